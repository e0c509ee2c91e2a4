// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "reports/html_sections.h"
#include "reports/html_text.h"
#include "reports/plot_layout.h"

namespace gnomon::reports {
namespace {

constexpr double kLeft = 50, kTop = 28, kRight = 10, kBottom = 44;  // pixels around the panel

struct PanelText {
  Measure measure;
  const char* title;
  const char* axis;
};

constexpr PanelText kPanels[] = {
    {Measure::kCulls, "Unsound: culled though it meets", "false culls / cases that are not outside"},
    {Measure::kInsides, "Unsound: “inside” though it is not", "false insides / cases that are not inside"},
    {Measure::kWaste, "Waste: kept though outside", "kept / cases that are exactly outside"},
};

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
  out += fmt::format(
      "<text class=\"tick\" x=\"{:.0f}\" y=\"{:.0f}\" text-anchor=\"middle\">ns per case (log)</text>",
      width / 2, height + 34);
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

std::string panel_svg(const PlotPanel& panel, const PanelText& text, const std::string& question) {
  std::string out = fmt::format(
      "<svg class=\"plot\" role=\"img\" aria-label=\"{} against time for {}\" viewBox=\"0 0 {:.0f} "
      "{:.0f}\"><g transform=\"translate({:.0f} {:.0f})\">",
      text.title, escaped(question), kLeft + PlotPanel::kWidth + kRight, kTop + PlotPanel::kHeight + kBottom,
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
    out += fmt::format("<text class=\"label\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text></g>",
                       x + p.label_dx, y + p.label_dy, p.label_anchor, escaped(p.label()));
  }
  return out + "</g></svg>\n";
}

nlohmann::json axis_json(const LogAxis& axis) {
  nlohmann::json ticks = nlohmann::json::array();
  for (const auto& [value, label] : axis.ticks) ticks.push_back({{"v", value}, {"l", label}});
  return {{"lo", axis.lo}, {"hi", axis.hi}, {"ticks", ticks}};
}

nlohmann::json points_json(std::span<const PlotPoint> points) {
  nlohmann::json list = nlohmann::json::array();
  for (const PlotPoint& p : points) {
    list.push_back({{"m", p.method},
                    {"t", p.tier},
                    {"s", p.scalar},
                    {"d", p.distribution},
                    {"x", p.ns},
                    {"ns", p.true_ns},
                    {"label", p.label()},
                    {"y", p.height()},
                    {"k", p.errors.k},
                    {"n", p.errors.n},
                    {"lo", p.errors.rate.low95},
                    {"hi", p.errors.rate.high95},
                    {"dx", p.label_dx},
                    {"dy", p.label_dy},
                    {"a", p.label_anchor}});
  }
  return list;
}

/// All of a question: pooled, then each distribution.
struct QuestionData {
  std::string name;
  std::vector<Summary> pooled, apart;

  [[nodiscard]] std::vector<std::string> distributions() const {
    std::vector<std::string> names;
    for (const Summary& s : apart) names.push_back(s.distribution);
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
  }

  [[nodiscard]] std::vector<Summary> on(const std::string& distribution) const {
    std::vector<Summary> some;
    std::copy_if(apart.begin(), apart.end(), std::back_inserter(some),
                 [&](const Summary& s) { return s.distribution == distribution; });
    return some;
  }

