// SPDX-License-Identifier: GPL-3.0-or-later
// The registry rows of shaft-oriented-box. Adding a method is a function here (or a file) and a row in the
// table.
#include "fast/shaft_oriented_box.h"
#include "fuzz/volume_rows.h"

namespace gnomon::fuzz {

namespace {

using Rows = VolumeRows<ShaftOrientedBoxQuestion, FormSupportShaft>;
using fast::Rigour;

template <class F, fast::FurtherAxes kAxes>
void separating(Rows::Cases<F> cases, Rows::Answers answers) {
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const fast::SupportShaft<F> shaft = fast::form_support_shaft(cases[i].a, cases[i].b);
    answers[i] = to_answer(fast::classify_separating(shaft, cases[i].t, kAxes));
  }
}

constexpr fast::FurtherAxes kUsual = fast::FurtherAxes::faces_and_box_edges, kAll = fast::FurtherAxes::all;

using Row = Method<ShaftOrientedBoxQuestion>;
const Row kRows[] = {
    {"trivial", "trivial", Promise::never_unsound, Twin::always_overlap, "all finite numbers",
     "always overlap: the floor", Rows::trivial<float>, Rows::trivial<double>},
    {"naive-f32", "naive", Promise::none, Twin::planes, kAllFloats,
     "sides and planes by how far the box reaches along their normals",
     Rows::by_planes<float, Rigour::naive>},
    {"naive-f64", "naive", Promise::none, Twin::planes, kAllDoubles, "the same in doubles", nullptr,
     Rows::by_planes<double, Rigour::naive>},
    {"separating-f32", "naive", Promise::none, Twin::separating, kAllFloats,
     "naive-f32, then the face normals and u x e: the usual test of separating axes",
     separating<float, kUsual>},
    {"separating-all-f32", "naive", Promise::none, Twin::truth, kAllFloats,
     "also u x the edges between both reference boxes: no model error", separating<float, kAll>},
    {"separating-all-f64", "naive", Promise::none, Twin::truth, kAllDoubles, "the same in doubles", nullptr,
     separating<double, kAll>},
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
std::span<const Row> methods<ShaftOrientedBoxQuestion>() {
  return kRows;
}

}  // namespace gnomon::fuzz
