/* SPDX-License-Identifier: MIT */
/* Everything that a plug-in should not do, a method each; `fine` is next to them. Most do it on the few cases
 * of integer grids that is_chosen() names, so that the case to blame can be found. */
#define _POSIX_C_SOURCE 200809L
#include <fenv.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "gnomon/plugin.h"

typedef void action(unsigned long long count, const float* cases, unsigned char* answers,
                    unsigned long long i);

static int is_chosen(const float* c) {
  return c[0] == 3 && c[7] == 2;
}

static void do_crash(unsigned long long count, const float* cases, unsigned char* answers,
                     unsigned long long i) {
  (void)count, (void)cases, (void)answers, (void)i;
  volatile int* volatile nowhere = NULL;
  *nowhere = 1;
}
static void do_hang(unsigned long long count, const float* cases, unsigned char* answers,
                    unsigned long long i) {
  (void)count, (void)cases, (void)answers, (void)i;
  for (volatile int for_ever = 1; for_ever;) {
  }
}
static void do_abort(unsigned long long count, const float* cases, unsigned char* answers,
                     unsigned long long i) {
  (void)count, (void)cases, (void)answers, (void)i;
  abort();
}
static void do_exit(unsigned long long count, const float* cases, unsigned char* answers,
                    unsigned long long i) {
  (void)count, (void)cases, (void)answers, (void)i;
  _exit(3);
}
static void do_write_past(unsigned long long count, const float* cases, unsigned char* answers,
                          unsigned long long i) {
  (void)cases, (void)i;
  answers[count] = GNOMON_OVERLAP;
}
static void do_write_before(unsigned long long count, const float* cases, unsigned char* answers,
                            unsigned long long i) {
  (void)count, (void)cases, (void)i;
  *(answers - 1) = GNOMON_OVERLAP;
}
static void do_write_cases(unsigned long long count, const float* cases, unsigned char* answers,
                           unsigned long long i) {
  (void)count, (void)answers;
  union {
    const float* given;
    float* taken;
  } way = {cases};
  way.taken[18 * i] = 0;
}
static void do_read_past(unsigned long long count, const float* cases, unsigned char* answers,
                         unsigned long long i) {
  answers[i] = cases[18 * count] > 0 ? GNOMON_OVERLAP : GNOMON_UNDECIDED;
}
static void do_nonsense(unsigned long long count, const float* cases, unsigned char* answers,
                        unsigned long long i) {
  (void)count, (void)cases;
  answers[i] = 77;
}
static void do_round_down(unsigned long long count, const float* cases, unsigned char* answers,
                          unsigned long long i) {
  (void)count, (void)cases, (void)answers, (void)i;
  fesetround(FE_DOWNWARD);
}
static void do_allocate(unsigned long long count, const float* cases, unsigned char* answers,
                        unsigned long long i) {
  (void)count, (void)cases, (void)answers, (void)i;
  for (int gigabyte = 0; gigabyte < 64; ++gigabyte) {
    if (malloc((size_t)1 << 30) == NULL) abort();
  }
}
static void do_print(unsigned long long count, const float* cases, unsigned char* answers,
                     unsigned long long i) {
  (void)count, (void)cases, (void)answers;
  if (i == 0) printf("a plug-in's own words\n");
}
static void do_answer_by_count(unsigned long long count, const float* cases, unsigned char* answers,
                               unsigned long long i) {
  (void)cases;
  answers[i] = count > 1 ? GNOMON_OUTSIDE : GNOMON_OVERLAP;
}
/* A block of 1024 takes some 10 ms: time enough to be killed in. */
static void do_sleep(unsigned long long count, const float* cases, unsigned char* answers,
                     unsigned long long i) {
  (void)count, (void)cases, (void)answers;
  const struct timespec nap = {0, 10000000};
  if (i == 0) nanosleep(&nap, NULL);
}
/* Is killed, by whomever, as often as the file $GNOMON_TEST_KILLS has letters. */
static void do_be_killed(unsigned long long count, const float* cases, unsigned char* answers,
                         unsigned long long i) {
  (void)count, (void)cases, (void)answers;
  const char* const name = getenv("GNOMON_TEST_KILLS");
  struct stat left;
  if (i != 0 || name == NULL || stat(name, &left) != 0 || left.st_size == 0) return;
  if (truncate(name, left.st_size - 1) == 0) raise(SIGKILL);
}
static void do_nothing(unsigned long long count, const float* cases, unsigned char* answers,
                       unsigned long long i) {
  (void)count, (void)cases, (void)answers, (void)i;
}

typedef struct deed {
  action* act;
  int always; /* not only on the chosen cases */
} deed;

static void run(unsigned long long count, const float* cases, unsigned char* answers, void* user) {
  const deed* what = user;
  for (unsigned long long i = 0; i < count; ++i) {
    answers[i] = GNOMON_OVERLAP;
    if (what->always || is_chosen(cases + 18 * i)) what->act(count, cases, answers, i);
  }
}
static void run_unwritten(unsigned long long count, const float* cases, unsigned char* answers, void* user) {
  (void)user;
  for (unsigned long long i = 0; i < count; ++i) {
    if (!is_chosen(cases + 18 * i)) answers[i] = GNOMON_OVERLAP;
  }
}

const gnomon_plugin* gnomon_plugin_entry(void) {
  static deed crash = {do_crash, 0}, hang = {do_hang, 0}, aborts = {do_abort, 0}, exits = {do_exit, 0},
              past = {do_write_past, 0}, before = {do_write_before, 0}, into = {do_write_cases, 0},
              reads = {do_read_past, 0}, nonsense = {do_nonsense, 0}, modes = {do_round_down, 0},
              greedy = {do_allocate, 0}, prints = {do_print, 1}, fickle = {do_answer_by_count, 1},
              unlucky = {do_be_killed, 1}, slow = {do_sleep, 1}, fine = {do_nothing, 1};
#define ROW(NAME, DEED) \
  { GNOMON_SHAFT_BOX, GNOMON_NEVER_UNSOUND, NAME, NULL, run, NULL, DEED }
  static const gnomon_method methods[] = {
      ROW("crash", &crash),
      ROW("hang", &hang),
      ROW("abort", &aborts),
      ROW("exit", &exits),
      ROW("write-past", &past),
      ROW("write-before", &before),
      ROW("write-cases", &into),
      ROW("read-past", &reads),
      ROW("nonsense", &nonsense),
      ROW("modes", &modes),
      ROW("greedy", &greedy),
      ROW("prints", &prints),
      ROW("fickle", &fickle),
      ROW("unlucky", &unlucky),
      ROW("slow", &slow),
      ROW("fine", &fine),
      {GNOMON_SHAFT_BOX, GNOMON_NEVER_UNSOUND, "unwritten", NULL, run_unwritten, NULL, NULL},
  };
  static const gnomon_plugin plugin = {GNOMON_PLUGIN_ABI,
                                       sizeof(gnomon_plugin),
                                       sizeof(gnomon_method),
                                       sizeof methods / sizeof methods[0],
                                       "bad",
                                       methods};
  return &plugin;
}
