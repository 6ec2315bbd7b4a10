#include "io/gltf/read_gltf.h"
#include "tests/fuzz/fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace abbe;
  for (const Strictness strictness : {Strictness::strict, Strictness::lenient})
    (void)try_input("s.gltf", [&] {
      (void)read_gltf_bytes(text_of(data, size), "s.gltf", ignore_warning, strictness);
    });
  return 0;
}
