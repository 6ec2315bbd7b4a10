#include "core/scene/user_error.h"
#include "io/states/check_parts.h"
#include "tests/catch.h"

using namespace abbe;

namespace {

KeptPart part(int number, int count) {
  return {"p" + std::to_string(number + 1),
          {"1.0", 5, "s.sdl", {{"s.sdl", 10, 20}}, {{"--seed", "0"}}, 64, {number, count}},
          true};
}

/// Why the parts are refused; empty when they are not.
std::string refusal(const std::vector<KeptPart>& parts) {
  try {
    check_parts(parts);
  } catch (const UserError& error) {
    return error.what();
  }
  return "";
}

/// The same for three parts the last of which was changed.
template <class Change>
std::string refusal_of(const Change& change) {
  std::vector<KeptPart> parts{part(0, 3), part(2, 3), part(1, 3)};
  change(parts.back());
  return refusal(parts);
}

} // namespace

TEST_CASE("all parts of one rendering belong together, in any order") {
  CHECK(refusal({part(1, 2), part(0, 2)}).empty());
  CHECK(refusal({part(0, 1)}).empty());
}

TEST_CASE("parts that are missing are told") {
  CHECK(refusal({part(0, 2)}) == "of 2 parts, these are missing: 2");
  CHECK(refusal({part(4, 9), part(1, 9), part(8, 9)}) ==
        "of 9 parts, these are missing: 1, 3 to 4 and 6 to 8");
}

TEST_CASE("parts that do not belong together are refused with the reason") {
  const std::string start = "p2: this part does not belong to p1: ";
  CHECK(refusal_of([](KeptPart& p) { p.info.version = "2.0"; }) ==
        start + "abbe 2.0 has written it, and 1.0 the first");
  CHECK(refusal_of([](KeptPart& p) { p.info.files[0].checksum = 1; }) ==
        start + "it shows another scene");
  CHECK(refusal_of([](KeptPart& p) { p.info.settings[0].second = "7"; }) ==
        start + "it was rendered with --seed 7, and the first with --seed 0");
  CHECK(refusal_of([](KeptPart& p) { p.info.samples = 16; }) ==
        start + "it is of 16 samples a pixel, and the first of 64");
  CHECK(refusal_of([](KeptPart& p) { p.info.part.count = 4; }) ==
        start + "it is one of 4 parts, and the first one of 3");
  CHECK(refusal_of([](KeptPart& p) { p.info.part.number = 2; }) ==
        "p3 and p2 are both part 3 of 3");
  CHECK(refusal_of([](KeptPart& p) { p.complete = false; }) ==
        "p2: this part is not complete. Go on with it by --resume");
}
