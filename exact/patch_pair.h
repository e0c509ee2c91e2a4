// SPDX-License-Identifier: GPL-3.0-or-later
// The exact answers to `patch-pair`: scene/patch_pair.h has the definition.
#pragma once

#include <cstdint>
#include <memory>

#include "scene/patch_pair.h"
#include "scene/scene.h"

namespace gnomon::exact {

/// What queries have cost: nodes of the tree tested, faces tested, and faces that intervals could not decide
/// about.
struct PatchPairCounters {
  std::uint64_t nodes = 0, faces = 0, exact_faces = 0;
};

/// True when the closed face has a point in common with an open segment between the patches: with
/// U = {(1-s)p + sq : p in a, q in b, 0 < s < 1}. The patches' own faces are treated as any other. Exact for
/// any finite doubles: intervals first, exact floats where they leave it open.
[[nodiscard]] bool can_block(const scene::Scene& scene, std::uint32_t face, const scene::PatchPair& pair);

/// True when the face lies strictly between the planes of both patches and meets all nine open segments from
/// corners of `a` to corners of `b`. Exact as above.
[[nodiscard]] bool hides(const scene::Scene& scene, std::uint32_t face, const scene::PatchPair& pair);

/// The answer, face by face.
[[nodiscard]] scene::PairVisibility patch_pair_by_all_faces(const scene::Scene& scene,
                                                            const scene::PatchPair& pair);

struct BuiltHierarchy;

/// The same in much less time, by a hierarchy of boxes that are rounded outwards.
///
/// Keeps a reference to the scene, which must be valid and must not change. Queries may run in any number of
/// threads at once; they allocate nothing, unless exact floats have to decide. Corners must be finite.
class PatchPairs {
 public:
  explicit PatchPairs(const scene::Scene& scene);
  ~PatchPairs();
  PatchPairs(const PatchPairs&) = delete;
  PatchPairs& operator=(const PatchPairs&) = delete;

  [[nodiscard]] scene::PairVisibility visibility(const scene::PatchPair& pair) const;
  [[nodiscard]] scene::PairVisibility visibility(const scene::PatchPair& pair,
                                                 PatchPairCounters& counters) const;

 private:
  const scene::Scene& scene_;
  std::unique_ptr<const BuiltHierarchy> built_;
};

}  // namespace gnomon::exact
