#include "io/building/material_energy.h"

#include "spectral/band_grid.h"

#include <algorithm>
#include <cmath>

namespace abbe {
namespace {

bool is_zero(const Curve& part) {
  return part.constant_value() == 0.0;
}

/// What Phong's highlight gives back of light at normal incidence, where that is most:
/// 1/pi cos^e(half angle) over the hemisphere.
double highlight_share(double exponent) {
  return 8.0 / (exponent + 2.0) * (1.0 - std::pow(2.0, -0.5 * (exponent + 2.0)));
}

/// The largest component of an image, if that is what the material has.
double most_of_image(const Material& material, std::span<const ReflectanceImage> images) {
  const auto* texture = material.texture ? std::get_if<ImageTexture>(&*material.texture) : nullptr;
  if (!texture) return 0.0;
  const std::vector<float>& rgb = images[texture->image].rgb;
  return rgb.empty() ? 0.0 : static_cast<double>(*std::ranges::max_element(rgb));
}

/// The largest reflectance of a texture at one wavelength.
struct MostOfTexture {
  double lambda_nm, image;

  double operator()(const CheckerTexture& checker) const {
    return std::max(checker.first.at(lambda_nm), checker.second.at(lambda_nm));
  }
  double operator()(const GridTexture& grid) const {
    return std::max(grid.lines.at(lambda_nm), grid.fields.at(lambda_nm));
  }
  double operator()(const ImageTexture&) const { return image; }
};

} // namespace

MaterialEnergy most_given_back(const Material& material, std::span<const ReflectanceImage> images) {
  MaterialEnergy found;
  const bool highlight = !is_zero(material.specular);
  const bool specular = !is_zero(material.reflectivity) || !is_zero(material.transparency);
  if (material.mixture) return found;
  // Each part alone is 1 at most: what is read is limited to that.
  if (!highlight && !(specular && (material.texture || !is_zero(material.diffuse)))) return found;
  const double image = most_of_image(material, images);
  const double per_highlight = highlight_share(material.specular_exponent);
  for (double nm = kLowerNm; nm <= kUpperNm; nm += kSampleStepNm) {
    MaterialEnergy here;
    here.at_nm = nm;
    here.diffuse = material.texture ? std::visit(MostOfTexture{nm, image}, *material.texture)
                                    : material.diffuse.at(nm);
    here.highlight = highlight ? per_highlight * material.specular.at(nm) : 0.0;
    const double mirrored = material.coat ? 0.0 : material.reflectivity.at(nm);
    const double through = material.transparency.at(nm);
    here.specular = material.fresnel ? std::max(mirrored, through) : mirrored + through;
    here.most = here.diffuse + here.highlight + here.specular;
    if (here.most > found.most) found = here;
  }
  return found;
}

double limit_shares(Material& material) {
  if (material.fresnel || is_zero(material.reflectivity) || is_zero(material.transparency))
    return 0.0;
  double most = 0.0;
  for (double nm = kLowerNm; nm <= kUpperNm; nm += kSampleStepNm)
    most = std::max(most, material.reflectivity.at(nm) + material.transparency.at(nm));
  if (most > 1.0) {
    material.reflectivity = material.reflectivity.scaled(1.0 / most);
    material.transparency = material.transparency.scaled(1.0 / most);
  }
  return most;
}

} // namespace abbe
