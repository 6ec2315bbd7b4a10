#include "io/outputs/band_place.h"

#include <cstdlib>

namespace abbe {

BandPlace band_place(const std::filesystem::path& picture) {
  if (const char* folder = std::getenv("TMPDIR"); folder != nullptr && *folder != '\0')
    return {folder};
  return {picture.has_parent_path() ? picture.parent_path() : "."};
}

} // namespace abbe
