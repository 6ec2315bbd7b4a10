// Every row of the table of settings, by all the ways that lead to it.

#include "core/scene/setting_table.h"

#include "core/image/metadata.h"
#include "core/scene/user_error.h"
#include "io/program/command_line.h"
#include "io/settings/setting_text.h"
#include "tests/catch.h"
#include "tests/io/scene_language/read_scene_helpers.h"

#include <algorithm>
#include <iostream>
#include <map>
#include <set>
#include <sstream>

using namespace abbe;

namespace {

/// A value that is not the default, as a scene and as a command line write it.
struct Example {
  std::string scene, option;
  Example(const char* both) : scene(both), option(both) {}
  Example(const char* in_scene, const char* in_option) : scene(in_scene), option(in_option) {}
};

// By option. A row without an example fails the test.
const std::map<std::string_view, Example> kExamples{
    {"--integrator", "path"},
    {"--bands", "27"},
    {"--spp", "010"}, // ten: numbers are decimal
    {"--adaptive", "off"},
    {"--observer", "10deg"},
    {"--seed", "18446744073709551615"},
    {"--filter", "tent"},
    {"--sky", "transparent"},
    {"--shadows", "opaque"},
    {"--depth", "7"},
    {"--cutoff", "0.25"},
    {"--min-reflectivity", "0.125"},
    {"--min-transparency", "0.0625"},
    {"--jitter", "off"},
    {"--exact", {"on", ""}},
    {"--noise", "0.05"},
    {"--time", "2.5"},
    {"--tolerance", "1e6"},
    {"--fan", "12"},
    {"--caustics", "on"},
    {"--light-paths", "0.5"},
    {"--bright-sky", "2.5"},
    {"--photon-radius", "0.2"},
    {"--errors", {"on", ""}},
    {"--layers", {"", "transmittance,depth"}},
    {"--relightable", {"on", ""}},
    {"--band-images", {"on", ""}},
    {"--size", {"640 480", "640x480"}},
    {"--crop", {"1 2 30 40", "1,2,30,40"}},
    {"--threads", "3"},
    {"--skip", "off"},
    {"--tracing", "single"},
    {"--display", "display-p3"},
    {"--transfer", "1.8"},
    {"--gamut", "clip"},
    {"--exposure", "-1.5"},
    {"--white-point", {"0.3457 0.3585", "0.3457,0.3585"}},
    {"--adaptation", "cat16"},
    {"--tone", "filmic"},
};

// These are of one run on one machine, not of a scene.
const std::set<std::string_view> kNotInScenes{"--time",        "--errors",     "--layers",
                                              "--relightable", "--threads",    "--skip",
                                              "--tracing",     "--band-images"};
// Those, and what the windows and channels of an image file tell.
const std::set<std::string_view> kNotInMetadata{"--errors",      "--layers", "--relightable",
                                                "--band-images", "--size",   "--crop",
                                                "--threads",     "--skip",   "--tracing"};

RenderCommand parse(const std::string& option, const std::string& value) {
  std::vector<const char*> words{"abbe", "render", "scene.sdl", option.c_str()};
  if (!value.empty()) words.push_back(value.c_str());
  return std::get<RenderCommand>(parse_command_line(static_cast<int>(words.size()), words.data()));
}

/// The settings as text, row by row. It differs where any member does.
template <class Row, class Settings>
std::vector<std::string> texts(std::span<const Row> table, const Settings& settings) {
  std::vector<std::string> list;
  for (const Row& row : table)
    list.push_back(value_text(row, settings));
  return list;
}

/// The help of `abbe render`, each run of white space as one space.
std::string help() {
  std::ostringstream out;
  std::streambuf* const saved = std::cout.rdbuf(out.rdbuf());
  const std::vector<const char*> words{"abbe", "render", "--help"};
  (void)parse_command_line(static_cast<int>(words.size()), words.data());
  std::cout.rdbuf(saved);
  std::istringstream in(out.str());
  std::string text;
  for (std::string word; in >> word;)
    text += word + ' ';
  return text;
}

RenderSettings of_scene(const Scene& scene, const RenderSettings&) {
  return scene.settings;
}
DisplaySettings of_scene(const Scene& scene, const DisplaySettings&) {
  return scene.display;
}
RenderSettings of_options(const RenderCommand& options, const RenderSettings& usual) {
  return overridden(usual, options.settings);
}
DisplaySettings of_options(const RenderCommand& options, const DisplaySettings& usual) {
  return overridden(usual, options.display);
}

/// One row by both ways: each changes the value to the same, and nothing else.
template <class Row, class Settings>
void check_ways(std::span<const Row> table, const Row& row, const Settings& usual) {
  const Example& example = kExamples.at(row.option);
  const Settings given = of_options(parse(std::string(row.option), example.option), usual);
  CHECK(value_text(row, given) != value_text(row, usual));
  const auto before = texts(table, usual), after = texts(table, given);
  for (std::size_t i = 0; i < table.size(); ++i)
    if (&table[i] != &row && !(row.option == "--display" && table[i].option == "--transfer"))
      CHECK(before[i] == after[i]); // a display brings its transfer function
  CHECK(row.keyword.empty() == kNotInScenes.contains(row.option));
  if (row.keyword.empty()) return;
  const Scene scene = scene_of(std::string(row.keyword) + " " + example.scene);
  CHECK(texts(table, of_scene(scene, usual)) == after);
}

template <class Row, class Settings>
void check_help(const std::string& text, const Row& row, const Settings& usual) {
  const std::string choice = choice_words(row);
  const std::string type = row.flag            ? ""
                           : !row.type.empty() ? std::string(row.type) + " "
                           : !choice.empty()   ? choice + " "
                                               : "N ";
  const std::string begin = " " + std::string(row.option) + " " + type + std::string(row.help);
  const std::size_t at = text.find(begin);
  REQUIRE(at != text.npos);
  const std::string usual_text =
      row.default_words.empty() ? value_text(row, usual) : std::string(row.default_words);
  const std::string shown = "(default " + usual_text + ")";
  CHECK(text.find(shown, at) == text.find("(default ", at));
}

bool names(const Metadata& data, const std::string& name, const std::string& value) {
  return std::find(data.begin(), data.end(), std::pair{name, value}) != data.end();
}

} // namespace

