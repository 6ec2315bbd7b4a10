// A scene of glTF 2.0 is JSON: arrays of nodes, meshes, materials, cameras and others, which name
// each other by their numbers, and buffers of bytes with the numbers of meshes.
//
//   { "asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}],
//     "nodes": [{"mesh": 0, "translation": [0, 1, 0]}],
//     "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}], ... }

#include "io/gltf/read_gltf.h"

#include "io/building/check_reach.h"
#include "io/building/studio.h"
#include "io/files/regular_file.h"
#include "io/gltf/gltf_state.h"

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace abbe {
namespace {

using glm::dmat4;
using glm::dquat;
using glm::dvec3;

constexpr std::array<std::string_view, 2> kNodeExtensions{"KHR_lights_punctual",
                                                          "EXT_mesh_gpu_instancing"};
constexpr std::array<std::string_view, 1> kRootExtensions{"KHR_lights_punctual"};

dmat4 placed(const dvec3& translation, const dquat& rotation, const dvec3& scale) {
  const double length = glm::length(rotation);
  const dquat unit = length > 0.0 ? rotation / length : dquat(1.0, 0.0, 0.0, 0.0);
  return glm::translate(dmat4(1.0), translation) * glm::mat4_cast(unit) *
         glm::scale(dmat4(1.0), scale);
}

/// The node's place in the frame of its parent.
dmat4 local_matrix(const GltfValue& node) {
  if (node.find("matrix")) {
    const auto m = node.numbers<16>("matrix", {});
    dmat4 matrix;
    for (int i = 0; i < 16; ++i)
      matrix[i / 4][i % 4] = m[static_cast<std::size_t>(i)];
    return matrix;
  }
  const auto t = node.numbers<3>("translation", {0.0, 0.0, 0.0});
  const auto r = node.numbers<4>("rotation", {0.0, 0.0, 0.0, 1.0});
  const auto s = node.numbers<3>("scale", {1.0, 1.0, 1.0});
  return placed({t[0], t[1], t[2]}, dquat(r[3], r[0], r[1], r[2]), {s[0], s[1], s[2]});
}

/// The places of EXT_mesh_gpu_instancing in the frame of the node; one that changes nothing where
/// the node has none.
std::vector<dmat4> instances_of(GltfState& state, const GltfValue& node) {
  const auto extension = node.extension("EXT_mesh_gpu_instancing");
  if (!extension) return {dmat4(1.0)};
  const auto attributes = extension->find("attributes");
  std::size_t count = 0;
  const auto read = [&](std::string_view name, std::size_t components) {
    std::vector<double> numbers;
    const auto accessor =
        attributes ? attributes->index(name, state.document.all("accessors").size(), "accessors")
                   : std::nullopt;
    if (!accessor) return numbers;
    numbers = read_accessor(state, *attributes, *accessor, components);
    const std::size_t here = numbers.size() / components;
    if (count > 0 && here != count)
      throw ReadError(attributes->where(), "the instances have not the same number of each",
                      fmt::format("{} and {}", count, here), "Export it again");
    count = here;
    return numbers;
  };
  const auto t = read("TRANSLATION", 3), r = read("ROTATION", 4), s = read("SCALE", 3);
  std::vector<dmat4> places;
  for (std::size_t i = 0; i < count; ++i)
    places.push_back(placed(t.empty() ? dvec3(0.0) : dvec3(t[3 * i], t[3 * i + 1], t[3 * i + 2]),
                            r.empty() ? dquat(1.0, 0.0, 0.0, 0.0)
                                      : dquat(r[4 * i + 3], r[4 * i], r[4 * i + 1], r[4 * i + 2]),
                            s.empty() ? dvec3(1.0) : dvec3(s[3 * i], s[3 * i + 1], s[3 * i + 2])));
  return places;
}

void place_mesh(GltfState& state, const GltfValue& node, std::size_t mesh, const dmat4& to_world) {
  const std::string name =
      node.string("name", state.document.all("meshes")[mesh].string("name", ""));
  for (const dmat4& instance : instances_of(state, node)) {
    const dmat4 place = to_world * instance;
    for (const GltfPart& part : gltf_mesh(state, mesh)) {
      try {
        const Transform transform{glm::dmat3(place), dvec3(place[3])};
        state.builder.add_shape(part.where, {part.mesh, transform, {}, {}, 0}, part.material);
      } catch (const std::invalid_argument& fault) {
        // A node of the scale 0 is a common way to hide it.
        return refuse(state, node, "a node that has no extent", fault.what());
      }
      state.scene.object_names.resize(state.scene.shapes.size());
      state.scene.object_names.back() = name;
    }
  }
}

/// What a node is, but for its children.
void read_node(GltfState& state, const GltfValue& node, const dmat4& to_world) {
  refuse_extensions(state, node, kNodeExtensions);
  if (node.find("skin"))
    refuse(state, *node.find("skin"), "a skin", "the mesh is read as it rests");
  if (const auto mesh = node.index("mesh", state.document.all("meshes").size(), "meshes"))
    place_mesh(state, node, *mesh, to_world);
  if (const auto camera = node.index("camera", state.document.all("cameras").size(), "cameras"))
    read_gltf_camera(state, state.document.all("cameras")[*camera], to_world);
  if (const auto extension = node.extension("KHR_lights_punctual")) {
    const auto library = state.document.root().extension("KHR_lights_punctual");
    const std::vector<GltfValue> lights =
        library ? library->list("lights") : std::vector<GltfValue>{};
    if (const auto light = extension->index("light", lights.size(), "lights"))
      read_gltf_light(state, lights[*light], node.string("name", ""), to_world);
  }
}

/// All nodes of the scene, parents before their children and in the order of the file.
void read_nodes(GltfState& state, const GltfValue& scene) {
  const std::vector<GltfValue>& nodes = state.document.all("nodes");
  std::vector<bool> met(nodes.size(), false);
  struct Waiting {
    std::size_t node;
    dmat4 parent;
  };
  std::vector<Waiting> waiting;
  const auto add = [&](const std::vector<GltfValue>& children, const dmat4& parent) {
    for (auto child = children.rbegin(); child != children.rend(); ++child) {
      const std::size_t number = child->as_index(nodes.size(), "nodes");
      if (met[number])
        throw ReadError(child->where(), fmt::format("node {} has two parents", number),
                        "nodes make a tree", "Check the file with the glTF validator");
      met[number] = true;
      waiting.push_back({number, parent});
    }
  };
  add(scene.list("nodes"), dmat4(1.0));
  while (!waiting.empty()) {
    const Waiting next = waiting.back();
    waiting.pop_back();
    const GltfValue& node = nodes[next.node];
    const dmat4 to_world = next.parent * local_matrix(node);
    read_node(state, node, to_world);
    add(node.list("children"), to_world);
  }
}

/// Extensions without which the file is not what it means.
void check_required(GltfState& state) {
  constexpr std::array<std::string_view, 15> kRead{
      "KHR_lights_punctual",        "KHR_materials_transmission", "KHR_materials_volume",
      "KHR_materials_ior",          "KHR_materials_dispersion",   "KHR_materials_iridescence",
      "KHR_materials_clearcoat",    "KHR_materials_specular",     "KHR_materials_emissive_strength",
      "KHR_texture_transform",      "KHR_mesh_quantization",      "EXT_mesh_gpu_instancing",
      "KHR_draco_mesh_compression", // told, with the command that unpacks it, where a mesh has it
      "EXT_meshopt_compression",    "KHR_meshopt_compression"};
  for (const GltfValue& name : state.document.root().list("extensionsRequired")) {
    const std::string text = name.as_string();
    if (text == "KHR_texture_basisu")
      refuse(state, name, "KHR_texture_basisu",
             "npx @gltf-transform/cli ktxdecompress in.glb out.glb unpacks its pictures");
    else if (std::ranges::find(kRead, text) == kRead.end())
      refuse(state, name, fmt::format("the extension {}", text), "the file cannot do without it");
  }
}

bool has_light(const Scene& scene) {
  return !scene.lights.empty() ||
         std::ranges::any_of(scene.materials, [](const Material& m) { return !m.emission.zero(); });
}

Scene read(std::string_view bytes, const std::filesystem::path& file, const Warn& warn,
           InputFiles* files, Strictness strictness) {
  GltfState state(bytes, file);
  state.scene.title = file.stem().string();
  state.warn = warn ? warn : [](const std::string&) {};
  state.strictness = strictness;
  state.scene.mm_per_unit = 1000.0; // glTF measures in metres
  state.scene.settings.integrator = Integrator::path;
  state.scene.settings.width = 960;
  state.scene.settings.height = 720;
  check_required(state);
  refuse_extensions(state, state.document.root(), kRootExtensions);
  if (const auto animations = state.document.root().find("animations"))
    refuse(state, *animations, "an animation", "the scene is read as it rests");
  const std::vector<GltfValue>& scenes = state.document.all("scenes");
  const auto chosen = state.document.root().index("scene", scenes.size(), "scenes");
  if (scenes.empty())
    throw ReadError(state.document.root().where(), "the file has no scene",
                    "it holds parts of scenes alone", "Export a scene");
  read_nodes(state, scenes[chosen.value_or(0)]);
  if (!state.has_camera) fit_camera(state.scene);
  if (!has_light(state.scene)) add_studio_light(state.scene);
  state.builder.warn_of_the_whole(state.warn);
  if (files) files->insert(files->end(), state.files.begin(), state.files.end());
  return state.builder.take();
}

} // namespace

void refuse(GltfState& state, const GltfValue& where, const std::string& what,
            const std::string& why) {
  if (state.strictness == Strictness::strict)
    throw ReadError(where.where(), what + " is not understood", why,
                    "Change it, or give --lenient to go on without");
  std::string message =
      fmt::format("{}: {} is not understood ({})", to_string(where.where()), what, why);
  if (state.told.insert(message).second) state.warn(message);
}

void refuse_extensions(GltfState& state, const GltfValue& object,
                       std::span<const std::string_view> understood) {
  const auto extensions = object.find("extensions");
  if (!extensions) return;
  for (const std::string_view name : extensions->names())
    if (std::ranges::find(understood, name) == understood.end())
      refuse(state, *extensions->find(name), fmt::format("the extension {}", name),
             "it would change the picture, or tell of something else");
}

Scene read_gltf_bytes(std::string_view bytes, const std::filesystem::path& file, const Warn& warn,
                      Strictness strictness) {
  return read(bytes, file, warn, nullptr, strictness);
}

Scene read_gltf(const std::filesystem::path& file, const Warn& warn, InputFiles* files,
                Strictness strictness) {
  std::string bytes;
  try {
    bytes = read_regular_file(file);
  } catch (const std::runtime_error& fault) {
    throw ReadError(file, "the file cannot be read", fault.what(), "Give a .glb or .gltf file");
  }
  if (files) files->push_back(file);
  return read(bytes, file, warn, files, strictness);
}

} // namespace abbe
