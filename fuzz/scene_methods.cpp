// SPDX-License-Identifier: GPL-3.0-or-later
// The registry rows of shadow and first-hit. Adding a method is a caster (a file) and a row in the table.
#include "fuzz/brute_caster.h"
#include "fuzz/scene_method.h"

namespace gnomon::fuzz {
namespace {

constexpr std::string_view kAllFloats = "all finite floats";

const SceneMethod kRows[] = {
    {"brute-naive-f32", "naive", Promise::none, kAllFloats,
     "all faces, Moeller and Trumbore's test in floats", true, true, make_brute_caster},
};

}  // namespace

std::span<const SceneMethod> scene_methods() {
  return kRows;
}

}  // namespace gnomon::fuzz
