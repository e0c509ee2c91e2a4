// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "exact/contact.h"
#include "exact/first_hit_fold.h"
#include "exact/frame.h"
#include "exact/hierarchy_walk.h"
#include "exact/path.h"
#include "exact/shadow_fold.h"

#ifdef GNOMON_EXACT_HAS_AVX2
// Without fused products: the answers' bounds count every rounding.
#ifdef __clang__
#pragma clang attribute push(__attribute__((target("avx2,bmi"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2,bmi")
#endif
#define GNOMON_EXACT_TARGET avx2
#include "exact/hierarchy_walk_inl.h"
#ifdef __clang__
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif
#endif
