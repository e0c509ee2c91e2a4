// SPDX-License-Identifier: GPL-3.0-or-later
// Our hierarchies as scene methods.
#pragma once

#include <memory>

#include "fuzz/scene_method.h"

namespace gnomon::fuzz {

/// fast::Hierarchy in its three tiers; the exact one hands what it leaves open to the predicates of exact/.
[[nodiscard]] std::unique_ptr<SceneCaster> make_naive_hierarchy(const scene::Scene& scene);
[[nodiscard]] std::unique_ptr<SceneCaster> make_certified_hierarchy(const scene::Scene& scene);
[[nodiscard]] std::unique_ptr<SceneCaster> make_exact_hierarchy(const scene::Scene& scene);

/// exact::Hierarchy, which judges all others: what its truth costs, touching included.
[[nodiscard]] std::unique_ptr<SceneCaster> make_reference(const scene::Scene& scene);

}  // namespace gnomon::fuzz
