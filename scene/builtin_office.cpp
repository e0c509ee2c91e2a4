// SPDX-License-Identifier: MIT
// An office with ten area lights, in two meshings of the same geometry.
#include <algorithm>

#include "scene/builtin_list.h"
#include "scene/furniture.h"

namespace gnomon::scene {
namespace {

constexpr double kBay = 3, kHeight = 2.75;
constexpr std::uint32_t kFineCells = 2;  // a metre

constexpr std::size_t kDeskFaces = 8 * kBoxFaces;
constexpr std::size_t kOnDeskFaces =
    11 * kBoxFaces + 2 * prism_faces(12) + kBoxFaces + 14;  // screen to books, cup and lamp
constexpr std::size_t kBayFaces =
    kDeskFaces + kOnDeskFaces + kSwivelChairFaces + prism_faces(12) + kBoxFaces;  // bin, partition

/// Its user sits at y < 0 and looks along y.
void add_desk(Modeller& modeller, const Placement& at) {
  modeller.place(at);
  add_box(modeller, "desk top", {-0.75, 0, 0.703125}, {0.75, 0.75, 0.734375});
  for (const double x : {-0.71875, 0.6875}) {
    add_box(modeller, "desk side", {x, 0.03125, 0}, {x + 0.03125, 0.71875, 0.703125});
  }
  add_box(modeller, "desk back", {-0.6875, 0.6875, 0.25}, {0.6875, 0.703125, 0.703125});
  add_box(modeller, "drawers", {0.28125, 0.0625, 0.046875}, {0.6875, 0.65625, 0.703125});
  for (const double z : {0.15625, 0.375, 0.59375}) {
    add_box(modeller, "handle", {0.421875, 0.046875, z}, {0.546875, 0.0625, z + 0.015625});
  }
}

void add_on_desk(Modeller& modeller, const Placement& desk) {
  const Placement at = within(desk, {0, 0, 0.734375});
  modeller.place(at);
  add_box(modeller, "screen foot", {-0.109375, 0.421875, 0}, {0.109375, 0.59375, 0.015625});
  add_box(modeller, "screen neck", {-0.03125, 0.5, 0.015625}, {0.03125, 0.53125, 0.15625});
  add_box(modeller, "screen", {-0.265625, 0.453125, 0.15625}, {0.265625, 0.5, 0.484375});
  add_box(modeller, "keyboard", {-0.234375, 0.09375, 0}, {0.21875, 0.25, 0.015625});
  add_box(modeller, "mouse", {0.28125, 0.125, 0}, {0.34375, 0.21875, 0.03125});
  for (const double z : {0.0, 0.0625})
    add_box(modeller, "tray", {0.4375, 0.375, z}, {0.6875, 0.6875, z + 0.015625});
  for (std::uint32_t k = 0; k < 4; ++k) {
    const double x = -0.6875 + 0.046875 * k;
    add_box(modeller, "folder", {x, 0.421875, 0}, {x + 0.0390625, 0.6875, 0.28125 + 0.015625 * (k % 3)});
  }
  modeller.place(within(at, {-0.375, 0.3125, 0}));
  modeller.object("cup", Shape::convex);
  modeller.prism(regular_polygon(12, 0.0390625), 0, 0.09375);
  modeller.place(within(at, {-0.4375, 0.5625, 0}));
  modeller.object("lamp foot", Shape::convex);
  modeller.prism(regular_polygon(12, 0.0703125), 0, 0.015625);
  add_box(modeller, "lamp pole", {-0.0078125, -0.0078125, 0.015625}, {0.0078125, 0.0078125, 0.375});
  modeller.object("lamp shade", Shape::convex);
  modeller.pyramid(regular_polygon(8, 0.09375), 0.375, {0, 0, 0.5});
}

/// Bays turn their backs to each other in pairs of rows.
void add_bay(Modeller& modeller, std::uint32_t column, std::uint32_t row) {
  const bool away = row % 2 == 1;
  const Placement bay{0.5 + kBay * (column + 0.5), 0.5 + kBay * (row + 0.5), 0, away ? -1.0 : 1.0, 0};
  const Placement desk = within(bay, {0, 0.5, 0});
  add_desk(modeller, desk);
  add_on_desk(modeller, desk);
  // Nobody leaves a chair straight: turned to either side by the angle whose sine is 3/5 or 5/13.
  const bool much = (row + 2 * column) % 3 == 0;
  const double way = column % 2 == 0 ? 1 : -1;
  add_swivel_chair(
      modeller, within(bay, {0.0625 * way, 0.125, 0, much ? 0.8 : 12.0 / 13, way * (much ? 0.6 : 5.0 / 13)}));
  modeller.place(within(bay, {-1, 0.75, 0}));
  modeller.object("bin", Shape::convex);
  modeller.prism(regular_polygon(12, 0.140625), 0, 0.3125);
  modeller.place(bay);
  add_box(modeller, "partition", {-1.375, 1.3125, 0.0625}, {1.375, 1.359375, 1.5});
}

Point3 room_of(std::uint32_t size) {
  return {kBay * size + 1, kBay * size + 1.5, kHeight};
}

Scene make(std::uint32_t size, std::uint32_t cells) {
  Modeller modeller(0x1p-10);
  const Point3 room = room_of(size);
  add_room(modeller, {}, room, cells);
  for (std::uint32_t row = 0; row < size; ++row) {
    for (std::uint32_t column = 0; column < size; ++column) add_bay(modeller, column, row);
  }
  for (std::uint32_t k = 0; k < size; ++k) {
    add_bookshelf(modeller, {1.5 + kBay * k, room[1] - 0.0625, 0}, k);
    add_bookshelf(modeller, {2.75 + kBay * k, room[1] - 0.0625, 0}, size + k);
  }
  add_door(modeller, {room[0], 0.75, 0, 0, -1});
  add_plant(modeller, {0.375, room[1] - 0.5, 0});
  modeller.place({});
  // Two rows of five lights, just below the ceiling, that take the same share of it whatever its size.
  for (std::uint32_t k = 0; k < 10; ++k) {
    const double x = room[0] * (k % 5 + 0.5) / 5, y = room[1] * (k / 5 == 0 ? 0.25 : 0.75);
    const double wide = room[0] / 24, deep = room[1] / 12;
    modeller.ceiling_light({x - wide, y - deep}, {x + wide, y + deep}, kHeight - 0.015625);
  }
  modeller.view({0.375, 0.25, 2}, {std::min(room[0], 4.5), std::min(room[1], 5.0), 0.75}, 70);
  return modeller.finish();
}

std::size_t faces(std::uint32_t size, std::uint32_t cells) {
  return room_faces(room_of(size), cells) + kBayFaces * size * size + 2 * size * kBookshelfFaces +
         kDoorFaces + kPlantFaces;
}

constexpr std::uint32_t kDefault = 2, kLargest = 60;

}  // namespace

BuiltinScene office_scene() {
  return {"office",
          "an office with ten polygon lights, and a point light at the middle of each; walls whole",
          "workplaces along each side of the room",
          "shaft culling, the office before meshing (906 polygons, 10 area lights)",
          kDefault,
          kLargest,
          [](std::uint32_t size) { return faces(size, 0); },
          [](std::uint32_t size) { return make(size, 0); }};
}

BuiltinScene office_fine_scene() {
  return {"office-fine",
          "the same office; floor, ceiling and walls cut into squares of about half a metre",
          "workplaces along each side of the room",
          "shaft culling, the premeshed office (2563 polygons, 10 area lights)",
          kDefault,
          kLargest,
          [](std::uint32_t size) { return faces(size, kFineCells); },
          [](std::uint32_t size) { return make(size, kFineCells); }};
}

}  // namespace gnomon::scene
