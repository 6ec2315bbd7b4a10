#pragma once

#include "core/image/image.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace abbe {

/// A look by a configuration of OpenColorIO: that of a view on a display.
struct OcioLook {
  std::filesystem::path config;
  std::string display = {}; ///< empty: the configuration's first
  std::string view = {};    ///< empty: the display's first
};

/// True where this build has OpenColorIO.
[[nodiscard]] bool has_ocio();

/// Takes scene-linear colours to a display as a configuration says.
class OcioTransform {
public:
  /// Throws UserError where the build has no OpenColorIO, where the configuration cannot be read,
  /// or has no such display or view.
  explicit OcioTransform(const OcioLook& look);
  OcioTransform(OcioTransform&&) noexcept;
  OcioTransform& operator=(OcioTransform&&) noexcept;
  ~OcioTransform();

  /// The space of the colours that it takes.
  [[nodiscard]] SceneLinearSpace space() const;
  /// Takes interleaved red, green and blue to the display's codes, as fractions of full scale.
  void apply(std::vector<float>& rgb) const;

private:
  struct Processor;
  std::unique_ptr<Processor> processor_;
};

/// The picture for a screen. TIFFs of 32 bits have the light of the codes. `encoding` is that of
/// the display, which the configuration does not tell in a form that files can hold.
[[nodiscard]] DisplayImage ocio_picture(const OcioTransform& transform,
                                        const SceneLinearImage& image,
                                        const DisplaySettings& settings);

} // namespace abbe
