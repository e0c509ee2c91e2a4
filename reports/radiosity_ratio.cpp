// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/radiosity_ratio.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace gnomon::reports {

std::vector<RadiosityRatio> ratios_to_embree(std::span<const RadiosityTime> times) {
  std::map<std::string, double> embree;
  for (const RadiosityTime& time : times) {
    if (!time.method.starts_with("embree") || time.method.starts_with("embree-packet") || !(time.ns > 0)) {
      continue;
    }
    const auto [place, first] = embree.emplace(time.place, time.ns);
    if (!first) place->second = std::min(place->second, time.ns);
  }
  std::vector<RadiosityRatio> ratios;
  for (const RadiosityTime& time : times) {
    const auto best = embree.find(time.place);
    if (best == embree.end() || !(time.ns > 0)) continue;
    const double ratio = time.ns / best->second;
    auto row = std::find_if(ratios.begin(), ratios.end(),
                            [&](const RadiosityRatio& known) { return known.method == time.method; });
    if (row == ratios.end()) row = ratios.insert(row, {time.method, 0, 0, ratio, ratio});
    ++row->places;
    row->mean += std::log(ratio);
    row->least = std::min(row->least, ratio);
    row->most = std::max(row->most, ratio);
  }
  for (RadiosityRatio& row : ratios) row.mean = std::exp(row.mean / static_cast<double>(row.places));
  return ratios;
}

}  // namespace gnomon::reports
