// SPDX-License-Identifier: GPL-3.0-or-later
// exact/shaft_candidates.h and exact/patch_pair.h, and the rational reference, against CGAL's exact linear
// and quadratic programming solver.
#include <gtest/gtest.h>

#include "exact/patch_pair.h"
#include "exact/shaft_candidates.h"
#include "tests/pair_by_definition.h"
#include "tests/pair_trials.h"
#include "tests/shaft_lp_reference.h"

namespace gnomon::tests {
namespace {

/// Subtracts a combination of a triangle's corners, by three variables from `first` on, whose sum is 1 by
/// row 4.
void subtract_triangle(Program& program, int first, const scene::Scene& scene, std::uint32_t face) {
  for (int k = 0; k < 3; ++k) {
    for (int axis = 0; axis < 3; ++axis) {
      program.set_a(first + k, axis,
                    -scene.corner(face, static_cast<std::size_t>(k))[static_cast<std::size_t>(axis)]);
    }
    program.set_a(first + k, 4, 1);
  }
  program.set_b(4, 1);
}

bool meets_shaft_by_program(const scene::Scene& scene, std::uint32_t face, const scene::Box<double>& a,
                            const scene::Box<double>& b) {
  if (face >= scene.triangles.size()) {
    return distance_sign_by_program({a, b, scene.balls[face - scene.triangles.size()]}) <= 0;
  }
  HullProgram lp(a, b);
  subtract_triangle(*lp, 16, scene, face);
  return !lp.solve_linear().is_infeasible();
}

CGAL::Quadratic_program_options partial_dantzig() {
  CGAL::Quadratic_program_options options;
  options.set_pricing_strategy(CGAL::QP_PARTIAL_DANTZIG);
  return options;
}

/// Means of the six corners of both patches, in the variables 0..5.
Program means_of(const scene::PatchPair& pair) {
  Program program(CGAL::EQUAL, true, 0, false, 0);
  int k = 0;
  for (const scene::Patch* patch : {&pair.a, &pair.b}) {
    for (const auto& corner : patch->corners) {
      for (int axis = 0; axis < 3; ++axis) program.set_a(k, axis, corner[static_cast<std::size_t>(axis)]);
      program.set_a(k++, 3, 1);
    }
  }
  program.set_b(3, 1);
  return program;
}

Between triangle_by_programs(const scene::Scene& scene, std::uint32_t face, const scene::PatchPair& pair) {
  for (const int patch : {0, 3}) {  // the greatest weight that this patch can have
    Program program = means_of(pair);
    subtract_triangle(program, 6, scene, face);
    for (int k = 0; k < 3; ++k) program.set_c(patch + k, -1);
    Solution solution = CGAL::solve_linear_program(program, ExactNumber(), partial_dantzig());
    if (!solution.solves_linear_program(program)) throw std::runtime_error("LP certificate fails");
    if (solution.is_infeasible()) return Between::apart;
    if (!CGAL::is_negative(solution.objective_value())) return Between::at_patches;
  }
  return Between::within;
}

/// The sign of d^2 - r^2, d the distance from the ball's centre to the hull of the patches.
int ball_sign_by_program(const scene::Ball<double>& ball, const scene::PatchPair& pair) {
  Program program = means_of(pair);
  for (int axis = 0; axis < 3; ++axis) {
    program.set_a(6 + axis, axis, -1);
    program.set_l(6 + axis, false);
    program.set_b(axis, ball.centre[static_cast<std::size_t>(axis)]);
    program.set_d(6 + axis, 6 + axis, 2);
  }
  Solution solution = CGAL::solve_quadratic_program(program, ExactNumber(), partial_dantzig());
  if (!solution.solves_quadratic_program(program)) throw std::runtime_error("QP certificate fails");
  const ExactNumber r(ball.radius);
  return static_cast<int>(CGAL::compare(solution.objective_value(), CGAL::Quotient<ExactNumber>(r * r)));
}

TEST(PairPrograms, AllReferencesAgree) {
  std::array<int, 3> seen{};
  std::array<int, 3> signs{};
  std::array<int, 2> met{};
  int faces = 0;
  const int wanted = reference_cases(1000);
  for (const Finish finish :
       {Finish::grid, Finish::grid, Finish::turned, Finish::stretched, Finish::denormal}) {
    PairTrials trials(900 + static_cast<std::uint64_t>(faces), finish);
    for (int i = 0; i < wanted / 25 && !HasFailure(); ++i) {
      const PairTrial trial = trials.next(5);
      for (std::uint32_t face = 0; face < trial.scene.face_count(); ++face, ++faces) {
        const bool meets = meets_shaft_by_program(trial.scene, face, trial.a, trial.b);
        EXPECT_EQ(exact::meets_shaft(trial.scene, face, trial.a, trial.b), meets) << text_of(trial);
        EXPECT_EQ(meets_shaft_by_definition(trial.scene, face, trial.a, trial.b), meets) << text_of(trial);
        ++met[meets];
        const bool blocks = exact::can_block(trial.scene, face, trial.pair);
        if (face < trial.scene.triangles.size()) {
          const Between between = triangle_by_programs(trial.scene, face, trial.pair);
          EXPECT_EQ(blocks, between == Between::within) << text_of(trial);
          EXPECT_EQ(face_between(trial.scene, face, trial.pair), between) << text_of(trial);
          ++seen[static_cast<std::size_t>(between)];
          continue;
        }
        const int sign =
            ball_sign_by_program(trial.scene.balls[face - trial.scene.triangles.size()], trial.pair);
        if (sign != 0) {
          EXPECT_EQ(blocks, sign < 0) << text_of(trial);
        }
        const Between between = face_between(trial.scene, face, trial.pair);
        EXPECT_EQ(between == Between::apart, sign > 0) << text_of(trial);
        ++signs[static_cast<std::size_t>(sign + 1)];
      }
    }
  }
  RecordProperty("faces", faces);
  for (const int count : seen) EXPECT_GE(count, faces / 50);
  for (const int count : signs) EXPECT_GE(count, faces / 200);
  for (const int count : met) EXPECT_GE(count, faces / 10);
}

}  // namespace
}  // namespace gnomon::tests
