// SPDX-License-Identifier: GPL-3.0-or-later
// Several result files of one campaign as one.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace gnomon::reports {

struct MergedResult {
  std::string json;                 ///< the merged result file
  std::string summary;              ///< one line: what was merged, and what is missing
  std::vector<std::string> broken;  ///< the rows whose promise was broken, in words
};

/// Adds result files of `gnomon fuzz` up.
///
/// Shards of one command and seed: counts add, rates and their intervals are computed anew, of the worst gaps
/// and the witnesses those stay that one run would have kept. With all shards there the result is, outside
/// `measured`, byte for byte that of the run that was not sharded; while some are missing its "shard" says
/// which are there.
///
/// Several seeds: when all have the same rows (question, method, distribution, scalar) and all their shards,
/// cases of different seeds being different. "seeds" and "commands" then stand for "seed"; witnesses and
/// worst gaps say their own; trials of lower seeds count as lower ones.
///
/// `measured`: seconds add, times per case are weighted by trials, values that differ are listed. The order
/// of `files` changes nothing. Throws scene::InputError naming the file and what was expected for: what is no
/// result file of this major version; another kind than fuzz; a shard or seed that is there twice; shards of
/// different commands; different rows; fields that can't be added.
[[nodiscard]] MergedResult merge_results(const std::vector<std::filesystem::path>& files);

}  // namespace gnomon::reports
