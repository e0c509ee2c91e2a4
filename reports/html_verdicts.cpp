// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "reports/html_sections.h"
#include "reports/html_text.h"

namespace gnomon::reports {
namespace {

std::string promises_line(std::span<const Summary> apart) {
  std::string broken;
  std::uint64_t trials = 0;
  std::size_t promises = 0;
  for (const Summary& s : apart) {
    trials += s.trials;
    promises += s.promise != "none" && !s.promise.empty() ? 1 : 0;
    if (s.promise_broken) {
      broken += fmt::format(
          "<li><code>{}</code> promised “{}” for <code>{}</code> and broke it on <code>{}</code>.</li>",
          escaped(s.label), escaped(s.promise), escaped(s.question), escaped(s.distribution));
    }
  }
  if (!broken.empty()) {
    return fmt::format("<div class=\"banner bad\"><b>A promise was broken.</b><ul>{}</ul></div>\n", broken);
  }
  return fmt::format(
      "<div class=\"banner good\"><b>Every promise held.</b> {} trials; {} rows come with a promise, the "
      "others promise nothing and are here to be caught.</div>\n",
      thousands(trials), thousands(promises));
}

std::string named(const Summary& s) {
  return fmt::format("<b class=\"nowrap t-{}\">{}</b>", escaped(s.tier), escaped(s.label));
}

/// Where a method errs most, as ", 4.6 % on NAME"; empty when it was asked on one distribution only.
std::string worst_distribution(const Summary& pooled, std::span<const Summary> apart, Share Summary::*share) {
  const Summary* worst = nullptr;
  for (const Summary& s : apart) {
    if (s.question != pooled.question || s.method != pooled.method || s.scalar != pooled.scalar) continue;
    if ((s.*share).k > 0 && (!worst || (s.*share).rate.value > (worst->*share).rate.value)) worst = &s;
  }
  if (!worst || (worst->*share).n == (pooled.*share).n) return "";
  return fmt::format(", {} on <code>{}</code>", rate_text((worst->*share).rate.value),
                     escaped(worst->distribution));
}

/// The method with the highest rate, as a sentence; empty when nothing was seen.
std::string worst_text(std::span<const Summary> methods, std::span<const Summary> apart,
                       Share Summary::*share, const char* what) {
  const Summary* worst = nullptr;
  for (const Summary& s : methods) {
    if ((s.*share).k > 0 && (!worst || (s.*share).rate.value > (worst->*share).rate.value)) worst = &s;
  }
  if (!worst) return "";
  return fmt::format("{}: {}, {} ({}){}. ", what, named(*worst), rate_text((worst->*share).rate.value),
                     share_html(worst->*share), worst_distribution(*worst, apart, share));
}

/// The liars in a sentence or two.
std::string liars_text(std::span<const Summary> methods, std::span<const Summary> apart) {
  std::string liars;
  std::size_t count = 0;
  for (const Summary& s : methods) {
    if (!s.lies()) continue;
    ++count;
    liars += (liars.empty() ? "" : ", ") + named(s);
  }
  if (count == 0) return fmt::format("None of {} methods was caught lying. ", methods.size());
  return fmt::format("<b class=\"bad\">{} of {} methods {}</b>: {}. ", count, methods.size(),
                     count == 1 ? "lies" : "lie", liars) +
         worst_text(methods, apart, &Summary::culls,
                    methods.front().about_pairs ? "Most unsound answers" : "Most false culls") +
         worst_text(methods, apart, &Summary::insides, "Most false insides");
}

/// The cheapest method that was not caught and is of use, and what exactness costs.
std::string honest_text(std::span<const Summary> methods) {
  const Summary *fastest = nullptr, *exact = nullptr;
  for (const Summary& s : methods) {
    if (s.lies() || s.promise_broken || s.tier == "trivial" || s.tier == "naive" || s.tier == "reference") {
      continue;
    }
    if (s.ns && (!fastest || *s.ns < *fastest->ns)) fastest = &s;
    if (s.tier == "exact" && s.ns && (!exact || *s.ns < *exact->ns)) exact = &s;
  }
  std::string text;
  if (fastest) {
    text += fmt::format("Cheapest that promises and keeps: {} at {}, {} {}", named(*fastest),
                        time_text(fastest->ns), fastest->about_pairs ? "unsound" : "false culls",
                        share_html(fastest->culls));
    if (fastest->wasted.n > 0) text += fmt::format("; wastes {}", rate_text(fastest->wasted.rate.value));
    text += ". ";
  }
  if (exact && exact != fastest)
    text += fmt::format("The whole truth: {} at {}", named(*exact), time_text(exact->ns));
  if (exact && exact != fastest && exact->reference_ns) {
    text += fmt::format(" (the plain reference takes {})", time_text(exact->reference_ns));
  }
  return text.empty() || text.ends_with(". ") ? text : text + ".";
}

}  // namespace

std::string verdict_section(std::span<const ResultFile> files) {
  const std::vector<Summary> pooled = group(files, Grouping::kMethod);
  const std::vector<Summary> apart = group(files, Grouping::kMethodAndDistribution);
  std::string out =
      "<header><h1>gnomon</h1><p class=\"lead\">Fast floating-point tests for visibility culling, run beside "
      "an exact "
      "reference on the same cases: which of them lie, how often, in which direction, by how much, and what "
      "the truth "
      "costs.</p></header>\n";
  if (pooled.empty()) return out;
  out += promises_line(apart) +
         "<section id=\"verdicts\"><h2 class=\"unseen\">Verdicts</h2>\n<div class=\"headlines\">\n";
  for (auto first = pooled.begin(); first != pooled.end();) {
    const auto last =
        std::find_if(first, pooled.end(), [&](const Summary& s) { return s.question != first->question; });
    const std::span<const Summary> methods(first, last);
    out += fmt::format("<div><h3><code>{}</code></h3><p>{}</p><p>{}</p></div>\n", escaped(first->question),
                       liars_text(methods, apart), honest_text(methods));
    first = last;
  }
  return out + "</div></section>\n";
}

}  // namespace gnomon::reports
