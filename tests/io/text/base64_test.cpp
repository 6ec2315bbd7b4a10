#include "io/text/base64.h"

#include "tests/catch.h"

using namespace abbe;

TEST_CASE("base64 is that of RFC 4648") {
  CHECK(base64("") == "");
  // The test vectors of its section 10.
  CHECK(base64("f") == "Zg==");
  CHECK(base64("fo") == "Zm8=");
  CHECK(base64("foo") == "Zm9v");
  CHECK(base64("foob") == "Zm9vYg==");
  CHECK(base64("fooba") == "Zm9vYmE=");
  CHECK(base64("foobar") == "Zm9vYmFy");
  CHECK(base64("\xfb\xff\xfe") == "+//+"); // 62, 63, 63, 62
}

TEST_CASE("base64 is read with its padding and without, and other characters are none of it") {
  for (const std::string bytes : {"", "f", "fo", "foo", "foob", "fooba", "foobar", "\xfb\xff\xfe"})
    CHECK(base64_decoded(base64(bytes)) == bytes);
  CHECK(base64_decoded("Zm9vYg") == "foob");
  CHECK_FALSE(base64_decoded("Zm9v Yg==").has_value());
  CHECK_FALSE(base64_decoded("Zm9v-g==").has_value()); // the other alphabet of section 5
}
