#include "bench/reports/compare.h"

#include "core/scene/user_error.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace abbe::bench {
namespace {

using Json = nlohmann::ordered_json;

/// Adds ", WHAT" to a name.
void append(std::string& name, const std::string& what) {
  if (!name.empty()) name += ", ";
  name += what;
}

std::string settings_name(const Json& s) {
  std::string name = fmt::format("{}x{}", s.at("width").get<int>(), s.at("height").get<int>());
  if (const Json& crop = s.at("crop"); !crop.is_null())
    name += fmt::format(" crop {}", crop.dump());
  append(name, fmt::format("{} bands", s.at("bands").get<int>()));
  append(name, fmt::format("{} spp", s.at("samples_per_pixel").get<int>()));
  append(name, fmt::format("{} threads", s.at("threads").get<int>()));
  return name;
}

/// What an object says of itself: its scene, its settings, its place on an axis.
void add_labels(std::string& name, const Json& object) {
  for (const char* key : {"scene", "variation", "kind", "without"})
    if (object.contains(key)) append(name, object.at(key).get<std::string>());
  if (object.contains("scene") && object.contains("settings"))
    append(name, settings_name(object.at("settings")));
  if (object.contains("reference")) append(name, settings_name(object.at("reference")));
  if (object.contains("width")) append(name, fmt::format("width {}", object.at("width").dump()));
  struct Unit {
    const char *key, *unit;
  };
  for (const Unit& number : {Unit{"bands", "bands"}, Unit{"samples_per_pixel", "spp"},
                             Unit{"threads", "threads"}, Unit{"primitives", "primitives"}})
    if (object.contains(number.key))
      append(name, fmt::format("{} {}", object.at(number.key).dump(), number.unit));
}

/// Wall time is disturbed by other programs and is not compared.
bool is_timing(const std::string& key, const Json& value) {
  return key.ends_with("seconds") && !key.ends_with("wall_seconds") && value.is_object() &&
         value.contains("repeats");
}

void collect(const Json& node, const std::string& parents, std::vector<Timing>& timings) {
  if (node.is_array()) {
    for (const Json& item : node)
      collect(item, parents, timings);
    return;
  }
  if (!node.is_object()) return;
  std::string name = parents;
  add_labels(name, node);
  for (const auto& [key, value] : node.items()) {
    if (key == "settings" || key == "reference") continue;
    if (is_timing(key, value)) {
      timings.push_back({fmt::format("{}: {}", name, key.substr(0, key.rfind('_'))),
                         value.at("repeats").get<std::vector<double>>()});
    } else if (key == "replay_seconds") {
      for (const auto& [width, seconds] : value.items())
        timings.push_back({fmt::format("{}: embree {}", name, width),
                           seconds.at("repeats").get<std::vector<double>>()});
    } else if (key.starts_with("by_")) {
      collect(value, fmt::format("{}, {}", name, key), timings);
    } else {
      collect(value, name, timings);
    }
  }
}

} // namespace

std::vector<Timing> timings_of(const std::string& json_text) {
  try {
    const Json report = Json::parse(json_text);
    std::vector<Timing> timings;
    for (const auto& [key, value] : report.items())
      if (key != "machine") collect(value, key, timings);
    return timings;
  } catch (const Json::exception& error) {
    throw UserError(fmt::format("no report of abbe bench: {}", error.what()));
  }
}

std::vector<std::string> machine_differences(const std::string& first, const std::string& second) {
  try {
    const Json a = Json::parse(first).at("machine"), b = Json::parse(second).at("machine");
    std::vector<std::string> differences;
    for (const auto& [key, value] : a.items())
      if (key != "load" && b.contains(key) && b.at(key) != value)
        differences.push_back(fmt::format("{}: {} and {}", key, value.dump(), b.at(key).dump()));
    return differences;
  } catch (const Json::exception& error) {
    throw UserError(fmt::format("no report of abbe bench: {}", error.what()));
  }
}

} // namespace abbe::bench
