// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/shaft_questions.h"

#include <algorithm>
#include <cmath>

namespace gnomon::fuzz {

using scene::Box;
using scene::Category;
using scene::ShaftBallCase;
using scene::ShaftBoxCase;

Verdict ShaftAnswers::judge(Category truth, Answer answer) {
  if (answer == kUndecided) return Verdict::undecided;
  if (answer == kRejected) return Verdict::rejected;
  if (answer == static_cast<Answer>(truth)) return Verdict::agree;
  return answer == static_cast<Answer>(Category::overlap) ? Verdict::waste : Verdict::unsound;
}

Fault ShaftAnswers::fault(Category truth, Answer answer) {
  if (answer == static_cast<Answer>(Category::outside)) return Fault::false_cull;
  if (answer == static_cast<Answer>(Category::inside)) return Fault::false_inside;
  return truth == Category::outside ? Fault::false_keep : Fault::missed_inside;
}

exact::Boundary ShaftAnswers::boundary(Fault fault) {
  return fault == Fault::false_cull || fault == Fault::false_keep ? exact::Boundary::outside
                                                                  : exact::Boundary::inside;
}

namespace {

template <class Numbers>
void append(std::vector<double>& all, const Numbers& numbers) {
  all.insert(all.end(), numbers.begin(), numbers.end());
}

Box<double> box_of(std::span<const double> numbers) {
  Box<double> box;
  std::copy_n(numbers.begin(), 6, box.c.begin());
  return box;
}

bool is_single(const Box<double>& box) {
  return std::all_of(box.c.begin(), box.c.end(), scene::is_float);
}

double largest(std::initializer_list<const Box<double>*> boxes) {
  double most = 0;
  for (const Box<double>* box : boxes) {
    for (const double x : box->c) most = std::max(most, std::fabs(x));
  }
  return most;
}

}  // namespace

std::vector<double> numbers_of(const ShaftBoxCase& c) {
  std::vector<double> all;
  append(all, c.a.c);
  append(all, c.b.c);
  append(all, c.t.c);
  return all;
}

std::vector<double> numbers_of(const ShaftBallCase& c) {
  std::vector<double> all;
  append(all, c.a.c);
  append(all, c.b.c);
  append(all, c.t.centre);
  all.push_back(c.t.radius);
  return all;
}

template <>
ShaftBoxCase case_of(std::span<const double> numbers) {
  return {box_of(numbers.subspan(0, 6)), box_of(numbers.subspan(6, 6)), box_of(numbers.subspan(12, 6))};
}

template <>
ShaftBallCase case_of(std::span<const double> numbers) {
  ShaftBallCase c{box_of(numbers.subspan(0, 6)), box_of(numbers.subspan(6, 6)), {}};
  std::copy_n(numbers.begin() + 12, 3, c.t.centre.begin());
  c.t.radius = numbers[15];
  return c;
}

std::optional<std::string_view> objection(const ShaftBoxCase& c) {
  if (!is_valid(c.a)) return "a box A with finite lo <= hi on each axis";
  if (!is_valid(c.b)) return "a box B with finite lo <= hi on each axis";
  if (!is_valid(c.t)) return "a box T with finite lo <= hi on each axis";
  return std::nullopt;
}

std::optional<std::string_view> objection(const ShaftBallCase& c) {
  if (!is_valid(c.a)) return "a box A with finite lo <= hi on each axis";
  if (!is_valid(c.b)) return "a box B with finite lo <= hi on each axis";
  if (!is_valid(c.t)) return "a ball with finite centre and radius >= 0";
  return std::nullopt;
}

bool is_single(const ShaftBoxCase& c) {
  return is_single(c.a) && is_single(c.b) && is_single(c.t);
}
bool is_single(const ShaftBallCase& c) {
  return is_single(c.a) && is_single(c.b) && scene::is_float(c.t.radius) &&
         std::all_of(c.t.centre.begin(), c.t.centre.end(), scene::is_float);
}

double largest_number(const ShaftBoxCase& c) {
  return largest({&c.a, &c.b, &c.t});
}

double largest_number(const ShaftBallCase& c) {
  double most = std::max(largest({&c.a, &c.b}), c.t.radius);
  for (const double x : c.t.centre) most = std::max(most, std::fabs(x));
  return most;
}

double gap_length(const ShaftBoxCase&, const exact::Gap& gap, exact::Boundary) {
  return gap.get_d();
}

double gap_length(const ShaftBallCase& c, const exact::Gap& gap, exact::Boundary boundary) {
  // In GMP's floats: the squares of doubles leave the range of doubles.
  constexpr unsigned kBits = 256;
  const mpf_class radius(c.t.radius, kBits);
  const mpf_class difference(gap, kBits);
  // The square of d or x, the centre's distance.
  const bool outside = boundary == exact::Boundary::outside;
  mpf_class square(radius * radius, kBits);
  square += outside ? difference : mpf_class(-difference, kBits);
  if (!outside && square < 0) return mpf_class(radius + sqrt(mpf_class(-square, kBits)), kBits).get_d();
  if (square < 0) square = 0;
  // The difference of two squares over their sum: no cancellation.
  const mpf_class sum(sqrt(square) + radius, kBits);
  return sum == 0 ? 0.0 : mpf_class(difference / sum, kBits).get_d();
}

}  // namespace gnomon::fuzz
