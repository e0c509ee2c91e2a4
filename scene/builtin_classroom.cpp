// SPDX-License-Identifier: MIT
// A classroom: rows of desks with chairs before a blackboard, under six lights.
#include <algorithm>

#include "scene/builtin_list.h"
#include "scene/furniture.h"
#include "scene/variation.h"

namespace gnomon::scene {
namespace {

constexpr double kBayX = 1.5, kBayY = 1.25, kHeight = 3.25;

constexpr std::size_t kPlaceFaces =
    kTableFaces + kChairFaces + 2 * kBoxFaces + prism_faces(6);  // books, pencil
constexpr std::size_t kFrontFaces = kTableFaces + kChairFaces + 6 * kBoxFaces + kDoorFaces +
                                    2 * kBookshelfFaces;  // blackboard, podium, clock
constexpr std::size_t kWindowFaces = 6 * kBoxFaces;       // one a row

Point3 room_of(std::uint32_t size) {
  return {kBayX * size + 1.5, kBayY * size + 3.5, kHeight};
}

/// The front of the room is at y = 0; pupils look there.
void add_place(Modeller& modeller, std::uint32_t column, std::uint32_t row, std::uint32_t size) {
  const Placement at{0.75 + kBayX * (column + 0.5), 2.75 + kBayY * (row + 0.5), 0, -1, 0};
  const std::uint64_t number = 4 * (std::uint64_t{row} * size + column);
  add_table(modeller, at, {1.125, 0.5, 0.71875});
  // Some chairs are pushed in further than others.
  add_chair(modeller, within(at, {0.125 * varied(number) - 0.0625, -0.375 + 0.1875 * varied(number + 1), 0}));
  modeller.place(at);
  add_box(modeller, "book", {-0.375, -0.125, 0.71875}, {-0.1875, 0.125, 0.75});
  add_box(modeller, "notebook", {-0.0625, -0.1875, 0.71875}, {0.15625, 0.125, 0.7265625});
  modeller.place(within(at, {0.25, 0.0625 * varied(number + 2), 0.71875}));
  modeller.object("pencil cup", Shape::convex);
  modeller.prism(regular_polygon(6, 0.03125), 0, 0.09375);
}

void add_front(Modeller& modeller, const Point3& room) {
  const double middle = room[0] / 2;
  modeller.place({middle, 0, 0});
  add_box(modeller, "podium", {-1.375, 0, 0}, {1.375, 1.75, 0.1875});
  add_box(modeller, "blackboard", {-1.25, 0, 1.125}, {1.25, 0.03125, 2.375});
  add_box(modeller, "chalk tray", {-1.25, 0.03125, 1.0625}, {1.25, 0.125, 1.09375});
  add_box(modeller, "board edge", {-1.25, 0, 2.375}, {1.25, 0.0625, 2.4375});
  add_box(modeller, "clock", {-0.1875, 0, 2.625}, {0.1875, 0.0625, 3});
  add_box(modeller, "sponge", {-0.875, 0.046875, 1.09375}, {-0.75, 0.109375, 1.140625});
  add_table(modeller, {middle + 0.25, 1.25, 0.1875}, {1.5, 0.75, 0.75});
  add_chair(modeller, {middle + 0.25, 0.75, 0.1875});
  add_door(modeller, {room[0], 1.125, 0, 0, -1});
  add_bookshelf(modeller, {0.75, room[1], 0}, 1);
  add_bookshelf(modeller, {room[0] - 0.75, room[1], 0}, 2);
}

/// A blind window: frame, cross bars and sill on the wall at x = 0.
void add_window(Modeller& modeller, double y) {
  modeller.place({0, y, 0});
  add_box(modeller, "window frame", {0, -0.5, 0.9375}, {0.0625, -0.4375, 2.5});
  add_box(modeller, "window frame", {0, 0.4375, 0.9375}, {0.0625, 0.5, 2.5});
  add_box(modeller, "window frame", {0, -0.4375, 2.4375}, {0.0625, 0.4375, 2.5});
  add_box(modeller, "window bar", {0, -0.4375, 1.71875}, {0.046875, 0.4375, 1.75});
  add_box(modeller, "window sill", {0, -0.5625, 0.90625}, {0.1875, 0.5625, 0.9375});
  add_box(modeller, "heater", {0.03125, -0.4375, 0.125}, {0.125, 0.4375, 0.75});
}

Scene make(std::uint32_t size) {
  Modeller modeller(0x1p-10);
  const Point3 room = room_of(size);
  add_room(modeller, {}, room, 0);
  add_front(modeller, room);
  for (std::uint32_t row = 0; row < size; ++row) {
    for (std::uint32_t column = 0; column < size; ++column) add_place(modeller, column, row, size);
    add_window(modeller, 2.75 + kBayY * (row + 0.5));
  }
  modeller.place({});
  for (std::uint32_t k = 0; k < 6; ++k) {
    const double x = room[0] * (k % 2 == 0 ? 0.25 : 0.75), y = room[1] * (k / 2 + 0.5) / 3;
    const double wide = room[0] / 12, deep = room[1] / 48;
    modeller.ceiling_light({x - wide, y - deep}, {x + wide, y + deep}, kHeight - 0.125);
  }
  modeller.view({room[0] - 0.75, std::min(room[1] - 0.75, 10.0), 2.25}, {room[0] / 2 - 0.5, 1.5, 0.75}, 60);
  return modeller.finish();
}

}  // namespace

BuiltinScene classroom_scene() {
  return {"classroom",
          "desks and chairs before a blackboard, under six polygon lights, each with a point light",
          "desks along each side of the room",
          "ID images, \"Classroom\" (3138 faces)",
          5,
          80,
          [](std::uint32_t size) {
            return room_faces(room_of(size), 0) + kPlaceFaces * size * size + kWindowFaces * size +
                   kFrontFaces;
          },
          make};
}

}  // namespace gnomon::scene
