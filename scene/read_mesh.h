// SPDX-License-Identifier: MIT
// Mesh files: OFF, OBJ, PLY and STL.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string_view>

#include "scene/mesh.h"

namespace gnomon::scene {

/// Reads a mesh, by the file's extension in any case: .off, .obj, .ply or .stl; the reader then checks the
/// contents' own first words, where the format has some. The result is_valid(); points, faces and corners are
/// in the file's order. Text numbers are rounded once, to the nearest double.
///
/// Throws InputError, with one line "FILE:LINE: expected ..., found ..." (binary: "FILE: ... at byte N"), for
/// every input that is not a whole and well-formed mesh of at least one face: also for NaN, infinity, numbers
/// that overflow, indices out of range, faces of under 3 corners, too few and too many lines, an unknown
/// extension, no such file, a directory. Memory is bounded by what the file holds, never by what its header
/// claims.
[[nodiscard]] Mesh read_mesh(const std::filesystem::path& path);

/// True when the path ends in one of read_mesh()'s extensions, in any case.
[[nodiscard]] bool has_mesh_extension(const std::filesystem::path& path);

/// Text OFF with at most one vertex or face a line: OFF, and with N, C, ST before it (normals, colours,
/// texture coordinates; up to 9 extra numbers after x y z and up to 4 after a face are read and dropped,
/// under plain OFF too).
/// '#' starts a comment. The counts stand on the header's line or the next one; the number of edges may be
/// left out. Refused: homogeneous (4OFF), n-dimensional (nOFF) and binary OFF, and a missing header word.
/// Source: Geomview manual, "OFF Files". `name` is what InputError calls the input, here and below.
[[nodiscard]] Mesh read_off(std::istream& in, std::string_view name);

/// Wavefront OBJ: v (x y z, then nothing, w, r g b, or r g b a; what follows z is dropped) and f (v, v/vt,
/// v/vt/vn or v//vn; negative counts back from the last vertex; forward references are allowed). All other
/// statements of the format are skipped; so free-form curves and surfaces, lines and points give no faces.
/// Refused: unknown keywords, and `call` and `csh`, which would bring in more than this file. A backslash at
/// the end of a line continues it (complaints name the last of such lines). '#' starts a comment. vt and vn
/// indices need only be integers but 0. Source: Wavefront, "Advanced Visualizer Manual", appendix B1 (Object
/// Files).
[[nodiscard]] Mesh read_obj(std::istream& in, std::string_view name);

/// PLY 1.0, ascii (one item a line), binary_little_endian or binary_big_endian. Coordinates are the
/// properties x, y, z of `vertex`, faces the list vertex_indices or vertex_index of `face`; other properties
/// and elements are skipped. A property holds what its declared type can: a `float` written in ascii is
/// rounded once, to the nearest float, so that a mesh reads the same from ascii and binary. Anything after
/// the last item is refused: it means that header and body disagree. Source: Turk, "The PLY Polygon File
/// Format" (1994).
[[nodiscard]] Mesh read_ply(std::istream& in, std::string_view name);

/// STL, text or binary. Binary is a stream of exactly 84 + 50 n bytes, n as stored at byte 80, whatever its
/// first word; text begins with "solid" and holds no zero byte. Points are merged when all three coordinates
/// are equal (-0 equals 0), in order of first use; normals, attributes and the borders between several solids
/// are dropped. Text keywords may be in any case. The stream must be seekable. Source: 3D Systems,
/// "StereoLithography Interface Specification" (1989).
[[nodiscard]] Mesh read_stl(std::istream& in, std::string_view name);

}  // namespace gnomon::scene
