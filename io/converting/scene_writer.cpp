// What a scene is as a whole: settings, camera, lights and surroundings.

#include "io/converting/scene_writer.h"

#include "core/scene/setting_table.h"
#include "core/scene/user_error.h"
#include "io/files/atomic_file.h"
#include "io/images/write_exr.h"
#include "spectral/band_grid.h"
#include "spectral/illuminant.h"
#include "spectral/observer.h"

#include <fmt/format.h>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <numbers>
#include <stdexcept>

namespace abbe {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

std::string point(const dvec3& p) {
  return fmt::format("{} {} {}", p.x, p.y, p.z);
}

} // namespace

void SceneWriter::line(const std::string& statement) {
  text_ += statement;
  text_ += '\n';
}

void SceneWriter::warn_once(const std::string& message) {
  if (std::ranges::find(told_, message) != told_.end()) return;
  told_.push_back(message);
  warn_(message);
}

std::string SceneWriter::name_of_file(std::string_view kind, std::size_t number,
                                      std::string_view extension) const {
  return fmt::format("{}-{}-{}.{}", file_.stem().string(), kind, number, extension);
}

std::filesystem::path SceneWriter::beside(const std::string& name) const {
  return file_.parent_path() / name;
}

void SceneWriter::write_text(const std::filesystem::path& file, const std::string& text) const {
  replace_file(file, [&](const std::filesystem::path& temporary) {
    std::ofstream out(temporary, std::ios::binary);
    out << text;
    out.close();
    if (!out) throw std::runtime_error("not all of it could be written");
  });
}

std::string SceneWriter::spectrum(const Curve& curve) {
  if (!curve.spectral_lines().empty())
    throw UserError("a light of single lines cannot be written (light libraries have none)");
  const double y = to_xyz(curve).y;
  for (const std::string_view name : {"D65", "E"}) { // those that other programs' scenes have
    const Curve scaled = find_illuminant(name)->scaled(y);
    bool same = true;
    for (int k = 0; k < kSampleCount; ++k)
      same = same && std::abs(scaled.at(sample_nm(k)) - curve.at(sample_nm(k))) <= 1e-12 * y;
    if (same) return fmt::format("{} {}", name, y);
  }
  auto known = std::ranges::find(known_spectra_, curve);
  if (known == known_spectra_.end()) {
    known = known_spectra_.insert(known_spectra_.end(), curve);
    const Curve samples = curve.sampled81();
    spectra_ += fmt::format("filter spectrum{}\n{{\n  colour 81", known_spectra_.size());
    for (int k = 0; k < kSampleCount; ++k)
      spectra_ += fmt::format(" {}", samples.at(sample_nm(k)));
    spectra_ += "\n}\nendfilter\n";
  }
  return fmt::format("spectrum{} 1", known - known_spectra_.begin() + 1);
}

std::string SceneWriter::color_file(const Curve& curve) {
  auto known = std::ranges::find(known_colors_, curve);
  const auto number = static_cast<std::size_t>(known - known_colors_.begin() + 1);
  const std::string name = name_of_file("colour", number, "csv");
  if (known != known_colors_.end()) return name;
  known_colors_.push_back(curve);
  // Steps, since a reader takes means over 5 nm: they are then the samples.
  const Curve samples = curve.sampled81();
  std::string rows = "nm,reflectance\n";
  for (int k = 0; k < kSampleCount; ++k)
    for (const double side : {-1.0, 1.0})
      rows += fmt::format("{:.7f},{}\n", sample_nm(k) + side * (2.5 - 1e-6),
                          std::clamp(samples.at(sample_nm(k)), 0.0, 1.0));
  write_text(beside(name), rows);
  return name;
}

