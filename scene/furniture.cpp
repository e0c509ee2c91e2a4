// SPDX-License-Identifier: MIT
#include "scene/furniture.h"

#include <array>

#include "scene/turn.h"
#include "scene/variation.h"

namespace gnomon::scene {
namespace {

struct Slab {
  const char* name;
  Point3 lo, hi;
};

/// Walls stand between floor and ceiling, those across y between the others.
std::array<Slab, 6> slabs_of(const Point3& s) {
  constexpr double t = kWall;
  return {{{"floor", {-t, -t, -t}, {s[0] + t, s[1] + t, 0}},
           {"ceiling", {-t, -t, s[2]}, {s[0] + t, s[1] + t, s[2] + t}},
           {"wall", {-t, -t, 0}, {0, s[1] + t, s[2]}},
           {"wall", {s[0], -t, 0}, {s[0] + t, s[1] + t, s[2]}},
           {"wall", {0, -t, 0}, {s[0], 0, s[2]}},
           {"wall", {0, s[1], 0}, {s[0], s[1] + t, s[2]}}}};
}

std::array<std::uint32_t, 3> cells_of(const Slab& slab, std::uint32_t cells) {
  std::array<std::uint32_t, 3> counts{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double length = slab.hi[k] - slab.lo[k];
    counts[k] = cells == 0 || length < 2 * kWall ? 1 : static_cast<std::uint32_t>(length * cells);
  }
  return counts;
}

}  // namespace

void add_box(Modeller& modeller, const char* name, const Point3& lo, const Point3& hi) {
  modeller.object(name, Shape::convex);
  modeller.box(lo, hi);
}

void add_room(Modeller& modeller, const Placement& at, const Point3& size, std::uint32_t cells) {
  modeller.place(at);
  for (const Slab& slab : slabs_of(size)) {
    modeller.object(slab.name, Shape::convex);
    modeller.meshed_box(slab.lo, slab.hi, cells_of(slab, cells));
  }
}

std::size_t room_faces(const Point3& size, std::uint32_t cells) {
  std::size_t faces = 0;
  for (const Slab& slab : slabs_of(size)) {
    const auto [x, y, z] = cells_of(slab, cells);
    faces += 4 * (std::size_t{x} * y + std::size_t{y} * z + std::size_t{z} * x);
  }
  return faces;
}

void add_table(Modeller& modeller, const Placement& at, const Point3& size) {
  modeller.place(at);
  const double x = size[0] / 2, y = size[1] / 2, under = size[2] - 0.03125;
  add_box(modeller, "table top", {-x, -y, under}, {x, y, size[2]});
  for (const double u : {-x + 0.0625, x - 0.125}) {
    for (const double v : {-y + 0.0625, y - 0.125}) {
      add_box(modeller, "table leg", {u, v, 0}, {u + 0.0625, v + 0.0625, under});
    }
  }
}

void add_chair(Modeller& modeller, const Placement& at) {
  modeller.place(at);
  add_box(modeller, "seat", {-0.21875, -0.21875, 0.4375}, {0.21875, 0.21875, 0.46875});
  add_box(modeller, "back", {-0.21875, -0.21875, 0.625}, {0.21875, -0.1875, 0.875});
  for (const double x : {-0.203125, 0.171875}) {
    add_box(modeller, "back post", {x, -0.21875, 0.46875}, {x + 0.03125, -0.1875, 0.625});
    for (const double y : {-0.203125, 0.171875}) {
      add_box(modeller, "chair leg", {x, y, 0}, {x + 0.03125, y + 0.03125, 0.4375});
    }
  }
}

void add_swivel_chair(Modeller& modeller, const Placement& at) {
  modeller.place(at);
  add_box(modeller, "seat", {-0.234375, -0.234375, 0.4375}, {0.234375, 0.234375, 0.5});
  add_box(modeller, "back bar", {-0.03125, -0.265625, 0.4375}, {0.03125, -0.234375, 0.75});
  add_box(modeller, "back", {-0.21875, -0.234375, 0.59375}, {0.21875, -0.171875, 1});
  // Column, hub and feet are one object, of several solids.
  modeller.object("chair foot", Shape::concave);
  modeller.prism(regular_polygon(8, 0.03125), 0.125, 0.4375);
  modeller.prism(regular_polygon(10, 0.0625, true), 0.0625, 0.125);
  for (std::uint32_t k = 0; k < 5; ++k) {
    const Direction d = turn(k, 5);
    modeller.place(within(at, {0, 0, 0, d.cos, d.sin}));
    modeller.box({0.0625, -0.01953125, 0.03125}, {0.3125, 0.01953125, 0.09375});
  }
}

void add_bookshelf(Modeller& modeller, const Placement& at, std::uint64_t number) {
  modeller.place(at);
  constexpr double kBoard = 0.03125, kHeight = 2, kDepth = 0.3125, kPitch = 0.46875;
  add_box(modeller, "shelf side", {-0.5, -kDepth, 0}, {-0.5 + kBoard, 0, kHeight});
  add_box(modeller, "shelf side", {0.5 - kBoard, -kDepth, 0}, {0.5, 0, kHeight});
  add_box(modeller, "shelf back", {-0.5 + kBoard, -kBoard / 2, 0.0625}, {0.5 - kBoard, 0, kHeight});
  for (std::uint32_t shelf = 0; shelf <= kShelves; ++shelf) {
    const double z = 0.0625 + kPitch * shelf;
    add_box(modeller, "shelf", {-0.5 + kBoard, -kDepth, z}, {0.5 - kBoard, -kBoard / 2, z + kBoard});
    if (shelf == kShelves) break;
    double x = -0.4375;
    for (std::uint32_t book = 0; book < kBooks; ++book) {
      const std::uint64_t n = 64 * number + kBooks * shelf + book;
      const double thick = 0.03125 + 0.0625 * varied(3 * n), height = 0.25 + 0.125 * varied(3 * n + 1);
      add_box(modeller, "book", {x, -0.28125 + 0.0625 * varied(3 * n + 2), z + kBoard},
              {x + thick, -0.0625, z + kBoard + height});
      x += thick + 0.00390625;
    }
  }
}

void add_door(Modeller& modeller, const Placement& at) {
  modeller.place(at);
  add_box(modeller, "door", {-0.4375, -0.03125, 0}, {0.4375, 0, 2});
  add_box(modeller, "door frame", {-0.5, -0.0625, 0}, {-0.4375, 0, 2.0625});
  add_box(modeller, "door frame", {0.4375, -0.0625, 0}, {0.5, 0, 2.0625});
  add_box(modeller, "door frame", {-0.4375, -0.0625, 2}, {0.4375, 0, 2.0625});
  add_box(modeller, "door handle", {0.25, -0.09375, 1}, {0.375, -0.03125, 1.03125});
}

void add_plant(Modeller& modeller, const Placement& at) {
  modeller.place(at);
  modeller.object("pot", Shape::convex);
  modeller.prism(regular_polygon(12, 0.15625), 0, 0.3125);
  modeller.object("stem", Shape::convex);
  modeller.prism(regular_polygon(6, 0.015625), 0.3125, 0.625);
  for (std::uint32_t k = 0; k < kLeaves; ++k) {
    const Direction d = turn(k, kLeaves), side{-0.0625 * d.sin, 0.0625 * d.cos};
    const double high = 0.75 + 0.0625 * (k % 3), far = 0.3125 + 0.03125 * (k % 2);
    // A leaf is a thin tetrahedron: its upper and lower ridges cross.
    const Point3 root{0.03125 * d.cos, 0.03125 * d.sin, 0.5625}, tip{far * d.cos, far * d.sin, high};
    const Point3 left{far / 2 * d.cos + side.cos, far / 2 * d.sin + side.sin, high - 0.0625};
    const Point3 right{far / 2 * d.cos - side.cos, far / 2 * d.sin - side.sin, high - 0.0625};
    modeller.object("leaf", Shape::convex);
    modeller.tetrahedron(root, tip, right, left);
  }
}

}  // namespace gnomon::scene
