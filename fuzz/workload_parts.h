// SPDX-License-Identifier: GPL-3.0-or-later
// Internal to fuzz/: the recorders that record_workload() chooses from.
#pragma once

#include <array>
#include <vector>

#include "fuzz/random.h"
#include "fuzz/workload.h"

namespace gnomon::fuzz {

using Queries = std::vector<scene::ShadowQuery>;

[[nodiscard]] Queries record_primary(const scene::Scene&, const Oracle&, const WorkloadOptions&);
[[nodiscard]] Queries record_surface(const scene::Scene&, const Oracle&, const WorkloadOptions&);
[[nodiscard]] Queries record_light_rays(const scene::Scene&, const Oracle&, const WorkloadOptions&);
[[nodiscard]] Queries record_emitter(const scene::Scene&, const Oracle&, const WorkloadOptions&);
[[nodiscard]] Queries record_hard(const scene::Scene&, const Oracle&, const WorkloadOptions&);

using Rays = std::vector<scene::RayQuery>;

[[nodiscard]] Rays record_primary_rays(const scene::Scene&, const WorkloadOptions&);
[[nodiscard]] Rays record_hard_rays(const scene::Scene&, const WorkloadOptions&);

/// The point with each coordinate, a float, moved by up to so many floats.
[[nodiscard]] std::array<double, 3> nudged(const std::array<double, 3>& point, CaseRandom& random, int most);

}  // namespace gnomon::fuzz
