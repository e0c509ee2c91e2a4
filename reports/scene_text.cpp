// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/scene_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "exact/convexity.h"
#include "scene/cone.h"
#include "scene/scene_facts.h"

namespace gnomon::reports {
namespace {

using Json = nlohmann::ordered_json;
using Point = std::array<double, 3>;

std::string counted(std::size_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string point_text(const Point& p) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", p[0], p[1], p[2]);
}

Point lo_of(const scene::Box<double>& box) {
  return {box.lo(0), box.lo(1), box.lo(2)};
}
Point hi_of(const scene::Box<double>& box) {
  return {box.hi(0), box.hi(1), box.hi(2)};
}

Json view_json(const scene::View& view) {
  return {{"from", view.from},   {"at", view.at},         {"up", view.up},
          {"angle", view.angle}, {"hither", view.hither}, {"resolution", {view.columns, view.rows}}};
}

/// What the source says of objects' convexity, and what is so.
struct Convexity {
  std::vector<bool> exact;  ///< for each object
  std::size_t declared = 0, wrongly = 0;

  explicit Convexity(const scene::Scene& scene) {
    for (const scene::Object& object : scene.objects) {
      exact.push_back(exact::is_convex(scene, object));
      declared += object.declared_convex ? 1 : 0;
      wrongly += object.declared_convex && !exact.back() ? 1 : 0;
    }
  }
  [[nodiscard]] std::size_t convex() const {
    return static_cast<std::size_t>(std::count(exact.begin(), exact.end(), true));
  }
};

Json builtin_json(const scene::SizedScene& builtin) {
  return {{"name", builtin.scene->name},
          {"size", builtin.size},
          {"size_means", builtin.scene->size_means},
          {"summary", builtin.scene->summary},
          {"stands_for", builtin.scene->stands_for}};
}

}  // namespace

std::string scene_text(const scene::FoundScene& found, std::string_view name) {
  const scene::LoadedScene& loaded = found.loaded;
  const scene::Scene& scene = loaded.scene;
  const scene::SceneFacts facts = facts_of(scene);
  std::string text = fmt::format("{}: {}\n", name, counted(scene.face_count(), "face", "faces"));
  const auto add = [&text](std::string_view what, const std::string& value) {
    text += fmt::format("  {:<12}{}\n", what, value);
  };
  if (found.builtin) {
    const scene::BuiltinScene& builtin = *found.builtin->scene;
    add("built in", std::string(builtin.summary));
    add("", fmt::format("size {}: {}", found.builtin->size, builtin.size_means));
    add("", fmt::format("stands for: {}", builtin.stands_for));
  }
  add("triangles",
      fmt::format("{} on {}", scene.triangles.size(), counted(scene.points.size(), "point", "points")));
  if (loaded.polygons > 0) {
    add("", fmt::format("from {} of four or more corners{}", counted(loaded.polygons, "polygon", "polygons"),
                        loaded.crossing_polygons == 0
                            ? ""
                            : fmt::format("; self-crossing: {}", loaded.crossing_polygons)));
  }
  if (loaded.cones > 0) {
    add("", fmt::format("from {} of {} sides each",
                        counted(loaded.cones, "cone or cylinder", "cones and cylinders"), scene::kConeSides));
  }
  add("balls", std::to_string(scene.balls.size()));
  add("degenerate", std::to_string(facts.degenerate));
  add("duplicate", std::to_string(facts.duplicate));
  const std::size_t closed = facts.closed_objects();
  add("objects",
      fmt::format("{}: {} closed, {} open", scene.objects.size(), closed, scene.objects.size() - closed));
  const Convexity convexity(scene);
  add("convex", fmt::format("{} declared{}, {} exactly", convexity.declared,
                            convexity.wrongly == 0 ? "" : fmt::format(" ({} wrongly)", convexity.wrongly),
                            convexity.convex()));
  add("lights", fmt::format("{}, {}", counted(scene.point_lights.size(), "point", "points"),
                            counted(scene.polygon_lights.size(), "polygon", "polygons")));
  add("extent",
      fmt::format("from {} to {}", point_text(lo_of(facts.extent)), point_text(hi_of(facts.extent))));
  add("view", scene.view ? fmt::format("from {} at {}, {:.6g} degrees, {} x {}", point_text(scene.view->from),
                                       point_text(scene.view->at), scene.view->angle, scene.view->columns,
                                       scene.view->rows)
                         : "none");
  return text;
}

std::string scene_json(const scene::FoundScene& found, std::string_view name) {
  const scene::LoadedScene& loaded = found.loaded;
  const scene::Scene& scene = loaded.scene;
  const Convexity convexity(scene);
  const scene::SceneFacts facts = facts_of(scene);
  Json json{{"schema", 1},
            {"kind", "scene"},
            {"file", name},
            {"builtin", found.builtin ? builtin_json(*found.builtin) : Json()},
            {"faces", scene.face_count()},
            {"triangles", scene.triangles.size()},
            {"balls", scene.balls.size()},
            {"points", scene.points.size()},
            {"polygons", loaded.polygons},
            {"crossing_polygons", loaded.crossing_polygons},
            {"cones", loaded.cones},
            {"cone_sides", scene::kConeSides},
            {"degenerate", facts.degenerate},
            {"duplicate", facts.duplicate},
            {"extent", {{"lo", lo_of(facts.extent)}, {"hi", hi_of(facts.extent)}}}};
  json["convex"] = {{"declared", convexity.declared},
                    {"declared_wrongly", convexity.wrongly},
                    {"exact", convexity.convex()}};
  json["objects"] = Json::array();
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const scene::Object& object = scene.objects[i];
    json["objects"].push_back({{"name", object.name},
                               {"triangles", object.triangle_count},
                               {"balls", object.ball_count},
                               {"transmittance", object.transmittance},
                               {"declared_convex", object.declared_convex},
                               {"convex", static_cast<bool>(convexity.exact[i])},
                               {"one_sided", object.one_sided},
                               {"closed", static_cast<bool>(facts.closed[i])}});
  }
  json["point_lights"] = Json::array();
  for (const scene::PointLight& light : scene.point_lights) json["point_lights"].push_back(light.position);
  json["polygon_lights"] = Json::array();
  for (const scene::PolygonLight& light : scene.polygon_lights)
    json["polygon_lights"].push_back(light.corners);
  json["view"] = scene.view ? view_json(*scene.view) : Json();
  // A file's name need not be UTF-8.
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace gnomon::reports