TEST_CASE("every setting has a name in every place, and no name is used twice") {
  std::set<std::string_view> keywords, options, metadata, variations;
  std::size_t rows = 0;
  const auto add = [&](const auto& table) {
    for (const auto& row : table) {
      INFO(row.option);
      CHECK(options.insert(row.option).second);
      if (!row.keyword.empty()) CHECK(keywords.insert(row.keyword).second);
      if (!row.metadata.empty()) CHECK(metadata.insert(row.metadata).second);
      if (!row.variation.empty()) CHECK(variations.insert(row.variation).second);
      CHECK_FALSE(row.help.empty());
      CHECK(row.option.starts_with("--"));
      CHECK(row.metadata.empty() == kNotInMetadata.contains(row.option));
      CHECK(kExamples.contains(row.option));
      ++rows;
    }
  };
  add(render_setting_table());
  add(display_setting_table());
  CHECK(rows == kExamples.size());
}

TEST_CASE("every member of the settings has its row") {
  // A new member does not compile here until it is named, and counted below.
  const RenderSettings render;
  [[maybe_unused]] const auto& [width, height, crop, bands, observer, samples, noise, seconds,
                                adaptive, keep_errors, seed, integrator, filter, sky, layers,
                                relightable, band_images, max_depth, min_throughput,
                                min_reflectivity, min_transparency, shadows, caustics, light_paths,
                                bright_sky, photon_radius, exact, jitter, tolerance, max_fan,
                                threads, skip, tracing] = render;
  CHECK(render_setting_table().size() == 33 - 1); // width and height are one setting
  const DisplaySettings display;
  [[maybe_unused]] const auto& [exposure, gamut, space, transfer, white_point, adaptation, tone] =
      display;
  CHECK(display_setting_table().size() == 7);
}

TEST_CASE("a setting is the same from a scene and from the command line") {
  for (const RenderSetting& row : render_setting_table()) {
    INFO(row.option);
    check_ways(render_setting_table(), row, RenderSettings{});
  }
  for (const DisplaySetting& row : display_setting_table()) {
    INFO(row.option);
    check_ways(display_setting_table(), row, DisplaySettings{});
  }
}

