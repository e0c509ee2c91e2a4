// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/html_report.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>

#include "reports/html_text.h"
#include "reports/summary.h"
#include "scene/input_error.h"
#include "tests/report_xml_check.h"

namespace gnomon::reports {
namespace {

namespace fs = std::filesystem;

std::string read(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

std::string row(const std::string& method, const std::string& tier, const std::string& promise,
                const std::string& distribution, int culls) {
  const std::string c = std::to_string(culls), kept = std::to_string(300 - culls);
  return R"({"question":"shaft-box","method":")" + method + R"(","promise":")" + promise + R"(","tier":")" +
         tier + R"(","distribution":")" + distribution +
         R"(","scalar":"f32","trials":1000,"touching":{"outside":12,"inside":3},
  "matrix":{"outside":{"outside":600,"overlap":0,"inside":0},"overlap":{"outside":)" +
         c + R"(,"overlap":)" + kept + R"(,"inside":0},"inside":{"outside":0,"overlap":0,"inside":100}},
  "waste":0,"unsound":)" +
         c + R"(,"false_culls":)" + c + R"(,"false_insides":0,"unsound_touching":0,"undecided":0,"rejected":0,
  "rounding":)" +
         c + R"(,"model":0,"rounding_and_model":0,"waste_rate":{"value":0,"low95":0,"high95":0.0061},
  "unsound_rate":{"value":)" +
         std::to_string(culls / 400.0) +
         R"(,"low95":0,"high95":0.05},"false_inside_rate":{"value":0,"low95":0,"high95":0.0041},
  "worst_gap":null,"promise_broken":false,"threshold_exceeded":0,"witnesses":[],"later_addition":[1,2]})";
}

std::string result(const std::string& command = "gnomon fuzz shaft-box") {
  return R"({"schema":1,"kind":"fuzz","tool":"gnomon 0.1.0","command":")" + command +
         R"(","seed":1,"rows":[)" + row("naive-f32", "naive", "none", "uniform", 0) + "," +
         row("naive-f32", "naive", "none", "near-touch", 7) + "," +
         row("certified-f32", "certified", "never unsound", "uniform", 0) + "," +
         row("certified-f32", "certified", "never unsound", "near-touch", 0) +
         R"(],"witnesses":[{"name":"w1.txt","question":"shaft-box","method":"naive-f32","distribution":"near-touch",
  "scalar":"f32","verdict":"false cull","answer":"outside","reference":"overlap",
  "case":"shaft-box 0 0 0 1 1 1 4 4 0 5 5 1 1.5 3 0 2 3.5 1 -> overlap","gap":{"rational":"-1/3","approx":-0.333,"ulps":0.5},
  "index":123}],
  "measured":{"environment":{"compiler":"g++ 12","cpu":"a cpu"},"ns_per_case":[
   {"question":"shaft-box","method":"naive-f32","distribution":"uniform","scalar":"f32","ns":12.5,"reference_ns":310.0},
   {"question":"shaft-box","method":"certified-f32","distribution":"uniform","scalar":"f32","ns":13.5,"reference_ns":310.0}]}})";
}

class ReportHtml : public testing::Test {
 protected:
  ReportHtml()
      : dir_(fs::temp_directory_path() / ("gnomon-report-" + std::to_string(::getpid()) + "-" +
                                          testing::UnitTest::GetInstance()->current_test_info()->name())) {
    fs::create_directories(dir_ / "in");
  }
  ~ReportHtml() override { fs::remove_all(dir_); }
  ReportHtml(const ReportHtml&) = delete;
  ReportHtml& operator=(const ReportHtml&) = delete;

