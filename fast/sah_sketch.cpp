// SPDX-License-Identifier: MIT
#include "fast/sah_sketch.h"

#include <array>
#include <limits>
#include <numeric>

namespace gnomon::fast {

namespace {

constexpr std::size_t kBins = 32;
/// Below this depth sets are halved, so that no tree is deeper than kHeuristicDepth + 32.
constexpr std::size_t kHeuristicDepth = 64;

struct Set {
  std::uint32_t node, first, count;
  std::size_t depth;
};

struct Bin {
  scene::Box<float> box;
  std::uint32_t count = 0;

  void add(const scene::Box<float>& other, std::uint32_t boxes) {
    box = count == 0 ? other : box_around(box, other);
    count += boxes;
  }
  [[nodiscard]] double cost() const { return count == 0 ? 0 : half_surface(box) * count; }
};

struct Split {
  double cost = std::numeric_limits<double>::infinity();
  int axis = -1;
  std::size_t bins = 0;  ///< of the first half
};

class Builder {
 public:
  explicit Builder(std::span<const scene::Box<float>> boxes) : boxes_(boxes), order_(boxes.size()) {
    std::iota(order_.begin(), order_.end(), 0);
  }

  TreeSketch build() {
    if (boxes_.empty()) return {};
    sketch_.nodes.resize(1);
    std::vector<Set> open{{0, 0, static_cast<std::uint32_t>(boxes_.size()), 0}};
    while (!open.empty()) {
      const Set set = open.back();
      open.pop_back();
      TreeSketch::Node& node = sketch_.nodes[set.node];
      node.box = boxes_[order_[set.first]];
      for (std::uint32_t i = 1; i < set.count; ++i)
        node.box = box_around(node.box, boxes_[order_[set.first + i]]);
      if (set.count == 1) {
        node.primitive = order_[set.first];
        continue;
      }
      const std::uint32_t half = split(set);
      const std::uint32_t parts[2][2] = {{set.first, half}, {set.first + half, set.count - half}};
      for (const auto& part : parts) {
        sketch_.nodes.emplace_back();
        const auto child = static_cast<std::uint32_t>(sketch_.nodes.size() - 1);
        sketch_.add_child(set.node, child);
        open.push_back({child, part[0], part[1], set.depth + 1});
      }
    }
    return std::move(sketch_);
  }

 private:
  [[nodiscard]] double centre(std::uint32_t i, int axis) const {
    return static_cast<double>(boxes_[i].lo(axis)) + static_cast<double>(boxes_[i].hi(axis));
  }

  /// Orders the set by halves and returns the size of the first.
  std::uint32_t split(const Set& set) {
    const auto begin = order_.begin() + set.first, end = begin + set.count;
    if (set.count == 2 || set.depth >= kHeuristicDepth) return set.count / 2;
    Split best;
    std::array<double, 3> lo{}, scale{};
    for (int axis = 0; axis < 3; ++axis) {
      const auto k = static_cast<std::size_t>(axis);
      double hi = lo[k] = centre(*begin, axis);
      for (auto i = begin; i != end; ++i) {
        lo[k] = std::min(lo[k], centre(*i, axis));
        hi = std::max(hi, centre(*i, axis));
      }
      // Extents so small that the quotient overflows are left alone.
      scale[k] = static_cast<double>(kBins) / (hi - lo[k]);
      if (scale[k] < std::numeric_limits<double>::max()) consider(begin, end, axis, lo[k], scale[k], best);
    }
    if (best.axis < 0) return set.count / 2;
    const auto k = static_cast<std::size_t>(best.axis);
    const auto middle = std::stable_partition(
        begin, end, [&](std::uint32_t i) { return bin_of(i, best.axis, lo[k], scale[k]) < best.bins; });
    return static_cast<std::uint32_t>(middle - begin);
  }

  [[nodiscard]] std::size_t bin_of(std::uint32_t i, int axis, double lo, double scale) const {
    return std::min(static_cast<std::size_t>((centre(i, axis) - lo) * scale), kBins - 1);
  }

  template <class Iterator>
  void consider(Iterator begin, Iterator end, int axis, double lo, double scale, Split& best) const {
    std::array<Bin, kBins> bins{};
    for (auto i = begin; i != end; ++i) bins[bin_of(*i, axis, lo, scale)].add(boxes_[*i], 1);
    std::array<double, kBins> above{};  // the cost of the bins from k on
    Bin sum;
    for (std::size_t k = kBins; k-- > 1;) {
      if (bins[k].count > 0) sum.add(bins[k].box, bins[k].count);
      above[k] = sum.count == 0 ? std::numeric_limits<double>::infinity() : sum.cost();
    }
    sum = {};
    for (std::size_t k = 1; k < kBins; ++k) {
      if (bins[k - 1].count > 0) sum.add(bins[k - 1].box, bins[k - 1].count);
      if (sum.count > 0 && sum.cost() + above[k] < best.cost) best = {sum.cost() + above[k], axis, k};
    }
  }

  std::span<const scene::Box<float>> boxes_;
  std::vector<std::uint32_t> order_;
  TreeSketch sketch_;
};

}  // namespace

TreeSketch sketch_by_sah(std::span<const scene::Box<float>> boxes) {
  return Builder(boxes).build();
}

}  // namespace gnomon::fast
