#include "io/files/deflate.h"

#include <zlib.h>

#include <stdexcept>

namespace abbe {

std::string deflated(std::string_view bytes) {
  uLongf size = ::compressBound(bytes.size());
  std::string packed(size, '\0');
  constexpr int kLevel = 4; // half the time of the usual 6, and hardly larger
  if (::compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
                  reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), kLevel) != Z_OK)
    throw std::runtime_error("zlib has no memory to compress with");
  packed.resize(size);
  return packed;
}

} // namespace abbe
