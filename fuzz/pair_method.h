// SPDX-License-Identifier: GPL-3.0-or-later
// One row of the registries of questions about pairs in a scene: `shaft-candidates` and `patch-pair`.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "fuzz/method.h"
#include "scene/box.h"
#include "scene/patch_pair.h"
#include "scene/scene.h"

namespace gnomon::fuzz {

/// Two valid boxes, whose shaft is the convex hull of both: a case of `shaft-candidates`.
struct BoxPair {
  scene::Box<float> a, b;

  friend bool operator==(const BoxPair&, const BoxPair&) = default;
};

/// A method of `shaft-candidates` made ready for a scene. Several threads may ask it at once.
class CandidateFinder {
 public:
  CandidateFinder() = default;
  CandidateFinder(const CandidateFinder&) = delete;
  CandidateFinder& operator=(const CandidateFinder&) = delete;
  virtual ~CandidateFinder() = default;

  /// Replaces `out` by the faces that may block a segment from a to b: in any order, none twice. Every closed
  /// face that meets the closed shaft belongs there.
  virtual void faces(const BoxPair& pair, std::vector<std::uint32_t>& out) const = 0;
};

/// A method of `patch-pair` made ready for a scene. Several threads may ask it at once.
class PairJudge {
 public:
  PairJudge() = default;
  PairJudge(const PairJudge&) = delete;
  PairJudge& operator=(const PairJudge&) = delete;
  virtual ~PairJudge() = default;

  /// The number of a scene::PairVisibility, kUndecided or kRejected. All numbers of the pair are floats.
  [[nodiscard]] virtual Answer visibility(const scene::PatchPair& pair) const = 0;
};

/// A row: how to make what answers for a scene, which must outlive it and has floats alone
/// (scene/single.h).
template <class Maker>
struct PairRow {
  std::string_view name;
  std::string_view tier;  ///< trivial, naive, certified, exact, reference
  Promise promise;
  std::string_view domain;
  std::string_view summary;
  std::unique_ptr<Maker> (*make)(const scene::Scene& scene) = nullptr;
};

using CandidateMethod = PairRow<CandidateFinder>;
using PairMethod = PairRow<PairJudge>;

/// The rows of this project, in the order of reports. Adding methods is a file with a table of rows, and a
/// line in fuzz/pair_methods.cpp.
[[nodiscard]] std::span<const CandidateMethod> candidate_methods();
[[nodiscard]] std::span<const PairMethod> pair_methods();

}  // namespace gnomon::fuzz
