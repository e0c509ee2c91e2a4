// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/verb_scene.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "reports/scene_text.h"
#include "scene/atomic_file.h"
#include "scene/cone.h"
#include "scene/find_scene.h"
#include "scene/tokens.h"
#include "scene/write_nff.h"

namespace gnomon::reports {
namespace {

struct SceneArguments {
  std::string name, out;
  bool json = false;
};

int run_scene(const SceneArguments& arguments) {
  // By another name it could not be read again: the extension tells the format.
  if (!arguments.out.empty() &&
      !scene::equals_ignoring_case(std::filesystem::path(arguments.out).extension().string(), ".nff")) {
    throw std::runtime_error("-o: expected a file name that ends in .nff, found \"" + arguments.out + "\"");
  }
  const scene::FoundScene found = scene::find_scene(arguments.name);
  const scene::Scene& scene = found.loaded.scene;
  if (!arguments.out.empty()) {
    scene::write_whole_file(arguments.out, nff_text(scene));
    if (const std::size_t polygons = scene.polygon_lights.size(); polygons > 0) {
      std::cerr << "gnomon: NFF has no polygon lights: " << polygons
                << (polygons == 1 ? " became a point light" : " became point lights")
                << " at the mean of the corners\n";
    }
  }
  std::cout << (arguments.json ? scene_json(found, arguments.name) : scene_text(found, arguments.name));
  return 0;
}

}  // namespace

void add_scene_verb(CLI::App& app, std::function<int()>& run) {
  CLI::App* const verb = app.add_subcommand("scene", "Describe a scene, write it as NFF");
  const auto arguments = std::make_shared<SceneArguments>();
  verb->add_option("scene", arguments->name,
                   "a file (.nff, .off, .obj, .ply or .stl), or a built-in scene: NAME or NAME:SIZE")
      ->required();
  verb->add_option("-o,--out", arguments->out, "write the scene here, as NFF: triangles and balls alone");
  verb->add_flag("--json", arguments->json, "the description as JSON, object by object");
  verb->footer(
      "Faces are triangles and balls: polygons are triangulated, cones and cylinders become " +
      std::to_string(scene::kConeSides) +
      " flat sides.\n"
      "degenerate: triangles whose corners lie on one line, exactly, and balls of radius 0; duplicate: "
      "faces\n"
      "that repeat an earlier one. An object is closed when every edge belongs to exactly two of its "
      "triangles.\n"
      "convex: as the source declares, and as is so exactly: the boundary of one convex body, turned "
      "outward, "
      "or\n"
      "one face alone.\n"
      "What is written reads back with the same numbers, bit for bit; a polygon light becomes a point light "
      "at\n"
      "the mean of its corners, unless one stands there.\n"
      "Built-in scenes (a file of the same name comes first; gnomon list says more, and what SIZE counts):\n"
      "  " +
      std::string(scene::builtin_names()) +
      "\n"
      "Examples:\n"
      "  gnomon scene balls.nff\n"
      "  gnomon scene bunny.off -o bunny.nff\n"
      "  gnomon scene gears.nff --json\n"
      "  gnomon scene office-fine\n"
      "  gnomon scene city:20 -o city.nff");
  verb->final_callback([&run, arguments] { run = [arguments] { return run_scene(*arguments); }; });
}

}  // namespace gnomon::reports
