// SPDX-License-Identifier: MIT
// Candidate lists: the items that may block rays between two reference items.
#pragma once

#include <cstdint>
#include <vector>

#include "fast/item_tree.h"
#include "fast/mailbox.h"

namespace gnomon::fast {

/// Items of a tree, none below another, and marks on items at or below them that were found outside: these
/// are passed over, with all below them. Made by fast/list_builder.h.
struct CandidateList {
  std::vector<std::uint32_t> items;
  Mailbox marks;
  /// The list that this one was made from, whose marks hold here too; null: none. It must still be as it was.
  const CandidateList* parent = nullptr;
  /// Of an emitter list, where known: does items[i] meet the emitter's box? Else empty.
  std::vector<std::uint8_t> meets_emitter;

  [[nodiscard]] bool is_marked(std::uint32_t item) const {
    for (const CandidateList* list = this; list != nullptr; list = list->parent) {
      if (list->marks.is_marked(item)) return true;
    }
    return false;
  }
  [[nodiscard]] bool has_marks() const {
    for (const CandidateList* list = this; list != nullptr; list = list->parent) {
      if (list->marks.any()) return true;
    }
    return false;
  }
};

/// The primitives of a list: the faces of all primitives at or below its items that neither are marked nor
/// lie below what is. Appends their numbers, in no special order, each once.
void append_faces(const ItemTree& tree, const CandidateList& list, std::vector<std::uint32_t>& faces);

}  // namespace gnomon::fast
