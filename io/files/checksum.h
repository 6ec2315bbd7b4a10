#pragma once

#include <cstdint>
#include <string_view>

namespace abbe {

/// The CRC-32 of bytes that come one after the other: that of zip, gzip and PNG (ISO 3309). Any
/// burst of up to 32 changed bits gives another one.
class Checksum {
public:
  Checksum& add(std::string_view bytes);
  [[nodiscard]] std::uint32_t value() const { return value_; }

private:
  std::uint32_t value_ = 0;
};

} // namespace abbe
