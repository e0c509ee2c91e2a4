// SPDX-License-Identifier: GPL-3.0-or-later
// A path that is tested against the boxes of a node. Compiled once an instruction set: see
// hierarchy_walk_inl.h.

namespace gnomon::exact::GNOMON_EXACT_TARGET {

/// The lower bounds that a test of boxes finds, readable lane by lane; +0 or more.
union alignas(32) NearBounds {
  Float8 lanes;
  float of[kNodeLanes];
  std::uint32_t bits[kNodeLanes];
};

/// A path in the frame, for boxes that may hold a point of the closed path with t <= latest.
///
/// On each axis it has two origins and two inverse directions, rounded so that the t of the near side comes
/// out too small and that of the far side too large: by monotony nothing else than the two roundings of
/// each t is left to bound. Where a true near t is at most the true far t, both not negative, the computed
/// ones are at most (1 + u)^2 too large and (1 - u)^2 too small, u = 2^-24, and 2^-150 more where a product
/// underflows; kWiden and kTiny more than make up for it, and for the two roundings that they bring. A
/// negative near t counts as 0; a negative far t is negative as computed, since a difference of floats has
/// the sign of the exact one. An axis that tells nothing (0 times infinity) comes out as NaN, which no
/// comparison below lets through.
class alignas(32) BoxPath {
 public:
  BoxPath(const Frame& frame, const Path& path) {
    for (std::size_t i = 0; i < 3; ++i) {
      const double unscaled = path.kind == Path::Kind::segment ? path.to[i] - path.from[i] : path.to[i];
      const double d = unscaled * frame.scale;
      const double start = frame.map(path.from[i], i);
      const bool backwards = unscaled < 0;  // of the exact difference, too
      near_side_[i] = 2 * i + (backwards ? 1u : 0u);
      const float below = float_below(start), above = float_above(start);
      set_all(near_origin_[i], backwards ? below : above);
      set_all(far_origin_[i], backwards ? above : below);
      if (unscaled == 0) {
        set_all(near_inverse_[i], kInfinity);
        set_all(far_inverse_[i], kInfinity);
      } else if (!(std::fabs(d) <= 1e300 && std::fabs(d) >= 1e-290)) {
        // Over- or underflow may have hit d or will hit 1 / d: only the side that the path leaves by counts.
        set_all(near_inverse_[i], 0);
        set_all(far_inverse_[i], backwards ? -kInfinity : kInfinity);
      } else {
        const double inverse = 1 / std::fabs(d);
        const float least = std::max(0.0f, float_below(inverse)), greatest = float_above(inverse * kWiden);
        set_all(near_inverse_[i], backwards ? -least : least);
        set_all(far_inverse_[i], backwards ? -greatest : greatest);
      }
    }
  }

  /// The children whose boxes can't be left out, a bit each, with lower bounds on t.
  [[nodiscard, gnu::always_inline]] unsigned test(const WideNode& node, float latest,
                                                  NearBounds& bounds) const {
    Float8 near{}, far;
    set_all(far, latest * kWiden);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t side = near_side_[i];
      const Float8 in = (node.sides[side] - near_origin_[i]) * near_inverse_[i];
      const Float8 out = (node.sides[side ^ 1u] - far_origin_[i]) * far_inverse_[i];
      near = in > near ? in : near;
      far = out < far ? out : far;
    }
    bounds.lanes = near;
    const Int8 open = near <= far + kTiny;
    return mask_of(open) & node.used;
  }

  /// True when something at this lower bound may still be no later than `latest`.
  [[nodiscard]] static bool in_time(float near, float latest) { return near <= latest * kWiden + kTiny; }

 private:
  [[gnu::always_inline]] static void set_all(Float8& lanes, float x) {
    lanes = Float8{x, x, x, x, x, x, x, x};
  }

  static constexpr float kWiden = 1 + 0x1p-20f, kTiny = 1e-37f;

  std::array<Float8, 3> near_origin_, far_origin_, near_inverse_, far_inverse_;
  std::array<std::size_t, 3> near_side_;
};

}  // namespace gnomon::exact::GNOMON_EXACT_TARGET
