// SPDX-License-Identifier: GPL-3.0-or-later
// JSON files as input that may be wrong: every complaint names the file, the place and what was expected.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace gnomon::reports {

using Json = nlohmann::ordered_json;  // keeps the file's own order of fields

/// The JSON value that the file holds. Throws scene::InputError when the file can't be read, is no file, is
/// empty, ends too early, or is not JSON.
[[nodiscard]] Json read_json(const std::filesystem::path& path);

/// A value with the way to it. Every access checks the type and throws scene::InputError when it is another
/// one.
class Node {
 public:
  Node(const Json& json, std::string file, std::string where)
      : json_(&json), file_(std::move(file)), where_(std::move(where)) {}
  /// The top of a file.
  Node(const Json& json, const std::filesystem::path& path) : Node(json, path.string(), "the top") {}

  /// "FILE: expected `expected` at `where`, found ...".
  [[noreturn]] void fail(const std::string& expected) const;

  /// True when the object has the field, and it is not null.
  [[nodiscard]] bool has(const char* key) const;
  [[nodiscard]] Node at(const char* key) const;

  [[nodiscard]] std::string text() const;
  [[nodiscard]] std::uint64_t count() const;
  [[nodiscard]] double number() const;  ///< finite
  [[nodiscard]] bool flag() const;
  [[nodiscard]] std::vector<Node> list() const;
  [[nodiscard]] std::vector<std::pair<std::string, Node>> fields() const;
  [[nodiscard]] const Json& json() const { return *json_; }

 private:
  void object() const;

  const Json* json_;
  std::string file_, where_;
};

/// Throws scene::InputError unless `top` is that of a result file: an object with "schema": 1 and a "kind",
/// which is the value returned.
[[nodiscard]] std::string kind_of_result(const Node& top);

}  // namespace gnomon::reports
