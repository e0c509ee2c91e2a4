// SPDX-License-Identifier: MIT
// Blocks of houses between streets: stepped towers, courtyards of concave outline, gabled houses, slabs.
#include "scene/builtin_list.h"
#include "scene/modeller.h"
#include "scene/variation.h"

namespace gnomon::scene {
namespace {

constexpr double kBlock = 48, kPitch = 60, kPlot = 24;
constexpr std::uint32_t kKinds = 4, kFins = 10;

std::uint64_t plot_number(std::uint32_t row, std::uint32_t column, std::uint32_t plot) {
  return (std::uint64_t{row} << 32U) + 4 * std::uint64_t{column} + plot;
}

std::uint32_t kind_of(std::uint64_t plot) {
  return scrambled(8 * plot) % kKinds;
}

constexpr std::size_t kKindFaces[kKinds] = {4 * 12 + 14,  // tower: three steps, a hut and a spire
                                            28 + 2 * 12,  // courtyard: a prism on eight corners, and two huts
                                            2 * (12 + 8 + 12),            // two houses: walls, roof, chimney
                                            12 + 12 * kFins + 12};        // slab: body, fins, hut
constexpr std::size_t kStreetFaces = 12 + 4 * (20 + 12) + 4 * (20 + 14);  // pavement, lamps, trees

double whole(double x) {
  return static_cast<double>(static_cast<int>(x));
}

class Plot {
 public:
  Plot(Modeller& modeller, std::uint64_t number) : modeller_(modeller), number_(number) {}

  void add() {
    switch (kind_of(number_)) {
      case 0:
        return add_tower();
      case 1:
        return add_courtyard();
      case 2:
        return add_houses();
      default:
        return add_slab();
    }
  }

 private:
  [[nodiscard]] double varied(std::uint64_t k) const { return scene::varied(8 * number_ + k); }
  void box(const char* name, const Point3& lo, const Point3& hi) {
    modeller_.object(name, Shape::convex);
    modeller_.box(lo, hi);
  }

  void add_tower() {
    const double storey = 3.5, first = storey * whole(5 + 12 * varied(1)),
                 second = first + storey * whole(4 + 10 * varied(2)), third = second + storey * 4;
    box("tower", {2, 2, 0}, {22, 22, first});
    box("tower", {4, 5, first}, {20, 19, second});
    box("tower", {6, 7, second}, {18, 17, third});
    box("hut", {8, 9, third}, {16, 15, third + 3});
    modeller_.object("spire", Shape::convex);
    std::vector<Point2> outline = regular_polygon(8, 2);
    for (Point2& p : outline) p = {p[0] + 12, p[1] + 12};
    modeller_.pyramid(outline, third + 3, {12, 12, third + 12});
  }

  void add_courtyard() {
    const double top = 3.25 * whole(4 + 4 * varied(1)), wing = 7 + 2 * varied(2);
    const Point2 outline[] = {{1, 1},         {23, 1},       {23, 23},       {23 - wing, 23},
                              {23 - wing, 9}, {1 + wing, 9}, {1 + wing, 23}, {1, 23}};
    modeller_.object("courtyard", Shape::concave);
    modeller_.prism(outline, 0, top);
    box("hut", {9, 2.5, top}, {13, 6.5, top + 2.5});
    box("hut", {2.5, 15, top}, {6, 19, top + 2.5});
  }

  void add_houses() {
    for (const double y : {2.0, 13.0}) {
      const double width = 12 + 8 * varied(y > 2 ? 1 : 2), eaves = 3 * whole(2 + 2 * varied(y > 2 ? 3 : 4));
      const double x = 2, depth = 9;
      box("house", {x, y, 0}, {x + width, y + depth, eaves});
      std::vector<Point3> rings[2];
      // The roof juts out, so that none of its faces is one of the walls' upper side.
      for (const double end : {x - 0.5, x + width + 0.5}) {
        rings[end > x] = {
            {end, y - 0.5, eaves}, {end, y + depth + 0.5, eaves}, {end, y + depth / 2, eaves + 4}};
      }
      modeller_.object("roof", Shape::convex);
      modeller_.loft(rings);
      box("chimney", {x + 2, y + 1, eaves}, {x + 3, y + 2, eaves + 5});
    }
  }