  void put(const std::string& name, const std::string& text) const {
    std::ofstream(dir_ / "in" / name, std::ios::binary) << text;
  }
  [[nodiscard]] fs::path out() const { return dir_ / "report.html"; }
  [[nodiscard]] std::string page() const {
    write_html_report(dir_ / "in", out());
    return read(out());
  }
  /// The message with which the folder is refused; then nothing may have been written.
  [[nodiscard]] std::string refusal() const {
    try {
      write_html_report(dir_ / "in", out());
    } catch (const scene::InputError& error) {
      for (const auto& entry : fs::directory_iterator(dir_)) EXPECT_EQ(entry.path().filename(), "in");
      return error.what();
    }
    ADD_FAILURE() << "not refused";
    return "";
  }
  [[nodiscard]] std::string refusal_of(const std::string& text) const {
    put("bad.json", text);
    const std::string message = refusal();
    EXPECT_NE(message.find("bad.json"), std::string::npos) << message;
    EXPECT_NE(message.find("expected"), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    return message;
  }

  fs::path dir_;
};

void expect_holds(const std::string& page, const std::string& text) {
  EXPECT_NE(page.find(text), std::string::npos) << text;
}

TEST_F(ReportHtml, ShowsEveryRowWithItsCountsAndBounds) {
  put("a.json", result());
  put("notes.txt", "not a result");
  fs::create_directories(dir_ / "in" / "deeper.json");
  const std::string html = page();
  for (const char* method : {"naive-f32", "certified-f32"}) {
    for (const char* distribution : {"uniform", "near-touch"}) {
      expect_holds(html,
                   std::string("data-method=\"") + method + "\" data-distribution=\"" + distribution + "\"");
    }
  }
  expect_holds(html, "7 of 400");                     // the row
  expect_holds(html, "7 of 800");                     // both distributions
  expect_holds(html, "0 of 800 (&lt; 0.46\u00a0%)");  // 1 - 0.025^(1/800)
  expect_holds(html, "gnomon replay witnesses/w1.txt");
  expect_holds(html, "gnomon explain witnesses/w1.txt");
  expect_holds(html, "<svg xmlns=");          // the witness's picture
  expect_holds(html, "<svg class=\"plot\"");  // the still plot
  expect_holds(html, "Every promise held");
  expect_holds(html, "-1/3");
  expect_holds(html, "g++ 12");
}

TEST_F(ReportHtml, IsWellFormedWithAndWithoutFindings) {
  put("a.json", result());
  const auto fault = [](const std::string& html) {
    return tests::xml_fault(html, {"meta", "link", "input", "br"});
  };
  EXPECT_EQ(fault(page()), "");
  put("a.json",
      R"({"schema":1,"kind":"walk","command":"gnomon walk","rows":[{"scene":"hall","queries":3,"x":[1]}]})");
  const std::string other = page();
  EXPECT_EQ(fault(other), "");
  expect_holds(other, "hall");
  put("a.json", R"({"schema":1,"kind":"fuzz","command":"gnomon fuzz","rows":[]})");
  EXPECT_EQ(fault(page()), "");
}

TEST_F(ReportHtml, GivesTheSameBytesForTheSameInput) {
  put("a.json", result());
  const std::string first = page();
  EXPECT_EQ(page(), first);
  for (const auto& entry : fs::directory_iterator(dir_)) {
    EXPECT_TRUE(entry.path().filename() == "in" || entry.path() == out()) << entry.path();
  }
}

TEST_F(ReportHtml, LoadsNothing) {
  put("a.json", result());
  const std::string html = page();
  for (const char* loader : {"src=", "url(", "@import", "sourceMappingURL", "<iframe", "<img", "<base"}) {
    const std::string before_scripts = html.substr(0, html.find("/* Vega,"));
    EXPECT_EQ(before_scripts.find(loader), std::string::npos) << loader;
  }
  EXPECT_EQ(html.find("sourceMappingURL"), std::string::npos);
  for (std::size_t at = html.find("href=\""); at != std::string::npos; at = html.find("href=\"", at + 1)) {
    EXPECT_EQ(html.compare(at, 12, "href=\"data:,"), 0) << html.substr(at, 40);
  }
}

TEST_F(ReportHtml, EscapesHostileText) {
  const std::string hostile = R"(</script><script>alert('1')</script><b onclick=\"x\">&)";
  std::string text = result(hostile);
  text = replaced(text, "w1.txt", hostile + "'; rm -rf ~ #");
  text = replaced(text, "near-touch", hostile);
  text = replaced(text, "g++ 12", hostile);
  put("a.json", text);
  const std::string html = page();
  EXPECT_EQ(html.find("<script>alert"), std::string::npos);
  EXPECT_EQ(html.find("<b onclick"), std::string::npos);
  EXPECT_EQ(tests::xml_fault(html, {"meta", "link", "input", "br"}), "");
  expect_holds(html, "&lt;/script&gt;&lt;script&gt;alert(&#39;1&#39;)");
  expect_holds(html, "\\u003c/script>");  // in the plot's data
}

TEST_F(ReportHtml, RefusesEmptyAndMissingFolders) {
  EXPECT_NE(refusal().find("expected at least one *.json"), std::string::npos);
  EXPECT_THROW(write_html_report(dir_ / "nowhere", out()), scene::InputError);
}

TEST_F(ReportHtml, RefusesWhatIsNoResultFile) {
  const std::string good = result();
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, good.size() / 2, good.size() - 1}) {
    (void)refusal_of(good.substr(0, size));
  }
  (void)refusal_of("[]");
  (void)refusal_of("\"text\"");
  (void)refusal_of(good + "x");
  expect_holds(refusal_of(replaced(good, "\"schema\":1", "\"schema\":2")), "schema 1");
  expect_holds(refusal_of("{\n\n]"), "bad.json:3:");
}

