// SPDX-License-Identifier: GPL-3.0-or-later
// The speed of the common ray caster's tiers on shadow queries, next to Embree where it is installed.
#pragma once

#include <cstddef>

namespace gnomon::bench {

struct ShadowTierOptions {
  int rounds = 15;
  std::size_t most = 1000000;  ///< no scene has many more faces
  int side = 256;              ///< of the image whose points ask
};

/// Prints, for generated scenes of about 10 k, 100 k and 1 M faces, ns a query of every tier in the order of
/// an image's points and shuffled, and ratios to naive with 95 % intervals.
void print_shadow_tiers(const ShadowTierOptions& options);

}  // namespace gnomon::bench
