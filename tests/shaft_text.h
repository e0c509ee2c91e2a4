// SPDX-License-Identifier: GPL-3.0-or-later
// Shaft cases as lines of the text corpus, so that a failing test prints what `gnomon replay` reads.
#pragma once

#include <cstdio>
#include <ostream>
#include <string>

#include "scene/category.h"
#include "scene/shaft_case.h"

namespace gnomon::tests {

inline std::string hex_text(double value) {
  char text[40];
  std::snprintf(text, sizeof text, " %a", value);
  return text;
}

template <class F>
std::string text_of(const scene::Box<F>& box) {
  std::string text;
  for (const F x : box.c) text += hex_text(static_cast<double>(x));
  return text;
}

template <class F>
std::string text_of(const scene::ShaftBoxCaseOf<F>& c) {
  return "shaft-box" + text_of(c.a) + text_of(c.b) + text_of(c.t);
}

template <class F>
std::string text_of(const scene::ShaftBallCaseOf<F>& c) {
  std::string text = "shaft-sphere" + text_of(c.a) + text_of(c.b);
  for (const F x : c.t.centre) text += hex_text(static_cast<double>(x));
  return text + hex_text(static_cast<double>(c.t.radius));
}

template <class F>
scene::Box<double> as_double(const scene::Box<F>& box) {
  scene::Box<double> wide;
  for (std::size_t i = 0; i < 6; ++i) wide.c[i] = static_cast<double>(box.c[i]);
  return wide;
}

template <class F>
scene::ShaftBoxCase as_double(const scene::ShaftBoxCaseOf<F>& c) {
  return {as_double(c.a), as_double(c.b), as_double(c.t)};
}

template <class F>
scene::ShaftBallCase as_double(const scene::ShaftBallCaseOf<F>& c) {
  scene::ShaftBallCase wide{as_double(c.a), as_double(c.b), {}};
  for (std::size_t i = 0; i < 3; ++i) wide.t.centre[i] = static_cast<double>(c.t.centre[i]);
  wide.t.radius = static_cast<double>(c.t.radius);
  return wide;
}

}  // namespace gnomon::tests

namespace gnomon::scene {

// Found by argument-dependent lookup where GoogleTest and RapidCheck print values.
inline void PrintTo(Category category, std::ostream* out) {
  *out << name_of(category);
}
inline std::ostream& operator<<(std::ostream& out, Category category) {
  return out << name_of(category);
}

}  // namespace gnomon::scene
