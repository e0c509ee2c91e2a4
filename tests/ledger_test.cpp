// SPDX-License-Identifier: GPL-3.0-or-later
// The ledger holds every claim, says what a status asks for, and is printed and refused as it should be.
#include "reports/ledger.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "cli_run.h"
#include "reports/ledger_text.h"
#include "scene/input_error.h"

namespace gnomon::tests {
namespace {

using reports::Claim;
using reports::ClaimStatus;
using reports::ledger;

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// True when a witness of the claim shows somebody wrong, or a test does.
bool shows_an_error(const Claim& claim) {
  return std::ranges::any_of(claim.pointers, [](const auto& p) {
    const auto* witness = std::get_if<reports::WitnessPointer>(&p);
    return witness ? witness->answer != witness->exactly : std::holds_alternative<reports::TestPointer>(p);
  });
}

template <class Pointer>
bool points_to(const Claim& claim) {
  return std::ranges::any_of(claim.pointers,
                             [](const auto& p) { return std::holds_alternative<Pointer>(p); });
}

/// A claim is there once, or in parts a, b, ... without a gap.
TEST(Ledger, HoldsEveryClaimOfThePapersOnce) {
  std::map<std::string, std::string> parts;
  std::set<std::string> expected, found;
  for (const reports::Paper& paper : reports::papers()) {
    for (unsigned n = 1; n <= paper.claims; ++n) expected.insert(paper.letter + std::to_string(n));
  }
  for (const Claim& claim : ledger()) {
    const std::string whole(claim.whole());
    found.insert(whole);
    parts[whole] += claim.id.size() > whole.size() ? claim.id.substr(whole.size()) : ".";
  }
  EXPECT_EQ(found, expected);
  EXPECT_EQ(found.size(), 67u);
  for (const auto& [whole, letters] : parts) {
    if (letters == ".") continue;
    EXPECT_EQ(letters, std::string("abcdefghijklmnopqrstuvwxyz").substr(0, letters.size())) << whole;
    EXPECT_GE(letters.size(), 2u) << whole;
  }
}

/// Each status comes with the kind of pointer that its meaning asks for.
TEST(Ledger, StatusesComeWithWhatTheyAskFor) {
  for (const Claim& claim : ledger()) {
    EXPECT_TRUE(claim.text.size() > 15 && claim.text.ends_with('.')) << claim.id;
    EXPECT_TRUE(claim.note.empty() || claim.note.ends_with('.')) << claim.id;
    for (const ClaimStatus status : {claim.status, claim.status_f32}) {
      const bool wrong = status == ClaimStatus::refuted || status == ClaimStatus::erratum;
      if (status == ClaimStatus::proved) {
        EXPECT_TRUE(points_to<reports::TheoremPointer>(claim) || points_to<reports::TestPointer>(claim))
            << claim.id;
      }
      if (wrong) {
        EXPECT_TRUE(shows_an_error(claim)) << claim.id;
        EXPECT_NE(claim.note, "") << claim.id << " does not say what holds instead";
      }
      if (status == ClaimStatus::confirmed) {
        EXPECT_TRUE(std::ranges::any_of(claim.pointers, [](const auto& p) {
          const auto* campaign = std::get_if<reports::CampaignPointer>(&p);
          return campaign && campaign->errors == 0 && campaign->trials >= 10000000;
        })) << claim.id;
      }
    }
  }
}

/// Fails when proofs/CLAIMS.md was not written again after a change:
/// build/release/gnomon claims --markdown > proofs/CLAIMS.md
TEST(Ledger, TheCommittedDocumentIsWhatIsGeneratedNow) {
  const Outcome run = run_gnomon({"claims", "--markdown"});
  EXPECT_EQ(run.status, 0);
  EXPECT_TRUE(run.out == contents_of(GNOMON_SOURCE_DIR "/proofs/CLAIMS.md"))
      << "write it again: build/release/gnomon claims --markdown > proofs/CLAIMS.md";
  for (const ClaimStatus status : reports::claim_statuses()) {
    EXPECT_TRUE(has(run.out, "| " + std::string(name_of(status)) + " | ")) << name_of(status);
  }
}

/// The binary needs no source tree: what it prints anywhere is the file, with a command for each pointer.
TEST(Ledger, JsonIsTheFileWithCommands) {
  const Folder elsewhere;
  const Outcome run = run_gnomon({"claims", "--json"}, elsewhere.path());
  ASSERT_EQ(run.status, 0);
  const auto file = nlohmann::json::parse(contents_of(GNOMON_SOURCE_DIR "/proofs/claims.json"));
  auto printed = nlohmann::json::parse(run.out);
  ASSERT_EQ(printed.size(), file.size());
  for (std::size_t i = 0; i < file.size(); ++i) {
    for (std::size_t k = 0; k < printed[i]["pointer"].size(); ++k) {
      auto& pointer = printed[i]["pointer"][k];
      EXPECT_NE(pointer.at("command").get<std::string>(), "");
      if (!file[i]["pointer"][k].contains("command")) pointer.erase("command");
    }
    EXPECT_EQ(printed[i], file[i]);
  }
}

std::vector<std::string> ids_of(const std::vector<std::string>& arguments) {
  std::vector<std::string> words{"claims", "--json"}, ids;
  words.insert(words.end(), arguments.begin(), arguments.end());
  const Outcome run = run_gnomon(words);
  EXPECT_EQ(run.status, 0) << run.err;
  for (const auto& claim : nlohmann::json::parse(run.out)) ids.push_back(claim.at("id"));
  return ids;
}

TEST(Ledger, ClaimsAreChosenByIdPaperAndStatus) {
  using Ids = std::vector<std::string>;
  EXPECT_EQ(ids_of({"S2", "L3"}), (Ids{"S2a", "S2b", "L3"}));
  EXPECT_EQ(ids_of({"S2b"}), Ids{"S2b"});
  EXPECT_EQ(ids_of({"S2", "--status", "erratum"}), Ids{"S2b"});
  EXPECT_EQ(ids_of({"S2", "--status", "refuted"}), Ids{"S2a"});  // in float32
  EXPECT_EQ(ids_of({"--paper", "id-images"}).size(), 10u);
  EXPECT_EQ(ids_of({"--paper", "id-images", "--paper", "voxel-occlusion"}).size(), 24u);
  EXPECT_EQ(ids_of({"L3", "--paper", "id-images"}), Ids{});
  EXPECT_EQ(ids_of({}).size(), ledger().size());
}

TEST(Ledger, TheTableShowsStatusesTextAndCommands) {
  const Outcome run = run_gnomon({"claims", "S2b"});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(lines_of(run.out).at(1).rfind("S2b   erratum     erratum     ", 0), 0u) << run.out;
  EXPECT_TRUE(has(run.out, "gnomon replay proofs/witnesses/S2b-box-within-a.txt --method printed-f32"));
  EXPECT_TRUE(has(run.out, "ctest --preset release -R '^proofs\\.BoxTest$'"));
  EXPECT_TRUE(has(run.out, "1 entry; exact: 1 erratum; float32: 1 erratum\n"));
}

TEST(Ledger, BadCallsAreRefusedInOneLine) {
  for (const auto& [words, expected] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"X9"}, "expected ids of claims (S1 to S25, L1 to L18, I1 to I10, V1 to V14), found \"X9\""},
           {{"S1", "S26"}, "found \"S26\""},
           {{"s1"}, "found \"s1\""},
           {{"S"}, "found \"S\""},
           {{""}, "expected a value"},
           {{"--paper", "shafts"}, "--paper: expected one of shaft-culling, "},
           {{"--status", "true"}, "--status: expected one of proved, "},
           {{"--json", "--markdown"}, "found both"},
       }) {
    std::vector<std::string> all{"claims"};
    all.insert(all.end(), words.begin(), words.end());
    const Outcome run = run_gnomon(all);
    EXPECT_EQ(run.status, 2) << words.back();
    EXPECT_EQ(run.out, "") << words.back();
    EXPECT_EQ(lines_of(run.err).size(), 1u) << run.err;
    EXPECT_TRUE(has(run.err, expected)) << run.err;
  }
}

