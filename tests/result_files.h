// SPDX-License-Identifier: GPL-3.0-or-later
// Result files for tests: campaigns run and written, files changed, the binary run.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "fuzz/campaign.h"
#include "fuzz/shaft_questions.h"
#include "reports/result_json.h"

namespace gnomon::reports {

using OrderedJson = nlohmann::ordered_json;

/// A folder that is gone after the test.
class ResultFiles : public testing::Test {
 public:
  ResultFiles()
      : folder_(std::filesystem::temp_directory_path() / ("gnomon-results-" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(folder_);
  }
  ~ResultFiles() override { std::filesystem::remove_all(folder_); }

 protected:
  [[nodiscard]] std::filesystem::path path(const std::string& name) const { return folder_ / name; }

  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }

  /// Writes the file with a change.
  std::filesystem::path changed(const std::string& name, OrderedJson json,
                                const std::function<void(OrderedJson&)>& change) const {
    change(json);
    return write(name, json.dump(1) + "\n");
  }

  static std::string read(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  static OrderedJson json_of(const std::filesystem::path& file) { return OrderedJson::parse(read(file)); }

  /// What a result file says, timings apart, as bytes.
  static std::string said(const std::string& text) {
    OrderedJson json = OrderedJson::parse(text);
    json.erase("measured");
    return json.dump(1);
  }

  /// Runs `gnomon ARGUMENTS`: exit status and everything printed on standard error (standard output in
  /// `out`).
  struct Outcome {
    int status;
    std::string error, out;
  };
  [[nodiscard]] Outcome gnomon(const std::string& arguments) const {
    const std::string command = std::string(GNOMON_BINARY) + " " + arguments + " >" +
                                path("out.txt").string() + " 2>" + path("err.txt").string();
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read(path("err.txt")), read(path("out.txt"))};
  }

  /// The number of files in the folder whose names start so.
  [[nodiscard]] int files_like(const std::string& start) const {
    int found = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
      found += entry.path().filename().string().rfind(start, 0) == 0;
    }
    return found;
  }

 private:
  std::filesystem::path folder_;
};

/// A campaign of boxes that finds false culls, false insides and waste of every kind.
inline fuzz::CampaignOptions few_hard_trials() {
  fuzz::CampaignOptions options;
  options.trials = 7000;
  options.distributions = {"near-touch", "offset"};
  options.methods = {"naive-f32", "printed-f32", "certified-f32", "exact"};
  return options;
}

/// The result file of a campaign, with the command that the command line would write.
inline std::string result_of(const fuzz::CampaignOptions& options) {
  fuzz::CampaignResult result = fuzz::run_campaign<fuzz::ShaftBoxQuestion>(options);
  result.command = "gnomon fuzz shaft-box --trials " + std::to_string(options.trials) + " --seed " +
                   std::to_string(options.seed);
  if (options.shards > 1)
    result.command += " --shard " + std::to_string(options.shard) + "/" + std::to_string(options.shards);
  return result_json(result);
}

}  // namespace gnomon::reports
