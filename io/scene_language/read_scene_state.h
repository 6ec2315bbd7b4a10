#pragma once

#include "core/scene/scene.h"
#include "io/building/light_units.h"
#include "io/building/scene_builder.h"
#include "io/building/setting_effects.h"
#include "io/meshes/read_mesh.h"
#include "io/scene_language/input_files.h"
#include "io/scene_language/read_scene_libraries.h"
#include "io/text/name_index.h"
#include "io/text/read_arguments.h"
#include "io/text/token.h"
#include "spectral/color.h"

#include <filesystem>
#include <optional>
#include <set>
#include <span>
#include <string_view>
#include <vector>

namespace abbe {

/// The current material, which the shapes that follow are made of.
using CurrentMaterial = ShapeMaterial;

/// What applies to the lights that follow.
struct CurrentLight {
  Falloff falloff = Falloff::none;
  LightStrength strength;
  double soft_edge_deg = 0.0;
  double sun_radius = SunLight().angular_radius;
  std::string group;   ///< "": by the light's name
  LightKeywords given; ///< the statements that it comes from
};

/// A transform that waits for its `pop`.
struct PushedTransform {
  Transform transform;
  SourcePosition where;
};

/// A boolean whose operands are being read. Its tree has the frame of the outermost boolean.
struct BooleanScope {
  std::string_view keyword;
  SourcePosition where;
  CurrentMaterial material;        ///< at the keyword; each operand begins with it
  MaterialId whole;                ///< the finish at the outermost boolean's keyword
  const Medium* filling = nullptr; ///< its filling; null: opaque
  std::size_t push_depth = 0;      ///< transforms pushed before the keyword
  int depth = 1;                   ///< 1 is the outermost
  std::vector<CsgTree> operands;
};

/// Statements by name; the last token is an `end`.
struct Macro {
  std::string name;
  SourcePosition where; ///< of its def
  std::vector<Token> body;
};

/// A number and the keyword that gave it.
struct GivenNumber {
  double value;
  SourcePosition where;
};

/// What is said of the camera's lens, and where; it comes together at the end of the scene.
struct CameraLensState {
  double aperture = 0.0; ///< in scene units; 0: a pinhole, or a real lens as open as it is
  std::optional<double> focus_distance, film_distance_mm, film_height_mm;
  std::optional<LensPrescription> prescription;
  bool coating = true;
  std::optional<GivenNumber> f_number, focal_length_mm;
  std::optional<SourcePosition> focus_at, film_height_at, film_distance_at, coating_at, lens_at;
};

/// The scene as far as it is read, and everything that is current.
struct SceneState {
  SceneBuilder builder;
  Scene& scene = builder.scene(); ///< for what stands for itself, such as the camera
  SceneLibraries libraries;
  MeshFiles meshes;
  std::set<const MendedMesh*> filled_meshes; ///< those of glass, which have been looked at once
  GivenKeywords given;                       ///< those of the whole scene that may have no effect
  InputFiles files;                          ///< all that have been read but the libraries
  Warn warn;

  Transform transform;
  std::vector<PushedTransform> pushed;
  CurrentMaterial material = default_material();
  int priority = 0;
  std::string object_name; ///< of the shapes that follow; "": they have none
  CurrentLight light;
  BooleanScope* boolean = nullptr; ///< the innermost one that is open

  NameIndex material_names; ///< the places in `named` of the materials that the scene has named
  std::vector<CurrentMaterial> named;
  NameIndex macro_names; ///< the same for `macros`
  std::vector<Macro> macros;
  std::vector<std::string> open_macros;          ///< being used, each by the one before it
  std::vector<std::filesystem::path> open_files; ///< being read, each included by the one before
  std::size_t expanded = 0; ///< words that macros and included files have brought so far

