// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "reports/picture_parts.h"

namespace gnomon::reports {
namespace {

constexpr double kCells = 4;  // from the middle to each side
constexpr double kHalf = InsetPicture::kSize / 2;
constexpr double kPixels = kHalf / kCells;  // one cell

struct Point {
  double x = 0, y = 0;  // in cells, the corner at the origin, y upward
};

std::string place(const Point& p) {
  return svg_number(kHalf + p.x * kPixels) + " " + svg_number(kHalf - p.y * kPixels);
}

std::string path_of(const std::vector<Point>& polygon) {
  std::string d;
  for (const Point& p : polygon) d += (d.empty() ? "M" : "L") + place(p);
  return d.empty() ? d : d + "Z";
}

std::vector<Point> square() {
  return {{-kCells, -kCells}, {kCells, -kCells}, {kCells, kCells}, {-kCells, kCells}};
}

/// The part of a convex polygon where a x + b y + c <= 0 (Sutherland and Hodgman). The polygon never leaves
/// the frame, so the arithmetic stays as fine as the picture whatever the case's coordinates are.
std::vector<Point> clip(const std::vector<Point>& polygon, double a, double b, double c) {
  std::vector<Point> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double vp = a * p.x + b * p.y + c, vq = a * q.x + b * q.y + c;
    if (vp <= 0) kept.push_back(p);
    if ((vp < 0 && vq > 0) || (vp > 0 && vq < 0)) {
      const double t = vp / (vp - vq);
      kept.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
    }
  }
  return kept;
}

/// How many ulps a cell is, as a power of two: 1 while the line is then in sight and apart from the corner.
int cell_exponent(double offset) {
  const double size = std::abs(offset);
  if (size == 0 || (size >= 0.125 && size <= 3)) return 0;
  return static_cast<int>(std::floor(std::log2(size / 0.75)));
}

/// Offsets, in cells, of the floating-point numbers beside x; empty when they lie too close together to be
/// drawn.
std::vector<double> floats_beside(double x, const ShaftCase& shaft, double ulp, double cells_per_ulp) {
  std::vector<double> offsets;
  constexpr double kLegible = 5 / kPixels;  // cells: 5 pixels
  for (const int direction : {-1, 1}) {
    double at = 0;
    for (int step = 1;; ++step) {
      const double next = (neighbour(x, direction * step, shaft.single) - x) / ulp * cells_per_ulp;
      if (std::abs(next - at) < kLegible) {
        if (at == 0) return {};
        break;
      }
      if (!(std::abs(next) <= kCells)) break;
      offsets.push_back(at = next);
    }
  }
  offsets.push_back(0);
  std::sort(offsets.begin(), offsets.end());
  return offsets;
}

std::string grid(const std::vector<double>& across, const std::vector<double>& upward, bool dotted) {
  std::string lines, dots;
  for (const double x : across) lines += fmt::format("M{}V{:.0f}", place({x, kCells}), 2 * kHalf);
  for (const double y : upward) lines += fmt::format("M{}H{:.0f}", place({-kCells, y}), 2 * kHalf);
  for (const double x : across) {
    if (!dotted) break;
    for (const double y : upward) dots += "M" + place({x, y}) + "h0";
  }
  std::string out;
  if (!lines.empty()) out += fmt::format("<path class=\"gp-grid\" d=\"{}\"/>", lines);
  if (!dots.empty()) out += fmt::format("<path class=\"gp-dots\" d=\"{}\"/>", dots);
  return out;
}

struct Grid {
  std::string svg;
  bool floats = false;  // the dots are the floating-point numbers; else the lines are a plain scale
};

Grid grid_of(const ShaftCase& shaft, const DecidingView& view, double ulp, double cells_per_ulp) {
  std::vector<double> cells;
  for (double k = -kCells; k <= kCells; ++k) cells.push_back(k);
  if (shaft.ball) return {grid(cells, cells, false), false};  // the point is not a floating-point number
  const std::vector<double> across = floats_beside(view.corner[0], shaft, ulp, cells_per_ulp);
  const std::vector<double> upward = floats_beside(view.corner[1], shaft, ulp, cells_per_ulp);
  const bool floats = !across.empty() && !upward.empty();
  return {floats ? grid(across, upward, true) : grid(cells, cells, false), floats};
}

/// T near the corner: a box fills the quadrant behind the corner as far as it reaches, a ball lies behind its
/// arc.
std::string target(const ShaftCase& shaft, const DecidingView& view, double ulp, double cells_per_ulp) {
  const auto cells = [&](double length) { return std::min(length / ulp * cells_per_ulp, 1e4); };
  if (shaft.ball) {
    const double r = cells(shaft.ball->radius), nx = view.to_centre_x, ny = view.to_centre_y;
    std::vector<Point> disc;
    const double reach = std::min(r, 2 * kCells);
    constexpr int kSteps = 48;
    for (int i = -kSteps; i <= kSteps; ++i) {
      const double t = reach * i / kSteps;
      const double depth =
          r > 0 ? t * t / (r + std::sqrt(std::max(0.0, r * r - t * t))) : 0;  // r - sqrt(r^2 - t^2)
      disc.push_back({depth * nx - t * ny, depth * ny + t * nx});
    }
    const bool whole = r <= reach;  // then the arc above is half of the circle
    for (int i = kSteps; i >= -kSteps; --i) {
      const double t = reach * i / kSteps;
      const double depth = whole ? r + std::sqrt(std::max(0.0, r * r - t * t)) : 4 * kCells;
      disc.push_back({depth * nx - t * ny, depth * ny + t * nx});
    }
    return fmt::format("<path class=\"gp-t\" d=\"{}\"/>", path_of(disc));
  }
  const int right = view.projection.right, up = view.projection.up;
  const auto side = [&](double end, double corner) {
    return std::clamp((end - corner) / ulp * cells_per_ulp, -1e4, 1e4);
  };
  const double x0 = side(shaft.box->lo(right), view.corner[0]),
               x1 = side(shaft.box->hi(right), view.corner[0]);
  const double y0 = side(shaft.box->lo(up), view.corner[1]), y1 = side(shaft.box->hi(up), view.corner[1]);
  return fmt::format("<path class=\"gp-t\" d=\"{}\"/>", path_of({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}));
}

std::string ulps(double n) {
  return n >= 1 && n < 1e5 ? fmt::format("{:.0f} ulp", n) : fmt::format("{:.3g} ulp", n);
}

std::string scale_text(const ShaftCase& shaft, int exponent, bool floats) {
  if (!floats) return fmt::format("squares of {}", ulps(std::ldexp(1.0, exponent)));
  return fmt::format("dots: {} numbers; {} wide", shaft.single ? "float32" : "float64",
                     ulps(std::ldexp(2 * kCells, exponent)));
}

}  // namespace

