// SPDX-License-Identifier: MIT
#include <string>

#include "scene/line_reader.h"
#include "scene/parse_number.h"
#include "scene/read_mesh.h"
#include "scene/tokens.h"

namespace gnomon::scene {
namespace {

/// After x y z: a normal (3), a colour (up to 4), a texture coordinate (2). After a face: a colour.
constexpr int kMaxVertexExtras = 9;
constexpr int kMaxFaceExtras = 4;

std::string nth(std::string_view what, std::int64_t i, std::int64_t count) {
  return std::string(what) + " " + std::to_string(i + 1) + " of " + std::to_string(count);
}

/// True for OFF with any of ST, C, N before it, in this order.
bool is_header_word(std::string_view word) {
  for (const std::string_view prefix : {"ST", "C", "N"}) {
    if (word.starts_with(prefix)) word.remove_prefix(prefix.size());
  }
  return word == "OFF";
}

/// What follows a vertex or a face and is dropped must still be numbers, and not too many.
void drop_extras(const LineReader& reader, Tokens& words, int most) {
  for (int extras = 0; !words.done(); ++extras) {
    const std::string_view word = words.next();
    if (extras == most) reader.fail("the end of the line", in_quotes(word));
    if (!parse_real<double>(word)) reader.fail("a number or the end of the line", in_quotes(word));
  }
}

struct Counts {
  std::int64_t points;
  std::int64_t faces;
};

Counts read_header(LineReader& reader) {
  constexpr std::string_view kHeader = "the header OFF, with or without ST, C, N before it";
  auto line = reader.next_content();
  if (!line) reader.fail(kHeader, kEndOfFile);
  Tokens words(*line);
  const std::string_view header = words.next();
  if (!is_header_word(header)) reader.fail(kHeader, in_quotes(header));
  if (words.done()) {
    line = reader.next_content();
    if (!line) reader.fail("the numbers of vertices and faces", kEndOfFile);
    words = Tokens(*line);
  }
  Counts counts{};
  counts.points = reader.integer(words.next(), 1, kMaxMeshPoints, "a number of vertices");
  counts.faces = reader.integer(words.next(), 1, kMaxMeshPoints, "a number of faces");
  if (!words.done()) (void)reader.integer(words.next(), 0, INT64_MAX, "a number of edges");
  if (!words.done()) reader.fail("the end of the line", in_quotes(words.next()));
  return counts;
}

}  // namespace

Mesh read_off(std::istream& in, std::string_view name) {
  LineReader reader(in, name);
  const Counts counts = read_header(reader);
  Mesh mesh;
  for (std::int64_t i = 0; i < counts.points; ++i) {
    const auto line = reader.next_content();
    if (!line) reader.fail(nth("vertex", i, counts.points), kEndOfFile);
    Tokens words(*line);
    const double x = reader.finite_real(words.next(), "x");
    const double y = reader.finite_real(words.next(), "y");
    const double z = reader.finite_real(words.next(), "z");
    drop_extras(reader, words, kMaxVertexExtras);
    mesh.points.push_back({x, y, z});
  }
  for (std::int64_t i = 0; i < counts.faces; ++i) {
    const auto line = reader.next_content();
    if (!line) reader.fail(nth("face", i, counts.faces), kEndOfFile);
    Tokens words(*line);
    const std::int64_t corners = reader.integer(words.next(), 3, kMaxMeshPoints, "a number of corners");
    for (std::int64_t c = 0; c < corners; ++c) {
      const std::int64_t corner = reader.integer(words.next(), 0, counts.points - 1, "a vertex index");
      mesh.corners.push_back(static_cast<std::uint32_t>(corner));
    }
    drop_extras(reader, words, kMaxFaceExtras);
    mesh.end_face();
  }
  if (const auto line = reader.next_content()) {
    reader.fail("the end of the file after face " + std::to_string(counts.faces),
                in_quotes(Tokens(*line).next()));
  }
  return mesh;
}

}  // namespace gnomon::scene
