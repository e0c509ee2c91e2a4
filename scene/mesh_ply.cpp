// SPDX-License-Identifier: MIT
#include <array>
#include <string>
#include <utility>

#include "scene/line_reader.h"
#include "scene/ply_binary_source.h"
#include "scene/ply_header.h"
#include "scene/ply_text_source.h"
#include "scene/read_mesh.h"

namespace gnomon::scene {
namespace {

/// Where a mesh is to be found in the elements.
struct Layout {
  std::size_t vertex = 0;
  std::size_t face = 0;
  std::array<std::size_t, 3> axes{};
  std::size_t corners = 0;
  std::uint64_t point_count = 0;
};

std::size_t find_element(const LineReader& reader, const PlyHeader& header, std::string_view name) {
  for (std::size_t e = 0; e < header.elements.size(); ++e) {
    if (header.elements[e].name != name) continue;
    if (header.elements[e].count == 0) reader.fail("at least one " + std::string(name), "none");
    return e;
  }
  reader.fail("an element " + std::string(name), "none");
}

Layout find_mesh(const LineReader& reader, const PlyHeader& header) {
  constexpr std::array<std::string_view, 3> kAxes = {"x", "y", "z"};
  Layout layout;
  layout.vertex = find_element(reader, header, "vertex");
  const PlyElement& vertex = header.elements[layout.vertex];
  layout.point_count = vertex.count;
  if (layout.point_count > kMaxMeshPoints) {
    reader.fail("at most 4294967295 vertices", std::to_string(layout.point_count));
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto place = vertex.find(kAxes[axis]);
    if (!place || vertex.properties[*place].count_type) {
      reader.fail("a property " + std::string(kAxes[axis]) + " of vertex", place ? "a list" : "none");
    }
    layout.axes[axis] = *place;
  }
  layout.face = find_element(reader, header, "face");
  const PlyElement& face = header.elements[layout.face];
  const auto indices = face.find("vertex_indices");
  const auto index = face.find("vertex_index");
  if (indices.has_value() == index.has_value()) {
    reader.fail("a list vertex_indices or vertex_index of face", indices ? "both" : "neither");
  }
  layout.corners = indices ? *indices : *index;
  const PlyProperty& corners = face.properties[layout.corners];
  if (!corners.count_type || !is_integer(corners.type)) {
    reader.fail("a list of integers " + corners.name,
                corners.count_type ? "a list of reals" : "a single value");
  }
  return layout;
}

template <class Source>
class BodyReader {
 public:
  BodyReader(Source source, const PlyHeader& header, const Layout& layout)
      : source_(source), header_(header), layout_(layout) {}

  Mesh read() {
    for (std::size_t e = 0; e < header_.elements.size(); ++e) {
      const PlyElement& element = header_.elements[e];
      if (element.properties.empty()) continue;  // its items take no room, however many are claimed
      for (std::uint64_t i = 0; i < element.count; ++i) {
        source_.next_item(element, i);
        read_item(e, element);
        source_.end_item();
      }
    }
    source_.end_body();
    return std::move(mesh_);
  }

 private:
  void read_item(std::size_t e, const PlyElement& element) {
    std::array<double, 3> point{};
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      if (e == layout_.vertex && p == layout_.axes[0]) {
        point[0] = source_.finite_real(property.type, "x");
      } else if (e == layout_.vertex && p == layout_.axes[1]) {
        point[1] = source_.finite_real(property.type, "y");
      } else if (e == layout_.vertex && p == layout_.axes[2]) {
        point[2] = source_.finite_real(property.type, "z");
      } else if (e == layout_.face && p == layout_.corners) {
        read_face(property);
      } else {
        skip(property);
      }
    }
    if (e == layout_.vertex) mesh_.points.push_back(point);
  }

  void read_face(const PlyProperty& property) {
    const std::int64_t corners = source_.integer(*property.count_type, "a number of corners");
    if (corners < 3) source_.fail("a face of at least 3 corners", std::to_string(corners));
    for (std::int64_t c = 0; c < corners; ++c) {
      const std::int64_t corner = source_.integer(property.type, "a vertex index");
      if (corner < 0 || corner >= static_cast<std::int64_t>(layout_.point_count)) {
        source_.fail("a vertex index from 0 to " + std::to_string(layout_.point_count - 1),
                     std::to_string(corner));
      }
      mesh_.corners.push_back(static_cast<std::uint32_t>(corner));
    }
    mesh_.end_face();
  }

  void skip(const PlyProperty& property) {
    std::int64_t values = 1;
    if (property.count_type) {
      values = source_.integer(*property.count_type, "a number of list values");
      if (values < 0) source_.fail("a number of list values", std::to_string(values));
    }
    for (std::int64_t i = 0; i < values; ++i) source_.skip(property.type);
  }

  Source source_;
  const PlyHeader& header_;
  const Layout& layout_;
  Mesh mesh_;
};

}  // namespace

Mesh read_ply(std::istream& in, std::string_view name) {
  LineReader reader(in, name);
  const PlyHeader header = read_ply_header(reader);
  const Layout layout = find_mesh(reader, header);
  switch (header.encoding) {
    case PlyEncoding::kAscii:
      return BodyReader(PlyTextSource(reader), header, layout).read();
    case PlyEncoding::kLittleEndian:
      return BodyReader(PlyBinarySource(reader, std::endian::little), header, layout).read();
    case PlyEncoding::kBigEndian:
      break;
  }
  return BodyReader(PlyBinarySource(reader, std::endian::big), header, layout).read();
}

}  // namespace gnomon::scene
