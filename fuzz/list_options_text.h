// SPDX-License-Identifier: GPL-3.0-or-later
// Options of candidate lists as text: "strategy=ratio-open,ratio=0.6,mailbox=off".
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "fast/item_tree.h"
#include "fast/list_options.h"

namespace gnomon::fuzz {

/// A tree and the lists made from it.
struct ListSetup {
  fast::ListOptions options;
  fast::TreeBuild tree = fast::TreeBuild::goldsmith_salmon;
  fast::Volumes volumes = fast::Volumes::boxes;
  std::uint32_t seed = 1;

  friend bool operator==(const ListSetup&, const ListSetup&) = default;
};

/// NAME=VALUE,...: what is not named has its default; no text gives the defaults. Names and values are those
/// of the members, with hyphens; on or off for what is either. Throws UsageError, one line that names what is
/// known, for unknown names and values, numbers out of range, names given twice, and super-most below
/// super-least.
[[nodiscard]] ListSetup parse_list_setup(std::string_view text);

/// The text that reads back as the same: what differs from the defaults, in the order of the members.
[[nodiscard]] std::string text_of(const ListSetup& setup);

/// All names with their values, defaults first: for help.
[[nodiscard]] std::string known_list_options();

}  // namespace gnomon::fuzz
