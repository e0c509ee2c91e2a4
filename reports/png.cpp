// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/png.h"

#include <png.h>

#include <limits>
#include <stdexcept>

namespace gnomon::reports {

std::string png_of(const Pixels& pixels) {
  constexpr std::size_t kMost = std::numeric_limits<std::int32_t>::max() / 3;  // of libpng's row strides
  if (pixels.columns == 0 || pixels.columns > kMost || pixels.rows == 0 || pixels.rows > kMost ||
      pixels.colours.size() != pixels.columns * pixels.rows) {
    throw std::runtime_error("a picture of " + std::to_string(pixels.columns) + " x " +
                             std::to_string(pixels.rows) + " can't be made");
  }
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(pixels.columns);
  image.height = static_cast<png_uint_32>(pixels.rows);
  image.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = 0;
  std::string bytes;
  if (png_image_write_get_memory_size(image, size, 0, pixels.colours.data(), 0, nullptr) != 0) {
    bytes.resize(size);
    if (png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels.colours.data(), 0, nullptr) != 0) {
      bytes.resize(size);
      return bytes;
    }
  }
  throw std::runtime_error(std::string("libpng: ") + image.message);
}

}  // namespace gnomon::reports
