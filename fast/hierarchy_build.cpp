// SPDX-License-Identifier: MIT
//
// Top down into two at a time, by the surface area heuristic over bins of box centres; then nodes of two are
// merged to nodes of eight, always opening the child with the largest surface.
//
// DEPTH. A set of n faces at depth k is split by the heuristic as long as k < kHeuristicDepth, which may take
// off a single face; below that always in half, which ends after at most 32 more splits; and a last split
// parts triangles from balls. So no path has more than kHeuristicDepth + 34 nodes before merging, and merging
// makes none longer.
#include "fast/hierarchy_build.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "fast/hierarchy_leaves.h"

namespace gnomon::fast {

namespace {

constexpr int kBins = 16;
constexpr std::size_t kHeuristicDepth = 44;
static_assert(kHeuristicDepth + 34 <= kMostDepth);

constexpr float kInfinity = std::numeric_limits<float>::infinity();

struct Bounds {
  std::array<float, 3> lo{kInfinity, kInfinity, kInfinity}, hi{-kInfinity, -kInfinity, -kInfinity};

  void add(const Bounds& other) {
    for (std::size_t k = 0; k < 3; ++k) {
      lo[k] = std::min(lo[k], other.lo[k]);
      hi[k] = std::max(hi[k], other.hi[k]);
    }
  }
  /// Half of the surface; a measure for choosing only, so roundings (and infinities) do no harm.
  [[nodiscard]] float area() const {
    const float x = hi[0] - lo[0], y = hi[1] - lo[1], z = hi[2] - lo[2];
    return x * y + y * z + z * x;
  }
};

struct Item {
  Bounds box;
  std::uint32_t face;

  /// Half of it: the sum of two large floats would overflow.
  [[nodiscard]] float centre(std::size_t axis) const { return 0.5f * box.lo[axis] + 0.5f * box.hi[axis]; }
};

/// A node of two, or a leaf of the items from `first` on when count > 0.
struct Branch {
  Bounds box;
  std::uint32_t first = 0, count = 0;
  std::uint32_t children[2] = {0, 0};
};

class Builder {
 public:
  explicit Builder(const scene::Scene& scene) : scene_(scene) {
    const std::size_t triangles = scene.triangles.size();
    items_.resize(scene.face_count());
    for (std::size_t i = 0; i < items_.size(); ++i) {
      items_[i].face = static_cast<std::uint32_t>(i);
      if (i < triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
          Bounds point;
          for (std::size_t a = 0; a < 3; ++a) {
            point.lo[a] = point.hi[a] = static_cast<float>(scene.corner(i, k)[a]);
          }
          items_[i].box.add(point);
        }
      } else {
        const auto box = box_around_ball(scene.balls[i - triangles]);
        items_[i].box.lo = {box[0], box[1], box[2]};
        items_[i].box.hi = {box[3], box[4], box[5]};
      }
    }
  }

  HierarchyArrays build() {
    out_.places.resize(items_.size());
    if (items_.empty()) return std::move(out_);
    branches_.reserve(items_.size() / 2 + 16);
    const std::uint32_t root = grow(0, static_cast<std::uint32_t>(items_.size()), 0);
    std::size_t triangle_leaves = 0, ball_leaves = 0;
    for (const Branch& branch : branches_) {
      if (branch.count == 0) continue;
      ++(is_ball(items_[branch.first]) ? ball_leaves : triangle_leaves);
    }
    out_.triangles.reserve(triangle_leaves);
    out_.balls.reserve(ball_leaves);
    out_.nodes.emplace_back();
    if (branches_[root].count > 0) {
      std::uint32_t only[] = {root};
      fill_node(0, only, 1);
    } else {
      merge(0, root);
    }
    out_.nodes.shrink_to_fit();
    mark_one_sided();
    return std::move(out_);
  }

 private:
  [[nodiscard]] bool is_ball(const Item& item) const { return item.face >= scene_.triangles.size(); }

