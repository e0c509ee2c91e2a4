// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/volume_questions.h"

#include <algorithm>
#include <cmath>

#include "scene/scalar.h"

namespace gnomon::fuzz {

using scene::ShaftEllipsoidCase;
using scene::ShaftOrientedBoxCase;
using scene::ShaftSlabsCase;

namespace {

template <class Case>
std::vector<double> all_numbers(Case c) {
  std::vector<double> all;
  for_each_number(c, [&](double x) { all.push_back(x); });
  return all;
}

template <class Case>
Case from_numbers(std::span<const double> numbers) {
  Case c;
  std::size_t i = 0;
  for_each_number(c, [&](double& x) { x = numbers[i++]; });
  return c;
}

template <class Case>
bool all_floats(Case c) {
  bool all = true;
  for_each_number(c, [&](double x) { all = all && scene::is_float(x); });
  return all;
}

template <class Case>
double largest(Case c) {
  double most = 0;
  for_each_number(c, [&](double x) { most = std::max(most, std::fabs(x)); });
  return most;
}

template <class Case>
std::optional<std::string_view> objection_to_boxes(const Case& c) {
  if (!is_valid(c.a)) return "a box A with finite lo <= hi on each axis";
  if (!is_valid(c.b)) return "a box B with finite lo <= hi on each axis";
  return std::nullopt;
}

}  // namespace

template <>
ShaftSlabsCase case_of(std::span<const double> numbers) {
  return from_numbers<ShaftSlabsCase>(numbers);
}
template <>
ShaftOrientedBoxCase case_of(std::span<const double> numbers) {
  return from_numbers<ShaftOrientedBoxCase>(numbers);
}
template <>
ShaftEllipsoidCase case_of(std::span<const double> numbers) {
  return from_numbers<ShaftEllipsoidCase>(numbers);
}

std::vector<double> numbers_of(const ShaftSlabsCase& c) {
  return all_numbers(c);
}
std::vector<double> numbers_of(const ShaftOrientedBoxCase& c) {
  return all_numbers(c);
}
std::vector<double> numbers_of(const ShaftEllipsoidCase& c) {
  return all_numbers(c);
}

std::optional<std::string_view> objection(const ShaftSlabsCase& c) {
  if (const auto to_boxes = objection_to_boxes(c)) return to_boxes;
  if (!is_valid(c.t)) return "a slab set with finite lo <= hi in each of the seven slabs";
  if (exact::is_empty(c.t)) return "a slab set with a point in all seven slabs";
  return std::nullopt;
}
std::optional<std::string_view> objection(const ShaftOrientedBoxCase& c) {
  if (const auto to_boxes = objection_to_boxes(c)) return to_boxes;
  if (!is_valid(c.t)) return "an oriented box of finite numbers";
  return std::nullopt;
}
std::optional<std::string_view> objection(const ShaftEllipsoidCase& c) {
  if (const auto to_boxes = objection_to_boxes(c)) return to_boxes;
  if (!is_valid(c.t)) return "an ellipsoid of finite numbers";
  return std::nullopt;
}

bool is_single(const ShaftSlabsCase& c) {
  return all_floats(c);
}
bool is_single(const ShaftOrientedBoxCase& c) {
  return all_floats(c);
}
bool is_single(const ShaftEllipsoidCase& c) {
  return all_floats(c);
}

double largest_number(const ShaftSlabsCase& c) {
  return largest(c);
}
double largest_number(const ShaftOrientedBoxCase& c) {
  return largest(c);
}
double largest_number(const ShaftEllipsoidCase& c) {
  return largest(c);
}

double gap_length(const ShaftSlabsCase&, const exact::Gap& gap, exact::Boundary) {
  return gap.get_d();
}
double gap_length(const ShaftOrientedBoxCase&, const exact::Gap& gap, exact::Boundary) {
  return gap.get_d();
}
double gap_length(const ShaftEllipsoidCase& c, const exact::Gap& gap, exact::Boundary) {
  double longest = 0;
  for (const std::array<double, 3>& axis : c.t.axes) {
    longest = std::max(longest, std::hypot(axis[0], axis[1], axis[2]));
  }
  return gap.get_d() * longest;
}

}  // namespace gnomon::fuzz
