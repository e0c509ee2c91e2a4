// SPDX-License-Identifier: MIT
// The values of a PLY body that is bytes.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "scene/line_reader.h"
#include "scene/load_bytes.h"
#include "scene/ply_header.h"

namespace gnomon::scene {

/// The body as bytes, with the members of PlyTextSource. Complaints name the byte.
class PlyBinarySource {
 public:
  PlyBinarySource(LineReader& reader, std::endian order) : reader_(reader), order_(order) {}

  void next_item(const PlyElement& element, std::uint64_t i) {
    element_ = &element;
    item_ = i;
  }

  double finite_real(PlyScalar type, std::string_view what) {
    if (is_integer(type)) return static_cast<double>(integer(type, what));
    const char* const bytes = take(type);
    const double value = type == PlyScalar::kFloat ? static_cast<double>(load_bytes<float>(bytes, order_))
                                                   : load_bytes<double>(bytes, order_);
    if (!std::isfinite(value)) fail("a finite number for " + std::string(what), std::to_string(value));
    return value;
  }

  std::int64_t integer(PlyScalar type, std::string_view) {
    const char* const bytes = take(type);
    switch (type) {
      case PlyScalar::kInt8:
        return load_bytes<std::int8_t>(bytes, order_);
      case PlyScalar::kUint8:
        return load_bytes<std::uint8_t>(bytes, order_);
      case PlyScalar::kInt16:
        return load_bytes<std::int16_t>(bytes, order_);
      case PlyScalar::kUint16:
        return load_bytes<std::uint16_t>(bytes, order_);
      case PlyScalar::kInt32:
        return load_bytes<std::int32_t>(bytes, order_);
      case PlyScalar::kUint32:
        return load_bytes<std::uint32_t>(bytes, order_);
      case PlyScalar::kFloat:
      case PlyScalar::kDouble:
        break;
    }
    fail("an integer type", "a real one");
  }

  void skip(PlyScalar type) { (void)take(type); }

  [[noreturn]] void fail(std::string_view expected, std::string_view found) const {
    reader_.fail_at(start_, expected, found);
  }

  void end_item() {}

  void end_body() {
    start_ = reader_.offset();
    if (reader_.take(1) != nullptr) fail("the end of the file", "more bytes");
  }

 private:
  const char* take(PlyScalar type) {
    start_ = reader_.offset();
    const char* const bytes = reader_.take(ply_scalar_info(type).bytes);
    if (bytes == nullptr) fail(ply_item(*element_, item_), kEndOfFile);
    return bytes;
  }

  LineReader& reader_;
  std::endian order_;
  const PlyElement* element_ = nullptr;
  std::uint64_t item_ = 0;
  std::uint64_t start_ = 0;
};

}  // namespace gnomon::scene
