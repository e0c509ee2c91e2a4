// SPDX-License-Identifier: MIT
#include "scene/read_scene.h"

#include <fstream>
#include <utility>
#include <vector>

#include "scene/input_error.h"
#include "scene/line_reader.h"
#include "scene/open_input.h"
#include "scene/read_mesh.h"
#include "scene/scene_builder.h"
#include "scene/tokens.h"

namespace gnomon::scene {

LoadedScene read_scene(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  if (equals_ignoring_case(extension, ".nff")) {
    std::ifstream in = open_input(path);
    return read_nff(in, path.string());
  }
  if (has_mesh_extension(path)) return scene_of(read_mesh(path), path.stem().string());
  throw InputError(path.string(), 0,
                   "expected the extension .nff, .off, .obj, .ply or .stl, found " +
                       (extension.empty() ? std::string("none") : in_quotes(extension)));
}

LoadedScene scene_of(const Mesh& mesh, std::string name) {
  LoadedScene loaded;
  SceneBuilder builder;
  builder.begin_object(std::move(name), 0, false);
  std::vector<std::array<double, 3>> corners;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    corners.clear();
    for (const std::uint32_t corner : mesh.face(f)) corners.push_back(mesh.points[corner]);
    if (corners.size() > 3) ++loaded.polygons;
    if (builder.add_polygon(corners)) ++loaded.crossing_polygons;
  }
  loaded.scene = builder.finish();
  return loaded;
}

}  // namespace gnomon::scene
