// SPDX-License-Identifier: MIT
// Polygon meshes as every reader gives them: points and faces, nothing else.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gnomon::scene {

/// A polygon soup in two flat lists. Face f has the corners corners[offsets[f]] .. corners[offsets[f + 1] -
/// 1], each an index into points, in the file's order. Degenerate, non-planar, duplicate and inconsistently
/// turned faces are kept, and so are points that no face uses.
struct Mesh {
  std::vector<std::array<double, 3>> points;
  std::vector<std::uint32_t> corners;
  std::vector<std::size_t> offsets{0};

  [[nodiscard]] std::size_t face_count() const { return offsets.empty() ? 0 : offsets.size() - 1; }

  /// The corners of face f; f must be below face_count().
  [[nodiscard]] std::span<const std::uint32_t> face(std::size_t f) const {
    return {corners.data() + offsets[f], offsets[f + 1] - offsets[f]};
  }

  /// Ends the face whose corners were appended to `corners` since the last call.
  void end_face() { offsets.push_back(corners.size()); }

  friend bool operator==(const Mesh&, const Mesh&) = default;
};

/// Corners are 32-bit, so no mesh has more points than this.
inline constexpr std::size_t kMaxMeshPoints = 0xffff'ffff;

/// True when there is at least one face, every face has at least 3 corners, every corner is the index of a
/// point and every coordinate is finite: what the readers promise and all users ask of a mesh. Takes time
/// linear in its size.
[[nodiscard]] inline bool is_valid(const Mesh& mesh) {
  if (mesh.face_count() == 0 || mesh.offsets.front() != 0 || mesh.offsets.back() != mesh.corners.size())
    return false;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    if (mesh.offsets[f + 1] < mesh.offsets[f] || mesh.offsets[f + 1] - mesh.offsets[f] < 3) return false;
  }
  for (const std::uint32_t corner : mesh.corners) {
    if (corner >= mesh.points.size()) return false;
  }
  for (const auto& p : mesh.points) {
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2])) return false;
  }
  return true;
}

}  // namespace gnomon::scene
