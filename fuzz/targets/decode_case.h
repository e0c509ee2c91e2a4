// SPDX-License-Identifier: GPL-3.0-or-later
// Bytes to shaft cases: every byte string is a valid case, and short ones reach ties, degenerate boxes, the
// ends of the range, and contacts with the shaft's sides and planes.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "fuzz/shapes.h"

namespace gnomon::fuzz {

/// The input's bytes in turn, then zeros.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}
  [[nodiscard]] unsigned next() {
    if (size_ == 0) return 0;
    --size_;
    return *data_++;
  }
  /// -128 .. 127.
  [[nodiscard]] int small() { return static_cast<int>(next()) - 128; }
  [[nodiscard]] std::uint64_t word(int bytes) {
    std::uint64_t value = 0;
    for (int i = 0; i < bytes; ++i) value = value << 8 | next();
    return value;
  }

 private:
  const std::uint8_t* data_;
  std::size_t size_;
};

/// Makes the numbers of one case; later ones may copy or neighbour earlier ones.
template <class F>
class CaseDecoder {
 public:
  explicit CaseDecoder(Bytes& bytes) : bytes_(bytes) {}

  [[nodiscard]] Triple<F> triple() {
    Triple<F> c;
    for (scene::Box<F>* box : {&c.a, &c.b, &c.t}) {
      for (int axis = 0; axis < 3; ++axis) {
        const F x = number();
        set_axis(*box, axis, x, number());
      }
    }
    if (const unsigned contact = bytes_.next(); (contact & 1u) != 0) touch(c, (contact & 2u) != 0);
    return c;
  }

  /// The ball at t's lower corner, the radius a number or a distance, walked off by some ulps.
  [[nodiscard]] scene::ShaftBallCaseOf<F> with_radius(const Triple<F>& c) {
    scene::ShaftBallCaseOf<F> result{c.a, c.b, {}};
    for (std::size_t i = 0; i < 3; ++i) result.t.centre[i] = c.t.c[i];
    const unsigned kind = bytes_.next();
    F radius = 0;
    if (kind % 2 == 0) {
      radius = number();
    } else {  // from the centre to a side, an edge or a corner of A or B
      const scene::Box<F>& box = (kind & 2u) != 0 ? c.a : c.b;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if ((kind >> (2 + axis) & 1u) == 0) continue;
        radius = std::hypot(radius, c.t.c[axis] - box.c[axis + ((kind >> (5 + axis) & 1u) != 0 ? 3 : 0)]);
      }
      radius = step_ulps(finite(radius), bytes_.small() % 5);
    }
    result.t.radius = std::fabs(radius);
    return result;
  }

 private:
  [[nodiscard]] static F finite(F x) {
    if (std::isnan(x)) return 0;
    const F most = std::numeric_limits<F>::max();
    return std::clamp(x, -most, most);
  }

  [[nodiscard]] F earlier() { return numbers_.empty() ? F(0) : numbers_[bytes_.next() % numbers_.size()]; }

  [[nodiscard]] F number() {
    numbers_.push_back(finite(draw()));
    return numbers_.back();
  }

  [[nodiscard]] F draw() {
    switch (bytes_.next() % 8) {
      case 0:
        return F(bytes_.small());
      case 1:
        return earlier();
      case 2: {
        const F x = earlier();
        return step_ulps(x, bytes_.small() % 5);
      }
      case 3: {  // any bits
        if constexpr (sizeof(F) == 4) return std::bit_cast<F>(static_cast<std::uint32_t>(bytes_.word(4)));
        if constexpr (sizeof(F) == 8) return std::bit_cast<F>(bytes_.word(8));
        return 0;
      }
      case 4: {  // any power of two, the largest and the denormals among them
        const int mantissa = bytes_.small();
        return std::ldexp(F(mantissa), bytes_.small() * (std::numeric_limits<F>::max_exponent / 128 + 1));
      }
      case 5:
        return F(bytes_.small()) * std::numeric_limits<F>::denorm_min();
      case 6:
        return F(bytes_.small()) * F(0.1);
      default: {
        const F x = earlier(), s = F(bytes_.next()) / 255;
        return x + s * (earlier() / 2 - x / 2) * 2;
      }
    }
  }

  /// Puts t's near or far corner on a plane through an edge of A and one of B, give or take some ulps.
  void touch(Triple<F>& c, bool near) {
    const std::size_t f = bytes_.next() % 6, g = bytes_.next() % 6;
    const F s = F(bytes_.next()) / 255;
    const F af = c.a.c[f], ag = c.a.c[g], bf = c.b.c[f], bg = c.b.c[g];
    if (f % 3 == g % 3 || af == bf) return;
    const F x = finite(af + s * (bf - af));
    const long double slope = (static_cast<long double>(bg) - ag) / (static_cast<long double>(bf) - af);
    const long double y = ag + (static_cast<long double>(x) - af) * slope;
    if (!(std::fabs(y) <= static_cast<long double>(std::numeric_limits<F>::max()))) return;
    put(c.t, f, x, near);
    put(c.t, g, step_ulps(static_cast<F>(y), bytes_.small() % 5), near);
  }

  /// The side of t that a plane on `face` looks at first (near) or last (far), and the other beside it.
  void put(scene::Box<F>& t, std::size_t face, F x, bool near) {
    const F size = std::fabs(finite(t.c[face % 3 + 3] - t.c[face % 3]));
    const bool up = (face >= 3) == near;
    set_axis(t, static_cast<int>(face % 3), x, finite(up ? x + size : x - size));
  }

  Bytes& bytes_;
  std::vector<F> numbers_;
};

}  // namespace gnomon::fuzz
