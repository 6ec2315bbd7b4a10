#include "io/selftest/radiator_rows.h"

#include "io/selftest/small_picture.h"

#include <fmt/format.h>

#include <cmath>

namespace abbe {
namespace {

/// Planck's spectrum but for a factor; c2 = h c / k of CODATA 2018, in nm K.
double planck(double lambda_nm, double kelvin) {
  return std::pow(lambda_nm, -5.0) / std::expm1(1.438776877e7 / (lambda_nm * kelvin));
}

} // namespace

SelftestRows radiator_rows() {
  SelftestRows rows;
  for (const double kelvin : {1000.0, 2856.0, 5778.0, 20000.0}) {
    // The sky is seen, so the picture has the spectrum's own values in its bands.
    const Rendering sky =
        rendered(narrow_view() + fmt::format("background blackbody({}) 1", kelvin));
    for (const double nm : {400.0, 700.0}) {
      const BandGrid grid(kSampleCount);
      const auto at = [&](double lambda) { return sky.film.radiance(0, 0, grid.band_of(lambda)); };
      rows.push_back({"radiator", fmt::format("{:.0f} K, {:.0f} nm over 550 nm", kelvin, nm),
                      "Planck's law", planck(nm, kelvin) / planck(550.0, kelvin),
                      at(nm) / at(550.0), 2e-6 * planck(nm, kelvin) / planck(550.0, kelvin)});
    }
  }
  return rows;
}

} // namespace abbe
