#pragma once

#include "core/scene/scene.h"
#include "io/building/keyword_effects.h"
#include "io/building/opaque_solids.h"
#include "io/building/shape_material.h"
#include "io/text/read_error.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

namespace abbe {

/// Puts a scene together from plain values, for readers of any format. It keeps equal materials,
/// media and images once, and refuses what does not go together. `where` is the place in the file
/// that the reader reads; ReadError and warnings begin with it.
class SceneBuilder {
public:
  explicit SceneBuilder(std::string title = "") { scene_.title = std::move(title); }

  /// The scene as it is. A reader sets here what stands for itself: camera, settings, unit,
  /// background and environment.
  [[nodiscard]] Scene& scene() { return scene_; }

  /// The id of the finish that a shape of this material has, which is that of an equal one before.
  MaterialId add_material(const SourcePosition& where, const ShapeMaterial& material);
  /// The same for what fills a solid. Throws ReadError as `check_medium` does.
  MediumId add_medium(const SourcePosition& where, const Medium& medium);

  /// Adds a shape where it is, made of `material`; the ids of `shape` are filled in. Throws
  /// ReadError for a material that does not fit.
  void add_shape(const SourcePosition& where, PlacedShape shape, const ShapeMaterial& material);

  /// Adds a light, to which the noted statements apply.
  void add_light(Light light, const LightKeywords& given = {});

  /// The number of the image that this file holds, which `read` reads unless it is there.
  std::size_t add_image(const std::filesystem::path& file,
                        const std::function<ReflectanceImage()>& read);

  /// Two materials in one surface, of which the first has this share. Throws ReadError when they
  /// would fill a solid differently.
  [[nodiscard]] ShapeMaterial mix(const SourcePosition& where, const ShapeMaterial& first,
                                  const ShapeMaterial& second, double share);

  /// Warns once of a glass whose formula was not fitted for all wavelengths of a picture.
  void warn_of_extrapolation(const SourcePosition& where, const Glass& glass, const Warn& warn);

  /// Warns of keywords without effect, of materials that give back more light than they get, and of
  /// opaque solids between the camera and lights.
  void warn_of_the_whole(const Warn& warn) const;

  /// What keywords have acted on.
  [[nodiscard]] KeywordLedger& keywords() { return keywords_; }

  /// Hands out the scene, after which the builder has none.
  [[nodiscard]] Scene take() { return std::move(scene_); }

private:
  /// The numbers of the values of one vector, by their fingerprints.
  struct KnownValues {
    std::unordered_multimap<std::size_t, std::int32_t> numbers;
    std::int32_t last = -1; ///< asked for most recently, and mostly asked for again
  };
  /// Lowers shares that add up to more than 1, and notes other finishes whose parts do.
  MaterialId add_finish(const SourcePosition& where, Material finish);
  void note_energy(const SourcePosition& where, const Material& finish, double shares);
  template <class Value, class Check>
  static std::int32_t number_of(KnownValues& known, std::vector<Value>& values, const Value& value,
                                const Check& check);

  Scene scene_;
  KeywordLedger keywords_;
  OpaqueSolids opaque_solids_;
  std::vector<std::string> energy_warnings_;
  KnownValues materials_, media_;
  std::map<std::filesystem::path, std::size_t> images_;
  std::set<const Glass*> warned_glasses_;
};

/// Throws ReadError when the camera looks nowhere, or up does not tell which way is up.
void check_view(const SourcePosition& where, const Camera& camera);

/// Throws ReadError when the crop is not a part of the picture.
void check_crop(const SourcePosition& where, const RenderSettings& settings);

} // namespace abbe
