// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/explain_shadow.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "exact/border_contacts.h"
#include "exact/shadow.h"
#include "fuzz/replay.h"
#include "reports/peers/peers.h"
#include "reports/segment_contact.h"
#include "scene/float_text.h"
#include "scene/scalar.h"
#include "scene/shadow_case.h"

namespace gnomon::reports {

namespace {

using exact::Contact;
using exact::ContactKind;
using scene::decimal_text;
using scene::hex_text;
using scene::ShadowCase;
using Point = std::array<double, 3>;

constexpr std::uint32_t kShownAnyway = 12;

std::string point_text(const Point& p, std::string (*text)(double)) {
  return "(" + text(p[0]) + ", " + text(p[1]) + ", " + text(p[2]) + ")";
}

class Words {
 public:
  explicit Words(const ShadowCase& c) : case_(c), path_(c.query) {
    for (std::uint32_t face = 0; face < c.scene.face_count(); ++face) {
      contacts_.push_back(exact::contact(c.scene, face, c.query));
    }
  }

  [[nodiscard]] std::string numbers() const {
    std::string text = named("point", case_.query.point) + named("light", case_.query.light);
    std::size_t left_out = 0;
    for (std::uint32_t face = 0; face < contacts_.size(); ++face) {
      if (face >= kShownAnyway && contacts_[face].kind == ContactKind::none && face != case_.query.own) {
        ++left_out;
        continue;
      }
      text += "  " + name(face) + (face == case_.query.own ? " (the point's own face)\n" : "\n");
      if (is_ball(face)) {
        const scene::Ball<double>& ball = ball_of(face);
        text += fmt::format("    centre {}  radius {}\n       hex {}  {}\n",
                            point_text(ball.centre, decimal_text), decimal_text(ball.radius),
                            point_text(ball.centre, hex_text), hex_text(ball.radius));
        continue;
      }
      for (std::size_t k = 0; k < 3; ++k) {
        const Point corner = case_.scene.corner(face, k);
        text +=
            fmt::format("    {}  hex {}\n", point_text(corner, decimal_text), point_text(corner, hex_text));
      }
    }
    if (left_out > 0) text += fmt::format("  {} faces more, none of which is met\n", left_out);
    return text;
  }

  [[nodiscard]] std::string meetings() const {
    std::string text;
    for (std::uint32_t face = 0; face < contacts_.size(); ++face) text += meeting(face);
    if (text.empty())
      text = "  The closed segment has no point in common with any face that could block it.\n";
    return text;
  }

 private:
  [[nodiscard]] static std::string named(const char* what, const Point& p) {
    return fmt::format("  {}  {}\n    hex  {}\n", what, point_text(p, decimal_text), point_text(p, hex_text));
  }
  [[nodiscard]] bool is_ball(std::uint32_t face) const { return face >= case_.scene.triangles.size(); }
  [[nodiscard]] const scene::Ball<double>& ball_of(std::uint32_t face) const {
    return case_.scene.balls[face - case_.scene.triangles.size()];
  }
  [[nodiscard]] std::string name(std::uint32_t face) const {
    return is_ball(face) ? fmt::format("ball {}", face - case_.scene.triangles.size())
                         : fmt::format("triangle {}", face);
  }

  /// The indices that a contact on a border is on: of a vertex (twice), or of an edge, the least first.
  [[nodiscard]] std::array<std::uint32_t, 2> border(std::uint32_t triangle) const {
    const auto& corners = case_.scene.triangles[triangle];
    const std::size_t k = contacts_[triangle].corner;
    if (contacts_[triangle].kind == ContactKind::on_vertex) return {corners[k], corners[k]};
    const std::uint32_t a = corners[(k + 1) % 3], b = corners[(k + 2) % 3];
    return {std::min(a, b), std::max(a, b)};
  }

  [[nodiscard]] bool on_border(std::uint32_t face) const {
    return contacts_[face].kind == ContactKind::on_edge || contacts_[face].kind == ContactKind::on_vertex;
  }

  [[nodiscard]] bool is_sealed(std::uint32_t triangle) const {
    exact::BorderContacts same(case_.scene, path_);
    for (std::uint32_t face = 0; face < contacts_.size(); ++face) {
      if (on_border(face) && contacts_[face].kind == contacts_[triangle].kind &&
          border(face) == border(triangle)) {
        same.add(face, contacts_[face]);
      }
    }
    return same.any_sealed();
  }

