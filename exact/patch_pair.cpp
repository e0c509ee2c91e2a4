// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/patch_pair.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "exact/face_contact.h"
#include "exact/patches_ball.h"
#include "exact/segments_over_s.h"
#include "exact/shaft_walk.h"
#include "exact/side_of_face.h"

namespace gnomon::exact {

using scene::PairVisibility;
using scene::PatchPair;
using scene::Scene;
using scene::ShadowQuery;

namespace {

using Point = std::array<double, 3>;

Corners corners_of(const Scene& scene, std::size_t triangle) {
  return {scene.corner(triangle, 0), scene.corner(triangle, 1), scene.corner(triangle, 2)};
}

bool are_in_range(const Corners& v) {
  return std::ranges::all_of(v, [](const Point& p) {
    return std::ranges::all_of(p, [](double x) { return std::fabs(x) <= kLargestInIntervals; });
  });
}

std::uint16_t shared_corners(const Corners& v, const Corners& f) {
  unsigned shared = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (v[i] == f[k]) shared |= 1u << (3 * i + k);
    }
  }
  return static_cast<std::uint16_t>(shared);
}

template <class Add, class FT>
bool over_s(const PatchPair& pair, const Corners& f, SharedCorners shared, Add&& add, FT) {
  return SegmentsOverS<FT>(three<FT>(pair.a.corners), three<FT>(pair.b.corners), three<FT>(f), shared)
      .for_each(add);
}

/// Two ways to have a point in common for sure: an open segment between corners crosses the face inside, or
/// an edge of the face crosses a triangle with corners of both patches inside.
bool crosses_surely(const PatchPair& pair, const Corners& f) {
  using FT = FilterKernel::FT;
  const auto crosses = [](const Point& from, const Point& to, const Corners& v) {
    const std::optional<Contact> contact = triangle_contact<FT>(Path(ShadowQuery{from, to}), v);
    return contact && contact->kind == ContactKind::plain;
  };
  const Corners &a = pair.a.corners, &b = pair.b.corners;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (crosses(a[i], b[k], f)) return true;
    }
  }
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t e = 0; e < 3; ++e) {
        const Point &from = f[e], &to = f[(e + 1) % 3];
        if (crosses(from, to, {a[i], a[(i + 1) % 3], b[k]})) return true;
        if (crosses(from, to, {b[i], b[(i + 1) % 3], a[k]})) return true;
      }
    }
  }
  return false;
}

/// True when all of f lies beyond a side of the box around both patches.
bool is_beside(const PatchPair& pair, const Corners& f) {
  const Corners &a = pair.a.corners, &b = pair.b.corners;
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::max({f[0][i], f[1][i], f[2][i]}) <
            std::min({a[0][i], a[1][i], a[2][i], b[0][i], b[1][i], b[2][i]}) ||
        std::min({f[0][i], f[1][i], f[2][i]}) >
            std::max({a[0][i], a[1][i], a[2][i], b[0][i], b[1][i], b[2][i]})) {
      return true;
    }
  }
  return false;
}

bool triangle_blocks(const PatchPair& pair, const Corners& f, bool pair_in_range, bool& exactly) {
  exactly = false;
  if (is_beside(pair, f)) return false;
  if (pair_in_range && are_in_range(f)) {
    const CGAL::Interval_nt<false>::Protector upward;
    const SharedCorners shared{shared_corners(pair.a.corners, f), shared_corners(pair.b.corners, f)};
    RangeFilter range(Ends::open);
    const auto add = [&](const LinearInS<FilterKernel::FT>& x) { return range.add(x); };
    if (!over_s(pair, f, shared, add, FilterKernel::FT())) return false;
    if (range.has_some() || crosses_surely(pair, f)) return true;
  }
  exactly = true;
  RangeOfS<ExactFloat> range(Ends::open);
  return over_s(
      pair, f, {}, [&](LinearInS<ExactFloat> x) { return range.add(std::move(x)); }, ExactFloat());
}

/// A sign from intervals, else from exact floats.
template <class SignWith>
int filtered_sign(const SignWith& sign_with) {
  {
    const CGAL::Interval_nt<false>::Protector upward;
    const Sign sign = sign_with(FilterKernel::FT());
    if (sign != Sign::unknown) return static_cast<int>(sign);
  }
  return static_cast<int>(sign_with(ExactFloat()));
}

/// A pair, and on which side of either plane what hides must lie.
class Prepared {
 public:
  explicit Prepared(const PatchPair& pair)
      : pair_(pair),
        in_range_(are_in_range(pair.a.corners) && are_in_range(pair.b.corners)),
        side_of_a_(common_side(pair.a.corners, pair.b.corners)),
        side_of_b_(side_of_a_ == 0 ? 0 : common_side(pair.b.corners, pair.a.corners)) {}

  [[nodiscard]] bool can_block(const Scene& scene, std::uint32_t face, bool& exactly) const {
    if (face < scene.triangles.size()) {
      return triangle_blocks(pair_, corners_of(scene, face), in_range_, exactly);
    }
    SixPoints points;
    for (std::size_t k = 0; k < 3; ++k) {
      points[k] = pair_.a.corners[k];
      points[k + 3] = pair_.b.corners[k];
    }
    return ball_blocks(points, scene.balls[face - scene.triangles.size()], exactly);
  }

