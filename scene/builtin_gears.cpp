// SPDX-License-Identifier: MIT
// Layers of gears in mesh, on common axles.
#include "scene/builtin_list.h"
#include "scene/modeller.h"
#include "scene/turn.h"

namespace gnomon::scene {
namespace {

constexpr std::uint32_t kTeeth = 20;  // a multiple of 4: a tooth or a gap to all four sides
constexpr std::size_t kCorners = 4 * kTeeth, kAxleSides = 12;
constexpr std::size_t kGearFaces = 4 * kCorners - 4, kAxleFaces = 4 * kAxleSides - 4;

/// Teeth that take 60 % of the pitch at the root and 24 % at the tip: at the pitch radius 1, where those of
/// two gears meet, there is room left.
std::vector<Point2> outline(bool gap_first) {
  constexpr std::uint64_t kParts = 50;  // of a pitch
  constexpr double kRoot = 0.875, kTip = 1.0625;
  std::vector<Point2> corners;
  for (std::uint64_t tooth = 0; tooth < kTeeth; ++tooth) {
    const std::uint64_t middle = kParts * (tooth + kTeeth) + (gap_first ? kParts / 2 : 0);
    const auto add = [&](std::uint64_t part, double radius) {
      const Direction d = turn(part % (kParts * kTeeth), kParts * kTeeth);
      corners.push_back({radius * d.cos, radius * d.sin});
    };
    add(middle - 15, kRoot);
    add(middle - 6, kTip);
    add(middle + 6, kTip);
    add(middle + 15, kRoot);
  }
  return corners;
}

Scene make(std::uint32_t size) {
  Modeller modeller(0x1p-12);
  const std::vector<Point2> outlines[] = {outline(false), outline(true)};
  const std::vector<Point2> axle = regular_polygon(kAxleSides, 0.1875);
  for (std::uint32_t layer = 0; layer < size; ++layer) {
    for (std::uint32_t row = 0; row < size; ++row) {
      for (std::uint32_t column = 0; column < size; ++column) {
        modeller.place({2.0 * column, 2.0 * row, layer * 1.0});
        modeller.object("gear", Shape::concave);
        modeller.prism(outlines[(row + column) % 2], 0, 0.5);
        modeller.object("axle", Shape::convex);
        modeller.prism(axle, 0.5, 1);
      }
    }
  }
  modeller.place({});
  const double side = 2.0 * size;
  modeller.point_light({-side, -side, 2 * side});
  modeller.point_light({side, -side, 1.5 * side});
  modeller.point_light({side / 2, side / 2, 2.5 * side});
  modeller.view({-0.625 * side, -side, 1.5 * side}, {0.4375 * side, 0.375 * side, 0.125 * side}, 45);
  return modeller.finish();
}

}  // namespace

BuiltinScene gears_scene() {
  return {"gears",
          "layers of toothed wheels in mesh: concave polygons",
          "gears along each of three axes",
          "no paper's scene: concave objects",
          4,
          20,
          [](std::uint32_t size) { return std::size_t{size} * size * size * (kGearFaces + kAxleFaces); },
          make};
}

}  // namespace gnomon::scene
