// SPDX-License-Identifier: GPL-3.0-or-later
// Claim S9: which half-spaces the volume of a shaft needs, and which the test of boxes needs: all of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <vector>

#include "exact/shaft_box.h"
#include "fast/shaft_box.h"
#include "fuzz/shaft_questions.h"
#include "scene/corpus.h"
#include "tests/half_spaces.h"
#include "tests/shaft_random.h"
#include "tests/shaft_rational_reference.h"
#include "tests/shaft_text.h"

namespace gnomon::tests {
namespace {

using scene::Category;
using IntegerBox = std::array<long, 6>;  ///< lo(3) hi(3)

/// How far a box reaches outwards on a face; faces 0..2 are minima, 3..5 maxima.
long reach(const IntegerBox& box, std::size_t face) {
  return face < 3 ? -box[face] : box[face];
}
/// Where a box begins, seen outwards: the reach of its near side.
long near_reach(const IntegerBox& t, std::size_t face) {
  return -reach(t, (face + 3) % 6);
}
Integer3 outwards(std::size_t face, long length) {
  Integer3 n{};
  n[face % 3] = face < 3 ? -length : length;
  return n;
}

/// One comparison of the box test: a side of the extent box (f = g), or the plane of the edges on f (a
/// extreme) and g (b extreme).
struct Condition {
  std::size_t f, g;
  long weight_f, weight_g;  ///< of the outward reaches: weight_f x_f + weight_g x_g <= limit
  long limit;

