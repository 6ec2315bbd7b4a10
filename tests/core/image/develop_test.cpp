#include "core/image/develop.h"

#include "core/image/metadata.h"
#include "core/planning/make_plan.h"
#include "tests/catch.h"
#include "tests/render_text.h"

#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace abbe;

namespace {

/// A picture of 8 x 6 pixels of which 3 x 2 are rendered, and its plan.
struct Picture {
  Plan plan;
  Film film;
};

Picture picture(int bands) {
  const Scene scene = test::scene_from("imageSize 8 6 crop 2 3 5 5 bands 3 background E 1");
  std::vector<LayerForm> layers = beauty_layers({.quantum = 0x1p-40, .bands = bands});
  layers.push_back(transparency_layer());
  Picture p{make_plan(scene, scene.settings), Film({2, 3, 5, 5}, std::move(layers))};
  const std::vector<float> radiance{0.1f, 0.2f, 0.3f};
  for (int y = 3; y < 5; ++y)
    for (int x = 2; x < 5; ++x) {
      const double v = 0.05 * (x + 3 * (y - 3));
      const Film::Place place = p.film.add({x, y, 0, true}, Xyz{0.9, 1.0, 0.8} * v, radiance);
      p.film.add(*p.film.find(kTransparency), place, x > 2 ? 0.0 : 1.0);
    }
  return p;
}

std::set<std::string> names(const Metadata& metadata) {
  std::set<std::string> result;
  for (const auto& [name, value] : metadata)
    result.insert(name);
  return result;
}

} // namespace

TEST_CASE("the windows of a crop lie inside the full frame") {
  const Picture p = picture(3);
  const PixelWindow full{0, 0, 8, 6}, part{2, 3, 5, 5};
  const SceneLinearImage linear = develop_scene_linear(p.film, p.plan);
  CHECK(linear.display == full);
  CHECK(linear.data == part);
  CHECK(linear.rgba.size() == 6 * 4);
  const DisplayImage display = develop_display(p.film, p.plan, {});
  CHECK(display.display == full);
  CHECK(display.data == part);
  CHECK(display.encoded.size() == 6 * 3);
  CHECK(display.linear.size() == 6 * 3);
  const SpectralImage spectral = develop_spectral(p.film, p.plan);
  CHECK(spectral.display == full);
  CHECK(spectral.data == part);
}

TEST_CASE("scene-linear pixels are the film's colours and alpha, row by row") {
  const Picture p = picture(0);
  const SceneLinearImage image = develop_scene_linear(p.film, p.plan);
  std::size_t i = 0;
  for (int y = 3; y < 5; ++y)
    for (int x = 2; x < 5; ++x, i += 4) {
      const LinearRgb c = to_linear_srgb(p.film.color(x, y));
      CHECK(image.rgba[i] == static_cast<float>(c.r));
      CHECK(image.rgba[i + 1] == static_cast<float>(c.g));
      CHECK(image.rgba[i + 2] == static_cast<float>(c.b));
      CHECK(image.rgba[i + 3] == (x > 2 ? 1.0f : 0.0f));
    }
}

TEST_CASE("rows of a picture are those of the whole, and a layer alone is that layer") {
  Scene scene = test::scene_from("imageSize 5 6 samples 2 bands 3 light E 0 0 5 1 sphere");
  REQUIRE(add_layers("depth,normal,object,light:*,variance", scene.settings.layers));
  scene.settings.keep_errors = true;
  const Plan plan = make_plan(scene, scene.settings);
  const Film film = std::move(test::render_scene(scene, false).film);
  const SceneLinearImage whole = develop_scene_linear(film, plan);
  const FilmPart rows{.window = {0, 2, 5, 4}};
  const SceneLinearImage part = develop_scene_linear(film, plan, SceneLinearSpace::rec709, rows);
  const auto of_rows = [](const std::vector<float>& values, std::ptrdiff_t channels) {
    return std::vector<float>(values.begin() + 10 * channels, values.begin() + 20 * channels);
  };
  CHECK(part.rgba == of_rows(whole.rgba, 4));
  REQUIRE(part.channels.size() == whole.channels.size());
  for (std::size_t i = 0; i < part.channels.size(); ++i) {
    CHECK(part.channels[i].name == whole.channels[i].name);
    CHECK(part.channels[i].values == of_rows(whole.channels[i].values, 1));
  }
  const FilmPart ids{.window = film.window(), .layer = "CryptoObject"};
  const SceneLinearImage alone = develop_scene_linear(film, plan, SceneLinearSpace::rec709, ids);
  CHECK(alone.rgba.empty());
  REQUIRE(alone.channels.size() == 12);
  CHECK(alone.channels[0].name == "CryptoObject00.R");
}

