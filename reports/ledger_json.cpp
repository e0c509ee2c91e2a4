// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "reports/json_node.h"
#include "reports/ledger_text.h"

namespace gnomon::reports {
namespace {

struct Fields {
  Json& out;
  void operator()(const TheoremPointer& p) const { out["file"] = p.file, out["name"] = p.name; }
  void operator()(const TestPointer& p) const { out["name"] = p.name; }
  void operator()(const WitnessPointer& p) const {
    out["file"] = p.file;
    if (p.line) out["line"] = *p.line;
    out["method"] = p.method;
    out["answer"] = p.answer;
    out["exactly"] = p.exactly;
  }
  void operator()(const CampaignPointer& p) const {
    out["counts"] = p.counts;
    out["errors"] = p.errors;
    out["trials"] = p.trials;
    out["high95"] = p.high95;
    out["subset"] = p.subset;
  }
  void operator()(const MeasurementPointer& p) const { out["figures"] = p.figures; }
};

}  // namespace

std::string ledger_json(std::span<const Claim> claims) {
  Json all = Json::array();
  for (const Claim& claim : claims) {
    Json entry{{"id", claim.id},
               {"paper", claim.paper},
               {"text", claim.text},
               {"status", name_of(claim.status)},
               {"status_f32", name_of(claim.status_f32)}};
    if (!claim.note.empty()) entry["note"] = claim.note;
    entry["pointer"] = Json::array();
    for (const ClaimPointer& pointer : claim.pointers) {
      Json fields{{"kind", kind_of(pointer)}};
      std::visit(Fields{fields}, pointer);
      fields["command"] = command_of(pointer);
      entry["pointer"].push_back(std::move(fields));
    }
    all.push_back(std::move(entry));
  }
  return all.dump(2) + "\n";
}

}  // namespace gnomon::reports
