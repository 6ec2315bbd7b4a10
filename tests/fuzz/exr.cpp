#include "io/images/read_exr.h"
#include "tests/fuzz/fuzz_image.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return abbe::try_image(data, size, "image.exr",
                         [](const auto& file) { (void)abbe::read_exr_image(file); });
}
