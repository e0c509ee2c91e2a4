// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "reports/html_panel.h"
#include "reports/html_sections.h"
#include "reports/html_text.h"
#include "reports/plot_layout.h"

namespace gnomon::reports {
namespace {

struct PanelKind {
  Measure measure;
  PanelText text;
};

constexpr PanelKind kPanels[] = {
    {Measure::kCulls, {"Unsound: culled though it meets", "false culls / cases that are not outside"}},
    {Measure::kInsides, {"Unsound: “inside” though it is not", "false insides / cases that are not inside"}},
    {Measure::kWaste, {"Waste: kept though outside", "kept / cases that are exactly outside"}},
};

constexpr PanelKind kListPanels[] = {
    {Measure::kCulls, {"Unsound: a face is missing", "lists without a true face / lists with one"}},
    {Measure::kWaste, {"Waste: more faces than true", "lists with more / lists"}},
};

constexpr PanelKind kPairPanels[] = {
    {Measure::kCulls, {"Unsound: all or none said falsely", "false all or none / pairs"}},
    {Measure::kWaste,
     {"Waste: all or none not seen", "part said of all or none / pairs that are all or none"}},
};

std::span<const PanelKind> panels_of(const std::string& question) {
  if (question == "shaft-candidates") return kListPanels;
  if (question == "patch-pair") return kPairPanels;
  return kPanels;
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
  for (const PanelKind& kind : panels_of(question.name)) {
    if (!question.shows(kind.measure)) continue;
    const auto view = [&](const std::string& name, std::span<const Summary> summaries) {
      const PlotPanel panel = make_panel(question, summaries, kind.measure);
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
    const PlotPanel frame = make_panel(question, question.pooled, kind.measure);
    panels.push_back(
        {{"title", kind.text.title}, {"axis", kind.text.axis}, {"y", axis_json(frame.y)}, {"views", views}});
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
    for (const PanelKind& kind : panels_of(name)) {
      if (question.shows(kind.measure)) {
        panels += panel_svg(make_panel(question, question.pooled, kind.measure), kind.text, name);
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
      "others do it for every case. Of questions about pairs in a scene they include making the method's "
      "structure where every case has a scene of its own.</p>\n";
  out += kKey;
  out += "<div id=\"plot-controls\" hidden></div>\n<div id=\"plot-live\" class=\"panels\" hidden></div>\n" +
         figures;
  out += fmt::format("<script type=\"application/json\" id=\"plot-data\">{}</script>\n",
                     script_safe(data.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)));
  return out + "</section>\n";
}

}  // namespace gnomon::reports
