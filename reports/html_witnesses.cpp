// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>

#include "reports/case_line.h"
#include "reports/html_sections.h"
#include "reports/html_text.h"
#include "reports/picture.h"

namespace gnomon::reports {
namespace {

constexpr std::size_t kPictures = 24;  // a picture takes about 8 KB; the list below them has every witness

/// Verdicts that cost time and nothing else; any other one is taken for the worse kind.
bool is_waste(const ResultWitness& w) {
  return w.verdict == "waste" || w.verdict == "false keep" || w.verdict == "missed inside" ||
         w.verdict == "excess face" || w.verdict == "missed none" || w.verdict == "missed all";
}

double size_of(const ResultWitness& w) {
  if (!w.gap) return -1;
  return w.gap->ulps ? std::abs(*w.gap->ulps) : std::numeric_limits<double>::max();
}

/// Unsound before waste, then the larger gap, then by name: the same order for the same input.
bool worse(const ResultWitness* a, const ResultWitness* b) {
  return std::tuple(is_waste(*a), -size_of(*a), a->question, a->method, a->name) <
         std::tuple(is_waste(*b), -size_of(*b), b->question, b->method, b->name);
}

std::string gap_text(const ResultWitness& w) {
  if (!w.gap) return "";
  const bool squared = w.question == "shaft-sphere";
  std::string rational = fmt::format("<code>{}</code>", escaped(w.gap->rational));
  if (w.gap->rational.size() > 80) {
    rational = fmt::format("<details><summary>as a fraction</summary>{}</details>", rational);
  }
  std::string length = w.gap->approx ? fmt::format("{:.6g}, ", *w.gap->approx) : "";
  return fmt::format("<dt>Gap</dt><dd>{}{}; exactly{} {}</dd>", length, ulps_text(w.gap->ulps),
                     squared ? ", as a square," : "", rational);
}

std::string commands(const ResultWitness& w) {
  const std::string file = shell_word("witnesses/" + w.name);
  return fmt::format("gnomon replay {}\ngnomon explain {}", file, file);
}

/// The boundary on whose wrong side the answer is.
PictureFocus focus_of(const ResultWitness& w) {
  if (w.answer == "outside" || w.reference == "outside") return PictureFocus::kOutside;
  return w.answer == "inside" || w.reference == "inside" ? PictureFocus::kInside : PictureFocus::kNearer;
}

std::string generated(const ResultWitness& w) {
  if (w.as_generated.empty() || w.as_generated == w.case_line) return "";
  return fmt::format("<details><summary>as it was found</summary><pre class=\"copy\">{}</pre></details>",
                     escaped(w.as_generated));
}

std::string card(const ResultWitness& w) {
  std::string picture;
  if (const auto numbers = numbers_of_case(w.case_line)) {
    picture = fmt::format("<div class=\"picture\">{}</div>\n",
                          case_picture_svg(w.question, *numbers, w.scalar, focus_of(w)));
  }
  std::string out = fmt::format(
      "<article class=\"witness\"><h3><span class=\"word {}\">{}</span> <code>{}</code> on "
      "<code>{}</code></h3>\n"
      "{}",
      is_waste(w) ? "warn" : "bad", escaped(w.verdict), escaped(w.method), escaped(w.question), picture);
  out += fmt::format("<dl><dt>Said</dt><dd><b>{}</b>, exactly <b>{}</b> ({}{})</dd>{}", escaped(w.answer),
                     escaped(w.reference), escaped(w.scalar),
                     w.distribution.empty() ? "" : ", found on " + escaped(w.distribution), gap_text(w));
  return out +
         fmt::format(
             "<dt>Case, shrunk</dt><dd><pre class=\"copy\">{}</pre>{}</dd><dt>See for yourself</dt><dd><pre "
             "class=\"copy\">{}</pre></dd></dl></article>\n",
             escaped(w.case_line), generated(w), escaped(commands(w)));
}

std::string list_table(std::span<const ResultWitness* const> witnesses) {
  std::string out = fmt::format(
      "<details><summary>All {} witnesses as a list</summary><div class=\"scroll\"><table><thead><tr><th "
      "scope=\"col\">Verdict</th><th scope=\"col\">Method</th><th scope=\"col\">Said</th><th "
      "scope=\"col\">Exactly</th><th scope=\"col\">Gap</th><th scope=\"col\">File</th><th "
      "scope=\"col\">Case</th></tr></thead><tbody>\n",
      thousands(witnesses.size()));
  for (const ResultWitness* w : witnesses) {
    out += fmt::format(
        "<tr><td class=\"{}\">{}</td><td>{}</td><td>{}</td><td>{}</td><td class=\"num\">{}</td><td>{}</td>"
        "<td><code>{}</code></td></tr>\n",
        is_waste(*w) ? "warn" : "bad", escaped(w->verdict), escaped(w->method), escaped(w->answer),
        escaped(w->reference), w->gap ? ulps_text(w->gap->ulps) : "–", escaped(w->name),
        escaped(w->case_line));
  }
  return out + "</tbody></table></div></details>\n";
}

}  // namespace

std::string witness_section(std::span<const ResultFile> files) {
  std::vector<const ResultWitness*> all;
  for (const ResultFile& file : files) {
    for (const ResultWitness& w : file.witnesses) all.push_back(&w);
  }
  if (all.empty()) return "";
  std::stable_sort(all.begin(), all.end(), worse);
  std::string out =
      "<section id=\"witnesses\"><h2>Worst witnesses</h2>\n<p>The widest miss of each method and verdict, "
      "shrunk. "
      "The large picture is a projection in which the deciding plane is a line; the small one is its "
      "surroundings at the scale of the floating-point grid (an ulp is that of the case's largest "
      "coordinate); pairs in a scene have none. "
      "The commands run where the result files are.</p>\n<div class=\"witnesses\">\n";
  std::set<std::tuple<std::string, std::string, std::string>> shown;
  for (const ResultWitness* w : all) {
    if (shown.size() == kPictures) break;
    if (shown.insert({w->question, w->method, w->verdict}).second) out += card(*w);
  }
  return out + "</div>\n" + list_table(all) + "</section>\n";
}

}  // namespace gnomon::reports
