// SPDX-License-Identifier: MIT
#include "scene/shadow_case.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "scene/float_text.h"
#include "scene/line_reader.h"
#include "scene/parse_number.h"
#include "scene/scene_builder.h"

namespace gnomon::scene {

namespace {

using Point = std::array<double, 3>;

/// Walks over the words of a line.
class Words {
 public:
  explicit Words(const CorpusLine& line) : line_(line) {}

  /// The next word; says what is missing when there is none.
  const std::string& next(std::string_view expected) {
    if (at_ == line_.words.size()) line_.fail(expected, "the end of the line");
    return line_.words[at_++];
  }
  [[nodiscard]] bool done() const { return at_ == line_.words.size(); }

  double number(std::string_view what) {
    const std::string& word = next(what);
    const std::optional<double> value = parse_float_text(word);
    if (!value) line_.fail(what, in_quotes(word));
    if (!std::isfinite(*value)) line_.fail("a number within the range of a double", in_quotes(word));
    return *value;
  }
  Point point(std::string_view what) {
    const double x = number(what), y = number(what), z = number(what);
    return {x, y, z};
  }
  /// A whole number from least to most.
  std::int64_t whole(std::string_view what, std::int64_t least, std::int64_t most) {
    const std::string& word = next(what);
    const std::optional<std::int64_t> value = parse_integer(word);
    if (!value || *value < least || *value > most) line_.fail(what, in_quotes(word));
    return *value;
  }

 private:
  const CorpusLine& line_;
  std::size_t at_ = 0;
};

bool reaches_too_far(const Ball<double>& ball) {
  return std::ranges::any_of(ball.centre, [&](double c) {
    return !std::isfinite(c - ball.radius) || !std::isfinite(c + ball.radius);
  });
}

void add(std::string& text, const Point& p) {
  for (const double x : p) text += ' ' + hex_text(x);
}

}  // namespace

ShadowCase read_shadow_case(const CorpusLine& line) {
  Words words(line);
  ShadowCase c;
  c.query.point = words.point("three numbers for the point");
  c.query.light = words.point("three numbers for the light");
  const std::int64_t own = words.whole("the number of the point's face, or -1", -1, kNoFace - 1);
  const std::int64_t count = words.whole("how many faces there are", 0, kNoFace - 1);
  if (own >= count) {
    line.fail("the number of the point's face below " + std::to_string(count), std::to_string(own));
  }
  SceneBuilder builder;
  std::uint32_t triangles = 0, balls = 0;
  bool own_is_ball = false;
  std::uint32_t own_in_kind = 0;
  for (std::int64_t face = 0; face < count; ++face) {
    const std::string expected = "\"tri\" or \"ball\" for face " + std::to_string(face);
    const std::string& kind = words.next(expected);
    if (kind != "tri" && kind != "ball") line.fail(expected, in_quotes(kind));
    if (face == own) {
      own_is_ball = kind == "ball";
      own_in_kind = own_is_ball ? balls : triangles;
    }
    if (kind == "tri") {
      const char* const what = "nine numbers for a triangle";
      const Point a = words.point(what), b = words.point(what), d = words.point(what);
      builder.add_triangle(a, b, d);
      ++triangles;
      continue;
    }
    const Point centre = words.point("three numbers for a ball's centre");
    const Ball<double> ball{centre, words.number("a ball's radius")};
    if (ball.radius < 0) line.fail("a radius that is not negative", hex_text(ball.radius));
    if (reaches_too_far(ball)) line.fail("a ball within the range of a double", "one that reaches beyond it");
    builder.add_ball(ball);
    ++balls;
  }
  if (!words.done()) {
    line.fail("the end of the line after the last face", in_quotes(words.next("")));
  }
  c.scene = builder.finish();
  if (own >= 0) c.query.own = own_is_ball ? triangles + own_in_kind : own_in_kind;
  return c;
}

std::optional<Shadow> stated_shadow(const CorpusLine& line) {
  if (!line.answer) return std::nullopt;
  for (const Shadow shadow : {Shadow::lit, Shadow::shadowed, Shadow::facing}) {
    if (*line.answer == name_of(shadow)) return shadow;
  }
  line.fail("lit, shadowed or facing after \"->\"", in_quotes(*line.answer));
}

std::string corpus_text(const ShadowCase& c, std::string_view answer) {
  std::string text = "shadow";
  add(text, c.query.point);
  add(text, c.query.light);
  text += ' ' + (c.query.own == kNoFace ? "-1" : std::to_string(c.query.own));
  text += ' ' + std::to_string(c.scene.face_count());
  for (std::size_t t = 0; t < c.scene.triangles.size(); ++t) {
    text += " tri";
    for (std::size_t k = 0; k < 3; ++k) add(text, c.scene.corner(t, k));
  }
  for (const Ball<double>& ball : c.scene.balls) {
    text += " ball";
    add(text, ball.centre);
    text += ' ' + hex_text(ball.radius);
  }
  if (!answer.empty()) text += " -> " + std::string(answer);
  return text;
}

}  // namespace gnomon::scene