TEST_CASE("a picture tells how many samples its pixels have in the mean") {
  const Scene scene = test::scene_from("imageSize 2 1 bands 3 background E 1 samples 7");
  Film film({0, 0, 2, 1}, beauty_layers({}));
  for (const std::uint32_t s : {0u, 1u, 2u})
    film.add({s == 2 ? 1 : 0, 0, s, true}, {1.0, 1.0, 1.0}, {});
  const Metadata data = scene_linear_metadata(film, make_plan(scene, scene.settings));
  const auto taken = std::ranges::find(data, "abbe/samplesTaken", &Metadata::value_type::first);
  REQUIRE(taken != data.end());
  CHECK(taken->second == "1.5");
}

TEST_CASE("a pixel without samples is black and clear, whatever light paths brought to it") {
  const Scene scene = test::scene_from("imageSize 2 1 bands 3 background E 1");
  Film film({0, 0, 2, 1}, beauty_layers({.quantum = 0x1p-40, .splats = true}));
  film.add({1, 0, 0, true}, {0.0, 0.0, 0.0}, {});
  for (const int x : {0, 1})
    film.add_splat(x, 0, {0.9, 1.0, 0.8}, {}, 0.5);
  film.add_light_passes(1.0);
  const SceneLinearImage image = develop_scene_linear(film, make_plan(scene, scene.settings));
  for (const std::size_t i : {0u, 1u, 2u, 3u})
    CHECK(image.rgba[i] == 0.0f);
  CHECK(image.rgba[5] > 0.9f);
  CHECK(image.rgba[7] == 1.0f);
}

TEST_CASE("what shows through is a layer in the picture's space, in which clear is 1 1 1") {
  const Scene scene = test::scene_from("imageSize 2 1 bands 3 background E 1");
  std::vector<LayerForm> layers = beauty_layers({.quantum = 0x1p-40});
  layers.push_back(transmittance_layer());
  Film film({0, 0, 2, 1}, std::move(layers));
  const LayerId layer = *film.find(kTransmittance);
  const Xyz white = to_xyz(kSrgbWhite, 1.0);
  film.add(layer, film.add({0, 0, 0, true}, {0.0, 0.0, 0.0}, {}), white);
  film.add(layer, film.add({1, 0, 0, true}, {0.0, 0.0, 0.0}, {}), 0.5 * white);
  for (const SceneLinearSpace space : {SceneLinearSpace::rec709, SceneLinearSpace::acescg}) {
    const SceneLinearImage image =
        develop_scene_linear(film, make_plan(scene, scene.settings), space);
    REQUIRE(image.channels.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(image.channels[i].name == std::string("transmittance.") + "RGB"[i]);
      CHECK(image.channels[i].values[0] == Approx(1.0).epsilon(1e-5));
      CHECK(image.channels[i].values[1] == Approx(0.5).epsilon(1e-5));
    }
  }
}

TEST_CASE("exposure and gamut change the display image") {
  const Picture p = picture(0);
  const DisplayImage plain = develop_display(p.film, p.plan, {});
  const DisplayImage brighter = develop_display(p.film, p.plan, {.exposure_ev = 1.0});
  for (std::size_t i = 0; i < 3; ++i) // the first pixel stays in gamut
    CHECK(brighter.linear[i] == Approx(2.0 * plain.linear[i]).epsilon(1e-6));
  const DisplayImage dazzled = develop_display(p.film, p.plan, {.exposure_ev = 20.0});
  for (const float v : dazzled.encoded)
    CHECK(v == 1.0f);
  for (std::size_t i = 0; i < dazzled.linear.size(); ++i) // not clipped
    CHECK(dazzled.linear[i] == Approx(0x1p20 * plain.linear[i]).epsilon(1e-6));
}

TEST_CASE("the display's two encodings differ by the sRGB curve") {
  const Picture p = picture(0);
  const DisplayImage image = develop_display(p.film, p.plan, {});
  for (std::size_t i = 0; i < image.linear.size(); i += 3) {
    const DisplayRgb e = encode_srgb({image.linear[i], image.linear[i + 1], image.linear[i + 2]});
    CHECK(image.encoded[i] == Approx(e.r).epsilon(1e-6));
    CHECK(image.encoded[i + 1] == Approx(e.g).epsilon(1e-6));
    CHECK(image.encoded[i + 2] == Approx(e.b).epsilon(1e-6));
  }
}

