// SPDX-License-Identifier: MIT
// Points that recur, as in STL, to one index each.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gnomon::scene {

/// Gives equal points (all three coordinates ==, so -0 equals 0) the same index, in order of first
/// appearance, and keeps the first one's signs of zero. Coordinates must not be NaN. The table holds indices
/// alone: 8 to 16 bytes a point, where std::unordered_map takes about 70.
class PointMerger {
 public:
  /// Appends new points to `points`, which must be empty now and be changed by nobody else.
  explicit PointMerger(std::vector<std::array<double, 3>>& points) : points_(points), slots_(64, kFree) {}

  std::uint32_t index_of(const std::array<double, 3>& point) {
    std::uint32_t& slot = find(point);
    if (slot != kFree) return slot;
    const auto index = static_cast<std::uint32_t>(points_.size());
    slot = index;
    points_.push_back(point);
    if (2 * points_.size() > slots_.size()) grow();
    return index;
  }

 private:
  /// No point has this index: it is kMaxMeshPoints.
  static constexpr std::uint32_t kFree = 0xffff'ffff;

  std::uint32_t& find(const std::array<double, 3>& point) {
    const std::size_t mask = slots_.size() - 1;
    std::size_t i = hash(point) & mask;
    while (slots_[i] != kFree && points_[slots_[i]] != point) i = (i + 1) & mask;
    return slots_[i];
  }

  void grow() {
    slots_.assign(2 * slots_.size(), kFree);
    for (std::size_t i = 0; i < points_.size(); ++i) find(points_[i]) = static_cast<std::uint32_t>(i);
  }

  /// Each step is the 64-bit finaliser of MurmurHash3 (Appleby, public domain), which mixes all bits into
  /// all.
  static std::size_t hash(const std::array<double, 3>& point) {
    std::uint64_t h = 0;
    for (const double c : point) {
      h ^= std::bit_cast<std::uint64_t>(c == 0 ? 0.0 : c);
      h = (h ^ (h >> 33)) * 0xff51afd7ed558ccdU;
      h = (h ^ (h >> 33)) * 0xc4ceb9fe1a85ec53U;
      h ^= h >> 33;
    }
    return static_cast<std::size_t>(h);
  }

  std::vector<std::array<double, 3>>& points_;
  std::vector<std::uint32_t> slots_;
};

}  // namespace gnomon::scene
