#include "io/selftest/expected_index.h"
#include "io/selftest/newton_rows.h"
#include "spectral/band_grid.h"
#include "tests/catch.h"

using namespace abbe;

TEST_CASE("each band of Newton's spectrum lands where Snell sends it, with what Fresnel leaves") {
  const std::vector<NewtonBand> wall = newton_wall(1u << 17);
  for (int b = 0; b < kSampleCount; ++b) {
    const NewtonArrival arrival = newton_arrival(catalogue_index("SF11", sample_nm(b)));
    const NewtonBand& band = wall.at(static_cast<std::size_t>(b));
    INFO(sample_nm(b) << " nm");
    // The beam is 0.007 wide there, and each band has a tenth of the paths or more: some
    // 10000 photons.
    CHECK(band.y == Approx(arrival.y).margin(2e-4));
    CHECK(band.flux == Approx(newton_beam() * arrival.transmittance).epsilon(0.02));
  }
}
