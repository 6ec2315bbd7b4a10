#include "core/adaptive/sample_schedule.h"

#include <algorithm>
#include <bit>

namespace abbe {
namespace {

constexpr int kSamplesPerPass = 16;
/// A tile that still looks black may hold a small light. Measured: docs/decisions/noise.md.
constexpr int kFirstLook = 64;
constexpr int kFewestInFirstRound = 4; ///< a power of two

int largest_power_of_two(int most) {
  return static_cast<int>(std::bit_floor(static_cast<unsigned>(most)));
}

} // namespace

SampleSchedule::SampleSchedule(const RenderSettings& settings)
    : most_(settings.samples_per_pixel), adaptive_(settings.adaptive == AdaptiveSampling::on),
      timed_(settings.seconds > 0.0) {}

int SampleSchedule::first_round() const {
  // A quarter of all samples. With fewer than four a pixel tells little.
  const int first = std::max(largest_power_of_two(most_) / 4, kFewestInFirstRound);
  return std::min(timed_ ? std::min(first, kSamplesPerPass) : first, most_);
}

int SampleSchedule::end_of_round(int done) const {
  if (!adaptive_) return most_;
  if (done == 0) return first_round();
  if (!timed_) return most_;
  const int power = largest_power_of_two(done);
  const int next = done == power ? power + std::max(power / 2, 1) : 2 * power;
  return next <= most_ - next / 4 ? next : most_; // no short round at the end
}

bool SampleSchedule::in_hurry(int done) const {
  return timed_ && done < kSamplesPerPass;
}

int SampleSchedule::end_of_pass(int done, int round_end) const {
  // Passes end where light passes do, even if a round began between.
  const int end =
      in_hurry(done) ? done + std::max(done, 1) : (done / kSamplesPerPass + 1) * kSamplesPerPass;
  return std::min(end, round_end);
}

int SampleSchedule::passes(int done, int round_end) {
  return (round_end + kSamplesPerPass - 1) / kSamplesPerPass - done / kSamplesPerPass;
}

int SampleSchedule::end_of_light_pass(int done, int pass_end) const {
  return in_hurry(done) ? pass_end : std::min(done + kSamplesPerPass, most_);
}

int SampleSchedule::end_in_time(SampleRange samples, double seconds, double seconds_left) {
  const double fitting = seconds_left * samples.first / seconds; // not a number counts as endless
  if (!(fitting < samples.last - samples.first)) return samples.last;
  return samples.first + std::max(static_cast<int>(fitting), 1);
}

bool SampleSchedule::may_end(int samples) const {
  const int power = largest_power_of_two(samples);
  return samples >= kFirstLook && (samples == power || samples == power + power / 2);
}

} // namespace abbe
