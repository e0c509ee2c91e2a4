// SPDX-License-Identifier: MIT
#include "scene/read_mesh.h"

#include <array>
#include <fstream>
#include <string>
#include <system_error>

#include "scene/input_error.h"
#include "scene/line_reader.h"
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

Mesh read_mesh(const std::filesystem::path& path) {
  const std::string name = path.string();
  const std::string extension = path.extension().string();
  for (const Format& format : kFormats) {
    if (!equals_ignoring_case(extension, format.extension)) continue;
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) throw InputError(name, 0, "expected a file, found none");
    if (std::filesystem::is_directory(status))
      throw InputError(name, 0, "expected a file, found a directory");
    std::ifstream in(path, std::ios::binary);
    if (!in) throw InputError(name, 0, "expected a readable file, found one that can't be opened");
    return format.read(in, name);
  }
  throw InputError(name, 0,
                   "expected the extension .off, .obj, .ply or .stl, found " +
                       (extension.empty() ? std::string("none") : in_quotes(extension)));
}

}  // namespace gnomon::scene