TEST_F(ReportHtml, RefusesMissingFieldsByName) {
  const std::string good = result();
  for (const char* field :
       {"schema",     "kind",         "command",  "rows",   "question", "method",  "promise",  "distribution",
        "scalar",     "trials",       "touching", "matrix", "waste",    "unsound", "rounding", "model",
        "waste_rate", "unsound_rate", "value",    "low95",  "high95",   "verdict", "case",     "rational",
        "ns"}) {
    const std::string name = std::string("\"") + field + "\":";
    expect_holds(refusal_of(replaced(good, name, "\"no_" + std::string(field) + "\":")),
                 "\"" + std::string(field) + "\"");
  }
}

TEST_F(ReportHtml, RefusesWrongTypesByPlace) {
  const std::string good = result();
  const std::pair<const char*, const char*> changes[] = {
      {"\"trials\":1000", "\"trials\":\"many\""},
      {"\"trials\":1000", "\"trials\":-5"},
      {"\"trials\":1000", "\"trials\":10.5"},
      {"\"trials\":1000", "\"trials\":999"},
      {"\"trials\":1000", "\"trials\":null"},
      {"\"value\":0,", "\"value\":\"0\","},
      {"\"value\":0,", "\"value\":1e999,"},
      {"\"value\":0,", "\"value\":0.5,"},
      {"\"promise_broken\":false", "\"promise_broken\":0"},
      {"\"ns\":12.5", "\"ns\":-1"},
      {"\"seed\":1", "\"seed\":\"one\""},
      {"\"case\":\"", "\"case\":1,\"z\":\""},
      {"\"method\":\"", "\"method\":[],\"z\":\""},
  };
  for (const auto& [from, to] : changes) (void)refusal_of(replaced(good, from, to));
  expect_holds(refusal_of(replaced(good, "\"waste\":0", "\"waste\":{}")), "rows[0].waste");
}

