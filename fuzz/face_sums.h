// SPDX-License-Identifier: GPL-3.0-or-later
// How long lists of faces are, and by how much wrong: sums over trials.
#pragma once

#include <cstdint>

namespace gnomon::fuzz {

struct FaceSums {
  std::uint64_t in_truth = 0;  ///< faces that meet their shafts
  std::uint64_t listed = 0;    ///< faces that the method gave
  std::uint64_t missing = 0;   ///< in truth and not listed
  std::uint64_t excess = 0;    ///< listed and not in truth

  void add(const FaceSums& other) {
    in_truth += other.in_truth;
    listed += other.listed;
    missing += other.missing;
    excess += other.excess;
  }
  friend bool operator==(const FaceSums&, const FaceSums&) = default;
};

}  // namespace gnomon::fuzz
