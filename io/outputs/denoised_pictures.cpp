#include "io/outputs/denoised_pictures.h"

#include "core/denoise/denoise_guide.h"
#include "core/image/develop.h"
#include "core/image/develop_colors.h"
#include "core/image/develop_layers.h"

#include <algorithm>
#include <utility>

namespace abbe {
namespace {

/// The channels of layers for the filter that are not among these.
std::vector<std::string> channels_without(const ExtraLayers& asked) {
  std::vector<std::string> channels = noise_channels(), left_out;
  for (std::string& name : feature_channels())
    channels.push_back(std::move(name));
  for (std::string& channel : channels) {
    std::string layer = channel.substr(0, channel.rfind('.'));
    std::ranges::replace(layer, '_', '.');
    if (std::ranges::none_of(extra_layer_names(), [&](const ExtraLayerName& row) {
          return row.name == layer && asked.has(row.layer);
        }))
      left_out.push_back(std::move(channel));
  }
  return left_out;
}

} // namespace

DenoisedPictures::DenoisedPictures(const Film& film, const Plan& plan, const ExtraLayers& asked)
    : film_(film), plan_(plan), left_out_(channels_without(asked)),
      denoiser_(guide_of(develop_scene_linear(film, plan))) {}

bool DenoisedPictures::leaves_out(const std::string& layer) const {
  return std::ranges::any_of(
      left_out_, [&](const std::string& channel) { return layer_of(channel) == layer; });
}

SceneLinearImage DenoisedPictures::scene_linear(SceneLinearSpace space, bool colors_only) const {
  SceneLinearImage image = develop_scene_linear(film_, plan_, space);
  if (colors_only) image.channels.clear();
  std::erase_if(image.channels, [&](const ImageChannel& channel) {
    return std::ranges::find(left_out_, channel.name) != left_out_.end();
  });
  return denoised(std::move(image), denoiser_);
}

DisplayImage DenoisedPictures::display(const DisplaySettings& settings) const {
  SceneLinearImage linear = scene_linear(SceneLinearSpace::rec709, true);
  std::vector<Xyz> colors;
  for (std::size_t i = 0; i < linear.rgba.size(); i += 4)
    colors.push_back(to_xyz(LinearRgb{linear.rgba[i], linear.rgba[i + 1], linear.rgba[i + 2]}));
  DisplayImage image =
      display_of(linear.display, linear.data, colors, settings, plan_.settings.observer);
  linear.metadata.insert(linear.metadata.end(), image.metadata.begin(), image.metadata.end());
  image.metadata = std::move(linear.metadata);
  return image;
}

SpectralImage DenoisedPictures::spectral(const PixelWindow& rows) const {
  const int top = film_.window().y0;
  const DenoiseWeights weights = denoiser_.weights({rows.y0 - top, rows.y1 - top});
  const DenoiseRows sources = weights.sources();
  return denoised(
      develop_spectral(film_, plan_, {rows.x0, top + sources.first, rows.x1, top + sources.last}),
      weights);
}

} // namespace abbe
