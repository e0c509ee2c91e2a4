// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/campaign_files.h"

#include <algorithm>
#include <filesystem>

#include "fuzz/witness.h"
#include "reports/result_json.h"
#include "scene/atomic_file.h"

namespace gnomon::reports {

CampaignFiles::CampaignFiles(std::string folder, std::string json)
    : folder_(std::move(folder)), json_(std::move(json)) {
  if (!folder_.empty()) scene::require_writable(std::filesystem::path(folder_) / "witnesses" / "case");
  if (!json_.empty()) scene::require_writable(json_);
}

void CampaignFiles::write(const fuzz::CampaignResult& result, const std::string& question) {
  const std::string json = result_json(result);
  if (!folder_.empty()) {
    const std::filesystem::path folder(folder_);
    for (; rows_written_ < result.rows.size(); ++rows_written_) {
      for (const fuzz::Witness& witness : result.rows[rows_written_].witnesses) {
        scene::write_whole_file(folder / "witnesses" / witness.name, fuzz::witness_text(witness));
      }
    }
    std::string name = question + "-" + std::to_string(result.seed);
    if (result.shards > 1) name += "-" + std::to_string(result.shard) + "of" + std::to_string(result.shards);
    scene::write_whole_file(folder / (name + ".json"), json);
  }
  if (!json_.empty()) scene::write_whole_file(json_, json);
}

void CampaignFiles::write_failures(const fuzz::CampaignResult& result, const std::string& question) const {
  if (folder_.empty()) return;
  for (const fuzz::Failure& failure : result.failures) {
    std::string name =
        question + "." + failure.method + "." + failure.distribution + "." + failure.scalar + ".txt";
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c == ':' || c == '/'; }, '-');
    std::string text = "# " + failure.line + "\n";
    for (const std::string& line : failure.cases) text += line + "\n";
    scene::write_whole_file(std::filesystem::path(folder_) / "failures" / name, text);
  }
}

}  // namespace gnomon::reports
