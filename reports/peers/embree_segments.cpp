// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/peers/embree_segments.h"

#include <algorithm>
#include <limits>

#include "reports/peers/embree_scene.h"
#include "reports/peers/flush_denormals.h"

namespace gnomon::reports {
namespace {

constexpr float kBelowOne = 1 - std::numeric_limits<float>::epsilon() / 2;

class EmbreeSegments : public SegmentCaster {
 public:
  EmbreeSegments(const scene::Scene& scene, EmbreeMode mode)
      : faces_(scene),
        scene_(faces_, {mode == EmbreeMode::robust, mode == EmbreeMode::high_quality, 1}),
        packets_(mode == EmbreeMode::packet16) {}

  void run(std::span<const SegmentBatch> batches, std::span<std::uint8_t> blocked) const override {
    const FlushDenormals flush;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    std::uint8_t* out = blocked.data();
    for (const SegmentBatch& batch : batches) {
      if (packets_) {
        in_packets(batch, context, out);
      } else {
        one_by_one(batch, context, out);
      }
      out += batch.from.size() * batch.to.size();
    }
  }

 private:
  void one_by_one(const SegmentBatch& batch, RTCIntersectContext& context, std::uint8_t* out) const {
    for (const auto& p : batch.from) {
      for (const auto& q : batch.to) {
        RTCRay ray{p[0], p[1], p[2], 0, q[0] - p[0], q[1] - p[1], q[2] - p[2], 0, kBelowOne, ~0U, 0, 0};
        rtcOccluded1(scene_.get(), &context, &ray);
        *out++ = ray.tfar < 0;
      }
    }
  }

  void in_packets(const SegmentBatch& batch, RTCIntersectContext& context, std::uint8_t* out) const {
    constexpr std::size_t kPacket = 16;
    const std::size_t rays = batch.from.size() * batch.to.size();
    RTCRay16 packet{};
    alignas(64) std::array<int, kPacket> valid;
    std::size_t i = 0, k = 0;
    for (std::size_t first = 0; first < rays; first += kPacket) {
      const std::size_t count = std::min(kPacket, rays - first);
      valid.fill(0);
      for (std::size_t lane = 0; lane < count; ++lane) {
        const auto &p = batch.from[i], &q = batch.to[k];
        packet.org_x[lane] = p[0], packet.org_y[lane] = p[1], packet.org_z[lane] = p[2];
        packet.dir_x[lane] = q[0] - p[0], packet.dir_y[lane] = q[1] - p[1], packet.dir_z[lane] = q[2] - p[2];
        packet.tnear[lane] = 0, packet.tfar[lane] = kBelowOne, packet.mask[lane] = ~0U;
        valid[lane] = -1;
        if (++k == batch.to.size()) {
          k = 0;
          ++i;
        }
      }
      rtcOccluded16(valid.data(), scene_.get(), &context, &packet);
      for (std::size_t lane = 0; lane < count; ++lane) *out++ = packet.tfar[lane] < 0;
    }
  }

  fuzz::FloatFaces faces_;
  EmbreeScene scene_;
  bool packets_;
};

}  // namespace

std::unique_ptr<SegmentCaster> make_embree_segments(const scene::Scene& scene, EmbreeMode mode) {
  return std::make_unique<EmbreeSegments>(scene, mode);
}

}  // namespace gnomon::reports
