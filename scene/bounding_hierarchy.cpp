// SPDX-License-Identifier: MIT
#include "scene/bounding_hierarchy.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>

#include "scene/ball_around.h"

namespace gnomon::scene {
namespace {

template <class F>
using Point = std::array<F, 3>;

template <class F>
std::vector<Point<F>> rounded_points(const Mesh& mesh) {
  constexpr auto kMost = static_cast<double>(std::numeric_limits<F>::max());
  std::vector<Point<F>> points(mesh.points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double c = mesh.points[i][axis];
      if (c > kMost || c < -kMost) {
        throw std::runtime_error("expected coordinates within the number type's range, found " +
                                 std::to_string(c) + " at point " + std::to_string(i));
      }
      points[i][axis] = static_cast<F>(c);
    }
  }
  return points;
}

/// The box that every add() widens; before the first it is turned inside out.
template <class F>
Box<F> empty_box() {
  constexpr F kInf = std::numeric_limits<F>::infinity();
  return {{kInf, kInf, kInf, -kInf, -kInf, -kInf}};
}

template <class F>
void add(Box<F>& box, const Point<F>& p) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.c[axis] = std::min(box.c[axis], p[axis]);
    box.c[axis + 3] = std::max(box.c[axis + 3], p[axis]);
  }
}

/// The axis along which the box is widest; of equally wide ones (and too wide ones to tell) the first.
template <class F>
int widest_axis(const Box<F>& box) {
  int widest = 0;
  for (int axis = 1; axis < 3; ++axis) {
    if (box.hi(axis) - box.lo(axis) > box.hi(widest) - box.lo(widest)) widest = axis;
  }
  return widest;
}

/// std::midpoint neither overflows nor holds a product that a compiler could fuse.
template <class F>
Point<F> centre_of(const Box<F>& box) {
  return {std::midpoint(box.lo(0), box.hi(0)), std::midpoint(box.lo(1), box.hi(1)),
          std::midpoint(box.lo(2), box.hi(2))};
}

/// The centre of the face's box, and its number to break ties.
template <class F>
struct FaceCentre {
  Point<F> centre;
  std::uint32_t face;
};

template <class F>
std::vector<FaceCentre<F>> face_centres(const Mesh& mesh, const std::vector<Point<F>>& points) {
  std::vector<FaceCentre<F>> centres(mesh.face_count());
  for (std::size_t f = 0; f < centres.size(); ++f) {
    Box<F> box = empty_box<F>();
    for (const std::uint32_t corner : mesh.face(f)) add(box, points[corner]);
    centres[f] = {centre_of(box), static_cast<std::uint32_t>(f)};
  }
  return centres;
}

/// Moves the lesser half (rounded down), by centre along the widest axis, to the front. The order is total,
/// so which faces these are doesn't depend on how nth_element works.
template <class F>
void split_at_median(std::span<FaceCentre<F>> faces) {
  Box<F> spread = empty_box<F>();
  for (const FaceCentre<F>& f : faces) add(spread, f.centre);
  const auto axis = static_cast<std::size_t>(widest_axis(spread));
  const auto less = [axis](const FaceCentre<F>& a, const FaceCentre<F>& b) {
    return a.centre[axis] != b.centre[axis] ? a.centre[axis] < b.centre[axis] : a.face < b.face;
  };
  std::nth_element(faces.begin(), faces.begin() + static_cast<std::ptrdiff_t>(faces.size() / 2), faces.end(),
                   less);
}

template <class F>
Ball<F> ball_around(const Box<F>& box, const Mesh& mesh, const std::vector<Point<F>>& points,
                    std::span<const FaceCentre<F>> faces) {
  Ball<F> ball{centre_of(box), F(0)};
  double extent = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto c = static_cast<double>(ball.centre[axis]);
    extent =
        std::max({extent, static_cast<double>(box.c[axis + 3]) - c, c - static_cast<double>(box.c[axis])});
  }
  BallAround<F> around(ball.centre, extent);
  for (const FaceCentre<F>& f : faces) {
    for (const std::uint32_t corner : mesh.face(f.face)) around.add(points[corner]);
  }
  ball.radius = around.radius();
  if (!is_valid(ball))
    throw std::runtime_error("expected a mesh within a ball of finite radius, found a larger one");
  return ball;
}

}  // namespace

template <class F>
BoundingHierarchy<F>::BoundingHierarchy(const Mesh& mesh) {
  if (!is_valid(mesh)) throw std::runtime_error("expected a valid mesh of at least one face, found another");
  if (mesh.face_count() > (std::size_t{1} << 31)) {
    throw std::runtime_error("expected at most 2147483648 faces, found " + std::to_string(mesh.face_count()));
  }
  points_ = rounded_points<F>(mesh);
  std::vector<FaceCentre<F>> order = face_centres(mesh, points_);

  // Halves by count have a known number of nodes, so every node's place is known before it is made: the first
  // child follows its parent, the second follows the first child's 2 n - 1.
  nodes_.resize(2 * order.size() - 1);
  nodes_[0].face_count = static_cast<std::uint32_t>(order.size());
  for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
    HierarchyNode<F>& node = nodes_[i];
    const auto faces = std::span(order).subspan(node.first_face, node.face_count);
    node.box = empty_box<F>();
    for (const FaceCentre<F>& f : faces) {
      for (const std::uint32_t corner : mesh.face(f.face)) add(node.box, points_[corner]);
    }
    node.ball = ball_around<F>(node.box, mesh, points_, faces);
    if (node.face_count == 1) continue;
    split_at_median(faces);
    const std::uint32_t lesser = node.face_count / 2;
    node.children = {i + 1, i + 2 * lesser};
    for (const std::uint32_t child : node.children) {
      nodes_[child].parent = i;
      nodes_[child].depth = node.depth + 1;
    }
    nodes_[node.children[0]].first_face = node.first_face;
    nodes_[node.children[0]].face_count = lesser;
    nodes_[node.children[1]].first_face = node.first_face + lesser;
    nodes_[node.children[1]].face_count = node.face_count - lesser;
  }
  faces_.reserve(order.size());
  for (const FaceCentre<F>& f : order) faces_.push_back(f.face);
}

template class BoundingHierarchy<float>;
template class BoundingHierarchy<double>;

}  // namespace gnomon::scene