  /// False when no face can lie strictly between the planes.
  [[nodiscard]] bool has_between() const { return side_of_a_ != 0 && side_of_b_ != 0; }

  [[nodiscard]] bool hides(const Scene& scene, std::uint32_t face) const {
    return has_between() && meets_all(scene, face) && lies_beside(scene, face, pair_.a.corners, side_of_a_) &&
           lies_beside(scene, face, pair_.b.corners, side_of_b_);
  }

  [[nodiscard]] bool is_own(std::uint32_t face) const { return face == pair_.a.face || face == pair_.b.face; }

 private:
  /// The side of the plane of v that all points are strictly on, or 0.
  static int common_side(const Corners& v, const Corners& points) {
    const int side = side_of_face(v, points[0]);
    return side == side_of_face(v, points[1]) && side == side_of_face(v, points[2]) ? side : 0;
  }

  static bool lies_beside(const Scene& scene, std::uint32_t face, const Corners& v, int side) {
    if (face < scene.triangles.size()) return common_side(v, corners_of(scene, face)) == side;
    const scene::Ball<double>& ball = scene.balls[face - scene.triangles.size()];
    if (side_of_face(v, ball.centre) != side) return false;
    return filtered_sign([&](auto number) {
             using FT = decltype(number);
             const Vector<FT> n = cross(between<FT>(v[0], v[1]), between<FT>(v[0], v[2]));
             const FT height = dot(n, between<FT>(v[0], ball.centre));
             return sign_of(FT(CGAL::square(height) - CGAL::square(FT(ball.radius)) * square(n)));
           }) > 0;
  }

  [[nodiscard]] bool meets_all(const Scene& scene, std::uint32_t face) const {
    return std::ranges::all_of(pair_.a.corners, [&](const Point& p) {
      return std::ranges::all_of(pair_.b.corners, [&](const Point& q) {
        return contact(scene, face, ShadowQuery{p, q}).meets();
      });
    });
  }

  const PatchPair& pair_;
  bool in_range_;
  int side_of_a_, side_of_b_;
};

scene::Box<double> box_of(const Corners& v) {
  scene::Box<double> box;
  for (std::size_t i = 0; i < 3; ++i) {
    box.c[i] = std::min({v[0][i], v[1][i], v[2][i]});
    box.c[i + 3] = std::max({v[0][i], v[1][i], v[2][i]});
  }
  return box;
}

}  // namespace

bool can_block(const Scene& scene, std::uint32_t face, const PatchPair& pair) {
  bool exactly = false;
  return Prepared(pair).can_block(scene, face, exactly);
}

bool hides(const Scene& scene, std::uint32_t face, const PatchPair& pair) {
  return Prepared(pair).hides(scene, face);
}

PairVisibility patch_pair_by_all_faces(const Scene& scene, const PatchPair& pair) {
  const Prepared prepared(pair);
  const auto count = static_cast<std::uint32_t>(scene.face_count());
  bool blocked = false;
  for (std::uint32_t face = 0; face < count; ++face) {
    if (prepared.is_own(face)) continue;
    if (prepared.hides(scene, face)) return PairVisibility::none;
    bool exactly = false;
    blocked = blocked || prepared.can_block(scene, face, exactly);
  }
  return blocked ? PairVisibility::part : PairVisibility::all;
}

PatchPairs::PatchPairs(const Scene& scene)
    : scene_(scene), built_(std::make_unique<const BuiltHierarchy>(build_hierarchy(scene))) {}

PatchPairs::~PatchPairs() = default;

PairVisibility PatchPairs::visibility(const PatchPair& pair) const {
  PatchPairCounters unused;
  return visibility(pair, unused);
}

PairVisibility PatchPairs::visibility(const PatchPair& pair, PatchPairCounters& counters) const {
  const Prepared prepared(pair);
  bool blocked = false, hidden = false;
  const auto find_blocker = [&](std::uint32_t face) {
    if (prepared.is_own(face)) return false;
    bool exactly = false;
    blocked = prepared.can_block(scene_, face, exactly);
    ++counters.faces;
    counters.exact_faces += exactly;
    return blocked;
  };
  // The segments between the patches lie in the shaft of their boxes.
  ShaftWalk(*built_, box_of(pair.a.corners), box_of(pair.b.corners)).run(find_blocker, counters.nodes);
  if (!blocked) return PairVisibility::all;
  if (!prepared.has_between()) return PairVisibility::part;
  // What hides all segments hides this one.
  const auto find_hider = [&](std::uint32_t face) {
    hidden = !prepared.is_own(face) && prepared.hides(scene_, face);
    ++counters.faces;
    return hidden;
  };
  const Point &p = pair.a.corners[0], &q = pair.b.corners[0];
  ShaftWalk(*built_, box_of({p, p, p}), box_of({q, q, q})).run(find_hider, counters.nodes);
  return hidden ? PairVisibility::none : PairVisibility::part;
}

}  // namespace gnomon::exact
