// SPDX-License-Identifier: MIT
// Living rooms: a sofa and armchairs around a table of glass, shelves, a dining table, lamps.
#include "scene/builtin_list.h"
#include "scene/furniture.h"

namespace gnomon::scene {
namespace {

constexpr Point3 kRoom{6, 5, 2.5};
constexpr double kGap = 2 * kWall + 0.0625;  // rooms stand apart, so that no two walls have a face in common

constexpr std::size_t kSofaFaces = 7 * kBoxFaces, kArmchairFaces = 5 * kBoxFaces;
constexpr std::size_t kLampFaces = prism_faces(12) + prism_faces(6) + prism_faces(12);
constexpr std::size_t kVaseRings = 6, kVaseSides = 12;
constexpr std::size_t kVaseFaces = 2 * kVaseSides * (kVaseRings - 1) + 2 * (kVaseSides - 2);
constexpr std::size_t kRoomFaces = 6 * kBoxFaces + kSofaFaces + 2 * kArmchairFaces +
                                   5 * kBoxFaces                // glass table
                                   + 4 * kBoxFaces              // television
                                   + kBoxFaces + 4 * kBoxFaces  // rug, pictures
                                   + kBookshelfFaces + kTableFaces + 4 * kChairFaces + kLampFaces +
                                   kVaseFaces + 1 + kDoorFaces + kPlantFaces;

/// Looking along y, the back to y = 0, `width` wide between the arms, with that many cushions.
void add_seat(Modeller& modeller, const Placement& at, double width, std::uint32_t cushions) {
  modeller.place(at);
  const double x = width / 2;
  add_box(modeller, "base", {-x, 0.1875, 0.0625}, {x, 0.875, 0.3125});
  add_box(modeller, "backrest", {-x, 0, 0.0625}, {x, 0.1875, 0.84375});
  add_box(modeller, "arm", {-x - 0.1875, 0, 0}, {-x, 0.875, 0.59375});
  add_box(modeller, "arm", {x, 0, 0}, {x + 0.1875, 0.875, 0.59375});
  for (std::uint32_t k = 0; k < cushions; ++k) {
    const double left = -x + width * k / cushions;
    add_box(modeller, "cushion", {left + 0.0078125, 0.1875, 0.3125},
            {left + width / cushions - 0.0078125, 0.890625, 0.453125});
  }
}

void add_glass_table(Modeller& modeller, const Placement& at) {
  modeller.place(at);
  modeller.object("glass", Shape::convex, 0.75);
  modeller.box({-0.5625, -0.3125, 0.40625}, {0.5625, 0.3125, 0.421875});
  for (const double x : {-0.5, 0.4375}) {
    for (const double y : {-0.25, 0.1875})
      add_box(modeller, "table leg", {x, y, 0}, {x + 0.0625, y + 0.0625, 0.40625});
  }
}

void add_living_room(Modeller& modeller, double x, double y) {
  const Placement room{x, y};
  const auto at = [&room](double u, double v, double cos = 1, double sin = 0) {
    return within(room, {u, v, 0, cos, sin});
  };
  add_room(modeller, room, kRoom, 0);
  add_seat(modeller, at(2, 0.0625), 1.875, 3);
  add_seat(modeller, at(0.5, 2.625, 0.8, -0.6), 0.625, 1);
  add_seat(modeller, at(3.75, 2.25, 0.28, 0.96), 0.625, 1);
  add_glass_table(modeller, at(2, 1.625));
  modeller.place(room);
  add_box(modeller, "rug", {0.75, 0.9375, 0}, {3.25, 2.4375, 0.015625});
  add_box(modeller, "low board", {1.125, kRoom[1] - 0.4375, 0}, {2.875, kRoom[1], 0.46875});
  add_box(modeller, "screen foot", {1.75, 4.65625, 0.46875}, {2.25, 4.90625, 0.484375});
  add_box(modeller, "screen neck", {1.9375, 4.765625, 0.484375}, {2.0625, 4.796875, 0.59375});
  add_box(modeller, "screen", {1.375, 4.75, 0.59375}, {2.625, 4.8125, 1.28125});
  for (const double u : {1.125, 2.125}) {
    add_box(modeller, "picture", {u, 0, 1.3125}, {u + 0.75, 0.03125, 1.8125});
    add_box(modeller, "picture", {0, u + 1.5, 1.25}, {0.03125, u + 2, 1.875});
  }
  add_bookshelf(modeller, at(3.6875, kRoom[1]), 7);
  add_table(modeller, at(5, 3.75), {0.875, 1.375, 0.75});
  for (const double v : {3.4375, 4.0625}) {
    add_chair(modeller, at(4.53125, v, 0, -1));
    add_chair(modeller, at(5.46875, v, 0, 1));
  }
  modeller.place(at(5, 3.6875));
  modeller.object("vase", Shape::concave);
  constexpr Point2 kVase[kVaseRings] = {{0.0625, 0.75},      {0.109375, 0.84375}, {0.09375, 0.9375},
                                        {0.0390625, 1.0625}, {0.046875, 1.125},   {0.0625, 1.15625}};
  modeller.turned(kVase, kVaseSides);
  modeller.object("bowl", Shape::convex);
  modeller.ball({0, 0.3125, 0.84375}, 0.09375);
  modeller.place(at(0.4375, 0.5));
  modeller.object("lamp foot", Shape::convex);
  modeller.prism(regular_polygon(12, 0.15625), 0, 0.03125);
  modeller.object("lamp pole", Shape::convex);
  modeller.prism(regular_polygon(6, 0.015625), 0.03125, 1.6875);
  modeller.object("lamp shade", Shape::convex);
  modeller.prism(regular_polygon(12, 0.1875), 1.6875, 1.71875);
  add_door(modeller, at(kRoom[0], 0.9375, 0, -1));
  add_plant(modeller, at(5.5625, 2.25));
  modeller.place({});
}

Scene make(std::uint32_t size) {
  Modeller modeller(0x1p-10);
  for (std::uint32_t row = 0; row < size; ++row) {
    for (std::uint32_t column = 0; column < size; ++column) {
      add_living_room(modeller, (kRoom[0] + kGap) * column, (kRoom[1] + kGap) * row);
    }
  }
  // The first room is lit: from the ceiling, and above the standing lamp.
  modeller.ceiling_light({1.625, 1.875}, {2.375, 2.375}, kRoom[2] - 0.0625);
  modeller.ceiling_light({4.6875, 3.4375}, {5.3125, 4.0625}, kRoom[2] - 0.5);
  modeller.point_light({0.4375, 0.5, 1.875});
  modeller.view({5.75, 0.25, 2}, {1.75, 2.75, 0.625}, 65);
  return modeller.finish();
}

}  // namespace

BuiltinScene living_room_scene() {
  return {"living-room",
          "furnished rooms, the first lit by two polygon lights with a point light each and a standing lamp",
          "rooms along each side",
          "ID images, \"Living-Room\" (288 faces)",
          1,
          40,
          [](std::uint32_t size) { return kRoomFaces * size * size; },
          make};
}

}  // namespace gnomon::scene
