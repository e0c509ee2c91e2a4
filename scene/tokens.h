// SPDX-License-Identifier: MIT
// A line as words.
#pragma once

#include <cstddef>
#include <string_view>

namespace gnomon::scene {

/// Walks over the words of one line, which are separated by blanks (space, tab, carriage return, vertical
/// tab, form feed). Holds a view: the line must outlive it.
class Tokens {
 public:
  explicit Tokens(std::string_view line) : rest_(line) {}

  /// The next word; empty when there is none left (a word itself is never empty).
  std::string_view next() {
    skip_blanks();
    std::size_t length = 0;
    while (length < rest_.size() && !is_blank(rest_[length])) ++length;
    const std::string_view word = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return word;
  }

  /// True when no word is left.
  bool done() {
    skip_blanks();
    return rest_.empty();
  }

  [[nodiscard]] static bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
  }

 private:
  void skip_blanks() {
    std::size_t blanks = 0;
    while (blanks < rest_.size() && is_blank(rest_[blanks])) ++blanks;
    rest_.remove_prefix(blanks);
  }

  std::string_view rest_;
};

/// True when the two words are equal but for the case of ASCII letters; no locale is asked.
[[nodiscard]] inline bool equals_ignoring_case(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (lower(a[i]) != lower(b[i])) return false;
  }
  return true;
}

}  // namespace gnomon::scene