  [[nodiscard]] bool parts(const IntegerBox& t) const {
    return weight_f * near_reach(t, f) + weight_g * near_reach(t, g) > limit;
  }
  [[nodiscard]] HalfSpace half_space() const {
    Integer3 n = outwards(f, weight_f);
    const Integer3 m = outwards(g, weight_g);
    for (std::size_t i = 0; i < 3; ++i) n[i] += m[i];
    return {n, -limit};
  }
};

std::vector<Condition> conditions_of(const IntegerBox& a, const IntegerBox& b) {
  std::vector<Condition> conditions;
  for (std::size_t f = 0; f < 6; ++f) conditions.push_back({f, f, 1, 0, std::max(reach(a, f), reach(b, f))});
  for (std::size_t f = 0; f < 6; ++f) {
    for (std::size_t g = 0; g < 6; ++g) {
      const long af = reach(a, f), ag = reach(a, g), bf = reach(b, f), bg = reach(b, g);
      if (f % 3 == g % 3 || !(af > bf) || !(bg > ag)) continue;
      conditions.push_back({f, g, bg - ag, af - bf, (bg - ag) * af + (af - bf) * ag});
    }
  }
  return conditions;
}

/// A box that the given test alone parts from the shaft: everything beyond the side; or everything from a's
/// side f and b's side g on. `far` stands for infinity.
IntegerBox box_for(const Condition& test, const IntegerBox& a, const IntegerBox& b, long far) {
  IntegerBox t{-far, -far, -far, far, far, far};
  const auto begin_at = [&t](std::size_t face, long x) { t[(face + 3) % 6] = face < 3 ? -x : x; };
  if (test.f == test.g) {
    begin_at(test.f, std::max(reach(a, test.f), reach(b, test.f)) + 1);
  } else {
    begin_at(test.f, reach(a, test.f));
    begin_at(test.g, reach(b, test.g));
  }
  return t;
}

/// By the definition, in exact fractions: no s in [0, 1] satisfies (1-s) a_f + s b_f >= near_f for all faces.
bool misses(const IntegerBox& a, const IntegerBox& b, const IntegerBox& t) {
  long from = 0, from_over = 1, to = 1, to_over = 1;
  for (std::size_t face = 0; face < 6; ++face) {
    const long p = reach(a, face) - near_reach(t, face), q = reach(b, face) - reach(a, face);  // p + q s >= 0
    if (q == 0 && p < 0) return true;
    if (q > 0 && -p * from_over > from * q) from = -p, from_over = q;
    if (q < 0 && p * to_over < to * -q) to = p, to_over = -q;
  }
  return from * to_over > to * from_over;
}

std::vector<IntegerBox> boxes(long largest) {
  std::vector<std::array<long, 2>> intervals;
  for (long lo = 0; lo <= largest; ++lo)
    for (long hi = lo; hi <= largest; ++hi) intervals.push_back({lo, hi});
  std::vector<IntegerBox> all;
  for (const auto& x : intervals)
    for (const auto& y : intervals)
      for (const auto& z : intervals) all.push_back({x[0], y[0], z[0], x[1], y[1], z[1]});
  return all;
}

/// The code, whose floats are exact here, says outside with the plane and something else without it.
bool code_needs(const Condition& condition, const IntegerBox& a, const IntegerBox& b, const IntegerBox& t) {
  const auto box = [](const IntegerBox& x) {
    scene::Box<float> result;
    for (std::size_t i = 0; i < 6; ++i) result.c[i] = static_cast<float>(x[i]);
    return result;
  };
  fast::Shaft<float> shaft = fast::form_shaft(box(a), box(b), fast::Normals::as_formed);
  if (fast::classify(shaft, box(t)).answer != Category::outside) return false;
  const auto planes = shaft.planes();
  const auto found = std::find_if(planes.begin(), planes.end(), [&condition](const auto& plane) {
    return plane.far0 == condition.f && plane.far1 == condition.g;
  });
  if (found == planes.end()) return false;
  *found = planes.back();
  --shaft.plane_count;
  return fast::classify(shaft, box(t)).answer != Category::outside;
}

/// The boxes of PlaneMinimal.v's theorems, or larger ones, for every shaft of the grid.
TEST(ProofsNeededPlanes, EverySideAndPlaneIsTheOnlyOneToPartSomeBox) {
  const std::vector<IntegerBox> all = boxes(kSanitized ? 2 : 3);
  std::uint64_t planes = 0, sides = 0, wrong = 0;
  for (const IntegerBox& a : all) {
    for (const IntegerBox& b : all) {
      const std::vector<Condition> conditions = conditions_of(a, b);
      for (const Condition& condition : conditions) {
        const IntegerBox t = box_for(condition, a, b, 100);
        ++(condition.f == condition.g ? sides : planes);
        const auto parting = std::count_if(conditions.begin(), conditions.end(),
                                           [&t](const Condition& x) { return x.parts(t); });
        wrong += !condition.parts(t) || parting != 1 || !misses(a, b, t);
        if (condition.f != condition.g) wrong += !code_needs(condition, a, b, t);
      }
    }
  }
  std::printf("%llu sides and %llu planes, each the only one to part some box\n",
              static_cast<unsigned long long>(sides), static_cast<unsigned long long>(planes));
  EXPECT_EQ(wrong, 0U);
  EXPECT_EQ(sides, 6 * all.size() * all.size());
  EXPECT_GT(planes, all.size() * all.size());
}

struct Redundant {
  std::uint64_t shafts = 0, with_side = 0, with_plane = 0;
  std::uint64_t solid_with_side = 0, solid_with_plane = 0;  ///< both boxes have a volume
};

Redundant count_redundant(long largest) {
  const std::vector<IntegerBox> all = boxes(largest);
  Redundant result;
  for (const IntegerBox& a : all) {
    for (const IntegerBox& b : all) {
      // Exchanging a and b changes nothing.
      if (b < a) continue;
      std::vector<HalfSpace> half_spaces;
      const std::vector<Condition> conditions = conditions_of(a, b);
      for (const Condition& condition : conditions) half_spaces.push_back(condition.half_space());
      bool side = false, plane = false, solid = true;
      for (std::size_t i = 0; i < 6 && !side; ++i) side = is_redundant(half_spaces, i);
      for (std::size_t i = 6; i < half_spaces.size(); ++i) {
        // As PlaneMinimal.plane_cuts_volume_exactly_when says: both flat, apart, on the axis along the plane.
        const std::size_t k = 3 - conditions[i].f % 3 - conditions[i].g % 3;
        const bool flat_apart = a[k] == a[k + 3] && b[k] == b[k + 3] && a[k] != b[k];
        const bool redundant = is_redundant(half_spaces, i);
        EXPECT_EQ(redundant, flat_apart);
        plane |= redundant;
      }
      for (std::size_t i = 0; i < 3; ++i) solid = solid && a[i] < a[i + 3] && b[i] < b[i + 3];
      const std::uint64_t weight = a == b ? 1 : 2;
      result.shafts += weight;
      result.with_side += weight * side;
      result.with_plane += weight * plane;
      result.solid_with_side += weight * (side && solid);
      result.solid_with_plane += weight * (plane && solid);
    }
  }
  std::printf(
      "coordinates 0..%ld: %llu shafts; the volume can do without a side: %llu, without a plane: %llu; "
      "of two boxes with a volume: %llu, %llu\n",
      largest, static_cast<unsigned long long>(result.shafts),
      static_cast<unsigned long long>(result.with_side), static_cast<unsigned long long>(result.with_plane),
      static_cast<unsigned long long>(result.solid_with_side),
      static_cast<unsigned long long>(result.solid_with_plane));
  return result;
}

/// Flat boxes only: a side holds a face of one box and a plane an edge of each, which with a volume are
/// facets.
TEST(ProofsNeededPlanes, TheVolumeCanDoWithoutSome) {
  const Redundant redundant = count_redundant(kSanitized ? 2 : 3);
  EXPECT_EQ(redundant.shafts, kSanitized ? 216U * 216U : 1'000'000U);
  EXPECT_GT(redundant.with_side, 0U);
  EXPECT_GT(redundant.with_plane, 0U);
  EXPECT_EQ(redundant.solid_with_side + redundant.solid_with_plane, 0U);
}

std::vector<scene::CorpusLine> witnesses(const char* name) {
  return scene::read_corpus(std::filesystem::path(GNOMON_SOURCE_DIR) / "proofs/witnesses" / name);
}

/// Quarters are the finest that the witnesses hold.
long in_quarters(double x) {
  const long result = static_cast<long>(4 * x);
  EXPECT_EQ(static_cast<double>(result), 4 * x) << x;
  return result;
}

TEST(ProofsNeededPlanes, WitnessesNeedWhatTheVolumeDoesNot) {
  int lines = 0;
  for (const scene::CorpusLine& line : witnesses("needed_planes.txt")) {
    const std::vector<double> numbers = line.numbers(18);
    IntegerBox a{}, b{}, t{};
    for (std::size_t i = 0; i < 6; ++i) {
      a[i] = in_quarters(numbers[i]);
      b[i] = in_quarters(numbers[i + 6]);
      t[i] = in_quarters(numbers[i + 12]);
    }
    const auto c = fuzz::case_of<scene::ShaftBoxCase>(numbers);
    EXPECT_EQ(exact::classify(c), Category::outside) << text_of(c);
    EXPECT_EQ(refer_by_brute_force(c).truth, Category::outside) << text_of(c);
    EXPECT_TRUE(misses(a, b, t)) << text_of(c);

    const std::vector<Condition> conditions = conditions_of(a, b);
    std::vector<HalfSpace> half_spaces;
    std::vector<std::size_t> parting;
    for (std::size_t i = 0; i < conditions.size(); ++i) {
      half_spaces.push_back(conditions[i].half_space());
      if (conditions[i].parts(t)) parting.push_back(i);
    }
    ASSERT_EQ(parting.size(), 1U) << text_of(c);
    EXPECT_TRUE(is_redundant(half_spaces, parting[0])) << text_of(c);
    ++lines;
  }
  EXPECT_EQ(lines, 3);
}

TEST(ProofsNeededPlanes, NearCornersOfAnArbitraryPlaneSetAreNotExact) {
  int lines = 0;
  for (const scene::CorpusLine& line : witnesses("polyhedra.txt")) {
    ASSERT_EQ(line.question, "polyhedron-box");
    ASSERT_EQ(line.words.size() % 4, 2U);
    const std::vector<double> numbers = line.numbers(line.words.size());
    IntegerBox t{};
    for (std::size_t i = 0; i < 6; ++i) t[i] = in_quarters(numbers[i]);
    std::vector<HalfSpace> polyhedron;
    for (std::size_t i = 6; i < numbers.size(); i += 4) {
      const auto at = [&](std::size_t k) { return static_cast<long>(numbers[i + k]); };
      polyhedron.push_back({{at(0), at(1), at(2)}, in_quarters(numbers[i + 3])});
    }
    for (const HalfSpace& h : polyhedron) {
      long value = h.d;
      for (std::size_t axis = 0; axis < 3; ++axis) value += h.n[axis] * t[h.n[axis] > 0 ? axis : axis + 3];
      EXPECT_LE(value, 0) << line.line;
    }
    EXPECT_FALSE(have_no_common_point(polyhedron));
    std::vector<HalfSpace> both = polyhedron;
    for (std::size_t face = 0; face < 6; ++face) both.push_back({outwards(face, 1), -reach(t, face)});
    EXPECT_TRUE(have_no_common_point(both)) << line.line;
    ++lines;
  }
  EXPECT_EQ(lines, 2);
}

}  // namespace
}  // namespace gnomon::tests