InsetPicture inset(const ShaftCase& shaft, const DecidingView& view) {
  const int exponent = cell_exponent(view.line.offset);
  const double cells_per_ulp = std::ldexp(1.0, -exponent), ulp = shaft.ulp();
  const auto in_cells = [&](double ulps) { return std::clamp(ulps * cells_per_ulp, -1e6, 1e6); };

  std::vector<Point> region = square();
  for (const LocalLine& side : view.sides)
    region = clip(region, side.normal_x, side.normal_y, in_cells(side.offset));
  InsetPicture picture;
  std::string& out = picture.svg;
  out += fmt::format("<rect class=\"gp-paper\" width=\"{0:.0f}\" height=\"{0:.0f}\"/>", InsetPicture::kSize);
  if (region.size() > 1) {
    out += fmt::format("<path class=\"gp-shaft{}\" d=\"{}\"/>", region.size() == 2 ? " edge" : "",
                       path_of(region));
  }
  out += target(shaft, view, ulp, cells_per_ulp);
  const Grid lines = grid_of(shaft, view, ulp, cells_per_ulp);
  out += lines.svg;

  // The deciding line, right across the frame; its foot is the point of it that is nearest to the corner.
  const double nx = view.line.normal_x, ny = view.line.normal_y, c = in_cells(view.line.offset);
  const Point foot{-c * nx, -c * ny};
  out += fmt::format("<path class=\"gp-line\" d=\"M{}L{}\"/>", place({foot.x - 12 * ny, foot.y + 12 * nx}),
                     place({foot.x + 12 * ny, foot.y - 12 * nx}));
  if (c != 0) out += fmt::format("<path class=\"gp-foot\" d=\"M{}L{}\"/>", place({0, 0}), place(foot));
  out += fmt::format("<circle class=\"gp-corner\" cx=\"{0:.0f}\" cy=\"{0:.0f}\" r=\"4.5\"/>", kHalf);
  const Point say_in{foot.x - 2.6 * nx + 1.5 * ny, foot.y - 2.6 * ny - 1.5 * nx};
  const Point say_out{foot.x + 2.6 * nx + 1.5 * ny, foot.y + 2.6 * ny - 1.5 * nx};
  const auto say = [&](const Point& p, const char* text) {
    const Point inside{std::clamp(p.x, -kCells + 1.2, kCells - 1.2),
                       std::clamp(p.y, -kCells + 0.4, kCells - 0.6)};
    out += fmt::format("<text class=\"gp-side\" x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>",
                       svg_number(kHalf + inside.x * kPixels), svg_number(kHalf - inside.y * kPixels), text);
  };
  say(say_in, "shaft's side");
  say(say_out, "outside");
  out += fmt::format("<rect class=\"gp-frame\" width=\"{0:.0f}\" height=\"{0:.0f}\"/>", InsetPicture::kSize);
  picture.scale = scale_text(shaft, exponent, lines.floats);
  return picture;
}

}  // namespace gnomon::reports
