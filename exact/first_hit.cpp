// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/first_hit.h"

#include <algorithm>

#include "exact/border_contacts.h"
#include "exact/contact.h"
#include "exact/first_hit_fold.h"

namespace gnomon::exact {

using scene::RayQuery;
using scene::Scene;

namespace {

std::strong_ordering compare(const Scene& scene, const RayQuery& ray, std::uint32_t a, const HitBounds& of_a,
                             std::uint32_t b, const HitBounds& of_b) {
  if (of_a.hi < of_b.lo) return std::strong_ordering::less;
  if (of_b.hi < of_a.lo) return std::strong_ordering::greater;
  return a == b ? std::strong_ordering::equal : compare_hits_exactly(scene, a, b, ray);
}

}  // namespace

void FirstHitFold::add(std::uint32_t face, Contact contact) {
  at_end_ |= contact.kind == ContactKind::at_end;
  if (contact.meets()) add(face, contact, hit_bounds(scene_, face, ray_));
}

void FirstHitFold::add(std::uint32_t face, Contact contact, HitBounds bounds) {
  if (first_.empty()) {
    first_.push_back({face, contact});
    nearest_ = bounds;
    return;
  }
  const std::strong_ordering order = compare(scene_, ray_, face, bounds, first_.front().face, nearest_);
  if (order == std::strong_ordering::greater) return;
  if (order == std::strong_ordering::less) {
    first_.clear();
    nearest_ = bounds;
  } else {
    nearest_ = {std::max(nearest_.lo, bounds.lo), std::min(nearest_.hi, bounds.hi)};
  }
  first_.push_back({face, contact});
}

FirstHit FirstHitFold::result() {
  FirstHit hit;
  const Path path(ray_);
  BorderContacts borders(scene_, path);
  bool plain = false, on_border = false;
  for (const Met& met : first_) {
    hit.faces.push_back(met.face);
    plain |= met.contact.kind == ContactKind::plain;
    if (met.contact.kind == ContactKind::on_edge || met.contact.kind == ContactKind::on_vertex) {
      on_border = true;
      borders.add(met.face, met.contact);
    }
  }
  std::sort(hit.faces.begin(), hit.faces.end());
  const bool firm = first_.empty() || plain || (on_border && borders.any_sealed());
  hit.touching = at_end_ || !firm;
  return hit;
}

bool meets(const Scene& scene, std::uint32_t face, const RayQuery& ray) {
  return contact(scene, face, ray).meets();
}

std::strong_ordering compare_hits(const Scene& scene, std::uint32_t a, std::uint32_t b, const RayQuery& ray) {
  return compare(scene, ray, a, hit_bounds(scene, a, ray), b, hit_bounds(scene, b, ray));
}

FirstHit first_hit_by_all_faces(const Scene& scene, const RayQuery& ray) {
  FirstHitFold fold(scene, ray);
  const auto count = static_cast<std::uint32_t>(scene.face_count());
  for (std::uint32_t face = 0; face < count; ++face) fold.add(face, contact(scene, face, ray));
  return fold.result();
}

}  // namespace gnomon::exact
