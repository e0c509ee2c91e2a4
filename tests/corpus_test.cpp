// SPDX-License-Identifier: GPL-3.0-or-later
// The text corpus, its numbers, and files that are whole or not there.
#include "scene/corpus.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <bit>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include "fuzz/generator.h"
#include "fuzz/replay.h"
#include "scene/atomic_file.h"
#include "scene/float_text.h"
#include "scene/input_error.h"

namespace gnomon::scene {
namespace {

/// An empty folder of the test's own, removed at the end.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "gnomon-corpus.XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = name;
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::size_t entries() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(path_), {}));
  }

 private:
  std::filesystem::path path_;
};

std::string contents_of(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream out;
  out << in.rdbuf();
  return out.str();
}

std::vector<CorpusLine> read(const std::string& text) {
  std::istringstream in(text);
  return read_corpus(in, "c.txt");
}

/// The complaint about a corpus, also where the numbers are only looked at by the replay.
std::string complaint(const std::string& text) {
  try {
    (void)fuzz::replay(read(text), {"trivial"});
  } catch (const InputError& error) {
    return error.what();
  }
  return "no complaint";
}

std::uint64_t bits_of(double x) {
  return std::bit_cast<std::uint64_t>(x);
}

const std::string kBox = "shaft-box 0 0 0 1 1 1 2 2 2 3 3 3 0 0 0 1 1 1";
const std::string kBall = "shaft-sphere 0 0 0 1 1 1 2 2 2 3 3 3 0 0 0 1";

RC_GTEST_PROP(FloatText, EveryFiniteDoubleSurvivesBothForms, (std::uint64_t pattern)) {
  const double x = std::bit_cast<double>(pattern);
  RC_PRE(std::isfinite(x));
  for (const std::string& text : {hex_text(x), decimal_text(x)}) {
    const std::optional<double> back = parse_float_text(text);
    RC_ASSERT(back.has_value());
    RC_ASSERT(bits_of(*back) == pattern);
  }
}

// RapidCheck's patterns grow from small ones; here every exponent, with the significands that are the
// hardest.
TEST(FloatText, EveryExponentSurvivesBothForms) {
  constexpr std::uint64_t kOnes = (std::uint64_t{1} << 52) - 1;
  for (std::uint64_t exponent = 0; exponent < 2047; ++exponent) {
    for (const std::uint64_t significand :
         {std::uint64_t{0}, std::uint64_t{1}, kOnes, kOnes / 3, kOnes - 1}) {
      for (const std::uint64_t sign : {std::uint64_t{0}, std::uint64_t{1} << 63}) {
        const std::uint64_t pattern = sign | exponent << 52 | significand;
        const double x = std::bit_cast<double>(pattern);
        const std::optional<double> hex = parse_float_text(hex_text(x)),
                                    decimal = parse_float_text(decimal_text(x));
        ASSERT_TRUE(hex && decimal) << hex_text(x);
        ASSERT_EQ(bits_of(*hex), pattern) << hex_text(x);
        ASSERT_EQ(bits_of(*decimal), pattern) << decimal_text(x);
      }
    }
  }
}

TEST(FloatText, WritesTheShortestForms) {
  EXPECT_EQ(hex_text(3), "0x1.8p+1");
  EXPECT_EQ(hex_text(-0.5), "-0x1p-1");
  EXPECT_EQ(hex_text(0), "0x0p+0");
  EXPECT_EQ(hex_text(-0.0), "-0x0p+0");
  EXPECT_EQ(decimal_text(0.1), "0.1");
  EXPECT_EQ(decimal_text(-0.0), "-0");
}

TEST(FloatText, ReadsEveryForm) {
  const std::pair<const char*, double> forms[] = {{"0x1.8p+1", 3},
                                                  {"0X1P-3", 0.125},
                                                  {"0x1.8", 1.5},
                                                  {"0x10", 16},
                                                  {"+0x1p4", 16},
                                                  {"-0x1.8p1", -3},
                                                  {"0xAbC", 2748},
                                                  {"0x.8p0", 0.5},
                                                  {"1", 1},
                                                  {"+1", 1},
                                                  {"-1.5e3", -1500},
                                                  {".5", 0.5},
                                                  {"5.", 5},
                                                  {"1E2", 100},
                                                  {"0.1", 0.1},
                                                  {"1e-320", 1e-320},
                                                  {"0x0.8p-1073", 0x1p-1074},
                                                  {"4.9e-324", 0x1p-1074},
                                                  {"0x1p-1080", 0},
                                                  {"1e-400", 0},
                                                  {"007", 7},
                                                  {"0x001p0", 1},
                                                  {"9007199254740993", 9007199254740992},
                                                  {"0x1.00000000000008p0", 1}};  // ties go to even
  for (const auto& [text, value] : forms) {
    const std::optional<double> read = parse_float_text(text);
    ASSERT_TRUE(read) << text;
    EXPECT_EQ(bits_of(*read), bits_of(value)) << text;
  }
  EXPECT_TRUE(std::signbit(*parse_float_text("-0")));
  EXPECT_TRUE(std::signbit(*parse_float_text("-0x0p+0")));
  EXPECT_TRUE(std::signbit(*parse_float_text("-0x1p-2000")));
}

