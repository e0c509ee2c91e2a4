// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/batch_ball.h"

#include <gtest/gtest.h>

#include "fast/certified_shaft.h"
#include "fast/shaft_ball.h"
#include "tests/batch_ball_truth.h"
#include "tests/shaft_random.h"

namespace gnomon::tests {

using fast::BatchCounters;
using scene::Category;

namespace {

/// 64 * 2 + 1 balls and a bit: full words, a tail, and queues that run full.
constexpr int kBalls = 150;
/// Of each distribution; under sanitizers batches cost much, and tell as much of memory in fewer.
constexpr int kShafts = kSanitized ? 10 : 40;
/// Of each distribution, for the exact tier on every instruction set.
constexpr std::uint64_t kExactShafts = affordable(80);

template <class F>
class BatchBall : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(BatchBall, Scalars);

template <class F>
std::vector<std::uint8_t> bytes_of(const fast::BatchBallShaft<F>& shaft, const fast::BallsSoA<F>& balls) {
  std::vector<std::uint8_t> answers(balls.count, 77);
  fast::classify_balls(shaft, balls, answers);
  return answers;
}

/// The planes say what the bytes say, with and without the inside plane.
template <class Classify>
void expect_planes(const std::vector<std::uint8_t>& bytes, const Classify& classify) {
  const std::size_t words = fast::words_for(bytes.size());
  std::vector<std::uint64_t> kept(words), inside(words), outside_only(words);
  classify(fast::BitPlanes{kept.data(), inside.data()});
  classify(fast::BitPlanes{outside_only.data(), nullptr});
  for (std::size_t i = 0; i < 64 * words; ++i) {
    const int byte = i < bytes.size() ? bytes[i] : 0;
    ASSERT_EQ(kept[i / 64] >> (i % 64) & 1, byte >= 1) << i;
    ASSERT_EQ(inside[i / 64] >> (i % 64) & 1, byte == 2) << i;
    ASSERT_EQ(outside_only[i / 64] >> (i % 64) & 1, byte >= 1) << i;
  }
}

}  // namespace

TYPED_TEST(BatchBall, EveryTargetSaysWhatTheScalarKernelSays) {
  using F = TypeParam;
  std::int64_t counts[3] = {0, 0, 0};
  for (const auto& choice : file_free_distributions()) {
    for (std::uint64_t trial = 0; trial < kShafts; ++trial) {
      const BallBatch<F> batch = make_balls<F>(choice, trial, kBalls);
      for (const auto& shaft : {fast::form_shaft(batch.a, batch.b, fast::Normals::unit),
                                fast::form_certified_ball_shaft(batch.a, batch.b)}) {
        std::vector<std::uint8_t> expected;
        for (std::size_t i = 0; i < batch.view().count; ++i) {
          expected.push_back(static_cast<std::uint8_t>(fast::classify(shaft, batch.view()[i]).answer));
          ++counts[expected.back()];
        }
        for_each_target([&](const std::string& target) {
          ASSERT_EQ(bytes_of<F>(shaft, batch.view()), expected)
              << target << " " << choice.label() << " " << trial << " " << text_of(batch.a)
              << text_of(batch.b);
          expect_planes(expected, [&](fast::BitPlanes planes) {
            fast::classify_balls<F>(shaft, batch.view(), planes);
          });
        });
      }
    }
  }
  for (const std::int64_t count : counts) EXPECT_GT(count, kSanitized ? 1000 : 5000);
}

TYPED_TEST(BatchBall, NumbersOutOfTheDomainAreAnsweredAsByTheScalarKernel) {
  using F = TypeParam;
  constexpr F kOdd[] = {std::numeric_limits<F>::quiet_NaN(), std::numeric_limits<F>::infinity(),
                        -std::numeric_limits<F>::infinity(), std::numeric_limits<F>::max(), F(-0.0)};
  const auto choices = file_free_distributions();
  for (std::uint64_t trial = 0; trial < kShafts; ++trial) {
    BallBatch<F> batch = make_balls<F>(choices[trial % choices.size()], trial, kBalls);
    fuzz::CaseRandom random(4, 2, trial);
    for (auto& array : batch.c) {
      for (F& x : array) {
        if (random.chance(0.2)) x = kOdd[random.below(5)];
      }
    }
    const auto shaft = fast::form_shaft(batch.a, batch.b, fast::Normals::unit);
    std::vector<std::uint8_t> expected;
    for (std::size_t i = 0; i < batch.view().count; ++i) {
      expected.push_back(static_cast<std::uint8_t>(fast::classify(shaft, batch.view()[i]).answer));
    }
    for_each_target([&](const std::string& target) {
      ASSERT_EQ(bytes_of<F>(shaft, batch.view()), expected) << target;
      // The exact tier promises no more than some category.
      std::vector<std::uint8_t> answers(batch.view().count, 77);
      fast::classify_balls_exact<F>({batch.a, batch.b}, batch.view(), answers,
                                    [](const scene::Ball<F>&) { return Category::overlap; });
      for (const std::uint8_t answer : answers) ASSERT_LE(answer, 2);
    });
  }
}

TYPED_TEST(BatchBall, CertifiedIsNeverUnsoundAndExactIsExact) {
  using F = TypeParam;
  std::int64_t total = 0, second = 0, predicate_calls = 0, wastes = 0;
  for (const auto& choice : file_free_distributions()) {
    BatchCounters all;
    std::uint64_t balls = 0;
    for (std::uint64_t trial = 0; trial < kExactShafts; ++trial) {
      const BallBatch<F> batch = make_balls<F>(choice, trial, kBalls);
      const std::vector<Category> truth = truth_of(batch);
      const fast::ExactBallShaft<F> shaft(batch.a, batch.b);
      const auto predicate = predicate_for(batch, truth);
      const auto certified = bytes_of<F>(fast::form_certified_ball_shaft(batch.a, batch.b), batch.view());
      for (std::size_t i = 0; i < truth.size(); ++i) {
        const auto said = static_cast<Category>(certified[i]);
        ASSERT_TRUE(said == truth[i] || said == Category::overlap) << text_of(batch.view()[i]);
        wastes += said != truth[i];
      }
      std::vector<std::uint8_t> first;
      BatchCounters counters;
      for_each_target([&](const std::string& target) {
        std::vector<std::uint8_t> answers(truth.size(), 77);
        const BatchCounters now = fast::classify_balls_exact<F>(shaft, batch.view(), answers, predicate);
        if (first.empty()) {
          first = answers;
          counters = now;
          for (std::size_t i = 0; i < truth.size(); ++i) {
            ASSERT_EQ(static_cast<Category>(answers[i]), truth[i])
                << choice.label() << " trial " << trial << " ball " << i << ": " << text_of(batch.a)
                << text_of(batch.b) << text_of(batch.view()[i]);
          }
        }
        ASSERT_EQ(answers, first) << target;
        ASSERT_EQ(now, counters) << target;
        expect_planes(first, [&](fast::BitPlanes planes) {
          fast::classify_balls_exact<F>(shaft, batch.view(), planes, predicate);
        });
      });
      ASSERT_LE(counters.predicate_calls, counters.second_stage);
      ASSERT_LE(counters.second_stage, truth.size());
      balls += truth.size();
      all.second_stage += counters.second_stage;
      all.predicate_calls += counters.predicate_calls;
    }
    if (std::getenv("GNOMON_PRINT") != nullptr) {
      std::printf("%-16s %8zu balls, second stage %.5f, predicate %.5f\n", choice.label().c_str(),
                  std::size_t(balls), double(all.second_stage) / double(balls),
                  double(all.predicate_calls) / double(balls));
    }
    const std::string name(choice.distribution->name);
    // These batches are full of ties: a second stage that is never needed would test nothing.
    EXPECT_GT(all.second_stage, 0) << name;
    total += static_cast<std::int64_t>(balls);
    second += static_cast<std::int64_t>(all.second_stage);
    predicate_calls += static_cast<std::int64_t>(all.predicate_calls);
  }
  EXPECT_GE(total, affordable(100000));
  EXPECT_GT(second, affordable(1000));
  EXPECT_GT(predicate_calls, 0);
  EXPECT_GT(wastes, 0);
}

TYPED_TEST(BatchBall, FewBallsNeedThePredicate) {
  using F = TypeParam;
  for (const char* name : {"uniform", "offset", "integer-grid"}) {
    const auto choice = fuzz::parse_distribution(name);
    const auto generator = fuzz::make_generator<scene::ShaftBallCase>(choice, kScalarOf<F>);
    BatchCounters all;
    std::uint64_t balls = 0;
    for (std::uint64_t trial = 0; trial < 100; ++trial) {
      fuzz::CaseRandom random(21, 1, trial);
      const auto own = scene::converted<F>(generator->make(random));
      BallBatch<F> batch{own.a, own.b, {}};
      for (int i = 0; i < 500; ++i) batch.add(scene::converted<F>(generator->make(random)).t);
      std::vector<std::uint8_t> answers(500);
      const auto now = fast::classify_balls_exact<F>({own.a, own.b}, batch.view(), answers,
                                                     predicate_for(batch, truth_of(batch)));
      const auto truth = truth_of(batch);
      for (std::size_t i = 0; i < truth.size(); ++i) ASSERT_EQ(static_cast<Category>(answers[i]), truth[i]);
      all.second_stage += now.second_stage;
      all.predicate_calls += now.predicate_calls;
      balls += truth.size();
    }
    const bool ties = choice.distribution->name == "integer-grid";
    if (ties) {
      EXPECT_GT(all.second_stage, balls / 100);
      EXPECT_EQ(all.predicate_calls, 0);  // integers: everything is exact in registers
    } else {
      EXPECT_LT(all.second_stage, balls / 20) << name;
      EXPECT_LT(all.predicate_calls, balls / 1000) << name;
    }
  }
}

TYPED_TEST(BatchBall, TailsOfEveryLengthReadAndWriteNothingElse) {
  using F = TypeParam;
  const auto choices = file_free_distributions();
  const BallBatch<F> batch = make_balls<F>(choices[3], 5, kBalls);
  const auto shaft = fast::form_shaft(batch.a, batch.b, fast::Normals::unit);
  const fast::ExactBallShaft<F> exact_shaft(batch.a, batch.b);
  const auto predicate = predicate_for(batch, truth_of(batch));
  const auto expected = bytes_of<F>(shaft, batch.view());
  std::vector<std::uint8_t> expected_exact(kBalls);
  fast::classify_balls_exact<F>(exact_shaft, batch.view(), expected_exact, predicate);
  for (std::size_t count = 0; count <= 2 * 64 + 1; ++count) {
    BallBatch<F> part{batch.a, batch.b, {}};  // arrays of exactly `count` numbers, for the address sanitizer
    for (std::size_t k = 0; k < 4; ++k) {
      part.c[k].assign(batch.c[k].begin(), batch.c[k].begin() + static_cast<std::ptrdiff_t>(count));
      part.c[k].shrink_to_fit();
    }
    for_each_target([&](const std::string& target) {
      for (const bool exact : {false, true}) {
        std::vector<std::uint8_t> answers(count + 2, 77);
        const std::span<std::uint8_t> middle = std::span(answers).subspan(1, count);
        if (exact) {
          fast::classify_balls_exact<F>(exact_shaft, part.view(), middle, predicate);
        } else {
          fast::classify_balls<F>(shaft, part.view(), middle);
        }
        ASSERT_EQ(answers.front(), 77);
        ASSERT_EQ(answers.back(), 77);
        const auto& whole = exact ? expected_exact : expected;
        ASSERT_TRUE(std::equal(middle.begin(), middle.end(), whole.begin())) << target << " " << count;
        std::vector<std::uint64_t> kept(fast::words_for(count) + 1, 99), inside(kept);
        if (exact) {
          fast::classify_balls_exact<F>(exact_shaft, part.view(), {kept.data(), inside.data()}, predicate);
        } else {
          fast::classify_balls<F>(shaft, part.view(), {kept.data(), inside.data()});
        }
        ASSERT_EQ(kept.back(), 99);
        ASSERT_EQ(inside.back(), 99);
      }
    });
  }
}

}  // namespace gnomon::tests
