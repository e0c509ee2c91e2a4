// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/measure_scene.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <memory>
#include <stdexcept>

#include "exact/hierarchy.h"
#include "exact/shaft_candidates.h"
#include "fuzz/lights.h"
#include "fuzz/thread_time.h"
#include "scene/single.h"

namespace gnomon::fuzz {
namespace {

using Clock = std::chrono::steady_clock;
using Queries = std::vector<scene::ShadowQuery>;
using Pairs = std::vector<RadiosityPair>;
using Rays = std::vector<scene::RayQuery>;

/// Stands where a method has not answered: the number of no face.
constexpr std::uint32_t kUnanswered = 0xffff'fffd;

/// The queries of a workload of `shadow`, and the pairs that they are the rays of where it is radiosity's.
struct ShadowList {
  Queries queries;
  Pairs pairs;

  [[nodiscard]] std::size_t size() const { return queries.size(); }
};

/// In random order, with the place that each came from. Rays of a pair stay together.
std::pair<ShadowList, std::vector<std::uint32_t>> shuffled(const ShadowList& list) {
  ShadowList mixed;
  if (list.pairs.empty()) {
    std::vector<std::uint32_t> order = shuffled_order(list.size());
    for (const std::uint32_t i : order) mixed.queries.push_back(list.queries[i]);
    return {std::move(mixed), std::move(order)};
  }
  std::vector<std::uint32_t> first, order;
  std::uint32_t rays = 0;
  for (const RadiosityPair& pair : list.pairs) {
    first.push_back(rays);
    rays += static_cast<std::uint32_t>(pair.rays());
  }
  for (const std::uint32_t i : shuffled_order(list.pairs.size())) {
    mixed.pairs.push_back(list.pairs[i]);
    for (std::uint32_t ray = 0; ray < list.pairs[i].rays(); ++ray) order.push_back(first[i] + ray);
  }
  mixed.queries = queries_of(mixed.pairs);
  return {std::move(mixed), std::move(order)};
}

std::pair<Rays, std::vector<std::uint32_t>> shuffled(const Rays& rays) {
  std::vector<std::uint32_t> order = shuffled_order(rays.size());
  Rays mixed;
  mixed.reserve(rays.size());
  for (const std::uint32_t i : order) mixed.push_back(rays[i]);
  return {std::move(mixed), std::move(order)};
}

/// A method that is ready, with its answers and times for the workload at hand.
struct Contender {
  const SceneMethod* method;
  std::unique_ptr<SceneCaster> caster;
  std::vector<Answer> answers;                // to a ShadowList
  std::vector<std::uint32_t> faces;           // to Rays
  std::vector<double> image_ns, shuffled_ns;  // a query, of each round
  std::vector<double> listed_ns;              // of the pairs that have candidates

  void answer(const ShadowList& list) {
    if (method->by_pairs) return caster->pair_shadows(list.pairs, answers);
    caster->shadows(list.queries, answers);
  }
  void answer(const Rays& rays) { caster->first_hits(rays, faces); }
  [[nodiscard]] const std::vector<Answer>& answers_to(const ShadowList& /*list*/) const { return answers; }
  [[nodiscard]] const std::vector<std::uint32_t>& answers_to(const Rays& /*rays*/) const { return faces; }

  template <class List>
  double ask(const List& queries) {
    answers.resize(queries.size());
    const double start = thread_ns();
    answer(queries);
    return (thread_ns() - start) / static_cast<double>(queries.size());
  }
};

class SceneMeasurer {
 public:
  SceneMeasurer(std::string name, const scene::Scene& scene, const SceneVariant& variant,
                const MeasureOptions& options, Measurement& measurement, const OnMeasured& on_progress)
      : name_(std::move(name)),
        scene_(scene),
        variant_(variant),
        options_(options),
        measurement_(measurement),
        on_progress_(on_progress),
        truth_(scene) {}

  void run() {
    make_contenders();
    for (std::size_t i = 0; i < options_.workloads.size(); ++i) {
      from_ = static_cast<double>(i) / static_cast<double>(options_.workloads.size());
      run_workload(options_.workloads[i]);
    }
  }

 private:
  void note(const std::string& text) {
    measurement_.notes.push_back(name_ + " (" + std::string(variant_.name) + "): " + text);
  }

  void progress(const std::string& workload, double done) {
    const double share = 1 / static_cast<double>(options_.workloads.size());
    if (on_progress_) on_progress_(from_ + share * done, name_ + " " + workload);
  }

