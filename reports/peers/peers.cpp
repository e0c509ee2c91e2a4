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
template <bool kRobust, bool kHigh, unsigned kPacket>
std::unique_ptr<fuzz::SceneCaster> embree(const scene::Scene& scene) {
  return make_embree_caster(scene, {kRobust, kHigh, kPacket});
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

}  // namespace

const std::vector<SceneMethod>& all_scene_methods() {
  static const std::vector<SceneMethod> kAll = [] {
    std::vector<SceneMethod> all(fuzz::scene_methods().begin(), fuzz::scene_methods().end());
    all.insert(all.end(), std::begin(kPeers), std::end(kPeers));
    return all;
  }();
  return kAll;
}

std::vector<const SceneMethod*> choose_scene_methods(const std::vector<std::string>& names) {
  std::vector<const SceneMethod*> chosen;
  std::string known;
  for (const SceneMethod& method : all_scene_methods()) {
    known += (known.empty() ? "" : ", ") + std::string(method.name);
    if (names.empty() || std::find(names.begin(), names.end(), method.name) != names.end()) {
      chosen.push_back(&method);
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
