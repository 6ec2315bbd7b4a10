#include "io/libraries/read_lights.h"

#include "spectral/band_grid.h"
#include "spectral/observer.h"
#include "tests/catch.h"

#include <filesystem>

using namespace abbe;

namespace {

std::string values(int count, const std::string& value = "0.5") {
  std::string text;
  for (int i = 0; i < count; ++i)
    text += ' ' + value;
  return text;
}

std::vector<LightSpectrum> lights_of(const std::string& text) {
  return read_lights_text(text, "l.filter", [](const std::string&) {});
}

std::string error_of(const std::string& text) {
  try {
    (void)lights_of(text);
  } catch (const ReadError& error) {
    return error.what();
  }
  return "no error";
}

} // namespace

TEST_CASE("the thesis's filter 2a is read as printed, with one warning for its 84 values") {
  std::vector<std::string> warnings;
  const auto file = std::filesystem::path(ABBE_SOURCE_DIR) / "scenes/lights.filter";
  const auto lights = read_lights(file, [&](const auto& message) { warnings.push_back(message); });
  REQUIRE(lights.size() == 1);
  CHECK(lights[0].name == "2a");
  CHECK(lights[0].intensity == 0.85);
  double sum = 0.0;
  for (int k = 0; k < kSampleCount; ++k)
    sum += lights[0].colour.at(sample_nm(k));
  CHECK(sum == Approx(49.774).epsilon(1e-12)); // appendix_a.csv, added up by awk
  CHECK(lights[0].colour.at(415.0) == 0.023);
  CHECK(lights[0].colour.at(700.0) == 0.45);
  // golden_seed_spectra.csv, "filter 2a intensity 0.85"; it was made from the 1 nm table.
  CHECK(to_xyz(spectrum(lights[0])).y == Approx(0.7675024431).epsilon(1e-4));
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0] == file.string() + ":31:12: 3 zeros after the 81 values of colour are left out "
                                       "(they lie beyond 780 nm)");
}

TEST_CASE("entries stand one after the other, with or without endfilter") {
  const auto lights = lights_of("filter a { intensity 2 colour 81" + values(81) + "} endfilter\n" +
                                "FILTER \"b c\"{COLOUR 81" + values(81, "1") +
                                "}filter d{colour 81" + values(81) + "}");
  REQUIRE(lights.size() == 3);
  CHECK(lights[1].name == "b c");
  CHECK(lights[1].intensity == 1.0);
  CHECK(spectrum(lights[0]).at(500.0) == 1.0);
  CHECK(lights_of("! nothing\n").empty());
}

TEST_CASE("errors of a light library") {
  const std::string colour = "colour 81" + values(81);
  CHECK(error_of("filter a { colour 80" + values(80) + "}") ==
        "l.filter:1:19: 80 values are announced for colour (libraries hold values "
        "from 380 to 780 nm, in steps of 10, 5, 2 or 1 nm). Give 81 values, or 41, 201 or 401");
  CHECK(
      error_of("filter a { colour x }") ==
      "l.filter:1:19: \"x\" is not a whole number (colour takes 41|81|201|401 v380 ... v780). Give "
      "digits only, such as 81");
  CHECK(error_of("filter a {\ncolour 81" + values(80) + "\n}") ==
        "l.filter:3:1: colour has only 80 values (\"}\" stands where value 81 of 81 should). Give "
        "81 values, at 380, 385 ... 780 nm");
  CHECK(error_of("filter a { colour 81 1") ==
        "l.filter:1:23: colour has only 1 values (the end of the file stands where value 2 of 81 "
        "should). Give 81 values, at 380, 385 ... 780 nm");
  CHECK(error_of("filter a { colour 81 1 0.O }") ==
        "l.filter:1:24: \"0.O\" is not a number (it stands where value 2 of 81 should). Give 81 "
        "numbers for colour");
  CHECK(error_of("filter a { colour 81 -1 }") ==
        "l.filter:1:22: -1 is out of range for colour (it is a share of light, never negative). "
        "Give a number from 0 to 1000000000000000");
  CHECK(error_of("filter a {\n" + colour + "\n0 0.25 }") ==
        "l.filter:3:3: 0.25 is one of too many values for colour (81 values from 380 to 780 nm "
        "are read; only zeros may follow). Remove it, or look for one given twice");
  CHECK(error_of("filter a { colour 81" + values(81) + "\n intensty 2 }") ==
        "l.filter:2:2: unknown key \"intensty\" (no such key in an entry of filter). Did you mean "
        "intensity?");
  CHECK(error_of("filter a { brightness 2 }") ==
        "l.filter:1:12: unknown key \"brightness\" (no such key in an entry of filter). The keys "
        "are intensity colour");
  CHECK(error_of("filter a { intensity bright }") ==
        "l.filter:1:22: \"bright\" is not a number (intensity takes x). Give a finite number such "
        "as 2, -0.5 or 1e-3");
  CHECK(error_of("filter a { intensity -1 }") ==
        "l.filter:1:22: -1 is out of range for intensity (it is a factor on the colour). Give a "
        "number from 0 to 1000000000000000");
  CHECK(error_of("filter a intensity 1") ==
        "l.filter:1:10: \"{\" is missing before \"intensity\" (an entry is filter NAME { keys }). "
        "Add it after the name");
  CHECK(error_of("filter { intensity 1") ==
        "l.filter:1:8: \"{\" stands where a name should (filter takes NAME { keys }). Give a name; "
        "one with spaces goes in double quotes");
  CHECK(error_of("filter a { intensity 1 endfilter") ==
        "l.filter:1:24: \"}\" is missing before \"endfilter\" (an entry is filter NAME { keys }). "
        "Add it after the last key");
  CHECK(error_of("filter a { intensity 1 filter") ==
        "l.filter:1:24: \"}\" is missing before \"filter\" (an entry is filter NAME { keys }). Add "
        "it after the last key");
  CHECK(error_of("filter a { intensity 1") ==
        "l.filter:1:23: \"}\" is missing before the end of the file (an entry is filter NAME { "
        "keys }). Add it after the last key");
  CHECK(error_of("light a { }") ==
        "l.filter:1:1: \"light\" stands where filter should (an entry is filter NAME { keys }). "
        "Check the braces of the entry before it");
  CHECK(error_of("filter a { intensity 1 intensity 2 }") ==
        "l.filter:1:24: intensity is given twice (an entry has each key at most once). Remove one "
        "of them");
  CHECK(error_of("filter a { intensity 1 }") ==
        "l.filter:1:8: \"a\" has no colour (nothing sensible can stand in for it). Add colour "
        "41|81|201|401 v380 ... v780");
  CHECK(error_of("filter a {" + colour + "}\nfilter A {" + colour + "}") ==
        "l.filter:2:8: \"A\" is defined twice (names must differ by more than upper and lower "
        "case). Rename or remove one of them");
  REQUIRE_THROWS_WITH(read_lights("none.filter", {}),
                      "none.filter: the file cannot be read (No such file or directory). Check its "
                      "name and folder");
}

TEST_CASE("a light of steps other than 5 nm is linear between its values") {
  const auto lights = lights_of("filter a { colour 401" + values(400) +
                                " 1 } filter b { colour 41 0" + values(40, "1") + "}");
  CHECK(lights[0].colour.at(779.5) == Approx(0.75));
  CHECK(lights[1].colour.at(385.0) == Approx(0.5));
  CHECK(error_of("filter a { colour 401" + values(81) + "}")
            .starts_with("l.filter:1:346: colour has only 81 values"));
}
