// SPDX-License-Identifier: GPL-3.0-or-later
// The promises of the certified and exact tiers, held by a stranger's compiler flags: kernels of the library,
// kernels inlined from its headers into this file, and the exact references. Exit status 1 when one is
// broken.
#include <cstdio>
#include <span>
#include <vector>

#include "exact/shaft_ball.h"
#include "exact/shaft_box.h"
#include "fast/box_relation.h"
#include "fast/certified_shaft.h"
#include "fast/fp_environment.h"
#include "fast/shaft_ball.h"
#include "fast/shaft_box.h"
#include "hard_cases.h"

namespace {

using namespace gnomon;
using scene::Category;

struct Count {
  long cases = 0, unsound = 0, inlined_unsound = 0, inlined_differs = 0, certain_wrong = 0, exact_wrong = 0;
  long naive_unsound = 0, truths[3] = {}, wasted = 0;

  [[nodiscard]] long broken() const {
    return unsound + inlined_unsound + inlined_differs + certain_wrong + exact_wrong;
  }
};

bool is_unsound(Category answer, Category truth) {
  return answer != truth && answer != Category::overlap;
}

/// The cull of the library, evaluated here: `near_value` is inlined from the header under this file's flags.
template <class F>
bool culls_inlined(const fast::Shaft<F>& shaft, const scene::Box<F>& t) {
  bool outside = !fast::meets(t, shaft.extent);
  for (const fast::ShaftPlane<F>& plane : shaft.planes())
    outside |= plane.near_value(t) > plane.outside_threshold;
  return outside;
}

template <class F>
void try_box(const scene::ShaftBoxCaseOf<F>& c, Category truth, Count& count) {
  const fast::Shaft<F> shaft = fast::form_certified_box_shaft(c.a, c.b);
  const fast::Banded banded = fast::classify(shaft, c.t);
  const bool inlined = culls_inlined(shaft, c.t);
  const Category naive = fast::classify(fast::form_shaft(c.a, c.b, fast::Normals::as_formed), c.t).answer;
  count.unsound += is_unsound(banded.answer, truth);
  count.inlined_unsound += inlined && truth != Category::outside;
  count.inlined_differs += inlined != (banded.answer == Category::outside);
  count.certain_wrong += banded.certain && banded.answer != truth;
  count.exact_wrong += !banded.certain && exact::classify(scene::converted<double>(c)) != truth;
  count.naive_unsound += is_unsound(naive, truth);
  count.wasted += banded.answer != truth;
}

template <class F>
Count boxes(int cases) {
  consumer::Random random(sizeof(F));
  std::vector<scene::ShaftBoxCase> wide(static_cast<std::size_t>(cases));
  for (scene::ShaftBoxCase& c : wide) c = scene::converted<double>(consumer::hard_case<F>(random));
  std::vector<exact::ShaftBoxReference> references(wide.size());
  exact::refer(wide, references);
  Count count;
  for (std::size_t i = 0; i < wide.size(); ++i) {
    ++count.cases;
    ++count.truths[static_cast<int>(references[i].truth)];
    try_box(scene::converted<F>(wide[i]), references[i].truth, count);
  }
  return count;
}

/// Balls around the near corners of the same boxes, with radii that reach back about as far as the corner was
/// moved.
template <class F>
Count balls(int cases) {
  consumer::Random random(100 + sizeof(F));
  std::vector<scene::ShaftBallCase> wide(static_cast<std::size_t>(cases));
  for (scene::ShaftBallCase& c : wide) {
    const scene::ShaftBoxCaseOf<F> box = consumer::hard_case<F>(random);
    const F diameter = box.t.hi(0) - box.t.lo(0);
    const scene::Ball<F> ball{{box.t.lo(0), box.t.lo(1), box.t.hi(2)},
                              random.below(4) == 0 ? F(0) : diameter / F(random.below(9) + 1)};
    c = scene::converted<double>(scene::ShaftBallCaseOf<F>{box.a, box.b, ball});
  }
  std::vector<exact::ShaftBallReference> references(wide.size());
  exact::refer(wide, references);
  Count count;
  for (std::size_t i = 0; i < wide.size(); ++i) {
    const auto c = scene::converted<F>(wide[i]);
    const Category truth = references[i].truth;
    const fast::Banded banded = fast::classify(fast::form_certified_ball_shaft(c.a, c.b), c.t);
    const Category naive = fast::classify(fast::form_shaft(c.a, c.b, fast::Normals::unit), c.t).answer;
    ++count.cases;
    ++count.truths[static_cast<int>(truth)];
    count.unsound += is_unsound(banded.answer, truth);
    count.certain_wrong += banded.certain && banded.answer != truth;
    count.exact_wrong += !banded.certain && exact::classify(wide[i]) != truth;
    count.naive_unsound += is_unsound(naive, truth);
    count.wasted += banded.answer != truth;
  }
  return count;
}

/// Prints, and says whether the promises held on cases that could have broken them.
bool report(const char* name, const Count& count) {
  std::printf(
      "%s: %ld cases (%ld outside, %ld overlap, %ld inside): certified unsound %ld, wasted %ld; inlined "
      "unsound %ld, "
      "differs %ld; certain but wrong %ld; exact wrong %ld; naive unsound %ld\n",
      name, count.cases, count.truths[0], count.truths[1], count.truths[2], count.unsound, count.wasted,
      count.inlined_unsound, count.inlined_differs, count.certain_wrong, count.exact_wrong,
      count.naive_unsound);
  // A quarter of a per cent of each truth, and naive errors: else the cases were not hard.
  for (const long truth : count.truths) {
    if (truth * 400 < count.cases) {
      std::fprintf(stderr, "%s: too few cases of one kind\n", name);
      return false;
    }
  }
  if (count.naive_unsound == 0) std::fprintf(stderr, "%s: not even the naive test was wrong\n", name);
  return count.broken() == 0 && count.naive_unsound > 0;
}

/// This file's own arithmetic: is x * x - y rounded twice here?
bool contracts() {
  volatile double x = 1 + 0x1p-30;  // read anew each time, so that no product is known already
  const double a = x, b = x;
  volatile double rounded = a * b;  // 1 + 2^-29: the 2^-60 is lost
  const double c = x, d = x, product = rounded;
  return c * d - product != 0;
}

}  // namespace

int main() {
  bool held = true;
  if (!fast::witness_fp_environment().is_strict() || contracts()) {
    std::fprintf(stderr, "the floating-point environment is not strict\n");
    held = false;
  }
  held &= report("box f32", boxes<float>(150000));
  held &= report("box f64", boxes<double>(150000));
  held &= report("ball f32", balls<float>(40000));
  held &= report("ball f64", balls<double>(40000));
  return held ? 0 : 1;
}
