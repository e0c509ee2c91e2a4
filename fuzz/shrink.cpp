// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/shrink.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gnomon::fuzz {

namespace {

double complexity_of(double x) {
  if (x == 0) return 0;
  int exponent = 0;
  double fraction = std::frexp(std::fabs(x), &exponent);
  int bits = 0;
  while (fraction != 0) {
    fraction *= 2;
    fraction -= std::floor(fraction);
    ++bits;
  }
  return 1 + bits + std::abs(exponent - 1) / 4.0 + (x < 0 ? 0.5 : 0);
}

/// x rounded to a multiple of 2^exponent.
double to_grid(double x, int exponent) {
  return std::ldexp(std::round(std::ldexp(x, -exponent)), exponent);
}

/// x rounded to `bits` significant bits.
double to_bits(double x, int bits) {
  if (x == 0) return x;
  int exponent = 0;
  std::frexp(x, &exponent);
  return to_grid(x, exponent - bits);
}

class Shrinker {
 public:
  Shrinker(std::vector<double> numbers, scene::Scalar scalar, const AxisOfNumber& axis_of,
           const StillFails& still_fails, int most_trials)
      : best_(std::move(numbers)),
        scalar_(scalar),
        axis_of_(axis_of),
        still_fails_(still_fails),
        left_(most_trials),
        cost_(complexity(best_)) {}

  std::vector<double> run() {
    bool better = true;
    while (better && left_ > 0) {
      better = false;
      better |= scale();
      better |= translate();
      better |= round_all();
      for (std::size_t i = 0; i < best_.size(); ++i) better |= simplify(i);
    }
    return best_;
  }

 private:
  bool accept(const std::vector<double>& candidate) {
    if (left_ <= 0) return false;
    for (const double x : candidate) {
      if (!std::isfinite(x) || (scalar_ == scene::Scalar::f32 && !scene::is_float(x))) return false;
    }
    const double cost = complexity(candidate);  // knows finite numbers only
    if (!(cost < cost_)) return false;
    --left_;
    if (!still_fails_(candidate)) return false;
    best_ = candidate;
    cost_ = cost;
    return true;
  }

  bool scale() {
    double most = 0;
    for (const double x : best_) most = std::max(most, std::fabs(x));
    if (most == 0) return false;
    bool better = false;
    const int exponent = std::ilogb(most);
    for (int to = 0; to <= 12; to += 2) {
      std::vector<double> candidate = best_;
      for (double& x : candidate) x = std::ldexp(x, to - exponent);
      better |= accept(candidate);
    }
    return better;
  }

  bool translate() {
    bool better = false;
    for (std::size_t i = 0; i < best_.size(); ++i) {
      const int axis = axis_of_(i);
      if (axis < 0 || best_[i] == 0) continue;
      std::vector<double> candidate = best_;
      for (std::size_t j = 0; j < candidate.size(); ++j) {
        if (axis_of_(j) == axis) candidate[j] = fit(candidate[j] - best_[i]);
      }
      better |= accept(candidate);
    }
    return better;
  }

  bool round_all() {
    double most = 0;
    for (const double x : best_) most = std::max(most, std::fabs(x));
    if (most == 0) return false;
    const int top = std::ilogb(most);
    for (int exponent = top; exponent > top - 30;
         --exponent) {  // coarse first: the first that holds is the best
      std::vector<double> candidate = best_;
      for (double& x : candidate) x = to_grid(x, exponent);
      if (accept(candidate)) return true;
    }
    return false;
  }

  bool simplify(std::size_t i) {
    bool better = try_number(i, 0) || try_number(i, 1);
    for (std::size_t j = 0; j < best_.size(); ++j) {
      if (j != i && axis_of_(j) == axis_of_(i)) better |= try_number(i, best_[j]);
    }
    for (int bits = 1; bits < 24; ++bits) {
      if (try_number(i, to_bits(best_[i], bits))) {
        better = true;
        break;
      }
    }
    return better;
  }

  bool try_number(std::size_t i, double value) {
    if (best_[i] == value) return false;
    std::vector<double> candidate = best_;
    candidate[i] = value;
    return accept(candidate);
  }

  [[nodiscard]] double fit(double x) const {
    return scalar_ == scene::Scalar::f32 &&
                   std::fabs(x) <= static_cast<double>(std::numeric_limits<float>::max())
               ? static_cast<double>(static_cast<float>(x))
               : x;
  }

  std::vector<double> best_;
  scene::Scalar scalar_;
  const AxisOfNumber& axis_of_;
  const StillFails& still_fails_;
  int left_;
  double cost_;
};

}  // namespace

double complexity(const std::vector<double>& numbers) {
  double sum = 0;
  for (const double x : numbers) sum += complexity_of(x);
  return sum;
}

std::vector<double> shrink(std::vector<double> numbers, scene::Scalar scalar, const AxisOfNumber& axis_of,
                           const StillFails& still_fails, int most_trials) {
  return Shrinker(std::move(numbers), scalar, axis_of, still_fails, most_trials).run();
}

}  // namespace gnomon::fuzz
