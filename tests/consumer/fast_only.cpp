// SPDX-License-Identifier: GPL-3.0-or-later
// A consumer of the MIT part alone: no CGAL, no GMP.
#include <cstdio>

#include "fast/certified_shaft.h"
#include "fast/shaft_box.h"
#include "hard_cases.h"

int main() {
  using namespace gnomon;
  consumer::Random random(1);
  long kept[3] = {};
  for (int i = 0; i < 1000; ++i) {
    const auto c = consumer::hard_case<float>(random);
    ++kept[static_cast<int>(fast::classify(fast::form_certified_box_shaft(c.a, c.b), c.t).answer)];
  }
  std::printf("%ld outside, %ld overlap, %ld inside\n", kept[0], kept[1], kept[2]);
  return kept[0] > 0 && kept[1] > 0 && kept[2] > 0 ? 0 : 1;
}
