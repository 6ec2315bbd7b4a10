#include "io/write_exr.h"

#include "io/atomic_file.h"
#include "io/write_pixels.h"

#include <Imath/ImathBox.h>
#include <Imath/half.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStdIO.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfThreading.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <fstream>
#include <string>
#include <system_error>
#include <thread>

namespace abbe {
namespace {

/// OpenEXR's windows include their last pixel, ours do not.
Imath::Box2i inclusive(const PixelWindow& window) {
  return {{window.x0, window.y0}, {window.x1 - 1, window.y1 - 1}};
}

/// (source: ColorInterop2026)
const char* interop_id(SceneLinearSpace space) {
  switch (space) {
  case SceneLinearSpace::rec709:
    return "lin_rec709_scene";
  case SceneLinearSpace::acescg:
    return "lin_ap1_scene";
  case SceneLinearSpace::aces2065_1:
    return "lin_ap0_scene";
  case SceneLinearSpace::rec2020:
    return "lin_rec2020_scene";
  }
  return "unknown";
}

Imf::Header make_header(const PixelWindow& display, const PixelWindow& data,
                        const Metadata& metadata, SceneLinearSpace space) {
  Imf::Header header(inclusive(display), inclusive(data));
  header.compression() = Imf::ZIP_COMPRESSION;
  for (const auto& [name, value] : metadata)
    header.insert(name, Imf::StringAttribute(value));
  // The tag replaces `chromaticities`, which must not stand beside it. (source: ColorInterop2026)
  header.insert("colorInteropID", Imf::StringAttribute(interop_id(space)));
  return header;
}

/// The header's channels and where their pixels are.
struct Channels {
  Imf::Header& header;
  Imf::FrameBuffer frame;

  /// `first` is the channel's value in the upper left pixel of the data window; `stride` is the
  /// number of values from one pixel to the next.
  template <class Value>
  void add(const std::string& name, const Value* first, std::size_t stride) {
    constexpr Imf::PixelType type = sizeof(Value) == sizeof(float) ? Imf::FLOAT : Imf::HALF;
    const Imath::Box2i& window = header.dataWindow();
    const std::size_t width = static_cast<std::size_t>(window.size().x) + 1;
    header.channels().insert(name, Imf::Channel(type));
    frame.insert(name, Imf::Slice::Make(type, first, window, stride * sizeof(Value),
                                        width * stride * sizeof(Value)));
  }

  template <class Value>
  void add_rgba(const std::vector<Value>& rgba) {
    constexpr std::array names = {"R", "G", "B", "A"};
    for (std::size_t c = 0; c < names.size(); ++c)
      add(names[c], rgba.data() + c, names.size());
  }
};

/// Lets OpenEXR deflate on all processors that this process may use, for one scope. The bytes do
/// not depend on it; 81 bands at 1920 x 1080 take about 10 s on one processor. (source: measured)
class DeflateThreads {
public:
  DeflateThreads() {
    Imf::setGlobalThreadCount(static_cast<int>(std::thread::hardware_concurrency()));
  }
  DeflateThreads(const DeflateThreads&) = delete;
  DeflateThreads& operator=(const DeflateThreads&) = delete;
  ~DeflateThreads() { Imf::setGlobalThreadCount(before_); }

private:
  int before_ = Imf::globalThreadCount();
};

/// Our own stream: OpenEXR's writes its last bytes in a destructor, which hides a full disk.
/// `target` is the name in OpenEXR's messages, `temporary` the file.
void save(const std::filesystem::path& target, const std::filesystem::path& temporary,
          const Channels& channels, int rows) {
  std::ofstream file(temporary, std::ios::binary);
  if (!file) throw std::system_error(errno, std::generic_category());
  {
    Imf::StdOFStream stream(file, target.filename().c_str());
    Imf::OutputFile output(stream, channels.header);
    output.setFrameBuffer(channels.frame);
    output.writePixels(rows);
  }
  file.close();
  if (!file) throw std::runtime_error("the file could not be completed (is the disk full?)");
}

std::vector<Imath::half> to_half(const std::vector<float>& values) {
  constexpr float largest = 65504.0f; // (2 - 2^-10) 2^15, the largest finite half (IEEE 754)
  std::vector<Imath::half> halves;
  halves.reserve(values.size());
  for (const float value : values)
    halves.emplace_back(std::isfinite(value) ? std::clamp(value, -largest, largest) : value);
  return halves;
}

/// `S0.380,000000nm`: intensity; decimal comma, since a dot separates layers. (source: Fichet2021)
std::string spectral_channel_name(double wavelength_nm) {
  std::string number = fmt::format("{:.6f}", wavelength_nm);
  std::replace(number.begin(), number.end(), '.', ',');
  return "S0." + number + "nm";
}

} // namespace

void write_exr(const std::filesystem::path& path, const SceneLinearImage& image, ExrPixel pixel) {
  replace_file(path, [&](const std::filesystem::path& temporary) {
    require_pixels(image.display, image.data, image.rgba.size(), 4);
    Imf::Header header = make_header(image.display, image.data, image.metadata, image.space);
    Channels channels{header, {}};
    std::vector<Imath::half> halves;
    switch (pixel) {
    case ExrPixel::half:
      halves = to_half(image.rgba);
      channels.add_rgba(halves);
      break;
    case ExrPixel::single:
      channels.add_rgba(image.rgba);
      break;
    }
    for (const ImageChannel& channel : image.channels) {
      require_pixels(image.display, image.data, channel.values.size(), 1);
      channels.add(channel.name, channel.values.data(), 1);
    }
    save(path, temporary, channels, image.data.height());
  });
}

void write_spectral_exr(const std::filesystem::path& path, const SpectralImage& image) {
  replace_file(path, [&](const std::filesystem::path& temporary) {
    require_pixels(image.display, image.data, image.rgba.size(), 4);
    require_pixels(image.display, image.data, image.values.size(), image.wavelengths_nm.size());
    Imf::Header header =
        make_header(image.display, image.data, image.metadata, SceneLinearSpace::rec709);
    header.insert("spectralLayoutVersion", Imf::StringAttribute("1.0"));
    header.insert("emissiveUnits", Imf::StringAttribute("W.m^-2.sr^-1"));
    header.insert("EV", Imf::FloatAttribute(0.0f));
    Channels channels{header, {}};
    channels.add_rgba(image.rgba);
    for (std::size_t band = 0; band < image.wavelengths_nm.size(); ++band)
      channels.add(spectral_channel_name(image.wavelengths_nm[band]),
                   image.values.data() + band * image.data.pixel_count(), 1);
    const DeflateThreads threads;
    save(path, temporary, channels, image.data.height());
  });
}

} // namespace abbe
