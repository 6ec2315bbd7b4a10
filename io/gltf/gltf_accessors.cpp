// Accessors: arrays of numbers of six types in parts of buffers.

#include "io/gltf/gltf_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <type_traits>

namespace abbe {
namespace {

enum class ComponentType : std::uint16_t {
  int8 = 5120,
  uint8 = 5121,
  int16 = 5122,
  uint16 = 5123,
  uint32 = 5125,
  float32 = 5126
};

std::size_t size_of(ComponentType type) {
  switch (type) {
  case ComponentType::int8:
  case ComponentType::uint8:
    return 1;
  case ComponentType::int16:
  case ComponentType::uint16:
    return 2;
  case ComponentType::uint32:
  case ComponentType::float32:
    return 4;
  }
  return 0;
}

ComponentType component_type(const GltfValue& value) {
  const auto number = value.whole("componentType");
  for (const ComponentType type :
       {ComponentType::int8, ComponentType::uint8, ComponentType::int16, ComponentType::uint16,
        ComponentType::uint32, ComponentType::float32})
    if (number == static_cast<std::size_t>(type)) return type;
  throw ReadError(value.where(), "the numbers have no type that is known",
                  "componentType is one of 5120 to 5123, 5125 and 5126", std::string(kGltfAdvice));
}

/// Where the elements of an accessor, or of what replaces some of them, lie.
struct Elements {
  std::string_view bytes; ///< from the first element on
  std::size_t stride = 0;
  std::size_t count = 0, components = 1;
  ComponentType type = ComponentType::float32;
  bool normalized = false;
};

/// The elements, which are checked to lie within their bufferView.
Elements find_elements(GltfState& state, const GltfValue& user, ComponentType type,
                       std::size_t count, std::size_t components) {
  const auto view =
      user.index("bufferView", state.document.all("bufferViews").size(), "bufferViews");
  if (!view)
    throw ReadError(user.where(), "the accessor has no numbers", "it names no bufferView",
                    std::string(kGltfAdvice));
  const GltfBytes found = state.document.buffer_view(user, *view, state.files);
  const std::size_t size = components * size_of(type);
  const std::size_t stride = found.stride > 0 ? found.stride : size;
  const std::size_t offset = user.whole("byteOffset").value_or(0);
  const bool begins = offset <= found.bytes.size();
  const std::size_t room = begins ? found.bytes.size() - offset : 0;
  if (stride < size || !begins ||
      (count > 0 && (room < size || count - 1 > (room - size) / stride)))
    throw ReadError(
        user.where(), "the accessor reaches beyond its bufferView",
        fmt::format("{} elements of {} bytes, {} apart, from byte {} on do not lie in {}", count,
                    size, stride, offset, found.bytes.size()),
        std::string(kGltfAdvice));
  return {found.bytes.substr(offset), stride, count, components, type, false};
}

template <class Raw, class Out>
void copy(const Elements& from, std::vector<Out>& to) {
  constexpr double kMost =
      std::is_integral_v<Raw> ? static_cast<double>(std::numeric_limits<Raw>::max()) : 1.0;
  for (std::size_t i = 0; i < from.count; ++i) {
    const char* element = from.bytes.data() + i * from.stride;
    for (std::size_t c = 0; c < from.components; ++c) {
      Raw raw;
      std::memcpy(&raw, element + c * sizeof(Raw), sizeof(Raw));
      if constexpr (std::is_floating_point_v<Out>)
        to[i * from.components + c] = from.normalized
                                          ? std::max(static_cast<double>(raw) / kMost, -1.0)
                                          : static_cast<double>(raw);
      else if constexpr (std::is_integral_v<Raw>) // an index, which has no sign
        to[i * from.components + c] = static_cast<Out>(static_cast<std::make_unsigned_t<Raw>>(raw));
      else
        to[i * from.components + c] = static_cast<Out>(raw);
    }
  }
}

template <class Out>
std::vector<Out> numbers_of(const Elements& from) {
  std::vector<Out> to(from.count * from.components);
  switch (from.type) {
  case ComponentType::int8:
    copy<std::int8_t>(from, to);
    break;
  case ComponentType::uint8:
    copy<std::uint8_t>(from, to);
    break;
  case ComponentType::int16:
    copy<std::int16_t>(from, to);
    break;
  case ComponentType::uint16:
    copy<std::uint16_t>(from, to);
    break;
  case ComponentType::uint32:
    copy<std::uint32_t>(from, to);
    break;
  case ComponentType::float32:
    copy<float>(from, to);
    break;
  }
  return to;
}

std::size_t components_of(const GltfValue& accessor) {
  constexpr std::array<std::pair<std::string_view, std::size_t>, 4> kTypes{
      {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}}};
  const std::string type = accessor.string("type", "");
  for (const auto& [name, components] : kTypes)
    if (type == name) return components;
  throw ReadError(accessor.where(), fmt::format("the accessor is of the type \"{}\"", type),
                  "scalars and vectors are read", std::string(kGltfAdvice));
}

/// Puts the elements that a sparse accessor lists into their places.
void add_sparse(GltfState& state, const GltfValue& sparse, const Elements& all,
                std::vector<double>& numbers) {
  const auto indices = sparse.find("indices"), values = sparse.find("values");
  const std::size_t count = sparse.whole("count").value_or(0);
  if (!indices || !values || count > all.count)
    throw ReadError(sparse.where(), "the sparse accessor is incomplete",
                    "it has indices, values and a count of no more than all elements",
                    std::string(kGltfAdvice));
  const auto places =
      numbers_of<std::uint32_t>(find_elements(state, *indices, component_type(*indices), count, 1));
  Elements elements = find_elements(state, *values, all.type, count, all.components);
  elements.normalized = all.normalized;
  const auto replaced = numbers_of<double>(elements);
  for (std::size_t i = 0; i < count; ++i) {
    if (places[i] >= all.count)
      throw ReadError(indices->where(), fmt::format("{} is no element", places[i]),
                      fmt::format("there are {}", all.count), std::string(kGltfAdvice));
    std::copy_n(replaced.begin() + static_cast<std::ptrdiff_t>(i * all.components), all.components,
                numbers.begin() + static_cast<std::ptrdiff_t>(places[i] * all.components));
  }
}

} // namespace

std::vector<double> read_accessor(GltfState& state, const GltfValue& user, std::size_t accessor,
                                  std::size_t components) {
  const GltfValue& value = state.document.all("accessors")[accessor];
  if (components_of(value) != components)
    throw ReadError(
        value.where(),
        fmt::format("the accessor has {} numbers in each element", components_of(value)),
        fmt::format("{} needs {}", user.pointer(), components), std::string(kGltfAdvice));
  const ComponentType type = component_type(value);
  const std::size_t count = value.whole("count").value_or(0);
  Elements elements = find_elements(state, value, type, count, components);
  elements.normalized = value.flag("normalized", false);
  std::vector<double> numbers = numbers_of<double>(elements);
  if (const auto sparse = value.find("sparse")) add_sparse(state, *sparse, elements, numbers);
  return numbers;
}

std::vector<std::uint32_t> read_indices(GltfState& state, std::size_t accessor) {
  const GltfValue& value = state.document.all("accessors")[accessor];
  const ComponentType type = component_type(value);
  if (components_of(value) != 1 || type == ComponentType::float32)
    throw ReadError(value.where(), "the indices are no whole numbers",
                    "they are scalars of 8, 16 or 32 bits", std::string(kGltfAdvice));
  return numbers_of<std::uint32_t>(
      find_elements(state, value, type, value.whole("count").value_or(0), 1));
}

} // namespace abbe
