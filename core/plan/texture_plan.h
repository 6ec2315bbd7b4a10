#pragma once

#include "core/bands/band_table.h"
#include "core/scene/texture.h"
#include "geometry/world/surface_coordinates.h"

#include <array>
#include <variant>

namespace abbe {

/// CheckerTexture at the bands.
struct CheckerPlan {
  double across = 1.0, up = 1.0;
  BandTable first, second;
};

/// GridTexture at the bands.
struct GridPlan {
  double across = 1.0, up = 1.0;
  double half_width = 0.05; ///< of a line, in fields
  BandTable lines, fields;
};

/// Reflectances at the bands for colours on a lattice in linear sRGB. Between them a reflectance is
/// the mean of the four corners of the tetrahedron that the colour lies in, by its barycentric
/// weights. A spectrum's colour is linear in it, so the mean has the wanted colour under D65 as
/// exactly as the corners have theirs [JH19], and it stays between 0 and 1.
class ReflectanceLattice {
public:
  /// Values at these wavelengths, one per band.
  explicit ReflectanceLattice(const std::vector<double>& nm);

  /// Fills `reflectance` for a colour with components from 0 to 1.
  void evaluate(const std::array<float, 3>& rgb, BandTable& reflectance) const;

private:
  static constexpr int kSteps = 8; ///< along each axis
  std::size_t bands_ = 0, stride_ = 0;
  std::vector<float> values_; ///< rows of `stride_`; red runs fastest
};

/// ImageTexture: the colour is linear between the centres of the texels; it is held from the
/// outermost ones to the image's border.
struct ImagePlan {
  std::size_t image = 0; ///< index into TexturePlans::images
};

using TexturePlan = std::variant<CheckerPlan, GridPlan, ImagePlan>;

/// All textures of a scene.
struct TexturePlans {
  std::vector<TexturePlan> textures;
  std::vector<ReflectanceImage> images;
  std::vector<ReflectanceLattice> lattice; ///< one where there are images, else none
};

/// Adds a texture; returns its index. The images are those of the scene.
[[nodiscard]] int plan_texture(TexturePlans& plans, const Texture& texture,
                               const std::vector<ReflectanceImage>& images,
                               const std::vector<double>& nm, bool keep_constant);

/// The image's colour at surface coordinates.
[[nodiscard]] std::array<float, 3> color_at(const ReflectanceImage& image, const dvec2& uv);

/// The texture's reflectance at surface coordinates: one of its tables, or `scratch`, filled.
[[nodiscard]] const BandTable& texture_at(const TexturePlans& plans, int texture, const dvec2& uv,
                                          BandTable& scratch);

} // namespace abbe
