// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/tally.h"

namespace gnomon::fuzz {

void LargestGap::offer(const exact::Gap& gap, std::uint64_t trial) {
  const exact::Gap size = abs(gap);
  if (known_) {
    const int order = cmp(size, exact::Gap(abs(gap_)));
    if (order < 0 || (order == 0 && trial >= trial_)) return;
  }
  known_ = true;
  gap_ = gap;
  trial_ = trial;
  approximate_ = size.get_d();  // rounds towards zero
}

void Tally::add(const Tally& other, std::size_t keep) {
  trials += other.trials;
  for (std::size_t truth = 0; truth < kTruths; ++truth) {
    for (std::size_t answer = 0; answer < kColumns; ++answer)
      matrix[truth][answer] += other.matrix[truth][answer];
  }
  touching_outside += other.touching_outside;
  touching_inside += other.touching_inside;
  unsound_touching += other.unsound_touching;
  rounding += other.rounding;
  model += other.model;
  rounding_and_model += other.rounding_and_model;
  threshold_checked += other.threshold_checked;
  threshold_exceeded += other.threshold_exceeded;
  for (std::size_t fault = 0; fault < kFaults; ++fault) {
    for (const std::uint64_t trial : other.faults[fault].trials()) faults[fault].offer(trial, keep);
  }
  if (other.largest.known()) largest.offer(other.largest.gap(), other.largest.trial());
  faces.add(other.faces);
  ns += other.ns;
}

}  // namespace gnomon::fuzz
