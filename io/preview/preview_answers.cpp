#include "io/preview/preview_answers.h"

#include "core/scene/user_error.h"
#include "io/pages/page_files.h"
#include "io/settings/setting_text.h"
#include "io/text/json.h"
#include "io/text/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string_view>

namespace abbe {
namespace {

/// Options that a page may set, under their names without dashes.
constexpr std::array<std::string_view, 4> kSettings{"size", "crop", "integrator", "spp"};

double number_of(const std::string& name, const std::string& text, double least, double most) {
  const auto number = parse_finite(text);
  if (!number || *number < least || *number > most)
    throw UserError(
        fmt::format("{}: \"{}\" is not a number from {} to {}", name, text, least, most));
  return *number;
}

void set(PreviewWishes& wishes, const std::string& option, const std::string& text) {
  if (text.empty()) {
    wishes.settings.erase(option);
    return;
  }
  RenderSettings tried;
  set_from_text(setting_of_option(option), text, tried); // throws for what it cannot be
  wishes.settings[option] = text;
}

void wish_one(PreviewWishes& wishes, const std::string& name, const std::string& text) {
  if (std::ranges::find(kSettings, name) != kSettings.end()) return set(wishes, "--" + name, text);
  if (name == "layer") {
    set(wishes, "--layers", text);
    wishes.layer = text;
    // In files a layer's name has no dot.
    std::ranges::replace(wishes.layer, '.', '_');
  } else if (name == "yaw") {
    wishes.orbit.x += number_of(name, text, -7.0, 7.0);
  } else if (name == "pitch") {
    wishes.orbit.y = std::clamp(wishes.orbit.y + number_of(name, text, -7.0, 7.0), -3.2, 3.2);
  } else if (name == "closer") {
    wishes.distance = std::clamp(wishes.distance * number_of(name, text, 0.01, 100.0), 1e-3, 1e3);
  } else if (name == "focus-x" || name == "focus-y") {
    if (!wishes.focus) wishes.focus.emplace(0.5);
    (name == "focus-x" ? wishes.focus->x : wishes.focus->y) = number_of(name, text, 0.0, 1.0);
  } else if (name == "aperture") {
    wishes.aperture.reset();
    if (!text.empty()) wishes.aperture = number_of(name, text, 0.0, 1e6);
  } else if (name == "scene-camera") {
    wishes.orbit = glm::dvec2(0.0);
    wishes.distance = 1.0;
    wishes.aperture.reset();
    wishes.forget_focus = true;
  } else {
    throw UserError(fmt::format("{}: this cannot be wished", name));
  }
}

void add_whole(std::string& bytes, int value) {
  for (unsigned shift = 0; shift < 32; shift += 8)
    bytes += static_cast<char>(static_cast<std::uint32_t>(value) >> shift);
}

} // namespace

std::string preview_page() {
  std::string page(page_file("preview.html"));
  const auto put = [&page](std::string_view mark, std::initializer_list<const char*> files) {
    std::string text;
    for (const char* file : files)
      text += page_file(file);
    page.replace(page.find(mark), mark.size(), text);
  };
  put("/*style*/", {"page.css", "preview.css"});
  put("/*script*/", {"color.js", "screen.js", "preview.js"});
  return page;
}

std::string status_json(const PreviewBoard::News& news) {
  const PreviewReport& r = news.report;
  return fmt::format(
      "{{\"version\": {}, \"picture\": {}, \"title\": {}, \"error\": {}, \"warnings\": {}, "
      "\"camera\": {}, \"state\": {}, \"fraction\": {}, \"seconds\": {}, \"left\": {}, "
      "\"samples\": {}, \"noise\": {}, \"raysPerSecond\": {}, \"firstPicture\": {}, "
      "\"renderings\": {}, \"width\": {}, \"height\": {}}}",
      news.version, news.picture ? news.picture->number : 0, json_string(r.title),
      json_string(r.error), json_string(r.warnings), json_string(r.camera), json_string(r.state),
      json_number(r.fraction), json_number(r.seconds), json_number(r.seconds_left),
      json_number(r.samples), json_number(r.noise.value_or(std::nan(""))),
      json_number(r.rays_per_second), json_number(r.first_picture_seconds), r.renderings, r.width,
      r.height);
}

std::string picture_bytes(const PreviewPicture& picture) {
  std::string bytes;
  bytes.reserve(32 + 4 * picture.values.size());
  for (const int value : {picture.number, picture.frame.x1, picture.frame.y1, picture.part.x0,
                          picture.part.y0, picture.part.x1, picture.part.y1, picture.channels})
    add_whole(bytes, value);
  static_assert(std::endian::native == std::endian::little);
  bytes.append(reinterpret_cast<const char*>(picture.values.data()),
               picture.values.size() * sizeof(float));
  return bytes;
}

void wish_by_names(PreviewBoard& board, const std::map<std::string, std::string>& values) {
  board.wish([&](PreviewWishes& wishes) {
    PreviewWishes changed = wishes;
    for (const auto& [name, text] : values)
      wish_one(changed, name, text);
    wishes = changed;
  });
}

} // namespace abbe
