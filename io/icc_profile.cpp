#include "io/icc_profile.h"

#include <lcms2.h>

#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <stdexcept>

namespace abbe {
namespace {

struct CloseProfile {
  void operator()(void* profile) const { cmsCloseProfile(profile); }
};
struct FreeCurve {
  void operator()(cmsToneCurve* curve) const { cmsFreeToneCurve(curve); }
};
struct FreeText {
  void operator()(cmsMLU* text) const { cmsMLUfree(text); }
};
using Profile = std::unique_ptr<void, CloseProfile>;
using Curve = std::unique_ptr<cmsToneCurve, FreeCurve>;
using Text = std::unique_ptr<cmsMLU, FreeText>;

template <class Condition>
void require(const Condition& condition) {
  if (!condition) throw std::runtime_error("Little CMS cannot make an ICC profile");
}

/// Y = ((X + 0.055) / 1.055)^2.4 for X >= 0.04045, else X / 12.92. (source: IEC99)
Curve srgb_curve() {
  const std::array<double, 5> parameters = {2.4, 1.0 / 1.055, 0.055 / 1.055, 1.0 / 12.92, 0.04045};
  return Curve(cmsBuildParametricToneCurve(nullptr, 4, parameters.data()));
}

/// Replaces what would differ from call to call or between systems. (source: ICC2010, 7.2)
void fix_header(std::vector<std::byte>& profile) {
  const std::span header = std::span(profile).first(128);
  // Bytes 24-35, creation date: year, month, day, hour, minute, second as big-endian 16-bit
  // numbers. 1 January of the year of the sRGB standard.
  constexpr std::array<unsigned, 6> date = {1999, 1, 1, 0, 0, 0};
  for (std::size_t i = 0; i < date.size(); ++i) {
    header[24 + 2 * i] = static_cast<std::byte>(date[i] >> 8);
    header[25 + 2 * i] = static_cast<std::byte>(date[i] & 255);
  }
  std::ranges::fill(header.subspan(40, 4), std::byte{0});  // primary platform
  std::ranges::fill(header.subspan(84, 16), std::byte{0}); // profile id
}

std::vector<std::byte> make_profile(const char* description, const Curve& curve) {
  require(curve);
  // Chromaticities of the primaries and of D65. (source: IEC99)
  const cmsCIExyY white = {0.3127, 0.3290, 1.0};
  const cmsCIExyYTRIPLE primaries = {{0.64, 0.33, 1.0}, {0.30, 0.60, 1.0}, {0.15, 0.06, 1.0}};
  const std::array<cmsToneCurve*, 3> curves = {curve.get(), curve.get(), curve.get()};
  const Profile profile(cmsCreateRGBProfile(&white, &primaries, curves.data()));
  require(profile);
  cmsSetProfileVersion(profile.get(), 4.3);
  const Text text(cmsMLUalloc(nullptr, 1));
  require(text);
  require(cmsMLUsetASCII(text.get(), "en", "US", description));
  require(cmsWriteTag(profile.get(), cmsSigProfileDescriptionTag, text.get()));

  cmsUInt32Number size = 0;
  require(cmsSaveProfileToMem(profile.get(), nullptr, &size));
  std::vector<std::byte> bytes(size);
  require(cmsSaveProfileToMem(profile.get(), bytes.data(), &size));
  fix_header(bytes);
  return bytes;
}

} // namespace

std::vector<std::byte> srgb_profile() {
  return make_profile("sRGB", srgb_curve());
}

std::vector<std::byte> linear_srgb_profile() {
  return make_profile("linear sRGB", Curve(cmsBuildGamma(nullptr, 1.0)));
}

} // namespace abbe
