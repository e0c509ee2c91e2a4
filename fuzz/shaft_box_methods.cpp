// SPDX-License-Identifier: GPL-3.0-or-later
// The registry rows of shaft-box. Adding a method is a function here (or a file) and a row in the table.
#include "exact/shaft_box.h"
#include "fast/certified_shaft.h"
#include "fast/shaft_box.h"
#include "fast/slab_box.h"
#include "fuzz/batch_runs.h"
#include "fuzz/shaft_questions.h"

namespace gnomon::fuzz {

namespace {

using scene::Category;
template <class F>
using Cases = std::span<const scene::ShaftBoxCaseOf<F>>;
using Answers = std::span<Answer>;

Answer to_answer(Category category) {
  return static_cast<Answer>(category);
}

template <class F>
void trivial(Cases<F> cases, Answers answers) {
  for (std::size_t i = 0; i < cases.size(); ++i) answers[i] = to_answer(Category::overlap);
}

template <class F>
void printed(Cases<F> cases, Answers answers) {
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const fast::Shaft<F> shaft = fast::form_shaft(cases[i].a, cases[i].b, fast::Normals::as_formed);
    answers[i] = to_answer(fast::classify_as_printed(shaft, cases[i].t));
  }
}

template <class F, fast::Normals kNormals>
void naive(Cases<F> cases, Answers answers) {
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const fast::Shaft<F> shaft = fast::form_shaft(cases[i].a, cases[i].b, kNormals);
    answers[i] = to_answer(fast::classify(shaft, cases[i].t).answer);
  }
}

template <class F>
void slab(Cases<F> cases, Answers answers) {
  for (std::size_t i = 0; i < cases.size(); ++i) {
    answers[i] = to_answer(fast::classify_by_slabs(cases[i].a, cases[i].b, cases[i].t));
  }
}

template <class F>
void certified(Cases<F> cases, Answers answers) {
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const fast::Shaft<F> shaft = fast::form_certified_box_shaft(cases[i].a, cases[i].b);
    answers[i] = to_answer(fast::classify(shaft, cases[i].t).answer);
  }
}

template <class F>
double stated_gap(const scene::ShaftBoxCaseOf<F>& c) {
  return static_cast<double>(fast::form_certified_box_shaft(c.a, c.b).stated_gap.at(0));
}

template <class F>
void exact_tier(Cases<F> cases, Answers answers) {
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const fast::Shaft<F> shaft = fast::form_certified_box_shaft(cases[i].a, cases[i].b);
    const fast::Banded banded = fast::classify(shaft, cases[i].t);
    answers[i] =
        to_answer(banded.certain ? banded.answer : exact::classify(scene::converted<double>(cases[i])));
  }
}

template <class F, BatchTier kTier>
void batch(Cases<F> cases, Answers answers) {
  answer_in_runs<BoxRun<F>>(
      cases, answers, [](const auto& a, const auto& b, const fast::BoxesSoA<F>& boxes, Answers out) {
        if constexpr (kTier == BatchTier::naive) {
          fast::classify_boxes<F>(fast::form_shaft(a, b, fast::Normals::as_formed), boxes, out);
        } else if constexpr (kTier == BatchTier::certified) {
          fast::classify_boxes<F>(fast::form_certified_box_shaft(a, b), boxes, out);
        } else {
          fast::classify_boxes_exact<F>({a, b}, boxes, out, [&](const scene::Box<F>& t) {
            return exact::classify(scene::converted<double>(scene::ShaftBoxCaseOf<F>{a, b, t}));
          });
        }
      });
}

constexpr std::string_view kAllFloats = "all finite floats", kAllDoubles = "all finite doubles";
constexpr fast::Normals kFormed = fast::Normals::as_formed, kUnit = fast::Normals::unit;

using Row = Method<ShaftBoxQuestion>;
const Row kRows[] = {
    {"trivial", "trivial", Promise::never_unsound, Twin::always_overlap, "all finite numbers",
     "always overlap: the floor", trivial<float>, trivial<double>},
    {"printed-f32", "naive", Promise::none, Twin::printed, kAllFloats,
     "the paper to the letter: a box that meets a reference box overlaps", printed<float>},
    {"naive-f32", "naive", Promise::none, Twin::planes, kAllFloats,
     "extent box and planes as formed, corrected", naive<float, kFormed>},
    {"naive-f64", "naive", Promise::none, Twin::planes, kAllDoubles, "the same in doubles", nullptr,
     naive<double, kFormed>},
    {"normalised-f32", "naive", Promise::none, Twin::planes, kAllFloats,
     "planes divided by their length, as sphere tests need them", naive<float, kUnit>},
    {"slab-f32", "naive", Promise::none, Twin::truth, kAllFloats, "intervals of s, no planes", slab<float>},
    {"slab-f64", "naive", Promise::none, Twin::truth, kAllDoubles, "the same in doubles", nullptr,
     slab<double>},
    {"certified-f32", "certified", Promise::never_unsound, Twin::planes, kAllFloats,
     "the naive kernel on proved thresholds", certified<float>, nullptr, stated_gap<float>},
    {"certified-f64", "certified", Promise::never_unsound, Twin::planes, kAllDoubles, "the same in doubles",
     nullptr, certified<double>, nullptr, stated_gap<double>},
    {"exact", "exact", Promise::always_agrees, Twin::truth, "all finite numbers",
     "certified, what its band leaves open by exact predicate", exact_tier<float>, exact_tier<double>},
    {"batch-naive-f32", "naive", Promise::none, Twin::planes, kAllFloats,
     "naive-f32 in vector registers, for many boxes a shaft: uniform@64", batch<float, BatchTier::naive>,
     nullptr, nullptr, nullptr, true},
    {"batch-certified-f32", "certified", Promise::never_unsound, Twin::planes, kAllFloats,
     "certified-f32 in vector registers", batch<float, BatchTier::certified>, nullptr, stated_gap<float>,
     nullptr, true},
    {"batch-certified-f64", "certified", Promise::never_unsound, Twin::planes, kAllDoubles,
     "certified-f64 in vector registers", nullptr, batch<double, BatchTier::certified>, nullptr,
     stated_gap<double>, true},
    {"batch-exact", "exact", Promise::always_agrees, Twin::truth, "all finite numbers",
     "float filter, error-free doubles, exact predicate; the first two in vector registers",
     batch<float, BatchTier::exact>, batch<double, BatchTier::exact>, nullptr, nullptr, true},
};

}  // namespace

template <>
std::span<const Row> methods<ShaftBoxQuestion>() {
  return kRows;
}

}  // namespace gnomon::fuzz
