// SPDX-License-Identifier: GPL-3.0-or-later
// Follows the pointers of the ledger: what is wrong with one, or nothing.
#pragma once

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>
#include <vector>

#include "cli_run.h"
#include "fuzz/statistics.h"
#include "reports/claim_pointer.h"

namespace gnomon::tests {

/// The names of the tests that CTest would run, as CMake and gtest_discover_tests() have written them down;
/// of an executable that is not built yet, as its sources name them.
[[nodiscard]] inline std::vector<std::string> ctest_names(const std::filesystem::path& source,
                                                          const std::filesystem::path& build) {
  namespace fs = std::filesystem;
  std::vector<std::string> names;
  const auto collect = [&](const fs::path& file, const std::regex& pattern, const std::string& form) {
    const std::string text = contents_of(file);
    for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it) {
      names.push_back(it->format(form));
    }
  };
  const std::regex added(R"(add_test\((?:\[=*\[)?([^\s\]"]+))"), macro(R"(\nTEST(?:_F)?\((\w+), (\w+)\))");
  for (const char* folder : {"tests", "proofs"}) {
    for (const auto& entry : fs::directory_iterator(build / folder)) {
      const std::string name = entry.path().filename().string();
      if (name == "CTestTestfile.cmake" || name.ends_with("_tests.cmake")) collect(entry.path(), added, "$1");
    }
  }
  if (fs::exists(build / "tests/gnomon_cgal_tests[1]_tests.cmake")) return names;
  for (const auto& entry : fs::directory_iterator(source / "tests")) {
    if (entry.path().string().ends_with("_cgal_test.cpp")) collect(entry.path(), macro, "$1.$2");
  }
  return names;
}

/// Holds pointers against a source tree and its build; each call returns a complaint, or "" for a good one.
class PointerCheck {
 public:
  PointerCheck(const std::filesystem::path& source, const std::filesystem::path& build)
      : source_(source), ctest_(ctest_names(source, build)) {}

  [[nodiscard]] std::string fault_of(const reports::ClaimPointer& pointer) const {
    return std::visit([&](const auto& p) { return fault(p, command_of(pointer)); }, pointer);
  }

  [[nodiscard]] const std::vector<std::string>& known_to_ctest() const { return ctest_; }

 private:
  /// True when the command's own -R '...' selects at least one test.
  [[nodiscard]] bool selects_a_test(const std::string& command) const {
    std::smatch quoted;
    if (!std::regex_search(command, quoted, std::regex("-R '(.*)'$"))) return false;
    const std::regex wanted(quoted[1].str());
    return std::ranges::any_of(ctest_,
                               [&](const std::string& name) { return std::regex_search(name, wanted); });
  }

  [[nodiscard]] std::string fault(const reports::TheoremPointer& p, const std::string& command) const {
    if (!std::filesystem::exists(source_ / p.file)) return "no file " + p.file;
    const std::string text = contents_of(source_ / p.file);
    if (!std::regex_search(text,
                           std::regex("(^|\n)(Theorem|Lemma|Corollary|Proposition) " + p.name + "\\b"))) {
      return p.file + " has no theorem " + p.name;
    }
    const std::string listed = std::filesystem::path(p.file).stem().string() + "." + p.name;
    const std::vector<std::string> main = lines_of(contents_of(source_ / "proofs/main_theorems.txt"));
    if (std::ranges::find(main, listed) == main.end()) {
      return listed + " is not in proofs/main_theorems.txt: nobody asks what it rests on";
    }
    // Where proofs are not checked, as with sanitizers, CTest knows none of them.
    const bool proofs_on = std::ranges::find(ctest_, "proofs.nothing_assumed") != ctest_.end();
    return proofs_on && !selects_a_test(command) ? "selects no test: " + command : "";
  }

  [[nodiscard]] std::string fault(const reports::TestPointer&, const std::string& command) const {
    return selects_a_test(command) ? "" : "selects no test: " + command;
  }

