// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>
#include <utility>

#include "scene/line_reader.h"
#include "scene/parse_number.h"
#include "scene/read_mesh.h"
#include "scene/tokens.h"

namespace gnomon::scene {
namespace {

/// Every other statement of the format: vertex data, free-form geometry, elements without faces, grouping,
/// display attributes and the superseded statements.
constexpr std::string_view kSkipped[] = {
    "bevel", "bmat",   "bsp",  "bzp",       "c_interp", "cdc",    "cdp",    "con",  "cstype",     "ctech",
    "curv",  "curv2",  "deg",  "d_interp",  "end",      "g",      "hole",   "l",    "lod",        "maplib",
    "mg",    "mtllib", "o",    "p",         "parm",     "res",    "s",      "scrv", "shadow_obj", "sp",
    "stech", "step",   "surf", "trace_obj", "trim",     "usemap", "usemtl", "vn",   "vp",         "vt"};

bool is_skipped(std::string_view keyword) {
  return std::find(std::begin(kSkipped), std::end(kSkipped), keyword) != std::end(kSkipped);
}

class ObjReader {
 public:
  ObjReader(std::istream& in, std::string_view name) : reader_(in, name) {}

  Mesh read() {
    while (const auto statement = next_statement()) {
      Tokens words(*statement);
      const std::string_view keyword = words.next();
      if (keyword == "v") {
        read_vertex(words);
      } else if (keyword == "f") {
        read_face(words);
      } else if (!keyword.empty() && !is_skipped(keyword)) {
        reader_.fail("a statement of the OBJ format", in_quotes(keyword));
      }
    }
    if (mesh_.face_count() == 0) reader_.fail("at least one face", kEndOfFile);
    if (furthest_ > std::ssize(mesh_.points)) {
      reader_.fail("vertex " + std::to_string(furthest_) + ", which the face on line " +
                       std::to_string(furthest_line_) + " has as a corner",
                   "only " + std::to_string(mesh_.points.size()) + " vertices");
    }
    return std::move(mesh_);
  }

 private:
  /// The next line without its comment, joined with the lines that continue it.
  std::optional<std::string_view> next_statement() {
    joined_.clear();
    while (const auto line = reader_.next_line()) {
      std::string_view text = line->substr(0, line->find('#'));
      // A comment that ends in a backslash (a Windows path, say) doesn't swallow the line below it.
      const bool continued = text.size() == line->size() && text.ends_with('\\');
      if (!continued && joined_.empty()) return text;
      if (continued) text.remove_suffix(1);
      if (joined_.size() + text.size() > LineReader::kMaxLineBytes) {
        reader_.fail("a line of at most " + std::to_string(LineReader::kMaxLineBytes) + " bytes",
                     "a longer one");
      }
      joined_.append(text).push_back(' ');
      if (!continued) return joined_;
    }
    if (!joined_.empty()) reader_.fail("the line that a backslash continues", kEndOfFile);
    return std::nullopt;
  }

  void read_vertex(Tokens& words) {
    if (mesh_.points.size() == kMaxMeshPoints) reader_.fail("at most 4294967295 vertices", "one more");
    const double x = reader_.finite_real(words.next(), "x");
    const double y = reader_.finite_real(words.next(), "y");
    const double z = reader_.finite_real(words.next(), "z");
    mesh_.points.push_back({x, y, z});
    int extras = 0;
    for (; !words.done(); ++extras) {
      const std::string_view word = words.next();
      if (!parse_real<double>(word)) reader_.fail("a number or the end of the line", in_quotes(word));
    }
    if (extras != 0 && extras != 1 && extras != 3 && extras != 4) {
      reader_.fail("x y z and then nothing, a weight, or 3 or 4 colour components",
                   std::to_string(3 + extras) + " numbers");
    }
  }

  void read_face(Tokens& words) {
    int corners = 0;
    for (; !words.done(); ++corners) read_corner(words.next());
    if (corners < 3) reader_.fail("a face of at least 3 corners", std::to_string(corners));
    mesh_.end_face();
  }

  /// v, v/vt, v/vt/vn or v//vn.
  void read_corner(std::string_view word) {
    const std::size_t slash = word.find('/');
    read_index(word, word.substr(0, slash));
    if (slash == std::string_view::npos) return;
    const std::string_view rest = word.substr(slash + 1);
    const std::size_t second = rest.find('/');
    const std::string_view texture = rest.substr(0, second);
    const bool has_normal = second != std::string_view::npos;
    if (!(texture.empty() && has_normal) && !is_reference(texture)) fail_corner(word);
    if (has_normal && !is_reference(rest.substr(second + 1))) fail_corner(word);
  }

  void read_index(std::string_view word, std::string_view digits) {
    const auto index = parse_integer(digits);
    if (!index) fail_corner(word);
    const auto count = std::ssize(mesh_.points);
    if (*index == 0 || *index < -count || *index > std::int64_t{kMaxMeshPoints}) {
      reader_.fail("a vertex index other than 0 and not below " + std::to_string(-count), in_quotes(word));
    }
    if (*index > count && *index > furthest_) {
      furthest_ = *index;
      furthest_line_ = reader_.line();
    }
    mesh_.corners.push_back(static_cast<std::uint32_t>(*index > 0 ? *index - 1 : count + *index));
  }

  static bool is_reference(std::string_view digits) { return parse_integer(digits).value_or(0) != 0; }

  [[noreturn]] void fail_corner(std::string_view word) const {
    reader_.fail("a corner v, v/vt, v/vt/vn or v//vn", in_quotes(word));
  }

  LineReader reader_;
  std::string joined_;
  Mesh mesh_;
  // The largest index so far of a vertex that had not come yet, and its line.
  std::int64_t furthest_ = 0;
  std::size_t furthest_line_ = 0;
};

}  // namespace

Mesh read_obj(std::istream& in, std::string_view name) {
  return ObjReader(in, name).read();
}

}  // namespace gnomon::scene
