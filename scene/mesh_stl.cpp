// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <istream>
#include <string>
#include <utility>

#include "scene/input_error.h"
#include "scene/line_reader.h"
#include "scene/load_bytes.h"
#include "scene/point_merger.h"
#include "scene/read_mesh.h"
#include "scene/tokens.h"

namespace gnomon::scene {
namespace {

// Binary: an 80-byte header, the number of faces, and for each face a normal, three points (twelve floats)
// and two bytes of attributes; little-endian.
constexpr std::size_t kHeaderBytes = 80;
constexpr std::size_t kPrefixBytes = kHeaderBytes + 4;
constexpr std::size_t kFaceBytes = 50;
constexpr std::size_t kNormalBytes = 12;

/// The two parsers have this in common.
struct Soup {
  Mesh mesh;
  PointMerger merger{mesh.points};

  /// False when the mesh is full.
  bool add_corner(const std::array<double, 3>& point) {
    if (mesh.points.size() == kMaxMeshPoints) return false;
    mesh.corners.push_back(merger.index_of(point));
    return true;
  }
};

constexpr std::string_view kMostPoints = "at most 4294967295 different points";

Mesh read_binary(LineReader& reader) {
  const std::uint32_t faces =
      load_bytes<std::uint32_t>(reader.take(kPrefixBytes) + kHeaderBytes, std::endian::little);
  if (faces == 0) reader.fail_at(kHeaderBytes, "at least one face", "0");
  Soup soup;
  for (std::uint32_t f = 0; f < faces; ++f) {
    const std::uint64_t start = reader.offset();
    const char* const record = reader.take(kFaceBytes);
    if (record == nullptr) reader.fail_at(start, "a face of 50 bytes", kEndOfFile);
    for (std::size_t corner = 0; corner < 3; ++corner) {
      std::array<double, 3> point;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t at = kNormalBytes + 12 * corner + 4 * axis;
        point[axis] = static_cast<double>(load_bytes<float>(record + at, std::endian::little));
        if (!std::isfinite(point[axis])) {
          reader.fail_at(start + at, "a finite coordinate", std::to_string(point[axis]));
        }
      }
      if (!soup.add_corner(point)) reader.fail_at(start, kMostPoints, "one more");
    }
    soup.mesh.end_face();
  }
  return std::move(soup.mesh);
}

class TextReader {
 public:
  explicit TextReader(LineReader& reader) : reader_(reader) {}

  Mesh read() {
    for (bool first = true;; first = false) {
      if (!next_line(first ? "solid" : "")) break;
      expect("solid");
      while (next_keyword("facet or endsolid", "facet", "endsolid")) read_facet();
    }
    if (soup_.mesh.face_count() == 0) reader_.fail("at least one face", kEndOfFile);
    return std::move(soup_.mesh);
  }

 private:
  /// Goes to the next line that is not blank. At the end of the file: false when nothing was expected.
  bool next_line(std::string_view expected) {
    while (const auto line = reader_.next_line()) {
      words_ = Tokens(*line);
      if (!words_.done()) return true;
    }
    if (!expected.empty()) reader_.fail(expected, kEndOfFile);
    return false;
  }

  void expect(std::string_view keyword) {
    const std::string_view word = words_.next();
    if (!equals_ignoring_case(word, keyword)) reader_.fail(keyword, in_quotes(word));
  }

  void expect_line(std::string_view keyword) {
    next_line(keyword);
    expect(keyword);
  }

  void expect_end_of_line() {
    if (!words_.done()) reader_.fail("the end of the line", in_quotes(words_.next()));
  }

  /// The next line's keyword: true for `yes`, false for `no`.
  bool next_keyword(std::string_view expected, std::string_view yes, std::string_view no) {
    next_line(expected);
    const std::string_view word = words_.next();
    if (equals_ignoring_case(word, yes)) return true;
    if (!equals_ignoring_case(word, no)) reader_.fail(expected, in_quotes(word));
    return false;
  }

  /// The rest of a facet, whose first word was read. Its normal is dropped unread: many writers leave NaN
  /// there.
  void read_facet() {
    expect_line("outer");
    expect("loop");
    expect_end_of_line();
    for (int corner = 0; corner < 3; ++corner) {
      expect_line("vertex");
      const double x = reader_.finite_real(words_.next(), "x");
      const double y = reader_.finite_real(words_.next(), "y");
      const double z = reader_.finite_real(words_.next(), "z");
      expect_end_of_line();
      if (!soup_.add_corner({x, y, z})) reader_.fail(kMostPoints, "one more");
    }
    for (const std::string_view keyword : {"endloop", "endfacet"}) {
      expect_line(keyword);
      expect_end_of_line();
    }
    soup_.mesh.end_face();
  }

  LineReader& reader_;
  Tokens words_{""};
  Soup soup_;
};

/// Text that happens to have the size its bytes 80 to 83 ask for in binary would be over 7 GB long: the least
/// text byte is 0x09, and four of them ask for 151,587,081 faces.
bool is_binary_size(std::uint64_t size, std::string_view start) {
  return start.size() >= kPrefixBytes &&
         size == kPrefixBytes + kFaceBytes * std::uint64_t{load_bytes<std::uint32_t>(
                                                 start.data() + kHeaderBytes, std::endian::little)};
}

/// For streams of no binary size: whether they mean to be text.
bool is_text(std::string_view start) {
  std::size_t blanks = 0;
  while (blanks < start.size() && (Tokens::is_blank(start[blanks]) || start[blanks] == '\n')) ++blanks;
  return equals_ignoring_case(start.substr(blanks, 5), "solid") && start.find('\0') == std::string_view::npos;
}

}  // namespace

Mesh read_stl(std::istream& in, std::string_view name) {
  const std::istream::pos_type begin = in.tellg();
  const std::istream::pos_type end = in.seekg(0, std::ios::end).tellg();
  if (begin == std::istream::pos_type(-1) || end == std::istream::pos_type(-1)) {
    throw InputError(name, 0, "expected a seekable file, found a stream");
  }
  in.seekg(begin);
  std::array<char, 512> block{};
  in.read(block.data(), static_cast<std::streamsize>(block.size()));
  const std::string_view start(block.data(), static_cast<std::size_t>(in.gcount()));
  in.clear();
  in.seekg(begin);

  LineReader reader(in, name);
  const auto size = static_cast<std::uint64_t>(end - begin);
  if (is_binary_size(size, start)) return read_binary(reader);
  if (is_text(start)) return TextReader(reader).read();
  std::string expected = "text that begins with solid, or binary of 84 + 50 n bytes";
  if (start.size() >= kPrefixBytes) {
    expected += " for n = " +
                std::to_string(load_bytes<std::uint32_t>(start.data() + kHeaderBytes, std::endian::little));
  }
  throw InputError(name, 0, "expected " + expected + ", found " + std::to_string(size) + " bytes");
}

}  // namespace gnomon::scene
