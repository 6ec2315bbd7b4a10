#include "io/libraries/read_lights.h"
#include "tests/fuzz/fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace abbe;
  return try_input("file.filter", [&] {
    (void)read_lights_text(text_of(data, size), "file.filter", ignore_warning);
  });
}
