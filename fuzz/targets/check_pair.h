// SPDX-License-Identifier: GPL-3.0-or-later
// What has to hold of every small case about a pair.
#pragma once

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "fuzz/pair_question.h"
#include "fuzz/pair_witness.h"
#include "fuzz/replay_shadow.h"
#include "fuzz/targets/decode_pair.h"

namespace gnomon::fuzz {

/// References agree, no promise breaks, and the answer depends neither on scale, nor on the order of corners,
/// nor on which end comes first.
template <class Q>
class PairCheck {
 public:
  using Query = typename Q::Query;
  using Reply = typename Q::Reply;

  explicit PairCheck(const SmallPair<Query>& small) : small_(small) {}

  void run() const {
    expect(is_valid(small_.scene), "the decoder made no valid scene");
    Reply truth{}, other{};
    Q::refer(small_.scene, small_.query, truth);
    Q::refer(typename Q::Referee(small_.scene), small_.query, other);
    expect(other == truth, "the hierarchy differs");
    Q::refer(small_.scene, Query{small_.query.b, small_.query.a}, other);
    expect(other == truth, "the answer depends on which end comes first");
    Q::refer(turned(), small_.query, other);
    expect(other == truth, "the answer depends on the order of corners");
    same_at_another_scale(truth);
    if (!small_.floats) return;  // outside of every row's domain
    for (const typename Q::Method& method : Q::methods()) {
      const PairJudgement judged = try_pair<Q>(method, small_.scene, small_.query);
      const Verdict verdict = words_of(Q::id).judge(judged.truth, judged.answer);
      expect(!is_broken(method.promise, verdict), std::string(method.name) + " breaks its promise");
    }
  }

 private:
  void expect(bool holds, const std::string& what) const {
    if (holds) return;
    Reply truth{};
    Q::refer(small_.scene, small_.query, truth);
    std::fprintf(stderr, "%s:\n%s\n", what.c_str(), pair_text(small_.scene, small_.query, truth).c_str());
    std::abort();
  }

  [[nodiscard]] scene::Scene turned() const {
    scene::Scene scene = small_.scene;
    for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
      std::swap(scene.triangles[t][t % 3], scene.triangles[t][(t + 1) % 3]);
    }
    return scene;
  }

  void same_at_another_scale(const Reply& truth) const {
    SmallPair<Query> scaled = small_;
    const auto scale = [&](auto& x) { x = std::ldexp(x, small_.shift); };
    const auto scale_all = [&](auto& p) {
      for (auto& x : p) scale(x);
    };
    for (auto& p : scaled.scene.points) scale_all(p);
    for (scene::Ball<double>& ball : scaled.scene.balls) scale_all(ball.centre), scale(ball.radius);
    if constexpr (std::is_same_v<Query, BoxPair>) {
      scale_all(scaled.query.a.c);
      scale_all(scaled.query.b.c);
      for (std::size_t i = 0; i < 6; ++i) {  // a small number may have become a denormal, rounded
        if (std::ldexp(scaled.query.a.c[i], -small_.shift) != small_.query.a.c[i]) return;
        if (std::ldexp(scaled.query.b.c[i], -small_.shift) != small_.query.b.c[i]) return;
      }
    } else {
      for (scene::Patch* patch : {&scaled.query.a, &scaled.query.b}) {
        for (auto& corner : patch->corners) scale_all(corner);
      }
    }
    Reply other{};
    Q::refer(scaled.scene, scaled.query, other);
    expect(other == truth, "the answer depends on the scale");
  }

  const SmallPair<Query>& small_;
};

}  // namespace gnomon::fuzz
