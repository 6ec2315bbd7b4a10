#include "io/text/similar_names.h"

#include "tests/catch.h"

using namespace abbe;

using Names = std::vector<std::string>;

TEST_CASE("one wrong, missing, surplus or swapped letter is near") {
  const Names known{"sphere", "square", "scale"};
  CHECK(similar_names("sphera", known) == Names{"sphere"});
  CHECK(similar_names("spere", known) == Names{"sphere"});
  CHECK(similar_names("sspheree", known) == Names{"sphere"});
  CHECK(similar_names("shpere", known) == Names{"sphere"});
  CHECK(similar_names("cbue", {"cube"}) == Names{"cube"}); // four letters allow one step only
  CHECK(similar_names("SPHER", known) == Names{"sphere"});
}

TEST_CASE("a part of a name is near, and the nearest comes first") {
  CHECK(similar_names("BK7", {"K5", "SF11", "N-BK7"}) == Names{"N-BK7"});
  CHECK(similar_names("SF1", {"N-SF11", "SF2", "SF10", "SF11", "F2"}) ==
        Names{"SF2", "SF10", "SF11"});
}

TEST_CASE("a name that is held in the wanted one is near") {
  CHECK(similar_names("Vnumber", {"Vnum", "num"}) == Names{"Vnum", "num"});
  CHECK(similar_names("supper", {"up"}).empty());
}

TEST_CASE("nothing is near to another word or to a single letter") {
  CHECK(similar_names("telescope", {"sphere", "cube"}).empty());
  CHECK(similar_names("x", {"exact", "up", "y"}).empty());
}

TEST_CASE("the question lists what is near") {
  CHECK(did_you_mean("cub", {"cube", "lens"}, "No") == "Did you mean cube?");
  CHECK(did_you_mean("SF1", {"SF10", "SF11"}, "No") == "Did you mean SF10 or SF11?");
  CHECK(did_you_mean("SF1", {"SF10", "SF11", "SF12"}, "No") == "Did you mean SF10, SF11 or SF12?");
  CHECK(did_you_mean("telescope", {"cube"}, "No") == "No");
}