std::string SceneWriter::picture_file(int width, int height, const std::vector<float>& rgb) {
  const std::string name = name_of_file("picture", ++pictures_, "exr");
  SceneLinearImage image;
  image.display = image.data = PixelWindow{0, 0, width, height};
  for (std::size_t i = 0; i + 2 < rgb.size(); i += 3) {
    image.rgba.insert(image.rgba.end(), &rgb[i], &rgb[i] + 3);
    image.rgba.push_back(1.0f);
  }
  (void)write_exr(beside(name), image, ExrPixel::single);
  return name;
}

void SceneWriter::write_settings() {
  const auto unit = [&] {
    constexpr std::array<std::pair<double, std::string_view>, 5> kUnits{
        {{1.0, "mm"}, {10.0, "cm"}, {1000.0, "m"}, {25.4, "in"}, {0.001, "um"}}};
    for (const auto& [mm, name] : kUnits)
      if (mm == scene_.mm_per_unit) return name;
    throw UserError("the scene's unit of length has no name");
  };
  line(fmt::format("unit {}", unit()));
  const RenderSettings& settings = scene_.settings;
  line(fmt::format("imageSize {} {}", settings.width, settings.height));
  if (const auto& crop = settings.crop)
    line(fmt::format("crop {} {} {} {}", crop->x0, crop->y0, crop->x1, crop->y1));
  for (const RenderSetting& row : render_setting_table()) {
    if (row.keyword.empty() || row.keyword == "imageSize" || row.keyword == "crop") continue;
    const std::string value = value_text(row, settings);
    if (value != value_text(row, RenderSettings{})) line(fmt::format("{} {}", row.keyword, value));
  }
  for (const DisplaySetting& row : display_setting_table()) {
    const std::string value = value_text(row, scene_.display);
    if (!row.keyword.empty() && value != value_text(row, DisplaySettings{}))
      line(fmt::format("{} {}", row.keyword, value));
  }
}

void SceneWriter::write_camera() {
  const Camera& camera = scene_.camera;
  line("eye " + point(camera.eye));
  line("lookAt " + point(camera.look_at));
  line("up " + point(camera.up));
  line(fmt::format("fieldOfView {}", camera.field_of_view_deg));
  if (const auto* lens = std::get_if<ThinLens>(&camera.kind)) {
    line(fmt::format("aperture {}", lens->aperture));
    if (lens->focus_distance)
      line(std::isinf(*lens->focus_distance)
               ? std::string("focusDistance inf")
               : fmt::format("focusDistance {}", *lens->focus_distance));
  } else if (!std::holds_alternative<Pinhole>(camera.kind)) {
    throw UserError("the camera's lens cannot be written");
  }
}

void SceneWriter::write_surroundings() {
  if (!scene_.background.zero()) line("background " + spectrum(scene_.background));
  if (!scene_.global_ambient.zero()) line("globalAmbient " + spectrum(scene_.global_ambient));
  if (!scene_.environment) return;
  const Environment& around = *scene_.environment;
  line("push");
  write_transform(Transform(around.to_world, dvec3(0.0)));
  const std::string file = picture_file(around.width, around.height, around.rgb);
  std::string light;
  if (!around.has_colors) {
    light = spectrum(around.light); // its factor belongs to the picture
    const auto space = light.find(' ');
    const double factor = std::stod(light.substr(space + 1));
    light = fmt::format(" {} {}", light.substr(0, space), factor * around.factor);
  } else {
    light = fmt::format(" {}", around.factor);
  }
  line(fmt::format("environment {}{}", file, light));
  line("pop");
}

