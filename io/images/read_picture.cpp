#include "io/images/read_picture.h"

#include "core/scene/user_error.h"
#include "io/images/read_exr.h"
#include "io/images/read_image.h"
#include "io/images/read_in_child.h"
#include "io/images/read_tiff.h"
#include "io/text/numbers.h"
#include "spectral/data_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <exception>
#include <iterator>
#include <utility>

namespace abbe {
namespace {

namespace fs = std::filesystem;

/// One row of the table of readers.
struct InputFormat {
  std::string_view extension;
  PictureValues (*read)(const fs::path&, const PictureRequest&);
};

constexpr InputFormat kInputFormats[] = {
    {".exr", read_exr_picture},
    {".png", read_png_picture},
    {".tif", read_tiff_picture},
    {".tiff", read_tiff_picture},
};

/// Texts and numbers one after the other, each with its length before it.
class Packer {
public:
  void add(std::string_view text) { packed_ += fmt::format("{} {}", text.size(), text); }
  void add(const PixelWindow& w) {
    add(fmt::format("{}", w.x0));
    add(fmt::format("{}", w.y0));
    add(fmt::format("{}", w.x1));
    add(fmt::format("{}", w.y1));
  }
  void add(const Matrix4& matrix) {
    for (const auto& row : matrix)
      for (const double value : row)
        add(fmt::format("{}", value)); // the shortest text that is read as the same number
  }
  [[nodiscard]] std::string packed() && { return std::move(packed_); }

private:
  std::string packed_;
};

/// Takes out again what a Packer has put in. It comes from a process of our own.
class Unpacker {
public:
  explicit Unpacker(std::string_view packed) : rest_(packed) {}

  std::string text() {
    const std::size_t space = rest_.find(' ');
    const auto size = static_cast<std::size_t>(parse_whole(rest_.substr(0, space)).value());
    std::string text(rest_.substr(space + 1, size));
    rest_.remove_prefix(space + 1 + size);
    return text;
  }
  int whole() { return static_cast<int>(parse_whole(text()).value()); }
  PixelWindow window() {
    PixelWindow w;
    for (int* const edge : {&w.x0, &w.y0, &w.x1, &w.y1})
      *edge = whole();
    return w;
  }

