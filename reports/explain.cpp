// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/explain.h"

#include <fmt/format.h>

#include <algorithm>

#include "fuzz/replay.h"
#include "fuzz/replay_pair.h"
#include "fuzz/shaft_questions.h"
#include "fuzz/volume_questions.h"
#include "reports/explain_pair.h"
#include "reports/explain_shadow.h"
#include "reports/picture.h"
#include "reports/text_picture.h"
#include "scene/float_text.h"

namespace gnomon::reports {

namespace {

using scene::decimal_text;
using scene::hex_text;

std::string numbers_text(std::span<const double> numbers, std::string (*text)(double)) {
  return "(" + text(numbers[0]) + ", " + text(numbers[1]) + ", " + text(numbers[2]) + ")";
}

std::string box_text(const char* name, std::span<const double> numbers) {
  return fmt::format("  {}  from {}  to {}\n     hex  {}  {}\n", name, numbers_text(numbers, decimal_text),
                     numbers_text(numbers.subspan(3), decimal_text), numbers_text(numbers, hex_text),
                     numbers_text(numbers.subspan(3), hex_text));
}

template <class Case>
std::string gap_text(const Case& c, exact::Boundary boundary, const char* what, const char* unit) {
  const exact::Gap gap = exact::gap(c, boundary);
  const double length = fuzz::gap_length(c, gap, boundary);
  const scene::Scalar scalar = fuzz::is_single(c) ? scene::Scalar::f32 : scene::Scalar::f64;
  const double ulp = scene::ulp_of(fuzz::largest_number(c), scalar);
  return fmt::format("  {}: {}{}\n     a length of {}, {:.4g} ulps of the largest coordinate\n", what,
                     gap.get_str(), unit, decimal_text(length), length / ulp);
}

std::string answer_words(scene::Category truth, const char* volume) {
  switch (truth) {
    case scene::Category::outside:
      return fmt::format("{} has no point in common with the shaft: outside", volume);
    case scene::Category::overlap:
      return fmt::format("{} meets the shaft and is not within it: overlap", volume);
    case scene::Category::inside:
      return fmt::format("{} lies within the shaft: inside", volume);
  }
  return {};
}

/// What `unit` says of the gap: of balls it is a squared length, of ellipsoids a pure number.
template <class Case, class Reference>
std::string truth_text(const Case& c, const char* volume, const char* unit) {
  Reference reference;
  exact::refer(std::span(&c, 1), std::span(&reference, 1));
  std::string text = "Exactly: " + answer_words(reference.truth, volume);
  if (reference.touches_outside) text += "; it touches: the least push makes it outside or lets it overlap";
  if (reference.touches_inside) text += "; it touches the shaft's boundary from within";
  text += "\n" + gap_text(c, exact::Boundary::outside, "gap to outside (positive: outside)", unit);
  return text + gap_text(c, exact::Boundary::inside, "gap to inside (positive: not inside)", unit);
}

bool is_box(const scene::CorpusLine& line) {
  return line.question == fuzz::ShaftBoxQuestion::id;
}

std::vector<double> numbers_of_line(const scene::CorpusLine& line) {
  std::optional<std::vector<double>> of_volume;
  fuzz::for_volume_question(line.question,
                            [&](auto question) { of_volume = line.numbers(question.number_count); });
  if (of_volume) return *of_volume;
  if (!is_box(line) && line.question != fuzz::ShaftBallQuestion::id) {
    line.fail(
        "a question (shaft-box, shaft-sphere, shaft-slabs, shaft-oriented-box, shaft-ellipsoid, shadow, "
        "shaft-candidates, patch-pair)",
        "\"" + line.question + "\"");
  }
  return line.numbers(is_box(line) ? fuzz::ShaftBoxQuestion::number_count
                                   : fuzz::ShaftBallQuestion::number_count);
}

std::string vectors_text(const char* name, const char* what, std::span<const double> numbers) {
  return fmt::format("  {}  {} {}\n     hex  {}\n", name, what, numbers_text(numbers, decimal_text),
                     numbers_text(numbers, hex_text));
}

/// A volume T of twelve numbers: its centre, then its axes.
std::string spanned_text(std::span<const double> numbers) {
  return vectors_text("T", "centre", numbers) + vectors_text(" ", "axis 1", numbers.subspan(3)) +
         vectors_text(" ", "axis 2", numbers.subspan(6)) + vectors_text(" ", "axis 3", numbers.subspan(9)) +
         "\n";
}

std::string slabs_text(std::span<const double> numbers) {
  constexpr std::array<const char*, 7> kNormals{"x",          "y",          "z",        "x + y + z",
                                                "-x + y + z", "-x - y + z", "x - y + z"};
  std::string text;
  for (std::size_t k = 0; k < 7; ++k) {
    text += fmt::format("  {}  {} <= {} <= {}\n     hex  {}  {}\n", k == 0 ? "T" : " ",
                        decimal_text(numbers[k]), kNormals[k], decimal_text(numbers[k + 7]),
                        hex_text(numbers[k]), hex_text(numbers[k + 7]));
  }
  return text + "\n";
}

/// T and the truth of a case of the other volumes.
std::string volume_text(const scene::CorpusLine& line, std::span<const double> all) {
  if (line.question == fuzz::ShaftSlabsQuestion::id) {
    const auto c = fuzz::case_of<scene::ShaftSlabsCase>(all);
    return slabs_text(all.subspan(12)) +
           truth_text<scene::ShaftSlabsCase, exact::VolumeReference>(c, "the slab set T", "");
  }
  if (line.question == fuzz::ShaftOrientedBoxQuestion::id) {
    const auto c = fuzz::case_of<scene::ShaftOrientedBoxCase>(all);
    return spanned_text(all.subspan(12)) +
           truth_text<scene::ShaftOrientedBoxCase, exact::VolumeReference>(c, "the oriented box T", "");
  }
  const auto c = fuzz::case_of<scene::ShaftEllipsoidCase>(all);
  return spanned_text(all.subspan(12)) + truth_text<scene::ShaftEllipsoidCase, exact::VolumeReference>(
                                             c, "the ellipsoid T", " (a number from -1 to 1)");
}

bool is_volume(const scene::CorpusLine& line) {
  return fuzz::for_volume_question(line.question, [](auto) {});
}

}  // namespace

std::string explain(const scene::CorpusLine& line, const fuzz::Plugins* plugins) {
  if (line.question == fuzz::kShadowQuestion) return explain_shadow(line);
  if (line.question == fuzz::kCandidatesQuestion) return explain_candidates(line);
  if (line.question == fuzz::kPairQuestion) return explain_pair(line);
  const std::vector<double> numbers = numbers_of_line(line);
  const std::span<const double> all(numbers);
  const fuzz::ReplayResult replayed = fuzz::replay({line}, {}, {plugins});  // also refuses what is no case
  const bool single = std::all_of(numbers.begin(), numbers.end(), scene::is_float);

  std::string text = fmt::format("{}:{}: {} ({})\n", line.file, line.line, line.question,
                                 single ? "all numbers are floats" : "double precision");
  text += box_text("A", all.first(6)) + box_text("B", all.subspan(6, 6));
  if (is_volume(line)) {
    text += volume_text(line, all);
  } else if (is_box(line)) {
    text += box_text("T", all.subspan(12, 6)) + "\n";
    const auto c = fuzz::case_of<scene::ShaftBoxCase>(all);
    text += truth_text<scene::ShaftBoxCase, exact::ShaftBoxReference>(c, "the box T", "");
  } else {
    text += fmt::format("  T  centre {}  radius {}\n     hex  {}  {}\n\n",
                        numbers_text(all.subspan(12), decimal_text), decimal_text(numbers[15]),
                        numbers_text(all.subspan(12), hex_text), hex_text(numbers[15]));
    const auto c = fuzz::case_of<scene::ShaftBallCase>(all);
    text +=
        truth_text<scene::ShaftBallCase, exact::ShaftBallReference>(c, "the ball T", " (a squared length)");
  }
  text += "\nThe methods say:\n";
  for (const fuzz::ReplayLine& by : replayed.lines) {
    text += fmt::format("  {:<19} {:<10}{}\n", by.method, by.answer, by.verdict);
  }
  for (const std::string& failure : replayed.failures) text += "  " + failure + "\n";
  if (is_volume(line)) text += "\nPictures are drawn of boxes and balls only.\n";
  if (const std::optional<ShaftCase> c = shaft_case(line.question, numbers, single ? "f32" : "f64")) {
    text += "\n" + text_picture(*c);
  }
  return text;
}

std::string explain_svg(const scene::CorpusLine& line) {
  if (is_volume(line)) line.fail("a box or a ball for a picture", "\"" + line.question + "\"");
  if (line.question == fuzz::kShadowQuestion || line.question == fuzz::kCandidatesQuestion ||
      line.question == fuzz::kPairQuestion) {
    line.fail("a shaft case for a picture", "\"" + line.question + "\"");
  }
  const std::vector<double> numbers = numbers_of_line(line);
  const bool single = std::all_of(numbers.begin(), numbers.end(), scene::is_float);
  return case_picture_svg(line.question, numbers, single ? "f32" : "f64");
}

}  // namespace gnomon::reports
