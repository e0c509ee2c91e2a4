// SPDX-License-Identifier: GPL-3.0-or-later
// The finitely many directions that separate a polytope from a shaft. Internal to exact/.
//
// T misses the shaft S = hull(A u B) when 0 lies outside of P = S - T, and touches it when 0 lies on P's
// boundary. P = hull((A - T) u (B - T)) is a polytope. Its edges are parallel to edges of boxes (e_x, e_y,
// e_z), to edges of T, or join a point of A - T with one of B - T; for a normal whose faces of both are
// single points that join is the difference d of corners of A and B of the same signs. Claim: where P misses
// 0, one of the normals
//     e_i,  e_i x d,  e_i x g,  g x d,  and the normals of T's faces        (g the edges of T)
// separates strictly; and where 0 lies on P's boundary, one of them, not 0, supports P there.
//   P solid: its facets' normals do. A facet with an edge d has two corners of A - T or of B - T, hence an
//   edge of
//     that set, or all of its edges d; then A - T and B - T would be points and P a segment.
//   P flat, in a plane with normal m: m is a product as above. When 0 lies in that plane, look along an axis
//   e_i with
//     m_i != 0: P becomes a polygon, with normals e_i x (edge), and nothing about 0 changes.
//   P a segment along g: its normals are spanned by g x e_i when 0 is not on its line, and e_i tells
//   otherwise. P a point: some e_i.
#pragma once

#include <span>

#include "exact/half_spaces.h"

namespace gnomon::exact {

/// The least and the greatest n.x over a set.
template <class FT>
struct Extremes {
  FT least, most;
};

template <class FT>
class SeparatingAxes {
 public:
  /// `edges` are all directions of T's edges but the axes; `faces` all normals of its faces but the axes.
  SeparatingAxes(const scene::Box<double>& a, const scene::Box<double>& b, std::span<const Vector<FT>> edges,
                 std::span<const Vector<FT>> faces)
      : edges_(edges), faces_(faces) {
    for (std::size_t i = 0; i < 6; ++i) {
      a_[i] = FT(a.c[i]);
      b_[i] = FT(b.c[i]);
    }
  }

  /// Faces of T come first, then edges of T with axes, both with the shaft's half-spaces the usual test of
  /// separating axes; what follows is what else a shaft needs.
  [[nodiscard]] std::size_t faces() const { return faces_.size(); }
  [[nodiscard]] std::size_t faces_and_axes() const { return faces_.size() + 3 * edges_.size(); }
  [[nodiscard]] std::size_t size() const { return faces_and_axes() + 15 + 8 * edges_.size(); }

  [[nodiscard]] Vector<FT> normal(std::size_t i) const {
    if (i < faces()) return faces_[i];
    i -= faces();
    if (i < 3 * edges_.size()) return cross(edges_[i / 3], axis(i % 3));
    i -= 3 * edges_.size();
    if (i < 3) return axis(i);
    i -= 3;
    if (i < 12) {  // e_i x d: only the two other coordinates of d matter
      const std::size_t along = i / 4, corner = i % 4;
      return cross(axis(along),
                   between_corners((corner & 1) << (along + 1) % 3 | (corner >> 1) << (along + 2) % 3));
    }
    i -= 12;
    return cross(edges_[i / 8], between_corners(i % 8));
  }

  [[nodiscard]] Extremes<FT> of_shaft(const Vector<FT>& n) const {
    FT least_a(0), least_b(0), most_a(0), most_b(0);
    for (std::size_t i = 0; i < 3; ++i) {
      const FT a0 = n[i] * a_[i], a1 = n[i] * a_[i + 3], b0 = n[i] * b_[i], b1 = n[i] * b_[i + 3];
      least_a += (CGAL::min)(a0, a1);
      most_a += (CGAL::max)(a0, a1);
      least_b += (CGAL::min)(b0, b1);
      most_b += (CGAL::max)(b0, b1);
    }
    return {FT((CGAL::min)(least_a, least_b)), FT((CGAL::max)(most_a, most_b))};
  }

 private:
  [[nodiscard]] static Vector<FT> axis(std::size_t i) {
    return {FT(i == 0 ? 1 : 0), FT(i == 1 ? 1 : 0), FT(i == 2 ? 1 : 0)};
  }
  [[nodiscard]] Vector<FT> between_corners(std::size_t corner) const {
    Vector<FT> d;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t at = corner >> i & 1 ? i + 3 : i;
      d[i] = b_[at] - a_[at];
    }
    return d;
  }

  std::span<const Vector<FT>> edges_, faces_;
  std::array<FT, 6> a_, b_;
};

}  // namespace gnomon::exact
