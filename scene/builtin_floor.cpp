// SPDX-License-Identifier: MIT
// An unfurnished floor of a building: rooms with doors and windows along corridors.
#include "scene/builtin_list.h"
#include "scene/furniture.h"
#include "scene/variation.h"

namespace gnomon::scene {
namespace {

constexpr double kWide = 4, kDeep = 5, kCorridor = 2, kThick = 0.125, kHeight = 3;
constexpr double kPitchX = kWide + kThick, kPitchY = kDeep + kCorridor + 2 * kThick;

constexpr std::size_t kOneRoomFaces = (4 + 1 + 3 + 3 + 1 + 1 + 1 + 4) * kBoxFaces + prism_faces(8);
constexpr std::size_t kRowFaces = 2 * kBoxFaces;
constexpr std::size_t kHouseFaces = 3 * kBoxFaces;

/// A room from (0, 0) to (kWide, kDeep), with its left, front and back wall. Its door is at the back, to the
/// corridor; what it has at the front is a window, to the corridor before it or to the street.
void add_one_room(Modeller& modeller, const Placement& at, std::uint64_t number) {
  modeller.place(at);
  const auto wall = [&modeller](const Point3& lo, const Point3& hi) { add_box(modeller, "wall", lo, hi); };
  wall({-kThick, -kThick, 0}, {0, kDeep + kThick, kHeight});
  // Around the window.
  wall({0, -kThick, 0}, {1, 0, kHeight});
  wall({3, -kThick, 0}, {kWide, 0, kHeight});
  wall({1, -kThick, 0}, {3, 0, 1});
  wall({1, -kThick, 2.375}, {3, 0, kHeight});
  // Around the door.
  wall({0, kDeep, 0}, {0.75, kDeep + kThick, kHeight});
  wall({1.75, kDeep, 0}, {kWide, kDeep + kThick, kHeight});
  wall({0.75, kDeep, 2.125}, {1.75, kDeep + kThick, kHeight});
  add_box(modeller, "door frame", {0.75, kDeep, 0}, {0.8125, kDeep + kThick, 2.125});
  add_box(modeller, "door frame", {1.6875, kDeep, 0}, {1.75, kDeep + kThick, 2.125});
  add_box(modeller, "door frame", {0.8125, kDeep, 2.0625}, {1.6875, kDeep + kThick, 2.125});
  add_box(modeller, "heater", {1.125, 0.0625, 0.125}, {2.875, 0.1875, 0.75});
  add_box(modeller, "beam", {0, kDeep / 2 - 0.125, kHeight - 0.25}, {kWide, kDeep / 2 + 0.125, kHeight});
  add_box(modeller, "window frame", {1, -0.09375, 1}, {1.0625, -0.03125, 2.375});
  add_box(modeller, "window frame", {2.9375, -0.09375, 1}, {3, -0.03125, 2.375});
  add_box(modeller, "window frame", {1.0625, -0.09375, 1}, {2.9375, -0.03125, 1.0625});
  add_box(modeller, "window frame", {1.0625, -0.09375, 2.3125}, {2.9375, -0.03125, 2.375});
  // A column in a corner.
  modeller.place(within(at, {0.3125, 0.3125, 0}));
  modeller.object("column", Shape::convex);
  modeller.prism(regular_polygon(8, 0.1875, true), 0, kHeight);
  // The door, into the room and more or less open, on a hinge at its frame.
  constexpr double kOpen[4][2] = {{0.96, -0.28}, {0.8, -0.6}, {0.6, -0.8}, {0, -1}};
  const double* const open = kOpen[scrambled(number) % 4];
  modeller.place(within(at, {0.828125, kDeep - 0.0078125, 0, open[0], open[1]}));
  add_box(modeller, "door", {0, -0.046875, 0.0078125}, {0.84375, 0, 2.046875});
}

Scene make(std::uint32_t size) {
  Modeller modeller(0x1p-10);
  const double wide = kPitchX * size, deep = kPitchY * size;
  // Large slabs that all walls stand between.
  add_box(modeller, "floor", {-2 * kThick, -2 * kThick, -0.25}, {wide + kThick, deep + kThick, 0});
  add_box(modeller, "ceiling", {-2 * kThick, -2 * kThick, kHeight},
          {wide + kThick, deep + kThick, kHeight + 0.25});
  for (std::uint32_t row = 0; row < size; ++row) {
    for (std::uint32_t column = 0; column < size; ++column) {
      add_one_room(modeller, {kPitchX * column, kPitchY * row}, std::uint64_t{row} * size + column);
    }
    // The right end of the rooms, and of the corridor behind them; its left end is open.
    const double y = kPitchY * row;
    modeller.place({});
    add_box(modeller, "wall", {wide - kThick, y - kThick, 0}, {wide, y + kDeep + kThick, kHeight});
    add_box(modeller, "wall", {wide - kThick, y + kDeep + kThick, 0}, {wide, y + kPitchY - kThick, kHeight});
  }
  modeller.place({});
  add_box(modeller, "wall", {-kThick, deep - kThick, 0}, {wide, deep, kHeight});
  // One light in each corridor and in a room of each row.
  for (std::uint32_t row = 0; row < size; ++row) {
    const double y = kPitchY * row, x = kPitchX * (row % size) + kWide / 2;
    modeller.ceiling_light({x - 0.5, y + 1}, {x + 0.5, y + 1.5}, kHeight - 0.0625);
    modeller.ceiling_light({wide / 2 - 1, y + kDeep + 1}, {wide / 2 + 1, y + kDeep + 1.25}, kHeight - 0.0625);
  }
  modeller.view({0.25, kDeep + kThick + 1, 1.75}, {kPitchX, kDeep + 1, 1.25}, 75);
  return modeller.finish();
}

}  // namespace

BuiltinScene floor_scene() {
  return {"floor",
          "unfurnished rooms with doors along corridors; polygon lights, each with a point light",
          "rooms along each side",
          "ID images, \"Floor\" (4578 faces)",
          6,
          80,
          [](std::uint32_t size) { return kOneRoomFaces * size * size + kRowFaces * size + kHouseFaces; },
          make};
}

}  // namespace gnomon::scene
