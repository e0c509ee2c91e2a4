// SPDX-License-Identifier: GPL-3.0-or-later
// The registry rows of shaft-sphere. Adding a method is a function here (or a file) and a row in the table.
#include "exact/shaft_ball.h"
#include "fast/certified_shaft.h"
#include "fast/shaft_ball.h"
#include "fast/slab_ball.h"
#include "fuzz/batch_runs.h"
#include "fuzz/shaft_questions.h"

namespace gnomon::fuzz {

namespace {

using scene::Category;
template <class F>
using Cases = std::span<const scene::ShaftBallCaseOf<F>>;
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
    const fast::Shaft<F> shaft = fast::form_shaft(cases[i].a, cases[i].b, fast::Normals::unit);
    answers[i] = to_answer(fast::classify_as_printed(shaft, cases[i].t));
  }
}

template <class F>
void naive(Cases<F> cases, Answers answers) {
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const fast::Shaft<F> shaft = fast::form_shaft(cases[i].a, cases[i].b, fast::Normals::unit);
    answers[i] = to_answer(fast::classify(shaft, cases[i].t).answer);
  }
}

template <class F>
void slab(Cases<F> cases, Answers answers) {
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const fast::Shaft<F> shaft = fast::form_shaft(cases[i].a, cases[i].b, fast::Normals::as_formed);
    answers[i] = to_answer(fast::classify_by_slabs(shaft, cases[i].t));
  }
}

template <class F>
void certified(Cases<F> cases, Answers answers) {
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const fast::Shaft<F> shaft = fast::form_certified_ball_shaft(cases[i].a, cases[i].b);
    answers[i] = to_answer(fast::classify(shaft, cases[i].t).answer);
  }
}

template <class F>
double stated_gap(const scene::ShaftBallCaseOf<F>& c) {
  return static_cast<double>(fast::form_certified_ball_shaft(c.a, c.b).stated_gap.at(c.t.radius));
}

template <class F>
void exact_tier(Cases<F> cases, Answers answers) {
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const fast::Shaft<F> shaft = fast::form_certified_ball_shaft(cases[i].a, cases[i].b);
    const fast::Banded banded = fast::classify(shaft, cases[i].t);
    answers[i] =
        to_answer(banded.certain ? banded.answer : exact::classify(scene::converted<double>(cases[i])));
  }
}

template <class F, BatchTier kTier>
void batch(Cases<F> cases, Answers answers) {
  answer_in_runs<BallRun<F>>(
      cases, answers, [](const auto& a, const auto& b, const fast::BallsSoA<F>& balls, Answers out) {
        if constexpr (kTier == BatchTier::naive) {
          fast::classify_balls<F>(fast::form_shaft(a, b, fast::Normals::unit), balls, out);
        } else if constexpr (kTier == BatchTier::certified) {
          fast::classify_balls<F>(fast::form_certified_ball_shaft(a, b), balls, out);
        } else {
          fast::classify_balls_exact<F>({a, b}, balls, out, [&](const scene::Ball<F>& t) {
            return exact::classify(scene::converted<double>(scene::ShaftBallCaseOf<F>{a, b, t}));
          });
        }
      });
}

constexpr std::string_view kAllFloats = "all finite floats", kAllDoubles = "all finite doubles";

using Row = Method<ShaftBallQuestion>;
const Row kRows[] = {
    {"trivial", "trivial", Promise::never_unsound, Twin::always_overlap, "all finite numbers",
     "always overlap: the floor", trivial<float>, trivial<double>},
    {"printed-f32", "naive", Promise::none, Twin::printed, kAllFloats,
     "the paper to the letter: early end at a reference box, T > -radius taken for inside", printed<float>},
    {"naive-f32", "naive", Promise::none, Twin::planes, kAllFloats, "Arvo's test and unit planes, corrected",
     naive<float>},
    {"naive-f64", "naive", Promise::none, Twin::planes, kAllDoubles, "the same in doubles", nullptr,
     naive<double>},
    {"slab-f32", "naive", Promise::none, Twin::truth, kAllFloats,
     "least squared distance over s, no false positives", slab<float>},
    {"slab-f64", "naive", Promise::none, Twin::truth, kAllDoubles, "the same in doubles", nullptr,
     slab<double>},
    {"certified-f32", "certified", Promise::never_unsound, Twin::planes, kAllFloats,
     "the naive kernel on shortened normals, proved thresholds and slacks", certified<float>, nullptr,
     stated_gap<float>},
    {"certified-f64", "certified", Promise::never_unsound, Twin::planes, kAllDoubles, "the same in doubles",
     nullptr, certified<double>, nullptr, stated_gap<double>},
    {"exact", "exact", Promise::always_agrees, Twin::truth, "all finite numbers",
     "certified, what its band leaves open by exact predicate", exact_tier<float>, exact_tier<double>},
    {"batch-naive-f32", "naive", Promise::none, Twin::planes, kAllFloats,
     "naive-f32 in vector registers, for many balls a shaft: uniform@64", batch<float, BatchTier::naive>,
     nullptr, nullptr, nullptr, true},
    {"batch-certified-f32", "certified", Promise::never_unsound, Twin::planes, kAllFloats,
     "certified-f32 in vector registers", batch<float, BatchTier::certified>, nullptr, stated_gap<float>,
     nullptr, true},
    {"batch-certified-f64", "certified", Promise::never_unsound, Twin::planes, kAllDoubles,
     "certified-f64 in vector registers", nullptr, batch<double, BatchTier::certified>, nullptr,
     stated_gap<double>, true},
    {"batch-exact", "exact", Promise::always_agrees, Twin::truth, "all finite numbers",
     "certified, exact on grids, certificates in doubles, exact predicate; all but the last in vector "
     "registers",
     batch<float, BatchTier::exact>, batch<double, BatchTier::exact>, nullptr, nullptr, true},
};

}  // namespace

template <>
std::span<const Row> methods<ShaftBallQuestion>() {
  return kRows;
}

}  // namespace gnomon::fuzz
