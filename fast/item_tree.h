// SPDX-License-Identifier: MIT
// The paper's bounding volume hierarchy: items over primitives, each with a volume of its own.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "fast/strict_float.h"
#include "scene/ball.h"
#include "scene/box.h"
#include "scene/face_run.h"
#include "scene/scene.h"

namespace gnomon::fast {

/// Stands for "no item" where an item's number is expected.
inline constexpr std::uint32_t kNoItem = 0xffff'ffff;

/// Which way a tree is built.
enum class TreeBuild : std::uint8_t {
  goldsmith_salmon,  ///< by insertion, nodes of any width (fast/goldsmith_salmon.h)
  sah,               ///< top down into two, by the surface area heuristic over bins
};

/// What bounds an item.
enum class Volumes : std::uint8_t { boxes, spheres };

/// An item: a primitive (a polygon, that is a run of triangles, or a ball) or a volume around its children.
struct Item {
  scene::Box<float> box;    ///< around all that is below, also where volumes are spheres
  std::uint32_t first = 0;  ///< its first child, or its first face
  std::uint32_t bits = 0;

  static constexpr std::uint32_t kPrimitive = 0x8000'0000;
  [[nodiscard]] bool is_primitive() const { return (bits & kPrimitive) != 0; }
  /// Its children are the items first .. first + count() - 1; a primitive's faces likewise.
  [[nodiscard]] std::uint32_t count() const { return bits & ~kPrimitive; }
};

/// A bounding volume hierarchy with one primitive a leaf and any number of children, at least two, a volume.
/// The root is item 0, children lie side by side and after their parent. All boxes and balls hold what is
/// below them in exact arithmetic. The same input gives the same tree everywhere.
class ItemTree {
 public:
  /// Keeps nothing of its arguments. `primitives` must hold every face of the scene once
  /// (exact::polygons_of() gives such runs; faces by themselves are another way); a ball is a run of its own.
  /// `seed` shuffles the order in which goldsmith_salmon inserts primitives, and nothing else.
  ///
  /// Throws std::runtime_error when a coordinate or radius is no float, a ball reaches beyond the range of
  /// floats, or the runs are not as said. A scene without faces gives a tree without items.
  ItemTree(const scene::Scene& scene, std::span<const scene::FaceRun> primitives,
           TreeBuild build = TreeBuild::goldsmith_salmon, Volumes volumes = Volumes::boxes,
           std::uint64_t seed = 1);

  [[nodiscard]] bool empty() const { return items_.empty(); }
  [[nodiscard]] std::size_t size() const { return items_.size(); }
  [[nodiscard]] const Item& item(std::uint32_t i) const { return items_[i]; }
  [[nodiscard]] std::uint32_t parent(std::uint32_t i) const { return parents_[i]; }  ///< root: kNoItem
  [[nodiscard]] Volumes volumes() const { return volumes_; }
  /// The ball around all that is below, where volumes are spheres: infinite when no float is large enough. A
  /// ball's own item has the ball itself.
  [[nodiscard]] const scene::Ball<float>& ball(std::uint32_t i) const { return balls_[i]; }

  /// The item that is the primitive of the face; kNoItem for kNoFace.
  [[nodiscard]] std::uint32_t primitive_of(std::uint32_t face) const {
    return face < item_of_face_.size() ? item_of_face_[face] : kNoItem;
  }
  [[nodiscard]] std::uint32_t object_of(std::uint32_t face) const { return object_of_face_[face]; }
  /// The corners of a triangle, by its face's number; of a ball's faces: centre and radius.
  [[nodiscard]] const std::array<std::array<float, 3>, 3>& triangle(std::uint32_t face) const {
    return triangles_[face];
  }
  [[nodiscard]] bool is_ball(std::uint32_t face) const { return face >= triangles_.size(); }
  [[nodiscard]] const scene::Ball<float>& scene_ball(std::uint32_t face) const {
    return scene_balls_[face - triangles_.size()];
  }
  [[nodiscard]] std::size_t face_count() const { return item_of_face_.size(); }

  /// What a walk from the root that pushes all children of what it pops can have on its stack at most.
  [[nodiscard]] std::size_t stack_size() const { return stack_size_; }
  /// The estimate that both builders minimise: over all volumes, half the surface times the number of
  /// children.
  [[nodiscard]] double cost() const;

 private:
  void lay_out(const struct TreeSketch& sketch, std::span<const scene::FaceRun> primitives);
  void fit_balls();

  std::vector<Item> items_;
  std::vector<std::uint32_t> parents_, item_of_face_, object_of_face_;
  std::vector<scene::Ball<float>> balls_, scene_balls_;
  std::vector<std::array<std::array<float, 3>, 3>> triangles_;
  Volumes volumes_;
  std::size_t stack_size_ = 0;
};

}  // namespace gnomon::fast