/// One good entry, with a part of it replaced.
std::string entry_with(const std::string& what, const std::string& by) {
  std::string text = R"([{"id": "S1", "paper": "shaft-culling", "text": "T.", "status": "proved",
    "status_f32": "open", "pointer": [{"kind": "test", "name": "Suite.Name"}]}])";
  const std::size_t at = text.find(what);
  return text.replace(at, what.size(), by);
}

TEST(Ledger, WhatIsNoLedgerIsRefusedByPlace) {
  EXPECT_EQ(reports::read_ledger(entry_with("T.", "T."), "f").size(), 1u);
  for (const auto& [text, expected] : std::vector<std::pair<std::string, std::string>>{
           {"[{", "expected JSON"},
           {"{}", "expected an array"},
           {entry_with("\"S1\"", "\"S26\""), "S1 to S25"},
           {entry_with("\"S1\"", "\"L1\""), "S1 to S25"},
           {entry_with("\"S1\"", "\"S01\""), "S1 to S25"},
           {entry_with("\"S1\"", "\"S1ab\""), "S1 to S25"},
           {entry_with("\"S1\"", "1"), "id"},
           {entry_with("shaft-culling", "shaft"), "shaft-culling, "},
           {entry_with("proved", "true"), "proved, confirmed"},
           {entry_with("\"status_f32\": \"open\",", ""), "status_f32"},
           {entry_with("status_f32", "status_f16"), "one of the fields"},
           {entry_with("\"test\"", "\"tset\""), "theorem, test, witness"},
           {entry_with("Suite.Name", "Suite"), "Suite.Name"},
           {entry_with("\"name\"", "\"nom\""), "one of the fields"},
           {entry_with(R"({"kind": "test", "name": "Suite.Name"})", ""), "a pointer for what is not open"},
       }) {
    try {
      (void)reports::read_ledger(text, "the file");
      ADD_FAILURE() << "taken: " << text;
    } catch (const scene::InputError& error) {
      const std::string message = error.what();
      EXPECT_EQ(message.rfind("the file: expected", 0), 0u) << message;
      EXPECT_TRUE(has(message, expected)) << message;
      EXPECT_FALSE(has(message, "\n")) << message;
    }
  }
  const std::string once = entry_with("T.", "T.");
  const std::string twice = once.substr(0, once.size() - 1) + "," + once.substr(1);
  EXPECT_THROW((void)reports::read_ledger(twice, "the file"), scene::InputError);
}

}  // namespace
}  // namespace gnomon::tests
