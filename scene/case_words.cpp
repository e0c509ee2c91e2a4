// SPDX-License-Identifier: MIT
#include "scene/case_words.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "scene/float_text.h"
#include "scene/line_reader.h"
#include "scene/parse_number.h"
#include "scene/scene_builder.h"
#include "scene/shadow_query.h"

namespace gnomon::scene {

namespace {

bool reaches_too_far(const Ball<double>& ball) {
  return std::ranges::any_of(ball.centre, [&](double c) {
    return !std::isfinite(c - ball.radius) || !std::isfinite(c + ball.radius);
  });
}

}  // namespace

const std::string& CaseWords::next(std::string_view expected) {
  if (at_ == line_.words.size()) line_.fail(expected, "the end of the line");
  return line_.words[at_++];
}

double CaseWords::number(std::string_view what) {
  const std::string& word = next(what);
  const std::optional<double> value = parse_float_text(word);
  if (!value) line_.fail(what, in_quotes(word));
  if (!std::isfinite(*value)) line_.fail("a number within the range of a double", in_quotes(word));
  return *value;
}

std::array<double, 3> CaseWords::point(std::string_view what) {
  const double x = number(what), y = number(what), z = number(what);
  return {x, y, z};
}

std::int64_t CaseWords::whole(std::string_view what, std::int64_t least, std::int64_t most) {
  const std::string& word = next(what);
  const std::optional<std::int64_t> value = parse_integer(word);
  if (!value || *value < least || *value > most) line_.fail(what, in_quotes(word));
  return *value;
}

std::int64_t CaseWords::face_count() {
  return whole("how many faces there are", 0, kNoFace - 1);
}

CaseFaces CaseWords::faces(std::int64_t count) {
  CaseFaces result;
  SceneBuilder builder;
  std::uint32_t triangles = 0, balls = 0;
  std::vector<bool> is_ball;
  for (std::int64_t face = 0; face < count; ++face) {
    const std::string expected = "\"tri\" or \"ball\" for face " + std::to_string(face);
    const std::string& kind = next(expected);
    if (kind != "tri" && kind != "ball") line_.fail(expected, in_quotes(kind));
    is_ball.push_back(kind == "ball");
    if (kind == "tri") {
      const char* const what = "nine numbers for a triangle";
      const std::array<double, 3> a = point(what), b = point(what), c = point(what);
      builder.add_triangle(a, b, c);
      ++triangles;
      continue;
    }
    const std::array<double, 3> centre = point("three numbers for a ball's centre");
    const Ball<double> ball{centre, number("a ball's radius")};
    if (ball.radius < 0) line_.fail("a radius that is not negative", hex_text(ball.radius));
    if (reaches_too_far(ball)) {
      line_.fail("a ball within the range of a double", "one that reaches beyond it");
    }
    builder.add_ball(ball);
  }
  if (at_ < line_.words.size()) {
    line_.fail("the end of the line after the last face", in_quotes(line_.words[at_]));
  }
  result.scene = builder.finish();
  std::uint32_t triangle = 0;
  for (const bool ball : is_ball) result.number.push_back(ball ? triangles + balls++ : triangle++);
  return result;
}

void add_words(std::string& text, const std::array<double, 3>& p) {
  for (const double x : p) text += ' ' + hex_text(x);
}

void add_words(std::string& text, const Scene& scene) {
  text += ' ' + std::to_string(scene.face_count());
  for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
    text += " tri";
    for (std::size_t k = 0; k < 3; ++k) add_words(text, scene.corner(t, k));
  }
  for (const Ball<double>& ball : scene.balls) {
    text += " ball";
    add_words(text, ball.centre);
    text += ' ' + hex_text(ball.radius);
  }
}

}  // namespace gnomon::scene
