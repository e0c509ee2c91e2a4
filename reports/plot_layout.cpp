// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/plot_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace gnomon::reports {
namespace {

constexpr double kLetter = 6.4;  // pixels: a generous mean width of a letter at the labels' 11.5 px
constexpr double kLine = 13;     // pixels from one line of text to the next
constexpr double kMark = 7;      // pixels: half a mark and a gap
constexpr int kMostShifts = 32;  // places tried up and down from a mark: half the panel at most

struct Area {
  double x0, y0, x1, y1;

  [[nodiscard]] bool meets(const Area& other) const {
    return x0 < other.x1 && other.x0 < x1 && y0 < other.y1 && other.y0 < y1;
  }
};

std::string power_of_ten(int exponent) {
  if (exponent == 0) return "1";
  constexpr std::array kDigits = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char digit : std::to_string(std::abs(exponent)))
    text += kDigits.at(static_cast<std::size_t>(digit - '0'));
  return text;
}

std::string time_label(double ns) {
  if (ns < 1000) return fmt::format("{:g}", ns);
  return ns < 1e6 ? fmt::format("{:g}k", ns / 1e3) : fmt::format("{:g}M", ns / 1e6);
}

}  // namespace

std::string PlotPoint::label() const {
  return off ? fmt::format("← {} ({:.2g} ns)", method, true_ns) : method;
}

double LogAxis::share(double value) const {
  if (!(value > lo)) return 0;
  return value >= hi ? 1 : std::log(value / lo) / std::log(hi / lo);
}

std::vector<PlotPoint> plot_points(std::span<const Summary> summaries, Measure measure) {
  std::vector<PlotPoint> points;
  for (const Summary& s : summaries) {
    const Share& errors = measure == Measure::kCulls     ? s.culls
                          : measure == Measure::kInsides ? s.insides
                                                         : s.wasted;
    if (!s.ns || *s.ns <= 0 || errors.n == 0) continue;
    points.push_back({s.label, s.tier, s.scalar, s.distribution, *s.ns, false, *s.ns, errors});
  }
  return points;
}

std::vector<ReferenceLine> reference_lines(std::span<const Summary> summaries) {
  std::map<std::string, std::vector<double>> times;
  for (const Summary& s : summaries) {
    if (s.reference_ns && *s.reference_ns > 0) times[s.scalar].push_back(*s.reference_ns);
  }
  std::vector<ReferenceLine> lines;
  for (auto& [scalar, list] : times) {
    std::nth_element(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(list.size() / 2), list.end());
    lines.push_back({"reference, " + scalar, list[list.size() / 2]});
  }
  const auto [least, most] = std::minmax_element(lines.begin(), lines.end(),
                                                 [](const auto& a, const auto& b) { return a.ns < b.ns; });
  if (!lines.empty() && most->ns <= 1.25 * least->ns)
    return {{"exact reference", (most->ns + least->ns) / 2}};
  return lines;
}

LogAxis time_axis(std::span<const PlotPoint> points, std::span<const ReferenceLine> references) {
  double least = std::numeric_limits<double>::infinity(), most = 0;
  const auto hold = [&](double ns) {
    if (ns > 0) least = std::min(least, ns), most = std::max(most, ns);
  };
  for (const PlotPoint& point : points) {
    if (point.tier != "trivial") hold(point.ns);
  }
  for (const ReferenceLine& line : references) hold(line.ns);
  for (const PlotPoint& point : points) {
    if (most == 0 || point.ns * 20 > least) hold(point.ns);  // near enough to the others, or there are none
  }
  LogAxis axis;
  if (most == 0) return axis;
  axis.lo = least / 2.5;
  axis.hi = most * 2;
  const bool wide = axis.hi / axis.lo > 300;  // ticks at 1, 10, 100, ... suffice
  for (int e = static_cast<int>(std::floor(std::log10(axis.lo))); std::pow(10.0, e) <= axis.hi; ++e) {
    for (const double digit : {1.0, 2.0, 5.0}) {
      const double tick = digit * std::pow(10.0, e);
      if (tick >= axis.lo && tick <= axis.hi && (digit == 1 || !wide))
        axis.ticks.emplace_back(tick, time_label(tick));
    }
  }
  return axis;
}

LogAxis error_axis(std::span<const PlotPoint> points) {
  double least = 0.05;
  for (const PlotPoint& point : points) {
    least = std::min(
        least, point.errors.k == 0 ? point.height() : std::max(point.errors.rate.low95, point.height() / 10));
  }
  const int bottom = static_cast<int>(std::floor(std::log10(std::max(least, 1e-300)) - 0.35));
  LogAxis axis{std::pow(10.0, bottom), 2.0, {}};  // room above rate 1
  const int step = bottom < -9 ? 2 : 1;
  for (int e = 0; e >= bottom; e -= step) axis.ticks.emplace_back(std::pow(10.0, e), power_of_ten(e));
  return axis;
}

void pull_in(PlotPanel& panel) {
  for (PlotPoint& p : panel.points) {
    p.off = p.ns < panel.x.lo;
    if (p.off) p.ns = panel.x.lo * std::pow(panel.x.hi / panel.x.lo, 0.03);
  }
}

void place_labels(PlotPanel& panel) {
  std::vector<Area> taken;
  const auto at = [&](const PlotPoint& p) {
    return std::pair(panel.x.share(p.ns) * PlotPanel::kWidth,
                     (1 - panel.y.share(p.height())) * PlotPanel::kHeight);
  };
  for (const PlotPoint& p : panel.points) {
    const auto [x, y] = at(p);
    // A zero's mark has an arrow below it.
    taken.push_back({x - kMark + 1, y - kMark + 1, x + kMark - 1, y + (p.errors.k == 0 ? 22 : kMark - 1)});
  }
  for (const ReferenceLine& line : panel.references) {
    const double x = panel.x.share(line.ns) * PlotPanel::kWidth;
    taken.push_back({x - 16, 0, x + 2, kLetter * static_cast<double>(line.label.size()) + 4});
  }
  for (PlotPoint& p : panel.points) {
    const auto [x, y] = at(p);
    const double width = kLetter * static_cast<double>(p.label().size());
    double best_cost = std::numeric_limits<double>::infinity();
    Area best{};
    // From near to far: beside the mark, then further up and down on either side, then above it.
    for (int k = 0; k <= kMostShifts; ++k) {
      const double shift = (k % 2 == 0 ? 1 : -1) * ((k + 1) / 2) * kLine * 0.75;
      const struct {
        double dx, dy;
        const char* anchor;
      } places[] = {
          {kMark + 2, 4 + shift, "start"}, {-kMark - 2, 4 + shift, "end"}, {0, -10 + shift, "middle"}};
      for (const auto& place : places) {
        const double left = x + place.dx -
                            (*place.anchor == 's'   ? 0
                             : *place.anchor == 'e' ? width
                                                    : width / 2);
        const Area area{left, y + place.dy - 10, left + width, y + place.dy + 3};
        double cost = 3 * k + (*place.anchor == 's' ? 0 : *place.anchor == 'e' ? 1 : 2);
        for (const Area& other : taken) cost += area.meets(other) ? 100 : 0;
        if (area.x0 < 2 || area.x1 > PlotPanel::kWidth || area.y0 < 0 || area.y1 > PlotPanel::kHeight)
          cost += 150;
        if (cost >= best_cost) continue;
        best_cost = cost;
        best = area;
        p.label_dx = place.dx;
        p.label_dy = place.dy;
        p.label_anchor = place.anchor;
      }
    }
    taken.push_back(best);
  }
}

}  // namespace gnomon::reports
