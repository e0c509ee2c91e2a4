// SPDX-License-Identifier: MIT
#include "fast/item_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "fast/box_around.h"
#include "fast/goldsmith_salmon.h"
#include "fast/hierarchy_leaves.h"
#include "fast/is_float.h"
#include "fast/sah_sketch.h"
#include "scene/ball_around.h"

namespace gnomon::fast {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

float float_of(double x) {
  if (!is_float(x)) throw std::runtime_error("item tree: a coordinate or radius of the scene is no float");
  return static_cast<float>(x);
}

/// Steele, Lea and Flood's SplitMix64 (OOPSLA 2014): the same numbers everywhere.
class SplitMix {
 public:
  explicit SplitMix(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e37'79b9'7f4a'7c15);
    z = (z ^ (z >> 30)) * 0xbf58'476d'1ce4'e5b9;
    z = (z ^ (z >> 27)) * 0x94d0'49bb'1331'11eb;
    return z ^ (z >> 31);
  }

 private:
  std::uint64_t state_;
};

/// Fisher and Yates's shuffle; the remainder's bias is below 2^-32 for any number of primitives.
std::vector<std::uint32_t> shuffled_order(std::size_t count, std::uint64_t seed) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0);
  SplitMix random(seed);
  for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random.next() % i]);
  return order;
}

/// Every face once, no run of triangles and balls, no run of balls.
void check_runs(std::span<const scene::FaceRun> runs, std::size_t triangles, std::size_t faces) {
  std::vector<std::uint8_t> seen(faces, 0);
  std::size_t total = 0;
  for (const scene::FaceRun& run : runs) {
    const std::size_t end = std::size_t{run.first} + run.count;
    if (run.count == 0 || end > faces || (end > triangles && run.count > 1))
      throw std::runtime_error("item tree: a primitive is no run of triangles and no ball");
    for (std::size_t face = run.first; face < end; ++face) total += seen[face]++ == 0 ? 1 : 0;
    if (total > faces) break;
  }
  if (total != faces || std::count(seen.begin(), seen.end(), 1) != static_cast<std::ptrdiff_t>(faces))
    throw std::runtime_error("item tree: the primitives are not every face once");
}

/// The float not below x.
float rounded_up(double x) {
  if (x > static_cast<double>(std::numeric_limits<float>::max())) return kInfinity;
  const auto rounded = static_cast<float>(x);
  return static_cast<double>(rounded) >= x ? rounded : std::nextafter(rounded, kInfinity);
}

}  // namespace

ItemTree::ItemTree(const scene::Scene& scene, std::span<const scene::FaceRun> primitives, TreeBuild build,
                   Volumes volumes, std::uint64_t seed)
    : item_of_face_(scene.face_count(), kNoItem), object_of_face_(scene.face_count(), 0), volumes_(volumes) {
  triangles_.resize(scene.triangles.size());
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t axis = 0; axis < 3; ++axis)
        triangles_[t][k][axis] = float_of(scene.corner(t, k)[axis]);
    }
  }
  for (const scene::Ball<double>& ball : scene.balls) {
    for (const double x : ball.centre) float_of(x);
    float_of(ball.radius);
    scene_balls_.push_back(scene::converted<float>(ball));
  }
  for (std::size_t o = 0; o < scene.objects.size(); ++o) {
    const scene::Object& object = scene.objects[o];
    std::fill_n(object_of_face_.begin() + static_cast<std::ptrdiff_t>(object.first_triangle),
                object.triangle_count, static_cast<std::uint32_t>(o));
    std::fill_n(
        object_of_face_.begin() + static_cast<std::ptrdiff_t>(scene.triangles.size() + object.first_ball),
        object.ball_count, static_cast<std::uint32_t>(o));
  }
  check_runs(primitives, triangles_.size(), scene.face_count());

  std::vector<scene::Box<float>> boxes;
  boxes.reserve(primitives.size());
  for (const scene::FaceRun& run : primitives) {
    if (is_ball(run.first)) {
      boxes.push_back({box_around_ball(scene.balls[run.first - triangles_.size()])});
      if (!is_valid(boxes.back())) throw std::runtime_error("item tree: a ball reaches beyond floats");
    } else {
      scene::Box<float> box = box_of(triangles_[run.first]);
      for (std::uint32_t i = 1; i < run.count; ++i) box = box_around(box, box_of(triangles_[run.first + i]));
      boxes.push_back(box);
    }
  }
  if (boxes.empty()) return;
  if (build == TreeBuild::sah) {
    lay_out(sketch_by_sah(boxes), primitives);
  } else {
    GoldsmithSalmon inserter;
    for (const std::uint32_t i : shuffled_order(boxes.size(), seed)) inserter.insert(boxes[i], i);
    lay_out(inserter.tree(), primitives);
  }
  if (volumes_ == Volumes::spheres) fit_balls();
}

