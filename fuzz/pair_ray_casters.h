// SPDX-License-Identifier: GPL-3.0-or-later
// fast::PairCaster as methods that are asked pair by pair, in its three tiers.
#pragma once

#include <memory>

#include "fuzz/scene_method.h"

namespace gnomon::fuzz {

[[nodiscard]] std::unique_ptr<SceneCaster> make_naive_pair_caster(const scene::Scene& scene);
[[nodiscard]] std::unique_ptr<SceneCaster> make_certified_pair_caster(const scene::Scene& scene);
[[nodiscard]] std::unique_ptr<SceneCaster> make_exact_pair_caster(const scene::Scene& scene);

}  // namespace gnomon::fuzz
