// SPDX-License-Identifier: GPL-3.0-or-later
// The registry rows of shadow and first-hit. Adding a method is a caster (a file) and a row in the table.
#include "fuzz/brute_caster.h"
#include "fuzz/hierarchy_casters.h"
#include "fuzz/pair_ray_casters.h"
#include "fuzz/scene_method.h"

namespace gnomon::fuzz {
namespace {

constexpr std::string_view kAllFloats = "all finite floats";

const SceneMethod kRows[] = {
    {"brute-naive-f32", "naive", Promise::none, kAllFloats,
     "all faces, Moeller and Trumbore's test in floats", true, true, make_brute_caster},
    {"bvh-naive-f32", "naive", Promise::none, kAllFloats, "hierarchy eight boxes wide, the usual float tests",
     false, true, make_naive_hierarchy},
    {"bvh-certified-f32", "certified", Promise::never_unsound,
     "all finite floats; decides below 2^40 and above about 1e-9 units",
     "the same kernels on error thresholds: right or undecided", false, true, make_certified_hierarchy},
    {"bvh-exact", "exact", Promise::always_agrees, kAllFloats,
     "certified, the faces left open by exact predicates", false, true, make_exact_hierarchy},
    {"reference", "reference", Promise::always_agrees, "all finite numbers",
     "what judges the others: exact, and tells what is touching", false, true, make_reference, true},
};

const SceneMethod kRadiosityRows[] = {
    {"shaft-naive-f32", "naive", Promise::none, kAllFloats,
     "one walk of the hierarchy with the pair's shaft, then all rays at the faces left", false, true,
     make_naive_pair_caster, false, true, true},
    {"shaft-certified-f32", "certified", Promise::never_unsound, "all finite floats; decides below 2^40",
     "the same on error thresholds: right or undecided", false, true, make_certified_pair_caster, false, true,
     true},
    {"shaft-exact", "exact", Promise::always_agrees, kAllFloats,
     "certified, what is left open by exact predicates", false, true, make_exact_pair_caster, false, true,
     true},
};

}  // namespace

std::span<const SceneMethod> scene_methods() {
  return kRows;
}

std::span<const SceneMethod> radiosity_methods() {
  return kRadiosityRows;
}

}  // namespace gnomon::fuzz
