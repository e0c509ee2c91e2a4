// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a text corpus: cases that break no promise and can be explained, or a complaint of one line.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <sstream>

#include "fuzz/replay.h"
#include "fuzz/targets/complaint.h"
#include "reports/explain.h"
#include "scene/input_error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gnomon;
  std::istringstream in(std::string(data, data + size));
  try {
    std::vector<scene::CorpusLine> lines = scene::read_corpus(in, "input");
    constexpr std::size_t kMostCases = 4;  // more of them only cost time
    if (lines.size() > kMostCases) lines.resize(kMostCases);
    if (fuzz::replay(lines, {}).promise_broken()) std::abort();
    if (reports::explain(lines.front()).empty() || reports::explain_svg(lines.front()).empty()) std::abort();
  } catch (const scene::InputError& error) {
    fuzz::expect_complaint(error.what(), "input");
  }
  return 0;
}
