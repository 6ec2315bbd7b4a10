#include "tests/io/scene_language/read_scene_helpers.h"

#include "io/text/read_arguments.h"
#include "tests/catch.h"

using namespace abbe;

TEST_CASE("numbers are finite and nothing but numbers") {
  CHECK(parse_finite("1") == 1.0);
  CHECK(parse_finite("+.5") == 0.5);
  CHECK(parse_finite("-2.") == -2.0);
  CHECK(parse_finite("1e-3") == 1e-3);
  for (const char* text : {"", "+", "+-1", "++1", "-+1", "nan", "-nan", "inf", "+infinity", "1e999",
                           "1x", "1,5", "0x10", "e5"})
    CHECK_FALSE(parse_finite(text));
}

TEST_CASE("errors of keywords") {
  CHECK(scene_error("eye 0 0 5\n  shpere") ==
        "s.sdl:2:3: unknown keyword \"shpere\" (no such word in the scene language). Did you mean "
        "sphere?");
  CHECK(scene_error("telephone") ==
        "s.sdl:1:1: unknown keyword \"telephone\" (no such word in the scene language). "
        "docs/scene_format.md lists the keywords");
  CHECK(scene_error("\"sphere\"") ==
        "s.sdl:1:1: unknown keyword \"sphere\" (it stands in quotes). Remove the quotes");
  CHECK(scene_error("translate 1 2 3 4") ==
        "s.sdl:1:17: \"4\" stands where a keyword should (the statement before it has all its "
        "arguments). Remove it, or check the statement before it");
}

TEST_CASE("errors of arguments") {
  CHECK(scene_error("translate 1 abc 3") == "s.sdl:1:13: \"abc\" is not a number (translate takes "
                                            "x y z). Give a finite number such as 2, -0.5 or "
                                            "1e-3");
  CHECK(scene_error("translate 1 nan 3") == "s.sdl:1:13: \"nan\" is not a number (translate takes "
                                            "x y z). Give a finite number such as 2, -0.5 or "
                                            "1e-3");
  CHECK(scene_error("translate 1 2") ==
        "s.sdl:1:14: the file ends where a number should stand (translate takes x y z). Complete "
        "the statement");
  CHECK(scene_error("translate 1 \"2\" 3") ==
        "s.sdl:1:13: \"2\" is not a number (translate takes x y z). Give a number without quotes "
        "and braces");
  CHECK(scene_error("bands 1.5") == "s.sdl:1:7: \"1.5\" is not a whole number (bands takes n). "
                                    "Give digits only, such as 81");
  CHECK(scene_error("bands") == "s.sdl:1:6: the file ends where a whole number should stand (bands "
                                "takes n). Complete the statement");
  CHECK(scene_error("jitter maybe") ==
        "s.sdl:1:8: \"maybe\" is no choice of jitter (jitter takes on|off). Give on or off");
}

TEST_CASE("errors of settings") {
  CHECK(scene_error("background 0 0 -1") ==
        "s.sdl:1:16: -1 is out of range for background (it is a component of a linear sRGB "
        "colour). Give a number from 0 to 1000000000000000");
  CHECK(scene_error("background E -1") ==
        "s.sdl:1:14: -1 is out of range for background (it is a factor on the spectrum). Give a "
        "number from 0 to 1000000000000000");
  CHECK(scene_error("globalAmbient {") ==
        "s.sdl:1:15: \"{\" stands where a colour or the name of a spectrum should (globalAmbient "
        "takes r g b | SPECTRUM [factor]). Give a name; one with spaces goes in double quotes");
  CHECK(scene_error("maxRecursionDepth -1") ==
        "s.sdl:1:19: -1 is out of range for maxRecursionDepth (it is how often a ray may be "
        "reflected or refracted). Give a number from 0 to 1000000");
  for (const std::string word : {"minReflectivity", "minTransparency", "minThroughput"})
    CHECK(scene_error(word + "\n1.5") == "s.sdl:2:1: 1.5 is out of range for " + word +
                                             " (it is a fraction of the light). Give a number from "
                                             "0 to 1");
  CHECK(scene_error("unit km") ==
        "s.sdl:1:6: \"km\" is no choice of unit (unit takes mm|cm|m|in|um). Give mm, cm, m, in or "
        "um");
  CHECK(scene_error("shadows on") ==
        "s.sdl:1:9: \"on\" is no choice of shadows (shadows takes "
        "none|opaque|attenuated|automatic). Give none, opaque, attenuated or automatic");
  CHECK(scene_error("lights") == "s.sdl:1:7: the end of the file stands where the name of a file "
                                 "should (lights takes FILE). Give a name; one with spaces goes in "
                                 "double quotes");
}

