// SPDX-License-Identifier: GPL-3.0-or-later
// Every distribution makes valid cases of its scalar, keeps its stated mix of truths, and never changes its
// cases.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>

#include "exact/shaft_ball.h"
#include "exact/shaft_box.h"
#include "fuzz/generator.h"
#include "fuzz/shaft_questions.h"
#include "scene/corpus.h"
#include "scene/input_error.h"
#include "tests/shaft_random.h"

namespace gnomon::fuzz {
namespace {

using scene::Scalar;

/// Tetrahedra strewn over a cube, as a file.
class MeshFile {
 public:
  MeshFile() {
    std::string name = (std::filesystem::temp_directory_path() / "gnomon-mesh.XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    folder_ = name;
    std::ofstream out(path());
    constexpr int kCount = 300;
    out << "OFF\n" << 4 * kCount << " " << 4 * kCount << " 0\n";
    tests::Random random(1);
    const auto coordinate = [&](double size) { return std::round(random.unit() * size * 1024) / 1024; };
    for (int i = 0; i < kCount; ++i) {
      const double x = coordinate(4), y = coordinate(4), z = coordinate(4), size = 0.125 + coordinate(0.5);
      out << x << " " << y << " " << z << "\n" << x + size << " " << y << " " << z << "\n";
      out << x << " " << y + size << " " << z << "\n" << x << " " << y << " " << z + size << "\n";
    }
    for (int v = 0; v < 4 * kCount; v += 4) {
      for (const auto& [a, b, c] : {std::array{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}) {
        out << "3 " << v + a << " " << v + b << " " << v + c << "\n";
      }
    }
  }
  MeshFile(const MeshFile&) = delete;
  MeshFile& operator=(const MeshFile&) = delete;
  ~MeshFile() { std::filesystem::remove_all(folder_); }
  [[nodiscard]] std::string path() const { return (folder_ / "tetrahedra.off").string(); }

 private:
  std::filesystem::path folder_;
};

std::vector<std::string> all_names(const MeshFile& mesh) {
  std::vector<std::string> names;
  for (const Distribution& distribution : distributions()) {
    std::string name(distribution.name);
    if (distribution.needs_argument) name += ":" + mesh.path();
    names.push_back(name);
  }
  names.insert(names.end(), {"offset:1e5", "offset:1e30", "integer-grid:16", "integer-grid:2"});
  return names;
}

/// The cases of a campaign of seed 1, through the very stream that a campaign takes.
template <class Q, class Visit>
void each_case(const std::string& name, Scalar scalar, std::uint64_t count, Visit visit) {
  const DistributionChoice choice = parse_distribution(name);
  const auto generator = make_generator<typename Q::Case>(choice, scalar);
  const std::uint32_t stream =
      stream_of(std::string(Q::id) + " " + choice.label() + " " + std::string(name_of(scalar)));
  for (std::uint64_t trial = 0; trial < count; ++trial) {
    CaseRandom random(1, stream, trial);
    visit(generator->make(random));
  }
}

template <class Q>
class DistributionsOf : public testing::Test {};
using Questions = testing::Types<ShaftBoxQuestion, ShaftBallQuestion>;
TYPED_TEST_SUITE(DistributionsOf, Questions);

TYPED_TEST(DistributionsOf, MakeValidCasesOfTheirScalarInTheStatedMix) {
  using Q = TypeParam;
  const MeshFile mesh;
  constexpr std::uint64_t kTrials = 25000;
  for (const std::string& name : all_names(mesh)) {
    const DistributionChoice choice = parse_distribution(name);
    for (const Scalar scalar : {Scalar::f32, Scalar::f64}) {
      std::vector<typename Q::Case> cases;
      bool fails = false, doubles = false;
      each_case<Q>(name, scalar, kTrials, [&](const typename Q::Case& c) {
        fails |= objection(c).has_value();
        doubles |= !is_single(c);
        cases.push_back(c);
      });
      const std::string where = name + " " + std::string(name_of(scalar));
      EXPECT_FALSE(fails) << where;
      if (scalar == Scalar::f32) {
        EXPECT_FALSE(doubles) << where;
      } else if (name.rfind("integer-grid", 0) != 0 && name.rfind("mesh", 0) != 0 && name != "offset:1e30") {
        EXPECT_TRUE(doubles) << where << ": f64 cases that are all floats test nothing new";
      }
      if (!choice.argument.empty() && !choice.distribution->needs_argument)
        continue;  // the mix is the default's
      std::vector<typename Q::Reference> references(cases.size());
      exact::refer(std::span<const typename Q::Case>(cases), std::span(references));
      std::array<double, 3> share{};
      for (const auto& reference : references)
        share[static_cast<std::size_t>(reference.truth)] += 1.0 / kTrials;
      const bool box = Q::id == ShaftBoxQuestion::id;
      const TruthMix& mix = box ? choice.distribution->least_mix : choice.distribution->least_mix_sphere;
      EXPECT_GE(share[0], mix.outside) << where;
      EXPECT_GE(share[1], mix.overlap) << where;
      EXPECT_GE(share[2], mix.inside) << where;
      EXPECT_GT(std::min({mix.outside, mix.overlap, mix.inside}), 0) << where << " states no mix";
    }
  }
}

TEST(Distributions, UniformHasEveryTruthAndLeavesWorkToThePlanes) {
  for (const Scalar scalar : {Scalar::f32, Scalar::f64}) {
    constexpr std::uint64_t kTrials = 20000;
    std::array<double, 3> share{};
    double by_plane = 0;
    each_case<ShaftBoxQuestion>("uniform", scalar, kTrials, [&](const scene::ShaftBoxCase& c) {
      const scene::Category truth = exact::classify(c);
      share[static_cast<std::size_t>(truth)] += 1.0 / kTrials;
      bool meets_extent = true;
      for (int axis = 0; axis < 3; ++axis) {
        meets_extent &= c.t.lo(axis) <= std::max(c.a.hi(axis), c.b.hi(axis)) &&
                        c.t.hi(axis) >= std::min(c.a.lo(axis), c.b.lo(axis));
      }
      by_plane += truth == scene::Category::outside && meets_extent ? 1.0 / kTrials : 0;
    });
    for (const double part : share) EXPECT_GE(part, 0.1);
    EXPECT_GE(by_plane, 0.2);
  }
}

TYPED_TEST(DistributionsOf, NearTouchIsWithinAFewUlpsOnBothSides) {
  using Q = TypeParam;
  const std::uint64_t trials = static_cast<std::uint64_t>(tests::affordable(4000));
  for (const Scalar scalar : {Scalar::f32, Scalar::f64}) {
    std::map<std::string, double> share;
    each_case<Q>("near-touch", scalar, trials, [&](const typename Q::Case& c) {
      const double ulp = scene::ulp_of(largest_number(c), scalar), part = 1.0 / static_cast<double>(trials);
      double nearest = HUGE_VAL;
      for (const exact::Boundary boundary : {exact::Boundary::outside, exact::Boundary::inside}) {
        const double length = gap_length(c, exact::gap(c, boundary), boundary);
        if (std::fabs(length) < std::fabs(nearest)) nearest = length;
      }
      share["within 8 ulps"] += std::fabs(nearest) <= 8 * ulp ? part : 0;
      if (std::fabs(nearest) <= 8 * ulp)
        share[nearest > 0 ? "beyond" : nearest < 0 ? "short of" : "on it"] += part;
    });
    const std::string where = std::string(Q::id) + " " + std::string(name_of(scalar));
    EXPECT_GE(share["within 8 ulps"], 0.6) << where;
    EXPECT_GE(share["beyond"], 0.1) << where;
    EXPECT_GE(share["short of"], 0.1) << where;
  }
}

TEST(Distributions, ArgumentsDoWhatTheySay) {
  each_case<ShaftBoxQuestion>("offset:1e5", Scalar::f32, 500, [](const scene::ShaftBoxCase& c) {
    for (const double x : numbers_of(c)) ASSERT_NEAR(std::fabs(x), 1e5, 64);
  });
  double largest = 0;
  each_case<ShaftBoxQuestion>("integer-grid:16", Scalar::f64, 500, [&](const scene::ShaftBoxCase& c) {
    for (const double x : numbers_of(c)) {
      ASSERT_TRUE(x == std::floor(x) && x >= 0 && x <= 15) << x;
      largest = std::max(largest, x);
    }
  });
  EXPECT_EQ(largest, 15);
  largest = 0;
  each_case<ShaftBoxQuestion>("integer-grid", Scalar::f64, 500, [&](const scene::ShaftBoxCase& c) {
    for (const double x : numbers_of(c)) largest = std::max(largest, x);
  });
  EXPECT_EQ(largest, 7);
  EXPECT_EQ(parse_distribution("offset:1e5").label(), "offset:1e5");
  EXPECT_EQ(parse_distribution("mesh:/far/away/m.off").label(),
            "mesh:m.off");  // results don't depend on folders
}

TEST(Distributions, BadNamesAndArgumentsAreSaidInOneLine) {
  for (const std::string name : {"",
                                 "unknown",
                                 "Uniform",
                                 "uniform:",
                                 "uniform:1",
                                 "offset:",
                                 "offset:0",
                                 "offset:0.5",
                                 "offset:-1e5",
                                 "offset:1e31",
                                 "offset:nan",
                                 "offset:inf",
                                 "offset:far",
                                 "offset:1e5x",
                                 "offset: 1e5",
                                 "offset:1:2",
                                 "integer-grid:1",
                                 "integer-grid:0",
                                 "integer-grid:1048577",
                                 "integer-grid:-8",
                                 "integer-grid:",
                                 "mesh",
                                 "mesh:",
                                 "near-touch:1"}) {
    try {
      (void)make_generator<scene::ShaftBoxCase>(parse_distribution(name), Scalar::f32);
      ADD_FAILURE() << "expected a complaint about \"" << name << "\"";
    } catch (const UsageError& error) {
      const std::string said = error.what();
      EXPECT_EQ(said.rfind("--distribution", 0), 0u) << said;
      EXPECT_EQ(said.find('\n'), std::string::npos) << said;
    }
  }
}

TEST(Distributions, MeshesThatCantBeReadAreSaidInOneLine) {
  const MeshFile mesh;
  const std::string empty = mesh.path() + ".empty.off", bad = mesh.path() + ".bad.off";
  std::ofstream(empty) << "OFF\n0 0 0\n";
  std::ofstream(bad) << "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1\n3 0 1 2\n";
  for (const std::string& file : {mesh.path() + ".none.off", mesh.path() + ".unknown", empty, bad}) {
    try {
      (void)make_generator<scene::ShaftBallCase>(parse_distribution("mesh:" + file), Scalar::f32);
      ADD_FAILURE() << "expected a complaint about " << file;
    } catch (const std::runtime_error& error) {
      const std::string said = error.what();
      EXPECT_NE(said.find(file), std::string::npos) << said;
      EXPECT_EQ(said.find('\n'), std::string::npos) << said;
    }
  }
}

/// FNV-1a of the corpus text of the first 100 cases.
template <class Q>
std::uint32_t hash_of_cases(const std::string& name, Scalar scalar) {
  std::string text;
  each_case<Q>(name, scalar, 100, [&](const typename Q::Case& c) {
    text += scene::corpus_text(Q::id, numbers_of(c), "") + "\n";
  });
  return stream_of(text);
}

struct Golden {
  const char* name;
  std::uint32_t box_f32, box_f64, ball_f32, ball_f64;
};

// A result file is its seed: were these to change, no campaign of an earlier version could be repeated. Equal
// for g++ and clang.
constexpr Golden kGolden[] = {
    {"uniform", 0xfe0a471e, 0x4aac6be2, 0x43924790, 0x554ba290},
    {"offset", 0xf0c31d1b, 0x50abce64, 0xa442419f, 0x92136774},
    {"integer-grid", 0x80b4d4a8, 0x24cb1f23, 0x537f1cf2, 0x021709b9},
    {"near-touch", 0xeec8f915, 0xed650df8, 0x2b315220, 0xca29da73},
    {"nested", 0x7c36d9a2, 0xe7ad4e87, 0xfd75a701, 0xe8590ce9},
    {"degenerate", 0x5784fbab, 0xeaa5b764, 0x4f1735fa, 0xa63e69e7},
    {"thin", 0xb2cc97a0, 0x9aa43cfe, 0x669ca942, 0xc74afa9b},
    {"mixed-magnitude", 0xbe60fbef, 0x7444df10, 0x552d7f0e, 0xd16b16f3},
    {"denormal", 0xfd5975de, 0x22a2c08c, 0xae63237c, 0x9c192c2a},
    {"huge", 0x83e1dca5, 0x4c173cdf, 0x9688587c, 0xd61c995e},
    {"mesh:tetrahedra.off", 0x212bab69, 0x0ea7f72a, 0xb5ceb85b, 0xaa8198f0},
    {"offset:1e5", 0x538182e7, 0x05beb183, 0x694c8260, 0x2360f26f},
    {"offset:1e30", 0xf0940a65, 0xf14c7a55, 0x3a3cbca7, 0x5fbe5408},
    {"integer-grid:16", 0x61b222dd, 0x35bfb96c, 0x5b51d629, 0x5b0195cc},
    {"integer-grid:2", 0x4deedb72, 0xf90fffa1, 0x65246b0a, 0x0d2dbf91},
};

TEST(Distributions, CasesNeverChange) {
  const MeshFile mesh;
  std::size_t checked = 0;
  for (const std::string& name : all_names(mesh)) {
    const std::string label = parse_distribution(name).label();
    const std::array<std::uint32_t, 4> found{hash_of_cases<ShaftBoxQuestion>(name, Scalar::f32),
                                             hash_of_cases<ShaftBoxQuestion>(name, Scalar::f64),
                                             hash_of_cases<ShaftBallQuestion>(name, Scalar::f32),
                                             hash_of_cases<ShaftBallQuestion>(name, Scalar::f64)};
    char text[120];
    std::snprintf(text, sizeof text, "{\"%s\", 0x%08x, 0x%08x, 0x%08x, 0x%08x},", label.c_str(), found[0],
                  found[1], found[2], found[3]);
    for (const Golden& golden : kGolden) {
      if (golden.name != label) continue;
      ++checked;
      EXPECT_EQ(found, (std::array{golden.box_f32, golden.box_f64, golden.ball_f32, golden.ball_f64}))
          << text;
    }
    if (std::getenv("GNOMON_PRINT_GOLDEN") != nullptr) std::puts(text);
  }
  EXPECT_EQ(checked, distributions().size() + 4);
}

}  // namespace
}  // namespace gnomon::fuzz
