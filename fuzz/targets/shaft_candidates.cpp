// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a small scene with two boxes: which faces meet their shaft.
#include "fuzz/targets/check_pair.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gnomon::fuzz;
  PairCheck<CandidateQuestion>(PairDecoder(Bytes(data, size)).boxes()).run();
  return 0;
}