TEST_CASE("a spectral image has one plane per band, and the colour picture as a preview") {
  const Picture p = picture(3);
  const SpectralImage image = develop_spectral(p.film, p.plan);
  CHECK(image.wavelengths_nm == std::vector<double>{445.0, 580.0, 715.0});
  REQUIRE(image.values.size() == 18);
  for (std::size_t i = 0; i < 6; ++i) {
    CHECK(image.values[i] == Approx(0.1));
    CHECK(image.values[6 + i] == Approx(0.2));
    CHECK(image.values[12 + i] == Approx(0.3));
  }
  CHECK(image.rgba == develop_scene_linear(p.film, p.plan).rgba);
}

TEST_CASE("where errors are asked for, samples and the error of the luminance are added") {
  Scene scene = test::scene_from("imageSize 2 1 background E 1");
  Film film({0, 0, 2, 1}, 0x1p-40, 0, true);
  CHECK(develop_scene_linear(film, make_plan(scene, scene.settings)).channels.empty());
  scene.settings.keep_errors = true;
  const Plan plan = make_plan(scene, scene.settings);
  film.add({0, 0, 0, true}, {0.0, 1.0, 0.0}, {});
  film.add({0, 0, 1, true}, {0.0, 3.0, 0.0}, {});
  film.add({1, 0, 0, true}, {0.0, 3.0, 0.0}, {});
  const SceneLinearImage image = develop_scene_linear(film, plan);
  REQUIRE(image.channels.size() == 2);
  CHECK(image.channels[0].name == "samples");
  CHECK(image.channels[0].values == std::vector<float>{2.0f, 1.0f});
  CHECK(image.channels[1].name == "error.Y");
  CHECK(image.channels[1].values == std::vector<float>{1.0f, 0.0f}); // half of 3 - 1; unknown
}

TEST_CASE("metadata name every setting that shapes the picture and nothing of the machine") {
  const Scene scene = test::scene_from("sphere");
  const auto metadata = [&](auto change) {
    RenderSettings settings = scene.settings;
    change(settings);
    return render_metadata(make_plan(scene, settings));
  };
  const Metadata plain = metadata([](RenderSettings&) {});
  CHECK(names(plain) == std::set<std::string>{"abbe/integrator", "abbe/bands", "abbe/samples",
                                              "abbe/seed", "abbe/filter", "abbe/sky",
                                              "abbe/shadows", "abbe/depth", "abbe/minThroughput",
                                              "abbe/minReflectivity", "abbe/minTransparency",
                                              "abbe/jitter", "abbe/adaptive", "abbe/exact",
                                              "abbe/observer", "abbe/tolerance", "abbe/maxFan"});
  const Metadata path = metadata([](RenderSettings& s) { s.integrator = Integrator::path; });
  CHECK(path.size() == plain.size() + 4); // caustics, light paths, photon radius, bright sky
  const auto path_tells = [&](auto change) {
    return metadata([&](RenderSettings& s) {
             s.integrator = Integrator::path;
             change(s);
           }) != path;
  };
  CHECK(path_tells([](RenderSettings& s) { s.caustics = Caustics::off; }));
  CHECK(path_tells([](RenderSettings& s) { s.light_paths = 0.5; }));
  CHECK(path_tells([](RenderSettings& s) { s.photon_radius = 0.5; }));
  const auto tells = [&](auto change) { return metadata(change) != plain; };
  CHECK(tells([](RenderSettings& s) { s.adaptive = AdaptiveSampling::on; }));
  CHECK(tells([](RenderSettings& s) { s.bands = 80; }));
  CHECK(tells([](RenderSettings& s) { s.observer = Observer::cie1964_10deg; }));
  CHECK(tells([](RenderSettings& s) { s.samples_per_pixel = 3; }));
  CHECK(tells([](RenderSettings& s) { s.seed = 3; }));
  CHECK(tells([](RenderSettings& s) { s.filter = PixelFilter::tent; }));
  CHECK(tells([](RenderSettings& s) { s.shadows = ShadowRule::none; }));
  CHECK(tells([](RenderSettings& s) { s.max_depth = 3; }));
  CHECK(tells([](RenderSettings& s) { s.min_throughput = 0.5; }));
  CHECK(tells([](RenderSettings& s) { s.min_reflectivity = 0.5; }));
  CHECK(tells([](RenderSettings& s) { s.min_transparency = 0.5; }));
  CHECK(tells([](RenderSettings& s) { s.jitter = false; }));
  CHECK(tells([](RenderSettings& s) { s.exact = true; }));
  CHECK(tells([](RenderSettings& s) { s.tolerance_pixels = 2.0; }));
  CHECK(tells([](RenderSettings& s) { s.max_fan = 3; }));
  CHECK(tells([](RenderSettings& s) { s.noise = 0.1; }));
  CHECK(tells([](RenderSettings& s) { s.seconds = 9.0; }));
  CHECK_FALSE(tells([](RenderSettings& s) { s.threads = 7; }));
  CHECK_FALSE(tells([](RenderSettings& s) { s.tracing = Tracing::single; }));
  CHECK_FALSE(tells([](RenderSettings& s) { s.skip = false; }));
}

