// SPDX-License-Identifier: MIT
// Scenes from files: NFF, and the mesh formats.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <string_view>

#include "scene/loaded_scene.h"
#include "scene/mesh.h"

namespace gnomon::scene {

/// Reads a scene, by the file's extension in any case: .nff, or one of read_mesh()'s, which gives one opaque
/// object named after the file, without lights or view. The result is_valid(), its faces in the file's order.
/// Throws InputError, with one line, as read_mesh() does; nothing is allocated from counts that the file
/// claims.
[[nodiscard]] LoadedScene read_scene(const std::filesystem::path& path);

/// Neutral File Format: the records v, b, l (with or without a colour), f, c, s, p and pp, in any order, each
/// element on a line of its own as the format lays it out; '#' starts a comment. A file holds at most one v
/// and at least one face.
///
/// Kept: viewpoint, lights' positions, geometry, and transmittance, which must be from 0 to 1. Colours,
/// shading and normals must be finite numbers and are dropped. Each fill record starts an object; those with
/// faces are called "object 1", "object 2", ...; faces before any fill are opaque. The format's
/// polygons have one side, so all objects are one-sided. Polygons become what
/// triangulate() says; cones and cylinders 2 * kConeSides triangles without end caps, kConeSides when one
/// radius is 0. A negative radius (two for a cone), by which the format marks what is seen from within alone,
/// turns a cone's triangles over, and counts as positive for balls, which have no sides. Degenerate faces are
/// kept, but a cone's ends must differ.
///
/// Source: Haines, "A Proposal for Standard Graphics Environments", IEEE CG&A 7(11), 1987, and the file
/// NFF.TXT of the Standard Procedural Databases 3. `name` is what InputError calls the input.
[[nodiscard]] LoadedScene read_nff(std::istream& in, std::string_view name);

/// The mesh, which must be is_valid(), as one opaque object; polygons become what triangulate() says. Points
/// that no face uses are dropped.
[[nodiscard]] LoadedScene scene_of(const Mesh& mesh, std::string name);

}  // namespace gnomon::scene
