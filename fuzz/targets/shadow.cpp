// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a small scene with a query and a ray: references agree, no promise breaks, and answers don't
// depend on scale, on the order of corners or on which end of a path comes first.
#include <cstdio>
#include <cstdlib>

#include "exact/hierarchy.h"
#include "fuzz/replay_shadow.h"
#include "fuzz/targets/decode_shadow.h"
#include "scene/shadow_case.h"

namespace {

using namespace gnomon;
using exact::FirstHit;
using exact::ShadowTruth;

class SceneCheck {
 public:
  explicit SceneCheck(const fuzz::SmallScene& small) : small_(small) {}

  void run() const {
    expect(is_valid(small_.scene), "the decoder made no valid scene");
    const ShadowTruth shadow = exact::shadow_by_all_faces(small_.scene, small_.shadow);
    const FirstHit hit = exact::first_hit_by_all_faces(small_.scene, small_.ray);
    const exact::Hierarchy hierarchy(small_.scene);
    expect(hierarchy.shadow(small_.shadow) == shadow, "the hierarchy's shadow differs");
    expect(hierarchy.first_hit(small_.ray) == hit, "the hierarchy's first hit differs");
    for (const fuzz::SceneMethod& method : fuzz::scene_methods()) promises(method, shadow, hit);
    same_at_another_scale(shadow, hit);
    same_with_corners_exchanged(shadow, hit);
    same_from_the_other_end(shadow);
  }

 private:
  void expect(bool holds, const std::string& what) const {
    if (holds) return;
    std::fprintf(stderr, "%s%s:\n%s\n", what.c_str(),
                 !small_.scene.objects.empty() && small_.scene.objects[0].one_sided ? " (one-sided)" : "",
                 scene::corpus_text({small_.scene, small_.shadow}, "").c_str());
    std::abort();
  }

  void promises(const fuzz::SceneMethod& method, const ShadowTruth& shadow, const FirstHit& hit) const {
    // The ray's direction is that of the segment, rounded: in the domain where the segment is, but for this.
    const scene::ShadowQuery numbers{small_.ray.origin, small_.ray.direction, small_.ray.own};
    if (!is_in_domain(method, small_.scene, small_.shadow) || !is_in_domain(method, small_.scene, numbers)) {
      return;
    }
    const std::string name(method.name);
    const auto caster = method.make(small_.scene);
    fuzz::Answer answer = fuzz::kRejected;
    caster->shadows({&small_.shadow, 1}, {&answer, 1});
    expect(answer <= fuzz::kUndecided, name + " gives no answer");
    const fuzz::Verdict verdict = answer == fuzz::kUndecided ? fuzz::Verdict::undecided
                                  : answer == static_cast<fuzz::Answer>(shadow.answer)
                                      ? fuzz::Verdict::agree
                                      : fuzz::Verdict::unsound;
    expect(!is_broken(method.promise, verdict), name + " breaks its promise about the shadow");
    std::uint32_t face = 0;
    caster->first_hits({&small_.ray, 1}, {&face, 1});
    const bool right = hit.faces.empty()
                           ? face == scene::kNoFace
                           : std::find(hit.faces.begin(), hit.faces.end(), face) != hit.faces.end();
    const fuzz::Verdict first = face == fuzz::kUndecidedFace ? fuzz::Verdict::undecided
                                : right                      ? fuzz::Verdict::agree
                                                             : fuzz::Verdict::unsound;
    expect(!is_broken(method.promise, first), name + " breaks its promise about the first hit");
  }

  void same_at_another_scale(const ShadowTruth& shadow, const FirstHit& hit) const {
    fuzz::SmallScene scaled = small_;
    const auto scale = [&](double& x) { x = std::ldexp(x, small_.shift); };
    const auto scale_all = [&](std::array<double, 3>& p) { std::for_each(p.begin(), p.end(), scale); };
    std::for_each(scaled.scene.points.begin(), scaled.scene.points.end(), scale_all);
    for (scene::Ball<double>& ball : scaled.scene.balls) scale_all(ball.centre), scale(ball.radius);
    for (auto* p : {&scaled.shadow.point, &scaled.shadow.light, &scaled.ray.origin, &scaled.ray.direction}) {
      scale_all(*p);
    }
    const exact::Hierarchy hierarchy(scaled.scene);
    expect(hierarchy.shadow(scaled.shadow) == shadow, "the shadow depends on the scale");
    expect(hierarchy.first_hit(scaled.ray) == hit, "the first hit depends on the scale");
  }

  void same_with_corners_exchanged(const ShadowTruth& shadow, const FirstHit& hit) const {
    fuzz::SmallScene turned = small_;
    for (std::uint32_t t = 0; t < turned.scene.triangles.size(); ++t) {
      if (t != small_.shadow.own)
        std::swap(turned.scene.triangles[t][t % 3], turned.scene.triangles[t][(t + 1) % 3]);
    }
    expect(exact::shadow_by_all_faces(turned.scene, turned.shadow) == shadow,
           "the shadow depends on corners' order");
    expect(exact::first_hit_by_all_faces(turned.scene, turned.ray) == hit,
           "the first hit depends on corners' order");
  }

  void same_from_the_other_end(const ShadowTruth& shadow) const {
    if (small_.shadow.own != scene::kNoFace) return;
    const scene::ShadowQuery back{small_.shadow.light, small_.shadow.point, scene::kNoFace};
    expect(exact::shadow_by_all_faces(small_.scene, back) == shadow, "the way back differs");
  }

  const fuzz::SmallScene& small_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  SceneCheck(fuzz::SceneDecoder(fuzz::Bytes(data, size)).decode()).run();
  return 0;
}
