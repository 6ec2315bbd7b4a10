#include "core/adaptive/sample_schedule.h"
#include "core/planning/plan_samples.h"
#include "tests/catch.h"

#include <stdexcept>
#include <vector>

using namespace abbe;

namespace {

RenderSettings settings(int samples, AdaptiveSampling adaptive, double seconds = 0.0) {
  RenderSettings s;
  s.samples_per_pixel = samples;
  s.adaptive = adaptive;
  s.seconds = seconds;
  return s;
}

std::vector<int> rounds(const RenderSettings& s) {
  const SampleSchedule schedule(s);
  std::vector<int> ends;
  for (int done = 0; done < s.samples_per_pixel; ends.push_back(done))
    done = schedule.end_of_round(done);
  return ends;
}

std::vector<int> passes(const RenderSettings& s) {
  const SampleSchedule schedule(s);
  std::vector<int> ends;
  for (int done = 0, round = 0; done < s.samples_per_pixel; ends.push_back(done)) {
    if (done == round) round = schedule.end_of_round(done);
    done = schedule.end_of_pass(done, round);
  }
  return ends;
}

AdaptiveSampling planned(RenderSettings s) {
  plan_samples(s);
  return s.adaptive;
}

using Ends = std::vector<int>;
constexpr auto kOn = AdaptiveSampling::on, kOff = AdaptiveSampling::off,
               kAutomatic = AdaptiveSampling::automatic;

} // namespace

TEST_CASE("without adaptive sampling there is one round, in passes of 16") {
  CHECK(rounds(settings(100, kOff)) == Ends{100});
  CHECK(passes(settings(40, kOff)) == Ends{16, 32, 40});
}

TEST_CASE(
    "adaptive sampling begins with a quarter, at least four, and ends at what was asked for") {
  CHECK(rounds(settings(1, kOn)) == Ends{1});
  CHECK(rounds(settings(4, kOn)) == Ends{4});
  CHECK(rounds(settings(5, kOn)) == Ends{4, 5});
  CHECK(rounds(settings(8, kOn)) == Ends{4, 8});
  CHECK(rounds(settings(16, kOn)) == Ends{4, 16});
  CHECK(rounds(settings(64, kOn)) == Ends{16, 64});
  CHECK(rounds(settings(100, kOn)) == Ends{16, 100});
  CHECK(rounds(settings(1024, kOn)) == Ends{256, 1024});
  CHECK(passes(settings(64, kOn)) == Ends{16, 32, 48, 64});
  CHECK(passes(settings(20, kOn)) == Ends{4, 16, 20});
  CHECK(passes(settings(40, kOn)) == Ends{8, 16, 32, 40});
  CHECK(SampleSchedule::passes(8, 40) == 3);
  CHECK(SampleSchedule::passes(4, 16) == 1);
  CHECK(SampleSchedule::passes(64, 96) == 2);
  CHECK(SampleSchedule::passes(96, 128) == 2);
  CHECK(SampleSchedule::passes(64, 100) == 3);
}

TEST_CASE("a rendering in a hurry begins with short passes") {
  CHECK(passes(settings(40, kOff, 1.0)) == Ends{1, 2, 4, 8, 16, 32, 40});
  CHECK(passes(settings(64, kOn, 1.0)) == Ends{1, 2, 4, 8, 16, 24, 32, 48, 64});
  CHECK(rounds(settings(4096, kOn, 1.0)).front() == 16);
}

TEST_CASE("light paths come for 16 samples at a time, however short the passes") {
  const SampleSchedule schedule(settings(40, kOn));
  CHECK(schedule.end_of_light_pass(0, 8) == 16);
  CHECK(schedule.end_of_light_pass(16, 24) == 32);
  CHECK(schedule.end_of_light_pass(32, 40) == 40);
  CHECK(SampleSchedule(settings(4096, kOn, 1.0)).end_of_light_pass(1, 2) == 2);
}

TEST_CASE("light paths are followed for as many samples as there is time for, and at least one") {
  const auto end = [](double seconds, double seconds_left) {
    return SampleSchedule::end_in_time({16, 32}, seconds, seconds_left);
  };
  CHECK(end(8.0, 100.0) == 32);
  CHECK(end(8.0, 2.25) == 20);
  CHECK(end(8.0, 0.25) == 17);
  CHECK(end(8.0, 0.0) == 17);
  CHECK(end(0.0, 1.0) == 32);
  CHECK(end(0.0, 0.0) == 32);
}

TEST_CASE("tiles may end at 64, 96, 128, 192 ... samples") {
  const SampleSchedule schedule(settings(4096, kOff));
  Ends ends;
  for (int n = 1; n <= 200; ++n)
    if (schedule.may_end(n)) ends.push_back(n);
  CHECK(ends == Ends{64, 96, 128, 192});
}

TEST_CASE("adaptive sampling is automatic where there are samples enough") {
  CHECK(planned(settings(0, kAutomatic)) == kOn); // 16
  CHECK(planned(settings(8, kAutomatic)) == kOn);
  CHECK(planned(settings(7, kAutomatic)) == kOff);
  CHECK(planned(settings(2, kOn)) == kOn);
  CHECK(planned(settings(64, kOff)) == kOff);
  CHECK(planned(settings(0, kAutomatic, 1.0)) == kOn);
}

TEST_CASE("a noise target excludes adaptive sampling") {
  RenderSettings s = settings(0, kAutomatic);
  s.noise = 0.1;
  CHECK(planned(s) == kOff);
  s.adaptive = kOn;
  CHECK_THROWS_WITH(plan_samples(s),
                    "adaptive on and a noise target exclude each other: with a target each tile "
                    "ends on its own. Leave out one of them");
}
