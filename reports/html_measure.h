// SPDX-License-Identifier: GPL-3.0-or-later
// The report's part on measured scenes.
#pragma once

#include <span>
#include <string>

#include "reports/measure_rows.h"

namespace gnomon::reports {

/// Speed against error and a table for each workload of each scene, with the picture SCENE.png where one lies
/// beside the result file; empty without files.
[[nodiscard]] std::string measure_section(std::span<const MeasureFile> files);

/// For the top of the page: whether promises held on scenes, and how often each tier was wrong there, with
/// the 95 % interval. The reference is not counted: it is what judges. Empty without files.
[[nodiscard]] std::string measure_verdict(std::span<const MeasureFile> files);

}  // namespace gnomon::reports
