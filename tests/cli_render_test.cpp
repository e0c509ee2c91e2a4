// SPDX-License-Identifier: GPL-3.0-or-later
// gnomon render: pictures that libpng reads back, and what is refused.
#include <gtest/gtest.h>
#include <png.h>

#include <map>

#include "reports/shadow_picture.h"
#include "tests/cli_run.h"
#include "tests/shadow_scenes.h"

namespace gnomon::tests {
namespace {

using reports::Colour;

/// The pixels of a PNG file, rows from the top.
reports::Pixels read_png(const std::string& path) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  const std::string bytes = contents_of(path);
  EXPECT_NE(png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()), 0) << image.message;
  image.format = PNG_FORMAT_RGB;
  reports::Pixels pixels{image.width, image.height, {}};
  pixels.colours.resize(pixels.columns * pixels.rows);
  EXPECT_NE(png_image_finish_read(&image, nullptr, pixels.colours.data(), 0, nullptr), 0) << image.message;
  return pixels;
}

std::map<Colour, std::size_t> colours_of(const reports::Pixels& pixels) {
  std::map<Colour, std::size_t> counts;
  for (const Colour& colour : pixels.colours) ++counts[colour];
  return counts;
}

TEST(Png, ReadsBackThePixels) {
  const Folder folder;
  reports::Pixels pixels{3, 2, {}};
  for (std::uint8_t k = 0; k < 6; ++k) pixels.colours.push_back({k, static_cast<std::uint8_t>(255 - k), 7});
  const reports::Pixels read = read_png(folder.write("p.png", reports::png_of(pixels)));
  EXPECT_EQ(read.columns, 3u);
  EXPECT_EQ(read.rows, 2u);
  EXPECT_EQ(read.colours, pixels.colours);
  EXPECT_THROW((void)reports::png_of({}), std::runtime_error);
  EXPECT_THROW((void)reports::png_of({2, 2, pixels.colours}), std::runtime_error);
}

TEST(CommandLineRender, DrawsTheSceneInTheViewsSizeOrAnother) {
  const Folder folder;
  folder.write("s.nff", kBallsNff);
  const Outcome run =
      run_gnomon({"render", "s.nff", "--method", "bvh-exact", "-o", "new/s.png"}, folder.path());
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out, "");
  EXPECT_NE(run.err.find("bvh-exact: 0 of "), std::string::npos) << run.err;
  const reports::Pixels pixels = read_png(folder / "new/s.png");
  EXPECT_EQ(pixels.columns, 160u);
  EXPECT_EQ(pixels.rows, 120u);
  EXPECT_GT(colours_of(pixels).size(), 20u);
  ASSERT_EQ(run_gnomon({"render", "s.nff", "--method", "reference", "-o", "t.PNG", "--size", "31x17"},
                       folder.path())
                .status,
            0);
  EXPECT_EQ(read_png(folder / "t.PNG").columns, 31u);
  EXPECT_EQ(read_png(folder / "t.PNG").rows, 17u);
  // The same picture from exact rows.
  ASSERT_EQ(run_gnomon({"render", "s.nff", "--method", "reference", "-o", "u.png"}, folder.path()).status, 0);
  EXPECT_EQ(read_png(folder / "u.png").colours, pixels.colours);
}

/// A method that errs everywhere.
struct AlwaysLit : fuzz::SceneCaster {
  void shadows(std::span<const scene::ShadowQuery> /*queries*/,
               std::span<fuzz::Answer> answers) const override {
    std::fill(answers.begin(), answers.end(), fuzz::Answer{0});
  }
  void first_hits(std::span<const scene::RayQuery> /*rays*/,
                  std::span<std::uint32_t> /*faces*/) const override {}
  [[nodiscard]] std::size_t bytes() const override { return 0; }
};

struct AlwaysUndecided : AlwaysLit {
  void shadows(std::span<const scene::ShadowQuery> /*queries*/,
               std::span<fuzz::Answer> answers) const override {
    std::fill(answers.begin(), answers.end(), fuzz::kUndecided);
  }
};

