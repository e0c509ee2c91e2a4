// SPDX-License-Identifier: GPL-3.0-or-later
// The files that a campaign leaves behind, written while it runs.
#pragma once

#include <cstddef>
#include <string>

#include "fuzz/row_result.h"

namespace gnomon::reports {

/// Writes results and witnesses as they become known. Every file is whole at any time, whatever happens to
/// this process: old or new, never a part. A result file of a campaign that goes on says `"complete": false`.
class CampaignFiles {
 public:
  /// `folder` gets QUESTION-SEED.json, witnesses/ and failures/; `json` a result file. Empty: none. Throws
  /// std::runtime_error naming what can't be written.
  CampaignFiles(std::string folder, std::string json);

  /// Writes what is new since the last call: witnesses first, then the result file that names them.
  void write(const fuzz::CampaignResult& result, const std::string& question);
  /// The cases of failures, as corpora to replay.
  void write_failures(const fuzz::CampaignResult& result, const std::string& question) const;

 private:
  std::string folder_, json_;
  std::size_t rows_written_ = 0;
};

}  // namespace gnomon::reports
