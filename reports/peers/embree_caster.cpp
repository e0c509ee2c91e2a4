// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/peers/embree_caster.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "reports/peers/embree_scene.h"
#include "reports/peers/flush_denormals.h"

namespace gnomon::reports {
namespace {

using fuzz::Answer;
using fuzz::FloatFaces;
using fuzz::Vector;
using fuzz::operator-;
using scene::Shadow;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kBelowOne = 1 - std::numeric_limits<float>::epsilon() / 2;

/// What the filter is told: for each ray of a packet the geometry and number of the face to leave out.
struct Context {
  RTCIntersectContext base;  // first: the filter is handed its address
  std::array<unsigned, 16> own_geometry, own_number;
};

void leave_out_own_face(const RTCFilterFunctionNArguments* args) {
  const auto* const context = reinterpret_cast<const Context*>(args->context);
  for (unsigned i = 0; i < args->N; ++i) {
    if (args->valid[i] == 0) continue;
    const unsigned ray = RTCRayN_id(args->ray, args->N, i);
    if (RTCHitN_geomID(args->hit, args->N, i) == context->own_geometry[ray] &&
        RTCHitN_primID(args->hit, args->N, i) == context->own_number[ray]) {
      args->valid[i] = 0;
    }
  }
}

template <unsigned kPacket>
struct Packet;
template <>
struct Packet<8> {
  using Rays = RTCRay8;
  static constexpr auto occluded = rtcOccluded8;
};
template <>
struct Packet<16> {
  using Rays = RTCRay16;
  static constexpr auto occluded = rtcOccluded16;
};

class EmbreeCaster : public fuzz::SceneCaster {
 public:
  EmbreeCaster(const scene::Scene& scene, EmbreeOptions options)
      : faces_(scene), scene_(faces_, options), packet_(options.packet), filter_(options.filter) {}

  void shadows(std::span<const scene::ShadowQuery> queries, std::span<Answer> answers) const override {
    const FlushDenormals flush;
    if (packet_ == 8) return in_packets<8>(queries, answers);
    if (packet_ == 16) return in_packets<16>(queries, answers);
    Context context = new_context();
    for (std::size_t i = 0; i < queries.size(); ++i) {
      const Shadow before = without_blockers(queries[i]);
      answers[i] = static_cast<Answer>(before != Shadow::lit           ? before
                                       : occluded(queries[i], context) ? Shadow::shadowed
                                                                       : Shadow::lit);
    }
  }

  /// Ray by ray, but points are rounded to floats once, and no rule about own faces is asked: all rays face.
  void pair_shadows(std::span<const fuzz::RadiosityPair> pairs, std::span<Answer> answers) const override {
    const FlushDenormals flush;
    Context context = new_context();
    std::vector<Vector> lights;
    std::size_t next = 0;
    for (const fuzz::RadiosityPair& pair : pairs) {
      lights.clear();
      for (const auto& light : pair.to.points) lights.push_back(fuzz::to_floats(light));
      for (std::size_t i = 0; i < pair.from.points.size(); ++i) {
        const Vector point = fuzz::to_floats(pair.from.points[i]);
        exclude(context, 0, pair.from.faces[i]);
        for (const Vector& light : lights) {
          answers[next++] =
              static_cast<Answer>(occluded(point, light - point, context) ? Shadow::shadowed : Shadow::lit);
        }
      }
    }
  }

  void first_hits(std::span<const scene::RayQuery> rays, std::span<std::uint32_t> faces) const override {
    const FlushDenormals flush;
    Context context = new_context();
    for (std::size_t i = 0; i < rays.size(); ++i) faces[i] = first_hit(rays[i], context);
  }

  [[nodiscard]] std::size_t bytes() const override { return faces_.bytes() + scene_.bytes(); }

 private:
  [[nodiscard]] Context new_context() const {
    Context context{};
    rtcInitIntersectContext(&context.base);
    if (filter_) context.base.filter = leave_out_own_face;
    return context;
  }

