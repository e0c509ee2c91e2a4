// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/picture.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "reports/case_line.h"
#include "reports/deciding_view.h"
#include "tests/report_xml_check.h"

namespace gnomon::reports {
namespace {

std::vector<double> box_case(const std::vector<double>& a, const std::vector<double>& b,
                             const std::vector<double>& t) {
  std::vector<double> numbers = a;
  numbers.insert(numbers.end(), b.begin(), b.end());
  numbers.insert(numbers.end(), t.begin(), t.end());
  return numbers;
}

/// No number that SVG can't hold, balanced tags, nothing loaded.
void expect_sound(const std::string& svg) {
  ASSERT_FALSE(svg.empty());
  EXPECT_EQ(tests::xml_fault(svg), "");
  // "nan" and "inf" as numbers: after a quote, a blank, a bracket or a path letter.
  for (const char* number : {"nan", "inf"}) {
    for (const char before : {'"', ' ', '(', 'M', 'L', 'H', 'V', '-', '>'}) {
      EXPECT_EQ(svg.find(before + std::string(number)), std::string::npos) << svg;
    }
  }
  EXPECT_EQ(svg.find("href"), std::string::npos);
}

DecidingView view_of(const std::string& question, const std::vector<double>& numbers,
                     const char* scalar = "f64") {
  return deciding_view(shaft_case(question, numbers, scalar).value());
}

const std::vector<double> kUnit = {0, 0, 0, 1, 1, 1}, kFar = {4, 4, 0, 5, 5, 1};

TEST(ReportPicture, HasNoneForOtherQuestionsAndBadNumbers) {
  const std::vector<double> good = box_case(kUnit, kFar, {2, 2, 0, 3, 3, 1});
  EXPECT_EQ(case_picture_svg("shadow", good, "f32"), "");
  EXPECT_EQ(case_picture_svg("shaft-box", std::span(good).first(17), "f32"), "");
  EXPECT_EQ(case_picture_svg("shaft-sphere", good, "f32"), "");
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 9.0}) {
    std::vector<double> numbers = good;
    numbers[12] = bad;  // 9: lo > hi
    EXPECT_EQ(case_picture_svg("shaft-box", numbers, "f64"), "");
  }
  EXPECT_EQ(case_picture_svg("shaft-sphere", box_case(kUnit, kFar, {2, 2, 0, -1}), "f64"), "");
}

TEST(ReportPicture, SurvivesDegenerateCases) {
  const double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  const std::array<std::vector<double>, 12> boxes = {{
      kUnit,
      kFar,
      {0, 0, 0, 0, 0, 0},
      {1, 1, 1, 1, 1, 1},
      {0, 0, 0, 1, 0, 0},
      {2, 0, 0, 2, 1, 1},
      {-most, -most, -most, most, most, most},
      {-1e38, 0, 0, 1e38, 1e-38, 1e-38},
      {0, 0, 0, least, least, least},
      {-least, 0, 0, 0, 0, 3 * least},
      {9999999, 9999999, 9999999, 10000000, 10000001, 10000002},
      {most, most, most, most, most, most},
  }};
  const double radii[] = {0.0, 1.0, least, most};
  std::size_t turn = 0;  // runs through targets, radii and scalars while a and b run through all pairs
  for (const auto& a : boxes) {
    for (const auto& b : boxes) {
      for (int repeat = 0; repeat < 2; ++repeat, ++turn) {
        const auto& t = boxes[turn * 5 % 12];
        const char* scalar = turn % 3 == 0 ? "f32" : "f64";
        expect_sound(case_picture_svg("shaft-box", box_case(a, b, t), scalar));
        const double r = radii[turn * 3 % 7 % 4];
        expect_sound(case_picture_svg("shaft-sphere", box_case(a, b, {t[0], t[1], t[2], r}), scalar));
        if (HasFailure()) return;
      }
    }
  }
}

TEST(ReportPicture, FindsTheDecidingPlane) {
  // The slanted plane y - x = 1 through (0,1) and (4,5) decides; T's near corner (2, 3) lies on it exactly.
  const DecidingView touching = view_of("shaft-box", box_case(kUnit, kFar, {1.5, 3, 0, 2, 3.5, 1}));
  EXPECT_EQ(touching.projection.along, 2);
  EXPECT_EQ(touching.decision, Decision::kOutside);
  EXPECT_EQ(touching.sign, 0);
  EXPECT_EQ(touching.corner, (std::array<double, 2>{2, 3}));
  // One ulp of T's corner away, on either side.
  const double up = std::nextafter(3.0, 4.0), down = std::nextafter(3.0, 2.0);
  EXPECT_EQ(view_of("shaft-box", box_case(kUnit, kFar, {1.5, up, 0, 2, 3.5, 1})).sign, 1);
  EXPECT_EQ(view_of("shaft-box", box_case(kUnit, kFar, {1.5, down, 0, 2, 3.5, 1})).sign, -1);
}

