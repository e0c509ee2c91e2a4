// SPDX-License-Identifier: GPL-3.0-or-later
// Contacts of a path in plain doubles, where their rounding surely doesn't matter. Compiled once an
// instruction set: see hierarchy_walk_inl.h.

namespace gnomon::exact::GNOMON_EXACT_TARGET {

/// Whether a path meets a face. `none`: not even the closed path has a common point with the face. `plain`:
/// as ContactKind::plain.
enum class Certain : std::uint8_t { unknown, none, plain };

/// The same of a leaf's triangles, a bit each.
struct CertainTriangles {
  unsigned none = 0, plain = 0;
};

/// Bounds on t, readable lane by lane.
union alignas(32) HitLanes {
  Double4 lanes;
  double of[kLeafLanes];
};

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

  /// The triangles of a leaf, for a segment. What lanes without a triangle yield means nothing.
  template <class F>
  [[nodiscard, gnu::always_inline]] CertainTriangles segment_and(const Leaf<F>& leaf) const {
    Sides s;
    see(leaf, s);
    const Double4 beyond = s.volume - s.across;
    const Double4 least = s.volume < beyond ? s.volume : beyond, most = s.volume < beyond ? beyond : s.volume;
    const Int64x4 apart = (least > s.error) | (most < -s.error);
    const Int64x4 crosses = (least < -s.error) & (most > s.error);
    const Int64x4 none = s.valid & (s.misses | apart), plain = s.valid & s.inside & crosses;
    return {mask_of(none), mask_of(plain)};
  }

  /// The same for a ray, with bounds on the t of plain contacts.
  template <class F>
  [[nodiscard, gnu::always_inline]] CertainTriangles ray_and(const Leaf<F>& leaf, HitLanes& earliest,
                                                             HitLanes& latest) const {
    Sides s;
    see(leaf, s);
    // A ray goes on to where f(t) = volume - t * across has the sign of -across.
    Double4 up, down;
    magnitude(s.volume, up);
    magnitude(s.across, down);
    const Int64x4 sure = s.valid & (up > s.error) & (down > s.error);
    const Int64x4 behind = (s.volume > 0) ^ (s.across > 0);
    const Int64x4 none = (s.valid & s.misses) | (sure & behind), plain = sure & s.inside & ~behind;
    earliest.lanes = (up - s.error) / (down + s.error) * (1 - 8 * kUnit);
    latest.lanes = (up + s.error) / (down - s.error) * (1 + 8 * kUnit);
    return {mask_of(none), mask_of(plain)};
  }

  /// A ball of a leaf.
  template <class F>
  [[nodiscard]] Certain ball(const Leaf<F>& leaf, std::size_t lane) const {
    const double x = from_[0] - leaf.c[0][lane], y = from_[1] - leaf.c[1][lane],
                 z = from_[2] - leaf.c[2][lane], r = leaf.c[3][lane];
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

  /// Where a path passes the triangles of a leaf.
  struct alignas(32) Sides {
    Double4 volume, across;  ///< n * a for the start, and n * d
    Double4 error;           ///< of these and their difference
    Int64x4 misses, inside;  ///< certainly on different sides of two edges; on the same side of all three
    Int64x4 valid;           ///< nothing has overflowed
  };

  template <class F>
  [[gnu::always_inline]] void see(const Leaf<F>& leaf, Sides& s) const {
    alignas(32) std::array<Double4, 9> v;
    Double4 reach{};
    for (std::size_t i = 0; i < 9; ++i) {
      v[i] = __builtin_convertvector(leaf.c[i], Double4) - from_[i % 3];
      Double4 size;
      magnitude(v[i], size);
      reach = size > reach ? size : reach;
    }
    s.valid = reach + length_ <= kLargest;
    // b x c, c x a, a x b: each coordinate has two terms of at most R^2.
    const Double4 ux = v[4] * v[8] - v[5] * v[7], uy = v[5] * v[6] - v[3] * v[8],
                  uz = v[3] * v[7] - v[4] * v[6];
    const Double4 wx = v[7] * v[2] - v[8] * v[1], wy = v[8] * v[0] - v[6] * v[2],
                  wz = v[6] * v[1] - v[7] * v[0];
    const Double4 xx = v[1] * v[5] - v[2] * v[4], xy = v[2] * v[3] - v[0] * v[5],
                  xz = v[0] * v[4] - v[1] * v[3];
    const Double4 u = d_[0] * ux + d_[1] * uy + d_[2] * uz;
    const Double4 w = d_[0] * wx + d_[1] * wy + d_[2] * wz;
    const Double4 x = d_[0] * xx + d_[1] * xy + d_[2] * xz;
    // Eight roundings a term (three differences, two products, three sums), terms of 2 R^2 D in sum: 16 u.
    const Double4 square = reach * reach, side_error = 20 * kUnit * square * length_ + kTiny;
    Double4 least = u < w ? u : w, most = u < w ? w : u;
    least = x < least ? x : least;
    most = x > most ? x : most;
    s.misses = (least < -side_error) & (most > side_error);
    s.inside = (least > side_error) | (most < -side_error);
    // n * a for the start, less n * d for the end. Terms of 6 R^3 and 6 R^2 D in sum; eight roundings for the
    // first, ten for the second, and one for the difference.
    s.volume = v[0] * ux + v[1] * uy + v[2] * uz;
    s.across = u + w + x;
    s.error = 90 * kUnit * square * (reach + length_) + kTiny;
  }

  [[gnu::always_inline]] static void magnitude(const Double4& x, Double4& size) {
    const Int64x4 bits = reinterpret_cast<Int64x4>(x) & std::numeric_limits<std::int64_t>::max();
    size = reinterpret_cast<Double4>(bits);
  }

  std::array<double, 3> from_, d_{};
  double length_ = 0;
  bool bounded_;
};

}  // namespace gnomon::exact::GNOMON_EXACT_TARGET