  void exclude(Context& context, std::size_t ray, std::uint32_t own) const {
    const bool ball = own != scene::kNoFace && own >= faces_.triangles.size();
    context.own_geometry[ray] = ball ? EmbreeScene::kBalls : EmbreeScene::kTriangles;
    context.own_number[ray] = ball ? own - static_cast<std::uint32_t>(faces_.triangles.size()) : own;
  }

  /// What the rules about own faces say alone; lit when they leave it to the others.
  [[nodiscard]] Shadow without_blockers(const scene::ShadowQuery& query) const {
    if (faces_.faces_away(query)) return Shadow::facing;
    const Vector point = fuzz::to_floats(query.point);
    return faces_.own_ball_blocks(query.own, point, fuzz::to_floats(query.light) - point) ? Shadow::shadowed
                                                                                          : Shadow::lit;
  }

  bool occluded(const scene::ShadowQuery& query, Context& context) const {
    const Vector point = fuzz::to_floats(query.point), to = fuzz::to_floats(query.light) - point;
    exclude(context, 0, query.own);
    return occluded(point, to, context);
  }

  bool occluded(const Vector& point, const Vector& to, Context& context) const {
    RTCRay ray{point[0], point[1], point[2], 0, to[0], to[1], to[2], 0, kBelowOne, ~0U, 0, 0};
    rtcOccluded1(scene_.get(), &context.base, &ray);
    return ray.tfar < 0;
  }

  /// Packets of queries as they come; those that the own face decides stay in, inactive.
  template <unsigned kPacket>
  void in_packets(std::span<const scene::ShadowQuery> queries, std::span<Answer> answers) const {
    Context context = new_context();
    typename Packet<kPacket>::Rays rays{};
    alignas(64) std::array<int, kPacket> valid;
    for (std::size_t first = 0; first < queries.size(); first += kPacket) {
      const std::size_t count = std::min<std::size_t>(kPacket, queries.size() - first);
      valid.fill(0);
      for (std::size_t i = 0; i < count; ++i) {
        const scene::ShadowQuery& query = queries[first + i];
        const Shadow before = without_blockers(query);
        answers[first + i] = static_cast<Answer>(before);
        valid[i] = before == Shadow::lit ? -1 : 0;
        const Vector point = fuzz::to_floats(query.point), to = fuzz::to_floats(query.light) - point;
        rays.org_x[i] = point[0], rays.org_y[i] = point[1], rays.org_z[i] = point[2];
        rays.dir_x[i] = to[0], rays.dir_y[i] = to[1], rays.dir_z[i] = to[2];
        rays.tnear[i] = 0, rays.tfar[i] = kBelowOne, rays.mask[i] = ~0U;
        rays.id[i] = static_cast<unsigned>(i);
        exclude(context, i, query.own);
      }
      Packet<kPacket>::occluded(valid.data(), scene_.get(), &context.base, &rays);
      for (std::size_t i = 0; i < count; ++i) {
        if (valid[i] != 0 && rays.tfar[i] < 0) answers[first + i] = static_cast<Answer>(Shadow::shadowed);
      }
    }
  }

  std::uint32_t first_hit(const scene::RayQuery& query, Context& context) const {
    const Vector from = fuzz::to_floats(query.origin), to = fuzz::to_floats(query.direction);
    // A ray into its own ball meets it where it leaves: Embree is asked about all faces then.
    exclude(context, 0, faces_.own_ball_blocks(query.own, from, to) ? scene::kNoFace : query.own);
    RTCRayHit hit{};
    hit.ray = {from[0], from[1], from[2], 0, to[0], to[1], to[2], 0, kInfinity, ~0U, 0, 0};
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene_.get(), &context.base, &hit);
    if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return scene::kNoFace;
    return hit.hit.geomID == EmbreeScene::kTriangles
               ? hit.hit.primID
               : hit.hit.primID + static_cast<std::uint32_t>(faces_.triangles.size());
  }

  FloatFaces faces_;
  EmbreeScene scene_;
  unsigned packet_;
  bool filter_;
};

}  // namespace

std::unique_ptr<fuzz::SceneCaster> make_embree_caster(const scene::Scene& scene, EmbreeOptions options) {
  return std::make_unique<EmbreeCaster>(scene, options);
}

}  // namespace gnomon::reports