  std::uint32_t grow(std::uint32_t first, std::uint32_t count, std::size_t depth) {
    const auto index = static_cast<std::uint32_t>(branches_.size());
    branches_.emplace_back();
    Bounds box, centres;
    std::uint32_t balls = 0;
    for (std::uint32_t i = first; i < first + count; ++i) {
      const Item& item = items_[i];
      box.add(item.box);
      balls += is_ball(item);
      for (std::size_t k = 0; k < 3; ++k) {
        centres.lo[k] = std::min(centres.lo[k], item.centre(k));
        centres.hi[k] = std::max(centres.hi[k], item.centre(k));
      }
    }
    branches_[index].box = box;
    std::uint32_t middle = 0;
    if (count <= kWidth) {
      if (balls == 0 || balls == count) {
        branches_[index].first = first;
        branches_[index].count = count;
        return index;
      }
      const auto part = std::stable_partition(items_.begin() + first, items_.begin() + first + count,
                                              [&](const Item& item) { return !is_ball(item); });
      middle = static_cast<std::uint32_t>(part - items_.begin());
    } else {
      if (depth < kHeuristicDepth) middle = split_by_area(first, count, centres);
      if (middle == 0) middle = split_in_half(first, count, centres);
    }
    // The vector may move while children grow.
    const std::uint32_t left = grow(first, middle - first, depth + 1);
    const std::uint32_t right = grow(middle, first + count - middle, depth + 1);
    branches_[index].children[0] = left;
    branches_[index].children[1] = right;
    return index;
  }