TEST_F(ReportHtml, RefusesTheSameRunTwice) {
  put("a.json", result());
  (void)refusal_of(result());
  // The same seed asks the same cases: counted once. Another seed, or another shard of it, adds up.
  put("bad.json", result("gnomon fuzz shaft-box --jobs 2"));
  expect_holds(page(), "7 of 800");
  put("bad.json", replaced(result(), "\"seed\":1", "\"seed\":2"));
  expect_holds(page(), "14 of 1,600");
  put("a.json", replaced(result(), "\"seed\":1", "\"seed\":1,\"shard\":\"1/2\""));
  put("bad.json", replaced(result(), "\"seed\":1", "\"seed\":1,\"shard\":\"2/2\""));
  expect_holds(page(), "14 of 1,600");
}

TEST_F(ReportHtml, LeavesAnOldReportAloneWhenItFails) {
  put("a.json", result());
  const std::string old = page();
  put("b.json", "{");
  EXPECT_THROW(write_html_report(dir_ / "in", out()), scene::InputError);
  EXPECT_EQ(read(out()), old);
  fs::remove(dir_ / "in" / "b.json");
  fs::create_directories(dir_ / "taken" / "by a folder");
  EXPECT_THROW(write_html_report(dir_ / "in", dir_ / "taken"), std::runtime_error);
}

TEST_F(ReportHtml, TakesGapsBeyondDoubles) {
  put("a.json",
      replaced(replaced(result(), "\"approx\":-0.333,\"ulps\":0.5", "\"approx\":null,\"ulps\":null"),
               "\"worst_gap\":null", R"("worst_gap":{"rational":"1/7","approx":null,"ulps":null})"));
  expect_holds(page(), "beyond any double; exactly <code>-1/3</code>");
}

TEST_F(ReportHtml, SaysAloudWhenAPromiseIsBroken) {
  put("a.json", replaced(result(), "\"promise_broken\":false", "\"promise_broken\":true"));
  const std::string html = page();
  expect_holds(html, "A promise was broken");
  EXPECT_EQ(html.find("Every promise held"), std::string::npos);
}

TEST(ReportText, WritesNumbersForPeople) {
  EXPECT_EQ(thousands(0), "0");
  EXPECT_EQ(thousands(999), "999");
  EXPECT_EQ(thousands(1234567), "1,234,567");
  EXPECT_EQ(rate_text(0), "0");
  EXPECT_EQ(rate_text(0.1234), "12.3\u00a0%");
  EXPECT_EQ(rate_text(4.5e-5), "4.5e-5");
  EXPECT_EQ(rate_text(1e-12), "1.0e-12");
  EXPECT_EQ(rate_text(0.99999), "99.999\u00a0%");
  EXPECT_EQ(time_text(std::nullopt), "–");
  EXPECT_EQ(time_text(1240), "1.24\u00a0µs");
  EXPECT_EQ(shell_word("plain-name.txt"), "plain-name.txt");
  EXPECT_EQ(shell_word("it's"), "'it'\\''s'");
  EXPECT_EQ(shell_word("-rf"), "'./-rf'");
  EXPECT_EQ(escaped("a<b>&\"'\x01\xFF ü"), "a&lt;b&gt;&amp;&quot;&#39;\xEF\xBF\xBD\xEF\xBF\xBD ü");
}

TEST(ReportShare, HasClopperPearsonBounds) {
  // Clopper and Pearson's own form for k = 0, and published values for 5 of 50.
  EXPECT_NEAR(share_of(0, 1000).rate.high95, 0.0036821, 1e-7);
  EXPECT_NEAR(share_of(5, 50).rate.low95, 0.0332755, 1e-6);
  EXPECT_NEAR(share_of(5, 50).rate.high95, 0.2181354, 1e-6);
  EXPECT_EQ(share_of(7, 7).rate.high95, 1);
  EXPECT_EQ(share_of(0, 0).rate.high95, 1);
  EXPECT_THROW((void)share_of(2, 1), std::domain_error);
  // Tiny rates of many trials, where careless code loses the bound.
  EXPECT_NEAR(share_of(0, 1'000'000'000'000).rate.high95, 3.6889e-12, 1e-15);
}

}  // namespace
}  // namespace gnomon::reports
