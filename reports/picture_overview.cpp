// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/picture_parts.h"

namespace gnomon::reports {
namespace {

constexpr double kLeft = 34, kTop = 24, kRight = 12, kBottom = 34;  // pixels around the drawing
constexpr const char* kAxes = "xyz";

/// The picture's coordinates along one axis. Numbers are first scaled by a power of two (exact), so that
/// neither 1e308 nor 5e-324 does any harm.
class Scale {
 public:
  Scale(double lo, double hi, int exponent) : exponent_(exponent), lo_(small(lo)), hi_(small(hi)) {}

  [[nodiscard]] double extent() const { return hi_ - lo_; }
  void fit(double pixels_per_unit, double from, double length, bool flip) {
    factor_ = flip ? -pixels_per_unit : pixels_per_unit;
    shift_ = from + length / 2 - factor_ * (lo_ + hi_) / 2;
  }
  [[nodiscard]] double at(double x) const { return factor_ * small(x) + shift_; }
  [[nodiscard]] double length(double x) const { return std::abs(factor_) * small(x); }
  [[nodiscard]] double lo() const { return factor_ * lo_ + shift_; }
  [[nodiscard]] double hi() const { return factor_ * hi_ + shift_; }

 private:
  [[nodiscard]] double small(double x) const { return std::ldexp(x, -exponent_); }

