// SPDX-License-Identifier: GPL-3.0-or-later
// The verb that draws the shadows of scenes: render.
#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace gnomon::reports {

/// Adds the verb; once it is parsed, `run` is set to what it does and returns the exit status.
void add_render_verb(CLI::App& app, std::function<int()>& run);

}  // namespace gnomon::reports
