// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/shard_set.h"

#include <algorithm>
#include <charconv>

namespace gnomon::reports {

namespace {

/// Takes a number of at least 1 from the front of the text.
bool take_number(std::string_view& text, std::uint64_t& number) {
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || number == 0) return false;
  text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
  return true;
}

bool take(std::string_view& text, char c) {
  if (text.empty() || text.front() != c) return false;
  text.remove_prefix(1);
  return true;
}

std::string run_text(std::uint64_t from, std::uint64_t to) {
  return std::to_string(from) + (from == to ? "" : "-" + std::to_string(to));
}

}  // namespace

bool ShardSet::parse(std::string_view text, ShardSet& set) {
  ShardSet parsed;
  parsed.runs_.clear();
  do {
    Run run{};
    if (!take_number(text, run.first)) return false;
    run.second = run.first;
    if (take(text, '-') && !take_number(text, run.second)) return false;
    if (run.second < run.first || (!parsed.runs_.empty() && run.first <= parsed.runs_.back().second))
      return false;
    parsed.runs_.push_back(run);
  } while (take(text, ','));
  if (!take(text, '/') || !take_number(text, parsed.of_) || !text.empty()) return false;
  if (parsed.runs_.back().second > parsed.of_) return false;
  set = std::move(parsed);
  return true;
}

bool ShardSet::overlaps(const ShardSet& other) const {
  return std::any_of(runs_.begin(), runs_.end(), [&](const Run& mine) {
    return std::any_of(other.runs_.begin(), other.runs_.end(), [&](const Run& theirs) {
      return mine.first <= theirs.second && theirs.first <= mine.second;
    });
  });
}

void ShardSet::add(const ShardSet& other) {
  std::vector<Run> all = runs_;
  all.insert(all.end(), other.runs_.begin(), other.runs_.end());
  std::sort(all.begin(), all.end());
  runs_.clear();
  for (const Run& run : all) {
    if (!runs_.empty() && run.first == runs_.back().second + 1) {
      runs_.back().second = run.second;
    } else {
      runs_.push_back(run);
    }
  }
}

std::string ShardSet::text() const {
  if (whole()) return "1/1";
  std::string text;
  for (const Run& run : runs_) text += (text.empty() ? "" : ",") + run_text(run.first, run.second);
  return text + "/" + std::to_string(of_);
}

std::string ShardSet::missing() const {
  std::string text;
  std::uint64_t next = 1;
  const auto say = [&](std::uint64_t to) {
    if (next <= to) text += (text.empty() ? "" : ",") + run_text(next, to);
  };
  for (const Run& run : runs_) {
    say(run.first - 1);
    next = run.second + 1;
  }
  say(of_);
  return text;
}

}  // namespace gnomon::reports
