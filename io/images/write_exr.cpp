#include "io/images/write_exr.h"

#include "core/image/scene_linear_space.h"
#include "io/files/atomic_file.h"
#include "io/images/write_pixels.h"

#include <Imath/ImathBox.h>
#include <Imath/half.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStdIO.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfThreading.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <exception>
#include <fstream>
#include <span>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

namespace abbe {
namespace {

/// OpenEXR's windows include their last pixel, ours do not.
Imath::Box2i inclusive(const PixelWindow& window) {
  return {{window.x0, window.y0}, {window.x1 - 1, window.y1 - 1}};
}

Imath::M44f to_imath(const Matrix4& matrix) {
  Imath::M44f m;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      m[i][j] =
          static_cast<float>(matrix[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]);
  return m;
}

Imf::Chromaticities chromaticities(SceneLinearSpace space) {
  const ColorSpace s = space_of(space);
  const auto xy = [](const Chromaticity& c) {
    return Imath::V2f(static_cast<float>(c.x), static_cast<float>(c.y));
  };
  return {xy(s.primaries.red), xy(s.primaries.green), xy(s.primaries.blue), xy(s.white)};
}

Imf::Header make_header(const ExrHead& head) {
  Imf::Header header(inclusive(head.display), inclusive(head.data));
  header.compression() = Imf::ZIP_COMPRESSION;
  for (const auto& [name, value] : head.metadata)
    header.insert(name, Imf::StringAttribute(value));
  if (head.tag == ExrTag::interop_id || head.tag == ExrTag::both)
    header.insert("colorInteropID", Imf::StringAttribute(interop_id(head.space)));
  if (head.tag == ExrTag::chromaticities || head.tag == ExrTag::both)
    Imf::addChromaticities(header, chromaticities(head.space));
  if (!head.camera) return header;
  Imf::addWorldToCamera(header, to_imath(head.camera->world_to_camera));
  if (head.camera->world_to_image)
    Imf::addWorldToNDC(header, to_imath(*head.camera->world_to_image));
  return header;
}

/// The header's channels and where the pixels of some rows are.
struct Channels {
  Imf::Header& header;
  PixelWindow rows; ///< the part of the data window whose pixels are given
  Imf::FrameBuffer frame = {};

  /// `first` is the channel's value in the upper left pixel of the rows; `stride` is the number of
  /// values from one pixel to the next.
  template <class Value>
  void add(const std::string& name, const Value* first, std::size_t stride) {
    constexpr Imf::PixelType type = sizeof(Value) == sizeof(float) ? Imf::FLOAT : Imf::HALF;
    const auto width = static_cast<std::size_t>(rows.width());
    header.channels().insert(name, Imf::Channel(type));
    frame.insert(name, Imf::Slice::Make(type, first, inclusive(rows), stride * sizeof(Value),
                                        width * stride * sizeof(Value)));
  }

  template <class Value>
  void add_rgba(const Value* rgba) {
    constexpr std::array names = {"R", "G", "B", "A"};
    for (std::size_t c = 0; c < names.size(); ++c)
      add(names[c], rgba + c, names.size());
  }
};

/// Lets OpenEXR deflate on all processors that this process may use, for one scope. The bytes do
/// not depend on it; 81 bands at 1920 x 1080 take about 10 s on one processor. (source: measured)
class DeflateThreads {
public:
  DeflateThreads() { resume(); }
  DeflateThreads(const DeflateThreads&) = delete;
  DeflateThreads& operator=(const DeflateThreads&) = delete;
  ~DeflateThreads() { Imf::setGlobalThreadCount(before_); }

