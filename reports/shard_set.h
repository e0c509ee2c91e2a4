// SPDX-License-Identifier: GPL-3.0-or-later
// Which shards of a campaign a result file holds.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gnomon::reports {

/// Some of the shards 1..N of a campaign. As text "2/3", or of merged files "1-2,4/5"; the whole is "1/1".
class ShardSet {
 public:
  /// The whole run.
  ShardSet() = default;
  /// False when the text is no shard set; `set` is then left alone.
  [[nodiscard]] static bool parse(std::string_view text, ShardSet& set);

  [[nodiscard]] bool whole() const { return runs_.size() == 1 && runs_[0] == Run{1, of_}; }
  [[nodiscard]] std::uint64_t of() const { return of_; }
  [[nodiscard]] std::uint64_t first() const { return runs_.front().first; }
  /// True when both hold some shard; the sets must be of the same number of shards.
  [[nodiscard]] bool overlaps(const ShardSet& other) const;
  /// Adds the shards of a set that does not overlap.
  void add(const ShardSet& other);
  [[nodiscard]] std::string text() const;
  /// The shards that are not there, e.g. "2,5-7"; empty when whole.
  [[nodiscard]] std::string missing() const;

 private:
  using Run = std::pair<std::uint64_t, std::uint64_t>;  ///< from, to
  std::vector<Run> runs_{{1, 1}};                       ///< rising, with gaps between them
  std::uint64_t of_ = 1;
};

}  // namespace gnomon::reports
