// SPDX-License-Identifier: MIT
// A scene as it comes from a file.
#pragma once

#include <cstddef>

#include "scene/scene.h"

namespace gnomon::scene {

/// A scene, and what its triangles were in the file where they were no triangles.
struct LoadedScene {
  Scene scene;
  std::size_t polygons = 0;           ///< of four corners or more
  std::size_t crossing_polygons = 0;  ///< of those: they cross themselves, so their triangles overlap
  std::size_t cones = 0;              ///< cones and cylinders, of kConeSides sides each
};

}  // namespace gnomon::scene
