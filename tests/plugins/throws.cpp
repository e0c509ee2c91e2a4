// SPDX-License-Identifier: MIT
// A plug-in in C++ that lets an exception out, and one without flaw beside it.
#include <stdexcept>

#include "gnomon/plugin.h"

namespace {

void overlap(unsigned long long count, const double*, unsigned char* answers, void*) {
  for (unsigned long long i = 0; i < count; ++i) answers[i] = GNOMON_OVERLAP;
}
void throws(unsigned long long, const double*, unsigned char*, void*) {
  throw std::runtime_error("out");
}

constexpr gnomon_method kMethods[] = {
    {GNOMON_SHAFT_BOX, GNOMON_PROMISES_NOTHING, "throws", nullptr, nullptr, throws, nullptr},
    {GNOMON_SHAFT_SPHERE, GNOMON_NEVER_UNSOUND, "overlap", "always overlap", nullptr, overlap, nullptr},
};
constexpr gnomon_plugin kPlugin = {GNOMON_PLUGIN_ABI, sizeof(gnomon_plugin), sizeof(gnomon_method), 2, "cxx",
                                   kMethods};

}  // namespace

const gnomon_plugin* gnomon_plugin_entry() {
  return &kPlugin;
}
