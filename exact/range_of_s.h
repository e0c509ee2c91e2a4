// SPDX-License-Identifier: GPL-3.0-or-later
// Which s of 0 to 1 satisfy inequalities that are linear in s. Internal to exact/: includes CGAL.
#pragma once

#include <optional>

#include "exact/number.h"

namespace gnomon::exact {

/// Do s = 0 and s = 1 belong to the range?
enum class Ends : std::uint8_t { closed, open };

/// (1-s) at0 + s at1 >= 0.
template <class FT>
struct LinearInS {
  FT at0, at1;
};

/// The s that satisfy all inequalities so far, by the one that bounds them closest from below and the one
/// from above: no division. For numbers without unknown signs.
template <class FT>
class RangeOfS {
 public:
  explicit RangeOfS(Ends ends) : open_(ends == Ends::open) {}

  /// False when no s is left.
  bool add(LinearInS<FT> f) {
    const int at0 = static_cast<int>(sign_of(f.at0)), at1 = static_cast<int>(sign_of(f.at1));
    if (at0 >= 0 && at1 >= 0) return true;
    if (at0 < 0 && (at1 < 0 || (open_ && at1 == 0))) return false;
    if (open_ && at0 == 0) return false;
    if (at0 < 0) {
      // s >= -at0 / (at1 - at0), which grows with -at0 / at1.
      if (lower_ && sign_of(FT(f.at0 * lower_->at1 - lower_->at0 * f.at1)) != Sign::negative) return true;
      lower_ = std::move(f);
    } else {
      // s <= at0 / (at0 - at1).
      if (upper_ && sign_of(FT(upper_->at0 * f.at1 - f.at0 * upper_->at1)) != Sign::negative) return true;
      upper_ = std::move(f);
    }
    return !lower_ || !upper_ ||
           sign_of(FT(upper_->at0 * lower_->at1 - lower_->at0 * upper_->at1)) != Sign::negative;
  }

  /// What bounds the range closest; nothing where 0 or 1 does.
  [[nodiscard]] const std::optional<LinearInS<FT>>& lower() const { return lower_; }
  [[nodiscard]] const std::optional<LinearInS<FT>>& upper() const { return upper_; }

 private:
  bool open_;
  std::optional<LinearInS<FT>> lower_, upper_;
};

/// The same for intervals, between two ranges of doubles: what the greatest values of all inequalities leave,
/// and what the least ones do. Valid in any rounding mode, for values up to 1e300.
class RangeFilter {
 public:
  using FT = FilterKernel::FT;

  explicit RangeFilter(Ends ends) : open_(ends == Ends::open) {}

  /// The same for doubles that are off by a rounding each, and so have the right signs.
  bool add(const LinearInS<double>& f) {
    if (!add(f.at0, f.at1, outer_, -1)) return false;
    if (some_ && !add(f.at0, f.at1, inner_, 1)) some_ = false;
    return outer_.lo <= outer_.hi;
  }
  /// False when no s is left, surely.
  bool add(const LinearInS<FT>& f) {
    if (!add(f.at0.sup(), f.at1.sup(), outer_, -1)) return false;
    if (some_ && !add(f.at0.inf(), f.at1.inf(), inner_, 1)) some_ = false;
    return outer_.lo <= outer_.hi;
  }

  /// True when some s is left, surely.
  [[nodiscard]] bool has_some() const {
    return some_ && inner_.lo <= inner_.hi && !(open_ && (inner_.lo >= 1 || inner_.hi <= 0));
  }

 private:
  struct Bounds {
    double lo = 0, hi = 1;
  };

  /// Each quotient has two roundings, and those of its numbers, of 2^-52 at most in any mode: five in all, as
  /// nothing cancels. It may underflow, too. `inwards` (1 or -1) is the way that it is pushed by more than
  /// these; a bound of 0 or 1 is known as such, and stays.
  bool add(double at0, double at1, Bounds& bounds, int inwards) const {
    if (at0 >= 0 && at1 >= 0) return true;
    if (!(at0 >= 0)) {
      if (!(at1 >= 0) || (open_ && at1 == 0)) return false;
      const double lo = at0 / (at0 - at1);
      bounds.lo = at1 == 0 ? 1 : std::fmax(bounds.lo, lo + inwards * (lo * 0x1p-49 + kTiny));
      return true;
    }
    if (open_ && at0 == 0) return false;
    const double hi = at0 / (at0 - at1);
    bounds.hi = at0 == 0 ? 0 : std::fmin(bounds.hi, hi - inwards * (hi * 0x1p-49 + kTiny));
    return true;
  }

  static constexpr double kTiny = 1e-300;

  bool open_, some_ = true;
  Bounds outer_, inner_;
};

}  // namespace gnomon::exact
