// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/explain_pair.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "exact/blocked_range.h"
#include "exact/contact.h"
#include "exact/patch_pair.h"
#include "exact/shaft_ball.h"
#include "exact/shaft_candidates.h"
#include "exact/side_of_face.h"
#include "fuzz/replay.h"
#include "scene/float_text.h"
#include "scene/pair_case.h"

namespace gnomon::reports {

namespace {

using scene::decimal_text;
using scene::hex_text;
using Point = std::array<double, 3>;

std::string point_text(const Point& p, std::string (*text)(double)) {
  return "(" + text(p[0]) + ", " + text(p[1]) + ", " + text(p[2]) + ")";
}

std::string point_line(const Point& p) {
  return fmt::format("    {}  hex {}\n", point_text(p, decimal_text), point_text(p, hex_text));
}

std::string box_text(const char* name, const scene::Box<double>& box) {
  const Point lo{box.lo(0), box.lo(1), box.lo(2)}, hi{box.hi(0), box.hi(1), box.hi(2)};
  return fmt::format("  box {}, from and to\n", name) + point_line(lo) + point_line(hi);
}

std::string face_text(const scene::Scene& scene, std::uint32_t face) {
  if (face < scene.triangles.size()) {
    return point_line(scene.corner(face, 0)) + point_line(scene.corner(face, 1)) +
           point_line(scene.corner(face, 2));
  }
  const scene::Ball<double>& ball = scene.balls[face - scene.triangles.size()];
  return fmt::format("    centre {}  radius {}\n       hex {}  {}\n", point_text(ball.centre, decimal_text),
                     decimal_text(ball.radius), point_text(ball.centre, hex_text), hex_text(ball.radius));
}

std::string name_of_face(const scene::Scene& scene, std::uint32_t face, std::size_t on_line) {
  return fmt::format("{} {}", face < scene.triangles.size() ? "triangle" : "ball", on_line);
}

std::string range_text(const exact::BlockedRange& range) {
  if (range.least == range.greatest) {
    return fmt::format("s = {} (about {}) alone", range.least.get_str(), decimal_text(range.least.get_d()));
  }
  return fmt::format("s from {} to {} (about {} to {})", range.least.get_str(), range.greatest.get_str(),
                     decimal_text(range.least.get_d()), decimal_text(range.greatest.get_d()));
}

std::string head_of(const scene::CorpusLine& line) {
  return fmt::format("{}:{}: {}\n", line.file, line.line, line.question);
}

std::string methods_text(const scene::CorpusLine& line) {
  std::string text = "\nThe methods say:\n";
  for (const fuzz::ReplayLine& by : fuzz::replay({line}, {}).lines) {
    text += fmt::format("  {:<25} {:<10} {}\n", by.method, by.answer, by.verdict);
  }
  return text;
}

std::string meeting_text(const scene::CandidatesCase& c, std::uint32_t face) {
  if (face < c.scene.triangles.size()) {
    const std::optional<exact::BlockedRange> range = exact::blocked_range(c.scene, face, c.a, c.b);
    if (!range) return " has no point in common with the shaft: it blocks nothing\n";
    return " meets the shaft: the box (1-s)A + sB at " + range_text(*range) + "\n";
  }
  const scene::ShaftBallCase ball{c.a, c.b, c.scene.balls[face - c.scene.triangles.size()]};
  const exact::Gap gap = exact::gap(ball, exact::Boundary::outside);
  return fmt::format("{}\n    squared distance to the shaft less squared radius: {}\n",
                     exact::meets(ball) ? gap == 0 ? " meets the shaft: it touches it" : " meets the shaft"
                                        : " has no point in common with the shaft: it blocks nothing",
                     gap.get_str());
}

/// Where all of a face lies to the plane of a patch.
std::string side_text(const scene::Scene& scene, std::uint32_t face, const scene::Patch& patch) {
  if (exact::is_degenerate(patch.corners)) return "no plane there";
  std::array<bool, 3> on{};
  if (face >= scene.triangles.size()) {
    const int side = exact::side_of_face(patch.corners, scene.balls[face - scene.triangles.size()].centre);
    return side > 0 ? "its centre in front" : side < 0 ? "its centre behind" : "its centre in the plane";
  }
  for (std::size_t k = 0; k < 3; ++k) {
    on[static_cast<std::size_t>(exact::side_of_face(patch.corners, scene.corner(face, k)) + 1)] = true;
  }
  if (on[0] && on[2]) return "on both sides";
  if (!on[1]) return on[2] ? "in front" : "behind";
  return on[2] ? "in front, touching the plane" : on[0] ? "behind, touching the plane" : "in the plane";
}

std::string blocking_text(const scene::PairCase& c, std::uint32_t face) {
  if (face == c.pair.a.face || face == c.pair.b.face) return " is a patch's own face: it does not count\n";
  std::string text;
  if (!exact::can_block(c.scene, face, c.pair)) {
    text = " meets no open segment between the patches\n";
  } else {
    int met = 0;
    for (const Point& p : c.pair.a.corners) {
      for (const Point& q : c.pair.b.corners) {
        met += exact::contact(c.scene, face, scene::ShadowQuery{p, q}).meets();
      }
    }
    text = " blocks";
    if (face < c.scene.triangles.size()) {
      text += " at " + range_text(*exact::blocked_range(c.scene, face, c.pair));
    }
    text += fmt::format(": it meets {} of the nine open segments between corners\n", met);
    if (exact::hides(c.scene, face, c.pair)) {
      text += "    and lies strictly between the patches' planes: it hides each patch from the other\n";
    }
  }
  return text + fmt::format("    seen from a: {}; seen from b: {}\n", side_text(c.scene, face, c.pair.a),
                            side_text(c.scene, face, c.pair.b));
}

std::string patch_text(const char* name, const scene::PairCase& c, const scene::Patch& patch) {
  std::string text = fmt::format("  patch {}", name);
  for (std::size_t face = 0; face < c.number.size(); ++face) {
    if (c.number[face] == patch.face) text += fmt::format(" (face {})", face);
  }
  text += exact::is_degenerate(patch.corners) ? ", degenerate\n" : "\n";
  for (const Point& p : patch.corners) text += point_line(p);
  return text;
}

std::string answer_words(scene::PairVisibility visibility) {
  switch (visibility) {
    case scene::PairVisibility::all:
      return "no face but their own meets an open segment between the patches: all";
    case scene::PairVisibility::none:
      return "one face hides each patch from the other: none";
    case scene::PairVisibility::part:
      return "some face blocks, and none hides all alone: part";
  }
  return {};
}

}  // namespace

std::string explain_candidates(const scene::CorpusLine& line) {
  const std::string methods = methods_text(line);
  const scene::CandidatesCase c = scene::read_candidates_case(line);
  std::string text = head_of(line) + box_text("A", c.a) + box_text("B", c.b), meetings;
  for (std::size_t face = 0; face < c.number.size(); ++face) {
    const std::string name = "  " + name_of_face(c.scene, c.number[face], face);
    text += name + "\n" + face_text(c.scene, c.number[face]);
    meetings += name + meeting_text(c, c.number[face]);
  }
  const std::vector<std::uint32_t> truth = exact::shaft_candidates_by_all_faces(c.scene, c.a, c.b);
  return text +
         fmt::format("\nExactly: {} of {} faces meet the shaft: {}\n", truth.size(), c.number.size(),
                     scene::candidates_text(truth, c.number)) +
         meetings + methods;
}

std::string explain_pair(const scene::CorpusLine& line) {
  const std::string methods = methods_text(line);
  const scene::PairCase c = scene::read_pair_case(line);
  std::string text = head_of(line) + patch_text("a", c, c.pair.a) + patch_text("b", c, c.pair.b), blocking;
  for (std::size_t face = 0; face < c.number.size(); ++face) {
    const std::string name = "  " + name_of_face(c.scene, c.number[face], face);
    text += name + "\n" + face_text(c.scene, c.number[face]);
    blocking += name + blocking_text(c, c.number[face]);
  }
  return text + "\nExactly: " + answer_words(exact::patch_pair_by_all_faces(c.scene, c.pair)) + "\n" +
         blocking + methods;
}

}  // namespace gnomon::reports
