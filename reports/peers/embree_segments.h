// SPDX-License-Identifier: GPL-3.0-or-later
// Embree on batches of segments between points, as fast as it can be asked: no own faces, no filters.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>

#include "scene/scene.h"

namespace gnomon::reports {

/// The segments from every point of `from` to every point of `to`, as in fast/pair_visibility.h.
struct SegmentBatch {
  std::span<const std::array<float, 3>> from, to;
};

enum class EmbreeMode : std::uint8_t { single, robust, high_quality, packet16 };

class SegmentCaster {
 public:
  SegmentCaster() = default;
  SegmentCaster(const SegmentCaster&) = delete;
  SegmentCaster& operator=(const SegmentCaster&) = delete;
  virtual ~SegmentCaster() = default;

  /// Writes 1 for a segment that is blocked, else 0: batch by batch, as many as there are segments.
  virtual void run(std::span<const SegmentBatch> batches, std::span<std::uint8_t> blocked) const = 0;
};

/// Null where Embree was not built in. Faces that a segment starts or ends on block it as they please:
/// segments are open, from 0 to the largest float below 1, and nothing else is done about it.
[[nodiscard]] std::unique_ptr<SegmentCaster> make_embree_segments(const scene::Scene& scene, EmbreeMode mode);

}  // namespace gnomon::reports
