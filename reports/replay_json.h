// SPDX-License-Identifier: GPL-3.0-or-later
// The result file of a replay.
#pragma once

#include <string>

#include "fuzz/replay.h"

namespace gnomon::reports {

/// {"schema": 1, "kind": "replay", "lines": [...], "wrong_answers": [...]}. Ends with a newline.
[[nodiscard]] std::string replay_json(const fuzz::ReplayResult& result);

}  // namespace gnomon::reports
