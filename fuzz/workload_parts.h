// SPDX-License-Identifier: GPL-3.0-or-later
// Internal to fuzz/: the recorders that record_workload() chooses from.
#pragma once

#include <vector>

#include "fuzz/workload.h"

namespace gnomon::fuzz {

using Queries = std::vector<scene::ShadowQuery>;

[[nodiscard]] Queries record_primary(const scene::Scene&, const Oracle&, const WorkloadOptions&);
[[nodiscard]] Queries record_surface(const scene::Scene&, const Oracle&, const WorkloadOptions&);
[[nodiscard]] Queries record_light_rays(const scene::Scene&, const Oracle&, const WorkloadOptions&);
[[nodiscard]] Queries record_emitter(const scene::Scene&, const Oracle&, const WorkloadOptions&);
[[nodiscard]] Queries record_hard(const scene::Scene&, const Oracle&, const WorkloadOptions&);

}  // namespace gnomon::fuzz
