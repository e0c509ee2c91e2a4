// SPDX-License-Identifier: GPL-3.0-or-later
// The shaft questions as linear and quadratic programs over the sixteen corners of the hull, solved exactly
// by CGAL's solver. The solver is known to hang or to give failing certificates with its default pricing:
// every program runs with QP_PARTIAL_DANTZIG and every certificate is checked.
#pragma once

#include <CGAL/Gmpzf.h>
#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>

#include <array>
#include <optional>
#include <stdexcept>
#include <vector>

#include "scene/shaft_case.h"
#include "tests/shaft_rational_reference.h"

namespace gnomon::tests {

using ExactNumber = CGAL::Gmpzf;
using Program = CGAL::Quadratic_program<double>;
using Solution = CGAL::Quadratic_program_solution<ExactNumber>;

/// x = sum lambda_k v_k with lambda >= 0, sum lambda = 1 in the variables 0..15; further ones are the
/// caller's. All inputs stay the doubles that they are.
class HullProgram {
 public:
  HullProgram(const scene::Box<double>& a, const scene::Box<double>& b)
      : program_(CGAL::EQUAL, true, 0, false, 0) {
    int k = 0;
    for (const scene::Box<double>* box : {&a, &b}) {
      for (int corner = 0; corner < 8; ++corner, ++k) {
        for (int axis = 0; axis < 3; ++axis)
          program_.set_a(k, axis, corner >> axis & 1 ? box->hi(axis) : box->lo(axis));
        program_.set_a(k, 3, 1);
      }
    }
    program_.set_b(3, 1);
  }

  Program& operator*() { return program_; }

  /// Subtracts a combination of the corners of `t`, by the variables 16..23: a point common to the hull and
  /// to t. (Variables with upper bounds would be fewer, and the solver's certificates fail on some of those.)
  void subtract_point_of(const scene::Box<double>& t) {
    for (int corner = 0; corner < 8; ++corner) {
      for (int axis = 0; axis < 3; ++axis)
        program_.set_a(16 + corner, axis, corner >> axis & 1 ? -t.hi(axis) : -t.lo(axis));
      program_.set_a(16 + corner, 4, 1);
    }
    program_.set_b(4, 1);
  }

  [[nodiscard]] Solution solve_linear() const {
    Solution solution = CGAL::solve_linear_program(program_, ExactNumber(), options());
    if (!solution.solves_linear_program(program_)) throw std::runtime_error("LP certificate fails");
    return solution;
  }
  [[nodiscard]] Solution solve_quadratic() const {
    Solution solution = CGAL::solve_quadratic_program(program_, ExactNumber(), options());
    if (!solution.solves_quadratic_program(program_)) throw std::runtime_error("QP certificate fails");
    return solution;
  }

 private:
  static CGAL::Quadratic_program_options options() {
    CGAL::Quadratic_program_options options;
    options.set_pricing_strategy(CGAL::QP_PARTIAL_DANTZIG);
    return options;
  }

  Program program_;
};

/// The boxes' difference S - T and the origin: empty when 0 is outside, else whether 0 is in its interior,
/// which is so when it can be left in all six axis directions.
inline std::optional<bool> origin_is_interior(const scene::ShaftBoxCase& c) {
  for (int direction = 0; direction < 6; ++direction) {
    HullProgram lp(c.a, c.b);
    lp.subtract_point_of(c.t);
    (*lp).set_a(24, direction % 3, direction < 3 ? -1 : 1);
    (*lp).set_c(24, -1);  // the way to go, as large as can be
    const Solution solution = lp.solve_linear();
    if (solution.is_infeasible()) return std::nullopt;
    if (!CGAL::is_negative(solution.objective_value())) return false;
  }
  return true;
}

/// `shaft-box` by linear programs.
inline ReferenceAnswer refer_by_programs(const scene::ShaftBoxCase& c) {
  const std::optional<bool> interior = origin_is_interior(c);
  if (!interior) return {scene::Category::outside, false, false};
  bool within = true, flush = false;
  for (int corner = 0; corner < 8 && within; ++corner) {
    scene::Box<double> point;
    bool repeated = false;
    for (int axis = 0; axis < 3; ++axis) {
      const bool high = corner >> axis & 1;
      repeated |= high && c.t.lo(axis) == c.t.hi(axis);
      point.lo(axis) = point.hi(axis) = high ? c.t.hi(axis) : c.t.lo(axis);
    }
    if (repeated) continue;
    if (flush) {  // touching is known: membership is all that is left to ask
      HullProgram lp(c.a, c.b);
      lp.subtract_point_of(point);
      within &= !lp.solve_linear().is_infeasible();
      continue;
    }
    const std::optional<bool> corner_interior = origin_is_interior({c.a, c.b, point});
    within &= corner_interior.has_value();
    flush |= corner_interior.has_value() && !*corner_interior;
  }
  return {within ? scene::Category::inside : scene::Category::overlap, !*interior, within && flush};
}

/// The sign of d^2 - r^2 by the quadratic program min |y|^2, y = sum lambda v - c.
inline int distance_sign_by_program(const scene::ShaftBallCase& c) {
  HullProgram qp(c.a, c.b);
  for (int axis = 0; axis < 3; ++axis) {
    (*qp).set_a(16 + axis, axis, -1);
    (*qp).set_l(16 + axis, false);
    (*qp).set_b(axis, c.t.centre[static_cast<std::size_t>(axis)]);
    (*qp).set_d(16 + axis, 16 + axis, 2);
  }
  const CGAL::Quotient<ExactNumber> square = qp.solve_quadratic().objective_value();
  const ExactNumber r(c.t.radius);
  return static_cast<int>(CGAL::compare(square, CGAL::Quotient<ExactNumber>(r * r)));
}

}  // namespace gnomon::tests
