// SPDX-License-Identifier: GPL-3.0-or-later
// The registry of scene methods with other projects' methods beside ours.
#pragma once

#include <string>
#include <vector>

#include "fuzz/scene_method.h"

namespace gnomon::reports {

/// Our rows, then the peers that are built in. Peers promise nothing: their documentation states no bound.
[[nodiscard]] const std::vector<fuzz::SceneMethod>& all_scene_methods();

/// The rows by name, in the registry's order; all when `names` is empty. Throws std::runtime_error, with one
/// line that names the known ones.
[[nodiscard]] std::vector<const fuzz::SceneMethod*> choose_scene_methods(
    const std::vector<std::string>& names);

/// The further rows for workloads of radiosity, ours and other projects'.
[[nodiscard]] const std::vector<fuzz::SceneMethod>& all_radiosity_methods();

/// As choose_scene_methods(), from both lists: what `gnomon measure` takes.
[[nodiscard]] std::vector<const fuzz::SceneMethod*> choose_measured_methods(
    const std::vector<std::string>& names);

/// True when Embree's rows are built in.
[[nodiscard]] bool has_embree();

}  // namespace gnomon::reports
