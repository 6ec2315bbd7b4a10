#pragma once

#include "core/cameras/lens_system.h"
#include "io/libraries/read_lens_prescription.h"

#include <filesystem>
#include <string>

namespace abbe::test {

/// One of the lenses of scenes/lenses/.
inline LensPrescription lens_file(const std::string& name) {
  return read_lens_prescription(
      std::filesystem::path(ABBE_SOURCE_DIR) / "scenes/lenses" / (name + ".lens"), {});
}

} // namespace abbe::test
