// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/json_node.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <system_error>

#include "scene/input_error.h"

namespace gnomon::reports {

Json read_json(const std::filesystem::path& path) {
  const std::string name = path.string();
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    throw scene::InputError(name, 0, "expected a result file, found a folder");
  }
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw scene::InputError(name, 0, "expected a readable result file, can't open it");
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  if (stream.bad()) throw scene::InputError(name, 0, "expected a readable result file, reading failed");
  if (bytes.empty()) throw scene::InputError(name, 0, "expected a result file, found an empty one");
  // Values are walked by recursion: nesting without bound would overflow the stack.
  constexpr int kDeepest = 64;
  const auto refuse_deep = [&](int depth, Json::parse_event_t, const Json&) {
    if (depth <= kDeepest) return true;
    throw scene::InputError(name, 0, fmt::format("expected JSON of at most {} levels, found more", kDeepest));
  };
  try {
    return Json::parse(bytes, refuse_deep);
  } catch (const Json::parse_error& error) {
    const auto end = bytes.begin() + static_cast<std::ptrdiff_t>(std::min(bytes.size(), error.byte));
    const auto line = static_cast<std::size_t>(std::count(bytes.begin(), end, '\n')) + 1;
    const bool at_end = error.byte > bytes.size();
    throw scene::InputError(
        name, line,
        fmt::format("expected JSON, {} byte {}",
                    at_end ? "the file ends too early, at" : "parsing stopped at", error.byte));
  } catch (const Json::exception& error) {  // a number beyond double's range
    throw scene::InputError(name, 0, fmt::format("expected JSON, {}", error.what()));
  }
}

void Node::fail(const std::string& expected) const {
  // ASCII only: a message is one printable line, whatever the file holds.
  std::string found = json_->dump(-1, ' ', true, Json::error_handler_t::replace);
  if (found.size() > 60) found = found.substr(0, 57) + "...";
  throw scene::InputError(file_, 0, fmt::format("expected {} at {}, found {}", expected, where_, found));
}

bool Node::has(const char* key) const {
  object();
  const auto it = json_->find(key);
  return it != json_->end() && !it->is_null();
}

Node Node::at(const char* key) const {
  object();
  const auto it = json_->find(key);
  if (it == json_->end()) {
    throw scene::InputError(file_, 0, fmt::format("expected field \"{}\" at {}, found none", key, where_));
  }
  return {*it, file_, where_ == "the top" ? std::string(key) : where_ + "." + key};
}

std::string Node::text() const {
  if (!json_->is_string()) fail("text");
  return json_->get<std::string>();
}

std::uint64_t Node::count() const {
  if (!json_->is_number_unsigned()) fail("a count (a whole number, 0 or more)");
  return json_->get<std::uint64_t>();
}

double Node::number() const {
  if (!json_->is_number() || !std::isfinite(json_->get<double>())) fail("a finite number");
  return json_->get<double>();
}

bool Node::flag() const {
  if (!json_->is_boolean()) fail("true or false");
  return json_->get<bool>();
}

std::vector<Node> Node::list() const {
  if (!json_->is_array()) fail("an array");
  std::vector<Node> nodes;
  for (std::size_t i = 0; i < json_->size(); ++i) {
    nodes.emplace_back((*json_)[i], file_, fmt::format("{}[{}]", where_, i));
  }
  return nodes;
}

std::vector<std::pair<std::string, Node>> Node::fields() const {
  object();
  std::vector<std::pair<std::string, Node>> nodes;
  for (const auto& [key, value] : json_->items())
    nodes.emplace_back(key, Node(value, file_, where_ + "." + key));
  return nodes;
}

void Node::object() const {
  if (!json_->is_object()) fail("an object");
}

std::string kind_of_result(const Node& top) {
  if (top.at("schema").json() != 1) top.at("schema").fail("schema 1");
  return top.at("kind").text();
}

}  // namespace gnomon::reports