  void make_contenders() {
    // A second or so for each run over the workload.
    constexpr std::size_t kMostTests = std::size_t{1} << 27;
    for (const SceneMethod* method : options_.methods) {
      const std::string what(method->name);
      if (!method->has_balls && !scene_.balls.empty()) {
        note(what + " left out: it knows no balls");
        continue;
      }
      if (method->radiosity_alone &&
          std::none_of(options_.workloads.begin(), options_.workloads.end(), is_radiosity)) {
        if (options_.chosen) note(what + " left out: it answers workloads of radiosity alone");
        continue;
      }
      if (method->every_face && !options_.chosen &&
          scene_.face_count() > kMostTests / options_.workload.queries) {
        note(what + " left out: " + std::to_string(scene_.face_count()) +
             " faces for every query; --method asks it all the same");
        continue;
      }
      contenders_.push_back({method, nullptr, {}, {}, {}, {}, {}});
      const double seconds = set_up(contenders_.back());
      measurement_.set_ups.push_back(
          {name_, std::string(variant_.name), method, seconds, contenders_.back().caster->bytes()});
    }
  }

  /// The median of a few times that the structure is made: the first one warms up libraries. Where one takes
  /// long, it is the only one.
  double set_up(Contender& contender) const {
    std::vector<double> seconds;
    double sum = 0;
    while (seconds.size() < 5 && sum < 0.5) {
      contender.caster.reset();
      const auto start = Clock::now();
      contender.caster = contender.method->make(scene_);
      seconds.push_back(std::chrono::duration<double>(Clock::now() - start).count());
      sum += seconds.back();
    }
    return spread_of(std::move(seconds)).median;
  }

  void run_workload(const std::string& kind) {
    progress(kind, 0);
    asked_.clear();
    for (Contender& contender : contenders_) {
      if (is_radiosity(kind) || !contender.method->radiosity_alone) asked_.push_back(&contender);
    }
    const auto rays = ray_workload_kinds();
    if (std::any_of(rays.begin(), rays.end(),
                    [&](const WorkloadKind& known) { return known.name == kind; })) {
      return run_rays(kind);
    }
    const Oracle oracle{[this](const scene::RayQuery& ray) {
                          const std::vector<std::uint32_t> faces = truth_.first_hit(ray).faces;
                          return faces.empty() ? scene::kNoFace : faces.front();
                        },
                        [this](const scene::ShadowQuery& query) { return truth_.shadow(query).answer; }};
    Workload workload = record_workload(kind, scene_, oracle, options_.workload);
    const ShadowList list{std::move(workload.queries), std::move(workload.pairs)};
    std::vector<exact::ShadowTruth> truths;
    truths.reserve(list.size());
    for (const scene::ShadowQuery& query : list.queries) truths.push_back(truth_.shadow(query));
    run_queries(
        kind, list, with_candidates(list.pairs),
        [&](Contender& contender) { return judge(contender, kind, list, truths); }, measurement_.rows,
        measurement_.times);
  }

  void run_rays(const std::string& kind) {
    const Rays rays = record_rays(kind, scene_, options_.workload);
    std::vector<exact::FirstHit> truths;
    truths.reserve(rays.size());
    for (const scene::RayQuery& ray : rays) truths.push_back(truth_.first_hit(ray));
    run_queries(
        kind, rays, {}, [&](Contender& contender) { return judge(contender, kind, rays, truths); },
        measurement_.hit_rows, measurement_.hit_times);
  }

  /// The pairs that exactly have candidates: elsewhere no ray need be cast.
  ShadowList with_candidates(const Pairs& pairs) const {
    ShadowList list;
    if (pairs.empty()) return list;
    const exact::ShaftCandidates candidates(scene_);
    std::vector<std::uint32_t> faces;
    for (const RadiosityPair& pair : pairs) {
      candidates.faces(pair.from.box, pair.to.box, faces);
      std::erase_if(faces, [&](std::uint32_t face) {
        return pair.from.own.contains(face) || pair.to.own.contains(face);
      });
      if (!faces.empty()) list.pairs.push_back(pair);
    }
    list.queries = queries_of(list.pairs);
    return list;
  }

  /// Has every contender judged, asked in another order, and timed, also on the part `listed`; adds a row and
  /// its times for each.
  template <class List, class Judge, class Row>
  void run_queries(const std::string& kind, const List& queries, const List& listed, Judge judge_one,
                   std::vector<Row>& rows, std::vector<QueryTimes>& times) {
    if (queries.size() == 0) {
      note(kind + " left out: no such query was found");
      return;
    }
    const auto in_random_order = shuffled(queries);
    const List& mixed = in_random_order.first;
    const std::vector<std::uint32_t>& order = in_random_order.second;
    for (Contender* const contender : asked_) {
      progress(kind, 0);
      rows.push_back(judge_one(*contender));
      const auto in_order = contender->answers_to(queries);
      contender->ask(mixed);
      const auto& answers = contender->answers_to(queries);
      for (std::size_t i = 0; i < order.size(); ++i) {
        rows.back().changed_by_order += answers[i] != in_order[order[i]] ? 1U : 0U;
      }
    }
    time_rounds(kind, queries, mixed, listed);
    for (const Contender* const contender : asked_) {
      times.push_back({spread_of(contender->image_ns), spread_of(contender->shuffled_ns), {}});
      if (listed.size() > 0) times.back().listed = spread_of(contender->listed_ns);
    }
  }

