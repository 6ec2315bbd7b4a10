#include "io/gltf/gltf_document.h"

#include "io/files/regular_file.h"
#include "io/text/base64.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <stdexcept>

namespace abbe {
namespace {

constexpr std::uint32_t kMagic = 0x46546C67u; // "glTF"
constexpr std::uint32_t kJson = 0x4E4F534Au, kBinary = 0x004E4942u;

/// A number of four bytes, the lowest first; the caller has checked that they are there.
std::uint32_t number_at(std::string_view bytes, std::size_t place) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i)
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[place + i])) << (8 * i);
  return value;
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

std::string percent_decoded(std::string_view uri) {
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const bool code = uri[i] == '%' && i + 2 < uri.size() && hex_digit(uri[i + 1]) >= 0 &&
                      hex_digit(uri[i + 2]) >= 0;
    text += code ? static_cast<char>(16 * hex_digit(uri[i + 1]) + hex_digit(uri[i + 2])) : uri[i];
    if (code) i += 2;
  }
  return text;
}

} // namespace

GltfDocument::GltfDocument(std::string_view bytes, const std::filesystem::path& file)
    : name_(file.string()), folder_(file.parent_path()) {
  if (bytes.size() >= 4 && number_at(bytes, 0) == kMagic)
    read_chunks(bytes);
  else
    json_ = read_json(bytes, name_);
  const auto asset = root().find("asset");
  if (!asset)
    throw ReadError(root().where(), "this is no glTF", "it has no asset", "Check the file");
  if (const std::string version = asset->string("version", ""); !version.starts_with("2."))
    throw ReadError(asset->where(), fmt::format("glTF of version \"{}\" is not read", version),
                    "2.0 is", "Export it as glTF 2.0");
  buffers_.resize(all("buffers").size());
}

void GltfDocument::read_chunks(std::string_view bytes) {
  const auto fail = [&](std::size_t place, std::string_view what) {
    throw ReadError(SourcePosition{name_, 0, 0}, fmt::format("at byte {}, {}", place, what),
                    "a .glb is a header of 12 bytes, JSON, and the bytes of a buffer",
                    std::string(kGltfAdvice));
  };
  if (bytes.size() < 20) fail(bytes.size(), "the file ends within its header");
  if (number_at(bytes, 4) != 2) fail(4, "the version of the file is not 2");
  std::size_t place = 12;
  for (int chunk = 0; place + 8 <= bytes.size(); ++chunk) {
    const std::size_t length = number_at(bytes, place);
    const std::uint32_t type = number_at(bytes, place + 4);
    if (length > bytes.size() - place - 8) fail(place, "a chunk is longer than the file");
    const std::string_view content = bytes.substr(place + 8, length);
    if (chunk == 0 && type != kJson) fail(place + 4, "the first chunk is no JSON");
    if (chunk == 0) json_ = read_json(content, name_);
    if (chunk == 1 && type == kBinary) binary_ = content;
    place += 8 + length;
  }
}

const std::vector<GltfValue>& GltfDocument::all(std::string_view things) {
  const auto known = lists_.find(things);
  if (known != lists_.end()) return known->second;
  return lists_.emplace(things, root().list(things)).first->second;
}

std::filesystem::path GltfDocument::path_of(std::string_view uri) const {
  return folder_ / percent_decoded(uri);
}

std::optional<std::string> GltfDocument::data_of(const GltfValue& where, std::string_view uri) {
  if (!uri.starts_with("data:")) return std::nullopt;
  constexpr std::string_view kMark = ";base64,";
  const std::size_t mark = uri.find(kMark);
  auto bytes = mark == uri.npos ? std::nullopt : base64_decoded(uri.substr(mark + kMark.size()));
  if (!bytes)
    throw ReadError(where.where(), "the data in this URI cannot be read", "it is not base64",
                    std::string(kGltfAdvice));
  return bytes;
}

std::string_view GltfDocument::buffer(std::size_t index, InputFiles& files) {
  const GltfValue& value = all("buffers")[index];
  if (!value.find("uri")) {
    if (index == 0 && binary_) return *binary_;
    throw ReadError(value.where(), "the buffer has no bytes",
                    "it names no file, and is not the second chunk of a .glb", "Export it again");
  }
  if (!buffers_[index]) {
    const std::string uri = value.string("uri", "");
    buffers_[index] = data_of(*value.find("uri"), uri);
    if (!buffers_[index]) {
      const std::filesystem::path path = path_of(uri);
      files.push_back(path);
      try {
        buffers_[index] = read_regular_file(path);
      } catch (const std::runtime_error& fault) {
        throw ReadError(value.find("uri")->where(),
                        fmt::format("\"{}\" cannot be read", path.string()), fault.what(),
                        "A .gltf needs its .bin file beside it");
      }
    }
  }
  return *buffers_[index];
}

GltfBytes GltfDocument::buffer_view(const GltfValue& accessor, std::size_t index,
                                    InputFiles& files) {
  const GltfValue& view = all("bufferViews")[index];
  for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"})
    if (view.extension(name))
      throw ReadError(view.where(), fmt::format("the data is packed by {}", name),
                      "it is not unpacked here",
                      "npx @gltf-transform/cli copy in.glb out.glb unpacks it");
  const auto number = view.index("buffer", all("buffers").size(), "buffers");
  if (!number)
    throw ReadError(view.where(), "the bufferView names no buffer", "its bytes lie in one",
                    std::string(kGltfAdvice));
  const std::string_view bytes = buffer(*number, files);
  const std::size_t offset = view.whole("byteOffset").value_or(0);
  const std::size_t length = view.whole("byteLength").value_or(0);
  if (offset > bytes.size() || length > bytes.size() - offset)
    throw ReadError(view.where(), "the bufferView reaches beyond its buffer",
                    fmt::format("bytes {} to {} of {} are asked for by {}", offset, offset + length,
                                bytes.size(), accessor.pointer()),
                    std::string(kGltfAdvice));
  return {bytes.substr(offset, length), view.whole("byteStride").value_or(0)};
}

} // namespace abbe
