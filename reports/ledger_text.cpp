// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/ledger_text.h"

#include <fmt/format.h>

#include "reports/ledger.h"

namespace gnomon::reports {
namespace {

constexpr std::size_t kIndent = 30, kWidth = 116;

/// The text broken at blanks, every line but the first indented.
std::string wrapped(std::string_view text) {
  std::string out;
  std::size_t column = kIndent;
  while (!text.empty()) {
    const std::size_t blank = std::min(text.find(' '), text.size());
    if (column > kIndent && column + 1 + blank > kWidth) {
      out += "\n" + std::string(kIndent, ' ');
      column = kIndent;
    } else if (column > kIndent) {
      out += ' ', ++column;
    }
    out += text.substr(0, blank);
    column += blank;
    text.remove_prefix(std::min(blank + 1, text.size()));
  }
  return out;
}

}  // namespace

std::string ledger_text(std::span<const Claim> claims) {
  std::string out = fmt::format("{:<5} {:<11} {:<11} {}\n", "id", "exact", "float32", "claim");
  const std::string indent(kIndent, ' ');
  for (const Claim& claim : claims) {
    out += fmt::format("{:<5} {:<11} {:<11} {}\n", claim.id, name_of(claim.status), name_of(claim.status_f32),
                       wrapped(claim.text));
    if (!claim.note.empty()) out += indent + wrapped("note: " + claim.note) + "\n";
    for (const ClaimPointer& pointer : claim.pointers) {
      out += fmt::format("{}{}\n{}  {}\n", indent,
                         wrapped(fmt::format("{}: {}", kind_of(pointer), words_of(pointer))), indent,
                         command_of(pointer));
    }
  }
  return out + fmt::format("{} {}; exact: {}; float32: {}\n", claims.size(),
                           claims.size() == 1 ? "entry" : "entries",
                           counts_text(count_statuses(claims, &Claim::status)),
                           counts_text(count_statuses(claims, &Claim::status_f32)));
}

}  // namespace gnomon::reports
