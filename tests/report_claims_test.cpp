// SPDX-License-Identifier: GPL-3.0-or-later
// The ledger as a section of the HTML report.
#include <gtest/gtest.h>

#include "reports/html_sections.h"
#include "reports/ledger.h"
#include "tests/report_xml_check.h"

namespace gnomon::tests {
namespace {

using reports::Claim;
using reports::ClaimStatus;

std::string section_of(std::span<const Claim> claims) {
  std::string html = reports::claims_section(claims);
  EXPECT_EQ(xml_fault(html, {"meta", "link", "input", "br"}), "");
  return html;
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(ReportClaims, ShowsEveryClaimWithBothStatuses) {
  const std::string html = section_of(reports::ledger());
  for (const Claim& claim : reports::ledger()) {
    const std::size_t row = html.find("<tr id=\"claim-" + claim.id + "\">");
    ASSERT_NE(row, std::string::npos) << claim.id;
    const std::string text = html.substr(row, html.find("</tr>", row) - row);
    const std::size_t exactly = text.find(">" + std::string(name_of(claim.status)) + "</span>");
    ASSERT_NE(exactly, std::string::npos) << claim.id;
    EXPECT_NE(text.find(">" + std::string(name_of(claim.status_f32)) + "</span>", exactly + 1),
              std::string::npos)
        << claim.id;
  }
  for (const reports::Paper& paper : reports::papers()) EXPECT_TRUE(has(html, std::string(paper.title)));
  EXPECT_TRUE(has(html, "gnomon replay proofs/witnesses/S2b-box-within-a.txt --method printed-f32"));
  EXPECT_TRUE(has(html, "word good\"") && has(html, "word bad\"") && has(html, "word warn\"") &&
              has(html, "word idle\""));
}

TEST(ReportClaims, CountsAndEscapesWhatItIsGiven) {
  Claim claim{"S1", "shaft-culling", "<script>&", ClaimStatus::proved, ClaimStatus::refuted, "\"<b>", {}};
  claim.pointers.push_back(reports::MeasurementPointer{"rm '<i>'", "<u>"});
  const std::string html = section_of(std::vector{claim, claim, claim});
  EXPECT_TRUE(has(html, "exactly</th><td class=\"num\">3</td><td class=\"num quiet\">0</td>"));
  EXPECT_TRUE(has(html,
                  "in float32</th><td class=\"num quiet\">0</td><td class=\"num quiet\">0</td><td "
                  "class=\"num\">3</td>"));
  for (const char* raw : {"<script>", "<b>", "<i>", "<u>"}) EXPECT_FALSE(has(html, raw)) << raw;
  EXPECT_TRUE(has(html, "&lt;script&gt;&amp;"));
  EXPECT_TRUE(has(html, "1 pointer to follow"));
  EXPECT_EQ(reports::claims_section({}), "");
}

}  // namespace
}  // namespace gnomon::tests
