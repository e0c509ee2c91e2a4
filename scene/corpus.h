// SPDX-License-Identifier: MIT
// The text corpus: one case a line, for replays, witnesses and seeds.
#pragma once

#include <cstddef>
#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gnomon::scene {

/// One case as text: `QUESTION word word ... [-> ANSWER]`, the answer being a word or a set `{word word
/// ...}`, kept with single spaces. What the words mean is the question's business.
struct CorpusLine {
  std::string file;
  std::size_t line = 0;
  std::string question;
  std::vector<std::string> words;
  std::optional<std::string> answer;

  /// All words as finite numbers, of which there must be `count`; else throws InputError naming file and
  /// line.
  [[nodiscard]] std::vector<double> numbers(std::size_t count) const;
  /// Throws InputError "FILE:LINE: expected ..., found ...".
  [[noreturn]] void fail(std::string_view expected, std::string_view found) const;
};

/// Reads a corpus: blank lines and what follows a '#' are skipped. Throws InputError naming file and line for
/// a case without words, a lonely "->", more than one answer or a set without an end, and for a file that
/// can't be read or holds no case.
[[nodiscard]] std::vector<CorpusLine> read_corpus(const std::filesystem::path& path);
[[nodiscard]] std::vector<CorpusLine> read_corpus(std::istream& in, std::string_view name);

/// `QUESTION 0x1p+0 ... -> ANSWER`, without an end of line; no arrow when the answer is empty.
[[nodiscard]] std::string corpus_text(std::string_view question, const std::vector<double>& numbers,
                                      std::string_view answer);

}  // namespace gnomon::scene
