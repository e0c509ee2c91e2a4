// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/ledger.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <set>

#include "reports/assets.h"
#include "reports/json_node.h"
#include "scene/input_error.h"

namespace gnomon::reports {
namespace {

constexpr std::array<Paper, 4> kPapers{{
    {"shaft-culling", "Haines, Wallace: Shaft Culling for Efficient Ray-Cast Radiosity (1991)", 'S', 25},
    {"light-buffer", "Haines, Greenberg: The Light Buffer: A Shadow-Testing Accelerator (1986)", 'L', 18},
    {"id-images", "Alonso, Holzschuch: Using Graphics Hardware to Speed-up Visibility Queries (2000)", 'I',
     10},
    {"voxel-occlusion",
     "Woo, Amanatides: Voxel Occlusion Testing: A Shadow Determination Accelerator for Ray Tracing (1990)",
     'V', 14},
}};

/// Refuses fields that nobody reads: a misspelt one would be lost.
void only_fields(const Node& node, const std::set<std::string>& known) {
  for (const auto& [key, value] : node.fields()) {
    if (!known.contains(key)) value.fail(fmt::format("one of the fields {}", fmt::join(known, ", ")));
  }
}

ClaimPointer read_pointer(const Node& node) {
  const std::string kind = node.at("kind").text();
  if (kind == "theorem") {
    only_fields(node, {"kind", "file", "name"});
    return TheoremPointer{node.at("file").text(), node.at("name").text()};
  }
  if (kind == "test") {
    only_fields(node, {"kind", "name"});
    const std::string name = node.at("name").text();
    if (name.find('.') == std::string::npos) node.at("name").fail("Suite.Name");
    return TestPointer{name};
  }
  if (kind == "witness") {
    only_fields(node, {"kind", "file", "line", "method", "answer", "exactly"});
    return WitnessPointer{node.at("file").text(),
                          node.has("line") ? std::optional(node.at("line").count()) : std::nullopt,
                          node.at("method").text(), node.at("answer").text(), node.at("exactly").text()};
  }
  if (kind == "campaign") {
    only_fields(node, {"kind", "command", "counts", "errors", "trials", "high95", "subset"});
    return CampaignPointer{node.at("command").text(), node.at("counts").text(),   node.at("errors").count(),
                           node.at("trials").count(), node.at("high95").number(), node.at("subset").count()};
  }
  if (kind == "measurement") {
    only_fields(node, {"kind", "command", "figures"});
    return MeasurementPointer{node.at("command").text(), node.at("figures").text()};
  }
  node.at("kind").fail("theorem, test, witness, campaign or measurement");
}

ClaimStatus read_status(const Node& node) {
  const std::optional<ClaimStatus> status = status_of(node.text());
  if (!status) node.fail("proved, confirmed, refuted, erratum, reproduced or open");
  return *status;
}

/// "S1" to "S25", with one small letter behind for a part.
bool is_id_of(std::string_view id, const Paper& paper) {
  if (id.size() < 2 || id[0] != paper.letter || id[1] == '0') return false;
  unsigned number = 0;
  const char* const end = id.data() + id.size();
  const auto [stop, error] = std::from_chars(id.data() + 1, end, number);
  const bool part = end - stop == 1 && *stop >= 'a' && *stop <= 'z';
  return error == std::errc{} && (stop == end || part) && number >= 1 && number <= paper.claims;
}

Claim read_claim(const Node& node) {
  only_fields(node, {"id", "paper", "text", "status", "status_f32", "note", "pointer"});
  Claim claim;
  claim.id = node.at("id").text();
  claim.paper = node.at("paper").text();
  const auto paper = std::ranges::find(kPapers, claim.paper, &Paper::id);
  if (paper == kPapers.end())
    node.at("paper").fail("shaft-culling, light-buffer, id-images or voxel-occlusion");
  if (!is_id_of(claim.id, *paper)) {
    node.at("id").fail(fmt::format("{0}1 to {0}{1}, or a part such as {0}2a", paper->letter, paper->claims));
  }
  claim.text = node.at("text").text();
  if (claim.text.empty()) node.at("text").fail("what is claimed");
  claim.status = read_status(node.at("status"));
  claim.status_f32 = read_status(node.at("status_f32"));
  if (node.has("note")) claim.note = node.at("note").text();
  for (const Node& pointer : node.at("pointer").list()) claim.pointers.push_back(read_pointer(pointer));
  if (claim.settled() && claim.pointers.empty()) node.at("pointer").fail("a pointer for what is not open");
  return claim;
}

}  // namespace

std::span<const Paper> papers() {
  return kPapers;
}

std::vector<Claim> read_ledger(std::string_view json, const std::string& name) {
  const Json parsed = Json::parse(json, nullptr, false);
  if (parsed.is_discarded()) throw scene::InputError(name, 0, "expected JSON");
  const Node top(parsed, name, "the top");
  std::vector<Claim> claims;
  std::set<std::string> seen;
  for (const Node& node : top.list()) {
    claims.push_back(read_claim(node));
    if (!seen.insert(claims.back().id).second) node.at("id").fail("each id once");
  }
  return claims;
}

const std::vector<Claim>& ledger() {
  static const std::vector<Claim> claims = read_ledger(asset("claims.json"), "proofs/claims.json");
  return claims;
}

StatusCounts count_statuses(std::span<const Claim> claims, ClaimStatus Claim::*which) {
  StatusCounts counts{};
  for (const Claim& claim : claims) ++counts[static_cast<std::size_t>(claim.*which)];
  return counts;
}

std::string counts_text(const StatusCounts& counts) {
  std::string out;
  for (const ClaimStatus status : claim_statuses()) {
    const std::size_t n = counts[static_cast<std::size_t>(status)];
    if (n > 0) out += fmt::format("{}{} {}", out.empty() ? "" : ", ", n, name_of(status));
  }
  return out.empty() ? "none" : out;
}

}  // namespace gnomon::reports
