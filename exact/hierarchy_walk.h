// SPDX-License-Identifier: GPL-3.0-or-later
// The queries of exact/hierarchy.h, once an instruction set. Internal to exact/.
#pragma once

#include "exact/hierarchy.h"
#include "exact/hierarchy_build.h"

#if defined(__x86_64__)
#define GNOMON_EXACT_HAS_AVX2
#endif

namespace gnomon::exact {

/// What any machine that the compiler builds for can do.
namespace baseline {
[[nodiscard]] ShadowTruth shadow(const scene::Scene& scene, const BuiltHierarchy& built,
                                 const scene::ShadowQuery& query, HierarchyCounters* counters);
[[nodiscard]] FirstHit first_hit(const scene::Scene& scene, const BuiltHierarchy& built,
                                 const scene::RayQuery& ray, HierarchyCounters* counters);
}  // namespace baseline

#ifdef GNOMON_EXACT_HAS_AVX2
/// The same, bit for bit, for processors that have AVX2.
namespace avx2 {
[[nodiscard]] ShadowTruth shadow(const scene::Scene& scene, const BuiltHierarchy& built,
                                 const scene::ShadowQuery& query, HierarchyCounters* counters);
[[nodiscard]] FirstHit first_hit(const scene::Scene& scene, const BuiltHierarchy& built,
                                 const scene::RayQuery& ray, HierarchyCounters* counters);
}  // namespace avx2
#endif

}  // namespace gnomon::exact
