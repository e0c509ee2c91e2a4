// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as NFF: a valid scene, which reads back the same when it was written, or an InputError of one
// line, nothing else.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "fuzz/targets/read_any_bytes.h"
#include "scene/read_scene.h"
#include "scene/scene_facts.h"
#include "scene/write_nff.h"

namespace {

using gnomon::scene::Scene;

Scene read_twice(std::istream& in, std::string_view name) {
  Scene scene = gnomon::scene::read_nff(in, name).scene;
  std::istringstream again(nff_text(scene));
  if (gnomon::scene::read_nff(again, name).scene != scene) std::abort();
  if (facts_of(scene).closed.size() != scene.objects.size()) std::abort();
  return scene;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  gnomon::fuzz::read_any_bytes(read_twice, data, size);
  return 0;
}
