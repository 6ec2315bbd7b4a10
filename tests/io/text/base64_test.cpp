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
