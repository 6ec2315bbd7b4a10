#pragma once

#include "core/scene/scene.h"
#include "io/text/read_error.h"

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace abbe {

/// The text of a scene as far as it is written, and the files beside it, whose names begin as that
/// of the scene does.
class SceneWriter {
public:
  SceneWriter(const Scene& scene, std::filesystem::path file, Warn warn)
      : scene_(scene), file_(std::move(file)), warn_(std::move(warn)) {}

  /// Writes all of it. Throws UserError for what the scene language cannot say, and errors of
  /// files as `replace_file` does.
  void write();

private:
  void write_settings();
  void write_camera();
  void write_surroundings();
  void write_lights();
  void write_light(const Light& light);

  void write_shapes();
  void write_shape(const PlacedShape& placed);
  void write_tree(const CsgTree& tree);
  void write_plain_shape(const Shape& shape);
  void write_mesh(const Mesh& mesh);
  /// The statements of a transform, in the order in which they stand.
  void write_transform(const Transform& transform);

  /// What a material is before keywords of its surface change it.
  struct Base {
    double ambient = 0.0, diffuse = 0.0, reflectivity = 0.0, transparency = 0.0;
  };
  /// Makes a material the current one. Without a medium the solid lets nothing in.
  void write_material(MaterialId material, MediumId medium);
  /// Defines a material, for a mixture, and returns its name.
  std::string defined_material(MaterialId material, MediumId medium);
  Base write_body(const Material& finish, const Medium& medium);
  Base write_index(const Medium& medium, const Material& finish);
  void write_surface(const Material& finish, const Base& base);
  void write_absorption(const Curve& absorption);
  void write_color(std::string_view keyword, const Curve& color, double base);
  void write_share(std::string_view keyword, const Curve& share, double base);
  /// Defines materials of which the fields of a texture take their colours.
  void define_fields(const Texture& texture);
  void define_field(const Curve& reflectance);
  const std::string& field_name(const Curve& reflectance) const;
  void write_texture(const Texture& texture);

  /// The name of a spectrum and a factor on it.
  std::string spectrum(const Curve& curve);
  /// The name of a file of a reflectance.
  std::string color_file(const Curve& curve);
  /// The name of the file of an image of the scene, which is written once.
  const std::string& image_file(std::size_t image);
  std::string picture_file(int width, int height, const std::vector<float>& rgb);
  std::filesystem::path beside(const std::string& name) const;
  std::string name_of_file(std::string_view kind, std::size_t number,
                           std::string_view extension) const;
  void write_text(const std::filesystem::path& file, const std::string& text) const;
  void line(const std::string& statement);
  void warn_once(const std::string& message);

  const Scene& scene_;
  std::filesystem::path file_;
  Warn warn_;
  std::string text_;    ///< of the scene, behind what names the libraries
  std::string spectra_; ///< the light library
  std::vector<Curve> known_spectra_, known_colors_;
  std::vector<ConductorIndex> known_metals_;
  std::size_t pictures_ = 0;
  std::map<std::size_t, std::string> images_; ///< files of Scene::images, by their numbers
  std::map<const void*, std::string> meshes_; ///< by the triangles that copies share
  std::map<std::pair<std::int32_t, std::int32_t>, std::string> defined_;
  std::vector<std::pair<Curve, std::string>> fields_;
  std::vector<std::string> told_;
  int priority_ = 0;
  std::string object_;
  std::pair<MaterialId, MediumId> current_;
  bool has_current_ = false;
};

} // namespace abbe
