#include "io/images/read_exr.h"
#include "tests/fuzz/fuzz_image.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace abbe;
  return try_image(text_of(data, size), "image.exr",
                   [](const auto& file) { (void)read_exr_image(file); });
}
