// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/hierarchy_build.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include "scene/scalar.h"

namespace gnomon::exact {

using scene::Ball;
using scene::Scene;

namespace {

/// A box of floats in the frame.
struct FloatBox {
  std::array<float, 3> lo{kInfinity, kInfinity, kInfinity}, hi{-kInfinity, -kInfinity, -kInfinity};

  void add(const FloatBox& other) {
    for (std::size_t i = 0; i < 3; ++i) {
      lo[i] = std::min(lo[i], other.lo[i]);
      hi[i] = std::max(hi[i], other.hi[i]);
    }
  }
  /// Half the surface; 0 for a box that nothing was added to.
  [[nodiscard]] float area() const {
    if (lo[0] > hi[0]) return 0;
    const float x = hi[0] - lo[0], y = hi[1] - lo[1], z = hi[2] - lo[2];
    return x * y + y * z + z * x;
  }
  [[nodiscard]] float centre(std::size_t axis) const { return lo[axis] / 2 + hi[axis] / 2; }
};

/// The least and greatest coordinates of a face in doubles, those of balls rounded outwards.
struct Extent {
  std::array<double, 3> lo{HUGE_VAL, HUGE_VAL, HUGE_VAL}, hi{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};

  void add(const std::array<double, 3>& least, const std::array<double, 3>& greatest) {
    for (std::size_t i = 0; i < 3; ++i) {
      lo[i] = std::min(lo[i], least[i]);
      hi[i] = std::max(hi[i], greatest[i]);
    }
  }
};

Extent extent_of(const Scene& scene, std::size_t face) {
  Extent extent;
  if (face < scene.triangles.size()) {
    for (std::size_t k = 0; k < 3; ++k) extent.add(scene.corner(face, k), scene.corner(face, k));
    return extent;
  }
  const Ball<double>& ball = scene.balls[face - scene.triangles.size()];
  for (std::size_t i = 0; i < 3; ++i) {
    // Not beyond the finite numbers: what is rounded away there is far less than the frame's own step.
    constexpr double kMost = std::numeric_limits<double>::max();
    extent.lo[i] = std::nextafter(ball.centre[i] - ball.radius, -kMost);
    extent.hi[i] = std::nextafter(ball.centre[i] + ball.radius, kMost);
  }
  return extent;
}

/// The split of a range of faces: those whose centre falls into a bin before this one go left.
struct Split {
  std::size_t axis = 0;
  int bin = 0;
  float cost = kInfinity;
};

class Builder {
 public:
  explicit Builder(const Scene& scene) : scene_(scene) {}

  BuiltHierarchy build() {
    BuiltHierarchy built;
    const std::size_t count = scene_.face_count();
    if (count == 0) return built;
    Extent all;
    for (std::size_t face = 0; face < count; ++face) {
      const Extent extent = extent_of(scene_, face);
      all.add(extent.lo, extent.hi);
    }
    built.frame = frame_ = Frame(all.lo, all.hi);
    boxes_.resize(count);
    order_.resize(count);
    std::iota(order_.begin(), order_.end(), 0u);
    for (std::size_t face = 0; face < count; ++face) {
      const Extent extent = extent_of(scene_, face);
      for (std::size_t i = 0; i < 3; ++i) {
        boxes_[face].lo[i] = float_below(frame_.map(extent.lo[i], i));
        boxes_[face].hi[i] = float_above(frame_.map(extent.hi[i], i));
      }
    }
    nodes_ = &built.nodes;
    built.nodes.emplace_back();
    fill(0, range_of(0, static_cast<std::uint32_t>(count)), 0);
    built.nodes.shrink_to_fit();
    if (is_in_floats()) {
      gather(built.float_leaves);
    } else {
      gather(built.double_leaves);
    }
    return built;
  }

 private:
  static constexpr int kBins = 16;
  /// Deeper than this, ranges are halved: 2^32 faces then make at most 32 more levels.
  static constexpr std::size_t kHeuristicLevels = 40;
  static_assert(kHeuristicLevels + 32 < kMostLevels);

