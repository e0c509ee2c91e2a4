// SPDX-License-Identifier: MIT
#include "scene/shadow_case.h"

#include "scene/case_words.h"
#include "scene/line_reader.h"

namespace gnomon::scene {

ShadowCase read_shadow_case(const CorpusLine& line) {
  CaseWords words(line);
  ShadowCase c;
  c.query.point = words.point("three numbers for the point");
  c.query.light = words.point("three numbers for the light");
  const std::int64_t own = words.whole("the number of the point's face, or -1", -1, kNoFace - 1);
  const std::int64_t count = words.face_count();
  if (own >= count) {
    line.fail("the number of the point's face below " + std::to_string(count), std::to_string(own));
  }
  CaseFaces faces = words.faces(count);
  c.scene = std::move(faces.scene);
  if (own >= 0) c.query.own = faces.number[static_cast<std::size_t>(own)];
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
  add_words(text, c.query.point);
  add_words(text, c.query.light);
  text += ' ' + (c.query.own == kNoFace ? "-1" : std::to_string(c.query.own));
  add_words(text, c.scene);
  if (!answer.empty()) text += " -> " + std::string(answer);
  return text;
}

}  // namespace gnomon::scene
