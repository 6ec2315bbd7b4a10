// Shapes of a scene, each with the material that it needs.

#include "core/scene/user_error.h"
#include "io/converting/scene_writer.h"
#include "io/meshes/write_ply.h"

#include <fmt/format.h>

#include <utility>

namespace abbe {

void SceneWriter::write_mesh(const Mesh& mesh) {
  // Copies share their triangles; whether they share their normals, too, their address tells.
  const void* key = mesh.corner_normals() ? static_cast<const void*>(mesh.corner_normals())
                                          : static_cast<const void*>(mesh.triangles().data());
  const auto [known, is_new] = meshes_.try_emplace(key);
  if (is_new) {
    known->second = name_of_file("mesh", meshes_.size(), "ply");
    write_ply(beside(known->second), mesh);
  }
  line(fmt::format("mesh \"{}\"", known->second));
}

void SceneWriter::write_tree(const CsgTree& tree) {
  std::vector<std::string> parts; // of operands whose operation comes later
  for (const CsgTree::Step& step : tree.steps()) {
    if (step.leaf >= 0) {
      const CsgLeaf& leaf = tree.leaves()[static_cast<std::size_t>(step.leaf)];
      if (leaf.material.valid()) throw UserError("operands with materials of their own");
      const std::string before = std::exchange(text_, "push\n");
      write_transform(leaf.to_tree);
      std::visit([&](const auto& solid) { write_plain_shape(solid); }, leaf.solid);
      line("pop");
      parts.push_back(std::exchange(text_, before));
      continue;
    }
    const std::string right = std::move(parts.back());
    parts.pop_back();
    const char* word = step.operation == CsgOperation::unite       ? "union"
                       : step.operation == CsgOperation::intersect ? "intersection"
                                                                   : "difference";
    parts.back() = fmt::format("{}\n{}{}", word, parts.back(), right);
  }
  text_ += parts.back();
}

void SceneWriter::write_plain_shape(const Shape& shape) {
  if (std::holds_alternative<Sphere>(shape)) return line("sphere");
  if (std::holds_alternative<Box>(shape)) return line("cube");
  if (std::holds_alternative<Square>(shape)) return line("square");
  if (std::holds_alternative<Disc>(shape)) return line("disc");
  if (std::holds_alternative<Plane>(shape)) return line("plane");
  if (const auto* cylinder = std::get_if<TaperedCylinder>(&shape))
    return line(fmt::format("taperedCylinder {}", cylinder->top_radius));
  if (const auto* mesh = std::get_if<Mesh>(&shape)) return write_mesh(*mesh);
  if (const auto* tree = std::get_if<CsgTree>(&shape)) return write_tree(*tree);
  throw UserError("polyhedra cannot be written yet");
}

void SceneWriter::write_shape(const PlacedShape& placed) {
  if (placed.priority != priority_) {
    priority_ = placed.priority;
    line(fmt::format("priority {}", priority_));
  }
  line("push");
  write_transform(placed.to_world);
  write_plain_shape(placed.shape);
  line("pop");
}

void SceneWriter::write_shapes() {
  for (std::size_t i = 0; i < scene_.shapes.size(); ++i) {
    const PlacedShape& placed = scene_.shapes[i];
    const std::pair wanted(placed.material, placed.medium);
    if (!has_current_ || wanted != current_) {
      current_ = wanted;
      has_current_ = true;
      write_material(placed.material, placed.medium);
    }
    const std::string object = i < scene_.object_names.size() ? scene_.object_names[i] : "";
    if (object != object_) {
      object_ = object;
      line(object.empty() ? "objectName none" : fmt::format("objectName \"{}\"", object));
    }
    write_shape(placed);
  }
}

} // namespace abbe
