#pragma once

#include "core/image/image.h"

#include <string>

namespace abbe {

/// A viewer that shows a rendering while it grows: tev, or another that listens for tev's protocol.
class DisplayServer {
public:
  /// `place` is HOST:PORT. Throws UserError where nobody listens there.
  DisplayServer(const std::string& place, std::string image_name);
  ~DisplayServer();
  DisplayServer(const DisplayServer&) = delete;
  DisplayServer& operator=(const DisplayServer&) = delete;

  /// Shows the picture and its layers; the first one says how large the frame is and which layers
  /// there are. Once the viewer has gone nothing is sent, and false is returned.
  [[nodiscard]] bool show(const SceneLinearImage& image);

private:
  void create(const SceneLinearImage& image);
  void update(const SceneLinearImage& image, const PixelWindow& rows);
  void send(std::string packet);

  std::string name_;
  int socket_ = -1;
  bool created_ = false;
};

} // namespace abbe
