// SPDX-License-Identifier: GPL-3.0-or-later
// Contacts on edges and vertices, and whether the faces that share one close around the path. Internal to
// exact/.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "exact/contact.h"

namespace gnomon::exact {

/// Gathers the contacts of one path with triangles on their borders. Every triangle that shares the vertex
/// or the edge of a contact, and does not contain the path's direction, has a contact there too: what a query
/// gathers is all that can close around it. Allocates nothing before the first contact.
class BorderContacts {
 public:
  BorderContacts(const scene::Scene& scene, const Path& path) : scene_(scene), path_(path) {}

  /// Adds an on_edge or on_vertex contact.
  void add(std::uint32_t triangle, Contact contact);
  void clear();

  /// True when some contact added so far is sealed: seen along the path, the triangles added on the same
  /// edge lie on two sides of it, or those added on the same vertex cover a full turn around it.
  [[nodiscard]] bool any_sealed() const;

 private:
  /// The corners of one triangle by index: `shared` names the edge (less first) or the vertex (twice).
  struct Border {
    std::uint32_t shared[2];
    std::uint32_t others[2];  ///< of an edge, the opposite corner (twice)

    [[nodiscard]] bool is_vertex() const { return shared[0] == shared[1]; }
  };

  [[nodiscard]] int turn(std::uint32_t apex, std::uint32_t a, std::uint32_t b) const;
  [[nodiscard]] bool two_sides(std::size_t begin, std::size_t end) const;
  [[nodiscard]] bool full_turn(std::size_t begin, std::size_t end) const;

  const scene::Scene& scene_;
  const Path& path_;
  mutable std::vector<Border> borders_;
};

}  // namespace gnomon::exact