  int exponent_;
  double lo_, hi_, factor_ = 1, shift_ = 0;
};

struct Frame {
  Scale right, up;
  bool apart = false;  // the axes have scales of their own
};

/// The least and most of A, B and T on an axis; ball bounds stay within double's range.
std::pair<double, double> bounds(const ShaftCase& shaft, int axis) {
  double lo = std::min(shaft.a.lo(axis), shaft.b.lo(axis)), hi = std::max(shaft.a.hi(axis), shaft.b.hi(axis));
  if (shaft.box) lo = std::min(lo, shaft.box->lo(axis)), hi = std::max(hi, shaft.box->hi(axis));
  if (shaft.ball) {
    constexpr double kMost = std::numeric_limits<double>::max();
    const double c = shaft.ball->centre.at(static_cast<std::size_t>(axis)), r = shaft.ball->radius;
    lo = std::min(lo, std::max(c - r, -kMost));
    hi = std::max(hi, std::min(c + r, kMost));
  }
  return {lo, hi};
}

Frame frame_of(const ShaftCase& shaft, const Silhouette& s) {
  const auto [x0, x1] = bounds(shaft, s.right);
  const auto [y0, y1] = bounds(shaft, s.up);
  const double most = std::max({std::abs(x0), std::abs(x1), std::abs(y0), std::abs(y1)});
  const int exponent = most > 0 ? std::ilogb(most) : 0;
  Frame frame{{x0, x1, exponent}, {y0, y1, exponent}, false};
  const double width = OverviewPicture::kWidth - kLeft - kRight,
               height = OverviewPicture::kHeight - kTop - kBottom;
  const double a = frame.right.extent(), b = frame.up.extent();
  // One scale for both axes keeps angles true; beyond 1 : 15 it would make a thread of the case.
  constexpr double kThread = 15;
  frame.apart = a > 0 && b > 0 && (a > kThread * b || b > kThread * a);
  const auto pixels = [](double extent, double length) { return extent > 0 ? 0.9 * length / extent : 1.0; };
  double px = pixels(a, width), py = pixels(b, height);
  if (!frame.apart) {
    if (a == 0) px = py;
    if (b == 0) py = px;
    px = py = std::min(px, py);
  }
  frame.right.fit(px, kLeft, width, false);
  frame.up.fit(py, kTop, height, true);
  return frame;
}

std::string rectangle(const Frame& f, const scene::Box<double>& box, const Silhouette& s, const char* look) {
  const double x0 = f.right.at(box.lo(s.right)), x1 = f.right.at(box.hi(s.right));
  const double y0 = f.up.at(box.hi(s.up)), y1 = f.up.at(box.lo(s.up));
  std::string out = fmt::format("<rect class=\"{}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>", look,
                                svg_number(x0), svg_number(y0), svg_number(x1 - x0), svg_number(y1 - y0));
  // A flat or pointlike box still leaves a mark.
  if (x1 - x0 < 1.5 || y1 - y0 < 1.5) {
    out += fmt::format("<path class=\"{} edge\" d=\"M{} {}L{} {}\"/>", look, svg_number(x0), svg_number(y0),
                       svg_number(x1), svg_number(y1));
  }
  return out;
}

std::string letter(double x, double y, const char* name, const char* look) {
  x = std::clamp(x, 8.0, OverviewPicture::kWidth - 8);
  y = std::clamp(y, 12.0, OverviewPicture::kHeight - 30);
  return fmt::format("<text class=\"gp-name {}\" x=\"{}\" y=\"{}\">{}</text>", look, svg_number(x),
                     svg_number(y), name);
}

/// The shortest decimal that gives the number back, or nine digits when that is long.
std::string decimal(double x, bool single) {
  const std::string text = single ? fmt::format("{}", static_cast<float>(x)) : fmt::format("{}", x);
  return text.size() <= 11 ? text : fmt::format("{:.9g}", x);
}

/// An axis with its ends and name; along its own direction, from 0 to `length` pixels.
std::string axis(char name, double lo, double hi, double length, bool single) {
  const std::string from = decimal(lo, single), to = decimal(hi, single);
  const auto text = [](double x, const char* anchor, const std::string& what) {
    return fmt::format("<text class=\"gp-tick\" x=\"{}\" y=\"13\" text-anchor=\"{}\">{}</text>",
                       svg_number(x), anchor, what);
  };
  constexpr double kLetter = 6.2;  // pixels: the mean width of a digit
  if (lo == hi) return text(length / 2, "middle", fmt::format("{} = {}", name, from));
  const double longer = kLetter * static_cast<double>(std::max(from.size(), to.size()) + 1);
  if (longer > length / 2) return text(length / 2, "middle", fmt::format("{}: {} to {}", name, from, to));
  return text(0, "start", from) +
         text(length / 2, "middle", fmt::format("<tspan class=\"gp-axis-name\">{}</tspan>", name)) +
         text(length, "end", to);
}

std::string axes(const ShaftCase& shaft, const Silhouette& s, const Frame& f) {
  const auto [x0, x1] = bounds(shaft, s.right);
  const auto [y0, y1] = bounds(shaft, s.up);
  const double across = f.right.hi() - f.right.lo(), upward = f.up.lo() - f.up.hi();
  return fmt::format("<g transform=\"translate({} {})\"><path class=\"gp-axis\" d=\"M0 0H{}\"/>{}</g>",
                     svg_number(f.right.lo()), svg_number(OverviewPicture::kHeight - kBottom + 4),
                     svg_number(across), axis(kAxes[s.right], x0, x1, across, shaft.single)) +
         fmt::format(
             "<g transform=\"translate({} {}) rotate(-90)\"><path class=\"gp-axis\" d=\"M0 0H{}\"/><g "
             "transform=\"translate(0 -18)\">{}</g></g>",
             svg_number(kLeft - 6), svg_number(f.up.lo()), svg_number(upward),
             axis(kAxes[s.up], y0, y1, upward, shaft.single));
}

/// The deciding line from edge to edge; one ulp is `right` and `up` pixels.
std::string deciding_line(const DecidingView& view, double cx, double cy, double right, double up) {
  const LocalLine& line = view.line;
  const double foot_x = cx - line.offset * line.normal_x * right,
               foot_y = cy + line.offset * line.normal_y * up;
  double dx = -line.normal_y * right, dy = -line.normal_x * up;
  const double length = std::max(std::abs(dx), std::abs(dy));
  if (!(length > 0) || !std::isfinite(foot_x) || !std::isfinite(foot_y)) return "";
  constexpr double kReach = 2 * OverviewPicture::kHeight;
  dx *= kReach / length;
  dy *= kReach / length;
  const double width = OverviewPicture::kWidth - kLeft - kRight + 12,
               height = OverviewPicture::kHeight - kTop - kBottom;
  // A nested svg clips at its edge.
  return fmt::format(
      "<svg x=\"{0}\" y=\"{1}\" width=\"{2}\" height=\"{3}\" viewBox=\"{0} {1} {2} {3}\"><path "
      "class=\"gp-line gp-thin\" d=\"M{4} {5}L{6} {7}\"/></svg>",
      svg_number(kLeft), svg_number(kTop), svg_number(width), svg_number(height), svg_number(foot_x - dx),
      svg_number(foot_y - dy), svg_number(foot_x + dx), svg_number(foot_y + dy));
}

}  // namespace

OverviewPicture overview(const ShaftCase& shaft, const DecidingView& view) {
  const Silhouette& s = view.projection;
  const Frame f = frame_of(shaft, s);
  OverviewPicture picture;
  std::string& out = picture.svg;

  std::string hull;
  for (const ExactPoint& corner : s.corners) {
    hull += fmt::format("{}{} {}", hull.empty() ? "M" : "L",
                        svg_number(f.right.at(corner.x.convert_to<double>())),
                        svg_number(f.up.at(corner.y.convert_to<double>())));
  }
  out += fmt::format("<path class=\"gp-shaft\" d=\"{}Z\"/>", hull);
  out += rectangle(f, shaft.a, s, "gp-a") + rectangle(f, shaft.b, s, "gp-b");
  const auto middle = [](const Scale& scale, const scene::Box<double>& box, int axis) {
    return (scale.at(box.lo(axis)) + scale.at(box.hi(axis))) / 2;
  };
  double tx = 0, ty = 0;
  if (shaft.box) {
    out += rectangle(f, *shaft.box, s, "gp-t");
    tx = middle(f.right, *shaft.box, s.right);
    ty = middle(f.up, *shaft.box, s.up);
  } else {
    tx = f.right.at(shaft.ball->centre.at(static_cast<std::size_t>(s.right)));
    ty = f.up.at(shaft.ball->centre.at(static_cast<std::size_t>(s.up)));
    out += fmt::format("<ellipse class=\"gp-t\" cx=\"{}\" cy=\"{}\" rx=\"{}\" ry=\"{}\"/>", svg_number(tx),
                       svg_number(ty), svg_number(f.right.length(shaft.ball->radius)),
                       svg_number(f.up.length(shaft.ball->radius)));
  }
  const double cx = f.right.at(view.corner[0]), cy = f.up.at(view.corner[1]);
  out += deciding_line(view, cx, cy, f.right.length(shaft.ulp()), f.up.length(shaft.ulp()));
  out += fmt::format(
      "<circle class=\"gp-corner\" cx=\"{0}\" cy=\"{1}\" r=\"3\"/><circle class=\"gp-ring\" cx=\"{0}\" "
      "cy=\"{1}\" r=\"8\"/>",
      svg_number(cx), svg_number(cy));

  const double ax = middle(f.right, shaft.a, s.right), ay = middle(f.up, shaft.a, s.up);
  double bx = middle(f.right, shaft.b, s.right), by = middle(f.up, shaft.b, s.up);
  const auto close = [](double x, double y) { return std::abs(x) < 12 && std::abs(y) < 12; };
  if (close(ax - bx, ay - by)) bx += 16;
  if (close(ax - tx, ay - ty) || close(bx - tx, by - ty)) ty -= 18;
  if (close(cx - tx, cy - ty)) tx += 14, ty -= 12;
  out += letter(ax, ay + 5, "A", "gp-ink-a") + letter(bx, by + 5, "B", "gp-ink-b") +
         letter(tx, ty + 5, "T", "gp-ink-t");

  out += axes(shaft, s, f);
  out +=
      fmt::format("<text class=\"gp-text\" x=\"{}\" y=\"13\">seen along {}{}</text>", svg_number(kLeft - 6),
                  kAxes[s.along], f.apart ? "; the axes have scales of their own" : "");
  picture.pixels_per_ulp = std::max(f.right.length(shaft.ulp()), f.up.length(shaft.ulp()));
  return picture;
}

}  // namespace gnomon::reports
