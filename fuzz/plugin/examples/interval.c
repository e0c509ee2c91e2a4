/* SPDX-License-Identifier: MIT */
/* Interval analysis: the shaft is the union of the boxes (1-s) A + s B, 0 <= s <= 1. For a range of s,
 * interval arithmetic encloses those boxes; when the enclosure misses T, so do they all. Ranges that can't be
 * told are halved. "Outside" and "inside" are proved, every rounding goes outwards: this one promises never
 * to be unsound. */
#include <math.h>
#include <stddef.h>

#include "gnomon/plugin.h"

/* Ranges down to 2^-kDepth: what is left then is kept. */
enum { kDepth = 8 };

typedef struct interval {
  double lo, hi;
} interval;

/* Rounding to nearest errs by at most half a step, so one step outwards encloses the exact result. */
static double down(double x) {
  return nextafter(x, -INFINITY);
}
static double up(double x) {
  return nextafter(x, INFINITY);
}

/* The least and the largest (1-s) a + s b over s in [s0, s1]; a linear function has both at the ends. s, 1-s
 * are multiples of 2^-kDepth, hence exact; no step overflows, as s and 1-s are at most 1. */
static double at_least(double a, double b, double s) {
  return down(down((1 - s) * a) + down(s * b));
}
static double at_most(double a, double b, double s) {
  return up(up((1 - s) * a) + up(s * b));
}

static interval side(double a_lo, double b_lo, double a_hi, double b_hi, double s0, double s1) {
  interval result;
  result.lo = fmin(at_least(a_lo, b_lo, s0), at_least(a_lo, b_lo, s1));
  result.hi = fmax(at_most(a_hi, b_hi, s0), at_most(a_hi, b_hi, s1));
  return result;
}

/* T as a box: misses the enclosure when an axis parts them. */
static int box_misses(const interval* e, const double* t) {
  for (int axis = 0; axis < 3; ++axis) {
    if (e[axis].lo > t[axis + 3] || e[axis].hi < t[axis]) return 1;
  }
  return 0;
}

/* T as a ball c, r: misses when its centre is farther than r from the enclosure. A NaN keeps. */
static int ball_misses(const interval* e, const double* t) {
  double square = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double below = down(e[axis].lo - t[axis]), above = down(t[axis] - e[axis].hi);
    const double gap = fmax(fmax(below, above), 0);
    square = fmax(down(square + fmax(down(gap * gap), 0)), 0);
  }
  return square > up(t[3] * t[3]);
}

typedef int misses(const interval* e, const double* t);

static int outside(const double* c, misses* test, double s0, double s1, int depth) {
  interval e[3];
  for (int axis = 0; axis < 3; ++axis) e[axis] = side(c[axis], c[axis + 6], c[axis + 3], c[axis + 9], s0, s1);
  if (test(e, c + 12)) return 1;
  if (depth == kDepth) return 0;
  const double middle = (s0 + s1) / 2;
  return outside(c, test, s0, middle, depth + 1) && outside(c, test, middle, s1, depth + 1);
}

/* A box within A or within B is inside; comparisons are exact. Other inside boxes are said to overlap. */
static int within(const double* box, const double* t) {
  for (int axis = 0; axis < 3; ++axis) {
    if (t[axis] < box[axis] || t[axis + 3] > box[axis + 3]) return 0;
  }
  return 1;
}

static void run_box(unsigned long long count, const double* cases, unsigned char* answers, void* user) {
  (void)user;
  for (unsigned long long i = 0; i < count; ++i) {
    const double* c = cases + 18 * i;
    answers[i] = within(c, c + 12) || within(c + 6, c + 12) ? GNOMON_INSIDE
                 : outside(c, box_misses, 0, 1, 0)          ? GNOMON_OUTSIDE
                                                            : GNOMON_OVERLAP;
  }
}

static void run_ball(unsigned long long count, const double* cases, unsigned char* answers, void* user) {
  (void)user;
  for (unsigned long long i = 0; i < count; ++i)
    answers[i] = outside(cases + 16 * i, ball_misses, 0, 1, 0) ? GNOMON_OUTSIDE : GNOMON_OVERLAP;
}

static const gnomon_method methods[] = {
    {GNOMON_SHAFT_BOX, GNOMON_NEVER_UNSOUND, "halving", "enclosures of parts of the shaft", NULL, run_box,
     NULL},
    {GNOMON_SHAFT_SPHERE, GNOMON_NEVER_UNSOUND, "halving", "enclosures of parts of the shaft", NULL, run_ball,
     NULL},
};

const gnomon_plugin* gnomon_plugin_entry(void) {
  static const gnomon_plugin plugin = {
      GNOMON_PLUGIN_ABI, sizeof(gnomon_plugin), sizeof(gnomon_method), 2, "interval", methods};
  return &plugin;
}
