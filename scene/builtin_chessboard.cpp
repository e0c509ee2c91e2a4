// SPDX-License-Identifier: MIT
// Chessboards on tables, with all pieces: turned ones, balls on some, and knights of concave outline.
#include <string_view>

#include "scene/builtin_list.h"
#include "scene/modeller.h"

namespace gnomon::scene {
namespace {

constexpr std::uint32_t kSides = 16;  // of turned pieces
constexpr double kPitch = 14;         // from board to board, in squares

constexpr std::size_t turned_faces(std::size_t rings) {
  return 2 * kSides * (rings - 1) + 2 * (kSides - 2);
}

// Radius and height of each ring, in squares.
constexpr Point2 kPawn[] = {{0.3125, 0}, {0.3125, 0.09375}, {0.1875, 0.1875}, {0.125, 0.5}, {0.1875, 0.5625}};
constexpr Point2 kRook[] = {{0.34375, 0},     {0.34375, 0.125}, {0.25, 0.21875},
                            {0.1875, 0.6875}, {0.28125, 0.75},  {0.28125, 0.875}};
constexpr Point2 kBishop[] = {{0.34375, 0},     {0.34375, 0.125}, {0.21875, 0.25}, {0.125, 0.78125},
                              {0.21875, 0.875}, {0.21875, 1},     {0.0625, 1.25}};
constexpr Point2 kQueen[] = {{0.375, 0},      {0.375, 0.125},    {0.25, 0.28125},  {0.15625, 1},
                             {0.25, 1.09375}, {0.1875, 1.15625}, {0.28125, 1.375}, {0.125, 1.4375}};
constexpr Point2 kKing[] = {{0.375, 0},    {0.375, 0.125},  {0.25, 0.28125}, {0.15625, 1.0625},
                            {0.25, 1.125}, {0.25, 1.21875}, {0.1875, 1.5}};
constexpr Point2 kFoot[] = {{0.34375, 0}, {0.34375, 0.125}, {0.25, 0.1875}};
// A horse's head from the side: breast, mouth, ears, mane.
constexpr Point2 kHead[] = {{0.1875, 0.1875}, {0.125, 0.4375}, {0.1875, 0.625},  {0.34375, 0.5625},
                            {0.375, 0.6875},  {0.1875, 0.875}, {0.125, 1},       {0.0625, 0.90625},
                            {-0.125, 0.8125}, {-0.21875, 0.5}, {-0.1875, 0.1875}};

constexpr std::size_t kPieceFaces =
    16 * (turned_faces(std::size(kPawn)) + 1) + 4 * (turned_faces(std::size(kRook)) + 4 * 12) +
    4 * (turned_faces(std::size(kBishop)) + 1) +
    4 * (turned_faces(std::size(kFoot)) + 4 * std::size(kHead) - 4) +
    2 * (turned_faces(std::size(kQueen)) + 1) + 2 * (turned_faces(std::size(kKing)) + 2 * 12);
constexpr std::size_t kBoardFaces = 12 * (64 + 4 + 1 + 4) + kPieceFaces;

void add_piece(Modeller& modeller, char kind, const Placement& placement) {
  modeller.place(placement);
  const auto turned = [&modeller](const char* name, std::span<const Point2> profile) {
    modeller.object(name, Shape::concave);
    modeller.turned(profile, kSides);
  };
  switch (kind) {
    case 'p':
      turned("pawn", kPawn);
      modeller.ball({0, 0, 0.71875}, 0.171875);
      break;
    case 'r':
      turned("rook", kRook);
      for (const double x : {-0.15625, 0.0625}) {
        for (const double y : {-0.15625, 0.0625}) modeller.box({x, y, 0.875}, {x + 0.09375, y + 0.09375, 1});
      }
      break;
    case 'n': {
      turned("knight", kFoot);
      std::vector<Point3> rings[2];
      for (const Point2& p : kHead) {
        rings[0].push_back({p[0], 0.125, p[1]});
        rings[1].push_back({p[0], -0.125, p[1]});
      }
      modeller.loft(rings);
      break;
    }
    case 'b':
      turned("bishop", kBishop);
      modeller.ball({0, 0, 1.3125}, 0.078125);
      break;
    case 'q':
      turned("queen", kQueen);
      modeller.ball({0, 0, 1.515625}, 0.09375);
      break;
    default:
      turned("king", kKing);
      modeller.box({-0.03125, -0.03125, 1.5}, {0.03125, 0.03125, 1.8125});
      modeller.box({-0.125, -0.0390625, 1.625}, {0.125, 0.0390625, 1.6875});
  }
}

/// A board with its corner at (x, y), its squares' upper sides at height 0, on a table.
void add_board(Modeller& modeller, double x, double y) {
  constexpr double kRim = 0.5, kThick = 0.25, kTable = 10;
  modeller.place({x, y});
  for (int row = 0; row < 8; ++row) {
    for (int column = 0; column < 8; ++column) {
      modeller.object((row + column) % 2 == 0 ? "dark square" : "light square", Shape::convex);
      modeller.box({1.0 * column, 1.0 * row, -kThick}, {column + 1.0, row + 1.0, 0});
    }
  }
  const auto part = [&modeller](const char* name, const Point3& lo, const Point3& hi) {
    modeller.object(name, Shape::convex);
    modeller.box(lo, hi);
  };
  part("rim", {-kRim, -kRim, -kThick}, {8 + kRim, 0, 0.0625});
  part("rim", {-kRim, 8, -kThick}, {8 + kRim, 8 + kRim, 0.0625});
  part("rim", {-kRim, 0, -kThick}, {0, 8, 0.0625});
  part("rim", {8, 0, -kThick}, {8 + kRim, 8, 0.0625});
  part("table", {-1.5, -1.5, -1}, {9.5, 9.5, -kThick});
  for (const double u : {-1.0, 8.375}) {
    for (const double v : {-1.0, 8.375}) part("leg", {u, v, -kTable}, {u + 0.625, v + 0.625, -1});
  }
  // After 1. e4 e5 2. Nf3 Nc6.
  constexpr std::string_view kRows[] = {"rnbqkb.r", "pppp.ppp", ".....n..", "....p...",
                                        "....p...", "..n.....", "pppp.ppp", "r.bqkbnr"};
  for (std::size_t row = 0; row < 8; ++row) {
    const double facing = row < 4 ? 1 : -1;  // knights look across the board
    for (std::size_t column = 0; column < 8; ++column) {
      const char kind = kRows[row][column];
      if (kind == '.') continue;
      const Placement placement{x + static_cast<double>(column) + 0.5, y + static_cast<double>(row) + 0.5, 0,
                                0, facing};
      add_piece(modeller, kind, placement);
    }
  }
}

Scene make(std::uint32_t size) {
  Modeller modeller(0x1p-10);
  const double hall = kPitch * size;
  modeller.object("floor", Shape::convex);
  modeller.box({-6, -6, -10.5}, {hall + 4, hall + 4, -10});
  for (std::uint32_t row = 0; row < size; ++row) {
    for (std::uint32_t column = 0; column < size; ++column) {
      add_board(modeller, kPitch * column, kPitch * row);
    }
  }
  modeller.place({});
  const double end = hall - kPitch + 8;
  for (const double x : {-4.0, end + 4}) {
    for (const double y : {-5.0, end + 5}) modeller.point_light({x, y, 9 + x / 64});
  }
  modeller.view({end / 2 - 6, -9.0 - size, 8.0 + size}, {end / 2, end / 2, 0}, 40);
  return modeller.finish();
}

}  // namespace

BuiltinScene chessboard_scene() {
  return {"chessboard",
          "boards with all pieces, on tables: turned pieces, balls, concave knights",
          "boards along each side of the hall",
          "light buffer, \"Chessboard\" (132 objects, 4944 polygons, 4 lights)",
          1,
          20,
          [](std::uint32_t size) { return 12 + kBoardFaces * size * size; },
          make};
}

}  // namespace gnomon::scene
