// SPDX-License-Identifier: MIT
#include "scene/line_reader.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <istream>

#include "scene/input_error.h"
#include "scene/parse_number.h"
#include "scene/tokens.h"

namespace gnomon::scene {
namespace {

/// Large enough that the cost of a refill vanishes beside that of parsing what it brought.
constexpr std::size_t kBlockBytes = std::size_t{1} << 16;

}  // namespace

LineReader::LineReader(std::istream& in, std::string_view name)
    : in_(in), name_(name), buffer_(kBlockBytes) {}

bool LineReader::fill(std::size_t count) {
  std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
  consumed_before_buffer_ += begin_;
  end_ -= begin_;
  begin_ = 0;
  if (buffer_.size() < count) buffer_.resize(std::max(count, 2 * buffer_.size()));
  while (end_ < count && in_.good()) {
    in_.read(buffer_.data() + end_, static_cast<std::streamsize>(buffer_.size() - end_));
    end_ += static_cast<std::size_t>(in_.gcount());
  }
  if (in_.bad()) throw InputError(name_, 0, "expected a readable file, found a read error");
  return end_ >= count;
}

std::optional<std::string_view> LineReader::next_line() {
  std::size_t searched = 0;
  for (;;) {
    const char* const start = buffer_.data() + begin_;
    const std::size_t held = end_ - begin_;
    const void* const found =
        held > searched ? std::memchr(start + searched, '\n', held - searched) : nullptr;
    std::size_t length =
        found != nullptr ? static_cast<std::size_t>(static_cast<const char*>(found) - start) : held;
    if (found == nullptr && length <= kMaxLineBytes && fill(held + 1)) {
      searched = held;
      continue;
    }
    if (found == nullptr && length == 0) return std::nullopt;
    ++line_;
    if (length > kMaxLineBytes) {
      fail("a line of at most " + std::to_string(kMaxLineBytes) + " bytes", "a longer one");
    }
    const char* const text = buffer_.data() + begin_;
    begin_ += length + (found != nullptr ? 1 : 0);
    if (length > 0 && text[length - 1] == '\r') --length;
    return std::string_view(text, length);
  }
}

std::optional<std::string_view> LineReader::next_content() {
  while (const auto line = next_line()) {
    const std::string_view content = line->substr(0, line->find('#'));
    if (!Tokens(content).done()) return content;
  }
  return std::nullopt;
}

void LineReader::fail(std::string_view expected, std::string_view found) const {
  throw InputError(name_, line_, "expected " + std::string(expected) + ", found " + std::string(found));
}

void LineReader::fail_at(std::uint64_t offset, std::string_view expected, std::string_view found) const {
  throw InputError(name_, 0,
                   "expected " + std::string(expected) + ", found " + std::string(found) + " at byte " +
                       std::to_string(offset));
}

double LineReader::finite_real(std::string_view word, std::string_view what) const {
  const auto value = parse_real<double>(word);
  if (!value || !std::isfinite(*value)) fail("a finite number for " + std::string(what), in_quotes(word));
  return *value;
}

std::int64_t LineReader::integer(std::string_view word, std::int64_t least, std::int64_t most,
                                 std::string_view what) const {
  const auto value = parse_integer(word);
  if (!value || *value < least || *value > most) {
    fail(std::string(what) + " from " + std::to_string(least) + " to " + std::to_string(most),
         in_quotes(word));
  }
  return *value;
}

std::string in_quotes(std::string_view word) {
  constexpr std::size_t kShown = 40;
  constexpr std::string_view kDigits = "0123456789abcdef";
  if (word.empty()) return "the end of the line";
  std::string text = "'";
  for (const char c : word.substr(0, kShown)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7f) {
      text += c;
    } else {
      text += "\\x";
      text += kDigits[byte >> 4];
      text += kDigits[byte & 15];
    }
  }
  return text + (word.size() > kShown ? "...'" : "'");
}

}  // namespace gnomon::scene
