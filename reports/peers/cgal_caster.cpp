// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/peers/cgal_caster.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

#include <stdexcept>
#include <vector>

namespace gnomon::reports {
namespace {

using fuzz::Answer;
using scene::Shadow;

template <class Kernel>
class CgalCaster : public fuzz::SceneCaster {
  using Point = typename Kernel::Point_3;
  using Segment = typename Kernel::Segment_3;
  using Triangle = typename Kernel::Triangle_3;
  using Iterator = typename std::vector<Triangle>::const_iterator;
  using Primitive = CGAL::AABB_triangle_primitive<Kernel, Iterator>;
  using Traits = CGAL::AABB_traits<Kernel, Primitive>;
  using Tree = CGAL::AABB_tree<Traits>;

 public:
  explicit CgalCaster(const scene::Scene& scene) : place_(scene.triangles.size(), kOut) {
    if (!scene.balls.empty()) throw std::runtime_error("expected a scene of triangles, found balls");
    for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
      const Triangle triangle(point_of(scene.corner(t, 0)), point_of(scene.corner(t, 1)),
                              point_of(scene.corner(t, 2)));
      if (triangle.is_degenerate()) continue;
      place_[t] = triangles_.size();
      triangles_.push_back(triangle);
      faces_.push_back(static_cast<std::uint32_t>(t));
    }
    one_sided_.resize(scene.triangles.size());
    for (const scene::Object& object : scene.objects) {
      for (std::size_t t = 0; t < object.triangle_count; ++t) {
        one_sided_[object.first_triangle + t] = object.one_sided;
      }
    }
    tree_.rebuild(triangles_.cbegin(), triangles_.cend());
    if (!triangles_.empty()) tree_.build();
  }

  void shadows(std::span<const scene::ShadowQuery> queries, std::span<Answer> answers) const override {
    for (std::size_t i = 0; i < queries.size(); ++i) answers[i] = static_cast<Answer>(shadow(queries[i]));
  }

  void first_hits(std::span<const scene::RayQuery> rays, std::span<std::uint32_t> faces) const override {
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const auto& [x, y, z] = rays[i].direction;
      const Iterator own = own_of(rays[i].own);
      const auto hit = tree_.first_intersected_primitive(
          typename Kernel::Ray_3(point_of(rays[i].origin), typename Kernel::Vector_3(x, y, z)),
          [own](const Iterator& triangle) { return triangle == own; });
      faces[i] = hit ? faces_[static_cast<std::size_t>(*hit - triangles_.cbegin())] : scene::kNoFace;
    }
  }

  /// By the sizes of its parts, as the tree tells nothing: a node less than primitives.
  [[nodiscard]] std::size_t bytes() const override {
    return triangles_.size() *
               (sizeof(Triangle) + sizeof(Primitive) + sizeof(CGAL::AABB_node<Traits>) + sizeof(faces_[0])) +
           place_.size() * sizeof(place_[0]) + one_sided_.size() / 8;
  }

 private:
  static constexpr std::size_t kOut = ~std::size_t{0};

  /// Walks the tree until a triangle but the own one meets the segment.
  class AnyOther {
   public:
    AnyOther(const Traits& traits, Iterator own) : traits_(traits), own_(own) {}
    [[nodiscard]] bool go_further() const { return !found_; }
    void intersection(const Segment& segment, const Primitive& primitive) {
      found_ = primitive.id() != own_ && traits_.do_intersect_object()(segment, primitive);
    }
    [[nodiscard]] bool do_intersect(const Segment& segment, const CGAL::AABB_node<Traits>& node) const {
      return traits_.do_intersect_object()(segment, node.bbox());
    }
    [[nodiscard]] bool found() const { return found_; }

   private:
    const Traits& traits_;
    Iterator own_;
    bool found_ = false;
  };

  static Point point_of(const std::array<double, 3>& p) { return {p[0], p[1], p[2]}; }

  [[nodiscard]] Iterator own_of(std::uint32_t own) const {
    if (own >= place_.size() || place_[own] == kOut) return triangles_.cend();
    return triangles_.cbegin() + static_cast<std::ptrdiff_t>(place_[own]);
  }

  [[nodiscard]] Shadow shadow(const scene::ShadowQuery& query) const {
    const Point point = point_of(query.point), light = point_of(query.light);
    const Iterator own = own_of(query.own);
    if (own != triangles_.cend() && one_sided_[query.own] && faces_away(*own, point, light)) {
      return Shadow::facing;
    }
    if (triangles_.empty() || point == light) return Shadow::lit;
    AnyOther any(tree_.traits(), own);
    tree_.traversal(Segment(point, light), any);
    return any.found() ? Shadow::shadowed : Shadow::lit;
  }

  /// The kernel's predicate on the angle between the normal and light - point. That difference is a
  /// construction, rounded to doubles: exact for most floats.
  [[nodiscard]] static bool faces_away(const Triangle& own, const Point& point, const Point& light) {
    return typename Kernel::Angle_3()(own[0], own[1], own[2], light - point) == CGAL::OBTUSE;
  }

  std::vector<Triangle> triangles_;
  std::vector<std::uint32_t> faces_;  // of each triangle in the tree
  std::vector<std::size_t> place_;    // of each face, in the tree
  std::vector<bool> one_sided_;
  Tree tree_;
};

}  // namespace

std::unique_ptr<fuzz::SceneCaster> make_cgal_epick_caster(const scene::Scene& scene) {
  return std::make_unique<CgalCaster<CGAL::Exact_predicates_inexact_constructions_kernel>>(scene);
}

std::unique_ptr<fuzz::SceneCaster> make_cgal_double_caster(const scene::Scene& scene) {
  return std::make_unique<CgalCaster<CGAL::Simple_cartesian<double>>>(scene);
}

}  // namespace gnomon::reports
