// SPDX-License-Identifier: GPL-3.0-or-later
// Labels of many methods at one place: each can be read, and is tied to its mark.
#include "reports/plot_layout.h"

#include <gtest/gtest.h>

#include <cmath>

#include "reports/html_panel.h"

namespace gnomon::reports {
namespace {

struct Label {
  double x0, x1, y;
};

/// Where a label lies, by a letter's width of 6 pixels.
Label label_of(const PlotPanel& panel, const PlotPoint& point) {
  const double width = 6.0 * static_cast<double>(point.label().size());
  const double at = panel.x.share(point.ns) * PlotPanel::kWidth + point.label_dx;
  const double left = point.label_anchor == "start" ? at
                      : point.label_anchor == "end" ? at - width
                                                    : at - width / 2;
  return {left, left + width, (1 - panel.y.share(point.height())) * PlotPanel::kHeight + point.label_dy};
}

TEST(PlotLayout, KeepsTheLabelsOfACrowdApartAndInside) {
  for (const std::size_t count : {1UL, 6UL, 14UL}) {
    PlotPanel panel;
    for (std::size_t i = 0; i < count; ++i) {
      PlotPoint point;
      point.method = "method-name-" + std::to_string(i);
      point.tier = "peer";
      point.scalar = "f32";
      point.ns = point.true_ns = 100;
      point.errors = share_of(0, 5000);
      panel.points.push_back(point);
    }
    panel.x = time_axis(panel.points, {});
    panel.y = error_axis(panel.points);
    place_labels(panel);
    for (std::size_t i = 0; i < count; ++i) {
      const Label a = label_of(panel, panel.points[i]);
      EXPECT_TRUE(a.x0 >= 0 && a.x1 <= PlotPanel::kWidth && a.y >= 0 && a.y <= PlotPanel::kHeight) << i;
      for (std::size_t j = 0; j < i; ++j) {
        const Label b = label_of(panel, panel.points[j]);
        EXPECT_TRUE(a.x1 <= b.x0 || b.x1 <= a.x0 || std::abs(a.y - b.y) >= 11) << i << " " << j;
      }
    }
    const bool tied =
        panel_svg(panel, {"title", "axis"}, "test").find("class=\"leader\"") != std::string::npos;
    EXPECT_EQ(tied, count > 5) << count;
  }
}

}  // namespace
}  // namespace gnomon::reports
