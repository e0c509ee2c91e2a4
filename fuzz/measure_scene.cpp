// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/measure_scene.h"

#include <chrono>
#include <ctime>
#include <memory>
#include <stdexcept>

#include "exact/hierarchy.h"
#include "fuzz/lights.h"
#include "scene/single.h"

namespace gnomon::fuzz {
namespace {

using Clock = std::chrono::steady_clock;
using Queries = std::vector<scene::ShadowQuery>;

/// The processor time of this thread: what other programs take does not count.
double now_ns() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e9 + static_cast<double>(now.tv_nsec);
}

/// A method that is ready, with its answers and times for the workload at hand.
struct Contender {
  const SceneMethod* method;
  std::unique_ptr<SceneCaster> caster;
  std::vector<Answer> answers;
  std::vector<double> image_ns, shuffled_ns;  // a query, of each round

  double ask(const Queries& queries) {
    const double start = now_ns();
    caster->shadows(queries, answers);
    return (now_ns() - start) / static_cast<double>(queries.size());
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
      if (method->every_face && !options_.chosen &&
          scene_.face_count() > kMostTests / options_.workload.queries) {
        note(what + " left out: " + std::to_string(scene_.face_count()) +
             " faces for every query; --method asks it all the same");
        continue;
      }
      contenders_.push_back({method, nullptr, {}, {}, {}});
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
    const Oracle oracle{[this](const scene::RayQuery& ray) {
                          const std::vector<std::uint32_t> faces = truth_.first_hit(ray).faces;
                          return faces.empty() ? scene::kNoFace : faces.front();
                        },
                        [this](const scene::ShadowQuery& query) { return truth_.shadow(query).answer; }};
    const Workload workload = record_workload(kind, scene_, oracle, options_.workload);
    if (workload.queries.empty()) {
      note(kind + " left out: the scene asks no such query");
      return;
    }
    std::vector<exact::ShadowTruth> truths;
    truths.reserve(workload.queries.size());
    for (const scene::ShadowQuery& query : workload.queries) truths.push_back(truth_.shadow(query));

    Queries shuffled;
    const std::vector<std::uint32_t> order = shuffled_order(workload.queries.size());
    for (const std::uint32_t i : order) shuffled.push_back(workload.queries[i]);
    std::vector<ShadowRow> rows;
    for (Contender& contender : contenders_) {
      progress(kind, 0);
      rows.push_back(judge(contender, workload, truths));
      const std::vector<Answer> in_order = contender.answers;
      contender.ask(shuffled);
      for (std::size_t i = 0; i < order.size(); ++i) {
        rows.back().changed_by_order += contender.answers[i] != in_order[order[i]] ? 1U : 0U;
      }
    }
    time_rounds(kind, workload.queries, shuffled);
    for (std::size_t i = 0; i < contenders_.size(); ++i) {
      measurement_.rows.push_back(std::move(rows[i]));
      measurement_.times.push_back(
          {spread_of(contenders_[i].image_ns), spread_of(contenders_[i].shuffled_ns)});
    }
  }

  ShadowRow judge(Contender& contender, const Workload& workload,
                  const std::vector<exact::ShadowTruth>& truths) {
    ShadowRow row;
    row.scene = name_;
    row.variant = variant_.name;
    row.workload = workload.name;
    row.faces = scene_.face_count();
    row.method = contender.method;
    contender.answers.assign(workload.queries.size(), kRejected);
    contender.ask(workload.queries);
    for (std::size_t i = 0; i < truths.size(); ++i) {
      const auto truth = static_cast<std::size_t>(truths[i].answer);
      ++row.matrix[truth][contender.answers[i]];
      if (truths[i].touching) ++row.touching[truth][contender.answers[i]];
    }
    row.tests = contender.caster->count_tests(workload.queries);
    return row;
  }

  void time_rounds(const std::string& kind, const Queries& image, const Queries& shuffled) {
    for (Contender& contender : contenders_) {
      contender.image_ns.clear();
      contender.shuffled_ns.clear();
    }
    const std::size_t count = contenders_.size();
    for (unsigned round = 0; round < options_.rounds; ++round) {
      for (std::size_t i = 0; i < count; ++i) {
        progress(kind, (round + static_cast<double>(i) / static_cast<double>(count)) / options_.rounds);
        // Every other round backwards, so that nobody always follows the same neighbour.
        Contender& contender = contenders_[round % 2 == 0 ? i : count - 1 - i];
        contender.image_ns.push_back(contender.ask(image));
        contender.shuffled_ns.push_back(contender.ask(shuffled));
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
  SceneMeasurer(name, single.scene, variant, options, measurement, on_progress).run();
}

}  // namespace gnomon::fuzz