  [[nodiscard]] std::string fault(const reports::WitnessPointer& p, const std::string& command) const {
    const Outcome run = run_gnomon({"replay", p.file, "--method", p.method}, source_);
    const std::vector<std::string> lines = lines_of(run.out);
    if (run.status != 0) return command + ": exit status " + std::to_string(run.status) + ", " + run.err;
    if (run.err.find(fmt::format("{} cases, {} with a stated answer, 0 of them wrong", lines.size(),
                                 lines.size())) == std::string::npos) {
      return command + ": " + run.err;
    }
    if (!p.line && lines.size() != 1) return fmt::format("{}: {} lines instead of 1", command, lines.size());
    const std::string where = p.line ? fmt::format("{}:{} ", p.file, *p.line) : "";
    const auto line = std::ranges::find_if(lines, [&](const std::string& l) { return l.starts_with(where); });
    if (line == lines.end()) return command + ": no case in line " + std::to_string(*p.line);
    const std::string said = fmt::format(" {} {} {} ", p.method, p.answer, p.exactly);
    return line->find(said) == std::string::npos ? command + " says " + *line + ", not" + said : "";
  }

  [[nodiscard]] std::string fault(const reports::CampaignPointer& p, const std::string& command) const {
    std::vector<std::string> words = lines_of(std::regex_replace(p.command, std::regex(" "), "\n"));
    const auto trials = std::ranges::find(words, "--trials");
    const auto seed = std::ranges::find(words, "--seed");
    if (words.size() < 3 || words[0] != "gnomon" || words[1] != "fuzz" || seed == words.end() ||
        trials == words.end() || trials + 1 == words.end()) {
      return command + ": expected gnomon fuzz QUESTION ... --trials N --seed S";
    }
    const std::uint64_t of_a_row = std::stoull(*(trials + 1));
    *(trials + 1) = std::to_string(p.subset);
    const Folder folder;
    words.erase(words.begin());
    words.insert(words.end(), {"--witnesses", "0", "--json", folder / "r.json"});
    const Outcome run = run_gnomon(words);
    if (run.status != 0) return command + ": exit status " + std::to_string(run.status) + ", " + run.err;
    const auto result = nlohmann::json::parse(contents_of(folder / "r.json"));
    std::uint64_t counted = 0, rows = 0;
    for (const auto& row : result.at("rows")) {
      if (!row.contains(p.counts)) return command + ": no row has a field " + p.counts;
      counted += row.at(p.counts).get<std::uint64_t>();
      ++rows;
    }
    if (rows * of_a_row != p.trials) return fmt::format("{}: these are {} trials", command, rows * of_a_row);
    if (p.subset > of_a_row || p.subset < 1000)
      return command + ": expected a subset of at least 1000 trials";
    if ((counted == 0) != (p.errors == 0)) {
      return fmt::format("{}: {} {} in {} trials a row, the ledger has {}", command, counted, p.counts,
                         p.subset, p.errors);
    }
    const double high = fuzz::rate_of(p.errors, p.trials).high95;
    return std::abs(high - p.high95) > 0.01 * high ? fmt::format("{}: the bound is {}", command, high) : "";
  }

  /// That its program is one of ours, and the test that it names, if any; what it prints depends on the
  /// machine.
  [[nodiscard]] std::string fault(const reports::MeasurementPointer& p, const std::string& command) const {
    const std::regex form(R"((?:[A-Z_]+=\S+ )*(\S+/)?(\w+)(?: .*)?)"), filter("--gtest_filter=(\\S+)");
    std::smatch words, test;
    if (!std::regex_match(command, words, form)) return command + ": expected [NAME=VALUE] PROGRAM ...";
    const std::string program = words[2];
    if (std::ranges::none_of(p.figures, [](char c) { return c >= '0' && c <= '9'; })) {
      return command + ": no figures";
    }
    if (std::regex_search(command, test, filter) &&
        std::ranges::find(ctest_, test[1].str()) == ctest_.end()) {
      return command + ": no test " + test[1].str();
    }
    for (const char* file : {"CMakeLists.txt", "tests/CMakeLists.txt", "reports/bench/CMakeLists.txt"}) {
      if (contents_of(source_ / file).find("add_executable(" + program + " ") != std::string::npos) return "";
    }
    return command + ": no program " + program;
  }

  std::filesystem::path source_;
  std::vector<std::string> ctest_;
};

}  // namespace gnomon::tests
