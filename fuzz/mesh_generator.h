// SPDX-License-Identifier: GPL-3.0-or-later
// The distribution `mesh:FILE`: boxes and balls of a bounding hierarchy of a real mesh.
#pragma once

#include <memory>
#include <string>

#include "fuzz/generator.h"

namespace gnomon::fuzz {

/// A and B are nodes of the tree of like depth; T is a node anywhere, a node on the way to a point between A
/// and B, or a relative of A: what a traversal asks. Boxes are bitwise those of the tree, so shared sides are
/// common. Throws scene::InputError for a file that can't be read, UsageError for coordinates beyond the
/// scalar's range.
template <class Case, class F>
[[nodiscard]] std::unique_ptr<Generator<Case>> make_mesh_generator(const std::string& file);

}  // namespace gnomon::fuzz