struct AlwaysShadowed : AlwaysLit {
  void shadows(std::span<const scene::ShadowQuery> /*queries*/,
               std::span<fuzz::Answer> answers) const override {
    std::fill(answers.begin(), answers.end(), fuzz::Answer{1});
  }
};

template <class Caster>
reports::ShadowPicture draw() {
  const fuzz::SceneMethod method{
      "liar",
      "naive",
      fuzz::Promise::none,
      "",
      "",
      false,
      true,
      [](const scene::Scene&) -> std::unique_ptr<fuzz::SceneCaster> { return std::make_unique<Caster>(); }};
  const scene::Scene scene = single_scene(kBallsNff);
  return reports::draw_shadows(scene, method, 60, 40, [](double) {});
}

TEST(ShadowPictures, ColourWrongPixelsByDirection) {
  const reports::ShadowPicture lit = draw<AlwaysLit>(), dark = draw<AlwaysShadowed>(),
                               open = draw<AlwaysUndecided>();
  EXPECT_GT(lit.wrong.false_lit, 100u);
  EXPECT_EQ(lit.wrong.all(), lit.wrong.false_lit + lit.wrong.touching);
  EXPECT_EQ(colours_of(lit.errors)[reports::kFalseLit], lit.wrong.false_lit);
  EXPECT_GT(dark.wrong.false_shadowed, 100u);
  EXPECT_EQ(dark.wrong.false_lit, 0u);
  EXPECT_EQ(colours_of(dark.errors)[reports::kFalseShadowed], dark.wrong.false_shadowed);
  EXPECT_EQ(open.wrong.undecided + open.wrong.touching, open.wrong.seen);
  EXPECT_EQ(colours_of(open.errors)[reports::kUndecided], open.wrong.undecided);
  EXPECT_NE(lit.shadows.colours, dark.shadows.colours);
}

TEST(CommandLineRender, RefusesBadInputInOneLineAndWritesNothing) {
  const Folder folder;
  folder.write("far.nff", "s 0 0 3e38 1e38\n");
  folder.write("s.nff", kBallsNff);
  const std::set<std::string> before = folder.entries();
  const std::string good = "bvh-naive-f32";
  const std::pair<std::vector<std::string>, std::string> calls[] = {
      {{"s.nff", "--method", good}, "--out"},
      {{"s.nff", "-o", "p.png"}, "--method"},
      {{"s.nff", "--method", good, "-o", "p.jpg"}, "-o: expected a file name that ends in .png"},
      {{"s.nff", "--method", good, "-o", "s.nff/p.png"}, "can't be written"},
      {{"s.nff", "--method", "all", "-o", "p.png"}, "--method: expected a method"},
      {{"s.nff", "--method", "cgal-epick", "-o", "p.png"}, "s.nff: expected a scene without balls"},
      {{"far.nff", "--method", good, "-o", "p.png"}, "far.nff: expected a ball within the range of floats"},
      {{"none.nff", "--method", good, "-o", "p.png"}, "none.nff: expected"},
      {{"s.nff", "--method", good, "-o", "p.png", "--size", "0x5"}, "--size: expected WxH"},
      {{"s.nff", "--method", good, "-o", "p.png", "--size", "5"}, "--size: expected WxH"},
      {{"s.nff", "--method", good, "-o", "p.png", "--size", "5x6x7"}, "--size: expected WxH"},
      {{"s.nff", "--method", good, "-o", "p.png", "--size", "99999999x99999999"}, "--size: expected WxH"},
      {{"s.nff", "--method", good, "-o", "p.png", "--light", "1;2;3"}, "--light: expected X,Y,Z"},
  };
  for (const auto& [more, said] : calls) {
    std::vector<std::string> words{"render"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome run = run_gnomon(words, folder.path());
    EXPECT_EQ(run.status, 2) << said;
    EXPECT_EQ(run.out, "") << said;
    EXPECT_EQ(lines_of(run.err).size(), 1u) << run.err;
    EXPECT_NE(run.err.find(said), std::string::npos) << run.err << "expected " << said;
    EXPECT_EQ(folder.entries(), before) << said;
  }
}

}  // namespace
}  // namespace gnomon::tests
