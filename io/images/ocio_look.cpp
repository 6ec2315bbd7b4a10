#include "io/images/ocio_look.h"

#include "core/image/display.h"
#include "core/scene/user_error.h"

#ifdef ABBE_HAS_OCIO
#include <OpenColorIO/OpenColorIO.h>
#endif
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace abbe {

#ifdef ABBE_HAS_OCIO

namespace {

namespace ocio = OCIO_NAMESPACE;

/// Names under which configurations have one of our spaces. The role is defined as ACES2065-1, so
/// it comes first; then names of linear Rec. 709 in the configurations of ACES, of Blender and of
/// the Color Interop Forum, and ACES's own.
constexpr auto kInputs = std::to_array<std::pair<const char*, SceneLinearSpace>>({
    {"aces_interchange", SceneLinearSpace::aces2065_1},
    {"lin_rec709_scene", SceneLinearSpace::rec709},
    {"Linear Rec.709 (sRGB)", SceneLinearSpace::rec709},
    {"Linear Rec.709", SceneLinearSpace::rec709},
    {"lin_rec709", SceneLinearSpace::rec709},
    {"Linear", SceneLinearSpace::rec709},
    {"ACES2065-1", SceneLinearSpace::aces2065_1},
    {"ACEScg", SceneLinearSpace::acescg},
});

[[noreturn]] void refuse(const OcioLook& look, const std::string& why) {
  throw UserError(fmt::format("{}: {}", look.config.string(), why));
}

/// The one that is asked for, which must be one of the names, or the first.
std::string chosen(const OcioLook& look, const std::string& asked, const char* what,
                   const std::vector<std::string>& names) {
  if (names.empty()) refuse(look, fmt::format("the configuration has no {}", what));
  if (asked.empty()) return names.front();
  if (std::ranges::find(names, asked) == names.end())
    refuse(look, fmt::format("the configuration has no {} \"{}\"; it has: {}", what, asked,
                             fmt::join(names, ", ")));
  return asked;
}

} // namespace

struct OcioTransform::Processor {
  SceneLinearSpace space = SceneLinearSpace::rec709;
  ocio::ConstCPUProcessorRcPtr cpu;

  explicit Processor(const OcioLook& look) {
    ocio::SetLoggingLevel(ocio::LOGGING_LEVEL_NONE);
    try {
      make(look);
    } catch (const ocio::Exception& error) {
      refuse(look, error.what());
    }
  }

  void make(const OcioLook& look) {
    const ocio::ConstConfigRcPtr config = ocio::Config::CreateFromFile(look.config.c_str());
    const auto input = std::ranges::find_if(kInputs, [&](const auto& candidate) {
      return config->getColorSpace(candidate.first) != nullptr;
    });
    if (input == kInputs.end())
      refuse(look, "the configuration tells neither the role aces_interchange nor a space such as "
                   "lin_rec709_scene, so what our colours are in it is not known");
    space = input->second;
    std::vector<std::string> displays, views;
    for (int i = 0; i < config->getNumDisplays(); ++i)
      displays.emplace_back(config->getDisplay(i));
    const std::string display = chosen(look, look.display, "display", displays);
    for (int i = 0; i < config->getNumViews(display.c_str()); ++i)
      views.emplace_back(config->getView(display.c_str(), i));
    const std::string view = chosen(look, look.view, "view", views);
    const auto transform = ocio::DisplayViewTransform::Create();
    transform->setSrc(input->first);
    transform->setDisplay(display.c_str());
    transform->setView(view.c_str());
    cpu = config->getProcessor(transform)->getDefaultCPUProcessor();
  }
};

bool has_ocio() {
  return true;
}

void OcioTransform::apply(std::vector<float>& rgb) const {
  if (rgb.empty()) return;
  ocio::PackedImageDesc pixels(rgb.data(), static_cast<long>(rgb.size() / 3), 1, 3);
  processor_->cpu->apply(pixels);
}

#else

struct OcioTransform::Processor {
  SceneLinearSpace space = SceneLinearSpace::rec709;

  explicit Processor(const OcioLook&) {
    throw UserError("this build has no OpenColorIO. Install it (Debian: libopencolorio-dev) and "
                    "build again");
  }
};

bool has_ocio() {
  return false;
}

void OcioTransform::apply(std::vector<float>&) const {}

#endif

OcioTransform::OcioTransform(const OcioLook& look)
    : processor_(std::make_unique<Processor>(look)) {}
OcioTransform::OcioTransform(OcioTransform&&) noexcept = default;
OcioTransform& OcioTransform::operator=(OcioTransform&&) noexcept = default;
OcioTransform::~OcioTransform() = default;

SceneLinearSpace OcioTransform::space() const {
  return processor_->space;
}

DisplayImage ocio_picture(const OcioTransform& transform, const SceneLinearImage& image,
                          const DisplaySettings& settings) {
  DisplayImage picture{image.display, image.data, {}, {}, image.metadata, encoding_of(settings)};
  const auto gain = static_cast<float>(std::exp2(settings.exposure_ev));
  picture.encoded.reserve(image.rgba.size() / 4 * 3);
  for (std::size_t i = 0; i < image.rgba.size(); ++i)
    if (i % 4 != 3) picture.encoded.push_back(gain * image.rgba[i]);
  transform.apply(picture.encoded);
  picture.linear.reserve(picture.encoded.size());
  for (const float code : picture.encoded)
    picture.linear.push_back(
        static_cast<float>(decode(picture.encoding.transfer, static_cast<double>(code))));
  return picture;
}

} // namespace abbe
