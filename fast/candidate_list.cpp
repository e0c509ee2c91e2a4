// SPDX-License-Identifier: MIT
#include "fast/candidate_list.h"

namespace gnomon::fast {

void append_faces(const ItemTree& tree, const CandidateList& list, std::vector<std::uint32_t>& faces) {
  std::vector<std::uint32_t> open;
  open.reserve(tree.stack_size());
  for (const std::uint32_t start : list.items) {
    open.push_back(start);
    while (!open.empty()) {
      const std::uint32_t i = open.back();
      open.pop_back();
      if (list.is_marked(i)) continue;
      const Item& item = tree.item(i);
      for (std::uint32_t k = item.count(); k-- > 0;)
        (item.is_primitive() ? faces : open).push_back(item.first + k);
    }
  }
}

}  // namespace gnomon::fast
