#include "io/building/keyword_effects.h"

#include "io/scene_language/read_scene.h"
#include "tests/catch.h"

#include <string>
#include <vector>

using namespace abbe;

namespace {

/// The warnings of keywords without effect, of a scene called s.sdl without libraries.
std::vector<std::string> warnings_of(const std::string& text) {
  std::vector<std::string> warnings;
  (void)read_scene_text(text, "no_such_folder/s.sdl", [&](const std::string& message) {
    if (message.find("has no effect") != std::string::npos)
      warnings.push_back(message.substr(std::string("no_such_folder/").size()));
  });
  return warnings;
}

const std::string kUnfilled = " has no effect (nothing of this material is filled: it lets no "
                              "light in, or the shape has no inside)";

struct Case {
  std::string acts, does_not, warning; ///< at 1:1
};

const std::vector<Case> kCases{
    {"roughness 0.3 reflectivity 0.5 square", "roughness 0.3 square",
     "roughness has no effect (the surface neither mirrors nor refracts, and has no coat)"},
    {"roughness 0.3 coat 1.5 sphere", "roughness 0.3 reflectivity 0 sphere",
     "roughness has no effect (the surface neither mirrors nor refracts, and has no coat)"},
    {"compensation off metal Al compensation off roughness 0.3 cube",
     "compensation off reflectivity 1 cube",
     "compensation has no effect (the surface has no rough mirror or glass)"},
    {"speedOfLight 1.5 transparency 1 thinFilm 300 1.3 cube",
     "thinFilm 300 1.3 speedOfLight 1.5 transparency 1 fresnel off cube",
     "thinFilm has no effect (with fresnel off, or without any reflectivity and transparency, no "
     "film is seen)"},
    {"reflectivity 0.4 cube", "reflectivity 0.4 coat 1.5 cube",
     "reflectivity has no effect (a coat reflects by its own index)"},
    {"specularExponent 9 specular 0.1 0.1 0.1 cube", "specularExponent 9 cube",
     "specularExponent has no effect (there is no highlight: specular is 0)"},
    {"emissiveSides front emissive E 1 square", "emissiveSides front square",
     "emissiveSides has no effect (the surface gives off no light, or is a solid's, which gives it "
     "off outwards)"},
    {"emissiveSides front emissive E 1 disc cube", "emissiveSides front emissive E 1 cube",
     "emissiveSides has no effect (the surface gives off no light, or is a solid's, which gives it "
     "off outwards)"},
    {"fresnel off transparency 1 cube", "fresnel off reflectivity 1 cube",
     "fresnel has no effect (the surface is neither glass nor metal)"},
    {"speedOfLight 1.5 transparency 1 cube", "speedOfLight 1.5 cube", "speedOfLight" + kUnfilled},
    {"vnum 1.5 transparency 1 cube", "vnum 1.5 cube", "vnum" + kUnfilled},
    {"dispersionScale 2 transparency 1 cube", "dispersionScale 2 cube",
     "dispersionScale" + kUnfilled},
    {"absorption 2 transparency 1 cube", "absorption 2 transparency 1 square",
     "absorption" + kUnfilled},
    {"thinGlass 2 1.5 absorption 0.1 square", "absorption 2 cube", "absorption" + kUnfilled},
    {"absorptionTable 1 500 1 transparency 1 cube", "absorptionTable 1 500 1 cube",
     "absorptionTable" + kUnfilled},
    {"internalTransmittance 1 0 0 1 transparency 1 cube", "internalTransmittance 1 0 0 1 cube",
     "internalTransmittance" + kUnfilled},
    {"drops 0.1 cube", "drops 0.1 square", "drops" + kUnfilled},
    {"falloff square light E 0 0 1 1", "falloff square light E 0 0 1 0",
     "falloff has no effect (only points and spotlights fall off)"},
    {"intensity 2 sun 0 1 0", "intensity 2 sphere",
     "intensity has no effect (nothing follows that it applies to)"},
    {"softEdge 1 spotlight E 0 0 1 1 0 0 1 20", "softEdge 1 light E 0 0 1 1",
     "softEdge has no effect (only spotlights have an edge)"},
    {"sunRadius 1 sun 0 1 0", "sunRadius 1 light E 0 0 1 0",
     "sunRadius has no effect (only suns have a disc)"},
};

} // namespace

TEST_CASE("a keyword that acts on nothing it applies to is warned of at its line") {
  for (const Case& c : kCases) {
    INFO(c.acts << " / " << c.does_not);
    const auto acting = warnings_of(c.acts), idle = warnings_of(c.does_not);
    if (c.acts.find("compensation") == std::string::npos) CHECK(acting.empty());
    REQUIRE(idle.size() == 1);
    CHECK(idle[0] == "s.sdl:1:1: " + c.warning);
  }
}

TEST_CASE("a keyword need not act on every shape, nor at once") {
  CHECK(warnings_of("roughness 0.3 square reflectivity 1 square").empty());
  CHECK(warnings_of("roughness 0.3 defMaterial dull").empty());
  CHECK(warnings_of("roughness 0.3 reflectivity 1 union sphere cube").empty());
  CHECK(warnings_of("union roughness 0.3 reflectivity 1 sphere cube").empty());
  CHECK(warnings_of("roughness 0.3 reflectivity 1 defMaterial a diffuse 1 0 0 defMaterial b "
                    "mix a b 0.5 square")
            .empty());
  CHECK(
      warnings_of("roughness 0.3 roughness 0.2 reflectivity 1 square").empty()); // the last counts
  CHECK(warnings_of("roughness 0 fresnel on compensation on emissiveSides both square").empty());
  CHECK(warnings_of("def m { roughness 0.3 } use m square reflectivity 1 use m square").empty());
  CHECK(warnings_of("def m { roughness 0.3 } use m square use m square").size() == 1);
}

TEST_CASE("what the next material keyword throws away is warned of") {
  CHECK(warnings_of("roughness 0.3 glass N-BK7 sphere") ==
        std::vector<std::string>{
            "s.sdl:1:1: roughness has no effect (nothing follows that it applies to)"});
  CHECK(warnings_of("glass N-BK7 roughness 0.3 sphere").empty());
  CHECK(warnings_of("sphere roughness 0.3").size() == 1);
}
