#include "io/images/icc_profile.h"

#include "tests/catch.h"

#include <lcms2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <string>

using namespace abbe;

namespace {

using Vec3 = std::array<double, 3>;
using Mat3 = std::array<Vec3, 3>; // rows

Vec3 product(const Mat3& m, const Vec3& v) {
  Vec3 result{};
  for (std::size_t i = 0; i < 3; ++i)
    result[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
  return result;
}

double determinant(const Mat3& m) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

/// Solves m x = v by Cramer's rule.
Vec3 solve(const Mat3& m, const Vec3& v) {
  Vec3 result{};
  for (std::size_t column = 0; column < 3; ++column) {
    Mat3 replaced = m;
    for (std::size_t row = 0; row < 3; ++row)
      replaced[row][column] = v[row];
    result[column] = determinant(replaced) / determinant(m);
  }
  return result;
}

Vec3 xyz_of_xy(double x, double y) {
  return {x / y, 1.0, (1.0 - x - y) / y};
}

/// XYZ under D50 of linear RGB. The primaries are scaled so that (1, 1, 1) is the white; the result
/// is adapted to the profile connection space's D50 by Bradford's matrix.
Vec3 xyz_d50_of(const ColorSpace& space, const Vec3& rgb) {
  const auto& [red, green, blue] = space.primaries;
  const Vec3 r = xyz_of_xy(red.x, red.y), g = xyz_of_xy(green.x, green.y),
             b = xyz_of_xy(blue.x, blue.y);
  const Mat3 primaries = {{{r[0], g[0], b[0]}, {r[1], g[1], b[1]}, {r[2], g[2], b[2]}}};
  const Vec3 white = xyz_of_xy(space.white.x, space.white.y), d50 = {0.9642, 1.0, 0.8249};
  const Vec3 scale = solve(primaries, white);
  const Mat3 bradford = {{{0.8951, 0.2664, -0.1614}, //
                          {-0.7502, 1.7135, 0.0367}, //
                          {0.0389, -0.0685, 1.0296}}};
  Vec3 cone = product(
      bradford, product(primaries, {rgb[0] * scale[0], rgb[1] * scale[1], rgb[2] * scale[2]}));
  const Vec3 from = product(bradford, white), to = product(bradford, d50);
  for (std::size_t i = 0; i < 3; ++i)
    cone[i] *= to[i] / from[i];
  return solve(bradford, cone);
}

/// sRGB by the numbers of its standard, not by the program's table.
Vec3 xyz_d50_of_linear(const Vec3& rgb) {
  ColorSpace srgb;
  srgb.primaries = {{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}};
  srgb.white = {0.3127, 0.3290};
  return xyz_d50_of(srgb, rgb);
}

double linear_of_srgb(double v) {
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

/// XYZ (D50) that Little CMS makes of the colour, read with the profile's bytes alone.
Vec3 transformed(const std::vector<std::byte>& profile, const Vec3& rgb, cmsUInt32Number format,
                 cmsHPROFILE output) {
  cmsHPROFILE input =
      cmsOpenProfileFromMem(profile.data(), static_cast<cmsUInt32Number>(profile.size()));
  REQUIRE(input != nullptr);
  cmsHTRANSFORM transform = cmsCreateTransform(input, TYPE_RGB_DBL, output, format,
                                               INTENT_RELATIVE_COLORIMETRIC, cmsFLAGS_NOOPTIMIZE);
  REQUIRE(transform != nullptr);
  Vec3 result{};
  cmsDoTransform(transform, rgb.data(), result.data(), 1);
  cmsDeleteTransform(transform);
  cmsCloseProfile(output);
  cmsCloseProfile(input);
  return result;
}

const std::array<Vec3, 8> colors = {{{1, 1, 1},
                                     {1, 0, 0},
                                     {0, 1, 0},
                                     {0, 0, 1},
                                     {0.5, 0.5, 0.5},
                                     {0.03, 0.04, 0.05},
                                     {0.9, 0.2, 0.6},
                                     {0, 0, 0}}};

} // namespace

TEST_CASE("the sRGB profile gives the closed-form XYZ") {
  for (const Vec3& rgb : colors) {
    const Vec3 expected =
        xyz_d50_of_linear({linear_of_srgb(rgb[0]), linear_of_srgb(rgb[1]), linear_of_srgb(rgb[2])});
    const Vec3 xyz = transformed(icc_profile({}), rgb, TYPE_XYZ_DBL, cmsCreateXYZProfile());
    for (std::size_t i = 0; i < 3; ++i)
      CHECK(std::abs(xyz[i] - expected[i]) < 1e-4); // the file has steps of 2^-16
  }
}

TEST_CASE("the linear profile has the same primaries and no curve") {
  for (const Vec3& rgb : colors) {
    const Vec3 expected = xyz_d50_of_linear(rgb);
    const Vec3 xyz = transformed(icc_profile({srgb_space(), linear_transfer()}), rgb, TYPE_XYZ_DBL,
                                 cmsCreateXYZProfile());
    for (std::size_t i = 0; i < 3; ++i)
      CHECK(std::abs(xyz[i] - expected[i]) < 1e-4);
  }
}

TEST_CASE("middle grey of sRGB has the L* of its definition") {
  // L* = 116 Y^(1/3) - 16 (CIE 15), Y = linear(0.5) = 0.2140: L* = 53.39; a* = b* = 0.
  const Vec3 lab =
      transformed(icc_profile({}), {0.5, 0.5, 0.5}, TYPE_Lab_DBL, cmsCreateLab4Profile(nullptr));
  CHECK(std::abs(lab[0] - (116.0 * std::cbrt(linear_of_srgb(0.5)) - 16.0)) < 0.01);
  CHECK(std::abs(lab[1]) < 0.02);
  CHECK(std::abs(lab[2]) < 0.02);
}

TEST_CASE("a profile is the same bytes whenever it is made") {
  const std::vector<std::byte> srgb = icc_profile({}),
                               linear = icc_profile({srgb_space(), linear_transfer()});
  // Little CMS dates a profile to the second: let the second change.
  for (const std::time_t start = std::time(nullptr); std::time(nullptr) == start;) {
  }
  CHECK(icc_profile({}) == srgb);
  CHECK(icc_profile({srgb_space(), linear_transfer()}) == linear);
  CHECK(srgb != linear);
}

TEST_CASE("a profile's header is fixed: version 4.3, date of the sRGB standard's year, no id") {
  for (const std::vector<std::byte>& bytes :
       {icc_profile({}), icc_profile({srgb_space(), linear_transfer()})}) {
    cmsHPROFILE profile =
        cmsOpenProfileFromMem(bytes.data(), static_cast<cmsUInt32Number>(bytes.size()));
    REQUIRE(profile != nullptr);
    std::tm created{};
    CHECK(cmsGetHeaderCreationDateTime(profile, &created));
    CHECK(created.tm_year == 99);
    CHECK(created.tm_mon == 0);
    CHECK(created.tm_mday == 1);
    CHECK(created.tm_hour + created.tm_min + created.tm_sec == 0);
    CHECK(std::abs(cmsGetProfileVersion(profile) - 4.3) < 1e-9);
    CHECK(cmsGetDeviceClass(profile) == cmsSigDisplayClass);
    CHECK(cmsIsMatrixShaper(profile));
    cmsCloseProfile(profile);
    CHECK(std::all_of(bytes.begin() + 84, bytes.begin() + 100,
                      [](std::byte b) { return b == std::byte{0}; }));
  }
}

TEST_CASE("the profile of every display gives the XYZ of its primaries, white and curve") {
  // Profiles hold s15Fixed16 numbers; Little CMS evaluates power laws in single precision.
  for (const ColorSpace& space : color_spaces()) {
    INFO(space.name);
    const DisplayEncoding encoding{space, space.transfer};
    for (const Vec3& rgb : colors) {
      Vec3 linear{};
      for (std::size_t i = 0; i < 3; ++i)
        linear[i] = decode(space.transfer, rgb[i]);
      const Vec3 expected = xyz_d50_of(space, linear);
      const Vec3 xyz = transformed(icc_profile(encoding), rgb, TYPE_XYZ_DBL, cmsCreateXYZProfile());
      for (std::size_t i = 0; i < 3; ++i)
        CHECK(std::abs(xyz[i] - expected[i]) < 2e-4);
    }
  }
}

TEST_CASE("a profile is named after the space, and after another curve than its own") {
  const ColorSpace ntsc = find_color_space("ntsc").value();
  CHECK(profile_name({}) == "sRGB");
  CHECK(profile_name({srgb_space(), linear_transfer()}) == "linear sRGB");
  CHECK(profile_name({ntsc, ntsc.transfer}) == "NTSC 1953");
  CHECK(profile_name({ntsc, power_transfer(2.5)}) == "NTSC 1953, gamma 2.5");
  CHECK(profile_name({ntsc, srgb_transfer()}) == "NTSC 1953, srgb");
}

// Codes go through another engine's reading of the profile as through the transfer function itself.
TEST_CASE("a profile of version 2 tells the same colours as one of version 4") {
  const auto old = icc_profile({}, IccVersion::v2), now = icc_profile({}, IccVersion::v4);
  CHECK(static_cast<int>(old[8]) == 2);
  CHECK(static_cast<int>(now[8]) == 4);
  CHECK(icc_profile({}, IccVersion::none).empty());
  for (const Vec3& code : {Vec3{0.0, 0.0, 0.0}, Vec3{0.02, 0.5, 0.9}, Vec3{1.0, 1.0, 1.0}}) {
    const Vec3 a = transformed(old, code, TYPE_XYZ_DBL, cmsCreateXYZProfile());
    const Vec3 expected = xyz_d50_of_linear(
        {linear_of_srgb(code[0]), linear_of_srgb(code[1]), linear_of_srgb(code[2])});
    for (std::size_t i = 0; i < 3; ++i)
      CHECK(a[i] == Approx(expected[i]).margin(2e-4));
  }
}
