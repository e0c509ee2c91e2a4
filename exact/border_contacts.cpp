// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/border_contacts.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace gnomon::exact {

void BorderContacts::add(std::uint32_t triangle, Contact contact) {
  const auto& corners = scene_.triangles[triangle];
  const std::uint32_t at = corners[contact.corner], next = corners[(contact.corner + 1) % 3],
                      last = corners[(contact.corner + 2) % 3];
  if (contact.kind == ContactKind::on_vertex) {
    borders_.push_back({{at, at}, {next, last}});
  } else {
    borders_.push_back({{std::min(next, last), std::max(next, last)}, {at, at}});
  }
}

void BorderContacts::clear() {
  borders_.clear();
}

bool BorderContacts::any_sealed() const {
  const auto key = [](const Border& border) { return std::tie(border.shared[0], border.shared[1]); };
  std::sort(borders_.begin(), borders_.end(),
            [&](const Border& a, const Border& b) { return key(a) < key(b); });
  for (std::size_t begin = 0, end = 0; begin < borders_.size(); begin = end) {
    while (end < borders_.size() && key(borders_[end]) == key(borders_[begin])) ++end;
    if (borders_[begin].is_vertex() ? full_turn(begin, end) : two_sides(begin, end)) return true;
  }
  return false;
}

int BorderContacts::turn(std::uint32_t apex, std::uint32_t a, std::uint32_t b) const {
  return turn_along(path_, scene_.points[apex], scene_.points[a], scene_.points[b]);
}

bool BorderContacts::two_sides(std::size_t begin, std::size_t end) const {
  bool left = false, right = false;
  for (std::size_t i = begin; i < end; ++i) {
    const Border& border = borders_[i];
    const int side = turn(border.shared[0], border.shared[1], border.others[0]);
    left |= side > 0;
    right |= side < 0;
  }
  return left && right;
}

bool BorderContacts::full_turn(std::size_t begin, std::size_t end) const {
  // Every triangle covers a sector of less than half a turn, from its `others[0]` counterclockwise to its
  // `others[1]`. If some direction is uncovered, going clockwise from it one meets the end of a sector that
  // no other sector carries on; so the turn is full when every end lies in another sector or on its start.
  for (std::size_t i = begin; i < end; ++i) {
    Border& border = borders_[i];
    if (turn(border.shared[0], border.others[0], border.others[1]) < 0) {
      std::swap(border.others[0], border.others[1]);
    }
  }
  for (std::size_t i = begin; i < end; ++i) {
    const std::uint32_t ray = borders_[i].others[1];
    bool carried_on = false;
    for (std::size_t j = begin; j < end && !carried_on; ++j) {
      const Border& border = borders_[j];
      carried_on = j != i && turn(border.shared[0], border.others[0], ray) >= 0 &&
                   turn(border.shared[0], ray, border.others[1]) > 0;
    }
    if (!carried_on) return false;
  }
  return true;
}

}  // namespace gnomon::exact