  [[nodiscard]] std::string at(const mpq_class& t) const {
    Point place;
    for (std::size_t i = 0; i < 3; ++i) {
      const mpq_class from(case_.query.point[i]);
      place[i] = mpq_class(from + t * (mpq_class(case_.query.light[i]) - from)).get_d();
    }
    return fmt::format("    at t = {}\n      about {}, {}\n", t.get_str(), decimal_text(t.get_d()),
                       point_text(place, decimal_text));
  }

  [[nodiscard]] std::string meeting(std::uint32_t face) const {
    const ContactKind kind = contacts_[face].kind;
    if (kind == ContactKind::none) return {};
    return is_ball(face) ? ball_meeting(face, kind) : triangle_meeting(face, kind);
  }

  [[nodiscard]] std::string ball_meeting(std::uint32_t face, ContactKind kind) const {
    if (face == case_.query.own) {
      return "  " + name(face) +
             (kind == ContactKind::at_end
                  ? ", its own, does not block: the path leaves along its tangent plane\n"
                  : ", its own, blocks: the path leads into it\n");
    }
    const char* const what = kind == ContactKind::at_end ? " holds an end of the segment, and does not block"
                             : kind == ContactKind::grazing ? " blocks: touched, the path is tangent to it"
                                                            : " blocks: the path goes through it";
    const NearestToCentre nearest = nearest_to_centre(ball_of(face), case_.query);
    return "  " + name(face) + what + "\n    nearest to its centre" + at(nearest.parameter).substr(3) +
           "      squared distance less squared radius: " + nearest.squared_gap.get_str() + "\n";
  }

  [[nodiscard]] std::string triangle_meeting(std::uint32_t face, ContactKind kind) const {
    std::string text = "  " + name(face);
    switch (kind) {
      case ContactKind::none:
        return {};
      case ContactKind::at_end:
        text += " holds an end of the segment, and does not block\n";
        break;
      case ContactKind::grazing:
        text += " blocks: touched, it is degenerate or the path runs within its plane\n";
        break;
      case ContactKind::on_edge:
      case ContactKind::on_vertex:
        text += fmt::format(" blocks: met on {}, which is {}\n",
                            kind == ContactKind::on_edge ? "an edge" : "a vertex",
                            is_sealed(face) ? "sealed by the triangles that share it"
                                            : "not sealed: touched, the least move may free the path");
        break;
      case ContactKind::plain:
        text += " blocks: met inside\n";
        break;
    }
    const std::optional<mpq_class> t = plane_parameter(case_.scene, face, case_.query);
    return t ? text + at(*t) : text;
  }

  const ShadowCase& case_;
  exact::Path path_;
  std::vector<Contact> contacts_;
};

bool is_single(const ShadowCase& c) {
  const auto floats = [](const Point& p) { return std::ranges::all_of(p, scene::is_float); };
  return floats(c.query.point) && floats(c.query.light) && std::ranges::all_of(c.scene.points, floats) &&
         std::ranges::all_of(c.scene.balls, [&](const scene::Ball<double>& ball) {
           return floats(ball.centre) && scene::is_float(ball.radius);
         });
}

std::string answer_words(const exact::ShadowTruth& truth) {
  std::string text = "Exactly: ";
  switch (truth.answer) {
    case scene::Shadow::lit:
      text += "no face has a point in common with the open segment: lit";
      break;
    case scene::Shadow::shadowed:
      text += "a face has a point in common with the open segment: shadowed";
      break;
    case scene::Shadow::facing:
      text += "the own face turns away from the light: facing";
      break;
  }
  return text + (truth.touching ? "; it touches: the least move may change the answer\n" : "\n");
}

}  // namespace

std::string explain_shadow(const scene::CorpusLine& line) {
  const fuzz::ReplayResult replayed = fuzz::replay({line}, {}, {nullptr, all_scene_methods()});
  const ShadowCase c = scene::read_shadow_case(line);
  const Words words(c);
  std::string text = fmt::format("{}:{}: shadow ({})\n", line.file, line.line,
                                 is_single(c) ? "all numbers are floats" : "double precision");
  text +=
      words.numbers() + "\n" + answer_words(exact::shadow_by_all_faces(c.scene, c.query)) + words.meetings();
  text += "\nThe methods say:\n";
  for (const fuzz::ReplayLine& by : replayed.lines) {
    text += fmt::format("  {:<19} {:<10}{}\n", by.method, by.answer, by.verdict);
  }
  return text;
}

}  // namespace gnomon::reports
