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

#define GNOMON_EXACT_TARGET baseline
#include "exact/hierarchy_walk_inl.h"
