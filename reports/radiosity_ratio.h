// SPDX-License-Identifier: GPL-3.0-or-later
// Methods on workloads of radiosity against Embree's best way to ask ray by ray.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace gnomon::reports {

/// What was measured of one method on one workload.
struct RadiosityTime {
  std::string place;  ///< scene, variant and workload
  std::string method;
  double ns = 0;  ///< a ray, list building included
};

struct RadiosityRatio {
  std::string method;
  std::size_t places = 0;
  double mean = 0;             ///< geometric, over the places, of its time over Embree's
  double least = 0, most = 0;  ///< over the places
};

/// Over all places where one of Embree's rows that ask one ray at a time was measured; the quickest of these
/// stands for Embree at each place. In the order in which methods first come; empty without Embree.
[[nodiscard]] std::vector<RadiosityRatio> ratios_to_embree(std::span<const RadiosityTime> times);

}  // namespace gnomon::reports
