// SPDX-License-Identifier: MIT
// The words of corpus lines that bring a scene of their own. Internal to scene/.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scene/corpus.h"
#include "scene/scene.h"

namespace gnomon::scene {

/// The faces of a line as a scene: one object, which is not one-sided.
struct CaseFaces {
  Scene scene;
  /// The scene's number of each face of the line: balls come after all triangles there.
  std::vector<std::uint32_t> number;
};

/// Walks over the words of a line. All functions throw InputError naming file and line for words that are not
/// what they are asked for.
class CaseWords {
 public:
  explicit CaseWords(const CorpusLine& line) : line_(line) {}

  /// The next word; says what is missing when there is none.
  const std::string& next(std::string_view expected);
  /// A finite number.
  double number(std::string_view what);
  /// Three of them.
  std::array<double, 3> point(std::string_view what);
  /// A whole number from least to most.
  std::int64_t whole(std::string_view what, std::int64_t least, std::int64_t most);

  /// How many faces follow.
  std::int64_t face_count();
  /// So many faces, `tri v0(3) v1(3) v2(3)` or `ball c(3) r`, and then the end of the line.
  CaseFaces faces(std::int64_t count);

 private:
  const CorpusLine& line_;
  std::size_t at_ = 0;
};

/// Appends the point as hexadecimal floats.
void add_words(std::string& text, const std::array<double, 3>& p);
/// Appends how many faces there are, and all of them.
void add_words(std::string& text, const Scene& scene);

}  // namespace gnomon::scene
