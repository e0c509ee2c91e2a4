// SPDX-License-Identifier: MIT
// Walks the tree with the shaft of many rays, and tests them against the faces that it meets.
#include <algorithm>

#include "fast/hierarchy_query.h"
#include "fast/pair_shaft.h"
#include "fast/pair_tile.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fast/pair_walk.cpp"
#include <hwy/foreach_target.h>

#include "fast/pair_walk_inl.h"

HWY_BEFORE_NAMESPACE();
namespace gnomon::fast {
namespace HWY_NAMESPACE {

inline void fill_boxes(const PairPatch& patch, std::size_t step, std::vector<std::array<float, 6>>& boxes) {
  boxes.clear();
  for (std::size_t first = 0; first < patch.size(); first += step) {
    std::array<float, 6> box;
    for (std::size_t k = 0; k < 3; ++k) {
      const float* const x = patch.coordinates(k) + first;
      float lo = x[0], hi = x[0];
      // Beyond the last point are copies of it.
      for (std::size_t i = 1; i < step; ++i) {
        lo = x[i] < lo ? x[i] : lo;
        hi = x[i] > hi ? x[i] : hi;
      }
      box[k] = lo;
      box[k + 3] = hi;
    }
    boxes.push_back(box);
  }
}

template <class Tier>
PairResult PairWalk<Tier>::run(std::span<ShadowAnswer> answers) {
  shape_ = best_tile_shape(from_.size(), to_.size());
  const bool single = from_.size() <= shape_.from_count() && to_.size() <= shape_.to_count();
  Bundle bundle(from_.box, to_.box);
  skipped_ = keep_in_front(from_, to_, bundle);
  const std::uint32_t root = ChildLink::node(0).bits();
  std::span<const std::uint32_t> links{&root, 1};
  if (!single) {
    if (!share_walk(bundle)) {
      std::fill(answers.begin(), answers.end(), ShadowAnswer::lit);
      return {scene::PairVisibility::all};
    }
    links = scratch_.links;
    fill_boxes(from_, shape_.from_count(), scratch_.from_boxes);
    fill_boxes(to_, shape_.to_count(), scratch_.to_boxes);
  }
  std::uint32_t common = scene::kNoFace;
  bool has_common = true, first = true;
  for (first_from_ = 0; first_from_ < from_.size(); first_from_ += shape_.from_count()) {
    for (first_to_ = 0; first_to_ < to_.size(); first_to_ += shape_.to_count()) {
      const std::size_t rows = std::min(shape_.from_count(), from_.size() - first_from_),
                        columns = std::min(shape_.to_count(), to_.size() - first_to_);
      // Copies of the last points are left out.
      valid_ = 0;
      for (std::size_t i = 0; i < rows; ++i) valid_ |= ((1u << columns) - 1) << (i * shape_.to_count());
      live_ = valid_ & fill_tile(from_, first_from_, to_, first_to_, shape_.to_log, tile_);
      shadowed_ = undecided_ = 0;
      blocks_all_ = scene::kNoFace;
      scratch_.open.clear();
      if (live_ != 0) {
        if (single) {
          run_tile(bundle, links);
        } else {
          Bundle part(scratch_.from_boxes[first_from_ >> shape_.from_log],
                      scratch_.to_boxes[first_to_ >> shape_.to_log]);
          part.halves = bundle.halves;
          part.half_count = bundle.half_count;
          run_tile(part, links);
        }
        resolve();
      }
      has_common &= blocks_all_ != scene::kNoFace && (first || blocks_all_ == common);
      common = blocks_all_;
      first = false;
      store(answers);
    }
  }
  if (has_common) return {scene::PairVisibility::none, common};
  return {any_candidate_ ? scene::PairVisibility::part : scene::PairVisibility::all};
}

template <class Tier>
PairResult run(const PairView& view, const PairPatch& from, const PairPatch& to, PairScratch::Data& scratch,
               std::span<ShadowAnswer> answers, const ExactFaces* exact, PairCounters* counters) {
  PairWalk<Tier> walk(view, from, to, scratch, exact);
  const PairResult result = walk.run(answers);
  if (counters != nullptr) walk.add_to(*counters);
  return result;
}

PairResult run_naive(const PairView& view, const PairPatch& from, const PairPatch& to,
                     PairScratch::Data& scratch, std::span<ShadowAnswer> answers, const ExactFaces* exact,
                     PairCounters* counters) {
  return run<NaiveTier>(view, from, to, scratch, answers, exact, counters);
}
PairResult run_certified(const PairView& view, const PairPatch& from, const PairPatch& to,
                         PairScratch::Data& scratch, std::span<ShadowAnswer> answers, const ExactFaces* exact,
                         PairCounters* counters) {
  return run<CertifiedTier>(view, from, to, scratch, answers, exact, counters);
}

void list_candidates(const PairArrays& arrays, const PairPatch& from, const PairPatch& to,
                     std::vector<std::uint32_t>& faces) {
  Bundle bundle(from.box, to.box);
  const Skipped skipped = keep_in_front(from, to, bundle);
  list(arrays, bundle, skipped, faces);
}

void list_shaft_faces(const PairArrays& arrays, const std::array<float, 6>& a, const std::array<float, 6>& b,
                      std::vector<std::uint32_t>& faces) {
  list(arrays, Bundle(a, b), {}, faces);
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace gnomon::fast
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gnomon::fast {

namespace {

HWY_EXPORT(run_naive);
HWY_EXPORT(run_certified);
HWY_EXPORT(list_candidates);
HWY_EXPORT(list_shaft_faces);

}  // namespace

PairResult run_pair(Hierarchy::Tier tier, const PairView& view, const PairPatch& from, const PairPatch& to,
                    PairScratch::Data& scratch, std::span<ShadowAnswer> answers, const ExactFaces* exact,
                    PairCounters* counters) {
  if (tier == Hierarchy::Tier::naive) {
    return HWY_DYNAMIC_DISPATCH(run_naive)(view, from, to, scratch, answers, exact, counters);
  }
  return HWY_DYNAMIC_DISPATCH(run_certified)(view, from, to, scratch, answers, exact, counters);
}

void run_candidates(const PairArrays& arrays, const PairPatch& from, const PairPatch& to,
                    std::vector<std::uint32_t>& faces) {
  HWY_DYNAMIC_DISPATCH(list_candidates)(arrays, from, to, faces);
}

void run_shaft_faces(const PairArrays& arrays, const std::array<float, 6>& a, const std::array<float, 6>& b,
                     std::vector<std::uint32_t>& faces) {
  HWY_DYNAMIC_DISPATCH(list_shaft_faces)(arrays, a, b, faces);
}

}  // namespace gnomon::fast
#endif  // HWY_ONCE
