#include "core/planning/make_plan.h"
#include "core/planning/plan_extent.h"
#include "core/render/peer_sums.h"
#include "core/render/render.h"
#include "tests/catch.h"
#include "tests/core/render/same_states.h"
#include "tests/render_text.h"

#include <algorithm>
#include <barrier>
#include <mutex>
#include <thread>
#include <utility>

using namespace abbe;
using test::check_same;

namespace {

/// Threads in the place of processes.
class Group {
public:
  explicit Group(int count) : meet_(count), count_(count) {}

  [[nodiscard]] Peers peer(int number) {
    return {
        .number = number,
        .count = count_,
        .add_up = [this](Peers::Numbers numbers) { add_up(numbers, true); },
        .add_up_in_first = [this, number](Peers::Numbers numbers) { add_up(numbers, number == 0); },
        .collect_in_first =
            [this, number](const std::vector<std::int64_t>& list) {
              return collect(list, number == 0);
            }};
  }

private:
  void add_up(Peers::Numbers numbers, bool takes) {
    {
      const std::lock_guard lock(mutex_);
      if (sum_.empty()) sum_.resize(numbers.size());
      REQUIRE(sum_.size() == numbers.size()); // all are at the same place
      for (std::size_t i = 0; i < numbers.size(); ++i)
        sum_[i] += numbers[i];
    }
    meet_.arrive_and_wait();
    if (takes) std::copy(sum_.begin(), sum_.end(), numbers.begin());
    leave(sum_);
  }
  std::vector<std::int64_t> collect(const std::vector<std::int64_t>& list, bool takes) {
    {
      const std::lock_guard lock(mutex_);
      lists_.insert(lists_.end(), list.begin(), list.end());
    }
    meet_.arrive_and_wait();
    std::vector<std::int64_t> result;
    if (takes) result = lists_;
    leave(lists_);
    return result;
  }
  /// The last to leave clears it.
  void leave(std::vector<std::int64_t>& shared) {
    meet_.arrive_and_wait();
    {
      const std::lock_guard lock(mutex_);
      shared.clear();
    }
    meet_.arrive_and_wait();
  }

  std::barrier<> meet_;
  int count_;
  std::mutex mutex_;
  std::vector<std::int64_t> sum_, lists_;
};

struct Stage {
  Scene scene;
  Plan plan = make_plan(scene, scene.settings);
  World world = World(scene.shapes, farthest_coordinate(scene));

  [[nodiscard]] SampleRange all() const { return {0, plan.settings.samples_per_pixel}; }
  [[nodiscard]] RenderState begin() const { return begin_rendering(scene, plan, BandPlace{}); }
};

/// A glass ball on a floor under a lamp with an area, in several tiles.
Stage glass(const std::string& settings, int samples, AdaptiveSampling adaptive, double noise) {
  Scene scene = test::scene_from(
      settings + " imageSize 40 24 bands 5 eye 0 1.2 5 fieldOfView 40\n"
                 "background 0.1 0.1 0.2\n"
                 "falloff square intensity 4 light E 1 3 2 1\n"
                 "defaultMaterials diffuse 0.7 0.7 0.7\n"
                 "push rotate -90 1 0 0 scale 4 4 1 square pop\n"
                 "glass N-SF11 push translate 0 0.8 0 scale 0.7 0.7 0.7 sphere pop");
  scene.settings.samples_per_pixel = samples;
  scene.settings.adaptive = adaptive;
  scene.settings.noise = noise;
  scene.settings.threads = 2;
  return {std::move(scene)};
}

/// What so many peers render together, in the state of the first. How often they paused is added to
/// `pauses`.
RenderState by_peers(const Stage& stage, int count, double pause_after, int& pauses) {
  Group group(count);
  std::vector<RenderState> states;
  for (int n = 0; n < count; ++n)
    states.push_back(stage.begin());
  const auto work = [&](int n) {
    const Peers peers = group.peer(n);
    RenderState& state = states[static_cast<std::size_t>(n)];
    const RenderControl control{.pause_after = pause_after, .peers = &peers};
    while (!render(stage.scene, stage.plan, stage.world, stage.all(), state, control))
      if (n == 0) ++pauses;
    add_up_film(state.film, peers);
  };
  std::vector<std::jthread> threads;
  for (int n = 1; n < count; ++n)
    threads.emplace_back(work, n);
  work(0);
  threads.clear();
  return std::move(states.front());
}

} // namespace

// 24 samples end within a light pass. Five peers have tiles enough, but not all the same number.
TEST_CASE("peers render together what one renders alone") {
  struct Case {
    const char* settings;
    AdaptiveSampling adaptive;
    double noise;
    int samples;
  };
  for (const auto& [settings, adaptive, noise, samples] :
       {Case{"integrator whitted sky transparent", AdaptiveSampling::off, 0.0, 16},
        Case{"integrator path maxRecursionDepth 3", AdaptiveSampling::off, 0.0, 24},
        Case{"integrator path aperture 0.2 focusDistance 5", AdaptiveSampling::off, 0.0, 24},
        Case{"integrator path", AdaptiveSampling::on, 0.0, 24},
        Case{"integrator path", AdaptiveSampling::off, 0.08, 72}}) {
    const Stage s = glass(settings, samples, adaptive, noise);
    RenderState whole = s.begin();
    REQUIRE(render(s.scene, s.plan, s.world, s.all(), whole));
    for (const int count : {2, 3, 5}) {
      INFO(settings << ", noise " << noise << ", " << samples << " samples, " << count << " peers");
      int pauses = 0;
      check_same(by_peers(s, count, 0.0, pauses), whole);
      CHECK(pauses == 0);
    }
    int pauses = 0;
    check_same(by_peers(s, 3, 0.001, pauses), whole);
    CHECK(pauses > 0);
  }
}

TEST_CASE("each tile belongs to one peer, and all have about as many") {
  for (const int count : {1, 2, 3, 8, 1000}) {
    std::vector<int> tiles(static_cast<std::size_t>(count));
    for (std::size_t t = 0; t < 4000; ++t) {
      int owners = 0;
      for (int n = 0; n < count; ++n)
        if (Peers{n, count}.has_tile(t)) {
          ++owners;
          ++tiles[static_cast<std::size_t>(n)];
        }
      REQUIRE(owners == 1);
    }
    const auto [least, most] = std::ranges::minmax(tiles);
    CHECK(most - least <= 4);
  }
}
