// SPDX-License-Identifier: GPL-3.0-or-later
// The readers of formats that are text or binary, PLY and STL: good files, and the exact complaint about
// every kind of bad one.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>

#include "scene/read_mesh.h"
#include "tests/mesh_readers_checks.h"

namespace gnomon::scene {
namespace {

/// Appends numbers as bytes of the wanted order.
template <class... T>
std::string bytes(std::endian order, T... values) {
  std::string all;
  const auto append = [&](auto value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    std::string one(raw, sizeof value);
    all += order == std::endian::native ? one : std::string(one.rbegin(), one.rend());
  };
  (append(values), ...);
  return all;
}

/// A PLY header of double vertices and uchar-int faces.
std::string ply_header(const std::string& format, int vertices = 3, int faces = 1) {
  return "ply\nformat " + format + " 1.0\nelement vertex " + std::to_string(vertices) +
         "\nproperty double x\nproperty double y\nproperty double z\nelement face " + std::to_string(faces) +
         "\nproperty list uchar int vertex_indices\nend_header\n";
}

const std::string kAsciiBody = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

// ----------------------------------------------------------------------------------------------------------
// PLY

TEST(ReadPly, TakesAscii) {
  EXPECT_EQ(read(read_ply, ply_header("ascii") + kAsciiBody), kTriangle);
  EXPECT_EQ(read(read_ply, ply_header("ascii", 4, 2) + "0 0 0\n1 0 0\n\n1 1 0\n0 1 .1\n4 0 1 2 3\n3 2 1 0"),
            kTwoFaces);
}

TEST(ReadPly, TakesBinaryOfBothByteOrders) {
  for (const auto& [format, order] : {std::pair("binary_little_endian", std::endian::little),
                                      std::pair("binary_big_endian", std::endian::big)}) {
    const std::string points = bytes(order, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.1);
    const std::string faces = bytes(order, std::uint8_t{4}, 0, 1, 2, 3, std::uint8_t{3}, 2, 1, 0);
    EXPECT_EQ(read(read_ply, ply_header(format, 4, 2) + points + faces), kTwoFaces) << format;
  }
}

TEST(ReadPly, SkipsOtherElementsAndPropertiesOfEveryTypeInBothEncodings) {
  const std::string elements =
      "comment made by hand\r\nobj_info none\r\nelement face 1\r\nproperty int8 a\r\nproperty list uint8 "
      "float64 b\r\n"
      "property list uint16 uint32 vertex_index\r\nproperty uchar red\r\nelement empty 4000000000\r\n"
      "element edge 2\r\nproperty int v1\r\nproperty list char short c\r\nelement vertex 3\r\n"
      "property ushort q\r\nproperty char z\r\nproperty uint x\r\nproperty float y\r\nproperty float32 n\r\n"
      "end_header\r\n";
  EXPECT_EQ(
      read(read_ply,
           "ply\r\nformat ascii 1.0\r\n" + elements +
               "-1 2 nan 5 3 0 1 2 255\r\n1 0\r\n2 3 0 0 0\r\n7 0 0 0 nan\r\n7 0 1 0 .5\r\n7 0 0 1e0 0\r\n"),
      kTriangle);
  const auto le = std::endian::little;
  const std::string vertices = bytes(le, std::uint16_t{7}, std::int8_t{0}, std::uint32_t{0}, 0.f, 0.f) +
                               bytes(le, std::uint16_t{7}, std::int8_t{0}, std::uint32_t{1}, 0.f, 0.f) +
                               bytes(le, std::uint16_t{7}, std::int8_t{0}, std::uint32_t{0}, 1.f,
                                     std::numeric_limits<float>::quiet_NaN());
  const std::string face = bytes(le, std::int8_t{-1}, std::uint8_t{2}, 1.0, 2.0, std::uint16_t{3},
                                 std::uint32_t{0}, std::uint32_t{1}, std::uint32_t{2}, std::uint8_t{255});
  const std::string edges = bytes(le, 1, std::int8_t{0}, 2, std::int8_t{2}, std::int16_t{0}, std::int16_t{0});
  EXPECT_EQ(read(read_ply, "ply\r\nformat binary_little_endian 1.0\r\n" + elements + face + edges + vertices),
            kTriangle);
}

TEST(ReadPly, RoundsToTheDeclaredTypeSoThatAsciiAndBinaryAgree) {
  std::string header = ply_header("ascii");
  header.replace(header.find("double y"), 8, "float y ");
  const Mesh mesh = read(read_ply, header + "0.1 0.1 0.1\n1 0 0\n0 1 0\n3 0 1 2\n");
  EXPECT_EQ(mesh.points[0], (std::array<double, 3>{0.1, static_cast<double>(0.1f), 0.1}));
  EXPECT_EQ(complaint(read_ply, header + "0 1e39 0\n"), "m:10: expected a finite float for y, found '1e39'");
}

TEST(ReadPly, NamesLineAndFaultOfBadText) {
  const std::string ascii = ply_header("ascii");
  const std::string head = "ply\nformat ascii 1.0\n";
  const std::string vertex =
      head + "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
  const std::pair<std::string, std::string> cases[] = {
      {"", "m: expected ply, found the end of the file"},
      {"OFF\n", "m:1: expected ply, found 'OFF'"},
      {"ply ply\n", "m:1: expected the end of the line, found 'ply'"},
      {"ply\nelement vertex 3\n", "m:2: expected format, found 'element'"},
      {"ply\nformat binary 1.0\n",
       "m:2: expected ascii, binary_little_endian or binary_big_endian, found 'binary'"},
      {"ply\nformat ascii 2.0\n", "m:2: expected version 1.0, found '2.0'"},
      {head, "m:2: expected end_header, found the end of the file"},
      {head + "elements\n",
       "m:3: expected element, property, comment, obj_info or end_header, found 'elements'"},
      {head + "property int x\n", "m:3: expected an element before its properties, found none"},
      {head + "element\n", "m:3: expected a name, found the end of the line"},
      {head + "element a -1\n", "m:3: expected a count from 0 to 9223372036854775807, found '-1'"},
      {head + "element a 1 1\n", "m:3: expected the end of the line, found '1'"},
      {head + "element a 1\nelement a 1\n", "m:4: expected one element of a name, found a second 'a'"},
      {head + "element a 1\nproperty int64 b\n", "m:4: expected a type of the PLY format, found 'int64'"},
      {head + "element a 1\nproperty int\n", "m:4: expected a name, found the end of the line"},
      {head + "element a 1\nproperty list float int b\n",
       "m:4: expected an integer type for the count, found a real one"},
      {head + "element a 1\nproperty int b\nproperty int b\n",
       "m:5: expected one property of a name, found a second 'b'"},
      {head + "end_header\n", "m:3: expected an element vertex, found none"},
      {head + "element vertex 0\nend_header\n", "m:4: expected at least one vertex, found none"},
      {head + "element vertex 4294967296\nend_header\n",
       "m:4: expected at most 4294967295 vertices, found 4294967296"},
      {head + "element vertex 3\nproperty float x\nend_header\n",
       "m:5: expected a property y of vertex, found none"},
      {head + "element vertex 3\nproperty list int int x\nend_header\n",
       "m:5: expected a property x of vertex, found a list"},
      {vertex + "end_header\n", "m:7: expected an element face, found none"},
      {vertex + "element face 0\nend_header\n", "m:8: expected at least one face, found none"},
      {vertex + "element face 1\nend_header\n",
       "m:8: expected a list vertex_indices or vertex_index of face, found neither"},
      {vertex + "element face 1\nproperty int vertex_index\nproperty int vertex_indices\nend_header\n",
       "m:10: expected a list vertex_indices or vertex_index of face, found both"},
      {vertex + "element face 1\nproperty int vertex_index\nend_header\n",
       "m:9: expected a list of integers vertex_index, found a single value"},
      {vertex + "element face 1\nproperty list int float vertex_index\nend_header\n",
       "m:9: expected a list of integers vertex_index, found a list of reals"},
      {ascii, "m:9: expected 'vertex' 1 of 3, found the end of the file"},
      {ascii + "0 0 0\n1 0 0\n", "m:11: expected 'vertex' 3 of 3, found the end of the file"},
      {ascii + "0 0 0\n1 0 0\n0 1 0\n", "m:12: expected 'face' 1 of 1, found the end of the file"},
      {vertex +
           "element face 1\nproperty list int int vertex_index\nelement \x01\x7f 2\nproperty int "
           "a\nend_header\n" +
           kAsciiBody,
       "m:15: expected '\\x01\\x7f' 1 of 2, found the end of the file"},
      {ascii + "0 nan 0\n", "m:10: expected a finite number for y, found 'nan'"},
      {ascii + "0 0 inf\n", "m:10: expected a finite number for z, found 'inf'"},
      {ascii + "1e309 0 0\n", "m:10: expected a finite number for x, found '1e309'"},
      {ascii + "0 0\n", "m:10: expected a finite number for z, found the end of the line"},
      {ascii + "0 0 0 0\n", "m:10: expected the end of the line, found '0'"},
      {ascii + "0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "m:13: expected a vertex index from 0 to 2, found 3"},
      {ascii + "0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", "m:13: expected a vertex index from 0 to 2, found -1"},
      {ascii + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2.0\n",
       "m:13: expected a vertex index from -2147483648 to 2147483647, found '2.0'"},
      {ascii + "0 0 0\n1 0 0\n0 1 0\n256 0 1 2\n",
       "m:13: expected a number of corners from 0 to 255, found '256'"},
      {ascii + "0 0 0\n1 0 0\n0 1 0\n2 0 1\n", "m:13: expected a face of at least 3 corners, found 2"},
      {ascii + kAsciiBody + "3 0 1 2\n", "m:14: expected the end of the file, found '3'"},
  };
  for (const auto& [text, expected] : cases) EXPECT_EQ(complaint(read_ply, text), expected) << text;
}

TEST(ReadPly, NamesByteAndFaultOfBadBytes) {
  const auto le = std::endian::little;
  const std::string head = ply_header("binary_little_endian");
  const std::string points = bytes(le, 0., 0., 0., 1., 0., 0., 0., 1., 0.);
  const auto at = [&head](int byte) {
    return " at byte " + std::to_string(head.size() + static_cast<std::size_t>(byte));
  };
  const std::pair<std::string, std::string> cases[] = {
      {"", "m: expected 'vertex' 1 of 3, found the end of the file" + at(0)},
      {points.substr(0, 70), "m: expected 'vertex' 3 of 3, found the end of the file" + at(64)},
      {points, "m: expected 'face' 1 of 1, found the end of the file" + at(72)},
      {points + bytes(le, std::uint8_t{3}, 0, 1),
       "m: expected 'face' 1 of 1, found the end of the file" + at(81)},
      {points + bytes(le, std::uint8_t{2}, 0, 1),
       "m: expected a face of at least 3 corners, found 2" + at(72)},
      {points + bytes(le, std::uint8_t{3}, 0, 1, 3),
       "m: expected a vertex index from 0 to 2, found 3" + at(81)},
      {points + bytes(le, std::uint8_t{3}, 0, -1, 2),
       "m: expected a vertex index from 0 to 2, found -1" + at(77)},
      {points + bytes(le, std::uint8_t{3}, 0, 1, 2) + "\n",
       "m: expected the end of the file, found more bytes" + at(85)},
      {bytes(le, 0., std::nan("")), "m: expected a finite number for y, found nan" + at(8)},
      {bytes(le, 0., 0., HUGE_VAL), "m: expected a finite number for z, found inf" + at(16)},
  };
  for (const auto& [body, expected] : cases) EXPECT_EQ(complaint(read_ply, head + body), expected);
  // A claim of 4 billion items, corners or list values must not be believed before they are there.
  std::string claims = ply_header("binary_big_endian", 2000000000, 2000000000);
  claims.replace(claims.find("uchar"), 5, "uint");
  EXPECT_EQ(complaint(read_ply, claims),
            "m: expected 'vertex' 1 of 2000000000, found the end of the file at byte " +
                std::to_string(claims.size()));
  claims.replace(claims.find("2000000000"), 10, "1");
  EXPECT_EQ(complaint(read_ply, claims + bytes(std::endian::big, 0., 0., 0., 4294967295u, 0)),
            "m: expected 'face' 1 of 2000000000, found the end of the file at byte " +
                std::to_string(claims.size() + 32));
  std::string list = ply_header("binary_big_endian");
  list.replace(list.find("property double x"), 17, "property list char int l\nproperty double x");
  EXPECT_EQ(complaint(read_ply, list + "\xff"),
            "m: expected a number of list values, found -1 at byte " + std::to_string(list.size()));
}

// ----------------------------------------------------------------------------------------------------------
// STL

const std::string kFacet =
    "facet normal 0 0 1\n  outer loop\n    vertex 0 0 0\n    vertex 1 0 0\n    vertex 0 1 0\n  "
    "endloop\nendfacet\n";

std::string stl_prefix(const std::string& header, std::uint32_t faces) {
  return (header + std::string(80, ' ')).substr(0, 80) + bytes(std::endian::little, faces);
}

std::string stl_face(std::array<float, 9> points) {
  std::string face = bytes(std::endian::little, 0.f, 0.f, std::numeric_limits<float>::quiet_NaN());
  for (const float c : points) face += bytes(std::endian::little, c);
  return face + bytes(std::endian::little, std::uint16_t{0xffff});
}

TEST(ReadStl, TakesTextInAnyCaseOfSeveralSolids) {
  EXPECT_EQ(read(read_stl, "solid a # b\n" + kFacet + "endsolid a\n"), kTriangle);
  EXPECT_EQ(read(read_stl,
                 "\r\n SOLID\r\nFacet Normal nan nan nan\r\nOUTER LOOP\r\nVERTEX 0 0 0\r\nVertex +1 0 0\r\n"
                 "vertex 0 1e0 -0\r\nEndLoop\r\nENDFACET\r\nendsolid"),
            kTriangle);
  const Mesh two = read(read_stl, "solid a\n" + kFacet + "endsolid a\nsolid b\n" + kFacet + "endsolid b\n\n");
  EXPECT_EQ(two.points, kTriangle.points);
  EXPECT_EQ(two.corners, (std::vector<std::uint32_t>{0, 1, 2, 0, 1, 2}));
}

TEST(ReadStl, TakesBinaryWhateverItsFirstWord) {
  const std::string face = stl_face({0, 0, 0, 1, 0, 0, 0, 1, 0});
  EXPECT_EQ(read(read_stl, stl_prefix("made by hand", 1) + face), kTriangle);
  EXPECT_EQ(read(read_stl, stl_prefix("solid thing", 1) + face), kTriangle);
}

TEST(ReadStl, MergesEqualPointsAndTakesMinusZeroForZero) {
  const Mesh mesh = read(read_stl, stl_prefix("", 3) + stl_face({0, 0, 0, 1, 0, 0, 0, 1, 0}) +
                                       stl_face({1, -0.f, 0, -0.f, 0, -0.f, 0, 0, 1}) +
                                       stl_face({0, 1, 0, 0, 1, 0, 1e-45f, 1, 0}));
  EXPECT_EQ(mesh.points.size(), 5u);
  EXPECT_EQ(mesh.corners, (std::vector<std::uint32_t>{0, 1, 2, 1, 0, 3, 2, 2, 4}));
}

TEST(ReadStl, MergesManyPoints) {
  std::string text = stl_prefix("", 3000);
  for (int i = 0; i < 3000; ++i) {
    const auto c = static_cast<float>(i % 1000);
    text += stl_face({c, 0, 0, 0, c, 0, 0, 0, c});
  }
  const Mesh mesh = read(read_stl, text);
  EXPECT_EQ(mesh.points.size(), 1u + 3 * 999u);
  for (std::size_t i = 0; i < mesh.corners.size(); ++i) {
    std::array<double, 3> expected{};
    expected[i % 3] = static_cast<double>(i / 3 % 1000);
    ASSERT_EQ(mesh.points[mesh.corners[i]], expected);
  }
}

TEST(ReadStl, NamesLineAndFaultOfBadText) {
  const auto with = [](const std::string& from, const std::string& to) {
    std::string text = "solid\n" + kFacet + "endsolid\n";
    return text.replace(text.find(from), from.size(), to);
  };
  const std::string neither = "m: expected text that begins with solid, or binary of 84 + 50 n bytes, found ";
  const std::pair<std::string, std::string> cases[] = {
      {"", neither + "0 bytes"},
      {"sol", neither + "3 bytes"},
      {std::string("solid\n\0", 7), neither + "7 bytes"},
      {"solid\n", "m:1: expected facet or endsolid, found the end of the file"},
      {"solid\nendsolid\n", "m:2: expected at least one face, found the end of the file"},
      {"solid\n" + kFacet, "m:8: expected facet or endsolid, found the end of the file"},
      {"solid\n" + kFacet + "endsolid\nfacet\n", "m:10: expected solid, found 'facet'"},
      {"solidity\n", "m:1: expected solid, found 'solidity'"},
      {with("facet", "face"), "m:2: expected facet or endsolid, found 'face'"},
      {with("outer loop", "outer"), "m:3: expected loop, found the end of the line"},
      {with("outer loop", "inner loop"), "m:3: expected outer, found 'inner'"},
      {with("outer loop", "outer loop 1"), "m:3: expected the end of the line, found '1'"},
      {with("vertex 0 0 0\n", ""), "m:6: expected vertex, found 'endloop'"},
      {with("endloop", "vertex 0 0 0"), "m:7: expected endloop, found 'vertex'"},
      {with("endfacet", "facet"), "m:8: expected endfacet, found 'facet'"},
      {with("1 0 0", "1 0"), "m:5: expected a finite number for z, found the end of the line"},
      {with("1 0 0", "1 0 0 0"), "m:5: expected the end of the line, found '0'"},
      {with("1 0 0", "1 0 nan"), "m:5: expected a finite number for z, found 'nan'"},
      {with("1 0 0", "1e999 0 0"), "m:5: expected a finite number for x, found '1e999'"},
      {with("1 0 0", "1 0.0.0 0"), "m:5: expected a finite number for y, found '0.0.0'"},
      {"solid\n" + kFacet.substr(0, 60), "m:5: expected a finite number for x, found the end of the line"},
  };
  for (const auto& [text, expected] : cases) EXPECT_EQ(complaint(read_stl, text), expected) << text;
}

TEST(ReadStl, NamesByteAndFaultOfBadBytes) {
  const std::string face = stl_face({0, 0, 0, 1, 0, 0, 0, 1, 0});
  const float inf = std::numeric_limits<float>::infinity();
  EXPECT_EQ(
      complaint(read_stl, stl_prefix("", 2) + face),
      "m: expected text that begins with solid, or binary of 84 + 50 n bytes for n = 2, found 134 bytes");
  EXPECT_EQ(
      complaint(read_stl, stl_prefix("", 1) + face + "x"),
      "m: expected text that begins with solid, or binary of 84 + 50 n bytes for n = 1, found 135 bytes");
  EXPECT_EQ(complaint(read_stl, stl_prefix("solid", 4'000'000'000) + face + face),
            "m: expected text that begins with solid, or binary of 84 + 50 n bytes for n = 4000000000, found "
            "184 bytes");
  EXPECT_EQ(complaint(read_stl, stl_prefix("", 0)), "m: expected at least one face, found 0 at byte 80");
  EXPECT_EQ(complaint(read_stl, stl_prefix("", 2) + face + stl_face({0, 0, 0, 0, std::nanf(""), 0, 0, 0, 0})),
            "m: expected a finite coordinate, found nan at byte 162");
  EXPECT_EQ(complaint(read_stl, stl_prefix("", 1) + stl_face({0, 0, 0, 0, 0, 0, 0, 0, -inf})),
            "m: expected a finite coordinate, found -inf at byte 128");
}

}  // namespace
}  // namespace gnomon::scene
