// A PNG's chunks have checksums, which a change of their content breaks: they are made right before
// it is read.

#include "io/files/checksum.h"
#include "io/images/read_image.h"
#include "tests/fuzz/fuzz_image.h"

namespace {

using namespace abbe;

constexpr std::size_t kSignature = 8, kNumber = 4, kName = 4; ///< in bytes

std::uint32_t number_at(const std::string& bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < kNumber; ++i)
    number = number << 8U | static_cast<unsigned char>(bytes[at + i]);
  return number;
}

std::string with_right_checksums(std::string bytes) {
  std::size_t chunk = kSignature;
  while (chunk + kNumber + kName + kNumber <= bytes.size()) {
    const std::size_t length = number_at(bytes, chunk);
    if (length > bytes.size() - chunk - kNumber - kName - kNumber) break;
    const std::size_t end = chunk + kNumber + kName + length;
    const std::string_view sum_of(bytes.data() + chunk + kNumber, kName + length);
    const std::uint32_t sum = Checksum().add(sum_of).value();
    for (std::size_t i = 0; i < kNumber; ++i)
      bytes[end + i] = static_cast<char>(sum >> (24 - 8 * i) & 0xFFU);
    chunk = end + kNumber;
  }
  return bytes;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return try_image(with_right_checksums(std::string(text_of(data, size))), "image.png",
                   [](const auto& file) { (void)read_png(file); });
}
