// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/pair_caster_rows.h"

#include <algorithm>
#include <cmath>

#include "exact/patch_pair.h"
#include "exact/shaft_candidates.h"
#include "fast/pair_visibility.h"

namespace gnomon::fuzz {
namespace {

using scene::PairVisibility;

class CertifiedFinder : public CandidateFinder {
 public:
  explicit CertifiedFinder(const scene::Scene& scene) : scene_(scene), caster_(scene) {}
  void faces(const BoxPair& pair, std::vector<std::uint32_t>& out) const override {
    caster_.shaft_faces(pair.a, pair.b, out);
  }

 protected:
  const scene::Scene& scene_;

 private:
  fast::PairCaster caster_;
};

class ExactFinder final : public CertifiedFinder {
 public:
  using CertifiedFinder::CertifiedFinder;
  void faces(const BoxPair& pair, std::vector<std::uint32_t>& out) const override {
    CertifiedFinder::faces(pair, out);
    const exact::CandidateShaft shaft(scene::converted<double>(pair.a), scene::converted<double>(pair.b));
    std::erase_if(out, [&](std::uint32_t face) { return !shaft.meets(scene_, face); });
  }
};

/// The side of a plane on which all points of a list lie, strictly and for certain, or 0: 10 v times the sum
/// of the products' magnitudes bounds the error, as in fast/pair_plane.cpp.
class Plane {
 public:
  explicit Plane(const scene::Patch& patch) : corner_(patch.corners[0]) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      const auto edge = [&](std::size_t e, std::size_t axis) {
        return patch.corners[e][axis] - corner_[axis];
      };
      const double x = edge(1, i) * edge(2, j), y = edge(1, j) * edge(2, i);
      normal_[k] = x - y;
      sum_[k] = std::abs(x) + std::abs(y);
    }
  }

  [[nodiscard]] int side(const std::array<std::array<double, 3>, 3>& points) const {
    int front = 0, behind = 0;
    for (const auto& p : points) {
      double value = 0, sum = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        value += normal_[k] * (p[k] - corner_[k]);
        sum += sum_[k] * std::abs(p[k] - corner_[k]);
      }
      constexpr double kError = 10 * fast::Rounding<double>::u;
      front += value > kError * sum;
      behind += value < -kError * sum;
    }
    return front == 3 ? 1 : behind == 3 ? -1 : 0;
  }

 private:
  std::array<double, 3> corner_, normal_{}, sum_{};
};

class CertifiedJudge : public PairJudge {
 public:
  explicit CertifiedJudge(const scene::Scene& scene) : scene_(scene), caster_(scene) {}

  [[nodiscard]] Answer visibility(const scene::PatchPair& pair) const override {
    const fast::PairPatch a = prepare(pair.a), b = prepare(pair.b);
    std::vector<std::uint32_t> faces;
    caster_.candidates(a, b, faces);
    return answer(decide(pair, a, b, faces));
  }

 protected:
  static Answer answer(PairVisibility visibility) { return static_cast<Answer>(visibility); }

  /// `faces` are those that can block, or more.
  [[nodiscard]] virtual PairVisibility decide(const scene::PatchPair& pair, const fast::PairPatch& a,
                                              const fast::PairPatch& b,
                                              const std::vector<std::uint32_t>& faces) const {
    if (faces.empty()) return PairVisibility::all;
    fast::PairScratch scratch;
    std::array<fast::ShadowAnswer, 9> rays;
    const fast::PairResult result = caster_.shadows_certified(a, b, scratch, rays);
    if (result.visibility != PairVisibility::none || result.blocker >= scene_.triangles.size()) {
      return PairVisibility::part;
    }
    const Plane plane_a(pair.a), plane_b(pair.b);
    const std::array<std::array<double, 3>, 3> face{
        scene_.corner(result.blocker, 0), scene_.corner(result.blocker, 1), scene_.corner(result.blocker, 2)};
    const int towards_b = plane_a.side(pair.b.corners), towards_a = plane_b.side(pair.a.corners);
    return towards_b != 0 && towards_a != 0 && plane_a.side(face) == towards_b &&
                   plane_b.side(face) == towards_a
               ? PairVisibility::none
               : PairVisibility::part;
  }

  const scene::Scene& scene_;

 private:
  [[nodiscard]] fast::PairPatch prepare(const scene::Patch& patch) const {
    std::array<std::array<float, 3>, 3> points;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) points[i][k] = static_cast<float>(patch.corners[i][k]);
    }
    return caster_.prepare(points,
                           patch.face == scene::kNoFace ? scene::FaceRun{} : scene::FaceRun{patch.face, 1});
  }

  fast::PairCaster caster_;
};

class ExactJudge final : public CertifiedJudge {
 public:
  using CertifiedJudge::CertifiedJudge;

 private:
  [[nodiscard]] PairVisibility decide(const scene::PatchPair& pair, const fast::PairPatch& /*a*/,
                                      const fast::PairPatch& /*b*/,
                                      const std::vector<std::uint32_t>& faces) const override {
    const bool open = std::any_of(faces.begin(), faces.end(),
                                  [&](std::uint32_t face) { return exact::can_block(scene_, face, pair); });
    if (!open) return PairVisibility::all;
    const bool hidden = std::any_of(faces.begin(), faces.end(),
                                    [&](std::uint32_t face) { return exact::hides(scene_, face, pair); });
    return hidden ? PairVisibility::none : PairVisibility::part;
  }
};

template <class Made, class Base>
std::unique_ptr<Base> make(const scene::Scene& scene) {
  return std::make_unique<Made>(scene);
}

constexpr std::string_view kAllFloats = "all finite floats";
constexpr std::string_view kCasterDomain = "all finite floats; culls nothing beyond 2^40";

const CandidateMethod kCandidateRows[] = {
    {"shaft-certified-f32", "certified", Promise::never_unsound, kCasterDomain,
     "fast::PairCaster: the shaft as a slab test, eight boxes at a time, then faces",
     make<CertifiedFinder, CandidateFinder>},
    {"shaft-exact", "exact", Promise::always_agrees, kAllFloats,
     "shaft-certified-f32, its faces handed to the exact predicate", make<ExactFinder, CandidateFinder>},
};
const PairMethod kPairRows[] = {
    {"pair-certified-f32", "certified", Promise::never_unsound, kCasterDomain,
     "fast::PairCaster: all when its list is empty, none when it notices a face that hides",
     make<CertifiedJudge, PairJudge>},
    {"pair-exact", "exact", Promise::always_agrees, kAllFloats,
     "the list of pair-certified-f32, its faces handed to exact predicates", make<ExactJudge, PairJudge>},
};

}  // namespace

std::span<const CandidateMethod> caster_candidate_rows() {
  return kCandidateRows;
}
std::span<const PairMethod> caster_pair_rows() {
  return kPairRows;
}

}  // namespace gnomon::fuzz
