// SPDX-License-Identifier: GPL-3.0-or-later
// Contacts of a path in plain doubles, where their rounding surely doesn't matter. Internal to exact/.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "exact/contact.h"

namespace gnomon::exact {

/// `none`: not even the closed path has a common point with the face. `plain`: as ContactKind::plain.
enum class Certain : std::uint8_t { unknown, none, plain };

/// A path, and the sums that the bounds of the filter are written in.
///
/// Bounds. Every step rounds to (1 + e) times its exact value, |e| <= u = 2^-53; every product may also be
/// off by 2^-1074 where it underflows. R is the largest coordinate of a face seen from the start of the path,
/// D the sum of |d_i|. With R + D <= 1e100 nothing overflows, and underflow adds at most 18 * 2^-1074 * 1e200
/// < 1e-120 to any value below (degree four): kTiny. A face that leaves the filter undecided costs time, so
/// the factors are round numbers above the sums.
class PathFilter {
 public:
  explicit PathFilter(const Path& path) : from_(path.from), bounded_(path.kind == Path::Kind::segment) {
    for (std::size_t i = 0; i < 3; ++i) {
      d_[i] = bounded_ ? path.to[i] - path.from[i] : path.to[i];
      length_ += std::fabs(d_[i]);
    }
  }

  struct TriangleResult {
    Certain certain = Certain::unknown;
    HitBounds t;  ///< of a plain contact
  };

  /// The triangle with corners c[0..2], c[3..5], c[6..8].
  template <class F>
  [[nodiscard]] TriangleResult triangle(const std::array<F, 9>& c) const {
    std::array<double, 9> v;
    double reach = 0;
    for (std::size_t i = 0; i < 9; ++i) {
      v[i] = double{c[i]} - from_[i % 3];
      reach = std::max(reach, std::fabs(v[i]));
    }
    if (!(reach + length_ <= kLargest)) return {};
    // b x c, c x a, a x b: each coordinate has two terms of at most R^2.
    const double ux = v[4] * v[8] - v[5] * v[7], uy = v[5] * v[6] - v[3] * v[8],
                 uz = v[3] * v[7] - v[4] * v[6];
    const double wx = v[7] * v[2] - v[8] * v[1], wy = v[8] * v[0] - v[6] * v[2],
                 wz = v[6] * v[1] - v[7] * v[0];
    const double xx = v[1] * v[5] - v[2] * v[4], xy = v[2] * v[3] - v[0] * v[5],
                 xz = v[0] * v[4] - v[1] * v[3];
    const double u = d_[0] * ux + d_[1] * uy + d_[2] * uz;
    const double w = d_[0] * wx + d_[1] * wy + d_[2] * wz;
    const double x = d_[0] * xx + d_[1] * xy + d_[2] * xz;
    // Eight roundings a term (three differences, two products, three sums), terms of 2 R^2 D in sum: 16 u.
    const double square = reach * reach, side_error = 20 * kUnit * square * length_ + kTiny;
    const double least = std::min({u, w, x}), greatest = std::max({u, w, x});
    if (least < -side_error && greatest > side_error) return {Certain::none, {}};
    // n * a for the start, less n * d for the end. Terms of 6 R^3 and 6 R^2 D in sum; eight roundings for the
    // first, ten for the second, and one for the difference.
    const double volume = v[0] * ux + v[1] * uy + v[2] * uz, across = u + w + x, beyond = volume - across;
    const double error = 90 * kUnit * square * (reach + length_) + kTiny;
    if (bounded_) {
      if (std::min(volume, beyond) > error || std::max(volume, beyond) < -error) return {Certain::none, {}};
      const bool crosses = std::min(volume, beyond) < -error && std::max(volume, beyond) > error;
      if (!crosses || !(least > side_error || greatest < -side_error)) return {};
      return {Certain::plain, {}};
    }
    // A ray goes on to where f(t) = volume - t * across has the sign of -across.
    if (std::fabs(across) > error && std::fabs(volume) > error) {
      if ((volume > 0) != (across > 0)) return {Certain::none, {}};
      if (!(least > side_error || greatest < -side_error)) return {};
      const double up = std::fabs(volume), down = std::fabs(across);
      return {
          Certain::plain,
          {(up - error) / (down + error) * (1 - 8 * kUnit), (up + error) / (down - error) * (1 + 8 * kUnit)}};
    }
    return {};
  }

  /// The ball with centre c[0..2] and radius c[3].
  template <class F>
  [[nodiscard]] Certain ball(const std::array<F, 9>& ball) const {
    const double x = from_[0] - ball[0], y = from_[1] - ball[1], z = from_[2] - ball[2], r = ball[3];
    const double reach = std::max({std::fabs(x), std::fabs(y), std::fabs(z), r});
    if (!(reach + length_ <= kLargest)) return Certain::unknown;
    // f(t) = a t^2 + 2 b t + c as in face_contact.h. Sums of magnitudes: a of D^2, b of R D, c of 4 R^2; five
    // roundings in a and b (two of them by the difference), six in c.
    const double a = d_[0] * d_[0] + d_[1] * d_[1] + d_[2] * d_[2];
    const double b = d_[0] * x + d_[1] * y + d_[2] * z;
    const double c = x * x + y * y + z * z - r * r;
    const double square = reach * reach, error_b = 8 * kUnit * reach * length_ + kTiny,
                 error_c = 32 * kUnit * square + kTiny;
    // b^2 - a c: 4 + 1 R^2 D^2 in sum, fourteen roundings.
    const double discriminant = b * b - a * c, error_d = 100 * kUnit * square * (length_ * length_) + kTiny;
    if (c < -error_c) return a > 0 ? Certain::plain : Certain::unknown;
    if (discriminant < -error_d) return Certain::none;
    const bool away = b > error_b;
    if (!bounded_) {
      if (c > error_c && away) return Certain::none;
      return b < -error_b && discriminant > error_d ? Certain::plain : Certain::unknown;
    }
    const double scale = reach + length_, error_f = 60 * kUnit * scale * scale + kTiny;
    const double at_end = a + 2 * b + c, slope_at_end = a + b;
    const double error_s = 16 * kUnit * scale * length_ + kTiny;
    if (at_end < -error_f && a > 0) return Certain::plain;
    if (c > error_c && at_end > error_f && (away || slope_at_end < -error_s)) return Certain::none;
    if (b < -error_b && slope_at_end > error_s && discriminant > error_d) return Certain::plain;
    return Certain::unknown;
  }

 private:
  static constexpr double kUnit = 0x1p-53, kTiny = 1e-120, kLargest = 1e100;

  std::array<double, 3> from_, d_{};
  double length_ = 0;
  bool bounded_;
};

}  // namespace gnomon::exact
