// SPDX-License-Identifier: GPL-3.0-or-later
// The proved error bounds from both sides: never exceeded, and how much of them is used up, by distribution.
//
// GNOMON_SEARCH_TRIALS sets the cases of each row (each is held against several planes and boxes).
#include <gtest/gtest.h>

#include <cstdio>
#include <memory>
#include <string>

#include "fuzz/generator.h"
#include "tests/bound_cases.h"
#include "tests/search_trials.h"

namespace gnomon::tests {
namespace {

template <class F>
class ProofsBounds : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(ProofsBounds, Scalars);

template <class F>
constexpr scene::Scalar kScalar = std::is_same_v<F, float> ? scene::Scalar::f32 : scene::Scalar::f64;

/// Both corners of t, moved into the extent box, where thresholds are proved.
template <class F>
void measure(BoundShares& shares, const scene::ShaftBoxCaseOf<F>& c) {
  const fast::Shaft<F> shaft = fast::form_certified_box_shaft(c.a, c.b);
  for (const fast::ShaftPlane<F>& plane : shaft.planes()) {
    for (const bool near : {false, true}) {
      const auto coordinate = [&](fast::Face far) {
        const auto axis = static_cast<std::size_t>(fast::axis_of(far));
        return std::clamp(c.t.c[near ? fast::opposite(far) : far], shaft.extent.c[axis],
                          shaft.extent.c[axis + 3]);
      };
      add_box_shares(shares, shaft, plane, coordinate(plane.far0), coordinate(plane.far1));
    }
  }
  const fast::BallSlack<F> slack = fast::form_certified_ball_shaft(c.a, c.b).slack;
  for (const scene::Box<F>* box : {&shaft.extent, &shaft.a, &shaft.b}) {
    add_distance_share(shares, slack, {c.t.c[0], c.t.c[1], c.t.c[2]}, *box);
  }
}

/// The centre as it is, and moved into the extent box.
template <class F>
void measure(BoundShares& shares, const scene::ShaftBallCaseOf<F>& c) {
  const fast::Shaft<F> shaft = fast::form_certified_ball_shaft(c.a, c.b);
  for (const fast::ShaftPlane<F>& plane : shaft.planes()) {
    const int i = fast::axis_of(plane.far0), j = fast::axis_of(plane.far1);
    const F x = c.t.centre[static_cast<std::size_t>(i)], y = c.t.centre[static_cast<std::size_t>(j)];
    add_ball_shares(shares, shaft, plane, x, y);
    if (in_extent(shaft, plane, x, y)) continue;
    add_ball_shares(shares, shaft, plane, std::clamp(x, shaft.extent.lo(i), shaft.extent.hi(i)),
                    std::clamp(y, shaft.extent.lo(j), shaft.extent.hi(j)));
  }
  for (const scene::Box<F>* box : {&shaft.extent, &shaft.a, &shaft.b}) {
    add_distance_share(shares, shaft.slack, c.t.centre, *box);
  }
}

template <class F>
BoundShares of_distribution(const fuzz::Distribution& distribution, std::uint64_t trials) {
  const fuzz::DistributionChoice choice{&distribution, ""};
  const auto boxes = fuzz::make_generator<scene::ShaftBoxCase>(choice, kScalar<F>);
  const auto balls = fuzz::make_generator<scene::ShaftBallCase>(choice, kScalar<F>);
  BoundShares shares;
  for (std::uint64_t trial = 0; trial < trials; ++trial) {
    fuzz::CaseRandom of_box(7, fuzz::stream_of(distribution.name), trial);
    measure(shares, scene::converted<F>(boxes->make(of_box)));
    fuzz::CaseRandom of_ball(8, fuzz::stream_of(distribution.name), trial);
    measure(shares, scene::converted<F>(balls->make(of_ball)));
  }
  return shares;
}

template <class Case>
BoundShares of_random(std::uint64_t trials) {
  BoundShares shares;
  for (std::uint64_t trial = 0; trial < trials; ++trial) {
    fuzz::CaseRandom random(9, fuzz::stream_of("edges"), trial);
    Case(random).measure(shares);
  }
  return shares;
}

template <class F>
BoundShares of_underflow(std::uint64_t trials) {
  BoundShares shares;
  for (std::uint64_t trial = 0; trial < trials; ++trial) {
    fuzz::CaseRandom random(9, fuzz::stream_of("underflow"), trial);
    EdgesCase<F> c(random);
    c.make_products_underflow(random);
    c.measure(shares);
  }
  return shares;
}

template <class F>
BoundShares of_climbs(std::uint64_t trials) {
  constexpr int kSteps = 20000;
  BoundShares shares;
  for (std::uint64_t start = 0; start < std::max<std::uint64_t>(trials / kSteps, 2); ++start) {
    for (std::size_t bound = 0; bound < kBounds; ++bound) {
      const Bound aim = static_cast<Bound>(bound);
      shares.add(aim == Bound::squared_distance ? climb<DistanceCase<F>>(aim, 1, start, kSteps)
                                                : climb<EdgesCase<F>>(aim, 1, start, kSteps));
    }
  }
  return shares;
}

void print(const std::string& row, const BoundShares& shares) {
  std::printf("%-16s", row.c_str());
  for (const double share : shares.largest) std::printf("%11.4f", share);
  std::printf("\n");
}

TYPED_TEST(ProofsBounds, AreNeverExceededAndNotFarTooWide) {
  using F = TypeParam;
  const std::uint64_t trials = search_trials(3000);
  std::printf("largest share of each bound, %s\n%-16s", std::is_same_v<F, float> ? "f32" : "f64", "");
  for (const char* const name : kBoundNames) std::printf("%11s", name);
  std::printf("\n");
  BoundShares all;
  const auto add = [&all](const std::string& row, const BoundShares& shares) {
    print(row, shares);
    all.add(shares);
    EXPECT_EQ(shares.broken, 0U) << row;
  };
  for (const fuzz::Distribution& distribution : fuzz::distributions()) {
    if (distribution.needs_argument) continue;
    add(std::string(distribution.name), of_distribution<F>(distribution, trials));
  }
  BoundShares random = of_random<EdgesCase<F>>(trials * 4);
  random.add(of_random<DistanceCase<F>>(trials * 4));
  add("edges", random);
  add("underflow", of_underflow<F>(trials));
  add("climbs", of_climbs<F>(trials));
  print("all", all);
  std::printf("%-16s", "trials");
  for (const std::uint64_t count : all.trials) std::printf("%11llu", static_cast<unsigned long long>(count));
  std::printf("\n");

  for (std::size_t bound = 0; bound < kBounds; ++bound) {
    EXPECT_LE(all.largest[bound], 1) << kBoundNames[bound];
    // A bound ten times too wide would be a finding.
    EXPECT_GT(all.largest[bound], 0.1) << kBoundNames[bound];
    EXPECT_GT(all.trials[bound], trials * 5) << kBoundNames[bound];
  }
  EXPECT_GT(all.of(Bound::plane_value), 0.75);
}

}  // namespace
}  // namespace gnomon::tests