  /// The first item of the right part; 0 when no split of the bins leaves both parts with items.
  std::uint32_t split_by_area(std::uint32_t first, std::uint32_t count, const Bounds& centres) {
    struct Bin {
      Bounds box;
      std::uint32_t count = 0;
    };
    std::array<std::array<Bin, kBins>, 3> bins;
    std::array<float, 3> scale{};
    for (std::size_t k = 0; k < 3; ++k) {
      const float extent = centres.hi[k] - centres.lo[k];
      // Not for an extent whose inverse or itself is infinite, or 0.
      const float s = kBins / extent;
      scale[k] = extent > 0 && std::isfinite(s) && std::isfinite(extent) ? s : 0;
    }
    const auto bin_of = [&](const Item& item, std::size_t k) {
      const float x = (item.centre(k) - centres.lo[k]) * scale[k];
      return std::min(static_cast<int>(x), kBins - 1);
    };
    for (std::uint32_t i = first; i < first + count; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        Bin& bin = bins[k][static_cast<std::size_t>(bin_of(items_[i], k))];
        bin.box.add(items_[i].box);
        ++bin.count;
      }
    }
    float best = kInfinity;
    std::size_t best_axis = 3;
    int best_bin = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      if (scale[k] == 0) continue;
      std::array<float, kBins> right_cost{};
      Bounds box;
      std::uint32_t inside = 0;
      for (int b = kBins - 1; b > 0; --b) {
        const Bin& bin = bins[k][static_cast<std::size_t>(b)];
        box.add(bin.box);
        inside += bin.count;
        right_cost[static_cast<std::size_t>(b)] = inside == 0 ? kInfinity : box.area() * blocks_for(inside);
      }
      box = Bounds();
      inside = 0;
      for (int b = 1; b < kBins; ++b) {
        const Bin& bin = bins[k][static_cast<std::size_t>(b - 1)];
        box.add(bin.box);
        inside += bin.count;
        if (inside == 0) continue;
        const float cost = box.area() * blocks_for(inside) + right_cost[static_cast<std::size_t>(b)];
        if (cost < best) {
          best = cost;
          best_axis = k;
          best_bin = b;
        }
      }
    }
    if (best_axis == 3) return 0;
    const auto part = std::partition(items_.begin() + first, items_.begin() + first + count,
                                     [&](const Item& item) { return bin_of(item, best_axis) < best_bin; });
    const auto middle = static_cast<std::uint32_t>(part - items_.begin());
    return middle == first || middle == first + count ? 0 : middle;
  }

  [[nodiscard]] static float blocks_for(std::uint32_t count) {
    return static_cast<float>((count + kBlockStep - 1) / kBlockStep);
  }
  static constexpr std::uint32_t kBlockStep = 4;

  std::uint32_t split_in_half(std::uint32_t first, std::uint32_t count, const Bounds& centres) {
    std::size_t axis = 0;
    for (std::size_t k = 1; k < 3; ++k) {
      if (centres.hi[k] - centres.lo[k] > centres.hi[axis] - centres.lo[axis]) axis = k;
    }
    const auto begin = items_.begin() + first;
    std::nth_element(begin, begin + count / 2, begin + count, [&](const Item& a, const Item& b) {
      const float x = a.centre(axis), y = b.centre(axis);
      return x < y || (x == y && a.face < b.face);
    });
    return first + count / 2;
  }

  /// Makes node `index` of the branch's descendants.
  void merge(std::size_t index, std::uint32_t branch) {
    std::uint32_t members[kWidth] = {branches_[branch].children[0], branches_[branch].children[1]};
    std::size_t count = 2;
    while (count < kWidth) {
      std::size_t widest = kWidth;
      float most = -1;
      for (std::size_t i = 0; i < count; ++i) {
        const Branch& member = branches_[members[i]];
        if (member.count == 0 && !(member.box.area() <= most)) {
          most = member.box.area();
          widest = i;
        }
      }
      if (widest == kWidth) break;
      const Branch& opened = branches_[members[widest]];
      members[widest] = opened.children[0];
      members[count++] = opened.children[1];
    }
    fill_node(index, members, count);
  }

  void fill_node(std::size_t index, const std::uint32_t* members, std::size_t count) {
    {
      WideNode& node = out_.nodes[index];
      node.children.fill(ChildLink::leaf(scene_.triangles.empty(), 1, 0));
      for (std::size_t k = 0; k < 3; ++k) {
        node.bounds[k].fill(kInfinity);
        node.bounds[k + 3].fill(-kInfinity);
      }
      for (std::size_t i = 0; i < count; ++i) {
        const Bounds& box = branches_[members[i]].box;
        for (std::size_t k = 0; k < 3; ++k) {
          node.bounds[k][i] = box.lo[k];
          node.bounds[k + 3][i] = box.hi[k];
        }
      }
    }
    // Inner children lie side by side, their own children after them.
    std::size_t child = out_.nodes.size();
    for (std::size_t i = 0; i < count; ++i) {
      const Branch& member = branches_[members[i]];
      if (member.count > 0) {
        out_.nodes[index].children[i] = add_leaf(member);
      } else {
        out_.nodes[index].children[i] = ChildLink::node(out_.nodes.size());
        out_.nodes.emplace_back();
      }
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (branches_[members[i]].count == 0) merge(child++, members[i]);
    }
  }

  ChildLink add_leaf(const Branch& leaf) {
    std::array<std::uint32_t, kWidth> faces;
    for (std::uint32_t i = 0; i < kWidth; ++i) {
      faces[i] = items_[leaf.first + (i < leaf.count ? i : 0)].face;
    }
    const bool balls = is_ball(items_[leaf.first]);
    const std::size_t block = balls ? out_.balls.size() : out_.triangles.size();
    if (block >= ChildLink::kMostBlocks) throw std::runtime_error("too many faces for a hierarchy");
    if (balls) {
      out_.balls.push_back(make_ball_block(scene_, faces));
    } else {
      out_.triangles.push_back(make_triangle_block(scene_, faces));
    }
    for (std::uint32_t i = 0; i < leaf.count; ++i) {
      out_.places[faces[i]] = {i & 7u, static_cast<std::uint32_t>(block) & (ChildLink::kMostBlocks - 1), 0};
    }
    return ChildLink::leaf(balls, leaf.count, block);
  }

  void mark_one_sided() {
    for (const scene::Object& object : scene_.objects) {
      if (!object.one_sided) continue;
      for (std::size_t i = 0; i < object.triangle_count; ++i) {
        out_.places[object.first_triangle + i].one_sided = 1;
      }
    }
  }

  const scene::Scene& scene_;
  std::vector<Item> items_;
  std::vector<Branch> branches_;
  HierarchyArrays out_;
};

}  // namespace

HierarchyArrays build_hierarchy(const scene::Scene& scene) {
  return Builder(scene).build();
}

}  // namespace gnomon::fast
