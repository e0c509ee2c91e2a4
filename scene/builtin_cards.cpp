// SPDX-License-Identifier: MIT
// A house of cards: storeys of leaning pairs, with cards lying between the storeys.
#include <cmath>

#include "scene/builtin_list.h"
#include "scene/modeller.h"
#include "scene/turn.h"

namespace gnomon::scene {
namespace {

constexpr std::uint64_t kCornersEach = 10;  // of each rounded corner
constexpr std::size_t kCardFaces = 4 * (4 * kCornersEach) - 4;
constexpr double kWidth = 2.75, kHeight = 4, kThickness = 1.0 / 64, kRounding = 0.375;

/// A card's outline, counterclockwise, from (0, 0) to (kWidth, kHeight). All numbers are multiples of 1/256.
std::vector<Point2> outline() {
  const auto coarse = [](double x) { return std::floor(x * 256 + 0.5) / 256; };
  std::vector<Point2> corners;
  for (std::uint64_t quarter = 0; quarter < 4; ++quarter) {
    const double x = quarter == 0 || quarter == 3 ? kWidth - kRounding : kRounding;
    const double y = quarter < 2 ? kHeight - kRounding : kRounding;
    for (std::uint64_t k = 0; k < kCornersEach; ++k) {
      const Direction d = turn(quarter * (kCornersEach - 1) + k, 4 * (kCornersEach - 1));
      corners.push_back({coarse(x + kRounding * d.cos), coarse(y + kRounding * d.sin)});
    }
  }
  return corners;
}

class House {
 public:
  /// A card whose width runs along y and whose height along `rise`, a vector for a unit of height, from
  /// `foot` on; its other side is off by `thickness`. Products of multiples of 1/256 and of 1/128 are on the
  /// lattice, so that all sides are flat exactly.
  void card(const char* name, const Point3& foot, const Point3& rise, const Point3& thickness) {
    std::vector<Point3> rings[2];
    for (const Point2& p : outline_) {
      const Point3 q{foot[0] + p[1] * rise[0], foot[1] + p[0], foot[2] + p[1] * rise[2]};
      rings[0].push_back(q);
      rings[1].push_back({q[0] + thickness[0], q[1], q[2] + thickness[2]});
    }
    modeller_.object(name, Shape::convex);
    modeller_.loft(rings);
  }

  Scene build(std::uint32_t storeys) {
    // Leaning cards are 1.0078 times kHeight long; lying ones, from ridge to ridge, 1.0078125 times.
    constexpr double kLean = 0.5, kRise = 0.875, kLying = 1 + 1.0 / 128;
    constexpr double kSpan = kLying * kHeight, kRidge = kRise * kHeight, kStorey = kRidge + kThickness;
    static_assert(kSpan == 2 * (kLean * kHeight + kThickness));
    const double base = storeys * kSpan;
    modeller_.object("table", Shape::convex);
    modeller_.box({-4, -6, -0.5}, {base + 4, 8, 0});
    for (std::uint32_t storey = 0; storey < storeys; ++storey) {
      const std::uint32_t pairs = storeys - storey;
      const double z = storey * kStorey;
      for (std::uint32_t i = 0; i < pairs; ++i) {
        const double x = (i + 0.5 * storey) * kSpan;
        card("leaning card", {x, 0, z}, {kLean, 0, kRise}, {kThickness, 0, 0});
        card("leaning card", {x + kSpan - kThickness, 0, z}, {-kLean, 0, kRise}, {kThickness, 0, 0});
        if (i + 1 < pairs) {
          card("lying card", {x + kSpan / 2, 0, z + kStorey}, {kLying, 0, 0}, {0, 0, -kThickness});
        }
      }
    }
    modeller_.point_light({-3, -5, 6});
    modeller_.point_light({base + 3, -5, 7});
    modeller_.point_light({base / 2, 7, 9});
    modeller_.point_light({-2, 6, 5});
    modeller_.point_light({base / 2, -4, storeys * kStorey + 4});
    modeller_.view({base / 2 - 4, -1.5 * base - 4, storeys * 2.0 + 2}, {base / 2, 1, storeys * 1.625}, 50);
    return modeller_.finish();
  }

 private:
  Modeller modeller_{0x1p-15};
  std::vector<Point2> outline_ = outline();
};

std::size_t faces(std::uint32_t size) {
  const std::size_t n = size;
  return 12 + kCardFaces * (n * (n + 1) + n * (n - 1) / 2);
}

}  // namespace

BuiltinScene cards_scene() {
  return {"cards",   "a house of cards with rounded corners, each an object",
          "storeys", "light buffer, \"House of Cards\" (41 objects, 5 lights)",
          5,         120,
          faces,     [](std::uint32_t size) { return House().build(size); }};
}

}  // namespace gnomon::scene