  void add_slab() {
    const double top = 3.25 * whole(6 + 10 * varied(1));
    box("slab", {3, 4, 0}, {21, 18, top});
    for (std::uint32_t k = 0; k < kFins; ++k) {
      const double x = 3 + 18.0 * k / kFins + 0.5;
      box("fin", {x, 3.5, 3}, {x + 0.25, 4, top});
    }
    box("hut", {10, 9, top}, {14, 13, top + 3});
  }

  Modeller& modeller_;
  std::uint64_t number_;
};

void add_street(Modeller& modeller, double x, double y) {
  modeller.place({x, y, 0});
  modeller.object("pavement", Shape::convex);
  modeller.box({-3, -3, 0}, {kBlock + 3, kBlock + 3, 0.125});
  for (std::uint32_t k = 0; k < 4; ++k) {
    const double u = k % 2 == 0 ? -2.0 : kBlock + 2, v = k / 2 == 0 ? -2.0 : kBlock + 2,
                 inward = u < 0 ? 1 : -1;
    modeller.place({x + u, y + v, 0.125});
    modeller.object("lamp post", Shape::convex);
    modeller.prism(regular_polygon(6, 0.125), 0, 5.75);
    modeller.object("lamp", Shape::convex);
    modeller.box({-0.25, -0.25, 5.75}, {0.25, 0.25, 6.25});
    modeller.place({x + u + 12 * inward, y + v, 0.125});
    modeller.object("trunk", Shape::convex);
    modeller.prism(regular_polygon(6, 0.1875), 0, 2);
    modeller.object("crown", Shape::convex);
    modeller.pyramid(regular_polygon(8, 1.5), 2, {0, 0, 7});
  }
}

Scene make(std::uint32_t size) {
  Modeller modeller(0x1p-10);
  const double side = kPitch * size;
  modeller.object("ground", Shape::convex);
  modeller.box({-kPitch / 2, -kPitch / 2, -1}, {side + kPitch / 2, side + kPitch / 2, 0});
  for (std::uint32_t row = 0; row < size; ++row) {
    for (std::uint32_t column = 0; column < size; ++column) {
      const double x = kPitch * column, y = kPitch * row;
      add_street(modeller, x, y);
      for (std::uint32_t plot = 0; plot < 4; ++plot) {
        modeller.place({x + kPlot * (plot % 2), y + kPlot * (plot / 2), 0.125});
        Plot(modeller, plot_number(row, column, plot)).add();
      }
    }
  }
  // The sun, and street lamps' light at the first crossings, before the view.
  modeller.point_light({-0.75 * side - 50, -0.5 * side - 80, 0.75 * side + 150});
  for (const double x : {-6.0, 54.0}) modeller.point_light({x, 54, 6});
  modeller.view({-0.125 * side - 40, -0.25 * side - 60, 0.25 * side + 70}, {0.45 * side, 0.45 * side, 0}, 45);
  return modeller.finish();
}

std::size_t faces(std::uint32_t size) {
  std::size_t count = 12 + kStreetFaces * size * size;
  for (std::uint32_t row = 0; row < size; ++row) {
    for (std::uint32_t column = 0; column < size; ++column) {
      for (std::uint32_t plot = 0; plot < 4; ++plot)
        count += kKindFaces[kind_of(plot_number(row, column, plot))];
    }
  }
  return count;
}

}  // namespace

BuiltinScene city_scene() {
  return {"city",
          "blocks of towers, courtyards, gabled houses and slabs, with the sun and two street lamps",
          "blocks along each side of the city",
          "no paper's scene: many objects, large and small, outdoors",
          12,
          80,
          faces,
          make};
}

}  // namespace gnomon::scene