  struct Range {
    std::uint32_t begin = 0, end = 0;
    FloatBox box;
    [[nodiscard]] std::uint32_t size() const { return end - begin; }
  };

  [[nodiscard]] Range range_of(std::uint32_t begin, std::uint32_t end) const {
    Range range{begin, end, {}};
    for (std::uint32_t i = begin; i < end; ++i) range.box.add(boxes_[order_[i]]);
    return range;
  }

  /// Fills a node with a range, split into up to eight by the largest boxes first.
  void fill(std::uint32_t node, const Range& whole, std::size_t level) {
    std::array<Range, kNodeLanes> parts{whole};
    std::size_t count = 1;
    while (count < kNodeLanes) {
      std::size_t widest = count;
      for (std::size_t i = 0; i < count; ++i) {
        if (parts[i].size() <= kLeafLanes) continue;
        if (widest == count || parts[i].box.area() > parts[widest].box.area()) widest = i;
      }
      if (widest == count) break;
      const std::uint32_t middle = split(parts[widest], level);
      parts[count++] = range_of(middle, parts[widest].end);
      parts[widest] = range_of(parts[widest].begin, middle);
    }
    for (std::size_t i = 0; i < count; ++i) {
      WideNode& here = (*nodes_)[node];
      here.used = static_cast<std::uint8_t>(here.used | (1u << i));
      for (std::size_t axis = 0; axis < 3; ++axis) {
        here.sides[2 * axis][i] = parts[i].box.lo[axis];
        here.sides[2 * axis + 1][i] = parts[i].box.hi[axis];
      }
      if (parts[i].size() <= kLeafLanes) {
        here.leaves = static_cast<std::uint8_t>(here.leaves | (1u << i));
        here.child[i] = static_cast<std::uint32_t>(leaves_.size());
        leaves_.push_back({parts[i].begin, parts[i].end});
        continue;
      }
      const auto child = static_cast<std::uint32_t>(nodes_->size());
      here.child[i] = child;
      nodes_->emplace_back();
      fill(child, parts[i], level + 1);
    }
  }

  /// Reorders the range into two that are not empty, and says where the second one begins.
  std::uint32_t split(const Range& range, std::size_t level) {
    FloatBox centres;
    for (std::uint32_t i = range.begin; i < range.end; ++i) {
      FloatBox centre;
      for (std::size_t axis = 0; axis < 3; ++axis)
        centre.lo[axis] = centre.hi[axis] = boxes_[order_[i]].centre(axis);
      centres.add(centre);
    }
    const Split best = level < kHeuristicLevels ? cheapest(range, centres) : Split{};
    if (best.cost < kInfinity) {
      const float lo = centres.lo[best.axis], width = centres.hi[best.axis] - lo;
      const auto middle = std::partition(
          order_.begin() + range.begin, order_.begin() + range.end,
          [&](std::uint32_t face) { return bin_of(boxes_[face].centre(best.axis), lo, width) < best.bin; });
      return static_cast<std::uint32_t>(middle - order_.begin());
    }
    // Nothing to choose by: equal centres, infinite boxes, or too deep.
    std::size_t widest = 0;
    for (std::size_t axis = 1; axis < 3; ++axis) {
      if (centres.hi[axis] - centres.lo[axis] > centres.hi[widest] - centres.lo[widest]) widest = axis;
    }
    const std::uint32_t middle = range.begin + range.size() / 2;
    std::nth_element(order_.begin() + range.begin, order_.begin() + middle, order_.begin() + range.end,
                     [&](std::uint32_t a, std::uint32_t b) {
                       const float x = boxes_[a].centre(widest), y = boxes_[b].centre(widest);
                       return x < y || (!(y < x) && a < b);
                     });
    return middle;
  }

