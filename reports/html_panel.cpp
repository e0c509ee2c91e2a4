// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/html_panel.h"

#include <fmt/format.h>

#include <cmath>

#include "reports/html_text.h"

namespace gnomon::reports {
namespace {

constexpr double kLeft = 50, kTop = 28, kRight = 10, kBottom = 44;  // pixels around the panel

/// Filled or hollow: circle for f32, square for f64, diamond for everything else.
std::string mark(const PlotPoint& p, double x, double y) {
  const std::string classes = fmt::format("mark t-{}{}", escaped(p.tier), p.errors.k == 0 ? " zero" : "");
  if (p.scalar == "f32")
    return fmt::format("<circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"5\"/>", classes, x, y);
  const char* shape =
      p.scalar == "f64" ? "M{:.1f} {:.1f}m-4.5-4.5h9v9h-9z" : "M{:.1f} {:.1f}m0-6 6 6-6 6-6-6z";
  return fmt::format("<path class=\"{}\" d=\"{}\"/>", classes, fmt::format(fmt::runtime(shape), x, y));
}

std::string tooltip(const PlotPoint& p) {
  return fmt::format("{} ({}): {}, {} [95 %: {} to {}]; {}", p.method, p.tier, share_text(p.errors),
                     rate_text(p.errors.rate.value), rate_text(p.errors.rate.low95),
                     rate_text(p.errors.rate.high95), time_text(p.true_ns));
}

std::string axes(const PlotPanel& panel, const PanelText& text) {
  const double width = PlotPanel::kWidth, height = PlotPanel::kHeight;
  std::string out = fmt::format("<text class=\"title\" x=\"0\" y=\"-12\">{}</text>", text.title);
  for (const auto& [value, label] : panel.y.ticks) {
    const double y = (1 - panel.y.share(value)) * height;
    out += fmt::format(
        "<path class=\"grid\" d=\"M0 {0:.1f}H{1:.0f}\"/><text class=\"tick\" x=\"-6\" y=\"{2:.1f}\" "
        "text-anchor=\"end\">{3}</text>",
        y, width, y + 4, label);
  }
  for (const auto& [value, label] : panel.x.ticks) {
    const double x = panel.x.share(value) * width;
    out += fmt::format(
        "<path class=\"grid\" d=\"M{0:.1f} 0V{1:.0f}\"/><text class=\"tick\" x=\"{0:.1f}\" y=\"{2:.0f}\" "
        "text-anchor=\"middle\">{3}</text>",
        x, height, height + 15, label);
  }
  out += fmt::format("<path class=\"frame\" d=\"M0 0V{0:.0f}H{1:.0f}\"/>", height, width);
  out += fmt::format("<text class=\"tick\" x=\"{:.0f}\" y=\"{:.0f}\" text-anchor=\"middle\">{} (log)</text>",
                     width / 2, height + 34, text.time);
  out += fmt::format(
      "<text class=\"tick\" transform=\"translate(-38 {:.0f}) rotate(-90)\" text-anchor=\"middle\">{} "
      "(log)</text>",
      height / 2, text.axis);
  for (const ReferenceLine& line : panel.references) {
    const double x = panel.x.share(line.ns) * width;
    out += fmt::format(
        "<path class=\"reference\" d=\"M{0:.1f} 0V{1:.0f}\"/><text class=\"tick\" "
        "transform=\"translate({2:.1f} 2) rotate(-90)\" text-anchor=\"end\">{3}</text>",
        x, height, x - 5, escaped(line.label));
  }
  return out;
}

}  // namespace

std::string panel_svg(const PlotPanel& panel, const PanelText& text, const std::string& what) {
  std::string out = fmt::format(
      "<svg class=\"plot\" role=\"img\" aria-label=\"{} against time for {}\" viewBox=\"0 0 {:.0f} "
      "{:.0f}\"><g transform=\"translate({:.0f} {:.0f})\">",
      text.title, escaped(what), kLeft + PlotPanel::kWidth + kRight, kTop + PlotPanel::kHeight + kBottom,
      kLeft, kTop);
  out += axes(panel, text);
  for (const PlotPoint& p : panel.points) {
    const auto height = [&](double rate) { return (1 - panel.y.share(rate)) * PlotPanel::kHeight; };
    const double x = panel.x.share(p.ns) * PlotPanel::kWidth, y = height(p.height());
    const std::string tier = escaped(p.tier);
    out += fmt::format("<g><title>{}</title>", escaped(tooltip(p)));
    if (p.errors.k == 0) {
      out += fmt::format("<path class=\"whisker t-{}\" d=\"M{:.1f} {:.1f}v14m-3.5-4.5 3.5 4.5 3.5-4.5\"/>",
                         tier, x, y + 5);
    } else {
      out += fmt::format("<path class=\"whisker t-{}\" d=\"M{:.1f} {:.1f}V{:.1f}\"/>", tier, x,
                         height(p.errors.rate.low95), height(p.errors.rate.high95));
    }
    out += mark(p, x, y);
    // A label that had to move away is tied to its mark.
    if (std::abs(p.label_dy - 4) > 16) {
      out += fmt::format("<path class=\"leader\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"/>", x, y, x + p.label_dx,
                         y + p.label_dy - 4);
    }
    out += fmt::format("<text class=\"label\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text></g>",
                       x + p.label_dx, y + p.label_dy, p.label_anchor, escaped(p.label()));
  }
  return out + "</g></svg>\n";
}

}  // namespace gnomon::reports
