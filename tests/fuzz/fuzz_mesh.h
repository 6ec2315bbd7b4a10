#pragma once

#include "io/meshes/read_mesh.h"
#include "tests/fuzz/fuzz_input.h"

#include <stdexcept>

namespace abbe {

/// Reads a mesh, cuts its polygons and mends it.
inline int try_mesh(const std::uint8_t* data, std::size_t size, const char* file,
                    MeshFormat format) {
  return try_input(file, [&] {
    try {
      (void)mesh_of(text_of(data, size), file, format, ignore_warning);
    } catch (const std::invalid_argument&) { // there is no surface in it
    }
  });
}

} // namespace abbe
