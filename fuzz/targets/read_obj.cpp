// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as OBJ: a valid mesh or an InputError of one line, nothing else.
#include <cstddef>
#include <cstdint>

#include "fuzz/targets/read_any_bytes.h"
#include "scene/read_mesh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  gnomon::fuzz::read_any_bytes(gnomon::scene::read_obj, data, size);
  return 0;
}
