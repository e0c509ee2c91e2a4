// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/claim_pointer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "reports/html_text.h"

namespace gnomon::reports {
namespace {

std::string theory_of(const TheoremPointer& theorem) {
  return std::filesystem::path(theorem.file).stem().string();
}

struct Words {
  std::string operator()(const TheoremPointer& p) const { return theory_of(p) + "." + p.name; }
  std::string operator()(const TestPointer& p) const { return p.name; }
  std::string operator()(const WitnessPointer& p) const {
    return fmt::format("{}{} says {}, {} it is {}", p.line ? fmt::format("line {}: ", *p.line) : "", p.method,
                       p.answer, p.answer == p.exactly ? "and exactly" : "exactly", p.exactly);
  }
  std::string operator()(const CampaignPointer& p) const {
    std::string counts = p.counts;
    std::ranges::replace(counts, '_', ' ');
    return fmt::format("{} {} in {} trials, rate {} {:.2g} (95 %)", thousands(p.errors), counts,
                       thousands(p.trials), p.errors == 0 ? "below" : "at most", p.high95);
  }
  std::string operator()(const MeasurementPointer& p) const { return p.figures; }
};

struct Command {
  std::string operator()(const TheoremPointer& p) const {
    return fmt::format("ctest --preset release -R '^proofs\\.{}$'", theory_of(p));
  }
  std::string operator()(const TestPointer& p) const {
    // CTest names a typed test Suite.Name<type>.
    const std::size_t dot = p.name.find('.');
    return fmt::format("ctest --preset release -R '^{}\\.{}(<.*>)?$'", p.name.substr(0, dot),
                       p.name.substr(dot + 1));
  }
  std::string operator()(const WitnessPointer& p) const {
    return fmt::format("gnomon replay {} --method {}", p.file, p.method);
  }
  std::string operator()(const CampaignPointer& p) const { return p.command; }
  std::string operator()(const MeasurementPointer& p) const { return p.command; }
};

}  // namespace

std::string_view kind_of(const ClaimPointer& pointer) {
  constexpr std::array<std::string_view, 5> kinds{"theorem", "test", "witness", "campaign", "measurement"};
  return kinds[pointer.index()];
}

std::string words_of(const ClaimPointer& pointer) {
  return std::visit(Words{}, pointer);
}

std::string command_of(const ClaimPointer& pointer) {
  return std::visit(Command{}, pointer);
}

}  // namespace gnomon::reports
