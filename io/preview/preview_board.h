#pragma once

#include "core/scene/pixel_window.h"
#include "io/preview/preview_wishes.h"

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace abbe {

/// What a preview shows: linear sRGB, or a layer's values.
struct PreviewPicture {
  int number = 0; ///< counts the pictures of a preview
  PixelWindow frame, part;
  int channels = 3;
  std::vector<float> values; ///< the channels side by side, rows from the top of `part`
};

/// How a preview goes.
struct PreviewReport {
  std::string title;    ///< of the scene
  std::string error;    ///< of the scene, as "file:line:column: message"; empty where there is none
  std::string warnings; ///< of the scene, one a line
  std::string camera;   ///< the lines of the scene that place the camera as it is now
  int width = 0, height = 0;     ///< of the scene's own frame
  std::string state = "reading"; ///< "reading", "coarse", "rendering", "done", "error"
  double fraction = 0.0, seconds = 0.0, seconds_left = 0.0;
  double samples = 0.0;        ///< of a pixel, in the mean
  std::optional<double> noise; ///< the estimated relative error
  double rays_per_second = 0.0;
  double first_picture_seconds = 0.0; ///< from what made it render anew to the first picture
  int renderings = 0;                 ///< how often it has begun
};

/// Where the thread that renders and those that answer the page meet.
class PreviewBoard {
public:
  // For the thread that renders.
  void show(PreviewPicture picture);
  void tell(const PreviewReport& report);
  /// Waits until something is wished that was not taken before, or the preview is to end. Then
  /// `stop` is false again.
  [[nodiscard]] PreviewWishes take_wishes();
  /// True when what is rendered is of no use any more.
  [[nodiscard]] const std::atomic<bool>& stop() const { return stop_; }

  // For all others.
  struct News {
    int version = 0;
    PreviewReport report;
    std::shared_ptr<const PreviewPicture> picture; ///< null before the first
  };
  /// The news, once they are others than those of the version that was seen, or after a second.
  [[nodiscard]] News news(int seen);
  /// Changes what is wished, and has it rendered.
  void wish(const std::function<void(PreviewWishes&)>& change);
  /// Ends the preview.
  void end();

private:
  std::mutex mutex_;
  std::condition_variable changed_;
  News news_;
  PreviewWishes wishes_;
  bool wished_ = true;
  std::atomic<bool> stop_ = false;
};

} // namespace abbe
