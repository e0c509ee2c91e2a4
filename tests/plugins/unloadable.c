/* SPDX-License-Identifier: MIT */
/* Plug-ins that can't be used: each FLAW is compiled into a module of its own. */
#include <stddef.h>

#include "gnomon/plugin.h"

#define OTHER_VERSION 1
#define CRASHES 2
#define HANGS 3
#define NO_METHODS 4
#define SMALL 5
#define BAD_NAME 6
#define UNKNOWN_QUESTION 7
#define NO_FORM 8
#define TWINS 9
#define IS_NULL 10
#define NO_ENTRY 11
#define BAD_POINTER 12

static void run(unsigned long long count, const float* cases, unsigned char* answers, void* user) {
  (void)cases, (void)user;
  for (unsigned long long i = 0; i < count; ++i) answers[i] = GNOMON_OVERLAP;
}

static const gnomon_method methods[] = {
    {FLAW == UNKNOWN_QUESTION ? 9 : GNOMON_SHAFT_BOX, GNOMON_PROMISES_NOTHING,
     FLAW == BAD_NAME ? "no spaces" : "same", NULL, FLAW == NO_FORM ? NULL : run, NULL, NULL},
    {GNOMON_SHAFT_BOX, GNOMON_PROMISES_NOTHING, FLAW == TWINS ? "same" : "other", NULL, run, NULL, NULL},
};

static const gnomon_plugin plugin = {FLAW == OTHER_VERSION ? 2 : GNOMON_PLUGIN_ABI,
                                     FLAW == SMALL ? 8 : sizeof(gnomon_plugin),
                                     sizeof(gnomon_method),
                                     FLAW == NO_METHODS ? 0 : 2,
                                     "flawed",
                                     methods};

#if FLAW == NO_ENTRY
const gnomon_plugin* entry_of_another_name(void);
const gnomon_plugin* entry_of_another_name(void) {
  return &plugin;
}
#else
const gnomon_plugin* gnomon_plugin_entry(void) {
  volatile int* volatile nowhere = NULL;
  if (FLAW == CRASHES) *nowhere = 1;
  for (volatile int for_ever = FLAW == HANGS; for_ever;) {
  }
  if (FLAW == BAD_POINTER) return (const gnomon_plugin*)(size_t)64;
  return FLAW == IS_NULL ? NULL : &plugin;
}
#endif
