// SPDX-License-Identifier: GPL-3.0-or-later
// A shaft case drawn in characters.
#pragma once

#include <string>

#include "reports/shaft_case.h"

namespace gnomon::reports {

/// The projection of deciding_view() in characters: `.` the shaft, `A` and `B` the reference boxes, `T` the
/// test volume's outline (`#` where it covers the shaft). Small volumes are drawn as one character at least.
[[nodiscard]] std::string text_picture(const ShaftCase& c);

}  // namespace gnomon::reports
