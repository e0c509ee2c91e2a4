// SPDX-License-Identifier: GPL-3.0-or-later
// Replaying lines of the question `shadow`, and what methods may be held to.
#pragma once

#include <span>

#include "fuzz/replay.h"
#include "fuzz/scene_method.h"
#include "scene/corpus.h"

namespace gnomon::fuzz {

/// True when the verdict breaks the promise; what is rejected breaks none.
[[nodiscard]] bool is_broken(Promise promise, Verdict verdict);

/// True when all numbers of the scene's faces are floats, and balls stay within their range.
[[nodiscard]] bool are_floats(const scene::Scene& scene);

/// True when the method takes a scene with such faces and numbers: methods of floats those that are floats,
/// with balls that stay within their range.
[[nodiscard]] bool is_in_domain(const SceneMethod& method, const scene::Scene& scene,
                                const scene::ShadowQuery& query);

/// Appends what each of the methods says of the line's case. The truth is found face by face and by the exact
/// hierarchy. Throws scene::InputError for a line that is no case, std::logic_error when the two references
/// differ.
void replay_shadow(const scene::CorpusLine& line, std::span<const SceneMethod* const> methods,
                   ReplayResult& result);

}  // namespace gnomon::fuzz
