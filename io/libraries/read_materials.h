#pragma once

#include "core/scene/material.h"
#include "io/text/token.h"
#include "spectral/glass.h"
#include "spectral/metal.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace abbe {

/// One entry of a material library: a colour and the amounts that scale it.
struct LibraryMaterial {
  std::string name;
  SourcePosition where;                ///< of the name
  std::optional<Token> other_name;     ///< `alsoCalled`: a second entry with the same values
  Curve colour = Curve::constant(1.0); ///< `freqBreakdown`
  double ambient = 0.0;
  double diffuse = 0.0;
  double specular = 0.0;
  double emissive = 0.0;
  double specular_exponent = 1.0;
  double reflectivity = 0.0;
  double transparency = 0.0;
  bool fresnel = true;
  double speed_of_light = 1.0;   ///< used as refractive index, as the thesis does
  double v_number = 0.0;         ///< factor on quartz's dispersion, not an Abbe number
  const Glass* glass = nullptr;  ///< where set, it replaces the two above
  std::optional<Dispersion> law; ///< the same, for an index that is written out
  double dispersion_scale = 1.0; ///< about n_d
  const Metal* metal = nullptr;
  Curve absorption_per_mm = Curve::constant(0.0);
  std::vector<std::string> remarks; ///< what the reader warned of
};

/// The surface: each part is its amount times the colour, at most 1 but for emission; an amount of
/// 0 is the constant 0.
[[nodiscard]] Material finish(const LibraryMaterial& entry);

/// What fills a solid of this material, as far as its finish lets light in.
[[nodiscard]] Medium filling(const LibraryMaterial& entry);

/// Reads a material library (*.mtl). Throws ReadError.
[[nodiscard]] std::vector<LibraryMaterial> read_materials(const std::filesystem::path& file,
                                                          const Warn& warn);

/// The same from a text in memory; `file` is only for messages.
[[nodiscard]] std::vector<LibraryMaterial>
read_materials_text(std::string_view text, const std::string& file, const Warn& warn);

} // namespace abbe
