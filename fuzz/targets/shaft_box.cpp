// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a case of shaft-box: references agree, the theorem holds, no promise breaks.
#include "fuzz/targets/check_case.h"
#include "fuzz/targets/decode_case.h"

namespace {

using namespace gnomon;

template <class F>
void check(fuzz::Bytes& bytes, scene::Scalar scalar) {
  const auto c = scene::converted<double>(fuzz::CaseDecoder<F>(bytes).triple());
  fuzz::CaseCheck<fuzz::ShaftBoxQuestion>(c, scalar).run();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Bytes bytes(data, size);
  if (bytes.next() % 2 == 0) {
    check<float>(bytes, scene::Scalar::f32);
  } else {
    check<double>(bytes, scene::Scalar::f64);
  }
  return 0;
}
