// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <array>
#include <vector>

#include "reports/bench/shadow_truth.h"

namespace gnomon::bench {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;

Kernel::Point_3 point_of(const std::array<double, 3>& p) {
  return {p[0], p[1], p[2]};
}

}  // namespace

struct CgalTree::Tree {
  Triangles triangles;
  CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> tree;
};

CgalTree::CgalTree(const scene::Scene& scene) : tree_(std::make_unique<Tree>()) {
  for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
    tree_->triangles.emplace_back(point_of(scene.corner(t, 0)), point_of(scene.corner(t, 1)),
                                  point_of(scene.corner(t, 2)));
  }
  tree_->tree.rebuild(tree_->triangles.cbegin(), tree_->triangles.cend());
  tree_->tree.build();
}

CgalTree::~CgalTree() = default;

bool CgalTree::meets(const scene::ShadowQuery& query) const {
  return tree_->tree.do_intersect(Kernel::Segment_3(point_of(query.point), point_of(query.light)));
}

}  // namespace gnomon::bench
