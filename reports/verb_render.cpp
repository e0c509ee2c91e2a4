// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/verb_render.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "fast/fp_environment.h"
#include "fuzz/camera.h"
#include "fuzz/lights.h"
#include "reports/peers/peers.h"
#include "reports/progress_line.h"
#include "reports/scene_source.h"
#include "reports/shadow_picture.h"
#include "scene/atomic_file.h"
#include "scene/printable.h"
#include "scene/single.h"
#include "scene/tokens.h"

namespace gnomon::reports {
namespace {

constexpr std::size_t kMostPixels = std::size_t{1} << 26;

struct RenderArguments {
  std::string scene, method, out, size;
  std::vector<std::string> lights;
  bool errors = false;
};

std::array<std::size_t, 2> parse_size(const std::string& text) {
  std::array<std::size_t, 2> size{};
  const char* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, size[0]);
  const bool cross = first.ec == std::errc{} && first.ptr != end && *first.ptr == 'x';
  const auto second = cross ? std::from_chars(first.ptr + 1, end, size[1]) : first;
  if (!cross || second.ec != std::errc{} || second.ptr != end || size[0] < 1 || size[1] < 1 ||
      size[0] > kMostPixels / size[1]) {
    throw std::runtime_error("--size: expected WxH of at least 1x1 and at most " +
                             std::to_string(kMostPixels) + " pixels, found \"" + scene::printable(text) +
                             "\"");
  }
  return size;
}

void say_wrong(const WrongPixels& wrong, const std::string& method) {
  std::cerr << method << ": " << wrong.all() << " of " << wrong.seen
            << " pixels that see a face are wrong: " << wrong.false_lit << " false light (red), "
            << wrong.false_shadowed << " false shadow (blue), " << wrong.wrong_reason
            << " dark for the wrong reason (violet), " << wrong.undecided << " undecided (yellow), "
            << wrong.touching << " on touching queries alone (green)\n";
}

int run_render(const RenderArguments& arguments) {
  const fuzz::SceneMethod& method = *choose_scene_methods({arguments.method}).front();
  if (!scene::equals_ignoring_case(std::filesystem::path(arguments.out).extension().string(), ".png")) {
    throw std::runtime_error("-o: expected a file name that ends in .png, found \"" +
                             scene::printable(arguments.out) + "\"");
  }
  std::array<std::size_t, 2> size{};
  if (!arguments.size.empty()) size = parse_size(arguments.size);
  std::vector<std::array<double, 3>> lights;
  for (const std::string& light : arguments.lights) lights.push_back(parse_light(light));
  scene::require_writable(arguments.out);
  if (!fast::witness_fp_environment().is_strict()) {
    throw std::runtime_error(
        "the floating-point environment is not IEEE round-to-nearest with denormals: no result would hold");
  }
  NamedScene named = load_scene(arguments.scene);
  fuzz::replace_lights(named.scene, lights);
  scene::SingleScene single;
  try {
    single = scene::rounded_to_floats(named.scene);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(arguments.scene + ": " + error.what());
  }
  if (!method.has_balls && !single.scene.balls.empty()) {
    throw std::runtime_error(arguments.scene + ": expected a scene without balls for " + arguments.method +
                             ", found " + std::to_string(single.scene.balls.size()));
  }
  fuzz::complete(single.scene);
  // By default the view's own size, up to about a million pixels.
  if (arguments.size.empty()) size = fuzz::picture_size(*single.scene.view, std::size_t{1} << 20);
  if (single.moved > 0) {
    std::cerr << arguments.scene << ": rounded to floats: " << single.moved
              << " points, balls and lights moved, " << single.merged << " points merged\n";
  }
  ShadowPicture picture;
  {
    ProgressLine line;
    picture =
        draw_shadows(single.scene, method, size[0], size[1], [&](double done) { line.show(done, "rows"); });
  }
  scene::write_whole_file(arguments.out, png_of(arguments.errors ? picture.errors : picture.shadows));
  say_wrong(picture.wrong, arguments.method);
  return 0;
}

}  // namespace

void add_render_verb(CLI::App& app, std::function<int()>& run) {
  CLI::App* const verb = app.add_subcommand("render", "Draw a scene's shadows as one method sees them");
  const auto arguments = std::make_shared<RenderArguments>();
  verb->add_option("scene", arguments->scene,
                   "a file (.nff, .off, .obj, .ply or .stl), or a built-in scene: NAME or NAME:SIZE")
      ->required();
  verb->add_option("--method", arguments->method, "a method of `gnomon list`")->required();
  verb->add_option("-o,--out", arguments->out, "the picture, FILE.png")->required();
  verb->add_flag("--errors", arguments->errors,
                 "the truth in grey; where the method is wrong for a light, in colour");
  verb->add_option("--size", arguments->size, "WxH in pixels; without it the view's own");
  verb->add_option("--light", arguments->lights,
                   "X,Y,Z: a point light instead of the scene's own (repeatable)")
      ->allow_extra_args(false);
  verb->footer(
      "What a pixel sees is decided exactly; the method tells which lights it sees from there. Brighter "
      "where\n"
      "more lights are seen. With --errors: red false light, blue false shadow, violet dark for the wrong\n"
      "reason, yellow undecided, green wrong on touching queries alone. Counts go to standard error.\n"
      "A scene's numbers are rounded to floats first; without lights or view it gets some from its extent.\n"
      "Examples:\n"
      "  gnomon render balls.nff --method reference -o balls.png\n"
      "  gnomon render bunny.off --method bvh-naive-f32 --errors -o errors.png --size 1024x1024");
  verb->final_callback([&run, arguments] { run = [arguments] { return run_render(*arguments); }; });
}

}  // namespace gnomon::reports
