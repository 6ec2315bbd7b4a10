#include "core/render/progress_meter.h"

#include <algorithm>
#include <utility>

namespace abbe {

ProgressMeter::ProgressMeter(const ProgressCallback& callback, double expected, double time_limit)
    : callback_(callback), expected_(expected), time_limit_(time_limit) {}

void ProgressMeter::step(const RayCounts& rays, double done, double expected_more) {
  const std::lock_guard lock(mutex_);
  rays_ += rays;
  since_ += rays;
  done_ += done;
  expected_ += expected_more;
  const double now = seconds();
  if (!callback_ || (now - told_ < 0.1 && done_ < expected_)) return;
  told_ = now;
  fraction_ = std::max(fraction_, done_ / expected_);
  if (time_limit_ > 0.0) fraction_ = std::max(fraction_, std::min(now / time_limit_, 1.0));
  callback_({fraction_, now, rays_, false});
}

void ProgressMeter::add(const RayCounts& rays) {
  const std::lock_guard lock(mutex_);
  rays_ += rays;
  since_ += rays;
}

void ProgressMeter::follow_light() {
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (!lock || !callback_ || seconds() - told_ < 0.1) return;
  told_ = seconds();
  callback_({fraction_, told_, rays_, true});
}

RayCounts ProgressMeter::take_rays() {
  return std::exchange(since_, {});
}

double ProgressMeter::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

} // namespace abbe
