// SPDX-License-Identifier: GPL-3.0-or-later
// The constants that the theorems are proved for are the constants that the code uses: those of
// CertifiedConstants by name, and all of them, with the order of operations, by what form_certified_*_shaft()
// makes of real shafts.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <regex>
#include <string>
#include <type_traits>

#include "fast/certified_shaft.h"

namespace gnomon::tests {
namespace {

using fast::CertifiedConstants;
using fast::Shaft;
using fast::ShaftPlane;
using scene::Box;

/// Every `Definition NAME : R := NUMBER.` of proofs/*.v.
const std::map<std::string, double>& proved() {
  static const std::map<std::string, double> constants = [] {
    std::map<std::string, double> found;
    const std::regex definition(R"(^Definition ([a-z0-9_]+) : R := ([0-9.]+)\.$)");
    for (const auto& entry : std::filesystem::directory_iterator(GNOMON_SOURCE_DIR "/proofs")) {
      if (entry.path().extension() != ".v") continue;
      std::ifstream file(entry.path());
      std::smatch match;
      for (std::string line; std::getline(file, line);) {
        if (!std::regex_match(line, match, definition)) continue;
        EXPECT_TRUE(found.emplace(match[1], std::strtod(match[2].str().c_str(), nullptr)).second)
            << match[1] << " is defined twice";
      }
    }
    return found;
  }();
  return constants;
}

double proved(const std::string& name) {
  const auto found = proved().find(name);
  if (found == proved().end()) {
    ADD_FAILURE() << "no theorem is about " << name;
    return std::nan("");
  }
  return found->second;
}

TEST(ProofsConstants, NamedOnesAreTheProvedOnes) {
  EXPECT_EQ(CertifiedConstants::box_plane, proved("box_plane"));
  EXPECT_EQ(CertifiedConstants::ball_shortening, proved("ball_shortening"));
  EXPECT_EQ(CertifiedConstants::ball_outside_p, proved("ball_outside_p"));
  EXPECT_EQ(CertifiedConstants::ball_outside_d, proved("ball_outside_d"));
  EXPECT_EQ(CertifiedConstants::ball_outside_b, proved("ball_outside_b"));
  EXPECT_EQ(CertifiedConstants::ball_inside_p, proved("ball_inside_p"));
  EXPECT_EQ(CertifiedConstants::ball_inside_d, proved("ball_inside_d"));
  EXPECT_EQ(CertifiedConstants::square_factor, proved("square_factor"));
  EXPECT_EQ(CertifiedConstants::side_factor, proved("side_factor"));
}

template <class F>
class ProofsConstants : public testing::Test {
 protected:
  static constexpr F u = fast::Rounding<F>::u;
  static constexpr F two_eta = fast::Rounding<F>::two_eta;

  /// Boxes of sizes from denormal to far beyond what a scene has.
  void boxes(Box<F>& a, Box<F>& b) {
    const int size = std::uniform_int_distribution<int>(std::is_same_v<F, float> ? -145 : -1070,
                                                        std::is_same_v<F, float> ? 55 : 500)(random_);
    std::uniform_real_distribution<F> coordinate(-1, 1);
    for (Box<F>* box : {&a, &b}) {
      for (int axis = 0; axis < 3; ++axis) {
        const F p = std::scalbn(coordinate(random_), size), q = std::scalbn(coordinate(random_), size);
        box->lo(axis) = std::min(p, q);
        box->hi(axis) = std::max(p, q);
      }
    }
  }
  static F magnitude(const Box<F>& extent, fast::Face face) {
    const int axis = fast::axis_of(face);
    return std::max(std::fabs(extent.lo(axis)), std::fabs(extent.hi(axis)));
  }

