// SPDX-License-Identifier: GPL-3.0-or-later
// How long the searches of the proofs_*_test.cpp files run.
#pragma once

#include <cstdint>
#include <cstdlib>

#include "tests/shaft_random.h"

namespace gnomon::tests {

/// The number of trials that the environment asks for by GNOMON_SEARCH_TRIALS, else what a build can afford
/// of `otherwise`.
inline std::uint64_t search_trials(int otherwise) {
  const char* const asked = std::getenv("GNOMON_SEARCH_TRIALS");
  const std::uint64_t trials = asked == nullptr ? 0 : std::strtoull(asked, nullptr, 10);
  return trials > 0 ? trials : static_cast<std::uint64_t>(affordable(otherwise));
}

}  // namespace gnomon::tests
