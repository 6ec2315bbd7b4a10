#pragma once

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>

#include <filesystem>
#include <string>
#include <vector>

namespace abbe::test {

/// A channel and its values, row by row.
struct ForeignChannel {
  std::string name;
  std::vector<float> values;
};

/// Writes an EXR as another program does, by OpenEXR alone.
inline void write_foreign_exr(const std::filesystem::path& path, int width, int height,
                              const std::vector<ForeignChannel>& channels) {
  Imf::Header header(width, height);
  Imf::FrameBuffer frame;
  for (const ForeignChannel& channel : channels) {
    header.channels().insert(channel.name, Imf::Channel(Imf::FLOAT));
    frame.insert(channel.name,
                 Imf::Slice::Make(Imf::FLOAT, channel.values.data(), header.dataWindow(),
                                  sizeof(float), sizeof(float) * static_cast<std::size_t>(width)));
  }
  Imf::OutputFile file(path.c_str(), header);
  file.setFrameBuffer(frame);
  file.writePixels(height);
}

} // namespace abbe::test