void SceneWriter::write_light(const Light& light) {
  const std::string named = spectrum(light.spectrum);
  const auto space = named.find(' ');
  const std::string name = named.substr(0, space);
  const auto falloff = [&](Falloff f) {
    line(f == Falloff::square ? "falloff square" : "falloff none");
  };
  line("intensity " + named.substr(space + 1));
  if (!light.group.empty()) line(fmt::format("lightGroup \"{}\"", light.group));
  if (const auto* lamp = std::get_if<PointLight>(&light.kind)) {
    falloff(lamp->falloff);
    line(fmt::format("light {} {} 1", name, point(lamp->position)));
  } else if (const auto* sky = std::get_if<DirectionalLight>(&light.kind)) {
    line(fmt::format("light {} {} 0", name, point(-sky->direction)));
  } else if (const auto* spot = std::get_if<SpotLight>(&light.kind)) {
    falloff(spot->falloff);
    line(fmt::format("softEdge {}", (spot->half_angle - spot->full_angle) * kDegrees));
    line(fmt::format("spotlight {} {} 1 {} {}", name, point(spot->position), point(spot->axis),
                     spot->half_angle * kDegrees));
  } else if (const auto* sun = std::get_if<SunLight>(&light.kind)) {
    line(fmt::format("sunRadius {}", sun->angular_radius * kDegrees));
    line(fmt::format("sun {} {}", point(-sun->direction), name));
  }
  if (!light.group.empty()) line("lightGroup none");
}

void SceneWriter::write_lights() {
  for (const Light& light : scene_.lights)
    write_light(light);
}

/// Axis and angle of two turns, and factors along the axes between them.
void SceneWriter::write_transform(const Transform& transform) {
  const dvec3 offset = transform.offset();
  if (offset != dvec3(0.0)) line("translate " + point(offset));
  const glm::dmat3& m = transform.linear();
  // M = U S V^T: Jacobi's rotations make the columns of M V orthogonal.
  glm::dmat3 us = m, v(1.0);
  for (int sweep = 0; sweep < 60; ++sweep) {
    bool turned = false;
    for (int i = 0; i < 2; ++i)
      for (int j = i + 1; j < 3; ++j) {
        const double a = glm::dot(us[i], us[i]), b = glm::dot(us[j], us[j]);
        const double c = glm::dot(us[i], us[j]);
        if (std::abs(c) <= 1e-16 * std::sqrt(a * b)) continue;
        const double angle = 0.5 * std::atan2(2.0 * c, a - b);
        const double cos = std::cos(angle), sin = std::sin(angle);
        for (glm::dmat3* columns : {&us, &v}) {
          const dvec3 first = (*columns)[i], second = (*columns)[j];
          (*columns)[i] = cos * first + sin * second;
          (*columns)[j] = cos * second - sin * first;
        }
        turned = true;
      }
    if (!turned) break;
  }
  dvec3 factors(glm::length(us[0]), glm::length(us[1]), glm::length(us[2]));
  glm::dmat3 u(us[0] / factors.x, us[1] / factors.y, us[2] / factors.z);
  if (glm::determinant(u) < 0.0) {
    u[2] = -u[2];
    factors.z = -factors.z;
  }
  const auto turn = [&](const glm::dmat3& rotation) {
    const glm::dquat q = glm::normalize(glm::quat_cast(rotation));
    const dvec3 axis(q.x, q.y, q.z);
    const double sine = glm::length(axis);
    if (sine < 1e-15) return;
    line(fmt::format("rotate {} {}", 2.0 * std::atan2(sine, q.w) * kDegrees, point(axis / sine)));
  };
  if (factors.x == factors.y && factors.y == factors.z) { // one turn is enough
    turn(u * glm::transpose(v));
    if (factors.x != 1.0) line("scale " + point(factors));
    return;
  }
  turn(u);
  line("scale " + point(factors));
  turn(glm::transpose(v));
}

void SceneWriter::write() {
  write_settings();
  write_camera();
  write_surroundings();
  write_lights();
  write_shapes();
  std::string head = fmt::format("! Converted from {} by abbe.\n", scene_.title);
  if (!spectra_.empty()) {
    const std::string library = file_.stem().string() + "-spectra.filter";
    write_text(beside(library), spectra_);
    head += fmt::format("lights \"{}\"\n", library);
  }
  write_text(file_, head + text_);
}

} // namespace abbe
