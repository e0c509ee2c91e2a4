// SPDX-License-Identifier: MIT
#include "scene/pair_case.h"

#include <algorithm>
#include <array>

#include "scene/case_words.h"
#include "scene/float_text.h"
#include "scene/line_reader.h"
#include "scene/parse_number.h"

namespace gnomon::scene {

namespace {

Box<double> read_box(const CorpusLine& line, CaseWords& words, const std::string& name) {
  const std::array<double, 3> lo = words.point("six numbers for box " + name),
                              hi = words.point("six numbers for box " + name);
  const Box<double> box{{lo[0], lo[1], lo[2], hi[0], hi[1], hi[2]}};
  for (int axis = 0; axis < 3; ++axis) {
    if (box.lo(axis) <= box.hi(axis)) continue;
    line.fail("a box " + name + " with lo <= hi", hex_text(box.lo(axis)) + " > " + hex_text(box.hi(axis)));
  }
  return box;
}

/// A patch, whose face still has its number on the line.
Patch read_patch(CaseWords& words, const std::string& name) {
  Patch patch;
  for (auto& corner : patch.corners) corner = words.point("nine numbers for patch " + name);
  const std::int64_t own = words.whole("the number of patch " + name + "'s face, or -1", -1, kNoFace - 1);
  if (own >= 0) patch.face = static_cast<std::uint32_t>(own);
  return patch;
}

void add(std::string& text, const Box<double>& box) {
  for (const double x : box.c) text += ' ' + hex_text(x);
}

void add(std::string& text, const Patch& patch) {
  for (const auto& corner : patch.corners) add_words(text, corner);
  text += ' ' + (patch.face == kNoFace ? "-1" : std::to_string(patch.face));
}

std::string with_answer(std::string text, std::string_view answer) {
  if (!answer.empty()) text += " -> " + std::string(answer);
  return text;
}

}  // namespace

CandidatesCase read_candidates_case(const CorpusLine& line) {
  CaseWords words(line);
  CandidatesCase c;
  c.a = read_box(line, words, "A");
  c.b = read_box(line, words, "B");
  CaseFaces faces = words.faces(words.face_count());
  c.scene = std::move(faces.scene);
  c.number = std::move(faces.number);
  return c;
}

PairCase read_pair_case(const CorpusLine& line) {
  CaseWords words(line);
  PairCase c;
  c.pair.a = read_patch(words, "a");
  c.pair.b = read_patch(words, "b");
  const std::int64_t count = words.face_count();
  for (const Patch* patch : {&c.pair.a, &c.pair.b}) {
    if (patch->face == kNoFace || patch->face < count) continue;
    line.fail("the number of a patch's face below " + std::to_string(count), std::to_string(patch->face));
  }
  CaseFaces faces = words.faces(count);
  c.scene = std::move(faces.scene);
  c.number = std::move(faces.number);
  for (Patch* patch : {&c.pair.a, &c.pair.b}) {
    if (patch->face != kNoFace) patch->face = c.number[patch->face];
  }
  return c;
}

std::optional<std::vector<std::uint32_t>> stated_candidates(const CorpusLine& line, const CandidatesCase& c) {
  if (!line.answer) return std::nullopt;
  const std::string_view answer = *line.answer;
  const auto fail = [&] {
    line.fail("faces below " + std::to_string(c.number.size()) + " as {0 2 5} after \"->\", none twice",
              in_quotes(answer));
  };
  if (answer.size() < 2 || answer.front() != '{' || answer.back() != '}') fail();
  std::vector<std::uint32_t> faces;
  for (std::string_view rest = answer.substr(1, answer.size() - 2); !rest.empty();) {
    const std::size_t end = std::min(rest.find(' '), rest.size());
    const std::string_view word = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (word.empty()) continue;  // a space next to a brace
    const std::optional<std::int64_t> face = parse_integer(word);
    if (!face || *face < 0 || *face >= static_cast<std::int64_t>(c.number.size())) fail();
    faces.push_back(c.number[static_cast<std::size_t>(*face)]);
  }
  std::sort(faces.begin(), faces.end());
  if (std::adjacent_find(faces.begin(), faces.end()) != faces.end()) fail();
  return faces;
}

std::string candidates_text(std::span<const std::uint32_t> faces, std::span<const std::uint32_t> number) {
  std::string text = "{";
  for (std::size_t face = 0; face < number.size(); ++face) {
    if (std::find(faces.begin(), faces.end(), number[face]) == faces.end()) continue;
    text += (text.size() == 1 ? "" : " ") + std::to_string(face);
  }
  return text + '}';
}

std::optional<PairVisibility> stated_visibility(const CorpusLine& line) {
  if (!line.answer) return std::nullopt;
  for (const PairVisibility v : {PairVisibility::all, PairVisibility::none, PairVisibility::part}) {
    if (*line.answer == name_of(v)) return v;
  }
  line.fail("all, none or part after \"->\"", in_quotes(*line.answer));
}

std::string corpus_text(const CandidatesCase& c, std::string_view answer) {
  std::string text = "shaft-candidates";
  add(text, c.a);
  add(text, c.b);
  add_words(text, c.scene);
  return with_answer(std::move(text), answer);
}

std::string corpus_text(const PairCase& c, std::string_view answer) {
  std::string text = "patch-pair";
  add(text, c.pair.a);
  add(text, c.pair.b);
  add_words(text, c.scene);
  return with_answer(std::move(text), answer);
}

}  // namespace gnomon::scene
