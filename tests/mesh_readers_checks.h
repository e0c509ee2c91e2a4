// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests of all mesh readers share.
#pragma once

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <string_view>

#include "scene/input_error.h"
#include "scene/mesh.h"

namespace gnomon::scene {

using Reader = Mesh (*)(std::istream&, std::string_view);

/// The mesh that the text holds; checks what every reader promises.
inline Mesh read(Reader reader, const std::string& text) {
  std::istringstream in(text);
  Mesh mesh = reader(in, "m");
  EXPECT_TRUE(is_valid(mesh));
  return mesh;
}

/// The message of the InputError that the text brings about.
inline std::string complaint(Reader reader, const std::string& text) {
  std::istringstream in(text);
  try {
    (void)reader(in, "m");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no complaint";
}

inline const Mesh kTriangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2}, {0, 3}};
inline const Mesh kTwoFaces{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0.1}}, {0, 1, 2, 3, 2, 1, 0}, {0, 4, 7}};

}  // namespace gnomon::scene
