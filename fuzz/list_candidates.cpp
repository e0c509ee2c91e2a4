// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/list_candidates.h"

#include <mutex>
#include <utility>
#include <vector>

#include "exact/polygons.h"
#include "fast/list_builder.h"

namespace gnomon::fuzz {

namespace {

class ListFinder final : public CandidateFinder {
 public:
  ListFinder(const scene::Scene& scene, const ListSetup& setup)
      : scene_(scene),
        options_(setup.options),
        tree_(scene, exact::polygons_of(scene), setup.tree, setup.volumes, setup.seed) {}

  void faces(const BoxPair& pair, std::vector<std::uint32_t>& out) const override {
    std::unique_ptr<Work> work = take();
    fast::Reference emitter, receiver;
    emitter.box = pair.a;
    receiver.box = pair.b;
    work->builder.begin_emitter(emitter);
    work->builder.build(receiver, 0, work->list);
    out.clear();
    fast::append_faces(tree_, work->list, out);
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(work));
  }

 private:
  /// What one thread needs at a time.
  struct Work {
    Work(const fast::ItemTree& tree, const scene::Scene& scene, const fast::ListOptions& options)
        : builder(tree, scene, options) {}
    fast::ListBuilder builder;
    fast::CandidateList list;
  };

  std::unique_ptr<Work> take() const {
    {
      const std::lock_guard lock(mutex_);
      if (!idle_.empty()) {
        std::unique_ptr<Work> work = std::move(idle_.back());
        idle_.pop_back();
        return work;
      }
    }
    return std::make_unique<Work>(tree_, scene_, options_);
  }

  const scene::Scene& scene_;
  const fast::ListOptions options_;
  const fast::ItemTree tree_;
  mutable std::mutex mutex_;
  mutable std::vector<std::unique_ptr<Work>> idle_;
};

template <fast::Strategy strategy, fast::Arithmetic arithmetic, fast::Volumes volumes = fast::Volumes::boxes>
std::unique_ptr<CandidateFinder> make(const scene::Scene& scene) {
  ListSetup setup;
  setup.options.strategy = strategy;
  setup.options.arithmetic = arithmetic;
  setup.volumes = volumes;
  return make_list_finder(scene, setup);
}

using fast::Arithmetic;
using fast::Strategy;
using fast::Volumes;

constexpr std::string_view kDomain = "all finite floats; balls within their range";

const CandidateMethod kRows[] = {
    {"list-keep-closed-naive-f32", "naive", Promise::none, kDomain,
     "the paper's list: volumes that meet the shaft stay closed",
     make<Strategy::keep_closed, Arithmetic::naive>},
    {"list-always-open-naive-f32", "naive", Promise::none, kDomain,
     "the paper's list: every volume that meets the shaft is opened",
     make<Strategy::always_open, Arithmetic::naive>},
    {"list-overlap-open-naive-f32", "naive", Promise::none, kDomain,
     "the paper's list: volumes inside the shaft stay closed",
     make<Strategy::overlap_open, Arithmetic::naive>},
    {"list-ratio-open-naive-f32", "naive", Promise::none, kDomain,
     "the paper's list: opened up to a ratio of 0.4, with mailbox marks",
     make<Strategy::ratio_open, Arithmetic::naive>},
    {"list-spheres-naive-f32", "naive", Promise::none, kDomain,
     "ratio open, with spheres as bounding volumes",
     make<Strategy::ratio_open, Arithmetic::naive, Volumes::spheres>},
    {"list-keep-closed-certified-f32", "certified", Promise::never_unsound, kDomain,
     "keep closed, with the certified shaft", make<Strategy::keep_closed, Arithmetic::certified>},
    {"list-always-open-certified-f32", "certified", Promise::never_unsound, kDomain,
     "always open, with the certified shaft", make<Strategy::always_open, Arithmetic::certified>},
    {"list-overlap-open-certified-f32", "certified", Promise::never_unsound, kDomain,
     "overlap open, with the certified shaft", make<Strategy::overlap_open, Arithmetic::certified>},
    {"list-ratio-open-certified-f32", "certified", Promise::never_unsound, kDomain,
     "ratio open, with the certified shaft", make<Strategy::ratio_open, Arithmetic::certified>},
    {"list-spheres-certified-f32", "certified", Promise::never_unsound, kDomain,
     "ratio open, spheres as bounding volumes and the certified sphere test",
     make<Strategy::ratio_open, Arithmetic::certified, Volumes::spheres>},
};

}  // namespace

std::unique_ptr<CandidateFinder> make_list_finder(const scene::Scene& scene, const ListSetup& setup) {
  return std::make_unique<ListFinder>(scene, setup);
}

std::span<const CandidateMethod> list_candidate_rows() {
  return kRows;
}

}  // namespace gnomon::fuzz
