#pragma once

#include "io/building/scene_builder.h"
#include "io/building/strictness.h"
#include "io/gltf/gltf_document.h"

#include <glm/mat4x4.hpp>

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace abbe {

/// A primitive of a mesh, in the mesh's own frame, which all nodes that show the mesh share.
struct GltfPart {
  SourcePosition where;
  Mesh mesh;
  ShapeMaterial material;
};

/// The scene as far as it is read.
struct GltfState {
  GltfState(std::string_view bytes, const std::filesystem::path& file) : document(bytes, file) {}

  GltfDocument document;
  SceneBuilder builder;
  Scene& scene = builder.scene();
  Warn warn;
  Strictness strictness = Strictness::strict;
  InputFiles files;

  std::map<std::size_t, std::vector<GltfPart>> meshes; ///< that have been read, by number
  /// Materials by number (none: the default one), for solids and for sheets.
  std::map<std::pair<std::optional<std::size_t>, bool>, ShapeMaterial> materials;
  std::set<std::string> told; ///< what has been refused already
  bool has_camera = false;
};

/// What is not understood: an error at its place, or with Strictness::lenient a warning, which is
/// given once.
void refuse(GltfState& state, const GltfValue& where, const std::string& what,
            const std::string& why);
/// The same for the extensions of an object that are not among those that are read.
void refuse_extensions(GltfState& state, const GltfValue& object,
                       std::span<const std::string_view> understood);

/// The numbers of an accessor, `components` for each element, as they are meant: normalized
/// integers lie from -1 or 0 to 1.
[[nodiscard]] std::vector<double> read_accessor(GltfState& state, const GltfValue& user,
                                                std::size_t accessor, std::size_t components);
/// The whole numbers of an accessor of scalars.
[[nodiscard]] std::vector<std::uint32_t> read_indices(GltfState& state, std::size_t accessor);

/// What the numbered material is on a mesh that is a solid, or on one that is not.
[[nodiscard]] const ShapeMaterial& gltf_material(GltfState& state, std::optional<std::size_t> index,
                                                 bool solid);
/// Whether a mesh of the material must be made a solid where it can be.
[[nodiscard]] bool fills_solid(GltfState& state, std::optional<std::size_t> index);
/// True where nothing of the material is seen.
[[nodiscard]] bool is_invisible(GltfState& state, std::optional<std::size_t> index);

/// The parts of the numbered mesh.
[[nodiscard]] const std::vector<GltfPart>& gltf_mesh(GltfState& state, std::size_t index);

void read_gltf_camera(GltfState& state, const GltfValue& camera, const glm::dmat4& to_world);
void read_gltf_light(GltfState& state, const GltfValue& light, const std::string& name,
                     const glm::dmat4& to_world);

} // namespace abbe
