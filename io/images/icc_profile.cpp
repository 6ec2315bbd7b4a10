#include "io/images/icc_profile.h"

#include <fmt/format.h>
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
struct DeleteTransform {
  void operator()(void* transform) const { cmsDeleteTransform(transform); }
};
using Profile = std::unique_ptr<void, CloseProfile>;
using CmsCurve = std::unique_ptr<cmsToneCurve, FreeCurve>;
using Text = std::unique_ptr<cmsMLU, FreeText>;

template <class Condition>
void require(const Condition& condition) {
  if (!condition) throw std::runtime_error("Little CMS cannot make an ICC profile");
}

/// ICC's parametric curve of type 3 is our form (Little CMS counts types from 1); a plain power is
/// its type 0. (source: ICC2010, 10.15)
CmsCurve tone_curve(const TransferFunction& t) {
  if (t.knee == 0.0) return CmsCurve(cmsBuildGamma(nullptr, t.exponent));
  const std::array<double, 5> parameters = {t.exponent, t.scale, t.offset, t.slope, t.knee};
  return CmsCurve(cmsBuildParametricToneCurve(nullptr, 4, parameters.data()));
}

cmsCIExyY xyy(const Chromaticity& c) {
  return {c.x, c.y, 1.0};
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

} // namespace

std::string profile_name(const DisplayEncoding& encoding) {
  std::string space = encoding.space == srgb_space() ? "sRGB" : encoding.space.name;
  const TransferFunction& transfer = encoding.transfer;
  if (transfer == encoding.space.transfer) return space;
  if (transfer == linear_transfer()) return "linear " + space;
  return fmt::format("{}, {}{}", space, transfer.knee == 0.0 ? "gamma " : "", transfer.name);
}

std::vector<std::byte> icc_profile(const DisplayEncoding& encoding, IccVersion version) {
  if (version == IccVersion::none) return {};
  const CmsCurve curve = tone_curve(encoding.transfer);
  require(curve);
  const RgbPrimaries& p = encoding.space.primaries;
  const cmsCIExyY white = xyy(encoding.space.white);
  const cmsCIExyYTRIPLE primaries = {xyy(p.red), xyy(p.green), xyy(p.blue)};
  const std::array<cmsToneCurve*, 3> curves = {curve.get(), curve.get(), curve.get()};
  const Profile profile(cmsCreateRGBProfile(&white, &primaries, curves.data()));
  require(profile);
  cmsSetProfileVersion(profile.get(), version == IccVersion::v2 ? 2.1 : 4.3);
  const Text text(cmsMLUalloc(nullptr, 1));
  require(text);
  require(cmsMLUsetASCII(text.get(), "en", "US", profile_name(encoding).c_str()));
  require(cmsWriteTag(profile.get(), cmsSigProfileDescriptionTag, text.get()));

  cmsUInt32Number size = 0;
  require(cmsSaveProfileToMem(profile.get(), nullptr, &size));
  std::vector<std::byte> bytes(size);
  require(cmsSaveProfileToMem(profile.get(), bytes.data(), &size));
  fix_header(bytes);
  return bytes;
}

void take_to_linear_srgb(std::vector<float>& rgb, std::span<const std::byte> bytes) {
  const Profile from(
      cmsOpenProfileFromMem(bytes.data(), static_cast<cmsUInt32Number>(bytes.size())));
  if (!from || cmsGetColorSpace(from.get()) != cmsSigRgbData)
    throw std::runtime_error("its colour profile is damaged or is none of RGB");
  const std::vector<std::byte> linear = icc_profile({srgb_space(), linear_transfer()});
  const Profile to(
      cmsOpenProfileFromMem(linear.data(), static_cast<cmsUInt32Number>(linear.size())));
  require(to);
  const std::unique_ptr<void, DeleteTransform> transform(
      cmsCreateTransform(from.get(), TYPE_RGB_FLT, to.get(), TYPE_RGB_FLT,
                         INTENT_RELATIVE_COLORIMETRIC, cmsFLAGS_NOOPTIMIZE | cmsFLAGS_NOCACHE));
  if (!transform) throw std::runtime_error("its colour profile cannot be applied");
  cmsDoTransform(transform.get(), rgb.data(), rgb.data(),
                 static_cast<cmsUInt32Number>(rgb.size() / 3));
}

} // namespace abbe