TEST_CASE("errors of camera and film") {
  for (const std::string angle : {"0", "180", "-1"})
    CHECK(scene_error("fieldOfView " + angle) ==
          "s.sdl:1:13: " + angle +
              " is out of range for fieldOfView (it is the picture's height as an angle, in "
              "degrees). Give a number more than 0 and less than 180");
  CHECK(scene_error("imageSize 0 10") == "s.sdl:1:11: 0 is out of range for imageSize (it is a "
                                         "number of pixels). Give a number from 1 to 65536");
  CHECK(scene_error("imageSize 10 65537") ==
        "s.sdl:1:14: 65537 is out of range for imageSize (it is a number of pixels). Give a number "
        "from 1 to 65536");
  CHECK(scene_error("bands 406") == "s.sdl:1:7: 406 is out of range for bands (it is a number of "
                                    "bands). Give a number from 1 to 405");
  CHECK(scene_error("bands 0") == "s.sdl:1:7: 0 is out of range for bands (it is a number of "
                                  "bands). Give a number from 1 to 405");
  CHECK(scene_error("samples 0") ==
        "s.sdl:1:9: 0 is out of range for samples (it is a number of samples per pixel). Give a "
        "number from 1 to 16777216");
  CHECK(scene_error("noise 1.5") == "s.sdl:1:7: 1.5 is out of range for noise (it is a relative "
                                    "error). Give a number from 0 to 1");
  CHECK(
      scene_error("adaptive maybe") ==
      "s.sdl:1:10: \"maybe\" is no choice of adaptive (adaptive takes on|off|automatic). Give on, "
      "off or automatic");
  CHECK(scene_error("maxFan 0") == "s.sdl:1:8: 0 is out of range for maxFan (it is a number of "
                                   "rays). Give a number from 1 to 405");
  CHECK(scene_error("tolerance -1") == "s.sdl:1:11: -1 is out of range for tolerance (it is a "
                                       "distance in pixels). Give a number 0 or more");
  CHECK(scene_error("seed -1") == "s.sdl:1:6: \"-1\" is not a seed (seed takes n). Give a whole "
                                  "number from 0 to 18446744073709551615");
  CHECK(scene_error("integrator photons") ==
        "s.sdl:1:12: \"photons\" is no choice of integrator "
        "(integrator takes whitted|path). Give whitted or path");
  CHECK(scene_error("filter 2a") == "s.sdl:1:8: \"2a\" is no choice of filter (filter takes "
                                    "box|tent|gaussian). Give box, tent or gaussian");
  CHECK(scene_error("crop -1 0 1 1") == "s.sdl:1:6: -1 is out of range for crop (it is an edge in "
                                        "pixels). Give a number from 0 to 65536");
  for (const std::string crop : {"crop 5 0 5 1", "crop 0 5 1 5"})
    CHECK(scene_error(crop) ==
          "s.sdl:1:1: the crop holds no pixel (its right and lower edges must be beyond the left "
          "and upper ones). Give x0 y0 x1 y1 with x0 < x1 and y0 < y1");
  CHECK(scene_error("crop 0 0 10 11 imageSize 10 10") ==
        "s.sdl:1:1: the crop reaches beyond the picture (the picture has 10 x 10 pixels). Give a "
        "smaller crop, or a larger imageSize");
  CHECK(scene_error("lookAt 0 0 5") == "s.sdl:1:1: eye and lookAt are the same point (the camera "
                                       "has no direction). Move one of them");
  CHECK(scene_error("eye 0 5 0") ==
        "s.sdl:1:1: up has no part across the direction of view (it is 0 0 0, or points along the "
        "view). Give an up such as 0 1 0, or 0 0 1 when looking along y");
  CHECK(scene_error("up 0 0 0") ==
        "s.sdl:1:1: up has no part across the direction of view (it is 0 0 0, or points along the "
        "view). Give an up such as 0 1 0, or 0 0 1 when looking along y");
}
