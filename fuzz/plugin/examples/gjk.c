/* SPDX-License-Identifier: MIT */
/* GJK by libccd (double precision in Debian's package): the shaft and T by their support functions alone. */
#include <ccd/ccd.h>
#include <math.h>
#include <stddef.h>

#include "gnomon/plugin.h"

/* The farthest point of a box in a direction. */
static ccd_vec3_t farthest(const double* box, const ccd_vec3_t* direction) {
  ccd_vec3_t point;
  for (int axis = 0; axis < 3; ++axis) point.v[axis] = box[direction->v[axis] >= 0 ? axis + 3 : axis];
  return point;
}

/* Of the shaft, the hull of the boxes at `object` and behind it: the better of theirs. */
static void support_shaft(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* point) {
  const double* boxes = object;
  const ccd_vec3_t a = farthest(boxes, direction), b = farthest(boxes + 6, direction);
  *point = ccdVec3Dot(&a, direction) >= ccdVec3Dot(&b, direction) ? a : b;
}

static void support_box(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* point) {
  *point = farthest(object, direction);
}

static void support_ball(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* point) {
  const double* ball = object;
  const double length = sqrt(ccdVec3Dot(direction, direction));
  for (int axis = 0; axis < 3; ++axis)
    point->v[axis] = ball[axis] + (length > 0 ? ball[3] * direction->v[axis] / length : 0);
}

static unsigned char intersect(const double* c, ccd_support_fn support) {
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.support1 = support_shaft;
  ccd.support2 = support;
  ccd.max_iterations = 100; /* without a limit it may circle for ever */
  return ccdGJKIntersect(c, c + 12, &ccd) ? GNOMON_OVERLAP : GNOMON_OUTSIDE;
}

static void run_box(unsigned long long count, const double* cases, unsigned char* answers, void* user) {
  (void)user;
  for (unsigned long long i = 0; i < count; ++i) answers[i] = intersect(cases + 18 * i, support_box);
}

static void run_ball(unsigned long long count, const double* cases, unsigned char* answers, void* user) {
  (void)user;
  for (unsigned long long i = 0; i < count; ++i) answers[i] = intersect(cases + 16 * i, support_ball);
}

static const gnomon_method methods[] = {
    {GNOMON_SHAFT_BOX, GNOMON_PROMISES_NOTHING, "ccd", "libccd's GJK, never inside", NULL, run_box, NULL},
    {GNOMON_SHAFT_SPHERE, GNOMON_PROMISES_NOTHING, "ccd", "libccd's GJK, never inside", NULL, run_ball, NULL},
};

const gnomon_plugin* gnomon_plugin_entry(void) {
  static const gnomon_plugin plugin = {
      GNOMON_PLUGIN_ABI, sizeof(gnomon_plugin), sizeof(gnomon_method), 2, "gjk", methods};
  return &plugin;
}