  /// Ends the threads. A child process that reads an EXR has none of them, and would wait for them.
  void pause() { Imf::setGlobalThreadCount(0); }
  void resume() {
    try {
      Imf::setGlobalThreadCount(static_cast<int>(std::thread::hardware_concurrency()));
    } catch (const std::exception&) { // the system allows no more threads
      Imf::setGlobalThreadCount(0);
    }
  }

private:
  int before_ = Imf::globalThreadCount();
};

/// Rows of an image that go to a file together.
struct RowBlock {
  Imf::FrameBuffer frame;
  int rows;
};

/// Our own stream: OpenEXR's writes its last bytes in a destructor, which hides a full disk.
/// `target` is the name in OpenEXR's messages, `temporary` the file. `channels_of` is asked for the
/// image's rows from the top, `rows` at a time; when it is asked first, it completes the header.
template <class ChannelsOf>
void save(const std::filesystem::path& target, const std::filesystem::path& temporary,
          const Imf::Header& header, const PixelWindow& data, int rows,
          const ChannelsOf& channels_of) {
  const auto block_at = [&](int y) {
    return channels_of(PixelWindow{data.x0, y, data.x1, std::min(y + rows, data.y1)});
  };
  RowBlock block = block_at(data.y0);
  std::ofstream file(temporary, std::ios::binary);
  if (!file) throw std::system_error(errno, std::generic_category());
  {
    Imf::StdOFStream stream(file, target.filename().c_str());
    Imf::OutputFile output(stream, header);
    for (int y = data.y0; y < data.y1; y += rows) {
      if (y > data.y0) block = block_at(y);
      output.setFrameBuffer(block.frame);
      output.writePixels(block.rows);
    }
  }
  file.close();
  if (!file) throw std::runtime_error("the file could not be completed (is the disk full?)");
}

/// OpenEXR deflates so many rows together; each thread takes such a block.
constexpr int kRowsPerDeflate = 16;

/// `S0.380,000000nm`: intensity; decimal comma, since a dot separates layers. (source: Fichet2021)
std::string spectral_channel_name(double wavelength_nm) {
  std::string number = fmt::format("{:.6f}", wavelength_nm);
  std::replace(number.begin(), number.end(), '.', ',');
  return "S0." + number + "nm";
}

} // namespace

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

/// The largest finite half is (2 - 2^-10) 2^15; from the middle between it and 2^16 on, values are
/// rounded to infinity. (source: IEEE 754)
bool fits_half(std::span<const float> values) {
  constexpr float first_infinite = 65520.0f;
  return std::ranges::none_of(values, [](float value) {
    return std::abs(value) >= first_infinite && std::isfinite(value);
  });
}

void write_exr_rows(const std::filesystem::path& path, const ExrHead& head, ExrPixel pixel,
                    const LinearRows& develop) {
  replace_file(path, [&](const std::filesystem::path& temporary) {
    require_pixels(head.display, head.data, 4 * head.data.pixel_count(), 4);
    Imf::Header header = make_header(head);
    SceneLinearImage image;
    std::vector<Imath::half> halves;
    const auto channels_of = [&](const PixelWindow& rows) {
      image = develop(rows);
      Channels channels{header, rows};
      if (!image.rgba.empty() || image.channels.empty()) {
        require_pixels(head.display, rows, image.rgba.size(), 4);
        if (pixel == ExrPixel::single) channels.add_rgba(image.rgba.data());
        if (pixel == ExrPixel::half) {
          halves.assign(image.rgba.begin(), image.rgba.end());
          channels.add_rgba(halves.data());
        }
      }
      for (const ImageChannel& channel : image.channels) {
        require_pixels(head.display, rows, channel.values.size(), 1);
        channels.add(channel.name, channel.values.data(), 1);
      }
      return RowBlock{channels.frame, rows.height()};
    };
    const DeflateThreads threads;
    const int rows = kRowsPerDeflate * std::clamp(Imf::globalThreadCount(), 1, 8);
    save(path, temporary, header, head.data, rows, channels_of);
  });
}

ExrPixel write_exr(const std::filesystem::path& path, const SceneLinearImage& image, ExrPixel pixel,
                   ExrTag tag) {
  if (!fits_half(image.rgba)) pixel = ExrPixel::single;
  const auto rows_of = [&](const PixelWindow& rows) {
    const auto begin = static_cast<std::ptrdiff_t>(image.data.index(rows.x0, rows.y0));
    const auto count = static_cast<std::ptrdiff_t>(rows.pixel_count());
    const auto part = [&](const std::vector<float>& values, std::ptrdiff_t channels) {
      return std::vector<float>(values.begin() + channels * begin,
                                values.begin() + channels * (begin + count));
    };
    SceneLinearImage some{image.display, rows, {}, {}, image.space};
    if (!image.rgba.empty()) some.rgba = part(image.rgba, 4);
    for (const ImageChannel& channel : image.channels)
      some.channels.push_back({channel.name, part(channel.values, 1)});
    return some;
  };
  write_exr_rows(path, {image.display, image.data, image.metadata, image.space, image.camera, tag},
                 pixel, rows_of);
  return pixel;
}

void write_spectral_exr(const std::filesystem::path& path, const PixelWindow& data,
                        const std::function<SpectralImage(const PixelWindow& rows)>& develop,
                        ExrTag tag) {
  replace_file(path, [&](const std::filesystem::path& temporary) {
    require_pixels(data, data, 4 * data.pixel_count(), 4);
    SpectralImage image = develop({data.x0, data.y0, data.x1, data.y0 + 1});
    Imf::Header header = make_header(
        {image.display, data, image.metadata, SceneLinearSpace::rec709, image.camera, tag});
    header.insert("spectralLayoutVersion", Imf::StringAttribute("1.0"));
    header.insert("emissiveUnits", Imf::StringAttribute("W.m^-2.sr^-1"));
    header.insert("EV", Imf::FloatAttribute(0.0f));
    DeflateThreads threads;
    // A block for each thread, but no more than 8: 160 MiB at a width of 3840 and 81 bands.
    const int rows = kRowsPerDeflate * std::clamp(Imf::globalThreadCount(), 1, 8);
    const auto channels_of = [&](const PixelWindow& part) {
      threads.pause(); // what is developed may be read from other files
      image = develop(part);
      threads.resume();
      require_pixels(image.display, part, image.rgba.size(), 4);
      require_pixels(image.display, part, image.values.size(), image.wavelengths_nm.size());
      Channels channels{header, part};
      channels.add_rgba(image.rgba.data());
      for (std::size_t band = 0; band < image.wavelengths_nm.size(); ++band)
        channels.add(spectral_channel_name(image.wavelengths_nm[band]),
                     image.values.data() + band * part.pixel_count(), 1);
      return RowBlock{channels.frame, part.height()};
    };
    save(path, temporary, header, data, rows, channels_of);
  });
}

} // namespace abbe
