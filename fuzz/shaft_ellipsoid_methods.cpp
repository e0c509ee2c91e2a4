// SPDX-License-Identifier: GPL-3.0-or-later
// The registry rows of shaft-ellipsoid. Adding a method is a function here (or a file) and a row in the
// table.
#include "fast/shaft_ellipsoid.h"
#include "fuzz/volume_rows.h"

namespace gnomon::fuzz {

namespace {

using Rows = VolumeRows<ShaftEllipsoidQuestion, FormSupportShaft>;
using fast::Rigour;

using Row = Method<ShaftEllipsoidQuestion>;
const Row kRows[] = {
    {"trivial", "trivial", Promise::never_unsound, Twin::always_overlap, "all finite numbers",
     "always overlap: the floor", Rows::trivial<float>, Rows::trivial<double>},
    {"naive-f32", "naive", Promise::none, Twin::planes, kAllFloats,
     "sides and planes by how far the ellipsoid reaches along their normals",
     Rows::by_planes<float, Rigour::naive>},
    {"naive-f64", "naive", Promise::none, Twin::planes, kAllDoubles, "the same in doubles", nullptr,
     Rows::by_planes<double, Rigour::naive>},
    {"certified-f32", "certified", Promise::never_unsound, Twin::planes, kAllFloats,
     "the naive test where its proved error lets it decide", Rows::by_planes<float, Rigour::certified>,
     nullptr, Rows::stated_gap<float>},
    {"certified-f64", "certified", Promise::never_unsound, Twin::planes, kAllDoubles, "the same in doubles",
     nullptr, Rows::by_planes<double, Rigour::certified>, nullptr, Rows::stated_gap<double>},
    {"exact", "exact", Promise::always_agrees, Twin::truth, "all finite numbers",
     "certified, what it leaves open by exact predicate", Rows::exact_tier<float>, Rows::exact_tier<double>},
};

}  // namespace

template <>
std::span<const Row> methods<ShaftEllipsoidQuestion>() {
  return kRows;
}

}  // namespace gnomon::fuzz
