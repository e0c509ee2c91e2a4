// SPDX-License-Identifier: GPL-3.0-or-later
// The random numbers behind every case: known answers, so that a change of any stream is noticed.
#include "fuzz/random.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

namespace gnomon::fuzz {
namespace {

using Block = std::array<std::uint32_t, 4>;

Block philox(const Block& counter, std::uint32_t key0, std::uint32_t key1) {
  const r123::Philox4x32::ctr_type c{{counter[0], counter[1], counter[2], counter[3]}};
  const r123::Philox4x32::key_type key{{key0, key1}};
  const auto block = r123::Philox4x32()(c, key);
  return {block.v[0], block.v[1], block.v[2], block.v[3]};
}

Block next_block(CaseRandom& random) {
  Block block{};
  for (std::uint32_t& word : block) word = random.bits();
  return block;
}

// Random123's own vectors (tests/kat_vectors, philox4x32 with 10 rounds).
TEST(Random, PhiloxGivesTheKnownAnswers) {
  EXPECT_EQ(philox({0, 0, 0, 0}, 0, 0), (Block{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(philox({0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff}, 0xffffffff, 0xffffffff),
            (Block{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, 0xa4093822, 0x299f31d0),
            (Block{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(Random, TheFirstTrialOfSeedZeroIsTheKnownAnswer) {
  CaseRandom random(0, 0, 0);
  EXPECT_EQ(next_block(random), (Block{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
}

RC_GTEST_PROP(Random, SeedIsTheKeyAndTrialStreamBlockAreTheCounter,
              (std::uint64_t seed, std::uint32_t stream, std::uint64_t trial)) {
  CaseRandom random(seed, stream, trial);
  for (std::uint32_t block = 0; block < 5; ++block) {
    const Block expected =
        philox({static_cast<std::uint32_t>(trial), static_cast<std::uint32_t>(trial >> 32), stream, block},
               static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32));
    RC_ASSERT(next_block(random) == expected);
  }
}

RC_GTEST_PROP(Random, IsAPureFunctionOfSeedStreamAndTrial,
              (std::uint64_t seed, std::uint32_t stream, std::uint64_t trial)) {
  CaseRandom first(seed, stream, trial), again(seed, stream, trial);
  (void)CaseRandom(seed, stream, trial + 1).bits();  // what other trials do changes nothing
  for (int i = 0; i < 9; ++i) RC_ASSERT(first.bits() == again.bits());
}

TEST(Random, SeedsStreamsAndTrialsDiffer) {
  std::set<Block> seen;
  std::size_t made = 0;
  const auto add = [&](std::uint64_t seed, std::uint32_t stream, std::uint64_t trial) {
    CaseRandom random(seed, stream, trial);
    seen.insert(next_block(random));
    ++made;
  };
  for (int bit = 0; bit < 64; ++bit) {
    add(std::uint64_t{1} << bit, 0, 0);
    add(0, 0, std::uint64_t{1} << bit);
  }
  for (int bit = 0; bit < 32; ++bit) add(0, std::uint32_t{1} << bit, 0);
  add(0, 0, 0);
  EXPECT_EQ(seen.size(), made);
}

template <class F>
void expect_on_grid(F step) {
  F least = 1, most = 0;
  double sum = 0;
  constexpr int kDraws = 200000;
  CaseRandom random(7, 0, 0);
  for (int i = 0; i < kDraws; ++i) {
    const F x = random.unit<F>();
    ASSERT_GE(x, F(0));
    ASSERT_LT(x, F(1));
    const F multiple = x / step;
    ASSERT_EQ(multiple, std::floor(multiple)) << x;
    least = std::min(least, x);
    most = std::max(most, x);
    sum += static_cast<double>(x);
  }
  EXPECT_LT(least, F(1e-4));
  EXPECT_GT(most, F(1 - 1e-4));
  // The mean of n uniform numbers has the standard deviation 1 / sqrt(12 n); five of them.
  EXPECT_NEAR(sum / kDraws, 0.5, 5 / std::sqrt(12.0 * kDraws));
}

TEST(Random, UnitFloatsLieOnTheGridBelowOne) {
  expect_on_grid<float>(0x1p-24f);
}
TEST(Random, UnitDoublesLieOnTheGridBelowOne) {
  expect_on_grid<double>(0x1p-53);
}

// The largest bits make the largest unit, which must not be rounded to 1; all-ones blocks are out of reach of
// a test, so the formulas are followed with the bits that come.
TEST(Random, UnitsComeFromTheLeadingBits) {
  CaseRandom bits(3, 4, 5), singles(3, 4, 5), doubles(3, 4, 5);
  for (int i = 0; i < 100; ++i) {
    const std::uint64_t high = bits.bits(), low = bits.bits();
    EXPECT_EQ(singles.unit<float>(), std::ldexp(static_cast<float>(high >> 8), -24));
    EXPECT_EQ(singles.unit<float>(), std::ldexp(static_cast<float>(low >> 8), -24));
    EXPECT_EQ(doubles.unit<double>(), std::ldexp(static_cast<double>(((high << 32) | low) >> 11), -53));
  }
  EXPECT_LT(static_cast<float>(0xffffffffu >> 8) * 0x1p-24f, 1.0f);
  EXPECT_LT(static_cast<double>(~std::uint64_t{0} >> 11) * 0x1p-53, 1.0);
}

TEST(Random, BelowAndIntegerCoverTheirRangesEvenly) {
  CaseRandom random(1, 2, 3);
  std::array<int, 7> counts{};
  constexpr int kDraws = 70000;
  for (int i = 0; i < kDraws; ++i) {
    const int x = random.integer(-3, 3);
    ASSERT_GE(x, -3);
    ASSERT_LE(x, 3);
    ++counts[static_cast<std::size_t>(x + 3)];
  }
  for (const int count : counts) EXPECT_NEAR(count, kDraws / 7, 500);  // over five standard deviations
  for (int i = 0; i < 100; ++i) EXPECT_EQ(random.below(1), 0);
}

TEST(Random, ChanceAndSignAreFair) {
  CaseRandom random(1, 2, 3);
  int hits = 0, positive = 0;
  constexpr int kDraws = 40000;
  for (int i = 0; i < kDraws; ++i) {
    hits += random.chance(0.25) ? 1 : 0;
    const double sign = random.sign<double>();
    ASSERT_EQ(std::fabs(sign), 1);
    positive += sign > 0 ? 1 : 0;
    ASSERT_FALSE(random.chance(0));
    ASSERT_TRUE(random.chance(1));
  }
  EXPECT_NEAR(hits, kDraws / 4, 450);
  EXPECT_NEAR(positive, kDraws / 2, 520);
}

TEST(Random, BetweenStaysWithin) {
  CaseRandom random(9, 9, 9);
  for (int i = 0; i < 10000; ++i) {
    const float x = random.between<float>(-2, 3);
    ASSERT_GE(x, -2);
    ASSERT_LE(x, 3);
  }
}

TEST(Random, TrialsThatShareAShaftDrawTheSameForItAndTheirOwnForT) {
  // Two numbers for the shaft, five for t, one more for the shaft, one for t.
  const auto draws = [](std::uint64_t trial, std::uint64_t per_shaft) {
    CaseRandom random(5, 6, trial, per_shaft);
    std::vector<std::uint32_t> shaft, t;
    for (int i = 0; i < 2; ++i) shaft.push_back(random.bits());
    random.part(Part::t);
    for (int i = 0; i < 5; ++i) t.push_back(random.bits());
    random.part(Part::shaft);
    shaft.push_back(random.bits());
    random.part(Part::t);
    t.push_back(random.bits());
    return std::pair(shaft, t);
  };
  std::set<std::vector<std::uint32_t>> shafts, ts;
  std::set<std::uint32_t> numbers;
  for (std::uint64_t trial = 0; trial < 30; ++trial) {
    const auto [shaft, t] = draws(trial, 10);
    EXPECT_EQ(shaft, draws(trial - trial % 10, 10).first);
    EXPECT_EQ(std::pair(shaft, t), draws(trial, 10));
    if (shafts.insert(shaft).second) numbers.insert(shaft.begin(), shaft.end());
    ts.insert(t);
    numbers.insert(t.begin(), t.end());
  }
  EXPECT_EQ(shafts.size(), 3u);
  EXPECT_EQ(ts.size(), 30u);
  EXPECT_EQ(numbers.size(), 3u * 3 + 30 * 6);  // none is drawn twice

  // Alone, a trial draws one sequence, as ever.
  const auto [shaft, t] = draws(7, 1);
  CaseRandom plain(5, 6, 7);
  for (int i = 0; i < 2; ++i) EXPECT_EQ(plain.bits(), shaft[static_cast<std::size_t>(i)]);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(plain.bits(), t[static_cast<std::size_t>(i)]);
  EXPECT_EQ(plain.bits(), shaft[2]);
  EXPECT_EQ(plain.bits(), t[5]);
}

// FNV-1a's published values, then the streams that result files of earlier versions stand on.
TEST(Random, StreamNamesHashToTheirConstants) {
  EXPECT_EQ(stream_of(""), 0x811c9dc5u);
  EXPECT_EQ(stream_of("a"), 0xe40c292cu);
  EXPECT_EQ(stream_of("foobar"), 0xbf9cf968u);
  EXPECT_EQ(stream_of("shaft-box uniform f32"), 0x44a468b4u);
  EXPECT_EQ(stream_of("shaft-sphere near-touch f64"), 0xe32d2a51u);
  EXPECT_EQ(stream_of("\xff"), (2166136261u ^ 0xffu) * 16777619u);  // bytes, whatever char's sign is
}

}  // namespace
}  // namespace gnomon::fuzz
