// SPDX-License-Identifier: MIT
// What making lists costs, the same on every machine.
#pragma once

#include <cstdint>

#include "fast/strict_float.h"

namespace gnomon::fast {

struct CullCounters {
  std::uint64_t lists = 0;            ///< lists made for receivers
  std::uint64_t items = 0;            ///< items on them
  std::uint64_t marks = 0;            ///< children marked outside
  std::uint64_t volumes = 0;          ///< items held against a shaft
  std::uint64_t comparisons = 0;      ///< of these volumes with the extent box or a reference box
  std::uint64_t planes = 0;           ///< planes evaluated, near and far corners apart
  std::uint64_t enclosures = 0;       ///< items held against a reference box for enclosing it
  std::uint64_t emitter_volumes = 0;  ///< items held against the emitter's box or plane for its list
  std::uint64_t back_faces = 0;       ///< primitives held against the emitter for facing away

  friend bool operator==(const CullCounters&, const CullCounters&) = default;
};

}  // namespace gnomon::fast