  std::mt19937_64 random_{1};
};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(ProofsConstants, Scalars);

/// BoxThreshold.v: box_sum, box_threshold. BoxGap.v: code_box_gap.
TYPED_TEST(ProofsConstants, BoxThresholdsAreComputedAsProved) {
  using F = TypeParam;
  int planes = 0;
  for (int i = 0; i < 5000; ++i) {
    Box<F> a, b;
    this->boxes(a, b);
    const Shaft<F> shaft = fast::form_certified_box_shaft(a, b);
    F gap = 0;
    for (const ShaftPlane<F>& plane : shaft.planes()) {
      if (std::isinf(plane.outside_threshold)) {
        gap = plane.outside_threshold;
        continue;
      }
      ++planes;
      const F x = this->magnitude(shaft.extent, plane.far0), y = this->magnitude(shaft.extent, plane.far1);
      const F sum = std::fabs(plane.n0) * (x + std::fabs(a.c[plane.far0])) +
                    std::fabs(plane.n1) * (y + std::fabs(a.c[plane.far1]));
      const F threshold = F(proved("box_plane")) * this->u * sum + F(proved("box_underflow")) * this->two_eta;
      ASSERT_EQ(plane.outside_threshold, threshold);
      ASSERT_EQ(plane.inside_threshold, -threshold);
      const F length = std::fabs(plane.n0) + std::fabs(plane.n1);
      gap =
          std::max(gap, 2 * threshold / length * (1 + F(proved("gap_inflation")) * this->u) + this->two_eta);
    }
    ASSERT_EQ(shaft.stated_gap.base, gap);
  }
  EXPECT_GT(planes, 10000);
}

/// ShortenedNormal.v, BallThreshold.v: code_m, code_outside, code_inside. BallSlack.v. BallGap.v: code_base,
/// code_gap.
TYPED_TEST(ProofsConstants, BallThresholdsAreComputedAsProved) {
  using F = TypeParam;
  const F safe = std::is_same_v<F, float> ? F(0x1p40) : F(0x1p300);
  int planes = 0;
  for (int i = 0; i < 5000; ++i) {
    Box<F> a, b;
    this->boxes(a, b);
    const Shaft<F> shaft = fast::form_certified_ball_shaft(a, b);
    const Shaft<F> formed = fast::form_shaft(a, b, fast::Normals::as_formed);
    EXPECT_EQ(shaft.slack.square_factor, 1 + F(proved("square_factor")) * this->u);
    EXPECT_EQ(shaft.slack.square_offset, F(proved("square_offset")) * this->two_eta);
    EXPECT_EQ(shaft.slack.inside_factor, 1 + F(proved("side_factor")) * this->u);
    EXPECT_EQ(shaft.stated_gap.per_radius, F(proved("gap_per_radius")) * this->u);
    F base = 0;
    for (std::size_t k = 0; k < shaft.plane_count; ++k) {
      const ShaftPlane<F>& plane = shaft.plane_set[k];
      if (std::isinf(plane.outside_threshold)) {
        base = plane.outside_threshold;
        continue;
      }
      ++planes;
      F n0 = formed.plane_set[k].n0, n1 = formed.plane_set[k].n1;
      const F larger = std::max(std::fabs(n0), std::fabs(n1));
      if (!(larger >= 1 / safe && larger <= safe)) {
        const int exponent = std::ilogb(larger);
        n0 = std::scalbn(n0, -exponent);
        n1 = std::scalbn(n1, -exponent);
      }
      const F length = std::sqrt(n0 * n0 + n1 * n1);
      const F scale = (1 - F(proved("ball_shortening") + proved("scaling_error")) * this->u) / length;
      ASSERT_EQ(plane.n0, n0 * scale);
      ASSERT_EQ(plane.n1, n1 * scale);

      const F a0 = a.c[plane.far0], a1 = a.c[plane.far1], b0 = b.c[plane.far0], b1 = b.c[plane.far1];
      const F x = this->magnitude(shaft.extent, plane.far0), y = this->magnitude(shaft.extent, plane.far1);
      const F m0 = std::fabs(plane.n0), m1 = std::fabs(plane.n1);
      const F p = m0 * x + m1 * y;
      const F d = m0 * std::fabs(a0) + m1 * std::fabs(a1);
      const F w = m0 * std::fabs(b0 - a0) + m1 * std::fabs(b1 - a1);
      const F underflow = std::numeric_limits<F>::min() * (1 + x + y);
      const F inflated = F(proved("inflate")) * this->u;
      ASSERT_EQ(plane.d, -(plane.n0 * a0 + plane.n1 * a1));
      ASSERT_EQ(plane.outside_threshold,
                inflated * (F(proved("ball_outside_p")) * p + F(proved("ball_outside_d")) * d +
                            F(proved("ball_outside_b")) * w) +
                    underflow);
      ASSERT_EQ(plane.inside_threshold,
                -(inflated * (F(proved("ball_inside_p")) * p + F(proved("ball_inside_d")) * d) + underflow));
      const F larger_threshold = std::max(plane.outside_threshold, -plane.inside_threshold);
      base = std::max(base, F(proved("inflate")) * (larger_threshold + this->u * (F(proved("gap_p")) * p)) +
                                F(proved("gap_underflow")) * underflow);
    }
    const F root = std::is_same_v<F, float> ? F(0x1p-72) : F(0x1p-534);  // BallGap.v: kept_ball_grown_is_kept
    EXPECT_GE(root, 8 * this->two_eta);
    EXPECT_GE(root * root, 10 * this->two_eta);
    ASSERT_EQ(shaft.stated_gap.base, base + root);
  }
  EXPECT_GT(planes, 10000);
}

/// RoundingModel.v's formats are the machine's.
/// Overflow.v: largest_safe, a power of two; the code takes the largest number below it.
TYPED_TEST(ProofsConstants, PlanesDecideUpToTheProvedSize) {
  using F = TypeParam;
  std::ifstream file(GNOMON_SOURCE_DIR "/proofs/Overflow.v");
  const std::regex definition(R"(^Definition largest_safe : R := bpow radix2 \(emax - ([0-9]+)\)\.$)");
  std::smatch match;
  std::string line;
  while (std::getline(file, line) && !std::regex_match(line, match, definition)) continue;
  ASSERT_FALSE(match.empty()) << "no theorem is about largest_safe";
  const F power = std::scalbn(F(1), std::numeric_limits<F>::max_exponent - std::stoi(match[1]));
  const F largest = std::nextafter(power, F(0));
  // Two points a diagonal apart: the sum of both planes is 2 x y, exactly.
  const F x = std::scalbn(F(1), std::numeric_limits<F>::max_exponent / 2), y = largest / 2 / x;
  const Box<F> origin{};
  EXPECT_EQ(fast::form_certified_ball_shaft(origin, origin).slack.largest_radius, largest);
  for (const bool safe : {true, false}) {
    const F side = safe ? y : std::nextafter(y, x);
    Shaft<F> shaft = fast::form_certified_box_shaft(origin, Box<F>{{x, side, 0, x, side, 0}});
    ASSERT_EQ(shaft.plane_count, 2u);
    for (const ShaftPlane<F>& plane : shaft.planes()) {
      EXPECT_EQ(std::isfinite(plane.outside_threshold), safe);
      EXPECT_EQ(std::isfinite(plane.inside_threshold), safe);
    }
  }
}

TEST(ProofsConstants, FormatsAreTheMachines) {
  std::ifstream file(GNOMON_SOURCE_DIR "/proofs/RoundingModel.v");
  const std::string text(std::istreambuf_iterator<char>(file), {});
  const auto format = [](int prec, int emin, int emax, int safe) {
    return "prec := " + std::to_string(prec) + "; emin := " + std::to_string(emin) +
           "; emax := " + std::to_string(emax) + "; safe_exponent := " + std::to_string(safe);
  };
  using Float = std::numeric_limits<float>;
  using Double = std::numeric_limits<double>;
  EXPECT_NE(text.find(format(Float::digits, std::ilogb(Float::denorm_min()), Float::max_exponent, 40)),
            std::string::npos);
  EXPECT_NE(text.find(format(Double::digits, std::ilogb(Double::denorm_min()), Double::max_exponent, 300)),
            std::string::npos);
}

}  // namespace
}  // namespace gnomon::tests
