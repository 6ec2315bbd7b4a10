#include "io/images/spectral_channels.h"

#include "tests/catch.h"

using namespace abbe;

namespace {

std::vector<double> wavelengths(const std::vector<std::string>& names) {
  std::vector<double> found;
  for (const SpectralChannel& channel : spectral_channels(names))
    found.push_back(channel.wavelength_nm);
  return found;
}

} // namespace

TEST_CASE("bands are found by their names, whatever their order") {
  const std::vector<std::string> names{"A", "S0.550,500000nm", "S0.380,000000nm", "R", "S0.1000nm"};
  const auto found = spectral_channels(names);
  REQUIRE(found.size() == 3);
  CHECK(found[0].name == "S0.380,000000nm");
  CHECK(found[0].wavelength_nm == 380.0);
  CHECK(found[1].wavelength_nm == 550.5);
  CHECK(found[2].name == "S0.1000nm"); // by number, not by letters
}

TEST_CASE("units have prefixes, and frequencies are wavelengths in vacuum") {
  const auto found = wavelengths({"S0.0,5um", "S0.4e2nm", "S0.7E-7m", "S0.500THz"});
  REQUIRE(found.size() == 4);
  CHECK(found[0] == Approx(400.0));
  CHECK(found[1] == Approx(500.0));
  CHECK(found[2] == Approx(599.584916)); // 299792458 / 5e14
  CHECK(found[3] == Approx(700.0));
}

TEST_CASE("what is reflected counts where nothing is emitted") {
  CHECK(wavelengths({"T.400nm", "T.500nm"}) == std::vector<double>{400.0, 500.0});
  CHECK(wavelengths({"T.400nm", "S0.500nm"}) == std::vector<double>{500.0});
}

TEST_CASE("other channels are no bands") {
  CHECK(wavelengths({"S1.500nm", "S0.500", "S0.nm", "S0.5.5nm", "S0.500xm", "S0.-500nm", "S0.0nm",
                     "key.S0.500nm", "S0.500nmx", "Z"})
            .empty());
}
