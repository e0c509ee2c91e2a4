// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/shadow.h"

#include <algorithm>

#include "exact/contact.h"
#include "exact/shadow_fold.h"

namespace gnomon::exact {

using scene::Object;
using scene::Scene;
using scene::Shadow;
using scene::ShadowQuery;

namespace {

/// The object that a triangle belongs to. Among those that begin no later, the last one has it: runs without
/// triangles come before it.
const Object& object_of(const Scene& scene, std::uint32_t triangle) {
  const auto after = std::upper_bound(
      scene.objects.begin(), scene.objects.end(), std::size_t{triangle},
      [](std::size_t number, const Object& object) { return number < object.first_triangle; });
  return *(after - 1);
}

}  // namespace

std::optional<int> own_facing(const Scene& scene, const ShadowQuery& query) {
  if (query.own >= scene.triangles.size() || !object_of(scene, query.own).one_sided) return std::nullopt;
  const FacingSign facing = facing_sign(scene, query.own, query);
  if (!facing.has_normal) return std::nullopt;
  return facing.sign;
}

void ShadowFold::add(std::uint32_t face, Contact contact) {
  switch (contact.kind) {
    case ContactKind::none:
      return;
    case ContactKind::at_end:
      at_end_ = true;
      return;
    case ContactKind::grazing:
      met_ = true;
      return;
    case ContactKind::on_edge:
    case ContactKind::on_vertex:
      met_ = on_border_ = true;
      borders_.add(face, contact);
      return;
    case ContactKind::plain:
      settled_ = true;
      return;
  }
}

ShadowTruth ShadowFold::truth() const {
  if (settled_ || (on_border_ && borders_.any_sealed())) return {Shadow::shadowed, facing_is_zero_};
  if (met_) return {Shadow::shadowed, true};
  return {Shadow::lit, facing_is_zero_ || at_end_};
}

bool blocks(const Scene& scene, std::uint32_t face, const ShadowQuery& query) {
  return contact(scene, face, query).meets();
}

bool faces_away(const Scene& scene, const ShadowQuery& query) {
  return own_facing(scene, query) == -1;
}

ShadowTruth shadow_by_all_faces(const Scene& scene, const ShadowQuery& query) {
  const std::optional<int> facing = own_facing(scene, query);
  if (facing == -1) return {Shadow::facing, false};
  const Path path(query);
  ShadowFold fold(scene, path, facing == 0);
  const auto count = static_cast<std::uint32_t>(scene.face_count());
  for (std::uint32_t face = 0; face < count && !fold.settled(); ++face) {
    fold.add(face, contact(scene, face, query));
  }
  return fold.truth();
}

}  // namespace gnomon::exact
