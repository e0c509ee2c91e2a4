// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests of scenes share.
#pragma once

#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "scene/input_error.h"
#include "scene/read_scene.h"

namespace gnomon::scene {

/// The scene that the NFF text holds; checks what the reader promises.
inline LoadedScene read_nff_text(const std::string& text) {
  std::istringstream in(text);
  LoadedScene loaded = read_nff(in, "s");
  EXPECT_TRUE(is_valid(loaded.scene));
  return loaded;
}

/// The message of the InputError that the NFF text brings about.
inline std::string nff_complaint(const std::string& text) {
  std::istringstream in(text);
  try {
    (void)read_nff(in, "s");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no complaint";
}

inline const std::string kTrianglePolygon = "p 3\n0 0 0\n1 0 0\n0 1 0\n";

}  // namespace gnomon::scene
