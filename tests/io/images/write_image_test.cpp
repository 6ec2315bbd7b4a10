#include "io/images/write_image.h"

#include "tests/catch.h"
#include "tests/io/libraries/spectral_rows.h"
#include "tests/io/temporary_folder.h"

#include <csignal>
#include <cstdint>
#include <fstream>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <string>
#include <sys/resource.h>
#include <utility>

using namespace abbe;
namespace fs = std::filesystem;
using test::content;
using test::Folder;

namespace {

/// A full disk, as far as this process can tell: no file may grow beyond `bytes`.
class FileSizeLimit {
public:
  explicit FileSizeLimit(rlim_t bytes) {
    ::getrlimit(RLIMIT_FSIZE, &old_);
    const rlimit limit{bytes, old_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &old_);
    std::signal(SIGXFSZ, handler_);
  }

private:
  rlimit old_{};
  void (*handler_)(int) = std::signal(SIGXFSZ, SIG_IGN);
};

/// Grey noise (a linear congruential generator), which no compression makes small.
std::vector<float> noise(std::size_t count) {
  std::vector<float> values(count);
  std::uint32_t state = 1;
  for (float& value : values) {
    state = 1664525u * state + 1013904223u;
    value = static_cast<float>(state >> 8) / 16777216.0f;
  }
  return values;
}

const PixelWindow window{0, 0, 64, 48}, pixel{0, 0, 1, 1};
const SceneLinearImage scene_linear{window, window, noise(64 * 48 * 4), {}};
const DisplayImage display{window, window, noise(64 * 48 * 3), noise(64 * 48 * 3), {}};
const SpectralImage spectral{window, window, {400.0, 500.0}, noise(64 * 48 * 2), noise(64 * 48 * 4),
                             {}};

} // namespace

TEST_CASE("an image that half floats cannot hold is written as floats, and told") {
  const Folder folder;
  SceneLinearImage bright{pixel, pixel, {1.0f, 1.0f, 65520.0f, 1.0f}, {}};
  const fs::path path = folder.path / "a.exr";
  CHECK(write_image(path, bright, {}, {}) ==
        path.string() +
            ": written with 32 bits a channel, since values are beyond the range of half "
            "floats (65504)");
  CHECK(write_image(path, bright, {}, {.exr_pixel = ExrPixel::single}).empty());
  bright.rgba[2] = 65504.0f;
  CHECK(write_image(path, bright, {}, {}).empty());
}

TEST_CASE("the extension names the format, whatever its case") {
  const Folder folder;
  // First bytes of the files: OpenEXR's magic number 20000630, TIFF's "II" 42, PNG's signature.
  const std::string exr = "\x76\x2f\x31\x01", tiff("II*\0", 4), png = "\x89PNG";
  const std::pair<const char*, std::string> cases[] = {
      {"a.exr", exr},   {"b.EXR", exr}, {"c.tif", tiff},    {"d.TIFF", tiff},
      {"e.Tiff", tiff}, {"f.png", png}, {"g.1.2.png", png}, {"h.png.exr", exr}};
  for (const auto& [name, magic] : cases) {
    const fs::path path = folder.path / name;
    CHECK(is_known_image_extension(path));
    write_image(path, scene_linear, display, {});
    CHECK(content(path).substr(0, magic.size()) == magic);
  }
}

TEST_CASE("an unknown extension is an error that lists the known ones") {
  const Folder folder;
  CHECK_FALSE(is_known_image_extension("picture.jpg"));
  CHECK_FALSE(is_known_image_extension("picture"));
  CHECK_FALSE(is_known_image_extension("exr"));
  CHECK_FALSE(is_known_image_extension(".exr")); // a hidden file without extension
  CHECK_FALSE(is_known_image_extension("picture.exr2"));
  CHECK(known_image_extensions() == ".exr, .tif, .tiff or .png");
  const fs::path path = folder.path / "picture.jpg";
  CHECK_THROWS_WITH(write_image(path, scene_linear, display, {}),
                    "cannot write " + path.string() +
                        ": unknown image extension \".jpg\" (.exr, .tif, .tiff or .png would be "
                        "right)");
  CHECK(folder.file_count() == 0);
}

TEST_CASE("the options reach their writers") {
  const Folder folder;
  const auto size_of = [&](const char* name, const OutputOptions& options) {
    write_image(folder.path / name, scene_linear, display, options);
    return fs::file_size(folder.path / name);
  };
  const OutputOptions small, large{ExrPixel::single, TiffDepth::float32, 16};
  CHECK(size_of("b.exr", large) > size_of("a.exr", small) + 64 * 48 * 4);
  CHECK(size_of("b.tif", large) > size_of("a.tif", small) + 64 * 48 * 3);
  CHECK(size_of("b.png", large) > size_of("a.png", small) + 64 * 48 * 2);
}

TEST_CASE("on a full disk every writer fails, keeps the old image and leaves nothing behind") {
  const auto write_picture = [](const fs::path& path) {
    write_image(path, scene_linear, display, {});
  };
  // So small that a buffer holds all of it until the file is closed.
  const auto write_one_pixel = [](const fs::path& path) {
    write_image(path, {pixel, pixel, noise(4), {}}, {pixel, pixel, noise(3), noise(3), {}}, {});
  };
  const auto write_cube = [](const fs::path& path) {
    test::write_whole_spectral_exr(path, spectral);
  };
  const std::pair<const char*, std::function<void(const fs::path&)>> cases[] = {
      {"picture.exr", write_picture}, {"picture.tif", write_picture},
      {"picture.png", write_picture}, {"pixel.exr", write_one_pixel},
      {"pixel.tif", write_one_pixel}, {"pixel.png", write_one_pixel},
      {"cube.exr", write_cube}};
  for (const auto& [name, write] : cases) {
    const Folder folder;
    const fs::path path = folder.path / name;
    write(path);
    const std::string old = content(path);
    // In the header, among the pixels, and at the very last byte.
    for (const std::size_t limit :
         {std::size_t{0}, old.size() / 20, old.size() / 2, old.size() * 19 / 20, old.size() - 1}) {
      std::string message = "no error";
      try {
        const FileSizeLimit full(limit);
        write(path);
      } catch (const std::runtime_error& error) {
        message = error.what();
      }
      INFO(name << " with " << limit << " bytes: " << message);
      CHECK(message.starts_with("cannot write " + path.string() + ": "));
      CHECK(message.size() > path.string().size() + 20);
      CHECK(message.find(".tmp-") == std::string::npos);
      CHECK(content(path) == old);
      CHECK(folder.file_count() == 1);
    }
    write(path);
    CHECK(content(path) == old);
  }
}

TEST_CASE("images without pixels are errors, not crashes") {
  const Folder folder;
  for (const PixelWindow& empty : {PixelWindow{0, 0, 0, 0}, PixelWindow{5, 5, 5, 9},
                                   PixelWindow{5, 5, 9, 5}, PixelWindow{9, 9, 5, 5}})
    for (const auto& [whole, part] :
         {std::pair(window, empty), std::pair(empty, empty), std::pair(empty, window)})
      for (const char* name : {"a.exr", "a.tif", "a.png"}) {
        const fs::path path = folder.path / name;
        CHECK_THROWS_WITH(write_image(path, {whole, part, {}, {}}, {whole, part, {}, {}, {}}, {}),
                          "cannot write " + path.string() + ": the image has no pixels");
      }
  CHECK(folder.file_count() == 0);
}