TEST_CASE("EXR in another space: white stays white, other colours have the published values") {
  // Linear Rec. 709 to ACEScg with Bradford's adaptation, as OpenColorIO's ACES configurations have
  // it: rows 0.613097 0.339523 0.047379, 0.070194 0.916354 0.013452, 0.020616 0.109570 0.869815.
  // Rec. 709 to Rec. 2020 (ITU-R BT.2087): rows 0.6274 0.3293 0.0433, 0.0691 0.9195 0.0114,
  // 0.0164 0.0880 0.8956.
  const Scene scene = test::scene_from("imageSize 4 1 bands 3");
  const Plan plan = make_plan(scene, scene.settings);
  Film film({0, 0, 4, 1}, 0x1p-40, 0);
  const LinearRgb colors[] = {{1, 1, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int x = 0; x < 4; ++x)
    film.add({x, 0, 0, true}, to_xyz(colors[x]), {});
  const auto check = [&](SceneLinearSpace space, const std::vector<double>& expected,
                         double margin) {
    const SceneLinearImage image = develop_scene_linear(film, plan, space);
    CHECK(image.space == space);
    for (std::size_t c = 0; c < 3; ++c) {
      CHECK(image.rgba[c] == Approx(1.0).epsilon(1e-6));
      for (std::size_t pixel = 0; pixel < 3; ++pixel)
        CHECK(image.rgba[4 * (pixel + 1) + c] == Approx(expected[3 * c + pixel]).margin(margin));
    }
  };
  check(SceneLinearSpace::rec709, {1, 0, 0, 0, 1, 0, 0, 0, 1}, 1e-6);
  check(SceneLinearSpace::acescg,
        {0.613097, 0.339523, 0.047379, 0.070194, 0.916354, 0.013452, 0.020616, 0.109570, 0.869815},
        2e-5);
  check(SceneLinearSpace::rec2020,
        {0.6274, 0.3293, 0.0433, 0.0691, 0.9195, 0.0114, 0.0164, 0.0880, 0.8956}, 6e-5);
  // To ACES2065-1 likewise: 0.439633 0.382989 0.177378, 0.089776 0.813439 0.096784, ...
  const SceneLinearImage ap0 = develop_scene_linear(film, plan, SceneLinearSpace::aces2065_1);
  CHECK(ap0.rgba[4] == Approx(0.439633).margin(2e-5));
  CHECK(ap0.rgba[8] == Approx(0.382989).margin(2e-5));
  CHECK(ap0.rgba[9] == Approx(0.813439).margin(2e-5));
}

TEST_CASE("a display's picture also names every setting of the display") {
  const Picture p = picture(0);
  const auto metadata = [&](const DisplaySettings& settings) {
    return develop_display(p.film, p.plan, settings).metadata;
  };
  Metadata plain = render_metadata(p.plan);
  plain.insert(plain.end(), {{"abbe/display", "sRGB / Rec.709"},
                             {"abbe/transfer", "srgb"},
                             {"abbe/gamut", "desaturate"},
                             {"abbe/exposure", "0"}});
  CHECK(metadata({}) == plain);
  DisplaySettings other;
  other.exposure_ev = -1.5;
  other.gamut = GamutMapping::scale;
  other.space = find_color_space("ntsc").value();
  other.white_point = WhitePoint::at({0.3, 0.31});
  Metadata expected = render_metadata(p.plan);
  expected.insert(expected.end(), {{"abbe/display", "NTSC 1953"},
                                   {"abbe/transfer", "2.2"},
                                   {"abbe/gamut", "scale"},
                                   {"abbe/exposure", "-1.5"},
                                   {"abbe/whitePoint", "0.300000 0.310000"}});
  CHECK(metadata(other) == expected);
  Metadata of_film = render_metadata(p.plan);
  for (const auto& entry : film_metadata(p.film))
    of_film.push_back(entry);
  CHECK(develop_scene_linear(p.film, p.plan).metadata == of_film);
}
