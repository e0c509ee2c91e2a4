// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "reports/html_sections.h"
#include "reports/html_text.h"

namespace gnomon::reports {
namespace {

/// The word that a method gets, and its colour class.
struct Word {
  const char* word;
  const char* look;
};

/// What a method has earned, on all distributions together.
Word word_for(const Summary& s) {
  if (s.promise_broken) return {"PROMISE BROKEN", "bad"};
  if (s.lies()) return {"LIES", "bad"};
  if (s.wasted.n > 0 && s.wasted.k == s.wasted.n) return {"KEEPS ALL", "idle"};
  if (s.tier == "trivial" && s.about_pairs) return {"KEEPS ALL", "idle"};
  if ((s.tier == "exact" || s.tier == "reference") && s.waste == 0) return {"AGREES", "good"};
  if (s.tier == "naive") return {"NOT CAUGHT", "good"};
  return {"SAFE", "good"};
}

/// "1.2 % (34 of 2,800)" or "0 of 2,800 (< 1.3e-3)".
std::string spelled(const Share& share) {
  if (share.k == 0) return share_html(share);
  return fmt::format("<b>{}</b> ({})", rate_text(share.rate.value), share_html(share));
}

/// The distribution where `share` is worst, as " (worst on NAME: 3 %)"; empty when there is only one.
std::string worst_on(const Summary& pooled, std::span<const Summary> apart, Share Summary::*share) {
  const Summary* worst = nullptr;
  std::size_t seen = 0;
  for (const Summary& s : apart) {
    if (s.question != pooled.question || s.method != pooled.method || s.scalar != pooled.scalar) continue;
    ++seen;
    if ((s.*share).k > 0 && (!worst || (s.*share).rate.value > (worst->*share).rate.value)) worst = &s;
  }
  if (!worst || seen < 2) return "";
  return fmt::format(", worst on <code>{}</code> with {}", escaped(worst->distribution),
                     rate_text((worst->*share).rate.value));
}

std::string sentence(const Summary& s, std::span<const Summary> apart) {
  const bool shaft = s.matrix.contains("outside"), lists = s.question == "shaft-candidates";
  std::string text;
  if (s.culls.k > 0) {
    text += fmt::format("{} {}{}. ",
                        shaft   ? "Culls what it should keep:"
                        : lists ? "Leaves out faces that it must list:"
                                : "Wrong to the eye:",
                        spelled(s.culls), worst_on(s, apart, &Summary::culls));
  } else {
    text += fmt::format("No {} seen: {}. ",
                        shaft   ? "false cull"
                        : lists ? "list without a face that belongs there"
                                : "unsound answer",
                        spelled(s.culls));
  }
  if (s.insides.k > 0) {
    text += fmt::format("Says “inside” falsely: {}{}. ", spelled(s.insides),
                        worst_on(s, apart, &Summary::insides));
  }
  if (s.wasted.n > 0) {
    text += fmt::format("{} {}. ",
                        shaft   ? "Keeps what lies outside:"
                        : lists ? "Lists more than it must:"
                                : "Wastes:",
                        spelled(s.wasted));
  }
  if (s.undecided > 0) text += fmt::format("Undecided: {}. ", thousands(s.undecided));
  return text;
}

std::string speed(const Summary& s) {
  if (!s.ns) return "";
  std::string text = time_text(s.ns);
  if (s.reference_ns && *s.ns > 0) {
    const double factor = *s.reference_ns / *s.ns;
    const auto times = [](double x) {
      return x < 1000 ? fmt::format("{:.3g}", x) : thousands(static_cast<std::uint64_t>(std::min(x, 1e18)));
    };
    text += factor >= 1 ? fmt::format("<small>{} × faster than the reference</small>", times(factor))
                        : fmt::format("<small>{} × slower than the reference</small>", times(1 / factor));
  }
  return text;
}

}  // namespace

std::string methods_section(std::span<const ResultFile> files) {
  const std::vector<Summary> pooled = group(files, Grouping::kMethod);
  const std::vector<Summary> apart = group(files, Grouping::kMethodAndDistribution);
  if (pooled.empty()) return "";
  std::string out = "<section id=\"methods\"><h2>Method by method</h2>\n";
  out +=
      "<p>Rates are over all distributions together. Most of these are built to be hard, so a rate here "
      "compares methods; "
      "it is not the rate to expect in a scene. “&lt;” is the upper end of the two-sided 95 % "
      "Clopper-Pearson interval: no "
      "errors seen is not no errors.</p>\n";
  std::string open;
  for (const Summary& s : pooled) {
    if (s.question != open) {
      if (!open.empty()) out += "</tbody></table>\n";
      open = s.question;
      out += fmt::format(
          "<h3><code>{}</code></h3>\n<table class=\"verdicts\"><thead class=\"unseen\"><tr><th "
          "scope=\"col\">Method</th><th "
          "scope=\"col\">Verdict</th><th scope=\"col\">Why</th><th scope=\"col\">Time per "
          "case</th></tr></thead><tbody>\n",
          escaped(s.question));
    }
    const Word word = word_for(s);
    out += fmt::format(
        "<tr><th scope=\"row\"><span class=\"dot t-{0}\"></span>{1}<small>{0}, promise: {2}</small></th><td "
        "class=\"word "
        "{3}\">{4}</td><td>{5}</td><td class=\"num\">{6}</td></tr>\n",
        escaped(s.tier), escaped(s.label), escaped(s.promise), word.look, word.word, sentence(s, apart),
        speed(s));
  }
  return out + "</tbody></table></section>\n";
}

}  // namespace gnomon::reports
