#pragma once

#include "io/building/scene_builder.h"
#include "io/building/strictness.h"
#include "io/pbrt/pbrt_parameters.h"
#include "io/scene_language/input_files.h"
#include "spectral/curve.h"

#include <glm/mat4x4.hpp>

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace abbe {

/// A spectrum texture: a reflectance, or a pattern of them.
struct PbrtTexture {
  Curve value = Curve::constant(1.0); ///< where there is no pattern
  std::optional<Texture> pattern;
};

/// A medium that absorbs, in the scene's units.
struct PbrtMedium {
  Curve absorption = Curve::constant(0.0);
};

/// What a material is, as far as shapes must know.
struct PbrtMaterial {
  ShapeMaterial shape;
  bool nothing = false; ///< `interface`: the surface is not there
  bool fills = false;   ///< light gets inside, so that the shape must be a solid
};

/// What AttributeBegin keeps.
struct PbrtAttributes {
  glm::dmat4 transform{1.0};
  bool reversed = false; ///< ReverseOrientation
  std::shared_ptr<const PbrtMaterial> material;
  std::shared_ptr<const Curve> emission; ///< AreaLightSource; null: none
  bool two_sided = false;
  std::string inside, outside; ///< MediumInterface
  PbrtParameters shape_defaults, light_defaults, material_defaults;
};

/// A cap of a ball, which is glass and waits for the other one with the same rim.
struct PbrtCap {
  SourcePosition where;
  glm::dmat4 to_world; ///< of the unit ball that it is cut from
  glm::dvec3 rim_centre, apex;
  double rim_radius;
  ShapeMaterial material;
};

/// A shape of an object that instances repeat.
struct PbrtObjectShape {
  SourcePosition where;
  Shape shape;
  glm::dmat4 to_object;
  ShapeMaterial material;
};

/// The scene as far as it is read.
struct PbrtState {
  SceneBuilder builder;
  Scene& scene = builder.scene();
  Warn warn;
  Strictness strictness = Strictness::strict;
  InputFiles files;
  std::filesystem::path folder; ///< of the main file, from which all names of files are found

  bool in_world = false;
  glm::dmat4 to_ours{1.0}; ///< mirrors a world whose camera sees it mirrored
  glm::dmat4 camera{1.0};  ///< from the world to the camera
  double shorter_fov_deg = 90.0;
  PbrtAttributes now;
  struct Kept {
    PbrtAttributes attributes;
    SourcePosition where;
  };
  std::vector<Kept> kept;
  std::map<std::string, glm::dmat4, std::less<>> coordinate_systems;
  std::map<std::string, std::shared_ptr<const PbrtMaterial>, std::less<>> materials;
  std::map<std::string, PbrtTexture, std::less<>> textures;
  std::map<std::string, double, std::less<>> float_textures;
  std::map<std::string, PbrtMedium, std::less<>> media;
  std::map<std::string, std::vector<PbrtObjectShape>, std::less<>> objects;
  std::optional<std::string> open_object;
  std::vector<PbrtCap> caps;
};

/// What is not understood: an error at its place, or with Strictness::lenient a warning.
void refuse(const PbrtState& state, const SourcePosition& where, const std::string& what,
            const std::string& why);
/// The same for parameters that nobody has asked for.
void refuse_unused(const PbrtState& state, const PbrtParameters& parameters);

// Spectra. Those of lights are scaled so that Y = 1; see docs/decisions/pbrt.md.
/// A reflectance, or the texture that the parameter names.
[[nodiscard]] PbrtTexture read_reflectance(PbrtState& state, PbrtParameters& parameters,
                                           std::string_view name, double otherwise);
/// The reflectance that is nearest to a curve: no less than 0 and no more than 1 in any sample.
[[nodiscard]] Curve within_one(const Curve& curve);
[[nodiscard]] Curve read_light_spectrum(PbrtState& state, PbrtParameters& parameters,
                                        std::string_view name);
/// A spectrum as it stands, such as an index or an absorption; nothing where it is not given.
[[nodiscard]] std::optional<Curve> read_plain_spectrum(PbrtState& state, PbrtParameters& parameters,
                                                       std::string_view name);
/// The index of a glass: a number, a spectrum or a name.
[[nodiscard]] Dispersion read_index(PbrtState& state, PbrtParameters& parameters,
                                    std::string_view name, double otherwise);

/// What shapes are made of before a Material is given: diffuse, of reflectance 0.5.
[[nodiscard]] PbrtMaterial default_pbrt_material();

// Directives with their own files.
[[nodiscard]] PbrtMaterial read_pbrt_material(PbrtState& state, const SourcePosition& where,
                                              const std::string& type, PbrtParameters& parameters);
void read_pbrt_texture(PbrtState& state, const SourcePosition& where, PbrtParameters& parameters,
                       const std::vector<std::string>& words);
void read_pbrt_medium(PbrtState& state, const SourcePosition& where, const std::string& name,
                      PbrtParameters& parameters);
void read_pbrt_light(PbrtState& state, const SourcePosition& where, const std::string& type,
                     PbrtParameters& parameters);
void read_pbrt_area_light(PbrtState& state, const SourcePosition& where, const std::string& type,
                          PbrtParameters& parameters);
void read_pbrt_shape(PbrtState& state, const SourcePosition& where, const std::string& type,
                     PbrtParameters& parameters);
/// Joins caps of glass whose rims meet.
void join_caps(PbrtState& state);
/// Puts a shape into the scene, or into the object that is open.
void place_pbrt_shape(PbrtState& state, const SourcePosition& where, Shape shape,
                      const glm::dmat4& to_world, const ShapeMaterial& material);

} // namespace abbe
