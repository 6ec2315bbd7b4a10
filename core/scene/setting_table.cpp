#include "core/scene/setting_table.h"

#include "spectral/band_grid.h"

#include <fmt/format.h>

#include <array>
#include <type_traits>

namespace abbe {
namespace {

constexpr Word<bool> kOnOff[] = {{"on", true}, {"off", false}};
constexpr Word<Skips> kSkips[] = {{"on", Skips(true)}, {"off", Skips(false)}};
constexpr Word<Integrator> kIntegrators[] = {{"whitted", Integrator::whitted},
                                             {"path", Integrator::path}};
constexpr Word<PixelFilter> kFilters[] = {
    {"box", PixelFilter::box}, {"tent", PixelFilter::tent}, {"gaussian", PixelFilter::gaussian}};
constexpr Word<Sky> kSkies[] = {{"visible", Sky::visible}, {"transparent", Sky::transparent}};
constexpr Word<ShadowRule> kShadowRules[] = {{"none", ShadowRule::none},
                                             {"opaque", ShadowRule::opaque},
                                             {"attenuated", ShadowRule::attenuated},
                                             {"automatic", ShadowRule::automatic}};
constexpr Word<Caustics> kCaustics[] = {
    {"on", Caustics::on}, {"off", Caustics::off}, {"automatic", Caustics::automatic}};
constexpr Word<AdaptiveSampling> kAdaptive[] = {{"on", AdaptiveSampling::on},
                                                {"off", AdaptiveSampling::off},
                                                {"automatic", AdaptiveSampling::automatic}};
constexpr Word<Observer> kObservers[] = {{"2deg", Observer::cie1931_2deg, "2"},
                                         {"10deg", Observer::cie1964_10deg, "10"}};
constexpr Word<Tracing> kTracings[] = {{"single", Tracing::single}, {"packets", Tracing::packets}};
constexpr Word<GamutMapping> kGamuts[] = {{"clip", GamutMapping::clip},
                                          {"scale", GamutMapping::scale},
                                          {"desaturate", GamutMapping::desaturate},
                                          {"none", GamutMapping::none}};
constexpr Word<AdaptationMethod> kAdaptations[] = {{"bradford", AdaptationMethod::bradford},
                                                   {"cat16", AdaptationMethod::cat16}};
constexpr Word<ToneCurve> kTones[] = {{"linear", ToneCurve::linear}, {"filmic", ToneCurve::filmic}};

using Whole = WholeNumber<RenderSettings>;
using Real = RealNumber<RenderSettings>;
using S = RenderSettings;

constexpr double kMostSamples = 1 << 24;
constexpr Range kSide{"a number of pixels", 1.0, 65536.0};
constexpr Range kEdge{"an edge in pixels", 0.0, 65536.0};
constexpr Range kFraction{"a fraction of the light", 0.0, 1.0};

constexpr bool follows_paths(const RenderSettings& s) {
  return s.integrator == Integrator::path;
}
constexpr bool shares_rays(const RenderSettings& s) {
  return !s.exact;
}

constexpr auto kRenderTable = std::to_array<RenderSetting>({
    {.value = RenderChoice<Integrator>{&S::integrator, kIntegrators},
     .keyword = "integrator",
     .option = "--integrator",
     .help = "How light is followed",
     .metadata = "integrator",
     .variation = "integrator"},
    {.value = Whole{&S::bands, {"a number of bands", 1.0, BandGrid::kMaxCount}},
     .keyword = "bands",
     .arguments = "n",
     .option = "--bands",
     .help = "Wavelength bands",
     .metadata = "bands",
     .variation = "bands"},
    {.value = Whole{&S::samples_per_pixel, {"a number of samples per pixel", 1.0, kMostSamples}},
     .keyword = "samples",
     .arguments = "n",
     .option = "--spp",
     .help = "Samples per pixel; in the mean with --adaptive, the most with --noise or --time",
     .default_words = "16, or 4096 with --noise or --time",
     .metadata = "samples"},
    {.value = RenderChoice<AdaptiveSampling>{&S::adaptive, kAdaptive},
     .keyword = "adaptive",
     .option = "--adaptive",
     .help = "Pixels get the more samples the noisier they are",
     .default_words = "automatic: with 8 samples or more, unless --noise",
     .metadata = "adaptive",
     .variation = "adaptive"},
    {.value = RenderChoice<Observer>{&S::observer, kObservers},
     .keyword = "observer",
     .option = "--observer",
     .help = "CIE standard observer, of 1931 or of 1964",
     .metadata = "observer"},
    {.value = SeedNumber{&S::seed},
     .keyword = "seed",
     .arguments = "n",
     .option = "--seed",
     .help = "Seed of the random numbers",
     .metadata = "seed"},
    {.value = RenderChoice<PixelFilter>{&S::filter, kFilters},
     .keyword = "filter",
     .option = "--filter",
     .help = "Pixel filter",
     .metadata = "filter"},
    {.value = RenderChoice<Sky>{&S::sky, kSkies},
     .keyword = "sky",
     .option = "--sky",
     .help =
         "Show the sky, or leave it out and make alpha 0 there, to lay the picture over another",
     .metadata = "sky"},
    {.value = RenderChoice<ShadowRule>{&S::shadows, kShadowRules},
     .keyword = "shadows",
     .option = "--shadows",
     .help = "What glass does to shadow rays",
     .default_words = "automatic: attenuated with whitted, opaque with path",
     .metadata = "shadows"},
    {.value = Whole{&S::max_depth,
                    {"how often a ray may be reflected or refracted", 0.0, kNoDepthLimit}},
     .keyword = "maxRecursionDepth",
     .arguments = "n",
     .option = "--depth",
     .help = "How often a path may be reflected or refracted; the light beyond is lost",
     .default_words = "1000000: no limit",
     .metadata = "depth"},
    {.value = Real{&S::min_throughput, kFraction},
     .keyword = "minThroughput",
     .arguments = "x",
     .option = "--cutoff",
     .help = "Branches that carry less than this in every band are followed at random",
     .metadata = "minThroughput",
     .variation = "cutoff"},
    {.value = Real{&S::min_reflectivity, kFraction},
     .keyword = "minReflectivity",
     .arguments = "x",
     .option = "--min-reflectivity",
     .help = "Surfaces of a lower reflectivity send out reflected rays at random",
     .metadata = "minReflectivity"},
    {.value = Real{&S::min_transparency, kFraction},
     .keyword = "minTransparency",
     .arguments = "x",
     .option = "--min-transparency",
     .help = "Surfaces of a lower transparency send out refracted rays at random",
     .metadata = "minTransparency"},
    {.value = RenderChoice<bool>{&S::jitter, kOnOff},
     .keyword = "jitter",
     .option = "--jitter",
     .help = "Draw wavelengths inside the bands instead of taking their centres",
     .metadata = "jitter",
     .variation = "jitter"},
    {.value = RenderChoice<bool>{&S::exact, kOnOff},
     .keyword = "exact",
     .option = "--exact",
     .help = "Every band its own ray: neither tolerance nor roulette",
     .metadata = "exact",
     .variation = "exact",
     .flag = true},
    {.value = Real{&S::noise, {"a relative error", 0.0, 1.0}},
     .keyword = "noise",
     .arguments = "x",
     .option = "--noise",
     .help = "Sample each tile until its estimated relative error is at most this, such as 0.05",
     .default_words = "0: all samples",
     .metadata = "noise",
     .variation = "noise",
     .matters = [](const S& s) { return s.noise > 0.0; }},
    {.value = Real{&S::seconds, {"a time in seconds", 0.0, 1e9}},
     .option = "--time",
     .type = "SECONDS",
     .help = "End after so many seconds of rendering; the same bytes are not promised then",
     .default_words = "0: never",
     .metadata = "timeLimit",
     .matters = [](const S& s) { return s.seconds > 0.0; }},
    {.value = Real{&S::tolerance_pixels, {"a distance in pixels"}},
     .keyword = "tolerance",
     .arguments = "pixels",
     .option = "--tolerance",
     .help = "Bands share a ray while it strays less than this many pixels",
     .metadata = "tolerance",
     .variation = "tolerance",
     .matters = shares_rays},
    {.value = Whole{&S::max_fan, {"a number of rays", 1.0, BandGrid::kMaxCount}},
     .keyword = "maxFan",
     .arguments = "n",
     .option = "--fan",
     .help = "Most sub-bundles that one path follows",
     .metadata = "maxFan",
     .variation = "fan",
     .matters = shares_rays},
    {.value = RenderChoice<Caustics>{&S::caustics, kCaustics},
     .keyword = "caustics",
     .option = "--caustics",
     .help = "With path, find light that comes by mirrors and glass from its lights",
     .metadata = "caustics",
     .variation = "caustics",
     .matters = follows_paths},
    {.value = Real{&S::light_paths, {"a number of light paths per camera sample", 0.0, 1e6, true}},
     .keyword = "lightPaths",
     .arguments = "x",
     .option = "--light-paths",
     .help = "With path, light paths per camera sample",
     .metadata = "lightPaths",
     .variation = "lightpaths",
     .matters = follows_paths},
    {.value = Real{&S::bright_sky, {"a multiple of the mean luminance", 0.0, 1e15}},
     .keyword = "brightSky",
     .arguments = "x",
     .option = "--bright-sky",
     .help = "With path, light of the environment above this many times its mean goes by light "
             "paths where mirrors and glass stand",
     .metadata = "brightSky",
     .variation = "brightsky",
     .matters = follows_paths},
    {.value = Real{&S::photon_radius, {"a length"}},
     .keyword = "photonRadius",
     .arguments = "x",
     .option = "--photon-radius",
     .help = "With path, how far a photon of the first pass counts as near, in scene units",
     .default_words = "0: by the scene's size",
     .metadata = "photonRadius",
     .matters = follows_paths},
    {.value = RenderChoice<bool>{&S::keep_errors, kOnOff},
     .option = "--errors",
     .help = "Write the channels samples and error.Y into EXR, as --noise and --time do",
     .flag = true},
    {.value = LayerNames{},
     .option = "--layers",
     .type = "NAME,...",
     .help = "Further layers of EXR, such as depth,normal,object,light:*; docs/layers.md has all"},
    {.value = RenderChoice<bool>{&S::relightable, kOnOff},
     .option = "--relightable",
     .help = "Write the bands of each group of lights under light of equal energy, for relight",
     .flag = true},
    {.value = RenderChoice<bool>{&S::band_images, kOnOff},
     .option = "--band-images",
     .help = "Write each band's part of the picture alone, in colour: NAME.band001.exr, ...",
     .flag = true},
    {.value = ImageSize{kSide},
     .keyword = "imageSize",
     .arguments = "width height",
     .option = "--size",
     .type = "WxH",
     .help = "Image size in pixels"},
    {.value = CropCorners{kEdge},
     .keyword = "crop",
     .arguments = "x0 y0 x1 y1",
     .option = "--crop",
     .type = "x0,y0,x1,y1",
     .help = "Render only pixels x0 <= x < x1, y0 <= y < y1, counted from the upper left corner"},
    {.value = Whole{&S::threads, {"a number of threads", 1.0, 4096.0}},
     .option = "--threads",
     .help = "Threads",
     .default_words = "one per processor"},
    {.value = RenderChoice<Skips>{&S::skip, kSkips},
     .option = "--skip",
     .help = "Leave out what the plan finds to be without effect"},
    {.value = RenderChoice<Tracing>{&S::tracing, kTracings},
     .option = "--tracing",
     .help = "How rays are handed to Embree; the image is the same"},
});

using D = DisplaySettings;

constexpr auto kDisplayTable = std::to_array<DisplaySetting>({
    {.value = DisplaySpace{},
     .keyword = "display",
     .arguments = "NAME",
     .option = "--display",
     .type = "NAME",
     .help = "Colour space of TIFF and PNG",
     .default_words = "srgb",
     .metadata = "display"},
    {.value = DisplayTransfer{},
     .keyword = "transfer",
     .arguments = "NAME | GAMMA",
     .option = "--transfer",
     .type = "NAME|GAMMA",
     .help = "Transfer function of TIFF and PNG",
     .default_words = "that of the display",
     .metadata = "transfer"},
    {.value = Choice<D, GamutMapping>{&D::gamut, kGamuts},
     .keyword = "gamut",
     .option = "--gamut",
     .help = "How TIFF and PNG treat colours that the display cannot show",
     .metadata = "gamut"},
    {.value = RealNumber<D>{&D::exposure_ev, {"an exposure in stops", -64.0, 64.0}},
     .keyword = "exposure",
     .arguments = "stops",
     .option = "--exposure",
     .type = "EV",
     .help = "Exposure of TIFF and PNG in stops",
     .metadata = "exposure"},
    {.value = DisplayWhite{},
     .keyword = "whitePoint",
     .arguments = "NAME | x y | none",
     .option = "--white-point",
     .type = "NAME|x,y",
     .help = "Light that TIFF and PNG show as white: an illuminant, or x,y",
     .default_words = "none: what is, is shown",
     .metadata = "whitePoint",
     .matters = [](const D& d) { return d.white_point.has_value(); }},
    {.value = Choice<D, AdaptationMethod>{&D::adaptation, kAdaptations},
     .keyword = "adaptation",
     .option = "--adaptation",
     .help = "How the eye's adaptation to the white point is computed",
     .metadata = "adaptation",
     .matters =
         [](const D& d) {
           return d.white_point.has_value() && d.adaptation != AdaptationMethod::bradford;
         }},
    {.value = Choice<D, ToneCurve>{&D::tone, kTones},
     .keyword = "toneCurve",
     .option = "--tone",
     .help = "How TIFF and PNG show luminances: linear ends at 1, filmic rolls off",
     .metadata = "toneCurve",
     .matters = [](const D& d) { return d.tone != ToneCurve::linear; }},
});

/// The text of one kind of value.
template <class Settings>
struct TextOf {
  const Settings& settings;

