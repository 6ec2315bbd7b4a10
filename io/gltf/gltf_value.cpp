#include "io/gltf/gltf_value.h"

#include <fmt/format.h>

#include <cmath>

namespace abbe {
namespace {

/// A name as JSON pointers have it [RFC 6901].
std::string escaped(std::string_view name) {
  std::string text;
  for (const char c : name)
    if (c == '~')
      text += "~0";
    else if (c == '/')
      text += "~1";
    else
      text += c;
  return text;
}

} // namespace

void GltfValue::fail(std::string_view expected) const {
  throw ReadError(where(), fmt::format("this is not {}", expected), "glTF 2.0 asks for it",
                  std::string(kGltfAdvice));
}

std::optional<GltfValue> GltfValue::find(std::string_view name) const {
  if (!std::holds_alternative<JsonObject>(value_->value)) fail("an object");
  const JsonValue* member = value_->member(name);
  if (!member) return std::nullopt;
  return GltfValue(*member, *file_, pointer_ + "/" + escaped(name));
}

std::optional<GltfValue> GltfValue::extension(std::string_view name) const {
  const auto all = find("extensions");
  return all ? all->find(name) : std::nullopt;
}

std::vector<GltfValue> GltfValue::list(std::string_view name) const {
  std::vector<GltfValue> elements;
  const auto member = find(name);
  if (!member) return elements;
  const auto* array = std::get_if<JsonArray>(&member->value_->value);
  if (!array) member->fail("an array");
  for (std::size_t i = 0; i < array->size(); ++i)
    elements.emplace_back((*array)[i], *file_, fmt::format("{}/{}", member->pointer_, i));
  return elements;
}

std::vector<std::string_view> GltfValue::names() const {
  const auto* object = std::get_if<JsonObject>(&value_->value);
  if (!object) fail("an object");
  std::vector<std::string_view> found;
  for (const auto& [name, member] : *object)
    found.emplace_back(name);
  return found;
}

double GltfValue::as_number() const {
  const auto* number = std::get_if<double>(&value_->value);
  if (!number || !std::isfinite(*number)) fail("a number");
  return *number;
}

std::optional<double> GltfValue::number(std::string_view name, double lowest,
                                        double highest) const {
  const auto member = find(name);
  if (!member) return std::nullopt;
  const double value = member->as_number();
  if (!(value >= lowest && value <= highest))
    throw ReadError(member->where(), fmt::format("{} is {:g}", name, value),
                    std::isinf(highest) ? fmt::format("it is no less than {:g}", lowest)
                                        : fmt::format("it lies from {:g} to {:g}", lowest, highest),
                    "Change it");
  return value;
}

std::optional<std::size_t> GltfValue::whole(std::string_view name) const {
  const auto value = number(name, 0.0, 0x1p53);
  if (!value) return std::nullopt;
  if (*value != std::floor(*value)) find(name)->fail("a whole number");
  return static_cast<std::size_t>(*value);
}

std::optional<std::size_t> GltfValue::index(std::string_view name, std::size_t count,
                                            std::string_view things) const {
  const auto member = find(name);
  if (!member) return std::nullopt;
  return member->as_index(count, things);
}

std::size_t GltfValue::as_index(std::size_t count, std::string_view things) const {
  const double value = as_number();
  if (!(value >= 0.0 && value < static_cast<double>(count)) || value != std::floor(value))
    throw ReadError(where(), fmt::format("{:g} names nothing", value),
                    fmt::format("there are {} {}, and they count from 0", count, things),
                    std::string(kGltfAdvice));
  return static_cast<std::size_t>(value);
}

bool GltfValue::flag(std::string_view name, bool otherwise) const {
  const auto member = find(name);
  if (!member) return otherwise;
  const bool* value = std::get_if<bool>(&member->value_->value);
  if (!value) member->fail("true or false");
  return *value;
}

std::string GltfValue::string(std::string_view name, std::string_view otherwise) const {
  const auto member = find(name);
  return member ? member->as_string() : std::string(otherwise);
}

std::string GltfValue::as_string() const {
  const auto* text = std::get_if<std::string>(&value_->value);
  if (!text) fail("a string");
  return *text;
}

void GltfValue::read_numbers(std::string_view name, double* values, std::size_t count) const {
  if (!find(name)) return;
  const std::vector<GltfValue> elements = list(name);
  if (elements.size() != count) find(name)->fail(fmt::format("an array of {} numbers", count));
  for (std::size_t i = 0; i < count; ++i)
    values[i] = elements[i].as_number();
}

} // namespace abbe
