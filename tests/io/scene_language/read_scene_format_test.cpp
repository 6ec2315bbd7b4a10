#include "tests/io/scene_language/read_scene_helpers.h"

#include "io/libraries/read_lens_prescription.h"
#include "io/scene_language/read_scene_state.h"
#include "tests/catch.h"

using namespace abbe;

namespace {

std::string manual() {
  return read_text_file(std::filesystem::path(ABBE_SOURCE_DIR) / "docs/scene_format.md");
}

} // namespace

TEST_CASE("docs/scene_format.md has every keyword with its arguments") {
  const std::string text = manual();
  for (const auto& table :
       {table_keywords(), setting_keywords(), camera_keywords(), camera_lens_keywords(),
        transform_keywords(), material_keywords(), surface_keywords(), drop_keywords(),
        texture_keywords(), mixture_keywords(), light_keywords(), shape_keywords(), name_keywords(),
        lens_keywords(), boolean_keywords(), macro_keywords()})
    for (const SceneKeyword& keyword : table) {
      INFO(keyword.usage);
      CHECK(text.find("- `" + std::string(keyword.usage) + "`:") != std::string::npos);
    }
}

TEST_CASE("docs/scene_format.md has every keyword of a lens file, and an example") {
  const std::string text = manual(), fence = "```";
  for (const std::string_view usage : lens_file_keywords()) {
    INFO(usage);
    CHECK(text.find("- `" + std::string(usage) + "`:") != std::string::npos);
  }
  const std::size_t begin = text.find(fence + "lens\n") + fence.size() + 5;
  const LensPrescription lens =
      read_lens_prescription_text(text.substr(begin, text.find(fence, begin) - begin), "l", {});
  CHECK(lens.surfaces.size() == 3);
}

TEST_CASE("the example of docs/scene_format.md can be read") {
  const std::string text = manual(), fence = "```";
  const std::size_t begin = text.find(fence + "sdl\n") + fence.size() + 4;
  const Scene scene = scene_of(text.substr(begin, text.find(fence, begin) - begin));
  CHECK(scene.shapes.size() == 2);
  CHECK(scene.lights.size() == 2);
  CHECK(scene.settings.width == 640);
}
