// SPDX-License-Identifier: MIT
#include "scene/ply_header.h"

#include <array>
#include <utility>

#include "scene/tokens.h"

namespace gnomon::scene {
namespace {

/// The names of 1994 and the later ones that say their width.
constexpr std::array<std::pair<std::string_view, PlyScalar>, 16> kScalars{{
    {"char", PlyScalar::kInt8},
    {"int8", PlyScalar::kInt8},
    {"uchar", PlyScalar::kUint8},
    {"uint8", PlyScalar::kUint8},
    {"short", PlyScalar::kInt16},
    {"int16", PlyScalar::kInt16},
    {"ushort", PlyScalar::kUint16},
    {"uint16", PlyScalar::kUint16},
    {"int", PlyScalar::kInt32},
    {"int32", PlyScalar::kInt32},
    {"uint", PlyScalar::kUint32},
    {"uint32", PlyScalar::kUint32},
    {"float", PlyScalar::kFloat},
    {"float32", PlyScalar::kFloat},
    {"double", PlyScalar::kDouble},
    {"float64", PlyScalar::kDouble},
}};

constexpr std::array<std::pair<std::string_view, PlyEncoding>, 3> kEncodings{{
    {"ascii", PlyEncoding::kAscii},
    {"binary_little_endian", PlyEncoding::kLittleEndian},
    {"binary_big_endian", PlyEncoding::kBigEndian},
}};

/// Headers of real files have tens of lines; the bound keeps the search for names that came twice from
/// growing with the square of a hostile header.
constexpr std::size_t kMaxNames = 1000;

class HeaderReader {
 public:
  explicit HeaderReader(LineReader& reader) : reader_(reader) {}

  PlyHeader read() {
    next_line("ply");
    const std::string_view magic = words_.next();
    if (magic != "ply") reader_.fail("ply", in_quotes(magic));
    end_line();
    next_line("a format");
    if (const auto word = words_.next(); word != "format") reader_.fail("format", in_quotes(word));
    header_.encoding = look_up(kEncodings, "ascii, binary_little_endian or binary_big_endian");
    if (const auto version = words_.next(); version != "1.0") reader_.fail("version 1.0", in_quotes(version));
    end_line();
    for (;;) {
      next_line("end_header");
      const std::string_view keyword = words_.next();
      if (keyword == "comment" || keyword == "obj_info") continue;
      if (keyword == "end_header") break;
      if (keyword == "element") {
        read_element();
      } else if (keyword == "property") {
        read_property();
      } else {
        reader_.fail("element, property, comment, obj_info or end_header", in_quotes(keyword));
      }
      end_line();
    }
    end_line();
    return std::move(header_);
  }

 private:
  void next_line(std::string_view expected) {
    const auto line = reader_.next_line();
    if (!line) reader_.fail(expected, kEndOfFile);
    words_ = Tokens(*line);
  }

  void end_line() {
    if (!words_.done()) reader_.fail("the end of the line", in_quotes(words_.next()));
  }

  template <class Table>
  typename Table::value_type::second_type look_up(const Table& table, std::string_view expected) {
    const std::string_view word = words_.next();
    for (const auto& [name, value] : table) {
      if (name == word) return value;
    }
    reader_.fail(expected, in_quotes(word));
  }

  PlyScalar read_integer_type() {
    const PlyScalar type = look_up(kScalars, "a type of the PLY format");
    if (!is_integer(type)) reader_.fail("an integer type for the count", "a real one");
    return type;
  }

  void read_element() {
    PlyElement element;
    element.name = words_.next();
    if (element.name.empty()) reader_.fail("a name", in_quotes(""));
    for (const PlyElement& other : header_.elements) {
      if (other.name == element.name)
        reader_.fail("one element of a name", "a second " + in_quotes(element.name));
    }
    element.count = static_cast<std::uint64_t>(reader_.integer(words_.next(), 0, INT64_MAX, "a count"));
    if (header_.elements.size() == kMaxNames) reader_.fail("at most 1000 elements", "one more");
    header_.elements.push_back(std::move(element));
  }

  void read_property() {
    if (header_.elements.empty()) reader_.fail("an element before its properties", "none");
    PlyElement& element = header_.elements.back();
    PlyProperty property;
    Tokens ahead = words_;
    if (ahead.next() == "list") {
      words_ = ahead;
      property.count_type = read_integer_type();
    }
    property.type = look_up(kScalars, "a type of the PLY format");
    property.name = words_.next();
    if (property.name.empty()) reader_.fail("a name", in_quotes(""));
    if (element.find(property.name)) {
      reader_.fail("one property of a name", "a second " + in_quotes(property.name));
    }
    if (element.properties.size() == kMaxNames) reader_.fail("at most 1000 properties", "one more");
    element.properties.push_back(std::move(property));
  }

  LineReader& reader_;
  Tokens words_{""};
  PlyHeader header_;
};

}  // namespace

std::string ply_item(const PlyElement& element, std::uint64_t i) {
  return in_quotes(element.name) + " " + std::to_string(i + 1) + " of " + std::to_string(element.count);
}

PlyHeader read_ply_header(LineReader& reader) {
  return HeaderReader(reader).read();
}

}  // namespace gnomon::scene
