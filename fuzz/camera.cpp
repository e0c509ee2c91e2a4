// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fuzz/vectors.h"

namespace gnomon::fuzz {

Camera::Camera(const scene::View& view, std::size_t columns, std::size_t rows)
    : columns_(columns), rows_(rows), from_(as_floats(view.from)) {
  forward_ = unit_of(minus(view.at, view.from));
  if (length_of(forward_) == 0) forward_ = {0, 0, -1};
  Vector3 right = unit_of(cross_product(forward_, unit_of(view.up)));
  for (const Vector3& other : {Vector3{0, 1, 0}, Vector3{0, 0, 1}}) {
    if (length_of(right) == 0) right = unit_of(cross_product(forward_, other));
  }
  const double height = std::tan(view.angle * std::numbers::pi / 360);
  up_ = times(cross_product(right, forward_), height);
  right_ = times(right, height * static_cast<double>(columns) / static_cast<double>(rows));
}

scene::RayQuery Camera::ray(std::size_t column, std::size_t row) const {
  const double x = (2 * static_cast<double>(column) + 1) / static_cast<double>(columns_) - 1;
  const double y = 1 - (2 * static_cast<double>(row) + 1) / static_cast<double>(rows_);
  return {from_, as_floats(unit_of(along(along(forward_, right_, x), up_, y))), scene::kNoFace};
}

std::array<std::size_t, 2> picture_size(const scene::View& view, std::size_t pixels) {
  const double columns = static_cast<double>(view.columns), rows = static_cast<double>(view.rows);
  const double shrink = std::min(1.0, std::sqrt(static_cast<double>(pixels) / (columns * rows)));
  const auto least_one = [](double size) { return static_cast<std::size_t>(std::max(1.0, size)); };
  std::array<std::size_t, 2> size{least_one(columns * shrink), least_one(rows * shrink)};
  // A very long picture: the short side can't be less than one pixel.
  size[0] = std::min(size[0], std::max<std::size_t>(1, pixels / size[1]));
  size[1] = std::min(size[1], std::max<std::size_t>(1, pixels / size[0]));
  return size;
}

scene::View view_of(const scene::Box<double>& extent) {
  const Vector3 lo{extent.lo(0), extent.lo(1), extent.lo(2)}, hi{extent.hi(0), extent.hi(1), extent.hi(2)};
  const Vector3 centre = plus(times(lo, 0.5), times(hi, 0.5));
  const double diagonal = std::max(length_of(minus(hi, lo)), 1e-30);
  scene::View view;
  view.at = centre;
  // Half the diagonal fills 45 degrees from 1.31 diagonals.
  view.from = along(centre, unit_of({1, 0.8, 2}), 1.35 * diagonal);
  view.up = {0, 1, 0};
  view.angle = 45;
  view.hither = 0;
  view.columns = view.rows = 512;
  return view;
}

}  // namespace gnomon::fuzz