TEST(ReportPicture, TellsSidesApartFarFromTheOrigin) {
  // The same near 2^53, where an ulp is 1 and rounded products would see nothing.
  const double o = 0x1p53;
  const auto shifted = [&](std::vector<double> box) {
    for (double& x : box) x += o;
    return box;
  };
  const auto sign_at = [&](double y) {
    const std::vector<double> a = shifted({0, 0, 0, 6, 10, 6}), b = shifted({40, 46, 0, 50, 52, 6});
    return view_of("shaft-box", box_case(a, b, shifted({18, y, 0, 20, 40, 6}))).sign;
  };
  // y = 10 + 42/40 x at x = 20 is 31; doubles there are even numbers.
  EXPECT_EQ(sign_at(30), -1);
  EXPECT_EQ(sign_at(32), 1);
}

TEST(ReportPicture, ChoosesTheInsideBoundaryWhenThatIsNearer) {
  const DecidingView view = view_of("shaft-box", box_case(kUnit, kFar, {2, 2, 0.25, 2.5, 3.25, 0.75}));
  EXPECT_EQ(view.decision, Decision::kInside);
  EXPECT_EQ(view.sign, 1);  // corner (2, 3.25) is out by 1/4
  EXPECT_EQ(view.corner, (std::array<double, 2>{2, 3.25}));
}

TEST(ReportPicture, LooksAtTheBoundaryThatIsAskedFor) {
  const auto shaft =
      shaft_case("shaft-box", box_case(kUnit, kFar, {2, 2, 0.25, 2.5, 3.25, 0.75}), "f64").value();
  EXPECT_EQ(deciding_view(shaft, PictureFocus::kInside).decision, Decision::kInside);
  const DecidingView outside = deciding_view(shaft, PictureFocus::kOutside);
  EXPECT_EQ(outside.decision, Decision::kOutside);
  EXPECT_EQ(outside.sign, -1);
}

TEST(ReportPicture, ShowsTheBroaderOfTwoProjectionsThatDecideAlike) {
  // Flat in y: seen along z the case is a line; the side x <= 1 decides seen along y as well.
  const DecidingView view =
      view_of("shaft-box", box_case({0, 0, 0, 1, 0, 1}, {0, 0, 2, 1, 0, 3}, {1.5, 0, 0, 2, 0, 3}));
  EXPECT_EQ(view.projection.along, 1);
  EXPECT_EQ(view.sign, 1);
}

TEST(ReportPicture, MeasuresBalls) {
  const std::vector<double> low = {0, 0, 0, 1, 1, 1}, high = {0, 0, 4, 1, 1, 5};
  const auto ball = [&](double x, double y, double r) {
    return view_of("shaft-sphere", box_case(low, high, {x, y, 2, r}));
  };
  EXPECT_EQ(ball(3, 0.5, 2).sign, 0);
  EXPECT_EQ(ball(3, 0.5, std::nextafter(2.0, 0.0)).sign, 1);
  EXPECT_EQ(ball(3, 0.5, std::nextafter(2.0, 3.0)).sign, -1);
  // Past the corner (1, 1): 3-4-5.
  EXPECT_EQ(ball(4, 5, 5).sign, 0);
  EXPECT_EQ(ball(4, 5, std::nextafter(5.0, 0.0)).sign, 1);
  EXPECT_EQ(ball(4, 5, std::nextafter(5.0, 6.0)).sign, -1);
  // Inside, touching from within.
  const DecidingView inside = ball(0.5, 0.5, 0.5);
  EXPECT_EQ(inside.decision, Decision::kInside);
  EXPECT_EQ(inside.sign, 0);
  EXPECT_EQ(ball(0.5, 0.5, 0.25).sign, -1);
}

TEST(ReportPicture, SaysInWordsWhereTheCornerIs) {
  const std::string svg = case_picture_svg("shaft-box", box_case(kUnit, kFar, {1.5, 3, 0, 2, 3.5, 1}), "f32");
  EXPECT_NE(svg.find("Near corner exactly on the line"), std::string::npos);
  EXPECT_NE(svg.find("seen along z"), std::string::npos);
  EXPECT_NE(svg.find("float32 numbers"), std::string::npos);
  EXPECT_EQ(svg, case_picture_svg("shaft-box", box_case(kUnit, kFar, {1.5, 3, 0, 2, 3.5, 1}), "f32"));
}

TEST(ReportPicture, ReadsCaseLines) {
  EXPECT_EQ(numbers_of_case("q 0x1.8p+1 -2 1e3 # more -> 5"), (std::vector<double>{3, -2, 1000}));
  EXPECT_EQ(numbers_of_case("q 1 -> outside"), (std::vector<double>{1}));
  EXPECT_EQ(numbers_of_case("q 1 zwei"), std::nullopt);
}

}  // namespace
}  // namespace gnomon::reports
