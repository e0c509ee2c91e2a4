// SPDX-License-Identifier: GPL-3.0-or-later
// The rays of a picture.
#pragma once

#include <array>
#include <cstddef>

#include "scene/box.h"
#include "scene/ray_query.h"
#include "scene/view.h"

namespace gnomon::fuzz {

/// The rays through the centres of a picture's pixels. Directions are floats of about length 1.
class Camera {
 public:
  /// Of `columns` by `rows` square pixels, each at least 1; the view's angle is between its lower and upper
  /// edge. Where `at` equals `from`, or `up` is parallel to the line of sight, another axis stands in.
  Camera(const scene::View& view, std::size_t columns, std::size_t rows);

  /// Row 0 is the top one.
  [[nodiscard]] scene::RayQuery ray(std::size_t column, std::size_t row) const;

  [[nodiscard]] std::size_t columns() const { return columns_; }
  [[nodiscard]] std::size_t rows() const { return rows_; }

 private:
  std::size_t columns_, rows_;
  std::array<double, 3> from_, forward_, right_, up_;  // right_ and up_ reach from the centre to the edges
};

/// The size of a picture: its proportions are those of the view, and its pixels at most `pixels`, at most
/// those of the view, at least one.
[[nodiscard]] std::array<std::size_t, 2> picture_size(const scene::View& view, std::size_t pixels);

/// A view of everything in the box, for scenes that come without one: from the front, the right and above
/// (y is up, as in most meshes), 45 degrees, 512 x 512.
[[nodiscard]] scene::View view_of(const scene::Box<double>& extent);

}  // namespace gnomon::fuzz
