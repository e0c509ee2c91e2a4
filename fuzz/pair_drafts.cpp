// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/pair_drafts.h"

#include <algorithm>

#include "fuzz/pair_shapes.h"
#include "scene/scene_builder.h"

namespace gnomon::fuzz {

namespace {

using namespace drafts;

class CandidateDrafts final : public PairSource<BoxPair> {
 public:
  explicit CandidateDrafts(ShaftStyle style) : style_(std::move(style)) {}

  void make(const TrialId& id, PairCase<BoxPair>& c) const override {
    CaseRandom random = own_random(id);
    const std::size_t count = static_cast<std::size_t>(random.integer(1, 10));
    const std::size_t balls = static_cast<std::size_t>(random.below(static_cast<int>(count + 1))) / 2;
    const Shapes shapes = draw_shapes(style_, id, std::max<std::size_t>(count - balls, 1), balls);
    scene::SceneBuilder builder;
    // Where few faces lie about the shaft, its list is empty in a fair share of trials.
    const std::size_t triangles = random.chance(0.3) ? 1 : shapes.boxes.size();
    for (std::size_t j = 0; j < triangles; ++j) {
      const Corners corners = face_of(random, style_, shapes, j);
      builder.add_triangle(corners[0], corners[1], corners[2]);
    }
    if (triangles > 1) {
      for (const scene::Ball<double>& ball : shapes.balls) builder.add_ball(ball);
    }
    c.scene = builder.finish();
    c.query = {scene::converted<float>(shapes.a), scene::converted<float>(shapes.b)};
  }

 private:
  ShaftStyle style_;
};

}  // namespace

ShaftStyle ShaftStyle::of(const std::string& distribution) {
  const DistributionChoice choice = parse_distribution(distribution);
  const std::string_view name = choice.distribution->name;
  return {make_generator<scene::ShaftBoxCase>(choice, scene::Scalar::f32),
          make_generator<scene::ShaftBallCase>(choice, scene::Scalar::f32),
          name == "integer-grid" || name == "denormal", name == "integer-grid", name == "near-touch"};
}

std::unique_ptr<PairSource<BoxPair>> make_candidate_drafts(ShaftStyle style) {
  return std::make_unique<CandidateDrafts>(std::move(style));
}

}  // namespace gnomon::fuzz
