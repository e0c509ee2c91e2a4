// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/pair_ray_casters.h"

#include <algorithm>
#include <vector>

#include "exact/convexity.h"
#include "exact/first_hit.h"
#include "exact/shadow.h"
#include "fast/pair_visibility.h"

namespace gnomon::fuzz {
namespace {

enum class Tier : std::uint8_t { naive, certified, exact };

std::vector<std::uint8_t> convex_objects(const scene::Scene& scene) {
  std::vector<std::uint8_t> convex;
  for (const scene::Object& object : scene.objects) convex.push_back(exact::is_convex(scene, object) ? 1 : 0);
  return convex;
}

class PairRays : public SceneCaster {
 public:
  PairRays(const scene::Scene& scene, Tier tier) : caster_(scene, convex_objects(scene)), tier_(tier) {}

  /// Answers nothing: it is asked pair by pair alone.
  void shadows(std::span<const scene::ShadowQuery> /*queries*/, std::span<Answer> answers) const override {
    std::fill(answers.begin(), answers.end(), kRejected);
  }
  void first_hits(std::span<const scene::RayQuery> /*rays*/, std::span<std::uint32_t> faces) const override {
    std::fill(faces.begin(), faces.end(), kUndecidedFace);
  }
  [[nodiscard]] std::size_t bytes() const override { return caster_.bytes(); }

  void pair_shadows(std::span<const RadiosityPair> pairs, std::span<Answer> answers) const override {
    ask(pairs, answers, nullptr);
  }

  [[nodiscard]] std::optional<PairTotals> count_pairs(std::span<const RadiosityPair> pairs) const override {
    std::size_t rays = 0;
    for (const RadiosityPair& pair : pairs) rays += pair.rays();
    std::vector<Answer> answers(rays);
    fast::PairCounters counters;
    ask(pairs, answers, &counters);
    return PairTotals{counters.pairs, counters.all, counters.none, counters.faces};
  }

 private:
  using FloatPoints = std::vector<std::array<float, 3>>;

  static void take_points(const PatchSamples& samples, FloatPoints& points) {
    points.clear();
    for (const Vector3& p : samples.points) {
      points.push_back({static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])});
    }
  }

  void ask(std::span<const RadiosityPair> pairs, std::span<Answer> answers,
           fast::PairCounters* counters) const {
    static_assert(static_cast<Answer>(fast::ShadowAnswer::undecided) == kUndecided);
    fast::PairScratch scratch;
    FloatPoints from, to;
    std::vector<fast::ShadowAnswer> found;
    for (const RadiosityPair& pair : pairs) {
      take_points(pair.from, from);
      take_points(pair.to, to);
      found.resize(pair.rays());
      const fast::RayBatch batch{from, to, pair.from.own, pair.to.own};
      if (tier_ == Tier::naive) caster_.shadows_naive(batch, scratch, found, counters);
      if (tier_ == Tier::certified) caster_.shadows_certified(batch, scratch, found, counters);
      if (tier_ == Tier::exact) caster_.shadows_exact(exact_, batch, scratch, found, counters);
      std::transform(found.begin(), found.end(), answers.begin(),
                     [](fast::ShadowAnswer answer) { return static_cast<Answer>(answer); });
      answers = answers.subspan(found.size());
    }
  }

  fast::PairCaster caster_;
  Tier tier_;
  fast::ExactFaces exact_{exact::blocks, exact::faces_away, exact::meets, exact::compare_hits};
};

}  // namespace

std::unique_ptr<SceneCaster> make_naive_pair_caster(const scene::Scene& scene) {
  return std::make_unique<PairRays>(scene, Tier::naive);
}
std::unique_ptr<SceneCaster> make_certified_pair_caster(const scene::Scene& scene) {
  return std::make_unique<PairRays>(scene, Tier::certified);
}
std::unique_ptr<SceneCaster> make_exact_pair_caster(const scene::Scene& scene) {
  return std::make_unique<PairRays>(scene, Tier::exact);
}

}  // namespace gnomon::fuzz
