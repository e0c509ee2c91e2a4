// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/shaft_case.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/scalar.h"

namespace gnomon::reports {
namespace {

template <class F>
double step_once(double x, bool up) {
  constexpr F kMost = std::numeric_limits<F>::max();
  return static_cast<double>(std::nextafter(static_cast<F>(x), up ? kMost : -kMost));
}

scene::Box<double> box_at(std::span<const double> numbers) {
  scene::Box<double> box;
  std::copy_n(numbers.begin(), 6, box.c.begin());
  return box;
}

}  // namespace

double neighbour(double x, int step, bool single) {
  for (int i = 0; i < std::abs(step); ++i)
    x = single ? step_once<float>(x, step > 0) : step_once<double>(x, step > 0);
  return x;
}

double ShaftCase::ulp() const {
  double most = 0;
  const auto hold = [&](double x) { most = std::max(most, std::abs(x)); };
  for (const double x : a.c) hold(x);
  for (const double x : b.c) hold(x);
  if (box) std::for_each(box->c.begin(), box->c.end(), hold);
  if (ball) std::for_each(ball->centre.begin(), ball->centre.end(), hold), hold(ball->radius);
  const double below = neighbour(most, -1, single), above = neighbour(most, 1, single);
  if (above > most) return above - most;
  return most > below ? most - below : std::numeric_limits<double>::denorm_min();
}

std::optional<ShaftCase> shaft_case(std::string_view question, std::span<const double> numbers,
                                    std::string_view scalar) {
  const bool is_ball = question == "shaft-sphere";
  if ((!is_ball && question != "shaft-box") || numbers.size() != (is_ball ? 16U : 18U)) return std::nullopt;
  ShaftCase shaft;
  shaft.a = box_at(numbers);
  shaft.b = box_at(numbers.subspan(6));
  shaft.single = scalar == "f32" && std::all_of(numbers.begin(), numbers.end(), scene::is_float);
  bool valid = scene::is_valid(shaft.a) && scene::is_valid(shaft.b);
  if (is_ball) {
    shaft.ball = scene::Ball<double>{{numbers[12], numbers[13], numbers[14]}, numbers[15]};
    valid = valid && scene::is_valid(*shaft.ball);
  } else {
    shaft.box = box_at(numbers.subspan(12));
    valid = valid && scene::is_valid(*shaft.box);
  }
  if (!valid) return std::nullopt;
  return shaft;
}

}  // namespace gnomon::reports
