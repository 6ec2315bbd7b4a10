#include "io/preview/preview_board.h"

#include <utility>

namespace abbe {

void PreviewBoard::show(PreviewPicture picture) {
  const std::lock_guard lock(mutex_);
  picture.number = news_.picture ? news_.picture->number + 1 : 1;
  news_.picture = std::make_shared<const PreviewPicture>(std::move(picture));
  ++news_.version;
  changed_.notify_all();
}

void PreviewBoard::tell(const PreviewReport& report) {
  const std::lock_guard lock(mutex_);
  news_.report = report;
  ++news_.version;
  changed_.notify_all();
}

PreviewWishes PreviewBoard::take_wishes() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return wished_; });
  wished_ = false;
  stop_ = wishes_.over;
  PreviewWishes taken = wishes_;
  wishes_.read_again = false;
  wishes_.forget_focus = false;
  wishes_.focus = std::nullopt;
  return taken;
}

PreviewBoard::News PreviewBoard::news(int seen) {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, std::chrono::seconds(1),
                    [&] { return news_.version != seen || wishes_.over; });
  return news_;
}

void PreviewBoard::wish(const std::function<void(PreviewWishes&)>& change) {
  const std::lock_guard lock(mutex_);
  change(wishes_);
  wishes_.since = std::chrono::steady_clock::now();
  wished_ = true;
  stop_ = true;
  changed_.notify_all();
}

void PreviewBoard::end() {
  wish([](PreviewWishes& wishes) { wishes.over = true; });
}

} // namespace abbe
