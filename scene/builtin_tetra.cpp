// SPDX-License-Identifier: MIT
// A tetrahedron, replaced by four of half the size, again and again (Sierpinski's fractal).
#include "scene/builtin_list.h"
#include "scene/modeller.h"

namespace gnomon::scene {
namespace {

using Tetrahedron = std::array<Point3, 4>;

void add(SceneBuilder& builder, const Tetrahedron& t, std::uint32_t depth) {
  if (depth > 0) {
    for (const Point3& kept : t) {
      Tetrahedron part = t;
      for (Point3& p : part) {
        for (std::size_t k = 0; k < 3; ++k) p[k] = (p[k] + kept[k]) / 2;
      }
      add(builder, part, depth - 1);
    }
    return;
  }
  builder.begin_object("tetrahedron", 0, true);
  builder.scene().objects.back().declared_convex = true;
  builder.add_triangle(t[0], t[1], t[2]);
  builder.add_triangle(t[0], t[2], t[3]);
  builder.add_triangle(t[0], t[3], t[1]);
  builder.add_triangle(t[1], t[3], t[2]);
}

Scene make(std::uint32_t depth) {
  SceneBuilder builder;
  // Alternate corners of a cube: halves of halves stay exact.
  add(builder, {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}}, depth);
  Scene& scene = builder.scene();
  scene.point_lights.push_back({{2, -3, 4}});
  scene.view = View{{2, -4, 2.25}, {0, 0, 0}, {0, 0, 1}, 45, 0.0625, 512, 512};
  return builder.finish();
}

}  // namespace

BuiltinScene tetra_scene() {
  return {"tetra",
          "a fractal of tetrahedra, each an object",
          "how often each tetrahedron is replaced by four",
          "voxel occlusion, \"Tetra\" (4096 objects)",
          6,
          10,
          [](std::uint32_t size) { return std::size_t{4} << (2 * size); },
          make};
}

}  // namespace gnomon::scene
