/* SPDX-License-Identifier: MIT */
/* A frustum-style test: the shaft as a list of planes, a box against each plane by its near and far corners,
 * as engines cull against a view frustum. Two forms of one kernel: planes as they come out of differences of
 * coordinates, which are exact on small integers, and planes divided by their length, which are not: there a
 * box that touches the shaft may be found outside of it. */
#include <math.h>
#include <stddef.h>

#include "gnomon/plugin.h"

enum { kMostPlanes = 6 + 12 };

typedef struct plane {
  float n[3], d;
} plane; /* the half-space n.x + d <= 0 */

/* The extent box's sides, then the planes that join an edge of `a` with one of `b`: those between a side on
 * which only `a` is extreme and one of another axis on which only `b` is (Haines and Wallace, "Shaft Cull
 * Testing"). */
static int shaft_planes(const float* a, const float* b, int normalise, plane* planes) {
  int count = 0;
  for (int f = 0; f < 6; ++f) {
    const float sign = f < 3 ? -1.0f : 1.0f;
    const float of_a = sign * a[f], of_b = sign * b[f];
    plane side = {{0, 0, 0}, 0};
    side.n[f % 3] = sign;
    side.d = -(of_a > of_b ? of_a : of_b);
    planes[count++] = side;
    for (int g = 0; of_a > of_b && g < 6; ++g) {
      const float sign_g = g < 3 ? -1.0f : 1.0f;
      if (g % 3 == f % 3 || !(sign_g * b[g] > sign_g * a[g])) continue;
      plane joint = {{0, 0, 0}, 0};
      joint.n[f % 3] = sign * fabsf(b[g] - a[g]);
      joint.n[g % 3] = sign_g * fabsf(a[f] - b[f]);
      joint.d = -(joint.n[f % 3] * a[f] + joint.n[g % 3] * a[g]);
      if (normalise) {
        const float length =
            sqrtf(joint.n[0] * joint.n[0] + joint.n[1] * joint.n[1] + joint.n[2] * joint.n[2]);
        for (int axis = 0; axis < 3; ++axis) joint.n[axis] /= length;
        joint.d /= length;
      }
      planes[count++] = joint;
    }
  }
  return count;
}

/* The value of the plane at the corner of the box that is nearest to (or farthest from) its inner side. */
static float corner_value(const plane* p, const float* box, int far_corner) {
  float value = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const int take_hi = (p->n[axis] > 0) == far_corner;
    value += p->n[axis] * box[take_hi ? axis + 3 : axis];
  }
  return value + p->d;
}

static unsigned char classify(const float* c, int normalise) {
  plane planes[kMostPlanes];
  const int count = shaft_planes(c, c + 6, normalise, planes);
  unsigned char answer = GNOMON_INSIDE;
  for (int i = 0; i < count; ++i) {
    if (corner_value(&planes[i], c + 12, 0) > 0) return GNOMON_OUTSIDE;
    if (!(corner_value(&planes[i], c + 12, 1) <= 0)) answer = GNOMON_OVERLAP;
  }
  return answer;
}

/* `user` is null for planes as formed. */
static void run(unsigned long long count, const float* cases, unsigned char* answers, void* user) {
  for (unsigned long long i = 0; i < count; ++i) answers[i] = classify(cases + 18 * i, user != NULL);
}

static int normalised = 1;

static const gnomon_method methods[] = {
    {GNOMON_SHAFT_BOX, GNOMON_PROMISES_NOTHING, "as-formed", "planes of differences of coordinates", run,
     NULL, NULL},
    {GNOMON_SHAFT_BOX, GNOMON_PROMISES_NOTHING, "normalised", "the same divided by their length", run, NULL,
     &normalised},
};

const gnomon_plugin* gnomon_plugin_entry(void) {
  static const gnomon_plugin plugin = {
      GNOMON_PLUGIN_ABI, sizeof(gnomon_plugin), sizeof(gnomon_method), 2, "planes", methods};
  return &plugin;
}
