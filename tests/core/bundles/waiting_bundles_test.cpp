#include "core/bundles/waiting_bundles.h"
#include "tests/catch.h"

using namespace abbe;

TEST_CASE("the bundle that came last goes on first, with its own throughput") {
  WaitingBundles waiting(16);
  auto carried = std::make_unique<CarriedBundle>(16);
  for (int i = 0; i < 5; ++i) {
    CarriedBundle& next = waiting.add({i, i + 1});
    next.bundle.depth = i;
    next.throughput()[i] = static_cast<float>(i);
  }
  CHECK(waiting.size() == 5);
  for (int i = 4; i >= 0; --i) {
    REQUIRE(waiting.take(carried));
    CHECK(carried->bundle.depth == i);
    CHECK(carried->bundle.bands.first == i);
    CHECK(carried->throughput()[i] == static_cast<float>(i));
  }
  CHECK(waiting.size() == 0);
  CHECK_FALSE(waiting.take(carried));
  REQUIRE(carried); // nothing was handed over
  CHECK(carried->bundle.depth == 0);
}

TEST_CASE(
    "a bundle that is put to wait comes back as it was, and the caller has room for another") {
  WaitingBundles waiting(16);
  auto carried = std::make_unique<CarriedBundle>(16);
  carried->bundle.bands = {2, 3};
  carried->row[2] = 0.25f;
  const CarriedBundle* const first = carried.get();
  waiting.put(carried);
  REQUIRE(carried);
  CHECK(carried.get() != first);
  CHECK(carried->row.size() == 16);
  (void)waiting.add({0, 1});
  REQUIRE(waiting.take(carried));
  CHECK(carried->bundle.bands.first == 0);
  REQUIRE(waiting.take(carried));
  CHECK(carried.get() == first); // it has not been copied
  CHECK(carried->row[2] == 0.25f);
}

TEST_CASE("a bundle that waits stays in place while others come") {
  WaitingBundles waiting(16);
  CarriedBundle& first = waiting.add({0, 1});
  for (int i = 0; i < 1000; ++i)
    (void)waiting.add({0, 1});
  first.bundle.depth = 7;
  auto carried = std::make_unique<CarriedBundle>(16);
  while (waiting.size() > 0)
    REQUIRE(waiting.take(carried));
  CHECK(carried->bundle.depth == 7);
}