  std::optional<SourcePosition> camera_at; ///< of the last keyword that moves the camera
  std::optional<SourcePosition> crop_at;
  CameraLensState camera_lens;
};

/// A keyword of the scene language, one row of a table.
struct SceneKeyword {
  std::string_view usage; ///< the keyword and its arguments
  void (*read)(SceneState&, Arguments&);
  bool in_boolean = false; ///< may stand between a boolean's keyword and its operands
};

/// The keywords of the table of settings.
[[nodiscard]] std::span<const SceneKeyword> table_keywords();
[[nodiscard]] std::span<const SceneKeyword> setting_keywords();
[[nodiscard]] std::span<const SceneKeyword> camera_keywords();
[[nodiscard]] std::span<const SceneKeyword> camera_lens_keywords();
[[nodiscard]] std::span<const SceneKeyword> transform_keywords();
[[nodiscard]] std::span<const SceneKeyword> material_keywords();
[[nodiscard]] std::span<const SceneKeyword> texture_keywords();
[[nodiscard]] std::span<const SceneKeyword> mixture_keywords();
[[nodiscard]] std::span<const SceneKeyword> surface_keywords();
[[nodiscard]] std::span<const SceneKeyword> drop_keywords();
[[nodiscard]] std::span<const SceneKeyword> light_keywords();
[[nodiscard]] std::span<const SceneKeyword> shape_keywords();
[[nodiscard]] std::span<const SceneKeyword> name_keywords();
[[nodiscard]] std::span<const SceneKeyword> lens_keywords();
[[nodiscard]] std::span<const SceneKeyword> boolean_keywords();
[[nodiscard]] std::span<const SceneKeyword> macro_keywords();

/// True when the token can be a name that may be left out: neither a keyword nor a number, unless
/// it is quoted.
[[nodiscard]] bool name_follows(const Arguments& arguments);

/// Puts the camera's lens together from all that was said of it. Throws ReadError where that does
/// not fit together.
void finish_camera_lens(SceneState& state);

/// Reads one keyword with its arguments; for a boolean also its operands.
void read_statement(SceneState& state, TokenReader& reader);

/// The finish of the next operand, a solid: the current one; invalid when that is the whole's.
/// Warns where something else should fill it.
[[nodiscard]] MaterialId operand_finish(SceneState& state, const SourcePosition& where);

/// The tree, in the frame of the outermost boolean, becomes an operand of the open one.
void add_operand(SceneState& state, CsgTree tree);

/// Throws unless `next` may begin a statement inside the open boolean.
void check_operands(const SceneState& state, const Token& next);

/// Warns with the position in front of the message.
void warn_at(const SceneState& state, const SourcePosition& where, const std::string& message);

/// Three numbers, each 0 or more: linear sRGB.
[[nodiscard]] LinearRgb read_rgb(Arguments& arguments);

/// The same for a reflectance, whose components count as 1 where they are more, with a warning.
[[nodiscard]] LinearRgb read_fraction_rgb(SceneState& state, Arguments& arguments);

/// The material of this name that the scene has made, else the library's; `where` is for warnings.
/// Throws ReadError.
[[nodiscard]] CurrentMaterial named_material(SceneState& state, const SourcePosition& where,
                                             const Token& name);

/// Throws where the current material is a mixture, which has no finish to be changed.
void require_unmixed(const SceneState& state, const Arguments& arguments);

/// A glass of the catalogue or by its code, as the material that the keyword `glass` sets. Warns of
/// a glass that is extrapolated.
[[nodiscard]] CurrentMaterial read_clear_glass(SceneState& state, Arguments& arguments);

/// A refractive index: a number, or a glass of the catalogue or by its code.
[[nodiscard]] Dispersion read_index(SceneState& state, Arguments& arguments);

/// Reads what follows the keyword `polyhedron`.
[[nodiscard]] ConvexPolyhedron read_polyhedron(Arguments& arguments);

/// Three numbers or the name of a light with a factor that may be left out: light given off.
[[nodiscard]] Curve read_emission(SceneState& state, Arguments& arguments);

/// Adds a shape with a material and the current priority to the scene.
void place_shape(SceneState& state, const SourcePosition& where, Shape shape,
                 const Transform& to_world, const CurrentMaterial& material);

} // namespace abbe
