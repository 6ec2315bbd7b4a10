#include "geometry/world/world.h"
#include "tests/catch.h"
#include "tests/geometry/scene.h"

#include <sys/mman.h>
#include <unistd.h>

#include <memory>
#include <string>

using namespace abbe;
using namespace abbe::reference;

namespace {

/// Room for states that ends where memory that nobody may touch begins: who reads beyond the last
/// state ends the program, with or without a sanitizer.
class GuardedStates {
public:
  explicit GuardedStates(std::size_t count)
      : count_(count), page_(static_cast<std::size_t>(sysconf(_SC_PAGESIZE))),
        usable_((count * sizeof(RayState) + page_ - 1) / page_ * page_) {
    void* memory =
        mmap(nullptr, usable_ + page_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    REQUIRE(memory != MAP_FAILED);
    begin_ = static_cast<std::byte*>(memory);
    REQUIRE(mprotect(begin_ + usable_, page_, PROT_NONE) == 0);
    std::uninitialized_default_construct_n(states(), count_);
  }
  ~GuardedStates() {
    std::destroy_n(states(), count_);
    munmap(begin_, usable_ + page_);
  }
  GuardedStates(const GuardedStates&) = delete;
  GuardedStates& operator=(const GuardedStates&) = delete;

  [[nodiscard]] std::span<RayState> span() { return {states(), count_}; }

private:
  [[nodiscard]] RayState* states() {
    return reinterpret_cast<RayState*>(begin_ + usable_ - count_ * sizeof(RayState));
  }

  std::size_t count_, page_, usable_;
  std::byte* begin_ = nullptr;
};

/// All kinds of shapes around the origin.
std::vector<PlacedShape> cluster(Random& random) {
  Scene scene;
  for (int i = 0; i < 40; ++i)
    scene.add(placed(i % 3 == 0   ? sphere()
                     : i % 3 == 1 ? box()
                                  : square(),
                     random.linear(), random.in_cube(3.0)),
              0);
  return scene.shapes();
}

} // namespace

TEST_CASE("no packet reads beyond its rays, however narrow the instruction set") {
  Random random(44);
  const std::vector<PlacedShape> shapes = cluster(random);
  const World widest(shapes, 10.0);
  for (const char* isa : {"isa=sse2", "isa=sse4.2", "isa=avx", "isa=avx2", "isa=avx512"}) {
    INFO(isa);
    const World world(shapes, 10.0, isa);
    std::size_t met = 0;
    for (std::size_t count = 1; count <= 33; ++count) {
      GuardedStates guarded(count);
      const std::span<RayState> states = guarded.span();
      const dvec3 o = random.in_cube(8.0);
      for (RayState& state : states) {
        state.ray = {o, glm::normalize(-o + random.in_cube(2.0))};
        state.nesting = world.nesting_at(o);
      }
      std::vector<Hit> hits(count), expected(count);
      world.find_closest(states, hits, Tracing::packets);
      widest.find_closest(states, expected, Tracing::single);
      for (std::size_t i = 0; i < count; ++i) {
        REQUIRE(hits[i].shape == expected[i].shape);
        if (!hits[i].met()) continue;
        ++met;
        REQUIRE(hits[i].t == expected[i].t);
      }
      for (const int width : {1, 4, 8, 16})
        CHECK(world.replay_closest(states, width) == widest.replay_closest(states, 1));
    }
    CHECK(met > 33 * 34 / 2 / 4);
  }
}
