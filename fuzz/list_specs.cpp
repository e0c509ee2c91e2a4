// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of the tables of candidate lists.
#include "fuzz/list_statistics.h"

namespace gnomon::fuzz {
namespace {

ListSpec lists(const char* name, const char* setup) {
  return {name, ListStart::lists, parse_list_setup(setup)};
}

}  // namespace

std::vector<ListSpec> table1_specs() {
  return {{"baseline", ListStart::emitter_list, {}},    lists("keep closed", "strategy=keep-closed"),
          lists("always open", "strategy=always-open"), lists("overlap open", "strategy=overlap-open"),
          lists("ratio open 0.2", "ratio=0.2"),         lists("ratio open 0.4", "ratio=0.4"),
          lists("ratio open 0.6", "ratio=0.6"),         lists("ratio open 0.8", "ratio=0.8")};
}

std::vector<ListSpec> text_specs() {
  return {{"shadow cache alone", ListStart::root, parse_list_setup("emitter-list=off,behind-emitter=off")},
          lists("ratio open 0.2, no marks", "ratio=0.2,mailbox=off"),
          lists("ratio open 0.6, no marks", "ratio=0.6,mailbox=off"),
          lists("ratio open 0.8, no marks", "ratio=0.8,mailbox=off")};
}

ListSpec uncached_spec() {
  return {"no shadow cache", ListStart::root,
          parse_list_setup("shadow-cache=off,emitter-list=off,behind-emitter=off")};
}

std::vector<ListSpec> option_specs() {
  std::vector<ListSpec> specs{lists("defaults", "")};
  for (const char* const setup : {"discard-single=off",
                                  "enclosure=off",
                                  "emitter-list=off",
                                  "emitter-overlap=off",
                                  "behind-emitter=off",
                                  "back-faces=on",
                                  "mailbox=off",
                                  "shadow-cache=off",
                                  "wait-for-miss=off",
                                  "min-rays=10",
                                  "adjacency=0.0009765625",
                                  "clump=64",
                                  "clump=64,nested=on",
                                  "super-least=16,super-most=256",
                                  "sorting=solid-angle",
                                  "sorting=nearest",
                                  "sorting=hits",
                                  "sort-planes=on",
                                  "weak-planes=0.0625",
                                  "open-from-rays=16",
                                  "patch-planes=on",
                                  "arithmetic=certified",
                                  "tree=sah",
                                  "volumes=spheres"}) {
    specs.push_back(lists(setup, setup));
  }
  specs.push_back(lists("boxes of points", ""));
  specs.back().tight_boxes = true;
  return specs;
}

}  // namespace gnomon::fuzz
