// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/claim_status.h"

#include <array>

namespace gnomon::reports {

std::span<const ClaimStatus> claim_statuses() {
  static constexpr std::array kAll{ClaimStatus::proved,  ClaimStatus::confirmed,  ClaimStatus::refuted,
                                   ClaimStatus::erratum, ClaimStatus::reproduced, ClaimStatus::open};
  return kAll;
}

std::string_view name_of(ClaimStatus status) {
  constexpr std::array<std::string_view, 6> names{"proved",  "confirmed",  "refuted",
                                                  "erratum", "reproduced", "open"};
  return names[static_cast<std::size_t>(status)];
}

std::string_view meaning_of(ClaimStatus status) {
  switch (status) {
    case ClaimStatus::proved:
      return "a theorem that Coq checks, an enumeration of all inputs or, where the claim is that there are "
             "such "
             "cases, one of them, exactly";
    case ClaimStatus::confirmed:
      return "at least 10 million exact trials over all distributions, the hard ones included, on code whose "
             "mutants are killed, without a counterexample; the 95 % upper bound stands beside it";
    case ClaimStatus::refuted:
      return "there is a witness that anybody can replay; the note says what has to be true for the claim to "
             "hold";
    case ClaimStatus::erratum:
      return "what is printed is wrong; the note says what was built instead, and there is a witness against "
             "the printed form";
    case ClaimStatus::reproduced:
      return "the paper's figures stand next to ours on a comparable scene, each marked same or opposite in "
             "direction, with the ratio";
    case ClaimStatus::open:
      return "not settled yet";
  }
  return "";
}

std::optional<ClaimStatus> status_of(std::string_view name) {
  for (const ClaimStatus status : claim_statuses()) {
    if (name_of(status) == name) return status;
  }
  return std::nullopt;
}

}  // namespace gnomon::reports
