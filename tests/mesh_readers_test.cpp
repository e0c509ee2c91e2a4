// SPDX-License-Identifier: GPL-3.0-or-later
// The readers of text formats, OFF and OBJ, and read_mesh: good files, and the exact complaint about every
// kind of bad one. PLY and STL: mesh_readers_binary_test.cpp.
#include "scene/read_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

#include "scene/input_error.h"
#include "scene/line_reader.h"
#include "tests/mesh_readers_checks.h"

namespace gnomon::scene {
namespace {

// ----------------------------------------------------------------------------------------------------------
// OFF

TEST(ReadOff, TakesPlainText) {
  EXPECT_EQ(read(read_off, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), kTriangle);
}

TEST(ReadOff, TakesCountsOnTheHeaderLineCommentsBlankLinesCrLfAndNoLastNewline) {
  EXPECT_EQ(read(read_off,
                 "# made by hand\r\n\r\nOFF 4 2\r\n0 0 0 # origin\r\n+1 0 0\r\n\t1 1. 0\r\n\r\n0 1e0 .1\r\n"
                 "4 0 1 2 3 # quad\r\n3 2 1 0"),
            kTwoFaces);
}

TEST(ReadOff, DropsNormalsColoursAndTextureCoordinates) {
  EXPECT_EQ(read(read_off,
                 "STCNOFF\n3 1 0\n0 0 0 nan 0 1 9 9 9 1 .5 .5\n1 0 0 0 0 1 9 9 9 1 0 0\n"
                 "0 1 0 0 0 1 9 9 9 1 0 0\n3 0 1 2 255 0 0 .5\n"),
            kTriangle);
  EXPECT_EQ(read(read_off, "OFF\n3 1 0\n0 0 0 1 0 0\n1 0 0 1 0 0\n0 1 0 1 0 0\n3 0 1 2 7\n"), kTriangle);
}

TEST(ReadOff, KeepsDegenerateAndDuplicateFacesAndUnusedPoints) {
  const Mesh mesh = read(read_off, "OFF\n2 3 0\n0 0 0\n1 1 1\n3 0 0 0\n3 0 0 0\n4 0 0 0 0\n");
  EXPECT_EQ(mesh.face_count(), 3u);
  EXPECT_EQ(mesh.points.size(), 2u);
}

TEST(ReadOff, RoundsEachNumberOnceToNearest) {
  // Halfway between two doubles, just above it, the least denormal, below half of it, and signs of zero.
  const Mesh mesh =
      read(read_off,
           "OFF\n3 1 0\n9007199254740993 9007199254740993.00000000000000000001 4.9e-324\n"
           "2e-324 -1e-999999999999999999999 -0\n1.7976931348623157e308 0.1 0e99999999999999999999\n"
           "3 0 1 2\n");
  EXPECT_EQ(mesh.points[0][0], 9007199254740992.0);
  EXPECT_EQ(mesh.points[0][1], 9007199254740994.0);
  EXPECT_EQ(mesh.points[0][2], std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(mesh.points[1][0], 0.0);
  EXPECT_TRUE(std::signbit(mesh.points[1][1]) && std::signbit(mesh.points[1][2]));
  EXPECT_EQ(mesh.points[2][0], std::numeric_limits<double>::max());
  EXPECT_EQ(mesh.points[2][1], 0.1);
  EXPECT_EQ(mesh.points[2][2], 0.0);
}

TEST(ReadOff, TellsOverflowFromUnderflowWhateverTheExponentSays) {
  const std::string zeros(400, '0');
  const std::string rest = " 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  EXPECT_EQ(read(read_off, "OFF 3 1\n0." + zeros + "1e50" + rest), kTriangle);
  EXPECT_EQ(read(read_off, "OFF 3 1\n-0." + zeros + "1" + rest), kTriangle);
  for (const std::string& word :
       {"1" + zeros, "1" + zeros + "e-50", "1" + zeros + "." + zeros, std::string(".1e+310")}) {
    EXPECT_EQ(complaint(read_off, "OFF 3 1\n" + word + rest),
              "m:2: expected a finite number for x, found '" +
                  (word.size() > 40 ? word.substr(0, 40) + "..." : word) + "'");
  }
}

TEST(ReadOff, TakesAFaceOf100000CornersAndRefusesALongerLineThanTheCap) {
  std::string text = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n100000";
  for (int i = 0; i < 100'000; ++i) text += " 00000002";
  EXPECT_EQ(read(read_off, text).face(0).size(), 100'000u);
  EXPECT_EQ(complaint(read_off, "OFF\n" + std::string(LineReader::kMaxLineBytes + 1, ' ') + "\n3 1 0\n"),
            "m:2: expected a line of at most 1048576 bytes, found a longer one");
}

TEST(ReadOff, NamesLineAndFaultOfBadInput) {
  const std::string points = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n";
  const std::string header = "expected the header OFF, with or without ST, C, N before it, found ";
  const std::pair<std::string, std::string> cases[] = {
      {"", "m: " + header + "the end of the file"},
      {"\n# x\n", "m:2: " + header + "the end of the file"},
      {"ply\n", "m:1: " + header + "'ply'"},
      {"4OFF\n", "m:1: " + header + "'4OFF'"},
      {"3 1 0\n", "m:1: " + header + "'3'"},
      {"OFF BINARY\n", "m:1: expected a number of vertices from 1 to 4294967295, found 'BINARY'"},
      {"OFF\n", "m:1: expected the numbers of vertices and faces, found the end of the file"},
      {"OFF\n3\n", "m:2: expected a number of faces from 1 to 4294967295, found the end of the line"},
      {"OFF\n0 1 0\n", "m:2: expected a number of vertices from 1 to 4294967295, found '0'"},
      {"OFF\n3 0 0\n", "m:2: expected a number of faces from 1 to 4294967295, found '0'"},
      {"OFF\n-3 1 0\n", "m:2: expected a number of vertices from 1 to 4294967295, found '-3'"},
      {"OFF\n99999999999999999999 1 0\n",
       "m:2: expected a number of vertices from 1 to 4294967295, found '99999999999999999999'"},
      {"OFF\n3 1 x\n", "m:2: expected a number of edges from 0 to 9223372036854775807, found 'x'"},
      {"OFF\n3 1 0 0\n", "m:2: expected the end of the line, found '0'"},
      {"OFF\n3 1 0\n0 0\n", "m:3: expected a finite number for z, found the end of the line"},
      {"OFF\n3 1 0\n0 nan 0\n", "m:3: expected a finite number for y, found 'nan'"},
      {"OFF\n3 1 0\n-inf 0 0\n", "m:3: expected a finite number for x, found '-inf'"},
      {"OFF\n3 1 0\n0 0 -1e309\n", "m:3: expected a finite number for z, found '-1e309'"},
      {"OFF\n3 1 0\n0 0 0.00001e9999999999999999999999\n",
       "m:3: expected a finite number for z, found '0.00001e9999999999999999999999'"},
      {"OFF\n3 1 0\n0 1.5x 0\n", "m:3: expected a finite number for y, found '1.5x'"},
      {"OFF\n3 1 0\n0 1,5 0\n", "m:3: expected a finite number for y, found '1,5'"},
      {"OFF\n3 1 0\n0x10 1 0\n", "m:3: expected a finite number for x, found '0x10'"},
      {"OFF\n3 1 0\n+-1 1 0\n", "m:3: expected a finite number for x, found '+-1'"},
      {"OFF\n3 1 0\n\x01 1 0\n", "m:3: expected a finite number for x, found '\\x01'"},
      {"OFF\n3 1 0\n" + std::string(50, 'q'),
       "m:3: expected a finite number for x, found '" + std::string(40, 'q') + "...'"},
      {"OFF\n3 1 0\n0 0 0 red\n", "m:3: expected a number or the end of the line, found 'red'"},
      {"OFF\n3 1 0\n0 0 0 1 2 3 4 5 6 7 8 9 10\n", "m:3: expected the end of the line, found '10'"},
      {"OFF\n3 1 0\n0 0 0\n1 0 0\n", "m:4: expected vertex 3 of 3, found the end of the file"},
      {"OFF 4294967295 4294967295", "m:1: expected vertex 1 of 4294967295, found the end of the file"},
      {"OFF 3 4294967295\n0 0 0\n0 0 0\n0 0 0\n4294967295 0",
       "m:5: expected a vertex index from 0 to 2, found the end of the line"},
      {points, "m:5: expected face 1 of 1, found the end of the file"},
      {points + "3 0 1 3\n", "m:6: expected a vertex index from 0 to 2, found '3'"},
      {points + "3 0 1 -1\n", "m:6: expected a vertex index from 0 to 2, found '-1'"},
      {points + "3 0 1 1.0\n", "m:6: expected a vertex index from 0 to 2, found '1.0'"},
      {points + "3 0 1\n", "m:6: expected a vertex index from 0 to 2, found the end of the line"},
      {points + "2 0 1\n", "m:6: expected a number of corners from 3 to 4294967295, found '2'"},
      {points + "3 0 1 2 red\n", "m:6: expected a number or the end of the line, found 'red'"},
      {points + "3 0 1 2 1 2 3 4 5\n", "m:6: expected the end of the line, found '5'"},
      {points + "3 0 1 2\n\n3 2 1 0\n", "m:8: expected the end of the file after face 1, found '3'"},
  };
  for (const auto& [text, expected] : cases) EXPECT_EQ(complaint(read_off, text), expected) << text;
}

// ----------------------------------------------------------------------------------------------------------
// OBJ

TEST(ReadObj, TakesEveryFormOfCornerAndNegativeIndices) {
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (const char* face : {"f 1 2 3", "f 1/1 2/2 3/3", "f 1/1/1 2/2/2 3/3/3", "f 1//1 2//2 3//3",
                           "f -3 -2 -1", "f -3/-1/-1 2//1 -1", "f 1 2 3 # flat", "  f\t1 2 3\r"}) {
    EXPECT_EQ(read(read_obj, points + face + "\n"), kTriangle) << face;
  }
}

TEST(ReadObj, SkipsOtherStatementsJoinsContinuedLinesAndTakesForwardReferences) {
  EXPECT_EQ(
      read(
          read_obj,
          "# C:\\meshes\\\nmtllib a.mtl\no thing\ng a b\ns off\nusemtl red#1\nvn 0 0 1\nvt 0 0\nvp 1\nl 1 2\n"
          "p 1\ncstype bezier\n\nf 1 2\\\n3 \\\r\n4\nv 0 0 0 1\nv 1 0 0 .5 .5 .5\nv 1 1 0 1 1 1 1\n"
          "v 0 1 \\\n.1\nf 3 2 1"),
      kTwoFaces);
}

TEST(ReadObj, NamesLineAndFaultOfBadInput) {
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const std::string corner = "expected a corner v, v/vt, v/vt/vn or v//vn, found ";
  const std::pair<std::string, std::string> cases[] = {
      {"", "m: expected at least one face, found the end of the file"},
      {points, "m:3: expected at least one face, found the end of the file"},
      {points + "face 1 2 3\n", "m:4: expected a statement of the OBJ format, found 'face'"},
      {points + "call other.obj\n", "m:4: expected a statement of the OBJ format, found 'call'"},
      {"OFF\n", "m:1: expected a statement of the OBJ format, found 'OFF'"},
      {"v 0 0\n", "m:1: expected a finite number for z, found the end of the line"},
      {"v 0 inf 0\n", "m:1: expected a finite number for y, found 'inf'"},
      {"v 0 0 1e400\n", "m:1: expected a finite number for z, found '1e400'"},
      {"v 0 0 0 w\n", "m:1: expected a number or the end of the line, found 'w'"},
      {"v 0 0 0 1 1\n",
       "m:1: expected x y z and then nothing, a weight, or 3 or 4 colour components, found 5 numbers"},
      {points + "f 1 2\n", "m:4: expected a face of at least 3 corners, found 2"},
      {points + "f\n", "m:4: expected a face of at least 3 corners, found 0"},
      {points + "f 1 2 0\n", "m:4: expected a vertex index other than 0 and not below -3, found '0'"},
      {points + "f 1 2 -4\n", "m:4: expected a vertex index other than 0 and not below -3, found '-4'"},
      {points + "f 1 2 4294967296\n",
       "m:4: expected a vertex index other than 0 and not below -3, found '4294967296'"},
      {points + "f 1 2 4\nf 1 2 5\nf 1 2 3\nv 0 0 0\n",
       "m:7: expected vertex 5, which the face on line 5 has as a corner, found only 4 vertices"},
      {points + "f 1 2 4\n",
       "m:4: expected vertex 4, which the face on line 4 has as a corner, found only 3 vertices"},
      {points + "f 1 2 3 \\# no end\nf 1 2 3\n", "m:4: " + corner + "'\\'"},
      {points + "f 1 2 x\n", "m:4: " + corner + "'x'"},
      {points + "f 1 2 3.5\n", "m:4: " + corner + "'3.5'"},
      {points + "f 1 2 3/\n", "m:4: " + corner + "'3/'"},
      {points + "f 1 2 3//\n", "m:4: " + corner + "'3//'"},
      {points + "f 1 2 3/0\n", "m:4: " + corner + "'3/0'"},
      {points + "f 1 2 3/1/\n", "m:4: " + corner + "'3/1/'"},
      {points + "f 1 2 3/1/1/1\n", "m:4: " + corner + "'3/1/1/1'"},
      {points + "f 1 2 3/1/x\n", "m:4: " + corner + "'3/1/x'"},
      {points + "f 1 \\\n2 \\\nx\n", "m:6: " + corner + "'x'"},
      {points + "f 1 2 3 \\\n",
       "m:4: expected the line that a backslash continues, found the end of the file"},
  };
  for (const auto& [text, expected] : cases) EXPECT_EQ(complaint(read_obj, text), expected) << text;
  std::string joined = "g";
  for (int i = 0; i < 3; ++i) joined += std::string(LineReader::kMaxLineBytes / 2, ' ') + "\\\n";
  EXPECT_EQ(complaint(read_obj, joined), "m:2: expected a line of at most 1048576 bytes, found a longer one");
}

// ---------------------------------------------------------------------------------------------------
// read_mesh

class ReadMesh : public testing::Test {
 protected:
  ReadMesh() { std::filesystem::create_directories(folder_); }
  ~ReadMesh() override { std::filesystem::remove_all(folder_); }

  std::string complaint_about(const std::string& name) const {
    try {
      (void)read_mesh(folder_ / name);
    } catch (const InputError& error) {
      const std::string what = error.what();
      const std::string path = (folder_ / name).string();
      return what.starts_with(path) ? what.substr(path.size()) : what;
    }
    return "no complaint";
  }

  std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) /
      ("gnomon_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
};

TEST_F(ReadMesh, ChoosesTheReaderByExtensionInAnyCase) {
  std::ofstream(folder_ / "a.OFF") << "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  std::ofstream(folder_ / "b.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  std::ofstream(folder_ / "c.Ply")
      << "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
         "property float z\nelement face 1\nproperty list uchar int vertex_index\n"
         "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  std::ofstream(folder_ / "d.stl") << "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                                      "vertex 0 1 0\nendloop\nendfacet\nendsolid\n";
  for (const char* name : {"a.OFF", "b.obj", "c.Ply", "d.stl"})
    EXPECT_EQ(read_mesh(folder_ / name), kTriangle) << name;
}

TEST_F(ReadMesh, ComplainsAboutTheFileAsAWhole) {
  std::filesystem::create_directories(folder_ / "folder.off");
  std::ofstream(folder_ / "mesh.gltf") << "{}";
  std::ofstream(folder_ / "wrong.stl") << "OFF\n3 1 0\n";
  std::ofstream(folder_ / "wrong.off") << "solid\n";
  std::ofstream(folder_ / "empty.ply");
  EXPECT_EQ(complaint_about("none.off"), ": expected a file, found none");
  EXPECT_EQ(complaint_about("folder.off"), ": expected a file, found a directory");
  EXPECT_EQ(complaint_about("mesh.gltf"), ": expected the extension .off, .obj, .ply or .stl, found '.gltf'");
  EXPECT_EQ(complaint_about("mesh"), ": expected the extension .off, .obj, .ply or .stl, found none");
  EXPECT_EQ(complaint_about("wrong.stl"),
            ": expected text that begins with solid, or binary of 84 + 50 n bytes, found 10 bytes");
  EXPECT_EQ(complaint_about("wrong.off"),
            ":1: expected the header OFF, with or without ST, C, N before it, found 'solid'");
  EXPECT_EQ(complaint_about("empty.ply"), ": expected ply, found the end of the file");
}

}  // namespace
}  // namespace gnomon::scene
