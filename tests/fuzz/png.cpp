#include "io/images/read_image.h"
#include "tests/fuzz/fuzz_image.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return abbe::try_image(data, size, "image.png",
                         [](const auto& file) { (void)abbe::read_png(file); });
}
