// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/text_picture.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "reports/deciding_view.h"

namespace gnomon::reports {

namespace {

constexpr int kColumns = 64, kRows = 24;

/// A rectangle of character cells, both ends included.
struct Cells {
  int left, right, bottom, top;
};

class Canvas {
 public:
  Canvas(const ShaftCase& c, int right, int up)
      : right_(right), up_(up), rows_(kRows, std::string(kColumns, ' ')) {
    take(c.a);
    take(c.b);
    if (c.box) take(*c.box);
    if (c.ball) {
      for (const int sign : {-1, 1}) {
        take(c.ball->centre[static_cast<std::size_t>(right_)] + sign * c.ball->radius,
             c.ball->centre[static_cast<std::size_t>(up_)] + sign * c.ball->radius);
      }
    }
    // Halves: the width of the largest numbers would overflow.
    width_ = std::max(hi_x_ / 2 - lo_x_ / 2, std::numeric_limits<double>::min());
    height_ = std::max(hi_y_ / 2 - lo_y_ / 2, std::numeric_limits<double>::min());
  }

  void fill_shaft(const ShaftCase& c) {
    const std::size_t i = static_cast<std::size_t>(right_), j = static_cast<std::size_t>(up_);
    for (int step = 0; step <= 400; ++step) {
      const double s = step / 400.0;
      const auto at = [&](std::size_t face) { return c.a.c[face] * (1 - s) + c.b.c[face] * s; };
      rectangle(cells(at(i), at(i + 3), at(j), at(j + 3)), '.', true);
    }
  }
  void outline(const scene::Box<double>& box, char mark) {
    const std::size_t i = static_cast<std::size_t>(right_), j = static_cast<std::size_t>(up_);
    rectangle(cells(box.c[i], box.c[i + 3], box.c[j], box.c[j + 3]), mark, false);
  }
  void outline(const scene::Ball<double>& ball) {
    for (int step = 0; step < 720; ++step) {
      const double angle = step * 3.14159265358979 / 360;
      const double x = ball.centre[static_cast<std::size_t>(right_)] + ball.radius * std::cos(angle);
      const double y = ball.centre[static_cast<std::size_t>(up_)] + ball.radius * std::sin(angle);
      const Cells cell = cells(x, x, y, y);
      put(cell.left, cell.bottom, 'T');
    }
  }
  [[nodiscard]] std::string text() const {
    std::string all;
    for (auto row = rows_.rbegin(); row != rows_.rend(); ++row) {
      all += "  |" + *row;
      all.erase(all.find_last_not_of(' ') + 1);
      all += '\n';
    }
    return all;
  }

 private:
  void take(double x, double y) {
    // A ball's side may lie beyond the largest number.
    constexpr double kMost = std::numeric_limits<double>::max();
    x = std::clamp(x, -kMost, kMost);
    y = std::clamp(y, -kMost, kMost);
    lo_x_ = std::min(lo_x_, x);
    hi_x_ = std::max(hi_x_, x);
    lo_y_ = std::min(lo_y_, y);
    hi_y_ = std::max(hi_y_, y);
  }
  void take(const scene::Box<double>& box) {
    take(box.lo(right_), box.lo(up_));
    take(box.hi(right_), box.hi(up_));
  }
  [[nodiscard]] static int cell(double x, double lo, double half_width, int count) {
    const double share = (x / 2 - lo / 2) / half_width;
    // Balls at the end of the range reach beyond it: infinities and NaN are drawn at an edge.
    if (!(share > 0)) return 0;
    if (share >= 1) return count - 1;
    return static_cast<int>(share * (count - 1) + 0.5);
  }
  [[nodiscard]] Cells cells(double x0, double x1, double y0, double y1) const {
    return {cell(x0, lo_x_, width_, kColumns), cell(x1, lo_x_, width_, kColumns),
            cell(y0, lo_y_, height_, kRows), cell(y1, lo_y_, height_, kRows)};
  }
  void rectangle(const Cells& r, char mark, bool filled) {
    for (int y = r.bottom; y <= r.top; ++y) {
      for (int x = r.left; x <= r.right; ++x) {
        if (filled || y == r.bottom || y == r.top || x == r.left || x == r.right) put(x, y, mark);
      }
    }
  }
  void put(int x, int y, char mark) {
    char& here = rows_[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
    here = mark == 'T' && here == '.' ? '#' : mark;
  }

  int right_, up_;
  double lo_x_ = HUGE_VAL, hi_x_ = -HUGE_VAL, lo_y_ = HUGE_VAL, hi_y_ = -HUGE_VAL, width_ = 1, height_ = 1;
  std::vector<std::string> rows_;
};

}  // namespace

std::string text_picture(const ShaftCase& c) {
  const DecidingView view = deciding_view(c);
  Canvas canvas(c, view.projection.right, view.projection.up);
  canvas.fill_shaft(c);
  canvas.outline(c.a, 'A');
  canvas.outline(c.b, 'B');
  if (c.box) canvas.outline(*c.box, 'T');
  if (c.ball) canvas.outline(*c.ball);
  const char* const names = "xyz";
  std::string text = std::string("seen along ") + names[view.projection.along] + " (" +
                     names[view.projection.right] + " to the right, " + names[view.projection.up] +
                     " up); . shaft, # T on it\n";
  return text + canvas.text();
}

}  // namespace gnomon::reports
