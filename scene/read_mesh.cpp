// SPDX-License-Identifier: MIT
#include "scene/read_mesh.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <string>

#include "scene/input_error.h"
#include "scene/line_reader.h"
#include "scene/open_input.h"
#include "scene/tokens.h"

namespace gnomon::scene {
namespace {

struct Format {
  std::string_view extension;
  Mesh (*read)(std::istream&, std::string_view);
};

constexpr std::array<Format, 4> kFormats{
    {{".off", read_off}, {".obj", read_obj}, {".ply", read_ply}, {".stl", read_stl}}};

}  // namespace

bool has_mesh_extension(const std::filesystem::path& path) {
  return std::ranges::any_of(kFormats, [extension = path.extension().string()](const Format& format) {
    return equals_ignoring_case(extension, format.extension);
  });
}

Mesh read_mesh(const std::filesystem::path& path) {
  const std::string name = path.string();
  const std::string extension = path.extension().string();
  for (const Format& format : kFormats) {
    if (!equals_ignoring_case(extension, format.extension)) continue;
    std::ifstream in = open_input(path);
    return format.read(in, name);
  }
  throw InputError(name, 0,
                   "expected the extension .off, .obj, .ply or .stl, found " +
                       (extension.empty() ? std::string("none") : in_quotes(extension)));
}

}  // namespace gnomon::scene
