#include "geometry/rays/short_vector.h"
#include "tests/catch.h"
#include "tests/geometry/random.h"

#include <array>
#include <vector>

using namespace abbe;
using reference::Random;

// The standard library's list is the model; lengths go over and back below what lives inside.
TEST_CASE("a short list holds what a vector holds, of any length") {
  using List = ShortVector<int, 4>;
  Random random(90);
  std::array<List, 3> lists;
  std::array<std::vector<int>, 3> models;
  std::size_t longest = 0;
  for (int step = 0; step < 20000; ++step) {
    const auto a = static_cast<std::size_t>(random.below(3));
    const auto b = static_cast<std::size_t>(random.below(3));
    List& list = lists[a];
    std::vector<int>& model = models[a];
    const int place = random.below(static_cast<int>(model.size()) + 1);
    switch (random.below(7)) {
    case 0:
    case 1:
      list.push_back(step);
      model.push_back(step);
      break;
    case 2:
    case 3:
      list.insert(static_cast<std::size_t>(place), step);
      model.insert(model.begin() + place, step);
      break;
    case 4:
      if (place == static_cast<int>(model.size())) break;
      list.erase(static_cast<std::size_t>(place));
      model.erase(model.begin() + place);
      break;
    case 5: // also onto itself
      list = lists[b];
      model = models[b];
      break;
    default:
      if (random.below(8) > 0) break;
      list.clear();
      model.clear();
    }
    longest = std::max(longest, model.size());
    const List copy = list;
    REQUIRE(list.size() == model.size());
    REQUIRE(list.empty() == model.empty());
    REQUIRE(std::equal(list.begin(), list.end(), model.begin(), model.end()));
    REQUIRE(std::equal(copy.begin(), copy.end(), model.begin(), model.end()));
  }
  CHECK(longest > 16);
}
