// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a small scene with two patches: do they see each other?
#include "fuzz/targets/check_pair.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gnomon::fuzz;
  PairCheck<PatchQuestion>(PairDecoder(Bytes(data, size)).patches()).run();
  return 0;
}
