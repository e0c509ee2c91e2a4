// SPDX-License-Identifier: MIT
// Round temples, of long thin rectangles: columns of many sides around a cella, under a conical roof.
#include "scene/builtin_list.h"
#include "scene/furniture.h"
#include "scene/modeller.h"
#include "scene/turn.h"

namespace gnomon::scene {
namespace {

constexpr double kPitch = 24;
constexpr std::uint32_t kColumns = 20, kInnerColumns = 10, kShaftSides = 40, kWallBlocks = 40,
                        kDoorBlocks = 4, kRound = 48, kBeams = 20;

constexpr std::size_t kColumnFaces = prism_faces(kShaftSides) + prism_faces(16) + 12;
constexpr std::size_t kTempleFaces = 3 * prism_faces(kRound) + (kColumns + kInnerColumns) * kColumnFaces +
                                     12 * (kBeams + (kWallBlocks - kDoorBlocks)) + 12 + kBeams * 12 +
                                     prism_faces(kRound) + (2 * kRound - 2);

/// A column with its capital, from height `bottom` to `top`.
void add_column(Modeller& modeller, double radius, double bottom, double top) {
  modeller.object("shaft", Shape::convex);
  modeller.prism(regular_polygon(kShaftSides, radius), bottom, top - 0.375);
  modeller.object("capital", Shape::convex);
  modeller.prism(regular_polygon(16, radius + 0.125), top - 0.375, top - 0.1875);
  modeller.object("abacus", Shape::convex);
  modeller.box({-radius - 0.1875, -radius - 0.1875, top - 0.1875}, {radius + 0.1875, radius + 0.1875, top});
}

/// Blocks of a ring, each the part of it between two directions.
void add_ring(Modeller& modeller, const char* name, std::uint32_t first, std::uint32_t blocks,
              std::uint32_t around, double inner, double outer, double bottom, double top) {
  for (std::uint32_t k = first; k < first + blocks; ++k) {
    const Direction a = turn(k, around), b = turn(k + 1, around);
    const Point2 outline[] = {{inner * a.cos, inner * a.sin},
                              {outer * a.cos, outer * a.sin},
                              {outer * b.cos, outer * b.sin},
                              {inner * b.cos, inner * b.sin}};
    modeller.object(name, Shape::convex);
    modeller.prism(outline, bottom, top);
  }
}

void add_temple(Modeller& modeller, const Placement& at) {
  modeller.place(at);
  constexpr double kFloor = 0.9375, kTop = 6.9375, kEntablature = 8;
  for (std::uint32_t step = 0; step < 3; ++step) {
    modeller.object("step", Shape::convex);
    modeller.prism(regular_polygon(kRound, 7.5 - 0.375 * step), 0.3125 * step, 0.3125 * (step + 1));
  }
  for (std::uint32_t k = 0; k < kColumns; ++k) {
    const Direction d = turn(2 * k + 1, 2 * kColumns);
    modeller.place(within(at, {6 * d.cos, 6 * d.sin, 0, d.cos, d.sin}));
    add_column(modeller, 0.4375, kFloor, kTop);
  }
  for (std::uint32_t k = 0; k < kInnerColumns; ++k) {
    const Direction d = turn(2 * k + 1, 2 * kInnerColumns);
    modeller.place(within(at, {3.125 * d.cos, 3.125 * d.sin, 0, d.cos, d.sin}));
    add_column(modeller, 0.1875, kFloor, kTop);
  }
  modeller.place(at);
  add_ring(modeller, "architrave", 0, kBeams, kBeams, 5.5, 6.625, kTop, kTop + 0.5);
  add_ring(modeller, "frieze", 0, kBeams, kBeams, 5.625, 6.5, kTop + 0.5, kEntablature);
  // The door of the cella looks along x.
  add_ring(modeller, "cella wall", kDoorBlocks / 2, kWallBlocks - kDoorBlocks, kWallBlocks, 3.75, 4.25,
           kFloor, kTop);
  modeller.object("altar", Shape::convex);
  modeller.box({-0.5, -0.75, kFloor}, {0.5, 0.75, kFloor + 1});
  modeller.object("ceiling", Shape::convex);
  modeller.prism(regular_polygon(kRound, 6.75), kEntablature, kEntablature + 0.25);
  modeller.object("roof", Shape::convex);
  modeller.pyramid(regular_polygon(kRound, 7.125), kEntablature + 0.25, {0, 0, kEntablature + 2.75});
  modeller.place({});
}

Scene make(std::uint32_t size) {
  Modeller modeller(0x1p-10);
  const double side = kPitch * size;
  modeller.object("ground", Shape::convex);
  modeller.box({-kPitch, -kPitch, -0.5}, {side, side, 0});
  for (std::uint32_t row = 0; row < size; ++row) {
    for (std::uint32_t column = 0; column < size; ++column) {
      add_temple(modeller, {kPitch * column, kPitch * row});
    }
  }
  const double middle = kPitch * (size / 2);
  modeller.ceiling_light({middle - 0.5, middle - 0.5}, {middle + 0.5, middle + 0.5}, 6.5);
  modeller.ceiling_light({middle + 16, middle - 20}, {middle + 20, middle - 16}, 24);
  modeller.view({middle + 15, middle - 9, 5}, {middle, middle, 4.25}, 50);
  return modeller.finish();
}

}  // namespace

BuiltinScene temple_scene() {
  return {"temple",
          "round temples of long thin rectangles, with a lamp inside and a bright patch of sky",
          "temples along each side of the ground",
          "ID images, \"Greek Temple\" (7778 faces)",
          1,
          25,
          [](std::uint32_t size) { return 12 + kTempleFaces * size * size; },
          make};
}

}  // namespace gnomon::scene
