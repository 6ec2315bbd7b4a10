#include "io/outputs/display_server.h"

#include "core/scene/user_error.h"
#include "tests/catch.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstring>
#include <future>
#include <map>
#include <optional>

using namespace abbe;

namespace {

/// An image as a viewer has it: by channel, row by row.
struct ViewedImage {
  int width = 0, height = 0;
  std::map<std::string, std::vector<float>> channels;
};

/// A packet, taken apart from its beginning.
class Reader {
public:
  explicit Reader(std::string packet) : packet_(std::move(packet)) {}

  template <class Value>
  Value take() {
    Value value;
    REQUIRE(at_ + sizeof value <= packet_.size());
    std::memcpy(&value, packet_.data() + at_, sizeof value);
    at_ += sizeof value;
    return value;
  }
  std::string text() {
    const std::string text = packet_.c_str() + at_;
    at_ += text.size() + 1;
    return text;
  }
  [[nodiscard]] std::size_t left() const { return packet_.size() - at_; }

private:
  std::string packet_;
  std::size_t at_ = 0;
};

/// A viewer by the public description of tev's protocol ("Over the Network", and what its Ipc.cpp
/// says of each packet).
class Viewer {
public:
  Viewer() : listening_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    REQUIRE(::bind(listening_, reinterpret_cast<sockaddr*>(&address), size) == 0);
    REQUIRE(::listen(listening_, 1) == 0);
    ::getsockname(listening_, reinterpret_cast<sockaddr*>(&address), &size);
    place = "127.0.0.1:" + std::to_string(ntohs(address.sin_port));
  }
  ~Viewer() { ::close(listening_); }
  Viewer(const Viewer&) = delete;
  Viewer& operator=(const Viewer&) = delete;

  /// All images that one client sends before it goes.
  std::map<std::string, ViewedImage> receive() {
    const int client = ::accept(listening_, nullptr, nullptr);
    std::map<std::string, ViewedImage> images;
    for (std::uint32_t length = 0; read(client, reinterpret_cast<char*>(&length), 4);) {
      REQUIRE(length > 4);
      std::string packet(length - 4, '\0');
      REQUIRE(read(client, packet.data(), packet.size()));
      apply(Reader(packet), images);
    }
    ::close(client);
    return images;
  }

  std::string place;

private:
  static bool read(int from, char* to, std::size_t count) {
    while (count > 0) {
      const ssize_t got = ::recv(from, to, count, 0);
      if (got <= 0) return false;
      to += got;
      count -= static_cast<std::size_t>(got);
    }
    return true;
  }
  static void apply(Reader packet, std::map<std::string, ViewedImage>& images) {
    const int type = packet.take<std::uint8_t>();
    packet.take<std::uint8_t>(); // whether it shall come to the front
    ViewedImage& image = images[packet.text()];
    if (type == 4) { // CreateImage
      image.width = packet.take<std::int32_t>();
      image.height = packet.take<std::int32_t>();
      for (int left = packet.take<std::int32_t>(); left > 0; --left)
        image.channels[packet.text()].resize(static_cast<std::size_t>(image.width * image.height));
      CHECK(packet.left() == 0);
      return;
    }
    REQUIRE(type == 6); // UpdateImage, its third version
    std::vector<std::string> names(static_cast<std::size_t>(packet.take<std::int32_t>()));
    for (std::string& name : names)
      name = packet.text();
    const int x = packet.take<std::int32_t>(), y = packet.take<std::int32_t>();
    const int width = packet.take<std::int32_t>(), height = packet.take<std::int32_t>();
    std::vector<std::int64_t> offsets(names.size()), strides(names.size());
    for (auto* list : {&offsets, &strides})
      for (std::int64_t& value : *list)
        value = packet.take<std::int64_t>();
    std::vector<float> values(packet.left() / sizeof(float));
    for (float& value : values)
      value = packet.take<float>();
    for (std::size_t c = 0; c < names.size(); ++c)
      for (int i = 0; i < width * height; ++i)
        image.channels.at(names[c]).at(
            static_cast<std::size_t>((y + i / width) * image.width + x + i % width)) =
            values.at(static_cast<std::size_t>(offsets[c] + strides[c] * i));
  }
  int listening_;
};

/// A part of a frame, with values that tell where they belong.
SceneLinearImage picture() {
  SceneLinearImage image{{0, 0, 5, 100}, {1, 2, 4, 90}, {}, {}};
  ImageChannel depth{"depth.Z", {}};
  for_each_pixel(image.data, [&](int x, int y) {
    const float at = static_cast<float>(x) + 10.0F * static_cast<float>(y);
    image.rgba.insert(image.rgba.end(), {at, at + 0.25F, at + 0.5F, 1.0F});
    depth.values.push_back(-at);
  });
  image.channels.push_back(depth);
  return image;
}

} // namespace

TEST_CASE("a viewer gets the picture and its layers by tev's protocol") {
  Viewer viewer;
  auto received = std::async(std::launch::async, [&] { return viewer.receive(); });
  {
    DisplayServer server(viewer.place, "a.exr");
    SceneLinearImage black = picture();
    for (float& value : black.rgba)
      value = 0.0F;
    CHECK(server.show(black));
    CHECK(server.show(picture())); // as it has grown
  }
  const auto images = received.get();
  REQUIRE(images.size() == 1);
  const ViewedImage& image = images.at("a.exr");
  CHECK(image.width == 5);
  CHECK(image.height == 100);
  REQUIRE(image.channels.size() == 5);
  for_each_pixel({0, 0, 5, 100}, [&](int x, int y) {
    const auto i = static_cast<std::size_t>(5 * y + x);
    const bool inside = x >= 1 && x < 4 && y >= 2 && y < 90;
    const float at = static_cast<float>(x + 10 * y);
    REQUIRE(image.channels.at("R")[i] == (inside ? at : 0.0F));
    REQUIRE(image.channels.at("B")[i] == (inside ? at + 0.5F : 0.0F));
    REQUIRE(image.channels.at("A")[i] == (inside ? 1.0F : 0.0F));
    REQUIRE(image.channels.at("depth.Z")[i] == (inside ? -at : 0.0F));
  });
}

TEST_CASE("a viewer that goes away is no error") {
  std::optional<Viewer> viewer(std::in_place);
  DisplayServer server(viewer->place, "a.exr");
  viewer.reset(); // the system ends the connection, which nobody has taken
  bool there = true;
  for (int i = 0; i < 1000 && there; ++i)
    there = server.show(picture());
  CHECK_FALSE(there);
  CHECK_FALSE(server.show(picture()));
}

TEST_CASE("what is no place of a viewer is refused") {
  CHECK_THROWS_AS(DisplayServer("localhost", "a"), UserError);
  CHECK_THROWS_AS(DisplayServer(":14158", "a"), UserError);
  CHECK_THROWS_AS(DisplayServer("localhost:0", "a"), UserError);
  CHECK_THROWS_AS(DisplayServer("localhost:elephant", "a"), UserError);
  CHECK_THROWS_AS(DisplayServer("127.0.0.1:1", "a"), UserError); // nobody listens there
}
