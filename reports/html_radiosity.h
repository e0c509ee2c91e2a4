// SPDX-License-Identifier: GPL-3.0-or-later
// The report's part on radiosity.
#pragma once

#include <span>
#include <string>

#include "reports/measure_rows.h"

namespace gnomon::reports {

/// The paper's Table 1 beside ours, what its text says, the options one by one, and batches of rays against
/// Embree; empty without any of these.
[[nodiscard]] std::string radiosity_section(std::span<const MeasureFile> files);

}  // namespace gnomon::reports
