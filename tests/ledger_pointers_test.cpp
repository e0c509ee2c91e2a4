// SPDX-License-Identifier: GPL-3.0-or-later
// No pointer of the ledger dangles; and the check that says so finds each kind of dangling pointer.
#include <gtest/gtest.h>

#include "ledger_pointer_check.h"
#include "reports/ledger.h"

namespace gnomon::tests {
namespace {

using reports::CampaignPointer;
using reports::ClaimPointer;
using reports::MeasurementPointer;
using reports::TestPointer;
using reports::TheoremPointer;
using reports::WitnessPointer;

const PointerCheck& check() {
  static const PointerCheck all(GNOMON_SOURCE_DIR, GNOMON_BUILD_DIR);
  return all;
}

TEST(LedgerPointers, EachLeadsToWhatTheLedgerSays) {
  ASSERT_GT(check().known_to_ctest().size(), 100u);
  std::size_t followed = 0;
  for (const reports::Claim& claim : reports::ledger()) {
    for (const ClaimPointer& pointer : claim.pointers) {
      EXPECT_EQ(check().fault_of(pointer), "") << claim.id;
      ++followed;
    }
  }
  EXPECT_GE(followed, 20u);
}

void expect_fault(const ClaimPointer& pointer, const std::string& expected) {
  const std::string fault = check().fault_of(pointer);
  EXPECT_NE(fault.find(expected), std::string::npos) << kind_of(pointer) << ": \"" << fault << "\"";
}

TEST(LedgerPointers, DanglingTheoremsAreFound) {
  const TheoremPointer good{"proofs/BoxTest.v", "box_test_is_exact"};
  EXPECT_EQ(check().fault_of(good), "");
  expect_fault(TheoremPointer{"proofs/BoxTests.v", good.name}, "no file proofs/BoxTests.v");
  expect_fault(TheoremPointer{good.file, "box_test_is"}, "has no theorem box_test_is");
  expect_fault(TheoremPointer{good.file, "near_reach"}, "has no theorem");  // there is one that uses it
  expect_fault(TheoremPointer{good.file, "crossing"}, "not in proofs/main_theorems.txt");
}

TEST(LedgerPointers, DanglingTestsAreFound) {
  EXPECT_EQ(check().fault_of(TestPointer{"LedgerPointers.DanglingTestsAreFound"}), "");
  EXPECT_EQ(check().fault_of(TestPointer{"CertifiedShaft.OverflowingPlanesAreDisarmed"}), "");  // typed
  expect_fault(TestPointer{"LedgerPointers.DanglingTests"}, "selects no test");
  expect_fault(TestPointer{"Pointers.DanglingTestsAreFound"}, "selects no test");
}

TEST(LedgerPointers, DanglingWitnessesAreFound) {
  const WitnessPointer good{"proofs/witnesses/S2b-box-within-a.txt", {}, "printed-f32", "overlap", "inside"};
  EXPECT_EQ(check().fault_of(good), "");
  const auto with = [&](auto member, const char* value) {
    WitnessPointer pointer = good;
    pointer.*member = value;
    return pointer;
  };
  expect_fault(with(&WitnessPointer::file, "proofs/witnesses/none.txt"), "none.txt");
  expect_fault(with(&WitnessPointer::file, "tests/corpus/shaft.txt"), "lines instead of 1");
  expect_fault(with(&WitnessPointer::method, "printed-f16"), "exit status 2");
  expect_fault(with(&WitnessPointer::method, "naive-f32"), "says");
  expect_fault(with(&WitnessPointer::answer, "outside"), "says");
  expect_fault(with(&WitnessPointer::exactly, "overlap"), "says");
  WitnessPointer with_line = good;
  with_line.line = 3;
  EXPECT_EQ(check().fault_of(with_line), "");
  with_line.line = 2;
  expect_fault(with_line, "no case in line 2");
}

TEST(LedgerPointers, DanglingCampaignsAreFound) {
  const CampaignPointer good{
      "gnomon fuzz shaft-box --method printed-f32 --distribution nested --trials 5000 --seed 3",
      "unsound",
      0,
      5000,
      fuzz::rate_of(0, 5000).high95,
      2000};
  EXPECT_EQ(check().fault_of(good), "");
  const auto with = [&](auto member, auto value) {
    CampaignPointer pointer = good;
    pointer.*member = value;
    return pointer;
  };
  const auto command = [&](const std::string& words) {
    return with(&CampaignPointer::command, "gnomon fuzz " + words + " --trials 5000 --seed 3");
  };
  expect_fault(command("shaft-cube"), "exit status 2");
  expect_fault(command("shaft-box --method printed-f16 --distribution nested"), "exit status 2");
  expect_fault(command("shaft-box --method printed-f32 --distribution nests"), "exit status 2");
  expect_fault(with(&CampaignPointer::command, "gnomon fuzz shaft-box"), "expected gnomon fuzz");
  expect_fault(with(&CampaignPointer::counts, "unsounds"), "no row has a field");
  expect_fault(with(&CampaignPointer::counts, "model"), "the ledger has 0");  // it calls inside overlap
  expect_fault(with(&CampaignPointer::errors, std::uint64_t{7}), "0 unsound in 2000 trials");
  expect_fault(with(&CampaignPointer::trials, std::uint64_t{50000}), "these are 5000 trials");
  expect_fault(with(&CampaignPointer::high95, 1e-9), "the bound is");
  expect_fault(with(&CampaignPointer::subset, std::uint64_t{6000}), "expected a subset");
}

TEST(LedgerPointers, DanglingMeasurementsAreFound) {
  const std::string bench = "build/release/reports/bench/gnomon_bench",
                    tests = "build/release/tests/gnomon_tests";
  EXPECT_EQ(check().fault_of(MeasurementPointer{bench + " table", "12 ns"}), "");
  EXPECT_EQ(check().fault_of(MeasurementPointer{
                "N=3 " + tests + " --gtest_filter=LedgerPointers.DanglingMeasurementsAreFound", "12"}),
            "");
  expect_fault(MeasurementPointer{bench + "es table", "12 ns"}, "no program");
  expect_fault(MeasurementPointer{bench + " table", "fast"}, "no figures");
  expect_fault(MeasurementPointer{tests + " --gtest_filter=LedgerPointers.Dangling", "12"}, "no test");
}

}  // namespace
}  // namespace gnomon::tests
