// SPDX-License-Identifier: MIT
#include "scene/scene_facts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <tuple>
#include <utility>

#include "scene/orientation.h"

namespace gnomon::scene {
namespace {

using Corners = std::array<std::uint32_t, 3>;

/// Sorts the list and says how many of it equal the one before.
template <class T, class Less>
std::size_t count_repeated(std::vector<T>& list, Less less) {
  std::sort(list.begin(), list.end(), less);
  std::size_t repeated = 0;
  for (std::size_t i = 1; i < list.size(); ++i) repeated += less(list[i - 1], list[i]) ? 0 : 1;
  return repeated;
}

std::size_t count_duplicates(const Scene& scene) {
  std::vector<Corners> triangles = scene.triangles;
  for (Corners& corners : triangles) std::ranges::sort(corners);
  std::vector<Ball<double>> balls = scene.balls;
  const auto less_ball = [](const Ball<double>& a, const Ball<double>& b) {
    return std::tie(a.centre, a.radius) < std::tie(b.centre, b.radius);
  };
  return count_repeated(triangles, std::less<>()) + count_repeated(balls, less_ball);
}

bool is_closed(std::span<const Corners> triangles) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  edges.reserve(3 * triangles.size());
  for (const Corners& t : triangles) {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
    for (std::size_t k = 0; k < 3; ++k) edges.push_back(std::minmax(t[k], t[(k + 1) % 3]));
  }
  std::ranges::sort(edges);
  for (std::size_t i = 0; i < edges.size(); i += 2) {
    if (i + 1 == edges.size() || edges[i] != edges[i + 1]) return false;
    if (i + 2 < edges.size() && edges[i] == edges[i + 2]) return false;
  }
  return true;
}

/// The greatest double that is at most a - b. The sum is finite for valid balls.
double difference_below(double a, double b) {
  const double difference = a - b;
  // Knuth's error of a difference; it is exact, as sums of doubles don't underflow.
  const double back = difference - a;
  const double error = (a - (difference - back)) - (b + back);
  return error < 0 ? std::nextafter(difference, -std::numeric_limits<double>::infinity()) : difference;
}

}  // namespace

Box<double> extent_of(const Scene& scene) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Box<double> box{{kInfinity, kInfinity, kInfinity, -kInfinity, -kInfinity, -kInfinity}};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double &lo = box.c[axis], &hi = box.c[axis + 3];
    for (const auto& point : scene.points) {
      lo = std::min(lo, point[axis]);
      hi = std::max(hi, point[axis]);
    }
    for (const Ball<double>& ball : scene.balls) {
      lo = std::min(lo, difference_below(ball.centre[axis], ball.radius));
      hi = std::max(hi, -difference_below(-ball.centre[axis], ball.radius));
    }
  }
  return box;
}

std::size_t SceneFacts::closed_objects() const {
  return static_cast<std::size_t>(std::count(closed.begin(), closed.end(), true));
}

SceneFacts facts_of(const Scene& scene) {
  SceneFacts facts;
  for (const Corners& t : scene.triangles) {
    facts.degenerate += are_collinear(scene.points[t[0]], scene.points[t[1]], scene.points[t[2]]) ? 1 : 0;
  }
  for (const Ball<double>& ball : scene.balls) facts.degenerate += ball.radius == 0 ? 1 : 0;
  facts.duplicate = count_duplicates(scene);
  for (const Object& object : scene.objects) {
    facts.closed.push_back(
        is_closed(std::span(scene.triangles).subspan(object.first_triangle, object.triangle_count)));
  }
  facts.extent = extent_of(scene);
  return facts;
}

}  // namespace gnomon::scene
