#include "io/states/info_bytes.h"

#include <stdexcept>
#include <string>

namespace abbe {

void require(bool holds, const char* what) {
  if (!holds) throw std::runtime_error(std::string(what) + " is out of its range");
}

void put_info(ValueWriter& out, const StateInfo& info) {
  out.put(info.version);
  out.put(info.build);
  out.put(info.scene.string());
  out.put(std::uint64_t{info.files.size()});
  for (const SceneFile& file : info.files) {
    out.put(file.path.string());
    out.put(file.size);
    out.put(file.checksum);
  }
  out.put(std::uint64_t{info.settings.size()});
  for (const auto& [option, value] : info.settings) {
    out.put(option);
    out.put(value);
  }
  out.put(std::int32_t{info.samples});
  out.put(std::int32_t{info.part.number});
  out.put(std::int32_t{info.part.count});
}

StateInfo get_info(ValueReader& in) {
  StateInfo info;
  info.version = in.text();
  info.build = in.get<std::uint32_t>();
  info.scene = in.text();
  info.files.resize(in.length(1));
  for (SceneFile& file : info.files) {
    file.path = in.text();
    file.size = in.get<std::uint64_t>();
    file.checksum = in.get<std::uint32_t>();
  }
  info.settings.resize(in.length(1));
  for (auto& [option, value] : info.settings) {
    option = in.text();
    value = in.text();
  }
  info.samples = in.get<std::int32_t>();
  info.part.number = in.get<std::int32_t>();
  info.part.count = in.get<std::int32_t>();
  require(info.samples > 0, "the number of samples");
  require(info.part.number >= 0 && info.part.number < info.part.count &&
              info.part.count <= info.samples,
          "the number of the part");
  return info;
}

} // namespace abbe
