// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hierarchy_casters.h"

#include <algorithm>
#include <array>

#include "exact/hierarchy.h"
#include "fast/hierarchy.h"

namespace gnomon::fuzz {
namespace {

enum class Tier : std::uint8_t { naive, certified, exact };

class FastCaster : public SceneCaster {
 public:
  FastCaster(const scene::Scene& scene, Tier tier) : hierarchy_(scene), tier_(tier) {}

  void shadows(std::span<const scene::ShadowQuery> queries, std::span<Answer> answers) const override {
    in_parts(queries, answers, [this](auto part, auto out) {
      if (tier_ == Tier::exact) return hierarchy_.shadows_exact(exact_, part, out);
      hierarchy_.shadows(fast_tier(), part, out);
    });
  }

  void first_hits(std::span<const scene::RayQuery> rays, std::span<std::uint32_t> faces) const override {
    static_assert(kUndecidedFace == fast::kUndecidedFace);
    if (tier_ == Tier::exact) return hierarchy_.first_hits_exact(exact_, rays, faces);
    hierarchy_.first_hits(fast_tier(), rays, faces);
  }

  [[nodiscard]] std::size_t bytes() const override { return hierarchy_.bytes(); }

  [[nodiscard]] std::optional<TestCounts> count_tests(
      std::span<const scene::ShadowQuery> queries) const override {
    fast::TestCounters counters;
    std::vector<Answer> answers(queries.size());
    in_parts(queries, answers, [&](auto part, auto out) {
      if (tier_ == Tier::exact) return hierarchy_.shadows_exact(exact_, part, out, counters);
      hierarchy_.shadows(fast_tier(), part, out, counters);
    });
    return TestCounts{counters.boxes, counters.faces, counters.exact};
  }

  [[nodiscard]] std::optional<TestCounts> count_hit_tests(
      std::span<const scene::RayQuery> rays) const override {
    fast::TestCounters counters;
    std::vector<std::uint32_t> faces(rays.size());
    if (tier_ == Tier::exact) {
      hierarchy_.first_hits_exact(exact_, rays, faces, counters);
    } else {
      hierarchy_.first_hits(fast_tier(), rays, faces, counters);
    }
    return TestCounts{counters.boxes, counters.faces, counters.exact};
  }

 private:
  [[nodiscard]] fast::Hierarchy::Tier fast_tier() const {
    return tier_ == Tier::naive ? fast::Hierarchy::Tier::naive : fast::Hierarchy::Tier::certified;
  }

  /// The hierarchy has a type of its own for answers; parts of them are turned into ours while they are in
  /// the first-level cache.
  template <class Ask>
  static void in_parts(std::span<const scene::ShadowQuery> queries, std::span<Answer> answers, Ask ask) {
    constexpr std::size_t kPart = 1024;
    static_assert(static_cast<Answer>(fast::ShadowAnswer::undecided) == kUndecided);
    std::array<fast::ShadowAnswer, kPart> part{};
    for (std::size_t first = 0; first < queries.size(); first += kPart) {
      const std::size_t count = std::min(kPart, queries.size() - first);
      ask(queries.subspan(first, count), std::span(part).first(count));
      for (std::size_t i = 0; i < count; ++i) answers[first + i] = static_cast<Answer>(part[i]);
    }
  }

  fast::Hierarchy hierarchy_;
  Tier tier_;
  fast::ExactFaces exact_{exact::blocks, exact::faces_away, exact::meets, exact::compare_hits};
};

class Reference : public SceneCaster {
 public:
  explicit Reference(const scene::Scene& scene) : hierarchy_(scene) {}

  void shadows(std::span<const scene::ShadowQuery> queries, std::span<Answer> answers) const override {
    for (std::size_t i = 0; i < queries.size(); ++i) {
      answers[i] = static_cast<Answer>(hierarchy_.shadow(queries[i]).answer);
    }
  }

  void first_hits(std::span<const scene::RayQuery> rays, std::span<std::uint32_t> faces) const override {
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const std::vector<std::uint32_t> tied = hierarchy_.first_hit(rays[i]).faces;
      faces[i] = tied.empty() ? scene::kNoFace : tied.front();
    }
  }

  [[nodiscard]] std::size_t bytes() const override { return hierarchy_.bytes(); }

  [[nodiscard]] std::optional<TestCounts> count_tests(
      std::span<const scene::ShadowQuery> queries) const override {
    exact::HierarchyCounters counters;
    for (const scene::ShadowQuery& query : queries) static_cast<void>(hierarchy_.shadow(query, counters));
    return TestCounts{counters.box_tests, counters.face_tests, counters.exact_face_tests};
  }

  [[nodiscard]] std::optional<TestCounts> count_hit_tests(
      std::span<const scene::RayQuery> rays) const override {
    exact::HierarchyCounters counters;
    for (const scene::RayQuery& ray : rays) static_cast<void>(hierarchy_.first_hit(ray, counters));
    return TestCounts{counters.box_tests, counters.face_tests, counters.exact_face_tests};
  }

 private:
  exact::Hierarchy hierarchy_;
};

}  // namespace

std::unique_ptr<SceneCaster> make_naive_hierarchy(const scene::Scene& scene) {
  return std::make_unique<FastCaster>(scene, Tier::naive);
}
std::unique_ptr<SceneCaster> make_certified_hierarchy(const scene::Scene& scene) {
  return std::make_unique<FastCaster>(scene, Tier::certified);
}
std::unique_ptr<SceneCaster> make_exact_hierarchy(const scene::Scene& scene) {
  return std::make_unique<FastCaster>(scene, Tier::exact);
}
std::unique_ptr<SceneCaster> make_reference(const scene::Scene& scene) {
  return std::make_unique<Reference>(scene);
}

}  // namespace gnomon::fuzz
