// SPDX-License-Identifier: MIT
// The values of a PLY body that is text.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "scene/line_reader.h"
#include "scene/parse_number.h"
#include "scene/ply_header.h"
#include "scene/tokens.h"

namespace gnomon::scene {

/// The body as text, one item a line. Complaints name the line.
class PlyTextSource {
 public:
  explicit PlyTextSource(LineReader& reader) : reader_(reader) {}

  /// Goes to the next item, whose place and element a complaint may name.
  void next_item(const PlyElement& element, std::uint64_t i) {
    while (const auto line = reader_.next_line()) {
      words_ = Tokens(*line);
      if (!words_.done()) return;
    }
    reader_.fail(ply_item(element, i), kEndOfFile);
  }

  /// The next value as its declared type holds it; throws InputError unless it is finite.
  double finite_real(PlyScalar type, std::string_view what) {
    if (is_integer(type)) return static_cast<double>(integer(type, what));
    const std::string_view word = words_.next();
    if (type == PlyScalar::kDouble) return reader_.finite_real(word, what);
    const auto value = parse_real<float>(word);
    if (!value || !std::isfinite(*value))
      reader_.fail("a finite float for " + std::string(what), in_quotes(word));
    return static_cast<double>(*value);
  }

  /// The next value, which must be one of an integer type's.
  std::int64_t integer(PlyScalar type, std::string_view what) {
    const PlyRange range = ply_scalar_info(type).range;
    return reader_.integer(words_.next(), range.least, range.most, what);
  }

  /// Passes one value over, whatever it says.
  void skip(PlyScalar) {
    if (words_.done()) reader_.fail("another value", in_quotes(""));
    (void)words_.next();
  }

  /// Complains about the value read last.
  [[noreturn]] void fail(std::string_view expected, std::string_view found) const {
    reader_.fail(expected, found);
  }

  void end_item() {
    if (!words_.done()) reader_.fail("the end of the line", in_quotes(words_.next()));
  }

  void end_body() {
    while (const auto line = reader_.next_line()) {
      if (Tokens words(*line); !words.done()) reader_.fail("the end of the file", in_quotes(words.next()));
    }
  }

 private:
  LineReader& reader_;
  Tokens words_{""};
};

}  // namespace gnomon::scene
