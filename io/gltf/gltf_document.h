#pragma once

#include "io/gltf/gltf_value.h"
#include "io/scene_language/input_files.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace abbe {

/// A part of a buffer, as a bufferView has it.
struct GltfBytes {
  std::string_view bytes;
  std::size_t stride = 0; ///< 0: elements follow each other
};

/// A glTF file: its JSON, and its buffers, which are read when they are first asked for.
class GltfDocument {
public:
  /// `bytes` is the content of a .gltf or .glb file, and outlives this. Throws ReadError.
  GltfDocument(std::string_view bytes, const std::filesystem::path& file);
  GltfDocument(const GltfDocument&) = delete;
  GltfDocument& operator=(const GltfDocument&) = delete;

  [[nodiscard]] GltfValue root() const { return {json_, name_, ""}; }
  /// The elements of one of the root's arrays, such as "meshes".
  [[nodiscard]] const std::vector<GltfValue>& all(std::string_view things);

  /// What a bufferView holds. Files that are read are added to `files`.
  [[nodiscard]] GltfBytes buffer_view(const GltfValue& accessor, std::size_t index,
                                      InputFiles& files);
  /// The path to which a relative URI leads, or nothing for a data URI.
  [[nodiscard]] std::filesystem::path path_of(std::string_view uri) const;
  /// The content of a data URI, which `where` holds; nothing for another one.
  [[nodiscard]] static std::optional<std::string> data_of(const GltfValue& where,
                                                          std::string_view uri);

private:
  void read_chunks(std::string_view bytes);
  std::string_view buffer(std::size_t index, InputFiles& files);

  std::string name_; ///< of the file, for messages
  std::filesystem::path folder_;
  JsonValue json_;
  std::optional<std::string_view> binary_; ///< the second chunk of a .glb
  std::vector<std::optional<std::string>> buffers_;
  std::map<std::string, std::vector<GltfValue>, std::less<>> lists_;
};

} // namespace abbe