TEST(FloatText, BeyondTheLargestDoubleIsInfinity) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const char* text : {"1e309", "0x1p1024", "1e99999999999999999999", "0x1p+99999999999999999999"}) {
    EXPECT_EQ(parse_float_text(text), kInfinity) << text;
    EXPECT_EQ(parse_float_text("-" + std::string(text)), -kInfinity) << text;
  }
  EXPECT_EQ(parse_float_text("0x1.fffffffffffffp+1023"), std::numeric_limits<double>::max());
}

TEST(FloatText, RefusesWhatIsNoNumber) {
  for (const char* text :
       {"",        "-",         "+",     "0x",    "0xp1",    "-0x", "0x-1p0",  "0x+1",  "--1", "+-1",
        "-+1",     "++1",       "1p3",   "0x1p",  "0x1p+",   "0xg", "1x",      "1.2.3", "1e",  "1e+",
        "e5",      ".",         "1,5",   "1 ",    " 1",      "inf", "-inf",    "nan",   "NAN", "infinity",
        "-nan(1)", "0x1.8p+1z", "0xinf", "0xnan", "0x1p0.5", "1f",  "\xc2\xbd"}) {
    EXPECT_FALSE(parse_float_text(text)) << text;
  }
}

TEST(Corpus, KeepsWordsAnswersAndLineNumbers) {
  const std::vector<CorpusLine> lines =
      read("# a comment\n\n  shaft-box 1 0x1p+0 -> outside # why\r\n\t\nother word#comment\nlast 1 -> x");
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0].file, "c.txt");
  EXPECT_EQ(lines[0].line, 3u);
  EXPECT_EQ(lines[0].question, "shaft-box");
  EXPECT_EQ(lines[0].words, (std::vector<std::string>{"1", "0x1p+0"}));
  EXPECT_EQ(lines[0].answer, "outside");
  EXPECT_EQ(lines[1].line, 5u);
  EXPECT_EQ(lines[1].words, (std::vector<std::string>{"word"}));
  EXPECT_FALSE(lines[1].answer);
  EXPECT_EQ(lines[2].line, 6u);  // the last line needs no end
  EXPECT_EQ(lines[2].answer, "x");
}

TEST(Corpus, ComplaintsNameFileLineAndWhatWasExpected) {
  const std::pair<std::string, std::string> bad[] = {
      {"", "c.txt: expected at least one case, found none"},
      {"# only a comment\n\n", "c.txt: expected at least one case, found none"},
      {"\nshaft-box\n", "c.txt:2: expected a question and its numbers, found "},
      {"shaft-box -> outside", "c.txt:1: expected a question and its numbers, found "},
      {kBox + " ->", "c.txt:1: expected an answer after \"->\", found the end of the line"},
      {kBox + " -> # outside", "c.txt:1: expected an answer after \"->\", found the end of the line"},
      {kBox + " -> outside inside", "c.txt:1: expected one answer after \"->\", found "},
      {kBox + " -> -> inside", "c.txt:1: expected one \"->\", found a second one"},
      {"\n" + kBox + " 1", "c.txt:2: expected 18 numbers for shaft-box, found 19"},
      {"shaft-box 1 2 3", "c.txt:1: expected 18 numbers for shaft-box, found 3"},
      {kBall + " 1", "c.txt:1: expected 16 numbers for shaft-sphere, found 17"},
      {"shaft-box 0 0 0 1 1 1 2 2 2 3 3 3 0 0 0 1 1 nan", "c.txt:1: expected a number, found "},
      {"shaft-box 0 0 0 1 1 1 2 2 2 3 3 3 0 0 0 1 1 1e999",
       "c.txt:1: expected a number within the range of a double, found "},
      {"shaft-box 0 0 0 1 1 1 2 2 2 3 3 3 0 0 0 1 1 -1", "c.txt:1: expected a box T with finite lo <= hi"},
      {"shaft-box 0 2 0 1 1 1 2 2 2 3 3 3 0 0 0 1 1 1", "c.txt:1: expected a box A with finite lo <= hi"},
      {"shaft-sphere 0 0 0 1 1 1 2 2 4 3 3 3 0 0 0 1", "c.txt:1: expected a box B with finite lo <= hi"},
      {"shaft-sphere 0 0 0 1 1 1 2 2 2 3 3 3 0 0 0 -1",
       "c.txt:1: expected a ball with finite centre and radius >= 0"},
      {kBox + "\nwhat 1",
       "c.txt:2: expected a question (shaft-box, shaft-sphere, shaft-slabs, shaft-oriented-box, "
       "shaft-ellipsoid, shadow, shaft-candidates, patch-pair), found "},
      {kBox + " -> outsid", "c.txt:1: expected outside, overlap or inside after \"->\", found "},
  };
  for (const auto& [text, message] : bad) {
    const std::string said = complaint(text);
    EXPECT_EQ(said.substr(0, message.size()), message) << text;
    EXPECT_EQ(said.find('\n'), std::string::npos) << text;
  }
}

