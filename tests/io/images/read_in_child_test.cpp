#include "io/images/read_in_child.h"

#include "tests/catch.h"

#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>

using namespace abbe;

namespace {

std::string error(const std::function<ExrImage()>& read, const ReadingLimits& limits = {}) {
  try {
    (void)read_in_child(read, limits);
  } catch (const std::runtime_error& fault) {
    return fault.what();
  }
  return "no error";
}

} // namespace

TEST_CASE("an image comes back from the child as it was read") {
  ExrImage image{500, 300, std::vector<float>(3 * 500 * 300), "a tag"}; // more than a pipe holds
  for (std::size_t i = 0; i < image.rgb.size(); ++i)
    image.rgb[i] = static_cast<float>(i) - 0.25F;
  const ExrImage read = read_in_child([&] { return image; });
  CHECK(read.width == 500);
  CHECK(read.height == 300);
  CHECK(read.unknown_tag == "a tag");
  CHECK(read.rgb == image.rgb);
}

TEST_CASE("what a child throws is thrown here") {
  CHECK(error([]() -> ExrImage { throw std::runtime_error("no such compression"); }) ==
        "no such compression");
}

TEST_CASE("a library that ends or stops its process is an error, and the program goes on") {
  CHECK(error([]() -> ExrImage {
          std::signal(SIGSEGV, SIG_DFL);
          std::raise(SIGSEGV);
          return {};
        }) == "its reader ended by signal 11 (Segmentation fault), it is damaged");
  CHECK(error([]() -> ExrImage { ::_Exit(3); }) == "its reader ended with exit code 3");
  CHECK(error(
            []() -> ExrImage {
              for (volatile int i = 0; i == 0;) // for ever
                continue;
              return {};
            },
            {.processor_seconds = 1}) == "reading it takes more than 1 s");
  CHECK(error(
            []() -> ExrImage {
              while (true)
                ::pause(); // as on a disk that does not answer
            },
            {.seconds = 1}) == "reading it takes more than 1 s");
}

TEST_CASE("a library that takes too much memory is an error") {
  const std::string message = error(
      []() -> ExrImage {
        ExrImage image{1, 1, {}, {}};
        image.rgb.assign(std::size_t{1} << 28, 1.0F); // 1 GiB
        return image;
      },
      {.memory = std::uint64_t{1} << 28});
#ifdef __SANITIZE_ADDRESS__ // it ends the process instead of throwing
  CHECK(message != "no error");
#else
  CHECK(message == "reading it takes more than 256 MiB of memory");
#endif
}
