#include "io/libraries/read_lens_prescription.h"
#include "tests/fuzz/fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace abbe;
  return try_input("file.lens", [&] {
    (void)read_lens_prescription_text(text_of(data, size), "file.lens", ignore_warning);
  });
}
