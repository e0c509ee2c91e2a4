// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures as PNG files.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace gnomon::reports {

using Colour = std::array<std::uint8_t, 3>;  ///< red, green, blue, in sRGB

/// Rows from the top, each from the left.
struct Pixels {
  std::size_t columns = 0, rows = 0;
  std::vector<Colour> colours;
};

/// The bytes of a PNG file, the same for the same pixels and libraries. Throws std::runtime_error when libpng
/// can't: for no pixels, or more than memory holds.
[[nodiscard]] std::string png_of(const Pixels& pixels);

}  // namespace gnomon::reports
