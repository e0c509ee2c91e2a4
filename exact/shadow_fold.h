// SPDX-License-Identifier: GPL-3.0-or-later
// From the contacts of a query to its answer. Internal to exact/.
#pragma once

#include <cstdint>
#include <optional>

#include "exact/border_contacts.h"
#include "exact/shadow.h"

namespace gnomon::exact {

/// The sign of n * (light - point) when the own face has a front only and is not degenerate.
[[nodiscard]] std::optional<int> own_facing(const scene::Scene& scene, const scene::ShadowQuery& query);

/// Takes contacts of one query in any order. The answer is settled by the first plain or sealed one.
class ShadowFold {
 public:
  /// `facing_is_zero`: the product that decides about facing.
  ShadowFold(const scene::Scene& scene, const Path& path, bool facing_is_zero)
      : borders_(scene, path), facing_is_zero_(facing_is_zero) {}

  void add_plain() { settled_ = true; }
  void add(std::uint32_t face, Contact contact);
  /// True when nothing that is added can change the answer.
  [[nodiscard]] bool settled() const { return settled_; }
  [[nodiscard]] ShadowTruth truth() const;

 private:
  BorderContacts borders_;
  bool facing_is_zero_, settled_ = false, at_end_ = false, met_ = false, on_border_ = false;
};

}  // namespace gnomon::exact
