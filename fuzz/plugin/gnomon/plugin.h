/* SPDX-License-Identifier: MIT */
/* gnomon/plugin.h: your own culling code under test by gnomon. C99 or C++, no other header.
 *
 * A plug-in is a shared library with one function, gnomon_plugin_entry(), that returns a table of methods.
 * `gnomon fuzz QUESTION --plugin ./libmine.so` treats each method as a row of its own, named PLUGIN:METHOD:
 * answers are counted against the exact ones, disagreements are shrunk and saved, promises are enforced.
 *
 * The plug-in runs in processes of its own, any number of them, one thread each; several may run at once. An
 * answer must be a function of the case alone: the same case is asked alone and in batches, and two different
 * answers are an error. */
#ifndef GNOMON_PLUGIN_H
#define GNOMON_PLUGIN_H

/* Grows when a plug-in has to be compiled again. Fields are only added at the ends of the structs, whose
 * sizes the plug-in states, so that older plug-ins go on working. */
#define GNOMON_PLUGIN_ABI 1u

/* Questions, and the numbers of a case. S is the convex hull of two boxes A and B. All numbers are finite,
 * lo <= hi, r >= 0; boxes may be flat or points. All sets are closed: touching counts as meeting. */
enum gnomon_question {
  GNOMON_SHAFT_BOX = 1,   /* box T against S, 18 numbers: A.lo A.hi B.lo B.hi T.lo T.hi (x y z each) */
  GNOMON_SHAFT_SPHERE = 2 /* ball (c, r) against S, 16 numbers: A.lo A.hi B.lo B.hi c r */
  /* 3 is kept for the question `shadow`, which is not there yet. */
};

/* Answers, one byte a case. */
enum gnomon_answer {
  GNOMON_OUTSIDE = 0,   /* T and S have no point in common: T can be culled */
  GNOMON_OVERLAP = 1,   /* neither; also what a method says that must not lie and can't tell */
  GNOMON_INSIDE = 2,    /* T is a subset of S */
  GNOMON_UNDECIDED = 3, /* the method can't tell and says so */
  GNOMON_REJECTED = 4   /* the case is outside of the method's domain */
};

/* What a method never does. A campaign that sees a promise broken fails (exit status 1). */
enum gnomon_promise {
  GNOMON_PROMISES_NOTHING = 0,
  GNOMON_NEVER_UNSOUND = 1, /* never "outside" or "inside" where that is not exactly so */
  GNOMON_ALWAYS_AGREES = 2  /* never anything but the exact answer */
};

/* Answers `count` cases: `cases` holds count times 18 (or 16) numbers, one case after the other, aligned as
 * its scalar is; answers[i] is for case i. The cases can't be written to. `user` is the method's. Must leave
 * the floating-point modes (rounding, denormals) as it found them, and must not throw. */
typedef void gnomon_run_f32(unsigned long long count, const float* cases, unsigned char* answers, void* user);
typedef void gnomon_run_f64(unsigned long long count, const double* cases, unsigned char* answers,
                            void* user);

/* Strings are UTF-8 and end in a zero. Names have 1 to 31 of the characters a-z 0-9 - _. */
typedef struct gnomon_method {
  unsigned question;       /* enum gnomon_question */
  unsigned promise;        /* enum gnomon_promise */
  const char* name;        /* one of a kind within its question */
  const char* summary;     /* one line of at most 127 bytes, or null */
  gnomon_run_f32* run_f32; /* the method for cases that are floats; null: has no such form */
  gnomon_run_f64* run_f64; /* the method for doubles; null: has no such form. One of the two at least. */
  void* user;              /* handed to every call; may be null */
} gnomon_method;

/* The table and all that it points to must live until the process ends. */
typedef struct gnomon_plugin {
  unsigned abi;          /* GNOMON_PLUGIN_ABI */
  unsigned size;         /* sizeof(gnomon_plugin) */
  unsigned method_size;  /* sizeof(gnomon_method) */
  unsigned method_count; /* 1 to 64 */
  const char* name;
  const gnomon_method* methods;
} gnomon_plugin;

#if defined(__GNUC__)
#define GNOMON_PLUGIN_EXPORT __attribute__((visibility("default")))
#else
#define GNOMON_PLUGIN_EXPORT
#endif

/* Called once in each process, before any other call. Null means that the plug-in can't run here. */
#ifdef __cplusplus
extern "C" {
#endif
GNOMON_PLUGIN_EXPORT const gnomon_plugin* gnomon_plugin_entry(void);
#ifdef __cplusplus
}
#endif

#endif /* GNOMON_PLUGIN_H */
