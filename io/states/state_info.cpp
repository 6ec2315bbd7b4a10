#include "io/states/state_info.h"

#include "io/files/checksum.h"

#include <algorithm>
#include <fstream>
#include <stdexcept>

#ifndef ABBE_VERSION
#define ABBE_VERSION "unknown"
#endif

namespace abbe {
namespace {

namespace fs = std::filesystem;

SceneFile identified(const fs::path& path) {
  SceneFile file{fs::absolute(path).lexically_normal()};
  std::ifstream stream(path, std::ios::binary);
  Checksum sum;
  std::string bytes(1 << 16, '\0');
  while (stream) {
    stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    const auto count = static_cast<std::size_t>(stream.gcount());
    sum.add(std::string_view(bytes).substr(0, count));
    file.size += count;
  }
  if (!stream.eof()) throw std::runtime_error("cannot read " + path.string());
  file.checksum = sum.value();
  return file;
}

} // namespace

std::vector<SceneFile> scene_files(std::span<const fs::path> files) {
  std::vector<SceneFile> result;
  result.reserve(files.size());
  for (const fs::path& file : files)
    result.push_back(identified(file));
  return result;
}

bool is_planned(const StateInfo& info) {
  return std::ranges::any_of(info.settings, [](const auto& s) { return s.first == kPlanOption; });
}

std::string program_version() {
  return ABBE_VERSION;
}

std::uint32_t build_checksum() {
  try {
    return identified("/proc/self/exe").checksum;
  } catch (const std::runtime_error&) {
    return 0;
  }
}

} // namespace abbe
