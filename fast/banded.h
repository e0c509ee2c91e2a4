// SPDX-License-Identifier: MIT
// An answer together with whether the thresholds vouch for it.
#pragma once

#include "fast/strict_float.h"
#include "scene/category.h"

namespace gnomon::fast {

/// `certain` says that no value fell within the band of its threshold; it means something only where the
/// shaft was made with proved thresholds. The answer alone is what the naive and certified tiers use,
/// `certain` tells the exact tier when to ask the exact predicate.
struct Banded {
  scene::Category answer;
  bool certain;
};

}  // namespace gnomon::fast