  template <class Row>
  Row new_row(const Contender& contender, const std::string& kind) const {
    Row row;
    row.scene = name_;
    row.variant = variant_.name;
    row.workload = kind;
    row.faces = scene_.face_count();
    row.method = contender.method;
    return row;
  }

  ShadowRow judge(Contender& contender, const std::string& kind, const ShadowList& list,
                  const std::vector<exact::ShadowTruth>& truths) const {
    auto row = new_row<ShadowRow>(contender, kind);
    contender.answers.assign(list.size(), kRejected);
    contender.ask(list);
    for (std::size_t i = 0; i < truths.size(); ++i) {
      const auto truth = static_cast<std::size_t>(truths[i].answer);
      ++row.matrix[truth][contender.answers[i]];
      if (truths[i].touching) ++row.touching[truth][contender.answers[i]];
    }
    row.tests = contender.caster->count_tests(list.queries);
    row.pairs = contender.caster->count_pairs(list.pairs);
    return row;
  }

  /// What an answer comes to: every one of the tied faces is right.
  FirstHitRow::Column column_of(std::uint32_t answer, const exact::FirstHit& truth) const {
    if (answer == kUndecidedFace) return FirstHitRow::undecided;
    if (answer == scene::kNoFace) return FirstHitRow::none;
    if (answer >= scene_.face_count()) return FirstHitRow::rejected;
    return std::binary_search(truth.faces.begin(), truth.faces.end(), answer) ? FirstHitRow::right
                                                                              : FirstHitRow::wrong;
  }

  FirstHitRow judge(Contender& contender, const std::string& kind, const Rays& rays,
                    const std::vector<exact::FirstHit>& truths) const {
    auto row = new_row<FirstHitRow>(contender, kind);
    contender.faces.assign(rays.size(), kUnanswered);
    contender.ask(rays);
    for (std::size_t i = 0; i < truths.size(); ++i) {
      const std::size_t truth = truths[i].faces.empty() ? 0 : 1;
      const FirstHitRow::Column answer = column_of(contender.faces[i], truths[i]);
      ++row.matrix[truth][answer];
      if (truths[i].touching) ++row.touching[truth][answer];
      row.ties += truths[i].faces.size() > 1 ? 1U : 0U;
    }
    row.tests = contender.caster->count_hit_tests(rays);
    return row;
  }

  template <class List>
  void time_rounds(const std::string& kind, const List& image, const List& mixed, const List& listed) {
    for (Contender* const contender : asked_) {
      contender->image_ns.clear();
      contender->shuffled_ns.clear();
      contender->listed_ns.clear();
    }
    const std::size_t count = asked_.size();
    for (unsigned round = 0; round < options_.rounds; ++round) {
      for (std::size_t i = 0; i < count; ++i) {
        progress(kind, (round + static_cast<double>(i) / static_cast<double>(count)) / options_.rounds);
        // Every other round backwards, so that nobody always follows the same neighbour.
        Contender& contender = *asked_[round % 2 == 0 ? i : count - 1 - i];
        contender.image_ns.push_back(contender.ask(image));
        contender.shuffled_ns.push_back(contender.ask(mixed));
        if (listed.size() > 0) contender.listed_ns.push_back(contender.ask(listed));
      }
    }
  }

  const std::string name_;
  const scene::Scene& scene_;
  const SceneVariant& variant_;
  const MeasureOptions& options_;
  Measurement& measurement_;
  const OnMeasured& on_progress_;
  exact::Hierarchy truth_;
  std::vector<Contender> contenders_;
  std::vector<Contender*> asked_;  // those that take part in the workload at hand
  double from_ = 0;
};

}  // namespace

void measure_scene(const std::string& name, const scene::Scene& given, const SceneVariant& variant,
                   const MeasureOptions& options, Measurement& measurement, const OnMeasured& on_progress) {
  scene::Scene changed = given;
  replace_lights(changed, options.lights);
  scene::SingleScene single;
  try {
    single = scene::rounded_to_floats(transformed(changed, variant));
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(name + " (" + std::string(variant.name) + "): " + error.what());
  }
  complete(single.scene);
  if (single.moved > 0) {
    measurement.notes.push_back(
        name + " (" + std::string(variant.name) + "): rounded to floats: " + std::to_string(single.moved) +
        " points, balls and lights moved, " + std::to_string(single.merged) + " points merged");
  }
  if (options.lists) {
    const std::string where = name + " candidate lists";
    std::vector<ListRow> rows =
        measure_lists(name, single.scene, {*options.lists, (options.rounds + 2) / 3, options.checked_lists},
                      [&](double done) {
                        if (on_progress) on_progress(done, where);
                      });
    if (rows.empty()) measurement.notes.push_back(where + " left out: no two polygons face each other");
    std::move(rows.begin(), rows.end(), std::back_inserter(measurement.lists));
  }
  SceneMeasurer(name, single.scene, variant, options, measurement, on_progress).run();
}

}  // namespace gnomon::fuzz
