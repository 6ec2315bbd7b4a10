// A scene may name other files: those of corpus/files, beside which it stands.

#include "io/scene_language/read_scene.h"
#include "tests/fuzz/fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace abbe;
  return try_input("corpus/files/", [&] {
    (void)read_scene_text(text_of(data, size), ABBE_SOURCE_DIR "/tests/fuzz/corpus/files/scene.sdl",
                          ignore_warning);
  });
}
