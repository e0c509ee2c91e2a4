// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "reports/html_sections.h"
#include "reports/html_text.h"
#include "reports/summary.h"

namespace gnomon::reports {
namespace {

/// What the cases of one distribution are, exactly.
struct Mix {
  std::map<std::string, std::uint64_t> truths;
  std::uint64_t total = 0, touching = 0;
  bool knows_touching = true;
};

Mix mix_of(const ResultRow& row) {
  Mix mix;
  for (const auto& [truth, answers] : row.matrix) {
    for (const auto& [answer, n] : answers) mix.truths[truth] += n, mix.total += n;
  }
  for (const auto& [truth, n] : row.touching) mix.touching += n;
  mix.knows_touching = row.knows_twin;
  return mix;
}

/// Question, distribution, scalar -> the mix as the row with the most accepted cases saw it.
using Mixes = std::map<std::tuple<std::string, std::string, std::string>, Mix>;

Mixes collect(std::span<const ResultFile> files) {
  Mixes mixes;
  for (const ResultFile& file : files) {
    for (const ResultRow& row : file.rows) {
      Mix mix = mix_of(row);
      Mix& kept = mixes[{row.question, row.distribution, row.scalar}];
      if (mix.total > kept.total) kept = std::move(mix);
    }
  }
  return mixes;
}

std::string share(std::uint64_t n, std::uint64_t total) {
  if (n == 0) return "0";
  return rate_text(static_cast<double>(n) / static_cast<double>(total));
}

std::string bar(const Mix& mix, std::span<const std::string> truths) {
  std::string out =
      "<svg class=\"bar\" viewBox=\"0 0 200 12\" preserveAspectRatio=\"none\" aria-hidden=\"true\">";
  double x = 0;
  for (std::size_t i = 0; i < truths.size(); ++i) {
    const auto it = mix.truths.find(truths[i]);
    if (it == mix.truths.end()) continue;
    const double width = 200 * static_cast<double>(it->second) / static_cast<double>(mix.total);
    out += fmt::format("<rect class=\"truth{}\" x=\"{:.2f}\" y=\"0\" width=\"{:.2f}\" height=\"12\"/>", i % 4,
                       x, width);
    x += width;
  }
  return out + "</svg>";
}

}  // namespace

std::string mix_section(std::span<const ResultFile> files) {
  const Mixes mixes = collect(files);
  if (mixes.empty()) return "";
  std::string out =
      "<section id=\"mix\"><h2>What was asked</h2>\n<p>The share of each exact answer by distribution. "
      "<i>Touching</i>: the answer changes under arbitrarily small moves.</p>\n<div class=\"beside\">\n";
  std::string open;
  std::vector<std::string> truths;
  for (const auto& [key, mix] : mixes) {
    const auto& [question, distribution, scalar] = key;
    if (question != open) {
      if (!open.empty()) out += "</tbody></table></div></div>\n";
      open = question;
      Matrix all;
      for (const auto& [other, m] : mixes) {
        if (std::get<0>(other) != question) continue;
        for (const auto& [truth, n] : m.truths) all[truth];
      }
      truths = answers_of(all);
      out += fmt::format(
          "<div><h3><code>{}</code></h3>\n<div class=\"scroll\"><table class=\"mix\"><thead><tr><th "
          "scope=\"col\">Distribution</th><th scope=\"col\">Scalar</th><td></td>",
          escaped(question));
      for (std::size_t i = 0; i < truths.size(); ++i) {
        out += fmt::format("<th scope=\"col\"><span class=\"swatch truth{}\"></span>{}</th>", i % 4,
                           escaped(truths[i]));
      }
      out += "<th scope=\"col\">touching</th><th scope=\"col\">cases</th></tr></thead><tbody>\n";
    }
    if (mix.total == 0) continue;
    out += fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td>", escaped(distribution),
                       escaped(scalar), bar(mix, truths));
    for (const auto& truth : truths) {
      const auto it = mix.truths.find(truth);
      const std::uint64_t n = it == mix.truths.end() ? 0 : it->second;
      out += fmt::format("<td class=\"num{}\">{}</td>", n == 0 ? " quiet" : "", share(n, mix.total));
    }
    out += fmt::format("<td class=\"num{}\">{}</td><td class=\"num\">{}</td></tr>\n",
                       mix.touching == 0 ? " quiet" : "",
                       mix.knows_touching ? share(mix.touching, mix.total) : "–", thousands(mix.total));
  }
  return out + "</tbody></table></div></div></div></section>\n";
}

}  // namespace gnomon::reports
