// SPDX-License-Identifier: MIT
#include "fast/fp_environment.h"

#include <limits>

namespace gnomon::fast {

namespace {

template <class F>
bool rounds_to_nearest() {
  volatile F one = 1, u = std::numeric_limits<F>::epsilon() / 2;
  const volatile F even = one + u, odd = one + 3 * u, down = -one - u;
  return even == F(1) && odd == 1 + 4 * std::numeric_limits<F>::epsilon() / 2 && down == F(-1);
}

template <class F>
bool keeps_denormals() {
  volatile F least = std::numeric_limits<F>::min(), tiny = std::numeric_limits<F>::denorm_min();
  const volatile F half = least / 2, sum = tiny + tiny;
  return half > 0 && sum > tiny && tiny > 0;
}

template <class F>
bool fuses_products() {
  // (1 + e)^2 = 1 + 2e + e^2: rounded, the square is 1 + 2e; fused, its last term survives the difference.
  volatile F x = 1 + std::numeric_limits<F>::epsilon(), y = 1 + 2 * std::numeric_limits<F>::epsilon();
  const F a = x, b = y;
  volatile F difference = a * a - b;
  return difference != 0;
}

bool excess_precision() {
  volatile float large = std::numeric_limits<float>::max();
  const float a = large;
  volatile float back = a * 2 / 2;  // overflows in floats, not in a wider format
  return back == a;
}

}  // namespace

FpEnvironment witness_fp_environment() {
  return {rounds_to_nearest<float>() && rounds_to_nearest<double>(),
          keeps_denormals<float>() && keeps_denormals<double>(),
          fuses_products<float>() || fuses_products<double>(), excess_precision()};
}

}  // namespace gnomon::fast
