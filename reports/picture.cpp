// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/picture_parts.h"

namespace gnomon::reports {
namespace {

constexpr double kGutter = 16;
constexpr double kWidth = OverviewPicture::kWidth + kGutter + InsetPicture::kSize + 6;

/// Class names start with gp- because a style inside an SVG reaches the whole page that it stands in.
constexpr const char* kStyle = R"(<style>
.gp{--gp-ink:#1c2430;--gp-soft:#5b6675;--gp-line:#c3cad4;--gp-paper:#fff;--gp-a:#2457a8;--gp-b:#0b7285;--gp-t:#c2410c;--gp-cut:#b0126f;--gp-shaft:#8a97a8;
font:12px system-ui,sans-serif;color:var(--gp-ink)}
@media (prefers-color-scheme:dark){.gp{--gp-ink:#e6eaf0;--gp-soft:#a3aebd;--gp-line:#434d5b;--gp-paper:#12171e;--gp-a:#86b2ff;--gp-b:#5cd0e0;--gp-t:#ff9a5c;--gp-cut:#ff7ac6;--gp-shaft:#7f8da0}}
@media print{.gp{--gp-ink:#1c2430;--gp-soft:#5b6675;--gp-line:#c3cad4;--gp-paper:#fff;--gp-a:#2457a8;--gp-b:#0b7285;--gp-t:#c2410c;--gp-cut:#b0126f;--gp-shaft:#8a97a8}}
.gp text{fill:var(--gp-ink)}.gp .gp-tick{fill:var(--gp-soft);font-size:10.5px}.gp .gp-axis-name{font-style:italic;font-size:13px;fill:var(--gp-ink)}
.gp .gp-side{fill:var(--gp-soft);font-size:11px}.gp .gp-text{fill:var(--gp-soft)}.gp .gp-strong{font-weight:600}
.gp .gp-name{font-weight:700;font-size:15px;text-anchor:middle;paint-order:stroke;stroke:var(--gp-paper);stroke-width:3px}
.gp .gp-ink-a{fill:var(--gp-a)}.gp .gp-ink-b{fill:var(--gp-b)}.gp .gp-ink-t{fill:var(--gp-t)}
.gp-shaft{fill:var(--gp-shaft);fill-opacity:.22;stroke:var(--gp-shaft);stroke-width:1.2}
.gp-a{fill:var(--gp-a);fill-opacity:.2;stroke:var(--gp-a);stroke-width:1.5}.gp-b{fill:var(--gp-b);fill-opacity:.2;stroke:var(--gp-b);stroke-width:1.5}
.gp-t{fill:var(--gp-t);fill-opacity:.22;stroke:var(--gp-t);stroke-width:1.5}.gp .edge{stroke-width:4;stroke-linecap:round}
.gp-corner{fill:var(--gp-ink)}.gp-ring{fill:none;stroke:var(--gp-cut);stroke-width:1.5}.gp-axis{fill:none;stroke:var(--gp-soft)}
.gp-paper{fill:var(--gp-paper)}.gp-frame{fill:none;stroke:var(--gp-cut);stroke-width:1.5}.gp-grid{fill:none;stroke:var(--gp-line);stroke-width:.6}
.gp-dots{fill:none;stroke:var(--gp-soft);stroke-width:3;stroke-linecap:round}.gp-line{stroke:var(--gp-cut);stroke-width:2;fill:none}
.gp .gp-thin{stroke-width:1;stroke-dasharray:6 3}
.gp-foot{stroke:var(--gp-ink);stroke-width:1.2;stroke-dasharray:3 2}
</style>)";

struct Text {
  std::string headline, detail;
};

/// What the small picture shows, in words.
Text verdict(const ShaftCase& shaft, const DecidingView& view) {
  const bool inside = view.decision == Decision::kInside;
  const char* what = shaft.box ? inside ? "Far corner" : "Near corner"
                     : inside  ? "Farthest point"
                               : "Nearest point";
  if (view.sign == 0) return {fmt::format("{} exactly on the line", what), "touching: closed sets meet"};
  // A gap too small for a double still has its sign.
  const std::string size = view.gap == 0 ? "below any double" : fmt::format("{:.4g} ulp", std::abs(view.gap));
  return {fmt::format("{} {}", what, view.sign > 0 ? "outside" : "on the shaft's side"),
          fmt::format("decided exactly; gap {}", size)};
}

std::string legend(double x, double y) {
  const struct {
    const char *look, *text;
    double shift;
  } entries[] = {{"gp-a", "A", 0}, {"gp-b", "B", 34}, {"gp-shaft", "shaft", 68}, {"gp-t", "T", 128}};
  std::string out;
  for (const auto& e : entries) {
    out += fmt::format(
        "<rect class=\"{}\" x=\"{}\" y=\"{}\" width=\"11\" height=\"11\"/><text x=\"{}\" y=\"{}\">{}</text>",
        e.look, svg_number(x + e.shift), svg_number(y - 10), svg_number(x + e.shift + 15), svg_number(y),
        e.text);
  }
  out += fmt::format("<path class=\"gp-line\" d=\"M{} {}h14\"/><text x=\"{}\" y=\"{}\">line</text>",
                     svg_number(x + 162), svg_number(y - 4), svg_number(x + 180), svg_number(y));
  return out;
}

}  // namespace

std::string svg_number(double x) {
  constexpr double kFar = 1e5;
  if (std::isnan(x)) x = 0;
  std::string text = fmt::format("{:.2f}", std::clamp(x, -kFar, kFar));
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string case_picture_svg(std::string_view question, std::span<const double> numbers,
                             std::string_view scalar, PictureFocus focus) {
  const std::optional<ShaftCase> shaft = shaft_case(question, numbers, scalar);
  if (!shaft) return {};
  const DecidingView view = deciding_view(*shaft, focus);
  const OverviewPicture whole = overview(*shaft, view);
  const Text text = verdict(*shaft, view);
  const bool visible = std::abs(view.line.offset) * whole.pixels_per_ulp > 24;  // no magnification needed

  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"gp\" role=\"img\" aria-label=\"{} {}\" "
      "viewBox=\"0 0 {:.0f} {:.0f}\">",
      text.headline, text.detail, kWidth, OverviewPicture::kHeight);
  out += kStyle;
  out += whole.svg;
  const double x = OverviewPicture::kWidth + kGutter;
  double y = 18;
  if (!visible) {
    const InsetPicture close = inset(*shaft, view);
    // A nested svg clips at its edge.
    out += fmt::format(
        "<svg x=\"{0}\" y=\"24\" width=\"{1:.0f}\" height=\"{1:.0f}\" viewBox=\"-1 -1 {2:.0f} "
        "{2:.0f}\">{3}</svg>",
        svg_number(x), InsetPicture::kSize + 2, InsetPicture::kSize + 2, close.svg);
    out += fmt::format(
        "<text class=\"gp-text\" x=\"{0}\" y=\"13\">around the ring</text><text class=\"gp-tick\" x=\"{0}\" "
        "y=\"{1:.0f}\">{2}</text>",
        svg_number(x), InsetPicture::kSize + 40, close.scale);
    y = InsetPicture::kSize + 60;
  } else {
    out += fmt::format("<text class=\"gp-text\" x=\"{}\" y=\"40\">Wide enough to be seen as it is.</text>",
                       svg_number(x));
    y = 66;
  }
  out += fmt::format(
      "<text class=\"gp-strong\" x=\"{0}\" y=\"{1}\">{2}</text><text x=\"{0}\" y=\"{3}\">{4}</text>",
      svg_number(x), svg_number(y), text.headline, svg_number(y + 17), text.detail);
  out += legend(x, y + 41);
  return out + "</svg>";
}

}  // namespace gnomon::reports
