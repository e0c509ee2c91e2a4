// SPDX-License-Identifier: MIT
#include "fast/pair_patch.h"

#include <algorithm>
#include <numeric>

#include "fast/hierarchy_bounds.h"

namespace gnomon::fast {

namespace {

/// The axis on which the listed points reach farthest.
std::size_t longest_axis(std::span<const std::array<float, 3>> points, std::span<const std::uint32_t> list) {
  std::array<float, 3> lo = points[list[0]], hi = lo;
  for (const std::uint32_t i : list) {
    for (std::size_t k = 0; k < 3; ++k) {
      lo[k] = std::min(lo[k], points[i][k]);
      hi[k] = std::max(hi[k], points[i][k]);
    }
  }
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (hi[k] - lo[k] > hi[axis] - lo[axis]) axis = k;
  }
  return axis;
}

/// Sorts a few dozens of points along an axis, by counting who comes before whom: no branch depends on the
/// numbers, and compilers make vectors of it. Equal ones keep their order.
void sort_along(std::span<const std::array<float, 3>> points, std::size_t axis, std::span<std::uint32_t> list,
                std::span<float> keys, std::span<std::uint32_t> copy) {
  const std::size_t count = list.size();
  for (std::size_t i = 0; i < count; ++i) {
    keys[i] = points[list[i]][axis];
    copy[i] = list[i];
  }
  for (std::size_t i = 0; i < count; ++i) {
    const float key = keys[i];
    std::uint32_t rank = 0;
    for (std::size_t j = 0; j < count; ++j) rank += keys[j] < key ? 1u : 0u;
    for (std::size_t j = 0; j < i; ++j) rank += keys[j] == key ? 1u : 0u;
    list[rank] = copy[i];
  }
}

}  // namespace

void PairPatch::assign(std::span<const std::array<float, 3>> points, scene::FaceRun own_run) {
  count_ = points.size();
  own = own_run;
  convex = {};
  plane.none_behind = false;
  in_domain = true;
  sorted_ = false;
  coordinates_.resize(3 * (count_ + kPadding));
  if (count_ == 0) return;
  bool inside = true;
  for (std::size_t k = 0; k < 3; ++k) {
    float* const to = coordinates_.data() + k * (count_ + kPadding);
    float lo = points[0][k], hi = lo;
    for (std::size_t i = 0; i < count_; ++i) {
      const float x = points[i][k];
      to[i] = x;
      lo = x < lo ? x : lo;
      hi = x > hi ? x : hi;
      inside &= x >= -kMostMagnitude && x <= kMostMagnitude;
    }
    std::fill_n(to + count_, kPadding, points[count_ - 1][k]);
    box[k] = lo;
    box[k + 3] = hi;
  }
  in_domain = inside;
  // Not for NaN, which has no order.
  if (count_ > kCluster && in_domain) sort(points);
}

/// Into slabs along the longest axis, and each slab along its own.
void PairPatch::sort(std::span<const std::array<float, 3>> points) {
  order_.resize(2 * count_);
  keys_.resize(count_);
  const std::span list = std::span(order_).first(count_), copy = std::span(order_).subspan(count_);
  std::iota(list.begin(), list.end(), 0u);
  sort_along(points, longest_axis(points, list), list, keys_, copy);
  const std::size_t clusters = (count_ + kCluster - 1) / kCluster;
  std::size_t slabs = 1;
  while (slabs * slabs < clusters) ++slabs;
  const std::size_t slab = (clusters + slabs - 1) / slabs * kCluster;
  for (std::size_t first = 0; slab > kCluster && first < count_; first += slab) {
    const std::span part = list.subspan(first, std::min(slab, count_ - first));
    if (part.size() > kCluster) sort_along(points, longest_axis(points, part), part, keys_, copy);
  }
  sorted_ = true;
  for (std::size_t k = 0; k < 3; ++k) {
    float* const to = coordinates_.data() + k * (count_ + kPadding);
    for (std::size_t i = 0; i < count_; ++i) to[i] = points[list[i]][k];
    std::fill_n(to + count_, kPadding, to[count_ - 1]);
  }
}

}  // namespace gnomon::fast
