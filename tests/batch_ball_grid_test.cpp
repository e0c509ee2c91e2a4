// SPDX-License-Identifier: GPL-3.0-or-later
// The exact ball test on grids: integers times a power of two, where it decides without the second stage.
#include <gtest/gtest.h>

#include "fast/batch_ball.h"
#include "tests/batch_ball_truth.h"

namespace gnomon::tests {

using fast::BatchCounters;
using scene::Category;

namespace {

constexpr int kBalls = 150;

template <class F>
class BatchBallGrid : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(BatchBallGrid, Scalars);

/// Numbers g (offset + 0 .. size - 1).
template <class F>
struct TestGrid {
  int size;
  F g, offset;
};

template <class F>
scene::Box<F> box_on(fuzz::CaseRandom& random, const TestGrid<F>& grid) {
  scene::Box<F> box;
  const int extra = std::max(grid.size / 4, 2);
  for (int axis = 0; axis < 3; ++axis) {
    const int lo = random.below(grid.size);
    const int hi = std::min(lo + random.below(extra), grid.size - 1);
    fuzz::set_axis(box, axis, grid.g * (grid.offset + F(lo)), grid.g * (grid.offset + F(hi)));
  }
  return box;
}

/// A ball on the grid, whose radius is the multiple of g nearest to touching; the closest of some tries.
template <class F>
scene::Ball<F> ball_on(fuzz::CaseRandom& random, const TestGrid<F>& grid, const fast::Shaft<F>& shaft,
                       int tries) {
  scene::Ball<F> best{};
  double best_gap = std::numeric_limits<double>::infinity();
  for (int i = 0; i < tries; ++i) {
    scene::Ball<F> ball{};
    for (F& x : ball.centre) {
      x = grid.g * (grid.offset + F(random.integer(-grid.size / 4, grid.size + grid.size / 4)));
    }
    const double g = static_cast<double>(grid.g), radius = touching_radius(shaft, ball.centre) / g;
    const double rounded = std::round(radius), gap = rounded > 0 ? std::fabs(radius / rounded - 1) : 1;
    ball.radius = static_cast<F>(g * rounded);
    if (gap < best_gap || i == 0) {
      best_gap = gap;
      best = ball;
    }
  }
  if (tries == 1) best.radius = std::max(best.radius + grid.g * F(random.integer(-1, 1)), F(0));
  if (random.below(8) == 0) best.radius = 0;
  return best;
}

template <class F>
BallBatch<F> batch_on(const TestGrid<F>& grid, std::uint64_t trial) {
  fuzz::CaseRandom random(23, static_cast<std::uint32_t>(grid.size), trial);
  BallBatch<F> batch{box_on(random, grid), box_on(random, grid), {}};
  if (random.below(4) == 0) {  // sides that don't move
    for (std::size_t k = 0; k < 6; ++k) {
      if (random.below(3) == 0) batch.b.c[k] = batch.a.c[k];
    }
    for (int axis = 0; axis < 3; ++axis) fuzz::set_axis(batch.b, axis, batch.b.lo(axis), batch.b.hi(axis));
  }
  const fast::Shaft<F> shaft = fast::form_shaft(batch.a, batch.b, fast::Normals::as_formed);
  for (int i = 0; i < kBalls; ++i) batch.add(ball_on(random, grid, shaft, i % 2 == 0 ? 1 : 60));
  return batch;
}

/// The exact tier on every instruction set, which all have to be right and to count the same.
template <class F>
BatchCounters expect_exact(const BallBatch<F>& batch, const std::string& label) {
  const std::vector<Category> truth = truth_of(batch);
  const auto predicate = predicate_for(batch, truth);
  const fast::ExactBallShaft<F> shaft(batch.a, batch.b);
  BatchCounters counters;
  bool first = true;
  for_each_target([&](const std::string& target) {
    std::vector<std::uint8_t> answers(truth.size(), 77);
    const BatchCounters now = fast::classify_balls_exact<F>(shaft, batch.view(), answers, predicate);
    for (std::size_t i = 0; i < truth.size(); ++i) {
      ASSERT_EQ(static_cast<Category>(answers[i]), truth[i])
          << target << " " << label << " ball " << i << ": " << text_of(batch.a) << text_of(batch.b)
          << text_of(batch.view()[i]);
    }
    if (first) counters = now;
    first = false;
    ASSERT_EQ(now, counters) << target;
  });
  return counters;
}

template <class F>
std::vector<TestGrid<F>> test_grids() {
  std::vector<TestGrid<F>> grids = {
      {8, 1, 0}, {32, 1, 0}, {32, F(0x1p-7), 1000}, {400, 1, 0}, {400, F(0x1p9), -2000}};
  if (sizeof(F) == 8) grids.push_back({1 << 20, F(0x1p-30), F(0x1p30)});
  return grids;
}

}  // namespace

TYPED_TEST(BatchBallGrid, DecidesTiesAndNearTies) {
  using F = TypeParam;
  for (const TestGrid<F>& grid : test_grids<F>()) {
    BatchCounters all;
    for (std::uint64_t trial = 0; trial < 60; ++trial) {
      const BatchCounters now = expect_exact(batch_on(grid, trial), std::to_string(grid.size));
      if (this->HasFatalFailure()) return;
      all.second_stage += now.second_stage;
      all.on_grid += now.on_grid;
      all.predicate_calls += now.predicate_calls;
    }
    if (std::getenv("GNOMON_PRINT") != nullptr) {
      std::printf("grid of %d times %g: %zu to the second stage, %zu on the grid, %zu to the predicate\n",
                  grid.size, double(grid.g), std::size_t(all.second_stage), std::size_t(all.on_grid),
                  std::size_t(all.predicate_calls));
    }
    EXPECT_GT(all.second_stage, 500);
    EXPECT_GT(all.on_grid, all.second_stage - all.second_stage / 20) << grid.size;
  }
}

namespace {

/// Moves a coordinate of ball i away, with the radius that reaches back from there: of some distances the one
/// where a multiple of g comes closest to touching.
template <class F>
void move_far(fuzz::CaseRandom& random, const TestGrid<F>& grid, BallBatch<F>& batch, std::size_t i, F& x) {
  const fast::Shaft<F> shaft = fast::form_shaft(batch.a, batch.b, fast::Normals::as_formed);
  const double g = static_cast<double>(grid.g);
  const F from = x, most = F(grid.size) * std::ldexp(F(1), random.integer(2, 12));
  F best_x = x, best_radius = batch.c[3][i];
  double best_gap = std::numeric_limits<double>::infinity();
  for (int i_try = 0; i_try < 60; ++i_try) {
    x = from + grid.g * std::round(most * random.unit<F>());
    const double radius = touching_radius(shaft, batch.view()[i].centre) / g;
    const double gap = std::fabs(radius / std::max(std::round(radius), 1.0) - 1);
    if (gap == 0 || gap > best_gap) continue;
    best_gap = gap;
    best_x = x;
    best_radius = static_cast<F>(g * std::round(radius));
  }
  x = best_x;
  batch.c[3][i] = best_radius;
}

}  // namespace

/// What is not on the grid, or too far away for it, is left to the second stage: one number of each ball is
/// moved by an ulp or a little more, or far.
TYPED_TEST(BatchBallGrid, LeavesOtherBallsAlone) {
  using F = TypeParam;
  for (const TestGrid<F>& grid : test_grids<F>()) {
    BatchCounters all;
    for (std::uint64_t trial = 0; trial < 60; ++trial) {
      BallBatch<F> batch = batch_on(grid, trial + 1000);
      fuzz::CaseRandom random(24, static_cast<std::uint32_t>(grid.size), trial);
      for (std::size_t i = 0; i < kBalls; ++i) {
        F& x = batch.c[static_cast<std::size_t>(random.below(4))][i];
        const F small = grid.g * std::ldexp(F(1), -random.integer(4, sizeof(F) == 4 ? 20 : 45));
        switch (random.below(4)) {
          case 0:
            x = fuzz::step_ulps(x, random.chance(0.5) ? 1 : -1);
            break;
          case 1:
            x += random.chance(0.5) ? small : -small;
            break;
          case 2:
            x += small;
            break;
          default:
            move_far(random, grid, batch, i, x);
        }
        batch.c[3][i] = std::fabs(batch.c[3][i]);
      }
      const BatchCounters now = expect_exact(batch, std::to_string(grid.size));
      if (this->HasFatalFailure()) return;
      all.second_stage += now.second_stage;
      all.on_grid += now.on_grid;
    }
    EXPECT_GT(all.second_stage, all.on_grid + 500) << grid.size;
  }
}

/// A shaft with one number off the grid, and balls on it.
TYPED_TEST(BatchBallGrid, LeavesOtherShaftsAlone) {
  using F = TypeParam;
  for (const TestGrid<F>& grid : test_grids<F>()) {
    BatchCounters all;
    for (std::uint64_t trial = 0; trial < 60; ++trial) {
      BallBatch<F> batch = batch_on(grid, trial + 2000);
      fuzz::CaseRandom random(25, static_cast<std::uint32_t>(grid.size), trial);
      scene::Box<F>& box = random.chance(0.5) ? batch.a : batch.b;
      const int axis = random.below(3);
      box.hi(axis) =
          random.chance(0.5) ? fuzz::step_ulps(box.hi(axis), 1) : box.hi(axis) + grid.g * F(0x1p-14);
      const BatchCounters now = expect_exact(batch, std::to_string(grid.size));
      if (this->HasFatalFailure()) return;
      all.second_stage += now.second_stage;
      all.on_grid += now.on_grid;
    }
    EXPECT_LT(all.on_grid, all.second_stage);
  }
}

}  // namespace gnomon::tests
