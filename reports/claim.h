// SPDX-License-Identifier: GPL-3.0-or-later
// One entry of the ledger: what a paper claims, and what became of it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "reports/claim_pointer.h"
#include "reports/claim_status.h"

namespace gnomon::reports {

struct Claim {
  std::string id;                              ///< "S1", or "S2a" for a part of S2
  std::string paper;                           ///< id of the paper, e.g. "shaft-culling"
  std::string text;                            ///< what is claimed, in our words
  ClaimStatus status = ClaimStatus::open;      ///< in exact arithmetic
  ClaimStatus status_f32 = ClaimStatus::open;  ///< in float32
  std::string note;                            ///< choices made, conditions, bounds; may be empty
  std::vector<ClaimPointer> pointers;

  /// The claim that this is, or is a part of: "S2" for "S2a".
  [[nodiscard]] std::string_view whole() const;
  [[nodiscard]] bool settled() const {
    return status != ClaimStatus::open || status_f32 != ClaimStatus::open;
  }
};

inline std::string_view Claim::whole() const {
  const std::string_view all = id;
  return all.substr(0, all.find_last_not_of("abcdefghijklmnopqrstuvwxyz") + 1);
}

}  // namespace gnomon::reports