TEST_CASE("the help of the command line tells each option and its default") {
  const std::string text = help();
  for (const RenderSetting& row : render_setting_table()) {
    INFO(row.option);
    check_help(text, row, RenderSettings{});
  }
  for (const DisplaySetting& row : display_setting_table()) {
    INFO(row.option);
    check_help(text, row, DisplaySettings{});
  }
}

TEST_CASE("defaults in words agree with the program's constants") {
  const std::string_view spp = setting_of_option("--spp").default_words;
  CHECK(spp.starts_with(std::to_string(kSamplesPerPixel) + ","));
  CHECK(spp.find(std::to_string(kMostSamplesPerPixel)) != spp.npos);
  const std::string_view adaptive = setting_of_option("--adaptive").default_words;
  CHECK(adaptive.find(std::to_string(kLeastAdaptiveSamples)) != adaptive.npos);
  for (const RenderSetting& row : render_setting_table()) {
    const std::string value = value_text(row, RenderSettings{}), words(row.default_words);
    INFO(row.option << " " << value);
    // Zeros that stand for something else are not told as zeros.
    if (!words.empty() && value != "0") CHECK(words.starts_with(value));
  }
  CHECK(find_color_space("srgb") == DisplaySettings{}.space);
}

TEST_CASE("an image file tells every setting that shaped the image") {
  Plan plan;
  plan.settings.integrator = Integrator::path; // where all of them matter
  plan.settings.noise = 0.5;
  plan.settings.seconds = 7.0;
  for (const RenderSetting& row : render_setting_table()) {
    if (row.metadata.empty()) continue;
    INFO(row.option);
    const std::string name = "abbe/" + std::string(row.metadata);
    CHECK(names(render_metadata(plan), name, value_text(row, plan.settings)));
    if (row.option == "--integrator" || row.option == "--exact") continue; // others depend on them
    Plan changed = plan;
    set_from_text(row, kExamples.at(row.option).option, changed.settings);
    CHECK(names(render_metadata(changed), name, value_text(row, changed.settings)));
    CHECK(render_metadata(changed) != render_metadata(plan));
  }
  for (const DisplaySetting& row : display_setting_table()) {
    INFO(row.option);
    DisplaySettings changed;
    if (row.option == "--adaptation")
      changed.white_point = WhitePoint::at({0.4, 0.4}); // it needs one
    const Metadata usual = display_metadata(changed, Observer::cie1931_2deg);
    set_from_text(row, kExamples.at(row.option).option, changed);
    const Metadata data = display_metadata(changed, Observer::cie1931_2deg);
    CHECK(data != usual);
    CHECK(names(data, "abbe/" + std::string(row.metadata), value_text(row, changed)));
  }
}

TEST_CASE("a text that is not right for a setting is the user's mistake, and changes nothing") {
  for (const auto& [option, text, right] :
       std::vector<std::tuple<const char*, const char*, const char*>>{
           {"--spp", "0x10", "a whole number from 1 to 16777216"},
           {"--spp", "1.0", "a whole number from 1 to 16777216"},
           {"--size", "4x4x", "a size such as 640x480, each side from 1 to 65536"},
           {"--size", "x4", "a size such as 640x480, each side from 1 to 65536"},
           {"--crop", "1,2,3,4,", "a crop x0,y0,x1,y1, each from 0 to 65536"},
           {"--crop", "1,2,3,-4", "a crop x0,y0,x1,y1, each from 0 to 65536"},
           {"--light-paths", "0", "a number more than 0 and less than 1000000"},
           {"--tolerance", "inf", "a number 0 or more"},
           {"--jitter", "", "on or off"},
           {"--seed", "-1", "a seed: a whole number from 0 to 2^64 - 1"}}) {
    RenderSettings settings;
    INFO(option << " " << text);
    CHECK_THROWS_WITH(set_from_text(setting_of_option(option), text, settings),
                      "\"" + std::string(text) + "\" is not " + right);
    CHECK(texts(render_setting_table(), settings) ==
          texts(render_setting_table(), RenderSettings{}));
  }
}