  Matrix4 matrix() {
    Matrix4 matrix;
    for (auto& row : matrix)
      for (double& value : row)
        value = parse_finite(text()).value();
    return matrix;
  }

private:
  std::string_view rest_;
};

/// The matrices of the camera that are known.
std::vector<const Matrix4*> matrices_of(const PictureHeader& header) {
  std::vector<const Matrix4*> matrices;
  if (header.camera) matrices.push_back(&header.camera->world_to_camera);
  if (header.camera && header.camera->world_to_image)
    matrices.push_back(&*header.camera->world_to_image);
  return matrices;
}

ChildMessage packed(PictureValues picture) {
  const PictureHeader& header = picture.header;
  Packer packer;
  packer.add(fmt::format("{}", matrices_of(header).size()));
  packer.add(header.format);
  packer.add(header.display);
  packer.add(header.data);
  packer.add(picture.part);
  packer.add(header.has_color ? "1" : "0");
  packer.add(header.unknown_tag);
  packer.add(fmt::format("{}", header.channels.size()));
  for (const PictureChannel& channel : header.channels) {
    packer.add(channel.name);
    packer.add(channel.type);
  }
  packer.add(fmt::format("{}", header.wavelengths_nm.size()));
  for (const double nm : header.wavelengths_nm)
    packer.add(fmt::format("{}", nm)); // the shortest text that is read as the same number
  packer.add(fmt::format("{}", header.metadata.size()));
  for (const auto& [name, value] : header.metadata) {
    packer.add(name);
    packer.add(value);
  }
  for (const Matrix4* matrix : matrices_of(header))
    packer.add(*matrix);
  packer.add(fmt::format("{}", picture.rgb.size()));
  packer.add(fmt::format("{}", picture.alpha.size()));
  packer.add(fmt::format("{}", picture.layers.size()));
  ChildMessage message{std::move(packer).packed(), std::move(picture.rgb)};
  for (const auto* values : {&picture.alpha, &picture.layers, &picture.bands})
    message.values.insert(message.values.end(), values->begin(), values->end());
  return message;
}

PictureValues unpacked(ChildMessage message) {
  Unpacker unpacker(message.text);
  PictureValues picture;
  PictureHeader& header = picture.header;
  const int matrices = unpacker.whole();
  header.format = unpacker.text();
  header.display = unpacker.window();
  header.data = unpacker.window();
  picture.part = unpacker.window();
  header.has_color = unpacker.whole() != 0;
  header.unknown_tag = unpacker.text();
  header.channels.resize(static_cast<std::size_t>(unpacker.whole()));
  for (PictureChannel& channel : header.channels) {
    channel.name = unpacker.text();
    channel.type = unpacker.text();
  }
  header.wavelengths_nm.resize(static_cast<std::size_t>(unpacker.whole()));
  for (double& nm : header.wavelengths_nm)
    nm = parse_finite(unpacker.text()).value();
  header.metadata.resize(static_cast<std::size_t>(unpacker.whole()));
  for (auto& [name, value] : header.metadata) {
    name = unpacker.text();
    value = unpacker.text();
  }
  if (matrices > 0) header.camera.emplace().world_to_camera = unpacker.matrix();
  if (matrices > 1) header.camera->world_to_image = unpacker.matrix();
  const auto colors = static_cast<std::ptrdiff_t>(parse_whole(unpacker.text()).value());
  const auto alphas = static_cast<std::ptrdiff_t>(parse_whole(unpacker.text()).value());
  const auto layers = static_cast<std::ptrdiff_t>(parse_whole(unpacker.text()).value());
  const auto alpha = message.values.begin() + colors, layer = alpha + alphas;
  picture.alpha.assign(alpha, layer);
  picture.layers.assign(layer, layer + layers);
  picture.bands.assign(layer + layers, message.values.end());
  message.values.resize(static_cast<std::size_t>(colors));
  picture.rgb = std::move(message.values);
  return picture;
}

/// Null for a name of no picture.
const InputFormat* find_input_format(const fs::path& file) {
  for (const InputFormat& format : kInputFormats)
    if (same_name(format.extension, file.extension().string())) return &format;
  return nullptr;
}

const InputFormat& format_of(const fs::path& file) {
  if (const InputFormat* format = find_input_format(file)) return *format;
  throw UserError(fmt::format("{}: no picture is read under this name. It should end in .exr, "
                              ".tif, .tiff or .png",
                              file.string()));
}

} // namespace

bool is_picture_name(const fs::path& file) {
  return find_input_format(file) != nullptr;
}

PictureValues read_picture(const fs::path& file, const PictureRequest& request) {
  const InputFormat& format = format_of(file);
  std::error_code error;
  if (!fs::exists(file, error)) throw UserError(fmt::format("there is no file {}", file.string()));
  try {
    return unpacked(message_of_child([&] { return packed(format.read(file, request)); }));
  } catch (const std::exception& fault) {
    throw UserError(fmt::format("{} cannot be read: {}", file.string(), fault.what()));
  }
}

PictureHeader read_picture_header(const fs::path& file) {
  return read_picture(file, {.header_only = true}).header;
}

void read_picture_blocks(const fs::path& file, const PictureRequest& request,
                         const std::function<void(const PictureValues& block)>& use) {
  const PictureHeader header = read_picture_header(file);
  const PixelWindow data = rows_of(header.data, request);
  // 64 MiB, and whole blocks of rows that are packed together.
  constexpr std::size_t kBlockValues = std::size_t{1} << 24;
  const std::size_t row_values = static_cast<std::size_t>(data.width()) *
                                 (4 + (request.bands ? header.wavelengths_nm.size() : 0));
  const int rows =
      static_cast<int>(std::clamp<std::size_t>(kBlockValues / row_values / 32 * 32, 32, 65536));
  for (int y = data.y0; y < data.y1;) {
    const int end = data.y1 - y > rows ? y + rows : data.y1;
    PictureRequest block = request;
    block.rows = RowRange{y, end};
    use(read_picture(file, block));
    y = end;
  }
}

} // namespace abbe