  [[nodiscard]] bool shows(Measure measure) const {
    if (plot_points(pooled, measure).empty()) return false;
    return measure != Measure::kInsides ||
           std::any_of(pooled.begin(), pooled.end(), [](const Summary& s) { return s.insides.k > 0; });
  }
};

PlotPanel make_panel(const QuestionData& question, std::span<const Summary> summaries, Measure measure) {
  PlotPanel panel;
  std::vector<PlotPoint> all = plot_points(question.apart, measure);
  const std::vector<PlotPoint> pooled = plot_points(question.pooled, measure);
  all.insert(all.end(), pooled.begin(), pooled.end());
  panel.points = plot_points(summaries, measure);
  panel.references = reference_lines(summaries);
  panel.x = time_axis(panel.points, panel.references);  // of this view
  panel.y = error_axis(all);                            // of all views, so that heights compare
  pull_in(panel);
  place_labels(panel);
  return panel;
}

nlohmann::json question_json(const QuestionData& question) {
  nlohmann::json panels = nlohmann::json::array();
  for (const PanelText& text : kPanels) {
    if (!question.shows(text.measure)) continue;
    const auto view = [&](const std::string& name, std::span<const Summary> summaries) {
      const PlotPanel panel = make_panel(question, summaries, text.measure);
      nlohmann::json json = {
          {"name", name}, {"x", axis_json(panel.x)}, {"points", points_json(panel.points)}};
      json["references"] = nlohmann::json::array();
      for (const ReferenceLine& line : panel.references) {
        json["references"].push_back({{"x", line.ns}, {"l", line.label}});
      }
      return json;
    };
    nlohmann::json views = nlohmann::json::array({view("", question.pooled), view("*", question.apart)});
    for (const std::string& name : question.distributions())
      views.push_back(view("=" + name, question.on(name)));
    const PlotPanel frame = make_panel(question, question.pooled, text.measure);
    panels.push_back(
        {{"title", text.title}, {"axis", text.axis}, {"y", axis_json(frame.y)}, {"views", views}});
  }
  return {{"name", question.name}, {"panels", panels}};
}

std::string untimed_note(const QuestionData& question) {
  std::string names;
  for (const Summary& s : question.pooled) {
    if (!s.ns) names += (names.empty() ? "" : ", ") + escaped(s.label);
  }
  return names.empty() ? ""
                       : fmt::format("<p class=\"note\">Not timed, so not in the plot: {}.</p>\n", names);
}

constexpr const char* kKey = R"(<p class="key"><span class="t-trivial">●</span> trivial
<span class="t-naive">●</span> naive <span class="t-certified">●</span> certified <span class="t-exact">●</span> exact
<span class="t-plug-in">●</span> plug-in
<span class="gap"></span> ● f32 &ensp;■ f64 &ensp;◆ other
<span class="gap"></span> <b>○↓</b> no error seen: drawn at the 95 % upper bound, the truth lies below
<span class="gap"></span> <b>│</b> 95 % interval</p>
)";

}  // namespace

std::string plot_section(std::span<const ResultFile> files) {
  std::map<std::string, QuestionData> questions;
  for (Summary& s : group(files, Grouping::kMethod)) {
    questions[s.question].name = s.question;
    questions[s.question].pooled.push_back(std::move(s));
  }
  for (Summary& s : group(files, Grouping::kMethodAndDistribution))
    questions[s.question].apart.push_back(std::move(s));

  std::string figures;
  nlohmann::json data = nlohmann::json::array();
  for (const auto& [name, question] : questions) {
    std::string panels;
    for (const PanelText& text : kPanels) {
      if (question.shows(text.measure)) {
        panels += panel_svg(make_panel(question, question.pooled, text.measure), text, name);
      }
    }
    if (!panels.empty()) {
      figures += fmt::format(
          "<figure class=\"still\" data-question=\"{0}\"><figcaption><code>{0}</code>, all distributions "
          "pooled</figcaption>\n<div class=\"panels\">\n{1}</div></figure>\n",
          escaped(name), panels);
      data.push_back(question_json(question));
    }
    figures += untimed_note(question);
  }
  if (figures.empty()) return "";
  std::string out = "<section id=\"plot\"><h2>Speed against error</h2>\n";
  if (data.empty()) return out + "<p>No times were measured.</p></section>\n";
  out +=
      "<p>Down and to the left is better. Both axes are logarithmic; dashed is the exact reference on the "
      "same cases. "
      "Times over several distributions are medians, since a few of these cost far more than the rest. They "
      "include the set-up of the shaft, which batch rows share among the K cases of a distribution with @K; "
      "all "
      "others do it for every case.</p>\n";
  out += kKey;
  out += "<div id=\"plot-controls\" hidden></div>\n<div id=\"plot-live\" class=\"panels\" hidden></div>\n" +
         figures;
  out += fmt::format("<script type=\"application/json\" id=\"plot-data\">{}</script>\n",
                     script_safe(data.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)));
  return out + "</section>\n";
}

}  // namespace gnomon::reports
