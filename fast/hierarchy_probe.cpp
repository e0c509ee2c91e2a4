// SPDX-License-Identifier: MIT
#include "fast/hierarchy_probe.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fast/hierarchy_probe.cpp"
#include <hwy/foreach_target.h>

#include "fast/hierarchy_balls_inl.h"
#include "fast/hierarchy_triangles_inl.h"

HWY_BEFORE_NAMESPACE();
namespace gnomon::fast {
namespace HWY_NAMESPACE {

void run_triangles(const TriangleBlock& block, const Beam& beam, TriangleProbe& probe) {
  const Floats d;
  const BeamVectors vectors(beam);
  for (std::size_t at = 0; at < kWidth; at += hn::Lanes(d)) {
    const TriangleValues x = evaluate(vectors, block, at);
    const TriangleErrors errors = errors_of(vectors, block, at, x);
    hn::StoreU(x.u, d, probe.u.data() + at);
    hn::StoreU(x.v, d, probe.v.data() + at);
    hn::StoreU(x.w, d, probe.w.data() + at);
    hn::StoreU(x.t, d, probe.t.data() + at);
    hn::StoreU(x.d, d, probe.d.data() + at);
    const V edge = hn::Mul(hn::Mul(hn::Load(d, block.edge_error.data() + at), x.c_most), vectors.spread);
    hn::StoreU(hn::Add(edge, hn::Set(d, kTriangleUnderflow)), d, probe.edge_error.data() + at);
    hn::StoreU(errors.w, d, probe.w_error.data() + at);
    hn::StoreU(errors.t, d, probe.t_error.data() + at);
    hn::StoreU(errors.d, d, probe.d_error.data() + at);
  }
}

void run_balls(const BallBlock& block, const Beam& beam, float end, BallProbe& probe) {
  const Floats d;
  const BeamVectors vectors(beam);
  for (std::size_t at = 0; at < kWidth; at += hn::Lanes(d)) {
    const BallValues x = evaluate(vectors, block, at, hn::Set(d, end));
    hn::StoreU(x.depth, d, probe.depth.data() + at);
    hn::StoreU(x.error, d, probe.error.data() + at);
  }
}

RayProbe taken_from(const LeafHits& hits) {
  RayProbe probe{hits.bits.certain, hits.bits.possible, {}, {}};
  for (std::size_t i = 0; i < kWidth; ++i) {
    probe.lo[i] = hits.lo[i];
    probe.hi[i] = hits.hi[i];
  }
  return probe;
}

RayProbe run_ray_triangles(const TriangleBlock& block, const Beam& beam) {
  return taken_from(ray_triangles<true>(BeamVectors(beam), block, std::numeric_limits<float>::infinity()));
}
RayProbe run_ray_balls(const BallBlock& block, const Beam& beam, bool leaving) {
  return taken_from(
      ray_balls<true>(BeamVectors(beam), block, std::numeric_limits<float>::infinity(), leaving));
}

std::uint32_t run_boxes(const WideNode& node, const Beam& beam, float end) {
  const Floats d;
  const BeamVectors vectors(beam);
  std::uint32_t bits = 0;
  for (std::size_t at = 0; at < kWidth; at += hn::Lanes(d)) {
    V entry;
    bits |= bits_of(d, boxes_met(vectors, node, at, hn::Set(d, end), entry)) << at;
  }
  return bits;
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace gnomon::fast
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gnomon::fast {

namespace {

HWY_EXPORT(run_triangles);
HWY_EXPORT(run_balls);
HWY_EXPORT(run_boxes);
HWY_EXPORT(run_ray_triangles);
HWY_EXPORT(run_ray_balls);

}  // namespace

TriangleProbe probe_triangles(const TriangleBlock& block, const Beam& beam) {
  TriangleProbe probe;
  HWY_DYNAMIC_DISPATCH(run_triangles)(block, beam, probe);
  return probe;
}

BallProbe probe_balls(const BallBlock& block, const Beam& beam, float end) {
  BallProbe probe;
  HWY_DYNAMIC_DISPATCH(run_balls)(block, beam, end, probe);
  return probe;
}

RayProbe probe_ray(const TriangleBlock& block, const Beam& beam) {
  return HWY_DYNAMIC_DISPATCH(run_ray_triangles)(block, beam);
}
RayProbe probe_ray(const BallBlock& block, const Beam& beam, bool leaving) {
  return HWY_DYNAMIC_DISPATCH(run_ray_balls)(block, beam, leaving);
}

std::uint32_t probe_boxes(const WideNode& node, const Beam& beam, float end) {
  return HWY_DYNAMIC_DISPATCH(run_boxes)(node, beam, end);
}

}  // namespace gnomon::fast
#endif  // HWY_ONCE
