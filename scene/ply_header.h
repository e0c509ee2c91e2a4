// SPDX-License-Identifier: MIT
// The header of a PLY file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/line_reader.h"

namespace gnomon::scene {

enum class PlyEncoding { kAscii, kLittleEndian, kBigEndian };

enum class PlyScalar { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat, kDouble };

/// The integers that a type holds; for kFloat and kDouble an empty range, least > most.
struct PlyRange {
  std::int64_t least;
  std::int64_t most;
};

template <class T>
inline constexpr PlyRange kPlyRange{std::numeric_limits<T>::min(), std::numeric_limits<T>::max()};

/// What the format says of one scalar type.
struct PlyScalarInfo {
  std::size_t bytes;
  PlyRange range;
};

/// Total: every PlyScalar has an answer.
[[nodiscard]] constexpr PlyScalarInfo ply_scalar_info(PlyScalar type) {
  switch (type) {
    case PlyScalar::kInt8:
      return {1, kPlyRange<std::int8_t>};
    case PlyScalar::kUint8:
      return {1, kPlyRange<std::uint8_t>};
    case PlyScalar::kInt16:
      return {2, kPlyRange<std::int16_t>};
    case PlyScalar::kUint16:
      return {2, kPlyRange<std::uint16_t>};
    case PlyScalar::kInt32:
      return {4, kPlyRange<std::int32_t>};
    case PlyScalar::kUint32:
      return {4, kPlyRange<std::uint32_t>};
    case PlyScalar::kFloat:
      return {4, {1, 0}};
    case PlyScalar::kDouble:
      break;
  }
  return {8, {1, 0}};
}

[[nodiscard]] constexpr bool is_integer(PlyScalar type) {
  return type != PlyScalar::kFloat && type != PlyScalar::kDouble;
}

/// One value of each item or, with a count type, a count and so many values.
struct PlyProperty {
  std::string name;
  PlyScalar type{};
  std::optional<PlyScalar> count_type;
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;  ///< as claimed: nothing may be allocated from it
  std::vector<PlyProperty> properties;

  /// The place of the property of this name among `properties`, if there is one.
  [[nodiscard]] std::optional<std::size_t> find(std::string_view property) const {
    for (std::size_t i = 0; i < properties.size(); ++i) {
      if (properties[i].name == property) return i;
    }
    return std::nullopt;
  }
};

struct PlyHeader {
  PlyEncoding encoding{};
  std::vector<PlyElement> elements;
};

/// How complaints call item i (from 0) of an element: "'vertex' 3 of 8".
[[nodiscard]] std::string ply_item(const PlyElement& element, std::uint64_t i);

/// Reads the lines from "ply" to "end_header"; the reader is then at the first byte of the body. Throws
/// InputError for a header that is not PLY 1.0, has two elements, or one element two properties, of the same
/// name, or a type that the format doesn't know. Counts are at most 2^63 - 1.
[[nodiscard]] PlyHeader read_ply_header(LineReader& reader);

}  // namespace gnomon::scene
