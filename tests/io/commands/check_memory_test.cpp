#include "io/commands/check_memory.h"

#include "core/scene/user_error.h"
#include "io/files/available_memory.h"
#include "tests/catch.h"

#include <limits>
#include <string>
#include <vector>

using namespace abbe;
using Catch::Matchers::ContainsSubstring;

namespace {

constexpr std::uint64_t kGiB = std::uint64_t{1} << 30;

std::string said(std::uint64_t need, std::optional<double> limit_gib) {
  try {
    check_memory(picture_needs(need), limit_gib);
  } catch (const UserError& error) {
    return error.what();
  }
  return "";
}

} // namespace

TEST_CASE("a picture that needs more memory than the limit is refused, with both figures") {
  CHECK(said(3 * kGiB, 4.0).empty());
  CHECK_THAT(said(3 * kGiB, 2.5), ContainsSubstring("needs 3.0 GiB of memory") &&
                                      ContainsSubstring("the limit is 2.5 GiB") &&
                                      ContainsSubstring("--limit-memory sets"));
  CHECK_THAT(said(3 * kGiB, 0.25), ContainsSubstring("the limit is 256 MiB"));
}

TEST_CASE("what the process holds already counts against a limit that the user gives") {
  const std::uint64_t before = memory_in_use();
  CHECK(before > 0);
  constexpr std::size_t kMore = 1 << 26;
  const std::vector<char> more(kMore, 'x');
  CHECK(memory_in_use() >= before + kMore * 9 / 10);
  const std::uint64_t held = memory_in_use(), need = kGiB;
  const auto gib = [](std::uint64_t bytes) {
    return static_cast<double>(bytes) / static_cast<double>(kGiB);
  };
  CHECK(said(need, gib(need + 2 * held)).empty());
  CHECK_THAT(said(need, gib(need + held / 2)),
             ContainsSubstring("the scene takes") &&
                 ContainsSubstring("of memory and the picture needs 1.0 GiB more"));
  CHECK(more.back() == 'x');
}

TEST_CASE("without a limit it is what the machine has left") {
  CHECK(available_memory() > kGiB / 16); // these tests run in it
  CHECK(said(kGiB / 1024, std::nullopt).empty());
  CHECK_THAT(said(std::numeric_limits<std::uint64_t>::max() - 1, std::nullopt),
             ContainsSubstring("which is what this machine has left"));
}
