#include "tests/fuzz/fuzz_mesh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return abbe::try_mesh(data, size, "file.obj", abbe::MeshFormat::obj);
}
