// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/list_statistics.h"

#include <algorithm>
#include <map>
#include <memory>
#include <tuple>

#include "exact/convexity.h"
#include "exact/hierarchy.h"
#include "exact/polygons.h"
#include "exact/shaft_candidates.h"
#include "exact/side_of_face.h"
#include "fuzz/list_runner.h"

namespace gnomon::fuzz {
namespace {

constexpr std::size_t kSamplesPerSide[] = {1, 2};

/// Holds lists against the exact candidates.
class ListCheck {
 public:
  ListCheck(const scene::Scene& scene, const fast::ItemTree& tree)
      : scene_(scene), tree_(tree), candidates_(scene), primitives_below_(tree.size(), 0) {
    for (std::size_t i = tree.size(); i-- > 0;) {
      const auto item = static_cast<std::uint32_t>(i);
      if (tree.item(item).is_primitive()) primitives_below_[i] = 1;
      if (tree.parent(item) != fast::kNoItem) primitives_below_[tree.parent(item)] += primitives_below_[i];
    }
  }

  void count_volumes(const fast::CandidateList& list, ListCounts& counts) const {
    for (const std::uint32_t item : list.items) {
      if (tree_.item(item).is_primitive()) continue;
      ++counts.volumes;
      counts.below_volumes += primitives_below_[item];
    }
  }

  /// `solids`: of the scene's objects those whose back faces may be missing; may be empty.
  void check(const fast::CandidateList& list, const fast::Reference& a, const fast::Reference& b,
             std::span<const std::uint8_t> solids, ListCounts& counts) {
    found_.clear();
    fast::append_faces(tree_, list, found_);
    candidates_.faces(scene::converted<double>(a.box), scene::converted<double>(b.box), exact_);
    for (std::vector<std::uint32_t>* const faces : {&found_, &exact_}) {
      std::erase_if(*faces, [&](std::uint32_t face) { return a.own.contains(face) || b.own.contains(face); });
    }
    std::sort(found_.begin(), found_.end());
    const auto has = [](const std::vector<std::uint32_t>& faces, std::uint32_t face) {
      return std::binary_search(faces.begin(), faces.end(), face);
    };
    ++counts.checked;
    counts.checked_faces += found_.size();
    counts.excess_faces += static_cast<std::uint64_t>(
        std::count_if(found_.begin(), found_.end(), [&](std::uint32_t face) { return !has(exact_, face); }));
    counts.lacking += std::any_of(exact_.begin(), exact_.end(), [&](std::uint32_t face) {
      return !has(found_, face) && reaches_before(face, a) && reaches_before(face, b) &&
             !is_back_face(face, a.box, solids);
    });
  }

 private:
  /// Whether the face has a point strictly in front of the reference item's plane, where it has one.
  [[nodiscard]] bool reaches_before(std::uint32_t face, const fast::Reference& reference) const {
    if (!reference.front || face >= scene_.triangles.size()) return true;
    std::array<Vector3, 3> plane;
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t axis = 0; axis < 3; ++axis) plane[k][axis] = (*reference.front)[k][axis];
    }
    for (std::size_t k = 0; k < 3; ++k) {
      if (exact::side_of_face(plane, scene_.corner(face, k)) > 0) return true;
    }
    return false;
  }

  /// Whether the face is one of a solid's that has all of the emitter's box behind it or in its plane.
  [[nodiscard]] bool is_back_face(std::uint32_t face, const scene::Box<float>& box,
                                  std::span<const std::uint8_t> solids) const {
    if (solids.empty() || face >= scene_.triangles.size() || solids[tree_.object_of(face)] == 0) return false;
    for (std::size_t corner = 0; corner < 8; ++corner) {
      Vector3 point;
      for (std::size_t axis = 0; axis < 3; ++axis) point[axis] = box.c[axis + ((corner >> axis) & 1) * 3];
      if (exact::side_of_face(scene_, face, point) > 0) return false;
    }
    return true;
  }

  const scene::Scene& scene_;
  const fast::ItemTree& tree_;
  const exact::ShaftCandidates candidates_;
  std::vector<std::uint64_t> primitives_below_;
  std::vector<std::uint32_t> found_, exact_;
};

class ListMeasurer {
 public:
  ListMeasurer(const std::string& name, const scene::Scene& scene, const ListMeasureOptions& options,
               const std::function<void(double)>& on_progress)
      : name_(name),
        scene_(scene),
        one_sided_(scene),
        options_(options),
        on_progress_(on_progress),
        polygons_(exact::polygons_of(scene)) {
    // Radiosity's polygons have a front alone: so the insides of solids are seen by nobody.
    for (scene::Object& object : one_sided_.objects) {
      convex_.push_back(exact::is_convex(scene, object) ? 1 : 0);
      object.one_sided = true;
    }
  }

