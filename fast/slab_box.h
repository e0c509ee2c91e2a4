// SPDX-License-Identifier: MIT
// The shaft's box test as a slab test in s: no planes.
#pragma once

#include "fast/box_relation.h"
#include "scene/category.h"

namespace gnomon::fast {

/// An interval of the parameter s of the boxes (1-s)A + sB; empty when from > to.
template <class F>
struct SInterval {
  F from = 0, to = 1;

  [[nodiscard]] bool empty() const { return !(from <= to); }

  /// Cuts the interval by p + q s >= 0; a coefficient 0 is branched on, never divided by.
  void cut(F p, F q) {
    if (q > 0) {
      from = std::max(from, -p / q);
    } else if (q < 0) {
      to = std::min(to, -p / q);
    } else if (p < 0) {
      to = -1;
    }
  }
};

/// Box `t` against the shaft between `a` and `b`. Outside: six inequalities, two an axis, and 0 <= s <= 1
/// have no common s; inside: each of t's eight corners has an s of its own. Exact in real arithmetic (Helly's
/// theorem on the line), promises nothing in floating point.
template <class F>
[[nodiscard]] scene::Category classify_by_slabs(const scene::Box<F>& a, const scene::Box<F>& b,
                                                const scene::Box<F>& t);

}  // namespace gnomon::fast