  static int bin_of(float centre, float lo, float width) {
    return std::min(kBins - 1, static_cast<int>((centre - lo) / width * kBins));
  }

  /// What faces cost: those of a leaf are tested all at once.
  static float leaves_of(std::uint32_t count) {
    return static_cast<float>((count + kLeafLanes - 1) / kLeafLanes);
  }

  [[nodiscard]] Split cheapest(const Range& range, const FloatBox& centres) const {
    Split best;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float lo = centres.lo[axis], width = centres.hi[axis] - lo;
      if (!(width > 1e-30f && width < kInfinity)) continue;
      std::array<FloatBox, kBins> boxes;
      std::array<std::uint32_t, kBins> counts{};
      for (std::uint32_t i = range.begin; i < range.end; ++i) {
        const FloatBox& box = boxes_[order_[i]];
        const auto bin = static_cast<std::size_t>(bin_of(box.centre(axis), lo, width));
        boxes[bin].add(box);
        ++counts[bin];
      }
      std::array<float, kBins> right{};
      FloatBox box;
      std::uint32_t count = 0;
      for (std::size_t bin = kBins - 1; bin > 0; --bin) {
        box.add(boxes[bin]);
        count += counts[bin];
        right[bin] = count == 0 ? kInfinity : box.area() * leaves_of(count);
      }
      box = {};
      count = 0;
      for (std::size_t bin = 1; bin < kBins; ++bin) {
        box.add(boxes[bin - 1]);
        count += counts[bin - 1];
        const float cost = box.area() * leaves_of(count) + right[bin];
        if (count > 0 && cost < best.cost) best = {axis, static_cast<int>(bin), cost};
      }
    }
    return best;
  }

  /// True when every number of the scene's faces is a float.
  [[nodiscard]] bool is_in_floats() const {
    return std::ranges::all_of(scene_.points,
                               [](const auto& p) { return std::ranges::all_of(p, scene::is_float); }) &&
           std::ranges::all_of(scene_.balls, [](const Ball<double>& ball) {
             return std::ranges::all_of(ball.centre, scene::is_float) && scene::is_float(ball.radius);
           });
  }

  template <class F>
  void gather(scene::LargeVector<Leaf<F>>& leaves) const {
    leaves.reserve(leaves_.size());
    for (const LeafRange& range : leaves_) {
      Leaf<F> leaf;
      for (std::uint32_t i = range.begin; i < range.end; ++i) put(leaf, i - range.begin, order_[i]);
      leaves.push_back(leaf);
    }
  }

  template <class F>
  void put(Leaf<F>& leaf, std::size_t lane, std::uint32_t face) const {
    const auto bit = static_cast<std::uint8_t>(1u << lane);
    leaf.face[lane] = face;
    if (face < scene_.triangles.size()) {
      leaf.triangles = static_cast<std::uint8_t>(leaf.triangles | bit);
      for (std::size_t i = 0; i < 9; ++i) leaf.c[i][lane] = static_cast<F>(scene_.corner(face, i / 3)[i % 3]);
    } else {
      leaf.balls = static_cast<std::uint8_t>(leaf.balls | bit);
      const Ball<double>& ball = scene_.balls[face - scene_.triangles.size()];
      for (std::size_t i = 0; i < 3; ++i) leaf.c[i][lane] = static_cast<F>(ball.centre[i]);
      leaf.c[3][lane] = static_cast<F>(ball.radius);
    }
  }

  /// The faces of a leaf, in order_.
  struct LeafRange {
    std::uint32_t begin, end;
  };

  const Scene& scene_;
  Frame frame_;
  std::vector<FloatBox> boxes_;
  std::vector<std::uint32_t> order_;
  std::vector<LeafRange> leaves_;
  scene::LargeVector<WideNode>* nodes_ = nullptr;
};

}  // namespace

BuiltHierarchy build_hierarchy(const Scene& scene) {
  return Builder(scene).build();
}

}  // namespace gnomon::exact
