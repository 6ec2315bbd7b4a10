// What surrounds a scene, as an OpenEXR picture of all directions:
//
//   environment sky.exr
//   environment sky.exr D65 0.5

#include "io/images/read_environment.h"

#include <Imath/ImathBox.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <vector>

namespace abbe {
namespace {

namespace fs = std::filesystem;

/// The names of the channels to read into red, green and blue; empty when there are none.
std::vector<const char*> color_channels(const Imf::ChannelList& channels) {
  const auto has = [&](const char* name) { return channels.findChannel(name) != nullptr; };
  if (has("R") && has("G") && has("B")) return {"R", "G", "B"};
  if (has("Y")) return {"Y"};
  return {};
}

/// True for the primaries of sRGB, to the digits in which they are written.
bool is_srgb(const Imf::Chromaticities& c) {
  const Imf::Chromaticities srgb;
  const auto near = [](const Imath::V2f& a, const Imath::V2f& b) {
    return std::abs(a.x - b.x) < 1e-3f && std::abs(a.y - b.y) < 1e-3f;
  };
  return near(c.red, srgb.red) && near(c.green, srgb.green) && near(c.blue, srgb.blue) &&
         near(c.white, srgb.white);
}

Environment read_picture(const Token& name, const fs::path& path, const Warn& warn) {
  Imf::InputFile file(path.c_str());
  const Imath::Box2i window = file.header().dataWindow();
  const auto channels = color_channels(file.header().channels());
  if (channels.empty())
    throw ReadError(name.where, fmt::format("\"{}\" holds no colours", path.string()),
                    "it has neither channels R, G and B nor a channel Y",
                    "Give a picture in linear sRGB");
  if (Imf::hasChromaticities(file.header()) && !is_srgb(Imf::chromaticities(file.header())))
    warn(fmt::format("{}: \"{}\" has other primaries than sRGB; it is read as if it had not",
                     to_string(name.where), path.string()));
  Environment environment;
  environment.width = window.max.x - window.min.x + 1;
  environment.height = window.max.y - window.min.y + 1;
  const auto width = static_cast<std::size_t>(environment.width);
  environment.rgb.resize(3 * width * static_cast<std::size_t>(environment.height));
  Imf::FrameBuffer frame;
  for (std::size_t c = 0; c < channels.size(); ++c)
    frame.insert(channels[c], Imf::Slice::Make(Imf::FLOAT, environment.rgb.data() + c, window,
                                               3 * sizeof(float), 3 * width * sizeof(float)));
  file.setFrameBuffer(frame);
  file.readPixels(window.min.y, window.max.y);
  if (channels.size() == 1)
    for (std::size_t i = 0; i < environment.rgb.size(); i += 3)
      environment.rgb[i + 1] = environment.rgb[i + 2] = environment.rgb[i];
  return environment;
}

} // namespace

Environment read_environment(const Token& name, const Warn& warn) {
  const fs::path file = fs::path(name.where.file).parent_path() / name.text;
  std::error_code error;
  if (!fs::is_regular_file(file, error))
    throw ReadError(name.where, fmt::format("there is no file \"{}\"", file.string()),
                    "pictures are found relative to the file that names them",
                    "Check the name, or write the whole path");
  Environment environment;
  try {
    environment = read_picture(name, file, warn);
  } catch (const ReadError&) {
    throw;
  } catch (const std::exception& fault) {
    throw ReadError(name.where, fmt::format("\"{}\" cannot be understood", file.string()),
                    fault.what(), "Write the picture again, as OpenEXR");
  }
  const auto bad = std::find_if(environment.rgb.begin(), environment.rgb.end(),
                                [](float v) { return !std::isfinite(v); });
  if (bad != environment.rgb.end()) {
    const auto pixel = (bad - environment.rgb.begin()) / 3;
    throw ReadError(name.where, fmt::format("\"{}\" has a pixel that is no number", file.string()),
                    fmt::format("the one in column {}, row {}", pixel % environment.width,
                                pixel / environment.width),
                    "Mend the picture");
  }
  return environment;
}

} // namespace abbe
