// SPDX-License-Identifier: GPL-3.0-or-later
// The exact ball test on grids: integers times a power of two, where it decides without the second stage.
#include <gtest/gtest.h>

#include <numeric>
#include <optional>
#include <utility>

#include "fast/batch_ball.h"
#include "tests/batch_ball_truth.h"
#include "tests/shaft_random.h"

namespace gnomon::tests {

using fast::BatchCounters;
using scene::Category;

namespace {

constexpr int kBalls = 150;
/// Shafts on each grid; under sanitizers batches cost much, and tell as much of memory in fewer.
constexpr std::uint64_t kGridShafts = kSanitized ? 20 : 60;

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
    for (std::uint64_t trial = 0; trial < kGridShafts; ++trial) {
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
    EXPECT_GT(all.second_stage, kSanitized ? 160 : 500);
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
    for (std::uint64_t trial = 0; trial < kGridShafts; ++trial) {
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
    EXPECT_GT(all.second_stage, all.on_grid + (kSanitized ? 160 : 500)) << grid.size;
  }
}

namespace {

/// Whole C and r, r below `most`, for which C^2 - R r^2 is not 0 but as small as can be: the last convergent
/// of the root of R's continued fraction. Nothing when the root is whole.
std::optional<std::pair<std::int64_t, std::int64_t>> near_root(std::int64_t of, std::int64_t most) {
  const auto root = static_cast<std::int64_t>(std::sqrt(static_cast<double>(of)));
  if (root * root == of) return std::nullopt;
  std::int64_t m = 0, d = 1, a = root, before_c = 1, c = root, before_r = 0, r = 1;
  std::pair<std::int64_t, std::int64_t> last;
  while (r < most) {
    last = {c, r};
    m = d * a - m;
    d = (of - m * m) / d;
    a = (root + m) / d;
    before_c = std::exchange(c, a * c + before_c);
    before_r = std::exchange(r, a * r + before_r);
  }
  return last;
}

/// The inverse of x modulo y, for x and y without common factors.
std::int64_t inverse(std::int64_t x, std::int64_t y) {
  std::int64_t before = 0, now = 1, rest = y, divisor = x % y;
  while (divisor != 0) {
    const std::int64_t times = rest / divisor;
    rest = std::exchange(divisor, rest % divisor);
    before = std::exchange(now, before - times * now);
  }
  return before < 0 ? before + y : before;
}

/// A ball that misses or reaches the slanted edge of a shaft by next to nothing: the edge (in x and y) runs
/// along (-q, p), and the centre's distance from it is c / sqrt(q^2 + p^2), against r.
template <class F>
std::optional<BallBatch<F>> next_to_an_edge(fuzz::CaseRandom& random, int half) {
  const std::int64_t q0 = 1 + random.below(2 * half - 2), q1 = 1 + random.below(2 * half - 2);
  if (std::gcd(q0, q1) != 1) return std::nullopt;
  const std::int64_t length = q0 * q0 + q1 * q1;
  const auto found = near_root(length, 3 * static_cast<std::int64_t>(half));
  if (!found) return std::nullopt;
  const auto [c, r] = *found;
  // p with p0 q1 + p1 q0 = c, q1 and -q0 being the run of the sides; then moved along the edge until the
  // foot lies within.
  std::int64_t p0 = q0 == 1 ? 0 : c % q0 * inverse(q1, q0) % q0;
  std::int64_t p1 = (c - p0 * q1) / q0;
  const auto floor = [](std::int64_t x, std::int64_t y) { return x / y - (x % y < 0 ? 1 : 0); };
  const std::int64_t along = floor(p1 * q1 - p0 * q0, length);
  p0 += along * q0;
  p1 -= along * q1;
  // a reaches to q0 in x and 0 in y, b to 0 and q1: seen from a's edge the sides move by -q0 and q1.
  const F h = F(half);
  const scene::Box<F> a{{-h, -h, -h, F(q0) - h, -h, h - 1}}, b{{-h, -h, -h, -h, F(q1) - h, h - 1}};
  BallBatch<F> batch{a, b, {}};
  batch.add({{F(q0 + p0) - h, F(p1) - h, F(random.integer(1 - half, half - 1))}, F(r)});
  return batch;
}

}  // namespace

/// D against r^2, where the rounded products of the comparison are equal and the exact ones are not.
TYPED_TEST(BatchBallGrid, ComparesProductsToTheirLastDigit) {
  using F = TypeParam;
  constexpr int kHalf = sizeof(F) == 4 ? 250 : 1 << 21;
  BatchCounters all;
  std::array<int, 3> truths{};
  for (std::uint64_t trial = 0; trial < affordable(6000); ++trial) {
    fuzz::CaseRandom random(26, 0, trial);
    const auto batch = next_to_an_edge<F>(random, kHalf);
    if (!batch) continue;
    const BatchCounters now = expect_exact(*batch, std::to_string(trial));
    if (this->HasFatalFailure()) return;
    all.on_grid += now.on_grid;
    ++truths[static_cast<std::size_t>(truth_of(*batch)[0])];
  }
  EXPECT_GT(all.on_grid, affordable(1000));
  EXPECT_GT(truths[0], affordable(1000));
  EXPECT_GT(truths[1], affordable(1000));
}

/// A radius of a unit or two is less than the margin of the first stage when coordinates have nearly all
/// digits of the format: such a ball comes here near a side, too.
TYPED_TEST(BatchBallGrid, HoldsSmallBallsAgainstSides) {
  using F = TypeParam;
  constexpr F kOffset = sizeof(F) == 4 ? F(0x1p20) : F(0x1p48);
  constexpr int kSize = sizeof(F) == 4 ? 400 : 400 << 14;  // the widest that the grid's stage takes
  BatchCounters all;
  std::array<int, 3> truths{};
  for (std::uint64_t trial = 0; trial < affordable(300); ++trial) {
    fuzz::CaseRandom random(27, 0, trial);
    const TestGrid<F> grid{kSize, 1, kOffset};
    BallBatch<F> batch{box_on(random, grid), box_on(random, grid), {}};
    for (int i = 0; i < kBalls; ++i) {
      // Near the edge of one of the boxes, some units inwards: sides and planes are a few units away.
      const scene::Box<F>& box = random.chance(0.5) ? batch.a : batch.b;
      scene::Ball<F> ball{};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const bool upper = random.chance(0.5);
        const F inwards = F(random.below(4));
        ball.centre[axis] = upper ? box.c[axis + 3] - inwards : box.c[axis] + inwards;
      }
      ball.radius = F(random.below(4));
      batch.add(ball);
    }
    const BatchCounters now = expect_exact(batch, std::to_string(trial));
    if (this->HasFatalFailure()) return;
    all.on_grid += now.on_grid;
    for (const Category truth : truth_of(batch)) ++truths[static_cast<std::size_t>(truth)];
  }
  EXPECT_GT(all.on_grid, affordable(1000));
  EXPECT_GT(truths[1], affordable(1000));
  EXPECT_GT(truths[2], affordable(1000));
}

/// A shaft with one number off the grid, and balls on it.
TYPED_TEST(BatchBallGrid, LeavesOtherShaftsAlone) {
  using F = TypeParam;
  for (const TestGrid<F>& grid : test_grids<F>()) {
    BatchCounters all;
    for (std::uint64_t trial = 0; trial < kGridShafts; ++trial) {
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
