// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of single cases.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace gnomon::reports {

/// Which boundary a picture is about: that between outside and overlap, that between overlap and inside, or
/// the one that the case is nearer to.
enum class PictureFocus { kNearer, kOutside, kInside };

/// An SVG picture of one case, complete in itself (own style, light and dark), for
///   shaft-box     18 numbers: Alo Ahi Blo Bhi Tlo Thi, three each
///   shaft-sphere  16 numbers: Alo Ahi Blo Bhi (three each), centre (three), radius.
///
/// It shows A, B, the shaft's silhouette and T along the axis that the deciding plane does not mention, and
/// beside it the deciding corner of T (the nearest or farthest point of the ball) magnified until the line
/// and the corner can be told apart, with the grid of floating-point numbers of `scalar` ("f32", otherwise
/// f64). A shaft of boxes projects to the shaft of the projected boxes, so the silhouette is exact. Deciding
/// is what is closest to changing the answer: the largest near-corner value over |n_x|+|n_y|+|n_z|, or for
/// cases closer to the inside | overlap boundary the largest far-corner value; for balls, distances in the
/// projection. The sign is computed in rationals.
///
/// Empty when the question has no picture, the count is wrong, a number is not finite, lo > hi or radius < 0.
[[nodiscard]] std::string case_picture_svg(std::string_view question, std::span<const double> numbers,
                                           std::string_view scalar,
                                           PictureFocus focus = PictureFocus::kNearer);

}  // namespace gnomon::reports
