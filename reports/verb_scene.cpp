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
#include "scene/read_scene.h"
#include "scene/tokens.h"
#include "scene/write_nff.h"

namespace gnomon::reports {
namespace {

struct SceneArguments {
  std::string file, out;
  bool json = false;
};

int run_scene(const SceneArguments& arguments) {
  // By another name it could not be read again: the extension tells the format.
  if (!arguments.out.empty() &&
      !scene::equals_ignoring_case(std::filesystem::path(arguments.out).extension().string(), ".nff")) {
    throw std::runtime_error("-o: expected a file name that ends in .nff, found \"" + arguments.out + "\"");
  }
  const scene::LoadedScene loaded = scene::read_scene(arguments.file);
  if (!arguments.out.empty()) scene::write_whole_file(arguments.out, nff_text(loaded.scene));
  std::cout << (arguments.json ? scene_json(loaded, arguments.file) : scene_text(loaded, arguments.file));
  return 0;
}

}  // namespace

void add_scene_verb(CLI::App& app, std::function<int()>& run) {
  CLI::App* const verb = app.add_subcommand("scene", "Describe a scene, write it as NFF");
  const auto arguments = std::make_shared<SceneArguments>();
  verb->add_option("file", arguments->file, "a scene: .nff, .off, .obj, .ply or .stl")->required();
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
      "What is written reads back with the same numbers, bit for bit.\n"
      "Examples:\n"
      "  gnomon scene balls.nff\n"
      "  gnomon scene bunny.off -o bunny.nff\n"
      "  gnomon scene gears.nff --json");
  verb->final_callback([&run, arguments] { run = [arguments] { return run_scene(*arguments); }; });
}

}  // namespace gnomon::reports
