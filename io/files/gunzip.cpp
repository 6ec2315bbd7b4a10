#include "io/files/gunzip.h"

#include "io/files/available_memory.h"

#include <zlib.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace abbe {
namespace {

/// A stream of zlib's, which ends with its scope.
struct Inflation {
  Inflation() {
    constexpr int kGzip = 16 + MAX_WBITS;
    if (::inflateInit2(&stream, kGzip) != Z_OK) throw std::runtime_error("zlib does not start");
  }
  Inflation(const Inflation&) = delete;
  Inflation& operator=(const Inflation&) = delete;
  ~Inflation() { ::inflateEnd(&stream); }

  z_stream stream{};
};

} // namespace

std::string gunzip(std::string_view packed) {
  constexpr std::size_t kPiece = std::size_t{1} << 20;
  const std::uint64_t most = available_memory() / 2; // the text is copied once as it grows
  Inflation inflation;
  z_stream& stream = inflation.stream;
  std::string text;
  std::size_t used = 0;
  while (used < packed.size()) {
    // zlib asks for pointers to bytes that it does not change.
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data() + used));
    const std::size_t in =
        std::min<std::size_t>(packed.size() - used, std::numeric_limits<uInt>::max());
    stream.avail_in = static_cast<uInt>(in);
    const std::size_t before = text.size();
    if (before + kPiece > most) throw std::runtime_error("it holds more than there is memory for");
    text.resize(before + kPiece);
    stream.next_out = reinterpret_cast<Bytef*>(text.data() + before);
    stream.avail_out = static_cast<uInt>(kPiece);
    const int result = ::inflate(&stream, Z_NO_FLUSH);
    text.resize(before + kPiece - stream.avail_out);
    used += in - stream.avail_in;
    if (result == Z_STREAM_END) {
      if (used == packed.size()) return text;
      ::inflateReset(&stream); // another member follows
    } else if (result != Z_OK) {
      throw std::runtime_error("what gzip has packed is damaged, or ends too early");
    }
  }
  // Everything is read; what is left comes out until nothing does.
  for (;;) {
    const std::size_t before = text.size();
    text.resize(before + kPiece);
    stream.next_out = reinterpret_cast<Bytef*>(text.data() + before);
    stream.avail_out = static_cast<uInt>(kPiece);
    const int result = ::inflate(&stream, Z_FINISH);
    text.resize(before + kPiece - stream.avail_out);
    if (result == Z_STREAM_END) return text;
    if (text.size() == before || text.size() > most)
      throw std::runtime_error("what gzip has packed is damaged, or ends too early");
  }
}

} // namespace abbe
