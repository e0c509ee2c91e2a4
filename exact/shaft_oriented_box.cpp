// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/shaft_oriented_box.h"

#include "exact/shaft_polytope_inl.h"

namespace gnomon::exact {

using scene::ShaftOrientedBoxCase;

namespace {

/// c + sum t_i u_i, |t_i| <= 1: n.x ranges over n.c -+ sum |n.u_i|.
template <class FT>
class OrientedBody {
 public:
  static constexpr int kScale = 1;
  static constexpr bool kFacesInPlanes = false;

  explicit OrientedBody(const scene::OrientedBox<double>& t) {
    for (std::size_t j = 0; j < 3; ++j) {
      centre_[j] = FT(t.centre[j]);
      for (std::size_t i = 0; i < 3; ++i) edges_[i][j] = FT(t.axes[i][j]);
    }
    for (std::size_t i = 0; i < 3; ++i) faces_[i] = cross(edges_[(i + 1) % 3], edges_[(i + 2) % 3]);
    for (std::size_t corner = 0; corner < 8; ++corner) {
      for (std::size_t j = 0; j < 3; ++j) {
        FT x = centre_[j];
        for (std::size_t i = 0; i < 3; ++i) x += corner >> i & 1 ? edges_[i][j] : FT(-edges_[i][j]);
        points_[corner][j] = x;
      }
    }
    points_[8] = centre_;
  }

  [[nodiscard]] Extremes<FT> range(const Vector<FT>& n) const {
    const FT middle = dot(n, centre_);
    FT reach(0);
    for (const Vector<FT>& u : edges_) reach += magnitude_of(dot(n, u));
    return {FT(middle - reach), FT(middle + reach)};
  }
  [[nodiscard]] std::span<const Vector<FT>> edges() const { return edges_; }
  [[nodiscard]] std::span<const Vector<FT>> faces() const { return faces_; }
  [[nodiscard]] std::span<const Vector<FT>> points() const { return points_; }

 private:
  Vector<FT> centre_;
  std::array<Vector<FT>, 3> edges_, faces_;
  std::array<Vector<FT>, 9> points_;
};

}  // namespace

std::uint64_t refer(std::span<const ShaftOrientedBoxCase> cases, std::span<VolumeReference> references) {
  return refer_polytopes<OrientedBody>(cases, references);
}

VolumeReference refer_in_rationals(const ShaftOrientedBoxCase& c) {
  return PolytopeDecision<OrientedBody, CGAL::Gmpq, ShaftOrientedBoxCase>(c).decide();
}

scene::Category classify(const ShaftOrientedBoxCase& c) {
  VolumeReference reference;
  refer(std::span(&c, 1), std::span(&reference, 1));
  return reference.truth;
}

Gap gap(const ShaftOrientedBoxCase& c, Boundary boundary) {
  return exact_polytope_gap<OrientedBody>(c, boundary);
}

double gap_bound(const ShaftOrientedBoxCase& c, Boundary boundary) {
  return polytope_gap_bound<OrientedBody>(c, boundary);
}

scene::Category classify_grown(const ShaftOrientedBoxCase& c, double growth) {
  return polytope_grown<OrientedBody>(c, growth);
}

}  // namespace gnomon::exact
