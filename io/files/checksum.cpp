#include "io/files/checksum.h"

#include <zlib.h>

namespace abbe {

Checksum& Checksum::add(std::string_view bytes) {
  // zlib returns the checksum of no bytes for a null pointer, whatever came before.
  if (bytes.empty()) return *this;
  value_ = static_cast<std::uint32_t>(
      ::crc32_z(value_, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()));
  return *this;
}

} // namespace abbe
