// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/shaft_slabs.h"

#include "exact/shaft_polytope_inl.h"

namespace gnomon::exact {

using scene::ShaftSlabsCase;

namespace {

using Integers = std::array<int, 3>;
using scene::kSlabNormals;

constexpr Integers cross_of(const Integers& p, const Integers& q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}
constexpr int dot_of(const Integers& p, const Integers& q) {
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}

/// Three independent slab normals p, q, r, and the dual basis: n = sum over k of (n.w_k / 2) n_k.
struct Basis {
  std::array<std::size_t, 3> slab{};
  std::array<Integers, 3> twice_dual{};
};

struct Bases {
  std::array<Basis, 29> all{};
  std::size_t count = 0;
};

/// 29 of the 35 triples are independent; their determinants are +-1, +-2 and +-4, and twice the dual vectors
/// integers.
constexpr Bases kBases = [] {
  Bases bases;
  for (std::size_t p = 0; p < 7; ++p) {
    for (std::size_t q = p + 1; q < 7; ++q) {
      for (std::size_t r = q + 1; r < 7; ++r) {
        const Integers across = cross_of(kSlabNormals[q], kSlabNormals[r]);
        const int determinant = dot_of(kSlabNormals[p], across);
        if (determinant == 0) continue;
        Basis& basis = bases.all[bases.count++];
        basis.slab = {p, q, r};
        basis.twice_dual = {across, cross_of(kSlabNormals[r], kSlabNormals[p]),
                            cross_of(kSlabNormals[p], kSlabNormals[q])};
        for (Integers& dual : basis.twice_dual) {
          for (int& x : dual) x = 2 * x / determinant;
        }
      }
    }
  }
  return bases;
}();
static_assert(kBases.count == 29);

/// w.n for w of -2 .. 2.
template <class FT>
FT combination(const Integers& w, const Vector<FT>& n) {
  FT sum(0);
  for (std::size_t i = 0; i < 3; ++i) {
    if (w[i] == 0) continue;
    const FT x = w[i] == 2 || w[i] == -2 ? FT(n[i] + n[i]) : n[i];
    sum = w[i] > 0 ? FT(sum + x) : FT(sum - x);
  }
  return sum;
}

/// The greatest n.x over a slab set with a point is, by the duality of linear programs, the least of the
/// bounds that n gets as a combination of three independent slab normals: slabs are bounded on both sides, so
/// that every such combination gives one. Everything is taken twice, which spares the halves.
template <class FT>
class SlabBody {
 public:
  static constexpr int kScale = 2;
  static constexpr bool kFacesInPlanes = true;

  explicit SlabBody(const scene::SlabSet<double>& t) {
    for (std::size_t k = 0; k < 7; ++k) {
      lo_[k] = FT(t.lo[k]);
      hi_[k] = FT(t.hi[k]);
    }
    // Edges lie in two of the slabs' planes: along an axis or across one of the six pairs of opposite cube
    // edges.
    std::size_t edge = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      for (const int sign : {-1, 1}) {
        edges_[edge] = {FT(0), FT(0), FT(0)};
        edges_[edge][(i + 1) % 3] = FT(1);
        edges_[edge++][(i + 2) % 3] = FT(sign);
      }
    }
    for (std::size_t k = 0; k < 7; ++k) {
      for (std::size_t i = 0; i < 3; ++i) normals_[k][i] = FT(kSlabNormals[k][i]);
    }
    // The middle of the axes' slabs, twice, if it lies in the others, too.
    for (std::size_t i = 0; i < 3; ++i) middle_[i] = lo_[i] + hi_[i];
    for (std::size_t k = 3; k < 7; ++k) {
      const FT at = dot(normals_[k], middle_);
      const Sign below = sign_of(FT(lo_[k] + lo_[k] - at)), above = sign_of(FT(at - hi_[k] - hi_[k]));
      has_middle_ = has_middle_ && below != Sign::positive && below != Sign::unknown &&
                    above != Sign::positive && above != Sign::unknown;
    }
  }

  [[nodiscard]] Extremes<FT> range(const Vector<FT>& n) const {
    std::optional<FT> least, most;
    for (const Basis& basis : kBases.all) {
      FT low(0), high(0);
      for (std::size_t i = 0; i < 3; ++i) {
        const FT weight = combination(basis.twice_dual[i], n);
        const FT x = weight * lo_[basis.slab[i]], y = weight * hi_[basis.slab[i]];
        low += (CGAL::min)(x, y);
        high += (CGAL::max)(x, y);
      }
      least = least ? FT((CGAL::max)(*least, low)) : low;
      most = most ? FT((CGAL::min)(*most, high)) : high;
    }
    return {*least, *most};
  }
  [[nodiscard]] std::span<const Vector<FT>> edges() const { return edges_; }
  [[nodiscard]] std::span<const Vector<FT>> faces() const { return std::span(normals_).subspan(3); }
  [[nodiscard]] std::span<const Vector<FT>> points() const { return {&middle_, has_middle_ ? 1u : 0u}; }

  /// Farkas: a set without points has four slabs that contradict each other, and one of them then has a range
  /// that ends before it begins. The sign of the most that a range ends before it begins.
  [[nodiscard]] Sign emptiness() const {
    SignFold fold;
    for (const Vector<FT>& n : normals_) {
      const Extremes<FT> of_normal = range(n);
      fold.add(sign_of(FT(of_normal.least - of_normal.most)));
    }
    return fold.any_positive ? Sign::positive : fold.any_unknown ? Sign::unknown : Sign::negative;
  }

 private:
  std::array<FT, 7> lo_, hi_;
  std::array<Vector<FT>, 7> normals_;
  std::array<Vector<FT>, 6> edges_;
  Vector<FT> middle_;
  bool has_middle_ = true;
};

}  // namespace

bool is_empty(const scene::SlabSet<double>& t) {
  {
    const CGAL::Interval_nt<false>::Protector upward;
    const Sign sign = SlabBody<FilterKernel::FT>(t).emptiness();
    if (sign != Sign::unknown) return sign == Sign::positive;
  }
  return SlabBody<CGAL::Mpzf>(t).emptiness() == Sign::positive;
}

std::uint64_t refer(std::span<const ShaftSlabsCase> cases, std::span<VolumeReference> references) {
  return refer_polytopes<SlabBody>(cases, references);
}

VolumeReference refer_in_rationals(const ShaftSlabsCase& c) {
  return PolytopeDecision<SlabBody, CGAL::Gmpq, ShaftSlabsCase>(c).decide();
}

scene::Category classify(const ShaftSlabsCase& c) {
  VolumeReference reference;
  refer(std::span(&c, 1), std::span(&reference, 1));
  return reference.truth;
}

Gap gap(const ShaftSlabsCase& c, Boundary boundary) {
  return exact_polytope_gap<SlabBody>(c, boundary);
}

double gap_bound(const ShaftSlabsCase& c, Boundary boundary) {
  return polytope_gap_bound<SlabBody>(c, boundary);
}

scene::Category classify_grown(const ShaftSlabsCase& c, double growth) {
  return polytope_grown<SlabBody>(c, growth);
}

}  // namespace gnomon::exact
