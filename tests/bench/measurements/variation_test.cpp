#include "bench/measurements/variation.h"

#include "core/scene/user_error.h"
#include "tests/catch.h"

using namespace abbe;
using namespace abbe::bench;

TEST_CASE("a variation changes what it names and nothing else") {
  const RenderSettings usual;
  const Variation plain = parse_variation("default", usual);
  CHECK(plain.name == "default");
  CHECK(plain.settings.max_fan == usual.max_fan);
  CHECK_FALSE(plain.settings.exact);

  const Variation varied = parse_variation("fan=7,tolerance=0.5,cutoff=0.01,jitter=off", usual);
  CHECK(varied.name == "fan=7,tolerance=0.5,cutoff=0.01,jitter=off");
  CHECK(varied.settings.max_fan == 7);
  CHECK(varied.settings.tolerance_pixels == 0.5);
  CHECK(varied.settings.min_throughput == 0.01);
  CHECK_FALSE(varied.settings.jitter);
  CHECK(varied.settings.bands == usual.bands);

  CHECK(parse_variation("exact", usual).settings.exact);
  CHECK(parse_variation("noise=0.1", usual).settings.noise == 0.1);
  CHECK(parse_variation("bands=27", usual).settings.bands == 27);
  CHECK(parse_variation("adaptive=on", usual).settings.adaptive == AdaptiveSampling::on);
  CHECK(parse_variation("adaptive=off", usual).settings.adaptive == AdaptiveSampling::off);
  CHECK(parse_variation("integrator=path", usual).settings.integrator == Integrator::path);
  CHECK(parse_variation("caustics=off", usual).settings.caustics == Caustics::off);
  CHECK(parse_variation("caustics=on", usual).settings.caustics == Caustics::on);
  CHECK(parse_variation("lightpaths=0.25", usual).settings.light_paths == 0.25);
  CHECK(parse_variation("bands=010", usual).settings.bands == 10);
  RenderSettings path = usual;
  path.integrator = Integrator::path;
  CHECK(parse_variation("integrator=whitted", path).settings.integrator == Integrator::whitted);
  CHECK(parse_variation("default", path).settings.integrator == Integrator::path);
}

TEST_CASE("what is no variation is refused") {
  const RenderSettings usual;
  for (const char* text :
       {"", "fan", "fan=", "fan=0", "fan=406", "fan=7x", "tolerance=nan", "tolerance=-1",
        "jitter=maybe", "noise=2", "integrator=bdpt", "lightpaths=-1", "exact=1", "bands=0x9",
        "speed=9", "fan=7,", "default,fast"}) {
    INFO(text);
    CHECK_THROWS_AS(parse_variation(text, usual), UserError);
  }
}
