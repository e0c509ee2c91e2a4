// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "scene/cone.h"
#include "scene/line_reader.h"
#include "scene/mesh.h"
#include "scene/read_scene.h"
#include "scene/scene_builder.h"
#include "scene/tokens.h"

namespace gnomon::scene {
namespace {

using Point = std::array<double, 3>;

class NffReader {
 public:
  NffReader(std::istream& in, std::string_view name) : reader_(in, name) {
    builder_.begin_object("", 0, true);  // of the faces before any fill
  }

  LoadedScene read() {
    while (const auto line = reader_.next_content()) {
      Tokens words(*line);
      read_record(words.next(), words);
    }
    if (builder_.scene().face_count() == 0) reader_.fail("at least one face", kEndOfFile);
    loaded_.scene = builder_.finish();
    for (std::size_t i = 0; i < loaded_.scene.objects.size(); ++i)
      loaded_.scene.objects[i].name = "object " + std::to_string(i + 1);
    return std::move(loaded_);
  }

 private:
  void read_record(std::string_view record, Tokens& words) {
    if (record == "v") return read_view(words);
    if (record == "b") return read_background(words);
    if (record == "l") return read_light(words);
    if (record == "f") return read_fill(words);
    if (record == "c") return read_cone(words);
    if (record == "s") return read_ball(words);
    if (record == "p") return read_polygon(words, Normals::none);
    if (record == "pp") return read_polygon(words, Normals::at_corners);
    reader_.fail("a record v, b, l, f, c, s, p or pp", in_quotes(record));
  }

  void read_view(Tokens& words) {
    if (builder_.scene().view) reader_.fail("one viewpoint", "a second one");
    end_line(words);
    View view;
    view.from = labelled_point("from");
    view.at = labelled_point("at");
    view.up = labelled_point("up");
    Tokens angle = labelled_line("angle");
    const std::string_view degrees = angle.next();
    view.angle = reader_.finite_real(degrees, "angle");
    if (!(view.angle > 0 && view.angle < 180))
      reader_.fail("an angle between 0 and 180 degrees", in_quotes(degrees));
    end_line(angle);
    Tokens hither = labelled_line("hither");
    view.hither = reader_.finite_real(hither.next(), "hither");
    end_line(hither);
    Tokens size = labelled_line("resolution");
    view.columns = reader_.integer(size.next(), 1, View::kMaxResolution, "a number of columns");
    view.rows = reader_.integer(size.next(), 1, View::kMaxResolution, "a number of rows");
    end_line(size);
    builder_.scene().view = view;
  }

  void read_background(Tokens& words) {
    drop_numbers(words, {"red", "green", "blue"});
    end_line(words);
  }

  void read_light(Tokens& words) {
    const Point position = point(words);
    if (!words.done()) drop_numbers(words, {"red", "green", "blue"});
    end_line(words);
    builder_.scene().point_lights.push_back({position});
  }

  void read_fill(Tokens& words) {
    drop_numbers(words, {"red", "green", "blue", "Kd", "Ks", "shine"});
    const std::string_view word = words.next();
    const double transmittance = reader_.finite_real(word, "transmittance");
    if (!(transmittance >= 0 && transmittance <= 1))
      reader_.fail("a transmittance from 0 to 1", in_quotes(word));
    drop_numbers(words, {"the index of refraction"});
    end_line(words);
    builder_.begin_object("", transmittance, true);
  }

  void read_cone(Tokens& words) {
    end_line(words);
    Cone cone;
    read_cone_end("the base of a cone", cone.base, cone.base_radius);
    read_cone_end("the apex of a cone", cone.apex, cone.apex_radius);
    const bool inside_out = cone.base_radius < 0 || cone.apex_radius < 0;
    if (inside_out && (cone.base_radius > 0 || cone.apex_radius > 0))
      reader_.fail("two radii of one sign", "a positive and a negative one");
    if (cone.base == cone.apex) reader_.fail("an apex apart from the base", "the same point");
    cone.base_radius = std::fabs(cone.base_radius);
    cone.apex_radius = std::fabs(cone.apex_radius);
    const auto rings = rings_of(cone);
    if (!rings) reader_.fail("a cone within the range of doubles", "one beyond it");
    for (std::size_t k = 0; k < kConeSides; ++k) {
      const std::size_t next = (k + 1) % kConeSides;
      const std::size_t left = inside_out ? next : k, right = inside_out ? k : next;
      if (cone.base_radius > 0)
        builder_.add_triangle(rings->base[left], rings->base[right], rings->apex[right]);
      if (cone.apex_radius > 0 || cone.base_radius == 0)
        builder_.add_triangle(rings->base[left], rings->apex[right], rings->apex[left]);
    }
    ++loaded_.cones;
  }

  void read_cone_end(std::string_view what, Point& centre, double& radius) {
    Tokens words = line([&] { return what; });
    centre = point(words);
    radius = reader_.finite_real(words.next(), "a radius");
    end_line(words);
  }

  void read_ball(Tokens& words) {
    const Point centre = point(words);
    const double radius = std::fabs(reader_.finite_real(words.next(), "a radius"));
    end_line(words);
    for (const double c : centre) {
      if (!std::isfinite(c - radius) || !std::isfinite(c + radius))
        reader_.fail("a sphere within the range of doubles", "one beyond it");
    }
    builder_.add_ball({centre, radius});
  }

  enum class Normals { none, at_corners };

  void read_polygon(Tokens& words, Normals normals) {
    const std::int64_t count = reader_.integer(words.next(), 3, kMaxMeshPoints, "a number of vertices");
    end_line(words);
    polygon_.clear();
    for (std::int64_t i = 0; i < count; ++i) {
      Tokens vertex =
          line([&] { return "vertex " + std::to_string(i + 1) + " of " + std::to_string(count); });
      polygon_.push_back(point(vertex));
      if (normals == Normals::at_corners)
        drop_numbers(vertex, {"x of a normal", "y of a normal", "z of a normal"});
      end_line(vertex);
    }
    if (count > 3) ++loaded_.polygons;
    if (builder_.add_polygon(polygon_)) ++loaded_.crossing_polygons;
  }

  /// The words of the next line with something on it; `what`() is what should stand there.
  template <class What>
  Tokens line(const What& what) {
    const auto content = reader_.next_content();
    if (!content) reader_.fail(what(), kEndOfFile);
    return Tokens(*content);
  }

  /// The words after this one, with which the next line must begin.
  Tokens labelled_line(std::string_view label) {
    Tokens words = line([&] { return label; });
    const std::string_view word = words.next();
    if (word != label) reader_.fail(label, in_quotes(word));
    return words;
  }
  Point labelled_point(std::string_view label) {
    Tokens words = labelled_line(label);
    const Point result = point(words);
    end_line(words);
    return result;
  }

  Point point(Tokens& words) {
    const double x = reader_.finite_real(words.next(), "x");
    const double y = reader_.finite_real(words.next(), "y");
    const double z = reader_.finite_real(words.next(), "z");
    return {x, y, z};
  }

  /// What is dropped must still be finite numbers.
  void drop_numbers(Tokens& words, std::initializer_list<std::string_view> names) {
    for (const std::string_view name : names) (void)reader_.finite_real(words.next(), name);
  }

  void end_line(Tokens& words) {
    if (!words.done()) reader_.fail("the end of the line", in_quotes(words.next()));
  }

  LineReader reader_;
  SceneBuilder builder_;
  LoadedScene loaded_;
  std::vector<Point> polygon_;
};

}  // namespace

LoadedScene read_nff(std::istream& in, std::string_view name) {
  return NffReader(in, name).read();
}

}  // namespace gnomon::scene