// Words of a broken file go to a terminal: nothing unprintable, nothing endless.
TEST(Corpus, ComplaintsArePrintable) {
  const std::string wild = "\x1b[31m\x01\xff" + std::string(5000, 'w');
  const std::string numbers = " 0 0 0 1 1 1 2 2 2 3 3 3 0 0 0 1 1 ";
  for (const std::string& text : {"shaft-box" + numbers + wild, wild + " 1", wild, kBox + " -> " + wild,
                                  kBox + " -> outside " + wild, "x" + wild + " 1 2", "shaft-box " + wild}) {
    const std::string said = complaint(text);
    EXPECT_LT(said.size(), 250u);
    for (const char c : said) ASSERT_TRUE(c >= 0x20 && c < 0x7f) << said;
  }
}

TEST(Corpus, GoodCasesAreAccepted) {
  EXPECT_EQ(complaint(kBox), "no complaint");
  EXPECT_EQ(complaint(kBall + " -> overlap\r\n# end"), "no complaint");
  EXPECT_EQ(complaint("shaft-sphere 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0"), "no complaint");
}

TEST(Corpus, FoldersAndMissingFilesAreSaid) {
  const TemporaryFolder folder;
  const auto said = [](const std::filesystem::path& path) -> std::string {
    try {
      (void)read_corpus(path);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no complaint";
  };
  EXPECT_EQ(said(folder.path()), folder.path().string() + ": expected a text corpus, found a folder");
  const std::string missing = (folder.path() / "none.txt").string();
  EXPECT_EQ(said(missing), missing + ": expected a text corpus, found no file that can be read");
}

TEST(Corpus, TextOfNumbersReadsBack) {
  const std::vector<double> numbers{1, -0.0, 0x1p-1074, -1.5, 0x1.fffffffffffffp+1023, 0.1};
  const std::string text = corpus_text("q", numbers, "inside");
  EXPECT_EQ(text,
            "q 0x1p+0 -0x0p+0 0x0.0000000000001p-1022 -0x1.8p+0 0x1.fffffffffffffp+1023 "
            "0x1.999999999999ap-4 -> inside");
  const std::vector<CorpusLine> lines = read(text);
  ASSERT_EQ(lines.size(), 1u);
  const std::vector<double> back = lines[0].numbers(numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) EXPECT_EQ(bits_of(back[i]), bits_of(numbers[i]));
  EXPECT_EQ(corpus_text("q", {}, ""), "q");
}

TEST(AtomicFile, WritesReplacesAndMakesFolders) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "a" / "b" / "file.txt";
  write_whole_file(file, "old and longer");
  EXPECT_EQ(contents_of(file), "old and longer");
  const std::string binary("new\0\n", 5);
  write_whole_file(file, binary);
  EXPECT_EQ(contents_of(file), binary);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(file.parent_path()), {}), 1);
  struct stat info {};
  ASSERT_EQ(::stat(file.c_str(), &info), 0);
  EXPECT_EQ(info.st_mode & 0777, 0644u);
}

TEST(AtomicFile, WritesLargeFilesWhole) {
  const TemporaryFolder folder;
  std::string large(3 << 20, 'x');
  large.back() = 'y';
  write_whole_file(folder.path() / "large", large);
  EXPECT_EQ(contents_of(folder.path() / "large"), large);
}

TEST(AtomicFile, FailsWithoutATrace) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "file") << "kept";
  std::filesystem::create_directory(folder.path() / "taken");
  std::ofstream(folder.path() / "taken" / "x") << "x";
  const std::size_t before = folder.entries();
  // A folder that is a file (root may write anywhere, so permissions tell nothing), and a name that is a
  // folder.
  for (const std::filesystem::path& path : {folder.path() / "file" / "x", folder.path() / "taken"}) {
    try {
      write_whole_file(path, "text");
      ADD_FAILURE() << "expected a complaint about " << path;
    } catch (const std::runtime_error& error) {
      EXPECT_EQ(std::string(error.what()).rfind(path.string() + ": can't be written: ", 0), 0u)
          << error.what();
    }
    EXPECT_THROW(require_writable(path), std::runtime_error) << path;
  }
  EXPECT_THROW(require_writable(folder.path() / "file" / "a" / "b"), std::runtime_error);
  EXPECT_NO_THROW(require_writable(folder.path() / "file"));
  EXPECT_NO_THROW(require_writable(folder.path() / "new" / "er" / "file"));
  EXPECT_EQ(folder.entries(), before);
  EXPECT_EQ(contents_of(folder.path() / "file"), "kept");
  EXPECT_EQ(contents_of(folder.path() / "taken" / "x"), "x");
}

}  // namespace
}  // namespace gnomon::scene