  std::string operator()(const WholeNumber<Settings>& v) const {
    return fmt::format("{}", settings.*v.member);
  }
  std::string operator()(const RealNumber<Settings>& v) const {
    return fmt::format("{}", settings.*v.member);
  }
  template <class Value>
  std::string operator()(const Choice<Settings, Value>& v) const {
    for (const Word<Value>& word : v.words)
      if (word.value == settings.*v.member) return std::string(word.word);
    return "mixed"; // some of the skips
  }
  std::string operator()(const SeedNumber& v) const {
    return fmt::format("{}", settings.*v.member);
  }
  std::string operator()(const ImageSize&) const {
    return fmt::format("{}x{}", settings.width, settings.height);
  }
  std::string operator()(const CropCorners&) const {
    if (!settings.crop) return "none";
    const PixelWindow& c = *settings.crop;
    return fmt::format("{},{},{},{}", c.x0, c.y0, c.x1, c.y1);
  }
  std::string operator()(const LayerNames&) const { return layer_list(settings.layers); }
  std::string operator()(const DisplaySpace&) const { return settings.space.name; }
  std::string operator()(const DisplayTransfer&) const {
    return settings.transfer.value_or(settings.space.transfer).name;
  }
  std::string operator()(const DisplayWhite&) const {
    if (!settings.white_point) return "none";
    const Chromaticity& white = settings.white_point->cie1931_2deg;
    return fmt::format("{:.6f} {:.6f}", white.x, white.y);
  }
};

struct WordsOf {
  template <class Settings, class Value>
  std::string operator()(const Choice<Settings, Value>& choice) const {
    std::string list;
    for (const Word<Value>& word : choice.words)
      list += (list.empty() ? "" : "|") + std::string(word.word);
    return list;
  }
  template <class Other>
  std::string operator()(const Other&) const {
    return "";
  }
};

} // namespace

std::span<const RenderSetting> render_setting_table() {
  return kRenderTable;
}

std::span<const DisplaySetting> display_setting_table() {
  return kDisplayTable;
}

std::string value_text(const RenderSetting& row, const RenderSettings& settings) {
  return std::visit(TextOf<RenderSettings>{settings}, row.value);
}

std::string value_text(const DisplaySetting& row, const DisplaySettings& settings) {
  return std::visit(TextOf<DisplaySettings>{settings}, row.value);
}

std::string choice_words(const RenderSetting& row) {
  return std::visit(WordsOf{}, row.value);
}

std::string choice_words(const DisplaySetting& row) {
  return std::visit(WordsOf{}, row.value);
}

} // namespace abbe
