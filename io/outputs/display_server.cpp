#include "io/outputs/display_server.h"

#include "core/scene/user_error.h"
#include "io/text/numbers.h"

#include <fmt/format.h>

#include <netdb.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <memory>

namespace abbe {
namespace {

/// The kinds of packets that are sent. tev has more. [tev, "Over the Network"]
enum class Packet : std::uint8_t { create_image = 4, update_image = 6 };

template <class Whole>
void add_whole(std::string& packet, Whole value) {
  for (std::size_t byte = 0; byte < sizeof value; ++byte)
    packet += static_cast<char>(static_cast<std::uint64_t>(value) >> (8 * byte));
}

void add_text(std::string& packet, const std::string& text) {
  packet.append(text.c_str(), text.size() + 1); // with the 0 that ends it
}

/// A packet's beginning, for an image that shall not come before the one that the user looks at.
std::string begun(Packet kind, const std::string& image) {
  std::string packet;
  packet += static_cast<char>(kind);
  packet += '\0';
  add_text(packet, image);
  return packet;
}

void add_channels(std::string& packet, const SceneLinearImage& image) {
  add_whole(packet, static_cast<std::int32_t>(4 + image.channels.size()));
  for (const char* name : {"R", "G", "B", "A"})
    add_text(packet, name);
  for (const ImageChannel& channel : image.channels)
    add_text(packet, channel.name);
}

void add_floats(std::string& packet, const float* values, std::size_t count) {
  static_assert(std::endian::native == std::endian::little);
  packet.append(reinterpret_cast<const char*>(values), count * sizeof(float));
}

int connected(const std::string& host, const std::string& port) {
  addrinfo wanted{}, *found = nullptr;
  wanted.ai_socktype = SOCK_STREAM;
  if (::getaddrinfo(host.c_str(), port.c_str(), &wanted, &found) != 0) return -1;
  const std::unique_ptr<addrinfo, void (*)(addrinfo*)> all(found, ::freeaddrinfo);
  for (const addrinfo* one = found; one != nullptr; one = one->ai_next) {
    const int socket = ::socket(one->ai_family, one->ai_socktype | SOCK_CLOEXEC, one->ai_protocol);
    if (socket < 0) continue;
    // A viewer that hangs must not hold up the rendering for long.
    constexpr timeval kPatience{5, 0};
    ::setsockopt(socket, SOL_SOCKET, SO_SNDTIMEO, &kPatience, sizeof kPatience);
    if (::connect(socket, one->ai_addr, one->ai_addrlen) == 0) return socket;
    ::close(socket);
  }
  return -1;
}

} // namespace

DisplayServer::DisplayServer(const std::string& place, std::string image_name)
    : name_(std::move(image_name)) {
  const std::size_t colon = place.rfind(':');
  const auto port =
      colon == place.npos ? std::nullopt : parse_whole(std::string_view(place).substr(colon + 1));
  if (!port || *port < 1 || *port > 65535 || colon == 0)
    throw UserError(fmt::format("--display-server {}: give HOST:PORT, such as 127.0.0.1:14158, "
                                "where tev listens unless it is told otherwise",
                                place));
  socket_ = connected(place.substr(0, colon), place.substr(colon + 1));
  if (socket_ < 0)
    throw UserError(
        fmt::format("--display-server {}: nobody answers there. Start the viewer first", place));
}

DisplayServer::~DisplayServer() {
  if (socket_ >= 0) ::close(socket_);
}

bool DisplayServer::show(const SceneLinearImage& image) {
  if (!created_) create(image);
  created_ = true;
  constexpr int kRows = 64;
  const PixelWindow& data = image.data;
  for (int y = data.y0; y < data.y1 && socket_ >= 0; y += kRows)
    update(image, {data.x0, y, data.x1, std::min(y + kRows, data.y1)});
  return socket_ >= 0;
}

void DisplayServer::create(const SceneLinearImage& image) {
  std::string packet = begun(Packet::create_image, name_);
  add_whole(packet, static_cast<std::int32_t>(image.display.width()));
  add_whole(packet, static_cast<std::int32_t>(image.display.height()));
  add_channels(packet, image);
  send(std::move(packet));
}

void DisplayServer::update(const SceneLinearImage& image, const PixelWindow& rows) {
  std::string packet = begun(Packet::update_image, name_);
  add_channels(packet, image);
  for (const int value : {rows.x0, rows.y0, rows.width(), rows.height()})
    add_whole(packet, static_cast<std::int32_t>(value));
  // Where each channel's first value is among the floats, and how far it is to its next.
  const std::size_t pixels = rows.pixel_count(), layers = image.channels.size();
  for (std::size_t k = 0; k < 4; ++k)
    add_whole(packet, static_cast<std::int64_t>(k));
  for (std::size_t k = 0; k < layers; ++k)
    add_whole(packet, static_cast<std::int64_t>((4 + k) * pixels));
  for (std::size_t k = 0; k < 4 + layers; ++k)
    add_whole(packet, std::int64_t{k < 4 ? 4 : 1});
  const std::size_t first = image.data.index(rows.x0, rows.y0);
  add_floats(packet, image.rgba.data() + 4 * first, 4 * pixels);
  for (const ImageChannel& channel : image.channels)
    add_floats(packet, channel.values.data() + first, pixels);
  send(std::move(packet));
}

void DisplayServer::send(std::string packet) {
  std::string length;
  add_whole(length, static_cast<std::uint32_t>(packet.size() + 4)); // its own bytes included
  packet.insert(0, length);
  for (std::size_t sent = 0; sent < packet.size() && socket_ >= 0;) {
    const ssize_t count = ::send(socket_, packet.data() + sent, packet.size() - sent, MSG_NOSIGNAL);
    if (count > 0) {
      sent += static_cast<std::size_t>(count);
      continue;
    }
    ::close(socket_);
    socket_ = -1;
  }
}

} // namespace abbe
