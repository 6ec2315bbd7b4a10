#include "io/libraries/read_glass_files.h"
#include "io/libraries/read_lens_tables.h"
#include "io/libraries/read_spectrum.h"
#include "tests/fuzz/fuzz_input.h"

// The small formats of the trade: glass catalogues, refractive indices, lenses, spectra.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace abbe;
  const auto text = text_of(data, size);
  (void)try_input("x.agf", [&] { (void)read_agf_text(text, "x.agf", ignore_warning); });
  (void)try_input("x.yml", [&] { (void)read_refractiveindex_text(text, "x.yml"); });
  (void)try_input("x.zmx", [&] { (void)read_zmx_text(text, "x.zmx"); });
  (void)try_input("x.dat", [&] { (void)read_dat_text(text, "x.dat"); });
  for (const char* file : {"x.csv", "x.sp", "x.spdx"})
    (void)try_input(file, [&] { (void)read_spectrum_text(text, file, ignore_warning); });
  return 0;
}
