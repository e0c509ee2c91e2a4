// SPDX-License-Identifier: MIT
// What all mesh readers stand on: lines and bytes of a stream, counted, without an allocation per line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gnomon::scene {

/// Hands out a stream's lines and, for binary parts, its bytes, in order, and words the complaints about
/// them. Reads ahead: from construction on, the stream belongs to the reader. Memory: one buffer that holds
/// the longest line.
class LineReader {
 public:
  /// Longer lines are refused, so that a file without a newline can't fill the memory. A polygon of 100,000
  /// corners fits (a tested figure).
  static constexpr std::size_t kMaxLineBytes = std::size_t{1} << 20;

  /// `name` is what complaints call the input. `in` must outlive the reader.
  LineReader(std::istream& in, std::string_view name);

  /// The next line without its end (LF or CR LF), valid until the next call of any member that reads; nothing
  /// at the end of the stream. The last line needs no end. Throws InputError for a line over kMaxLineBytes
  /// and when the stream fails.
  std::optional<std::string_view> next_line();

  /// The next line that is not blank once a comment ('#' to the end of the line) is cut off, without that
  /// comment.
  std::optional<std::string_view> next_content();

  /// The next `count` bytes, valid until the next call of any member that reads; null when fewer are left
  /// (they are then not consumed). Meant for small counts: the buffer grows to hold them.
  const char* take(std::size_t count) {
    if (end_ - begin_ < count && !fill(count)) return nullptr;
    const char* const bytes = buffer_.data() + begin_;
    begin_ += count;
    return bytes;
  }

  /// The number of the line handed out last, from 1; 0 before the first.
  [[nodiscard]] std::size_t line() const { return line_; }
  /// How many bytes were consumed so far.
  [[nodiscard]] std::uint64_t offset() const { return consumed_before_buffer_ + begin_; }

  /// Throws InputError "NAME:LINE: expected EXPECTED, found FOUND" for the line handed out last.
  [[noreturn]] void fail(std::string_view expected, std::string_view found) const;
  /// The same for a binary part: "NAME: expected EXPECTED, found FOUND at byte OFFSET".
  [[noreturn]] void fail_at(std::uint64_t offset, std::string_view expected, std::string_view found) const;

  /// The word as a finite double, rounded once to nearest; `what` names it in the complaint.
  [[nodiscard]] double finite_real(std::string_view word, std::string_view what) const;
  /// The word as an integer in [least, most]; `what` names it in the complaint.
  [[nodiscard]] std::int64_t integer(std::string_view word, std::int64_t least, std::int64_t most,
                                     std::string_view what) const;

 private:
  bool fill(std::size_t count);

  std::istream& in_;
  std::string name_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0;  // buffer_[begin_, end_) is read but not yet consumed
  std::size_t end_ = 0;
  std::uint64_t consumed_before_buffer_ = 0;
  std::size_t line_ = 0;
};

inline constexpr std::string_view kEndOfFile = "the end of the file";

/// A word of a file for a one-line message: in quotes, cut to 40 bytes, with bytes that don't print as \xNN;
/// an empty word is "the end of the line".
[[nodiscard]] std::string in_quotes(std::string_view word);

}  // namespace gnomon::scene
