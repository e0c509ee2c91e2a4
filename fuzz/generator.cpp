// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/generator.h"

#include <charconv>
#include <filesystem>

#include "fuzz/distributions.h"
#include "fuzz/mesh_generator.h"

namespace gnomon::fuzz {

namespace {

constexpr std::uint64_t kMostPerShaft = 1 << 20;

using scene::Scalar;
using scene::ShaftBallCase;
using scene::ShaftBoxCase;

/// A generator from a function that makes triples; balls take the place of their third boxes.
template <class F, class Make>
class BoxGenerator final : public Generator<ShaftBoxCase> {
 public:
  explicit BoxGenerator(Make make) : make_(std::move(make)) {}
  [[nodiscard]] ShaftBoxCase make(CaseRandom& random) const override {
    return scene::converted<double>(make_(random));
  }

 private:
  Make make_;
};

template <class F, class Make>
class BallGenerator final : public Generator<ShaftBallCase> {
 public:
  explicit BallGenerator(Make make) : make_(std::move(make)) {}
  [[nodiscard]] ShaftBallCase make(CaseRandom& random) const override {
    return with_ball(random, Triple<F>(make_(random)));
  }

 private:
  Make make_;
};

template <class F>
class NearTouchBallGenerator final : public Generator<ShaftBallCase> {
 public:
  [[nodiscard]] ShaftBallCase make(CaseRandom& random) const override { return near_touch_ball<F>(random); }
};

template <class Case, class F, class Make>
std::unique_ptr<Generator<Case>> generator_of(Make make) {
  if constexpr (std::is_same_v<Case, ShaftBoxCase>) {
    return std::make_unique<BoxGenerator<F, Make>>(std::move(make));
  } else {
    return std::make_unique<BallGenerator<F, Make>>(std::move(make));
  }
}

/// ARG as a number in [least, most], or `otherwise` when there is none.
double number_argument(const DistributionChoice& choice, double otherwise, double least, double most) {
  if (choice.argument.empty()) return otherwise;
  double value = 0;
  const char* const end = choice.argument.data() + choice.argument.size();
  const auto [stop, error] = std::from_chars(choice.argument.data(), end, value);
  if (error != std::errc{} || stop != end || !(value >= least && value <= most)) {
    throw UsageError("--distribution " + std::string(choice.distribution->name) + ": expected " +
                     std::string(choice.distribution->argument) + ", found \"" + choice.argument + "\"");
  }
  return value;
}

template <class Case, class F>
std::unique_ptr<Generator<Case>> make_for(const DistributionChoice& choice) {
  const std::string_view name = choice.distribution->name;
  // Exponents: what is mixed stays clear of over- and underflow of the fourth powers that balls take.
  constexpr int kMixed = std::is_same_v<F, float> ? 30 : 200;
  constexpr int kLargest = std::numeric_limits<F>::max_exponent - 1;
  if (name == "uniform") return generator_of<Case, F>([](CaseRandom& r) { return uniform_triple<F>(r); });
  if (name == "offset") {
    const double magnitude = number_argument(choice, 0, 1, 1e30);
    return generator_of<Case, F>([magnitude](CaseRandom& r) {
      constexpr double kMagnitudes[] = {1e3, 1e5, 1e7};
      const int which = r.below(3);
      return offset_triple<F>(r, magnitude > 0 ? magnitude : kMagnitudes[which]);
    });
  }
  if (name == "integer-grid") {
    const int size = static_cast<int>(number_argument(choice, 8, 2, 1 << 20));
    return generator_of<Case, F>([size](CaseRandom& r) { return grid_triple<F>(r, size); });
  }
  if (name == "near-touch") {
    if constexpr (std::is_same_v<Case, ShaftBallCase>) {
      return std::make_unique<NearTouchBallGenerator<F>>();
    } else {
      return generator_of<Case, F>([](CaseRandom& r) { return near_touch_triple<F>(r); });
    }
  }
  if (name == "nested") return generator_of<Case, F>([](CaseRandom& r) { return nested_triple<F>(r); });
  if (name == "degenerate")
    return generator_of<Case, F>([](CaseRandom& r) { return degenerate_triple<F>(r); });
  if (name == "thin") return generator_of<Case, F>([](CaseRandom& r) { return thin_triple<F>(r); });
  if (name == "mixed-magnitude") {
    return generator_of<Case, F>([](CaseRandom& r) { return mixed_triple<F>(r, -kMixed, kMixed); });
  }
  if (name == "denormal") return generator_of<Case, F>([](CaseRandom& r) { return denormal_triple<F>(r); });
  if (name == "huge") {
    return generator_of<Case, F>(
        [](CaseRandom& r) { return mixed_triple<F>(r, kLargest - 24, kLargest - 1); });
  }
  return make_mesh_generator<Case, F>(choice.argument);
}

}  // namespace

const std::vector<Distribution>& distributions() {
  static const std::vector<Distribution> all{
      {"uniform",
       "",
       "small boxes at random places of the unit cube; t in the shaft, at it, and about it",
       {0.1, 0.1, 0.1},
       {0.1, 0.1, 0.1},
       true,
       false},
      {"offset",
       "the distance, 1 to 1e30",
       "uniform, 16 times as large, moved 1e3, 1e5 or 1e7 away on each axis",
       {0.1, 0.1, 0.05},
       {0.1, 0.1, 0.05},
       true,
       false},
      {"integer-grid",
       "the number of grid lines, 2 to 1048576",
       "all coordinates are integers from 0 to 7",
       {0.1, 0.1, 0.05},
       {0.05, 0.1, 0.02},
       true,
       false},
      {"near-touch",
       "",
       "walked to within 4 ulps of the boundary of outside or inside, both sides",
       {0.1, 0.1, 0.1},
       {0.1, 0.1, 0.1},
       true,
       false},
      {"nested",
       "",
       "boxes within boxes, some sides shared",
       {0.01, 0.1, 0.1},
       {0.01, 0.05, 0.1},
       true,
       false,
       false},
      {"degenerate",
       "",
       "flat boxes, points, coordinates shared between boxes",
       {0.1, 0.1, 0.03},
       {0.1, 0.1, 0.001},
       true,
       false},
      {"thin", "", "sides from 2^-20 to 1 in one box", {0.1, 0.1, 0.1}, {0.1, 0.1, 0.1}, true, false},
      {"mixed-magnitude",
       "",
       "coordinates of sizes 2^-30 to 2^30 side by side (doubles: 2^-200 to 2^200)",
       {0.1, 0.1, 0.03},
       {0.1, 0.1, 0.01},
       true,
       false},
      {"denormal", "", "multiples of the smallest denormal", {0.1, 0.1, 0.1}, {0.1, 0.1, 0.1}, false, false},
      {"huge",
       "",
       "coordinates up to the largest finite number",
       {0.1, 0.1, 0.02},
       {0.1, 0.1, 0.01},
       false,
       false},
      {"mesh",
       "a mesh file: .off, .obj, .ply, .stl",
       "boxes and balls of a bounding hierarchy of a mesh",
       {0.05, 0.05, 0.01},
       {0.05, 0.05, 0.005},
       true,
       true},
  };
  return all;
}

std::string DistributionChoice::label() const {
  std::string text(distribution->name);
  if (!argument.empty()) {
    const bool file = distribution->needs_argument;
    text += ":" + (file ? std::filesystem::path(argument).filename().string() : argument);
  }
  return per_shaft == 1 ? text : text + "@" + std::to_string(per_shaft);
}

namespace {

struct Parsed {
  std::string text;
  std::uint64_t per_shaft = 1;
};

/// Takes `@K` off the end. In arguments, which may be names of files, an @ that no number follows is a
/// letter.
Parsed without_per_shaft(const std::string& whole) {
  const std::size_t at = whole.rfind('@');
  if (at == std::string::npos) return {whole};
  Parsed parsed{whole.substr(0, at)};
  const char* const end = whole.data() + whole.size();
  const auto [stop, error] = std::from_chars(whole.data() + at + 1, end, parsed.per_shaft);
  const bool is_number = error == std::errc{} && stop == end;
  if (!is_number && whole.find(':') < at) return {whole};
  if (!is_number || parsed.per_shaft < 1 || parsed.per_shaft > kMostPerShaft) {
    throw UsageError("--distribution: expected @K, K cases a shaft, 1 to " + std::to_string(kMostPerShaft) +
                     ", found \"" + whole + "\"");
  }
  return parsed;
}

}  // namespace

DistributionChoice parse_distribution(const std::string& whole) {
  const auto [text, per_shaft] = without_per_shaft(whole);
  const std::size_t colon = text.find(':');
  const std::string name = text.substr(0, colon);
  std::string known;
  for (const Distribution& distribution : distributions()) {
    known += (known.empty() ? "" : ", ") + std::string(distribution.name);
    if (distribution.name != name) continue;
    const std::string argument = colon == std::string::npos ? "" : text.substr(colon + 1);
    if (distribution.argument.empty() && colon != std::string::npos) {
      throw UsageError("--distribution " + name + ": takes no argument, found \"" + argument + "\"");
    }
    if (argument.empty() && (distribution.needs_argument || colon != std::string::npos)) {
      throw UsageError("--distribution " + name + ": expected " + name + ":ARG, " +
                       std::string(distribution.argument));
    }
    if (per_shaft > 1 && !distribution.shares_shafts) {
      throw UsageError("--distribution " + name + ": its shafts depend on t, none can be shared; found \"" +
                       whole + "\"");
    }
    return {&distribution, argument, per_shaft};
  }
  throw UsageError("--distribution: expected one of " + known + ", found \"" + name + "\"");
}

template <class Case>
std::unique_ptr<Generator<Case>> make_generator(const DistributionChoice& choice, Scalar scalar) {
  return scalar == Scalar::f32 ? make_for<Case, float>(choice) : make_for<Case, double>(choice);
}

template std::unique_ptr<Generator<ShaftBoxCase>> make_generator(const DistributionChoice&, Scalar);
template std::unique_ptr<Generator<ShaftBallCase>> make_generator(const DistributionChoice&, Scalar);

}  // namespace gnomon::fuzz
