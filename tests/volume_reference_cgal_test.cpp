// SPDX-License-Identifier: GPL-3.0-or-later
// Oriented boxes, slab sets and ellipsoids, flat ones too, against CGAL's exact linear and quadratic
// programming solver.
#include <gtest/gtest.h>

#include "fuzz/generator.h"
#include "fuzz/volume_questions.h"
#include "scene/corpus.h"
#include "tests/shaft_lp_reference.h"

namespace gnomon::tests {
namespace {

using scene::Category;

const std::array<const char*, 6> kDistributions{"uniform",    "integer-grid", "near-touch",
                                                "degenerate", "thin",         "offset"};

template <class Q, class Check>
void for_cases(int few, const Check& check) {
  const char* const more = std::getenv("GNOMON_REFERENCE_CASES");
  const int count = more == nullptr ? few : std::max(few, std::atoi(more) / 60);
  for (const char* name : kDistributions) {
    const auto generator =
        fuzz::make_generator<typename Q::Case>(fuzz::parse_distribution(name), scene::Scalar::f32);
    for (int i = 0; i < count && !testing::Test::HasFailure(); ++i) {
      fuzz::CaseRandom random(31, fuzz::stream_of(name), static_cast<std::uint64_t>(i));
      const typename Q::Case c = generator->make(random);
      SCOPED_TRACE(std::string(name) + ": " + scene::corpus_text(Q::id, fuzz::numbers_of(c), ""));
      check(c);
    }
  }
}

template <class Case>
exact::VolumeReference reference_of(const Case& c) {
  exact::VolumeReference reference;
  exact::refer(std::span(&c, 1), std::span(&reference, 1));
  return reference;
}

/// sum lambda v - M u = c with free variables u.
template <class Case>
HullProgram program_of(const Case& c) {
  HullProgram program(c.a, c.b);
  for (int k = 0; k < 3; ++k) {
    (*program).set_l(16 + k, false);
    for (int axis = 0; axis < 3; ++axis) {
      (*program).set_a(16 + k, axis, -c.t.axes[static_cast<std::size_t>(k)][static_cast<std::size_t>(axis)]);
    }
    (*program).set_b(k, c.t.centre[static_cast<std::size_t>(k)]);
  }
  return program;
}

TEST(VolumePrograms, EllipsoidsByLeastSquares) {
  int outside = 0, flat_and_outside = 0;
  for_cases<fuzz::ShaftEllipsoidQuestion>(60, [&](const scene::ShaftEllipsoidCase& c) {
    HullProgram program = program_of(c);
    for (int k = 0; k < 3; ++k) (*program).set_d(16 + k, 16 + k, 2);
    const Solution solution = program.solve_quadratic();
    const exact::VolumeReference r = reference_of(c);
    outside += r.truth == Category::outside;
    if (solution.is_infeasible()) {
      ++flat_and_outside;
      EXPECT_EQ(r.truth, Category::outside);
      return;
    }
    const auto against_1 =
        CGAL::compare(solution.objective_value(), CGAL::Quotient<ExactNumber>(ExactNumber(1)));
    EXPECT_EQ(against_1 == CGAL::LARGER, r.truth == Category::outside);
    if (against_1 == CGAL::EQUAL) {
      EXPECT_TRUE(r.touches_outside);
    }
  });
  EXPECT_GE(outside, 60);
  EXPECT_GE(flat_and_outside, 5);
}

/// |u_k| <= 1 as u_k + slack = 1 and -u_k + slack = 1.
TEST(VolumePrograms, OrientedBoxes) {
  int outside = 0;
  for_cases<fuzz::ShaftOrientedBoxQuestion>(60, [&](const scene::ShaftOrientedBoxCase& c) {
    HullProgram program = program_of(c);
    for (int k = 0; k < 3; ++k) {
      for (const int sign : {0, 1}) {
        const int row = 4 + 2 * k + sign;
        (*program).set_a(16 + k, row, sign == 0 ? 1 : -1);
        (*program).set_a(19 + 2 * k + sign, row, 1);
        (*program).set_b(row, 1);
      }
    }
    const exact::VolumeReference r = reference_of(c);
    outside += r.truth == Category::outside;
    EXPECT_EQ(program.solve_linear().is_infeasible(), r.truth == Category::outside);
  });
  EXPECT_GE(outside, 60);
}

/// lo_k <= n_k.x <= hi_k with x = sum lambda v, each bound an equation with a slack variable.
TEST(VolumePrograms, SlabSets) {
  int outside = 0;
  for_cases<fuzz::ShaftSlabsQuestion>(40, [&](const scene::ShaftSlabsCase& c) {
    HullProgram program(c.a, c.b);
    for (int k = 0; k < 3; ++k) {  // x
      (*program).set_l(16 + k, false);
      (*program).set_a(16 + k, k, -1);
    }
    for (int k = 0; k < 7; ++k) {
      const auto slab = static_cast<std::size_t>(k);
      for (const int sign : {1, -1}) {
        const int row = 4 + 2 * k + (sign > 0 ? 0 : 1);
        for (int j = 0; j < 3; ++j) {
          (*program).set_a(16 + j, row, sign * scene::kSlabNormals[slab][static_cast<std::size_t>(j)]);
        }
        (*program).set_a(15 + row, row, 1);
        (*program).set_b(row, sign > 0 ? c.t.hi[slab] : -c.t.lo[slab]);
      }
    }
    const exact::VolumeReference r = reference_of(c);
    outside += r.truth == Category::outside;
    EXPECT_EQ(program.solve_linear().is_infeasible(), r.truth == Category::outside);
  });
  EXPECT_GE(outside, 40);
}

}  // namespace
}  // namespace gnomon::tests