  std::vector<ListRow> run() {
    add("table1", table1_specs());
    add("text", text_specs());
    add("own", options_.own);
    add("text", {uncached_spec()}, 1);
    add("options", option_specs(), 1);
    const exact::Hierarchy truth(scene_);
    const auto hidden = [&](const scene::ShadowQuery& query) {
      return truth.shadow(query).answer == scene::Shadow::shadowed;
    };
    for (std::size_t rate = 0; rate < 2; ++rate) {
      const std::vector<RadiosityStep> steps =
          record_steps(scene_, hidden, {options_.steps, kSamplesPerSide[rate], 0});
      const std::vector<ListStep> ready = list_steps_of(steps);
      if (ready.empty()) return {};
      run_rate(rate, ready);
    }
    return std::move(rows_);
  }

 private:
  void add(const char* table, const std::vector<ListSpec>& specs, std::size_t rates = 2) {
    for (const ListSpec& spec : specs) rows_.push_back({name_, table, spec, rates, {}, {}});
  }

  struct Tree {
    fast::ItemTree items;
    ListCheck check;

    Tree(const scene::Scene& scene, std::span<const scene::FaceRun> polygons, const ListSetup& setup)
        : items(scene, polygons, setup.tree, setup.volumes, setup.seed), check(scene, items) {}
  };

  Tree& tree_for(const ListSetup& setup) {
    std::unique_ptr<Tree>& tree = trees_[{setup.tree, setup.volumes, setup.seed}];
    if (!tree) tree = std::make_unique<Tree>(scene_, polygons_, setup);
    return *tree;
  }

  void run_rate(std::size_t rate, const std::vector<ListStep>& steps) {
    std::vector<std::unique_ptr<ListRunner>> runners;
    const auto count_of = [rate](const ListRow& row) { return row.rates > rate; };
    // Rows at one rate come last.
    const auto asked = static_cast<std::size_t>(std::count_if(rows_.begin(), rows_.end(), count_of));
    for (std::size_t i = 0; i < asked; ++i) {
      progress(rate, static_cast<double>(i) / static_cast<double>(asked) / 2);
      Tree& tree = tree_for(rows_[i].spec.setup);
      runners.push_back(std::make_unique<ListRunner>(one_sided_, tree.items, rows_[i].spec, convex_));
      rows_[i].counts[rate] = count(*runners.back(), tree, rows_[i].spec, steps);
    }
    std::vector<std::vector<double>> with_rays(asked), alone(asked);
    for (unsigned round = 0; round < options_.rounds; ++round) {
      progress(rate, 0.5 + 0.5 * round / options_.rounds);
      for (std::size_t k = 0; k < asked; ++k) {
        // Every other round backwards, as measure_scene() does.
        const std::size_t i = round % 2 == 0 ? k : asked - 1 - k;
        const ListCounts& counts = rows_[i].counts[rate];
        with_rays[i].push_back(runners[i]->time(steps, true) / at_least_one(counts.cast.rays));
        if (rows_[i].spec.start != ListStart::lists) continue;
        alone[i].push_back(runners[i]->time(steps, false) / at_least_one(counts.cull.lists));
      }
    }
    for (std::size_t i = 0; i < asked; ++i) {
      rows_[i].times[rate].ray = spread_of(std::move(with_rays[i]));
      if (!alone[i].empty()) rows_[i].times[rate].list = spread_of(std::move(alone[i]));
    }
  }

  ListCounts count(ListRunner& runner, Tree& tree, const ListSpec& spec,
                   const std::vector<ListStep>& steps) const {
    std::size_t pairs = 0, seen = 0;
    for (const ListStep& step : steps) pairs += step.pairs.size();
    const std::size_t stride = pairs / std::max<std::size_t>(options_.checked_lists, 1) + 1;
    ListCounts found;
    const std::span<const std::uint8_t> solids =
        spec.setup.options.back_faces ? std::span(convex_) : std::span<const std::uint8_t>();
    ListCounts counts =
        runner.count(steps, [&](const fast::CandidateList& list, const fast::Reference& emitter,
                                const fast::Reference& receiver) {
          tree.check.count_volumes(list, found);
          if (seen++ % stride == 0) tree.check.check(list, emitter, receiver, solids, found);
        });
    counts.checked = found.checked;
    counts.lacking = found.lacking;
    counts.checked_faces = found.checked_faces;
    counts.excess_faces = found.excess_faces;
    counts.volumes = found.volumes;
    counts.below_volumes = found.below_volumes;
    return counts;
  }

  static double at_least_one(std::uint64_t n) { return static_cast<double>(std::max<std::uint64_t>(n, 1)); }

  void progress(std::size_t rate, double done) const {
    if (on_progress_) on_progress_((static_cast<double>(rate) + done) / 2);
  }

  const std::string name_;
  const scene::Scene& scene_;
  scene::Scene one_sided_;
  const ListMeasureOptions& options_;
  const std::function<void(double)>& on_progress_;
  const std::vector<scene::FaceRun> polygons_;
  std::vector<std::uint8_t> convex_;
  std::map<std::tuple<fast::TreeBuild, fast::Volumes, std::uint32_t>, std::unique_ptr<Tree>> trees_;
  std::vector<ListRow> rows_;
};

}  // namespace

std::vector<ListRow> measure_lists(const std::string& name, const scene::Scene& scene,
                                   const ListMeasureOptions& options,
                                   const std::function<void(double done)>& on_progress) {
  return ListMeasurer(name, scene, options, on_progress).run();
}

}  // namespace gnomon::fuzz
