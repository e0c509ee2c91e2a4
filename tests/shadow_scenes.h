// SPDX-License-Identifier: GPL-3.0-or-later
// Small scenes for the tests of shadow methods, workloads and the verbs that use them.
#pragma once

#include <string>

#include "exact/first_hit.h"
#include "exact/shadow.h"
#include "fuzz/lights.h"
#include "fuzz/workload.h"
#include "scene/single.h"
#include "tests/scene_checks.h"

namespace gnomon::tests {

/// Two balls, a cone and an edge-on triangle over a floor, two lights, a view; nothing is a float but the
/// corners of the floor.
inline const std::string kBallsNff =
    "v\nfrom 4 3 2.5\nat 0 0 0\nup 0 0 1\nangle 40\nhither 1\nresolution 160 120\nl 4.1 1 6\nl -2 5.3 5\n"
    "f 1 1 1 1 0 0 0 1\np 4\n-3 -3 -1\n3 -3 -1\n3 3 -1\n-3 3 -1\n"
    "f 1 1 1 1 0 0 0 1\ns 0 0 0 0.7\ns 1.1 0.5 -0.6 0.4\n"
    "f 1 1 1 1 0 0 0 1\nc\n-1.1 1 -1 0.3\n-1.1 1 1 0.1\np 3\n1 -1 -1\n1.5 -1 -1\n1.2 -1.3 0.5\n";

/// The same without its balls: what methods of triangles alone can be asked.
inline const std::string kTrianglesNff = kBallsNff.substr(0, kBallsNff.find("s 0 0 0")) +
                                         "p 3\n-0.5 -0.7 0\n0.9 0 0.1\n0 0.8 0.3\n" +
                                         kBallsNff.substr(kBallsNff.find("f 1 1 1 1 0 0 0 1\nc"));

/// The scene that the text holds, rounded to floats, with lights and a view.
inline scene::Scene single_scene(const std::string& nff) {
  scene::Scene scene = scene::rounded_to_floats(scene::read_nff_text(nff).scene).scene;
  fuzz::complete(scene);
  return scene;
}

/// Exact answers face by face: no hierarchy takes part.
inline fuzz::Oracle slow_oracle(const scene::Scene& scene) {
  return {
      [&scene](const scene::RayQuery& ray) {
        const exact::FirstHit hit = exact::first_hit_by_all_faces(scene, ray);
        return hit.faces.empty() ? scene::kNoFace : hit.faces.front();
      },
      [&scene](const scene::ShadowQuery& query) { return exact::shadow_by_all_faces(scene, query).answer; }};
}

}  // namespace gnomon::tests
