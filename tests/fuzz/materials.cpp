#include "io/libraries/read_materials.h"
#include "tests/fuzz/fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace abbe;
  return try_input("file.mtl", [&] {
    (void)read_materials_text(text_of(data, size), "file.mtl", ignore_warning);
  });
}
