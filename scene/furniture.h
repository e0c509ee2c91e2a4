// SPDX-License-Identifier: MIT
// Furniture that several built-in rooms share, in metres, each with its count of faces. Internal to scene/.
#pragma once

#include <cstddef>
#include <cstdint>

#include "scene/modeller.h"

namespace gnomon::scene {

inline constexpr std::size_t kBoxFaces = 12;
[[nodiscard]] constexpr std::size_t prism_faces(std::size_t corners) {
  return 4 * corners - 4;
}

/// A convex object of one box.
void add_box(Modeller& modeller, const char* name, const Point3& lo, const Point3& hi);

/// Floor, ceiling and four walls of a room, as slabs around the space from (0, 0, 0) to `size`: each is cut
/// into `cells` pieces a metre, or whole for 0.
void add_room(Modeller& modeller, const Placement& at, const Point3& size, std::uint32_t cells);
[[nodiscard]] std::size_t room_faces(const Point3& size, std::uint32_t cells);
inline constexpr double kWall = 0.125;  ///< how thick its slabs are

/// A board on four legs, centred on the origin.
void add_table(Modeller& modeller, const Placement& at, const Point3& size);
inline constexpr std::size_t kTableFaces = 5 * kBoxFaces;

/// Looking along y, centred on the origin.
void add_chair(Modeller& modeller, const Placement& at);
inline constexpr std::size_t kChairFaces = 8 * kBoxFaces;

/// On a column with five feet that turn; looking along y.
void add_swivel_chair(Modeller& modeller, const Placement& at);
inline constexpr std::size_t kSwivelChairFaces =
    3 * kBoxFaces + prism_faces(10) + prism_faces(8) + 5 * kBoxFaces;

/// Two metres high, one wide, the back to y = 0, open to y < 0, with four rows of books. `number` varies
/// them.
void add_bookshelf(Modeller& modeller, const Placement& at, std::uint64_t number);
inline constexpr std::uint32_t kShelves = 4, kBooks = 8;
inline constexpr std::size_t kBookshelfFaces = (3 + kShelves + 1 + kShelves * kBooks) * kBoxFaces;

/// A door in its frame before a wall along x, centred, seen from y < 0.
void add_door(Modeller& modeller, const Placement& at);
inline constexpr std::size_t kDoorFaces = 5 * kBoxFaces;

/// A pot with leaves.
void add_plant(Modeller& modeller, const Placement& at);
inline constexpr std::uint32_t kLeaves = 10;
inline constexpr std::size_t kPlantFaces = prism_faces(12) + prism_faces(6) + kLeaves * 4;

}  // namespace gnomon::scene
