#include "io/pbrt/read_pbrt.h"
#include "tests/fuzz/fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace abbe;
  for (const Strictness strictness : {Strictness::strict, Strictness::lenient})
    (void)try_input("s.pbrt", [&] {
      (void)read_pbrt_text(text_of(data, size), "s.pbrt", ignore_warning, strictness);
    });
  return 0;
}
