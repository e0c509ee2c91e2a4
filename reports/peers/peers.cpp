// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/peers/peers.h"

#include <algorithm>
#include <stdexcept>

#include "reports/peers/cgal_caster.h"
#include "reports/peers/embree_segments.h"
#ifdef GNOMON_HAS_EMBREE
#include "reports/peers/embree_caster.h"
#endif
#include "scene/printable.h"

namespace gnomon::reports {
namespace {

using fuzz::Promise;
using fuzz::SceneMethod;

#ifdef GNOMON_HAS_EMBREE
template <bool kRobust, bool kHigh, unsigned kPacket, bool kFilter = true>
std::unique_ptr<fuzz::SceneCaster> embree(const scene::Scene& scene) {
  return make_embree_caster(scene, {kRobust, kHigh, kPacket, kFilter});
}
#endif

constexpr std::string_view kAllFloats = "all finite floats";

const SceneMethod kPeers[] = {
#ifdef GNOMON_HAS_EMBREE
    {"embree", "peer", Promise::none, kAllFloats,
     "Embree 3, one thread; own face left out by a filter, not by an offset", false, true,
     embree<false, false, 1>},
    {"embree-robust", "peer", Promise::none, kAllFloats, "the same with RTC_SCENE_FLAG_ROBUST", false, true,
     embree<true, false, 1>},
    {"embree-high", "peer", Promise::none, kAllFloats, "the same with RTC_BUILD_QUALITY_HIGH", false, true,
     embree<false, true, 1>},
    {"embree-packet8", "peer", Promise::none, kAllFloats,
     "embree, 8 queries at a time in their order (first-hit: one)", false, true, embree<false, false, 8>},
    {"embree-packet16", "peer", Promise::none, kAllFloats,
     "embree, 16 queries at a time in their order (first-hit: one)", false, true, embree<false, false, 16>},
#endif
    {"cgal-epick", "peer", Promise::none, kAllFloats,
     "CGAL's AABB_tree over Epick: exact signs, closed segments; triangles alone", false, false,
     make_cgal_epick_caster},
    {"cgal-double", "peer", Promise::none, kAllFloats, "CGAL's AABB_tree over doubles; triangles alone",
     false, false, make_cgal_double_caster},
};

#ifdef GNOMON_HAS_EMBREE
const SceneMethod kRadiosityPeers[] = {
    {"embree-pairs", "peer", Promise::none, kAllFloats,
     "embree, handed pairs: points made ready once, ray by ray", false, true, embree<false, false, 1>, false,
     true, true},
    {"embree-unfiltered", "peer", Promise::none, kAllFloats,
     "embree-pairs without a filter: own faces are met, too", false, true, embree<false, false, 1, false>,
     false, true, true},
    {"embree-high-unfiltered", "peer", Promise::none, kAllFloats, "the same with RTC_BUILD_QUALITY_HIGH",
     false, true, embree<false, true, 1, false>, false, true, true},
};
#endif

std::vector<const SceneMethod*> choose(const std::vector<const SceneMethod*>& all,
                                       const std::vector<std::string>& names) {
  std::vector<const SceneMethod*> chosen;
  std::string known;
  for (const SceneMethod* const method : all) {
    known += (known.empty() ? "" : ", ") + std::string(method->name);
    if (names.empty() || std::find(names.begin(), names.end(), method->name) != names.end()) {
      chosen.push_back(method);
    }
  }
  for (const std::string& name : names) {
    if (std::none_of(chosen.begin(), chosen.end(),
                     [&](const SceneMethod* method) { return method->name == name; })) {
      throw std::runtime_error("--method: expected a method (" + known + "), found \"" +
                               scene::printable(name) + "\"");
    }
  }
  return chosen;
}

std::vector<const SceneMethod*> pointers_to(std::span<const SceneMethod> methods) {
  std::vector<const SceneMethod*> pointers;
  for (const SceneMethod& method : methods) pointers.push_back(&method);
  return pointers;
}

}  // namespace

const std::vector<SceneMethod>& all_scene_methods() {
  static const std::vector<SceneMethod> kAll = [] {
    std::vector<SceneMethod> all(fuzz::scene_methods().begin(), fuzz::scene_methods().end());
    all.insert(all.end(), std::begin(kPeers), std::end(kPeers));
    return all;
  }();
  return kAll;
}

const std::vector<SceneMethod>& all_radiosity_methods() {
  static const std::vector<SceneMethod> kAll = [] {
    std::vector<SceneMethod> all(fuzz::radiosity_methods().begin(), fuzz::radiosity_methods().end());
#ifdef GNOMON_HAS_EMBREE
    all.insert(all.end(), std::begin(kRadiosityPeers), std::end(kRadiosityPeers));
#endif
    return all;
  }();
  return kAll;
}

std::vector<const SceneMethod*> choose_scene_methods(const std::vector<std::string>& names) {
  return choose(pointers_to(all_scene_methods()), names);
}

std::vector<const SceneMethod*> choose_measured_methods(const std::vector<std::string>& names) {
  std::vector<const SceneMethod*> all = pointers_to(all_scene_methods());
  const std::vector<const SceneMethod*> more = pointers_to(all_radiosity_methods());
  all.insert(all.end(), more.begin(), more.end());
  return choose(all, names);
}

bool has_embree() {
#ifdef GNOMON_HAS_EMBREE
  return true;
#else
  return false;
#endif
}

#ifndef GNOMON_HAS_EMBREE
std::unique_ptr<SegmentCaster> make_embree_segments(const scene::Scene& /*scene*/, EmbreeMode /*mode*/) {
  return nullptr;
}
#endif

}  // namespace gnomon::reports
