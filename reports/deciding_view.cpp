// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/deciding_view.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace gnomon::reports {
namespace {

// Wide enough for squares of doubles: on x86 64 bits and an exponent range beyond 10^4900.
using Wide = long double;

Wide wide(const Rational& x) {
  return x.convert_to<Wide>();
}

/// Drawing needs no more than this, and products of it stay finite.
double drawable(Wide x) {
  return static_cast<double>(std::clamp<Wide>(x, -1e30L, 1e30L));
}

/// A coordinate; what lies beyond double's range is cut off there.
double coordinate(Wide x) {
  constexpr Wide kMost = std::numeric_limits<double>::max();
  return static_cast<double>(std::clamp(x, -kMost, kMost));
}

Rational magnitude(const Rational& x) {
  return x < 0 ? Rational(-x) : x;
}

int sign_of(const Rational& x) {
  return x > 0 ? 1 : x < 0 ? -1 : 0;
}

/// The length of (x, y), with the exact numbers scaled first so that nothing under- or overflows on the way.
Wide length(const Rational& x, const Rational& y) {
  const Rational scale = std::max(magnitude(x), magnitude(y));
  return std::hypot(wide(x / scale), wide(y / scale)) * wide(scale);
}

/// A side around a point: value is a x + b y + c there.
LocalLine local_line(const HalfPlane& side, const Rational& value, const Rational& ulp) {
  const Rational scale = std::max(magnitude(side.a), magnitude(side.b));
  const Wide a = wide(side.a / scale), b = wide(side.b / scale), n = std::hypot(a, b);
  return {drawable(a / n), drawable(b / n), drawable(wide(value / (scale * ulp)) / n)};
}

std::vector<Decision> decisions(PictureFocus focus) {
  if (focus == PictureFocus::kOutside) return {Decision::kOutside};
  if (focus == PictureFocus::kInside) return {Decision::kInside};
  return {Decision::kOutside, Decision::kInside};
}

/// The shorter side of the case in a projection: of projections that decide alike, the one with most to see
/// is shown.
Rational breadth(const ShaftCase& shaft, const Silhouette& s) {
  const auto extent = [&](int axis) {
    double lo = std::min(shaft.a.lo(axis), shaft.b.lo(axis)),
           hi = std::max(shaft.a.hi(axis), shaft.b.hi(axis));
    if (shaft.box) lo = std::min(lo, shaft.box->lo(axis)), hi = std::max(hi, shaft.box->hi(axis));
    return Rational(hi) - Rational(lo);
  };
  return std::min(extent(s.right), extent(s.up));
}

// ---- boxes ----

struct BoxChoice {
  const HalfPlane* side = nullptr;
  ExactPoint corner;
  Rational value, gap;  // gap = value / (|a| + |b|)
};

/// The corner of T with the least (near) or largest (far) value.
ExactPoint corner_of(const ShaftCase& shaft, const Silhouette& s, const HalfPlane& side, Decision decision) {
  const bool far = decision == Decision::kInside;
  const auto pick = [&](const Rational& n, int axis) {
    return Rational((n > 0) == far ? shaft.box->hi(axis) : shaft.box->lo(axis));
  };
  const auto flat = [&](const Rational& n, int axis) {
    return n == 0 ? Rational(shaft.box->lo(axis)) : pick(n, axis);
  };
  return {flat(side.a, s.right), flat(side.b, s.up)};
}

BoxChoice worst_side(const ShaftCase& shaft, const Silhouette& s, Decision decision) {
  BoxChoice best;
  for (const HalfPlane& side : s.sides) {
    BoxChoice choice{&side, corner_of(shaft, s, side, decision), {}, {}};
    choice.value = side.at(choice.corner);
    choice.gap = choice.value / (magnitude(side.a) + magnitude(side.b));
    if (!best.side || choice.gap > best.gap) best = choice;
  }
  return best;
}

DecidingView box_view(const ShaftCase& shaft, const std::array<Silhouette, 3>& projections,
                      PictureFocus focus) {
  BoxChoice chosen;
  const Silhouette* seen = nullptr;
  Decision decision = Decision::kOutside;
  for (const Decision d : decisions(focus)) {
    BoxChoice best;
    const Silhouette* best_seen = nullptr;
    for (const Silhouette& s : projections) {
      BoxChoice choice = worst_side(shaft, s, d);
      const bool tie = best.side && choice.gap == best.gap;
      if (!best.side || choice.gap > best.gap || (tie && breadth(shaft, s) > breadth(shaft, *best_seen))) {
        best = choice, best_seen = &s;
      }
    }
    if (!chosen.side || magnitude(best.gap) < magnitude(chosen.gap))
      chosen = best, seen = best_seen, decision = d;
  }
  const Rational ulp(shaft.ulp());
  DecidingView view;
  view.projection = *seen;
  view.decision = decision;
  for (const HalfPlane& side : seen->sides)
    view.sides.push_back(local_line(side, side.at(chosen.corner), ulp));
  view.line = local_line(*chosen.side, chosen.value, ulp);
  view.corner = {chosen.corner.x.convert_to<double>(), chosen.corner.y.convert_to<double>()};
  view.sign = sign_of(chosen.value);
  view.gap = drawable(wide(chosen.gap / ulp));
  return view;
}

// ---- balls ----

/// Where the centre is relative to the silhouette.
struct BallChoice {
  bool centre_outside = false;
  Rational squared;             // squared distance from the centre to the silhouette's boundary
  Rational normal_x, normal_y;  // outward, any length > 0
};

/// (squared distance, from the nearest point to the centre) for the segment p q.
std::pair<Rational, ExactPoint> to_segment(const ExactPoint& c, const ExactPoint& p, const ExactPoint& q) {
  const ExactPoint d{q.x - p.x, q.y - p.y};
  const Rational dd = d.x * d.x + d.y * d.y;
  Rational t = dd == 0 ? Rational(0) : Rational(((c.x - p.x) * d.x + (c.y - p.y) * d.y) / dd);
  t = std::clamp(t, Rational(0), Rational(1));
  const ExactPoint away{c.x - p.x - t * d.x, c.y - p.y - t * d.y};
  return {away.x * away.x + away.y * away.y, away};
}

BallChoice locate(const Silhouette& s, const ExactPoint& c) {
  BallChoice choice;
  bool first = true;
  for (const HalfPlane& side : s.sides) {
    const Rational value = side.at(c);
    if (value > 0) choice.centre_outside = true;
    const Rational squared = value * value / (side.a * side.a + side.b * side.b);
    if (first || squared < choice.squared)
      choice = {choice.centre_outside, squared, side.a, side.b}, first = false;
  }
  if (!choice.centre_outside) return choice;
  first = true;
  for (std::size_t i = 0; i < s.corners.size(); ++i) {
    const auto [squared, away] = to_segment(c, s.corners[i], s.corners[(i + 1) % s.corners.size()]);
    if (first || squared < choice.squared) choice = {true, squared, away.x, away.y}, first = false;
  }
  return choice;
}

/// The signed distance in ulps from the ball's deciding point to the line, without cancellation: differences
/// are taken of exact squares.
Wide ball_gap(const BallChoice& choice, const Rational& radius, const Rational& ulp, Decision decision) {
  const Wide distance = std::sqrt(wide(choice.squared / (ulp * ulp))), r = wide(radius / ulp);
  const bool cancels = choice.centre_outside == (decision == Decision::kOutside);
  const Wide sign = choice.centre_outside ? 1 : -1;
  if (!cancels) return sign * (distance + r);
  const Wide difference = wide((choice.squared - radius * radius) / (ulp * ulp));
  return distance + r == 0 ? 0 : sign * difference / (distance + r);
}

DecidingView ball_view(const ShaftCase& shaft, const std::array<Silhouette, 3>& projections,
                       PictureFocus focus) {
  const Rational ulp(shaft.ulp()), radius(shaft.ball->radius);
  const auto centre = [&](const Silhouette& s) {
    return ExactPoint{Rational(shaft.ball->centre.at(static_cast<std::size_t>(s.right))),
                      Rational(shaft.ball->centre.at(static_cast<std::size_t>(s.up)))};
  };
  BallChoice chosen;
  const Silhouette* seen = nullptr;
  Decision decision = Decision::kOutside;
  Wide gap = 0;
  for (const Decision d : decisions(focus)) {
    std::optional<BallChoice> best;
    const Silhouette* best_seen = nullptr;
    Wide best_gap = 0;
    for (const Silhouette& s : projections) {
      BallChoice choice = locate(s, centre(s));
      const Wide g = ball_gap(choice, radius, ulp, d);
      if (!best || g > best_gap) best = choice, best_seen = &s, best_gap = g;
    }
    if (!seen || std::abs(best_gap) < std::abs(gap))
      chosen = *best, seen = best_seen, decision = d, gap = best_gap;
  }

  DecidingView view;
  view.projection = *seen;
  view.decision = decision;
  const Wide n = length(chosen.normal_x, chosen.normal_y);
  const Wide nx = wide(chosen.normal_x) / n, ny = wide(chosen.normal_y) / n;
  const Wide toward =
      decision == Decision::kOutside ? -1 : 1;  // from the centre to the deciding point, along the normal
  const ExactPoint c = centre(*seen);
  for (const HalfPlane& side : seen->sides) {
    LocalLine line = local_line(side, side.at(c), ulp);
    const Rational scale = std::max(magnitude(side.a), magnitude(side.b));
    const Wide a = wide(side.a / scale), b = wide(side.b / scale), m = std::hypot(a, b);
    line.offset =
        drawable(wide(side.at(c) / (scale * ulp)) / m + toward * wide(radius / ulp) * (a * nx + b * ny) / m);
    const bool deciding =
        std::abs(line.normal_x - drawable(nx)) < 1e-15 && std::abs(line.normal_y - drawable(ny)) < 1e-15;
    if (deciding &&
        std::abs(line.offset - drawable(gap)) <= 1e-9 * (1 + std::abs(drawable(wide(radius / ulp))))) {
      line.offset = drawable(gap);  // the same side: take the value that did not cancel
    }
    view.sides.push_back(line);
  }
  view.line = {drawable(nx), drawable(ny), drawable(gap)};
  view.corner = {coordinate(wide(c.x) + toward * wide(radius) * nx),
                 coordinate(wide(c.y) + toward * wide(radius) * ny)};
  const Rational r2 = radius * radius;
  const bool cancels = chosen.centre_outside == (decision == Decision::kOutside);
  const int side = chosen.centre_outside ? 1 : -1;
  view.sign = cancels ? side * sign_of(chosen.squared - r2) : chosen.squared == 0 && radius == 0 ? 0 : side;
  view.gap = drawable(gap);
  view.to_centre_x = drawable(-toward * nx);
  view.to_centre_y = drawable(-toward * ny);
  return view;
}

}  // namespace

DecidingView deciding_view(const ShaftCase& shaft, PictureFocus focus) {
  const std::array<Silhouette, 3> projections = {
      silhouette(shaft.a, shaft.b, 2), silhouette(shaft.a, shaft.b, 1), silhouette(shaft.a, shaft.b, 0)};
  return shaft.box ? box_view(shaft, projections, focus) : ball_view(shaft, projections, focus);
}

}  // namespace gnomon::reports
