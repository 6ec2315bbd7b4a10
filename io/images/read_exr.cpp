#include "io/images/read_image.h"

#include <Imath/ImathBox.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>

#include <array>
#include <cstdint>
#include <stdexcept>

namespace abbe {

ReflectanceImage read_exr(const std::filesystem::path& path) {
  Imf::InputFile file(path.c_str());
  const Imath::Box2i window = file.header().dataWindow(); // includes its last pixel
  const auto width = static_cast<std::int64_t>(window.max.x) - window.min.x + 1;
  const auto height = static_cast<std::int64_t>(window.max.y) - window.min.y + 1;
  require_image_size(static_cast<std::uint64_t>(width), static_cast<std::uint64_t>(height));
  ReflectanceImage image{static_cast<int>(width), static_cast<int>(height), {}};
  image.rgb.resize(3 * static_cast<std::size_t>(width * height));

  constexpr std::array<const char*, 3> kNames{"R", "G", "B"};
  constexpr std::size_t kPixel = 3 * sizeof(float);
  Imf::FrameBuffer frame;
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    const Imf::Channel* channel = file.header().channels().findChannel(kNames[i]);
    if (!channel || channel->xSampling != 1 || channel->ySampling != 1)
      throw std::runtime_error("it has no full channels R, G and B");
    frame.insert(kNames[i], Imf::Slice::Make(Imf::FLOAT, image.rgb.data() + i, window, kPixel,
                                             kPixel * static_cast<std::size_t>(width)));
  }
  file.setFrameBuffer(frame);
  file.readPixels(window.min.y, window.max.y);
  return image;
}

} // namespace abbe
