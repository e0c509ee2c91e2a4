// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/list_json.h"

#include <array>
#include <set>
#include <string>

#include "reports/json_node.h"

namespace gnomon::reports {
namespace {

using Ordered = nlohmann::ordered_json;

struct Field {
  const char* name;
  std::uint64_t ListRate::*count;
};
constexpr Field kFields[] = {
    {"pairs", &ListRate::pairs},
    {"rays", &ListRate::rays},
    {"shadowed", &ListRate::shadowed},
    {"cache_tests", &ListRate::cache_tests},
    {"cache_hits", &ListRate::cache_hits},
    {"uncached", &ListRate::uncached},
    {"boxes", &ListRate::boxes},
    {"objects", &ListRate::objects},
    {"shafts", &ListRate::shafts},
    {"cull_tests", &ListRate::cull_tests},
    {"items", &ListRate::items},
    {"comparisons", &ListRate::comparisons},
    {"planes", &ListRate::planes},
    {"volumes", &ListRate::volumes},
    {"below_volumes", &ListRate::below_volumes},
    {"false_lit", &ListRate::false_lit},
    {"false_shadowed", &ListRate::false_shadowed},
    {"checked", &ListRate::checked},
    {"lacking", &ListRate::lacking},
    {"checked_faces", &ListRate::checked_faces},
    {"excess_faces", &ListRate::excess_faces},
};
constexpr const char* kRates[] = {"low", "high"};

Ordered spread_json(const std::optional<fuzz::Spread>& ns) {
  if (!ns) return nullptr;
  return {{"median", ns->median}, {"low25", ns->low25}, {"high75", ns->high75}};
}

std::optional<fuzz::Spread> read_spread(const Node& node, const char* key) {
  if (!node.has(key)) return std::nullopt;
  const Node ns = node.at(key);
  const fuzz::Spread s{ns.at("median").number(), ns.at("low25").number(), ns.at("high75").number()};
  if (!(0 <= s.low25 && s.low25 <= s.median && s.median <= s.high75)) {
    ns.fail("0 <= low25 <= median <= high75");
  }
  return s;
}

Ordered head(const ListFigures& row) {
  return {{"scene", row.scene}, {"table", row.table}, {"row", row.name}};
}

ListRate read_rate(const Node& node) {
  ListRate rate;
  for (const Field& field : kFields) rate.*field.count = node.at(field.name).count();
  for (const std::uint64_t some :
       {rate.shadowed, rate.uncached, rate.cache_hits, rate.false_lit, rate.false_shadowed, rate.wrong()}) {
    if (some > rate.rays) node.fail("at most as many shadowed, uncached, cache_hits and wrong as rays");
  }
  if (rate.lacking > rate.checked || rate.excess_faces > rate.checked_faces) {
    node.fail("at most as many lacking and excess_faces as checked and checked_faces");
  }
  return rate;
}

}  // namespace

Ordered lists_json(std::span<const ListFigures> rows) {
  Ordered lists = Ordered::array();
  for (const ListFigures& row : rows) {
    Ordered json = head(row);
    json["options"] = row.setup;
    for (std::size_t k = 0; k < row.rates.size(); ++k) {
      const ListRate& rate = row.rates[k];
      Ordered counts = {{"samples", k == 0 ? 1 : 4}};
      for (const Field& field : kFields) counts[field.name] = rate.*field.count;
      counts["tests_per_ray"] = rate.tests();
      json[kRates[k]] = counts;
    }
    lists.push_back(json);
  }
  return lists;
}

Ordered list_times_json(std::span<const ListFigures> rows) {
  Ordered times = Ordered::array();
  for (const ListFigures& row : rows) {
    Ordered json = head(row);
    for (std::size_t k = 0; k < row.rates.size(); ++k) {
      json[kRates[k]] = {{"ns_per_ray", spread_json(row.rates[k].ray)},
                         {"ns_per_list", spread_json(row.rates[k].list)}};
    }
    times.push_back(json);
  }
  return times;
}

std::vector<ListFigures> read_lists(const Node& top) {
  std::vector<ListFigures> rows;
  std::set<std::array<std::string, 3>> seen;
  if (!top.has("lists")) return rows;
  for (const Node& node : top.at("lists").list()) {
    ListFigures row{node.at("scene").text(),
                    node.at("table").text(),
                    node.at("row").text(),
                    node.at("options").text(),
                    {}};
    if (!seen.insert({row.scene, row.table, row.name}).second) node.fail("each row once");
    row.rates.push_back(read_rate(node.at("low")));
    if (node.has("high")) row.rates.push_back(read_rate(node.at("high")));
    rows.push_back(std::move(row));
  }
  if (!top.has("measured") || !top.at("measured").has("lists")) return rows;
  for (const Node& time : top.at("measured").at("lists").list()) {
    const std::string scene = time.at("scene").text(), table = time.at("table").text();
    const std::string name = time.at("row").text();
    for (ListFigures& row : rows) {
      if (row.scene != scene || row.table != table || row.name != name) continue;
      for (std::size_t k = 0; k < row.rates.size(); ++k) {
        const Node rate = time.at(kRates[k]);
        row.rates[k].ray = read_spread(rate, "ns_per_ray");
        row.rates[k].list = read_spread(rate, "ns_per_list");
      }
    }
  }
  return rows;
}

}  // namespace gnomon::reports
