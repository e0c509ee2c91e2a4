// SPDX-License-Identifier: GPL-3.0-or-later
// exact/shadow.h against the definition in rationals, and against what must hold of closed meshes.
#include "exact/shadow.h"

#include <gtest/gtest.h>

#include "tests/scene_cases.h"
#include "tests/shadow_by_definition.h"

namespace gnomon::tests {
namespace {

using exact::ShadowTruth;
using scene::kNoFace;
using scene::Scene;
using scene::SceneBuilder;
using scene::Shadow;
using scene::ShadowQuery;

struct Mix {
  std::array<std::size_t, 3> answers{};
  std::array<std::size_t, 3> touching{};
  ContactCounts contacts;
};

/// Asks both references, and counts.
void check(const Scene& scene, const ShadowQuery& q, Mix& mix) {
  const ShadowTruth expected = shadow_by_definition(scene, q, &mix.contacts);
  const ShadowTruth found = exact::shadow_by_all_faces(scene, q);
  ASSERT_EQ(found, expected) << corpus_text_of(scene, q) << " answer " << static_cast<int>(found.answer)
                             << " for " << static_cast<int>(expected.answer) << ", touching "
                             << found.touching;
  ++mix.answers[static_cast<std::size_t>(found.answer)];
  mix.touching[static_cast<std::size_t>(found.answer)] += found.touching;
  EXPECT_EQ(exact::faces_away(scene, q), found.answer == Shadow::facing);
  bool any = false;
  for (std::uint32_t face = 0; face < scene.face_count(); ++face) any |= exact::blocks(scene, face, q);
  if (found.answer == Shadow::facing) return;
  EXPECT_EQ(any, found.answer == Shadow::shadowed);
}

void expect_mix(const Mix& mix, std::size_t least) {
  EXPECT_GE(mix.answers[0], least);
  EXPECT_GE(mix.answers[1], least);
  EXPECT_GE(mix.answers[2], least / 4);
  EXPECT_GE(mix.contacts.firm, least);
}

TEST(ShadowExact, GridScenesAgreeWithTheDefinitionAtEveryScale) {
  Random random(1);
  Mix mix;
  for (int trial = 0; trial < affordable(reference_cases(6000)); ++trial) {
    const Placement& place = kPlacements[static_cast<std::size_t>(trial) % kPlacements.size()];
    const Scene scene = random_scene(random, {random.below(5), random.below(3), true}, place);
    for (int i = 0; i < 2 && !HasFatalFailure(); ++i)
      check(scene, random_query(random, scene, true, place), mix);
    if (HasFatalFailure()) return;
  }
  const auto least = static_cast<std::size_t>(affordable(640));
  expect_mix(mix, least);
  EXPECT_GE(mix.touching[0], least);
  EXPECT_GE(mix.touching[1], least / 2);
  EXPECT_EQ(mix.touching[2], 0u);
  EXPECT_GE(mix.contacts.ends, least);
  EXPECT_GE(mix.contacts.weak, least);
  EXPECT_GE(mix.contacts.unsealed, least / 2);
}

TEST(ShadowExact, RandomScenesAgreeWithTheDefinition) {
  Random random(2);
  Mix mix;
  for (int trial = 0; trial < affordable(reference_cases(1500)); ++trial) {
    const Scene scene = random_scene(random, {random.below(6), random.below(4), false}, {});
    for (int i = 0; i < 2; ++i) check(scene, random_query(random, scene, false, {}), mix);
    if (HasFatalFailure()) return;
  }
  expect_mix(mix, static_cast<std::size_t>(affordable(400)));
}

/// Numbers of many digits within one plane: what intervals decide about flat contacts.
TEST(ShadowExact, PathsWithinThePlaneOfFacesAgreeWithTheDefinition) {
  Random random(15);
  Mix mix;
  for (int trial = 0; trial < affordable(600); ++trial) {
    const FlatCase c = random_flat_case(random);
    check(c.scene, c.query, mix);
    if (HasFatalFailure()) return;
  }
  const auto least = static_cast<std::size_t>(affordable(100));
  EXPECT_GE(mix.answers[0], least);
  EXPECT_GE(mix.touching[1], least);
  EXPECT_EQ(mix.contacts.firm, 0u);
}

Scene one_triangle() {
  SceneBuilder builder;
  builder.add_triangle({0, 0, 0}, {4, 0, 0}, {0, 4, 0});
  return builder.finish();
}

TEST(ShadowExact, ContactsOfEachKind) {
  constexpr ShadowTruth kLit{Shadow::lit, false}, kLitTouching{Shadow::lit, true},
      kShadowed{Shadow::shadowed, false}, kShadowedTouching{Shadow::shadowed, true};
  const Scene triangle = one_triangle();
  const auto ask = [](const Scene& scene, const Point3& p, const Point3& light) {
    const ShadowTruth truth = exact::shadow_by_all_faces(scene, {p, light, kNoFace});
    EXPECT_EQ(exact::shadow_by_all_faces(scene, {light, p, kNoFace}), truth);
    return truth;
  };
  EXPECT_EQ(ask(triangle, {1, 1, -1}, {1, 1, 1}), kShadowed);
  EXPECT_EQ(ask(triangle, {2, 2, -1}, {2, 2, 1}), kShadowedTouching);   // an edge
  EXPECT_EQ(ask(triangle, {0, 0, -1}, {0, 0, 1}), kShadowedTouching);   // a vertex
  EXPECT_EQ(ask(triangle, {-1, 1, 0}, {9, 1, 0}), kShadowedTouching);   // in the plane, across
  EXPECT_EQ(ask(triangle, {1, 1, 0}, {1.5, 1, 0}), kShadowedTouching);  // in the plane, within
  EXPECT_EQ(ask(triangle, {-1, 5, 0}, {5, -1, 0}), kShadowedTouching);  // along an edge
  EXPECT_EQ(ask(triangle, {-1, 1, 0}, {1, -1, 0}), kShadowedTouching);  // in the plane, a vertex
  EXPECT_EQ(ask(triangle, {-1, 1, 0}, {0, 1, 0}), kLitTouching);        // in the plane, ends there
  EXPECT_EQ(ask(triangle, {1, 1, 0}, {1, 1, 5}), kLitTouching);         // an end on it
  EXPECT_EQ(ask(triangle, {0, 0, 0}, {0, 0, 5}), kLitTouching);
  EXPECT_EQ(ask(triangle, {1, 1, 0}, {1, 1, 0}), kLitTouching);  // a point on it
  EXPECT_EQ(ask(triangle, {1, 1, 1}, {1, 1, 1}), kLit);
  EXPECT_EQ(ask(triangle, {3, 3, -1}, {3, 3, 1}), kLit);
  EXPECT_EQ(ask(triangle, {1, 1, 0x1p-1074}, {1, 1, 1}), kLit);
  EXPECT_EQ(ask(triangle, {1, 1, -0x1p-1074}, {1, 1, 1}), kShadowed);

  SceneBuilder balls;
  balls.add_ball({{-4, 3, 0}, 5});  // tangent to the line from 0 along (3, 4, 0), at 0
  balls.add_ball({{9, 0, 0}, 0});
  const Scene scene = balls.finish();
  EXPECT_EQ(ask(scene, {-3, -4, 0}, {3, 4, 0}), kShadowedTouching);
  EXPECT_EQ(ask(scene, {0, 0, 0}, {3, 4, 0}), kLitTouching);
  EXPECT_EQ(ask(scene, {3, 4, 0}, {6, 8, 0}), kLit);
  EXPECT_EQ(ask(scene, {-3, -4, 0}, {3, std::nextafter(4, 5), 0}), kShadowed);
  EXPECT_EQ(ask(scene, {-3, -4, 0}, {3, std::nextafter(4, 3), 0}), kLit);
  EXPECT_EQ(ask(scene, {-4, 3, 0}, {-3, 3, 0}), kShadowed);  // wholly within
  EXPECT_EQ(ask(scene, {8, 0, 0}, {10, 0, 0}), kShadowedTouching);
  EXPECT_EQ(ask(scene, {9, 0, 0}, {10, 0, 0}), kLitTouching);
}

/// Segments from outside a closed mesh to points beyond its corners, edges and faces: whatever they pass
/// through on their way, nothing leaks, and nothing is taken for touching.
TEST(ShadowExact, ClosedMeshesNeitherLeakNorTouch) {
  Random random(5);
  std::size_t through_borders = 0;
  for (int trial = 0; trial < affordable(240); ++trial) {
    const Placement& place = kPlacements[static_cast<std::size_t>(trial) % 3];
    const Scene mesh = box_mesh(random, 2, place);
    // Enters in the middle of the side z = 0 or through it, leaves through the side z = 2.
    const auto at = [&](double z) {
      return Point3{0.25 * random.between(1, 7), 0.25 * random.between(1, 7), z};
    };
    const Point3 in = at(0), out = at(2);
    ShadowQuery q;
    for (std::size_t i = 0; i < 3; ++i) {
      q.point[i] = place.place(2 * in[i] - out[i]);
      q.light[i] = place.place(2 * out[i] - in[i]);
    }
    ContactCounts counts;
    EXPECT_EQ(shadow_by_definition(mesh, q, &counts), (ShadowTruth{Shadow::shadowed, false}));
    EXPECT_EQ(exact::shadow_by_all_faces(mesh, q), (ShadowTruth{Shadow::shadowed, false}))
        << corpus_text_of(mesh, q);
    EXPECT_EQ(counts.unsealed, 0u);
    through_borders += counts.sealed > 0 && counts.firm == 0;
  }
  EXPECT_GE(through_borders, static_cast<std::size_t>(affordable(32)));
}

/// The same mesh with some triangles left out, and paths from corner to corner of the grid.
TEST(ShadowExact, MeshesWithHolesAgreeWithTheDefinition) {
  Random random(12);
  Mix mix;
  for (int trial = 0; trial < affordable(300); ++trial) {
    Scene mesh = box_mesh(random, 2, {});
    for (int holes = random.below(12); holes > 0; --holes) {
      mesh.triangles.erase(mesh.triangles.begin() + random.below(static_cast<int>(mesh.triangles.size())));
    }
    mesh.objects[0].triangle_count = mesh.triangles.size();
    for (int i = 0; i < 2; ++i) {
      ShadowQuery q = random_query(random, mesh, true, {});
      for (std::size_t k = 0; k < 3; ++k) {
        q.point[k] = 2 * q.point[k] - 2;
        q.light[k] = 2 * q.light[k] - 2;
      }
      check(mesh, q, mix);
    }
    if (HasFatalFailure()) return;
  }
  const auto least = static_cast<std::size_t>(affordable(24));
  EXPECT_GE(mix.contacts.sealed, least);
  EXPECT_GE(mix.contacts.unsealed, least);
  EXPECT_GE(mix.touching[1], least);
}

TEST(ShadowExact, OwnFacesKeepTheirRules) {
  SceneBuilder builder;
  builder.begin_object("front only", 0, true);
  builder.add_triangle({0, 0, 0}, {4, 0, 0}, {0, 4, 0});
  builder.add_triangle({0, 0, 0}, {1, 0, 0}, {2, 0, 0});
  builder.begin_object("the same again", 0, false);
  builder.add_triangle({0, 0, 0}, {4, 0, 0}, {0, 4, 0});
  builder.add_ball({{0, 0, 10}, 1});
  const Scene scene = builder.finish();
  const auto ask = [&](const Point3& p, const Point3& light, std::uint32_t own) {
    return exact::shadow_by_all_faces(scene, {p, light, own});
  };
  EXPECT_EQ(ask({1, 1, 0}, {1, 1, -1}, 0), (ShadowTruth{Shadow::facing, false}));
  EXPECT_EQ(ask({1, 1, 0}, {1, 1, -1}, 2), (ShadowTruth{Shadow::lit, true}));  // its twin is at the point
  EXPECT_EQ(ask({1, 1, -1}, {1, 1, 1}, 0), (ShadowTruth{Shadow::shadowed, false}));  // by its twin
  EXPECT_EQ(ask({9, 9, 0}, {9, 8, 0}, 0), (ShadowTruth{Shadow::lit, true}));         // edge-on
  EXPECT_EQ(ask({9, 9, 0}, {9, 8, 0}, 1), (ShadowTruth{Shadow::lit, false}));        // no normal
  EXPECT_EQ(ask({0, 0, 11}, {0, 0, 12}, 3), (ShadowTruth{Shadow::lit, false}));
  EXPECT_EQ(ask({0, 0, 11}, {0, 0, 10.5}, 3), (ShadowTruth{Shadow::shadowed, false}));
  EXPECT_EQ(ask({0, 0, 11}, {1, 0, 11}, 3), (ShadowTruth{Shadow::lit, true}));
  EXPECT_EQ(ask({0, 0, 8}, {9, 0, 8.5}, 3), (ShadowTruth{Shadow::shadowed, false}));  // towards its centre
}

}  // namespace
}  // namespace gnomon::tests
