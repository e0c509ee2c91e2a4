// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a case of shaft-sphere: references agree, no promise breaks.
#include "fuzz/targets/check_case.h"
#include "fuzz/targets/decode_case.h"

namespace {

using namespace gnomon;

template <class F>
void check(fuzz::Bytes& bytes, scene::Scalar scalar) {
  fuzz::CaseDecoder<F> decoder(bytes);
  const fuzz::Triple<F> boxes = decoder.triple();
  const auto c = scene::converted<double>(decoder.with_radius(boxes));
  fuzz::CaseCheck<fuzz::ShaftBallQuestion>(c, scalar).run();
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
