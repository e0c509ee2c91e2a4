// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/summary.h"

#include <algorithm>
#include <array>
#include <set>
#include <stdexcept>
#include <tuple>

#include "fuzz/statistics.h"

namespace gnomon::reports {
namespace {

std::uint64_t row_sum(const std::map<std::string, std::uint64_t>& answers) {
  std::uint64_t sum = 0;
  for (const auto& [answer, n] : answers) sum += n;
  return sum;
}

std::uint64_t cell(const std::map<std::string, std::uint64_t>& answers, const char* answer) {
  const auto it = answers.find(answer);
  return it == answers.end() ? 0 : it->second;
}

/// Errors and chances of the three columns, from the counts alone.
struct Counts {
  std::uint64_t culls = 0, cull_chances = 0, insides = 0, inside_chances = 0, wasted = 0, waste_chances = 0;
};

Counts count(const Summary& s) {
  Counts c;
  if (s.matrix.contains("outside")) {
    for (const auto& [truth, answers] : s.matrix) {
      const std::uint64_t all = row_sum(answers);
      if (truth == "outside") {
        c.waste_chances += all;
        c.wasted += all - cell(answers, "outside");
      } else {
        c.cull_chances += all;
        c.culls += cell(answers, "outside");
      }
      if (truth != "inside" && s.matrix.contains("inside")) {
        c.inside_chances += all;
        c.insides += cell(answers, "inside");
      }
    }
  } else if (s.about_pairs) {
    c.cull_chances = s.deceivable;
    c.waste_chances = s.wasteful;
    c.culls = std::min(s.unsound, c.cull_chances);
    c.wasted = std::min(s.waste, c.waste_chances);
  } else {
    const std::uint64_t asked = s.trials - std::min(s.rejected, s.trials);
    c.cull_chances = c.waste_chances = asked;
    c.culls = std::min(s.unsound, asked);
    c.wasted = std::min(s.waste, asked);
  }
  return c;
}

int tier_rank(const std::string& tier) {
  constexpr std::array kOrder = {"trivial", "naive", "certified", "exact", "reference", "plug-in"};
  const auto it = std::find(kOrder.begin(), kOrder.end(), tier);
  return static_cast<int>(it - kOrder.begin());
}

/// A row that names no tier: the promise tells all but trivial from certified.
std::string tier_of(const ResultRow& row) {
  if (!row.tier.empty()) return row.tier;
  if (row.promise == "always agrees") return "exact";
  if (row.promise == "never unsound") return row.method.starts_with("trivial") ? "trivial" : "certified";
  return "naive";
}

void add(Summary& s, const ResultRow& row) {
  s.trials += row.trials;
  s.unsound += row.unsound;
  s.waste += row.waste;
  s.undecided += row.undecided;
  s.rejected += row.rejected;
  s.about_pairs = s.about_pairs || !row.knows_twin;
  s.wasteful += row.waste_rate.of.value_or(0);
  s.deceivable += row.unsound_rate.of.value_or(0);
  s.rounding += row.rounding;
  s.model += row.model;
  s.rounding_and_model += row.rounding_and_model;
  for (const auto& [truth, answers] : row.matrix) {
    for (const auto& [answer, n] : answers) s.matrix[truth][answer] += n;
  }
  s.promise_broken = s.promise_broken || row.promise_broken;
}

/// Half of the rows' times are at most this. A mean would be the time of the one distribution that is slowest
/// by far.
std::optional<double> median_time(std::span<const ResultRow* const> rows,
                                  std::optional<double> ResultRow::*field) {
  std::vector<double> times;
  for (const ResultRow* row : rows) {
    if (row->*field) times.push_back(*(row->*field));
  }
  if (times.empty()) return std::nullopt;
  std::sort(times.begin(), times.end());
  const std::size_t middle = times.size() / 2;
  return times.size() % 2 == 1 ? times[middle] : (times[middle - 1] + times[middle]) / 2;
}

/// A row and where it is from.
struct Source {
  const ResultFile* file;
  const ResultRow* row;
};

bool same_cases(const Source& a, const Source& b) {
  const auto whole = [](const Source& s) { return s.file->shard.empty() || s.file->shard == "1/1"; };
  return a.file->seed && a.file->seed == b.file->seed && a.row->distribution == b.row->distribution &&
         ((whole(a) && whole(b)) || a.file->shard == b.file->shard);
}

/// Adds a row, or lets the larger one of the same cases stand.
void count_once(std::vector<Source>& sources, Source added) {
  for (Source& known : sources) {
    if (!same_cases(known, added)) continue;
    if (added.row->trials > known.row->trials) known = added;
    return;
  }
  sources.push_back(added);
}

}  // namespace

Share share_of(std::uint64_t k, std::uint64_t n) {
  if (k > n) throw std::domain_error("share_of: more errors than chances");
  const fuzz::Rate rate = fuzz::rate_of(k, n);
  return {k, n, {rate.value, rate.low95, rate.high95, n}};
}

Summary summarise(const ResultRow& row) {
  const std::array<const ResultRow*, 1> one = {&row};
  Summary s = pool(one);
  s.distribution = row.distribution;
  s.culls.rate = row.unsound_rate;
  s.wasted.rate = row.waste_rate;
  if (row.false_inside_rate) s.insides.rate = *row.false_inside_rate;
  return s;
}

Summary pool(std::span<const ResultRow* const> rows) {
  Summary s;
  const ResultRow& first = *rows.front();
  s.question = first.question;
  s.method = s.label = first.method;
  s.promise = first.promise;
  s.tier = tier_of(first);
  s.scalar = first.scalar;
  for (const ResultRow* row : rows) add(s, *row);
  const Counts c = count(s);
  s.culls = share_of(c.culls, c.cull_chances);
  s.insides = share_of(c.insides, c.inside_chances);
  s.wasted = share_of(c.wasted, c.waste_chances);
  s.ns = median_time(rows, &ResultRow::ns);
  s.reference_ns = median_time(rows, &ResultRow::reference_ns);
  return s;
}

std::vector<Summary> group(std::span<const ResultFile> files, Grouping grouping) {
  const bool apart = grouping == Grouping::kMethodAndDistribution;
  using Key = std::tuple<std::string, int, std::string, std::string, std::string>;
  std::map<Key, std::vector<Source>> groups;
  for (const ResultFile& file : files) {
    for (const ResultRow& row : file.rows) {
      const std::string distribution = apart ? row.distribution : "";
      count_once(groups[{row.question, tier_rank(tier_of(row)), row.method, row.scalar, distribution}],
                 {&file, &row});
    }
  }
  std::vector<Summary> summaries;
  for (const auto& [key, sources] : groups) {
    std::vector<const ResultRow*> rows;
    for (const Source& source : sources) rows.push_back(source.row);
    summaries.push_back(apart && rows.size() == 1 ? summarise(*rows.front()) : pool(rows));
    if (apart) summaries.back().distribution = std::get<4>(key);
  }
  std::map<std::pair<std::string, std::string>, std::set<std::string>> scalars;
  for (const Summary& s : summaries) scalars[{s.question, s.method}].insert(s.scalar);
  for (Summary& s : summaries) {
    if (scalars[{s.question, s.method}].size() > 1) s.label += " " + s.scalar;
  }
  return summaries;
}

std::vector<std::string> answers_of(const Matrix& matrix) {
  std::vector<std::string> answers;
  const auto note = [&](const std::string& a) {
    if (std::find(answers.begin(), answers.end(), a) == answers.end()) answers.push_back(a);
  };
  for (const auto& [truth, row] : matrix) {
    note(truth);
    for (const auto& [answer, n] : row) note(answer);
  }
  constexpr std::array kOrder = {"outside", "overlap", "inside"};
  const auto rank = [&](const std::string& a) {
    return std::find(kOrder.begin(), kOrder.end(), a) - kOrder.begin();
  };
  std::sort(answers.begin(), answers.end(), [&](const std::string& a, const std::string& b) {
    return std::tuple(rank(a), a) < std::tuple(rank(b), b);
  });
  return answers;
}

}  // namespace gnomon::reports
