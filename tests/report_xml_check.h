// SPDX-License-Identifier: GPL-3.0-or-later
// A small well-formedness check for what the report writes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace gnomon::tests {

/// What is wrong with the markup, or "" when every tag is closed in order, attributes are quoted, and '<' and
/// '&' start nothing but tags and entities. `void_elements` need no end (HTML's <meta>).
inline std::string xml_fault(std::string_view text, const std::vector<std::string_view>& void_elements = {}) {
  std::vector<std::string> open;
  const auto near = [&](std::size_t at) { return " near: " + std::string(text.substr(at, 80)); };
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '&') {
      const auto end = text.find(';', i);
      if (end == std::string_view::npos || end - i > 8) return "bare &" + near(i);
      if (text.substr(i + 1, end - i - 1).find_first_of(" <&") != std::string_view::npos)
        return "bare &" + near(i);
    }
    if (text[i] != '<') continue;
    const std::size_t start = i++;
    const bool closing = i < text.size() && text[i] == '/';
    if (closing) ++i;
    const auto name_end = text.find_first_of(" \n/>", i);
    if (name_end == i || name_end == std::string_view::npos) return "bare <" + near(start);
    const std::string name(text.substr(i, name_end - i));
    if (name[0] == '!') {
      i = text.find('>', i);
      continue;
    }
    bool quoted = false;
    for (i = name_end; i < text.size() && (quoted || text[i] != '>'); ++i) {
      if (text[i] == '"') quoted = !quoted;
      if (text[i] == '<') return "< in a tag" + near(start);
    }
    if (i == text.size()) return "tag without end" + near(start);
    if (closing) {
      if (open.empty() || open.back() != name) return "</" + name + "> closes nothing" + near(start);
      open.pop_back();
      continue;
    }
    bool empty = text[i - 1] == '/';
    for (const std::string_view v : void_elements) empty = empty || v == name;
    if (empty) continue;
    open.push_back(name);
    if (name == "script" || name == "style") {  // raw text
      const auto end = text.find("</" + name + ">", i);
      if (end == std::string_view::npos) return "no </" + name + ">" + near(start);
      i = end - 1;
    }
  }
  return open.empty() ? "" : "<" + open.back() + "> is never closed";
}

}  // namespace gnomon::tests