void ItemTree::lay_out(const TreeSketch& sketch, std::span<const scene::FaceRun> primitives) {
  struct Open {
    std::uint32_t node, item;
    std::size_t stack;  ///< what a walk may have on its stack together with this item
  };
  items_.reserve(sketch.nodes.size());
  items_.resize(1);
  parents_.assign(1, kNoItem);
  std::vector<Open> open{{0, 0, 1}};
  while (!open.empty()) {
    const Open now = open.back();
    open.pop_back();
    const TreeSketch::Node& node = sketch.nodes[now.node];
    stack_size_ = std::max(stack_size_, now.stack);
    items_[now.item].box = node.box;
    if (node.is_leaf()) {
      const scene::FaceRun& run = primitives[node.primitive];
      items_[now.item].first = run.first;
      items_[now.item].bits = run.count | Item::kPrimitive;
      for (std::uint32_t i = 0; i < run.count; ++i) item_of_face_[run.first + i] = now.item;
      continue;
    }
    auto child = static_cast<std::uint32_t>(items_.size());
    items_[now.item].first = child;
    items_[now.item].bits = node.children;
    items_.resize(items_.size() + node.children);
    parents_.resize(items_.size(), now.item);
    for (std::uint32_t c = node.first_child; c != TreeSketch::kNone; c = sketch.nodes[c].next_sibling)
      open.push_back({c, child++, now.stack + node.children - 1});
  }
}

void ItemTree::fit_balls() {
  // A ball around the middle of each item's box: as far as the farthest corner below, or the farthest point
  // of a ball, whose distance is that of its centre and the radius.
  std::vector<scene::BallAround<float>> around;
  std::vector<double> of_balls(items_.size(), 0);
  around.reserve(items_.size());
  balls_.resize(items_.size());
  for (std::size_t i = 0; i < items_.size(); ++i) {
    double extent = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const float lo = items_[i].box.lo(axis), hi = items_[i].box.hi(axis);
      const float middle = 0.5F * lo + 0.5F * hi;
      balls_[i].centre[static_cast<std::size_t>(axis)] = middle;
      extent = std::max({extent, static_cast<double>(hi) - static_cast<double>(middle),
                         static_cast<double>(middle) - static_cast<double>(lo)});
    }
    around.emplace_back(balls_[i].centre, extent);
  }
  constexpr double kFar = std::numeric_limits<double>::infinity();
  for (std::uint32_t face = 0; face < item_of_face_.size(); ++face) {
    for (std::uint32_t i = item_of_face_[face]; i != kNoItem; i = parents_[i]) {
      if (!is_ball(face)) {
        for (const auto& corner : triangles_[face]) around[i].add(corner);
        continue;
      }
      const scene::Ball<double> ball = scene::converted<double>(scene_ball(face));
      const scene::Ball<double> item = scene::converted<double>(balls_[i]);
      double extent = 0;
      for (std::size_t axis = 0; axis < 3; ++axis)
        extent = std::max(extent, std::abs(ball.centre[axis] - item.centre[axis]));
      scene::BallAround<double> reach(item.centre, extent);
      reach.add(ball.centre);
      of_balls[i] = std::max(of_balls[i], std::nextafter(reach.radius() + ball.radius, kFar));
    }
  }
  for (std::size_t i = 0; i < items_.size(); ++i) {
    balls_[i].radius = std::max(around[i].radius(), rounded_up(of_balls[i]));
    if (items_[i].is_primitive() && is_ball(items_[i].first)) balls_[i] = scene_ball(items_[i].first);
  }
}

double ItemTree::cost() const {
  double sum = 0;
  for (const Item& item : items_) {
    if (!item.is_primitive()) sum += half_surface(item.box) * item.count();
  }
  return sum;
}

}  // namespace gnomon::fast
