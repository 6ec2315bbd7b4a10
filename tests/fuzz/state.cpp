// A state's blocks have checksums, which a change of their content breaks: they are made right
// before it is read.

#include "io/files/checksum.h"
#include "io/states/read_state.h"
#include "tests/fuzz/memory_file.h"

#include <cstring>

namespace {

using namespace abbe;

constexpr std::size_t kStart = 12, kHead = 12; ///< in bytes: signature and version; name and size

std::string with_right_checksums(std::string bytes) {
  std::size_t block = kStart;
  while (block + kHead + sizeof(std::uint32_t) <= bytes.size()) {
    std::uint64_t size = 0;
    std::memcpy(&size, bytes.data() + block + 4, sizeof size);
    if (size > bytes.size() - block - kHead - sizeof(std::uint32_t)) break;
    const std::string_view all(bytes.data() + block, kHead + size);
    const std::uint32_t sum = Checksum().add(all.substr(0, kHead)).add(all.substr(kHead)).value();
    std::memcpy(bytes.data() + block + kHead + size, &sum, sizeof sum);
    block += kHead + size + sizeof sum;
  }
  return bytes;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const MemoryFile file(with_right_checksums(std::string(text_of(data, size))), "file.state");
  return try_input(file.path, [&] {
    StateReader reader(file.path);
    if (reader.window().pixel_count() < 1'000'000) (void)reader.read({});
  });
}
