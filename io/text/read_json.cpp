#include "io/text/read_json.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <optional>

namespace abbe {
namespace {

constexpr std::size_t kMostNesting = 128;

/// Builds the tree from what the parser of the library meets, which calls these by their names.
class TreeBuilder {
public:
  explicit TreeBuilder(JsonValue& root) : root_(root) {}

  bool null() { return add({}) != nullptr; }
  bool boolean(bool value) { return add({value}) != nullptr; }
  bool number_integer(std::int64_t value) { return add({static_cast<double>(value)}) != nullptr; }
  bool number_unsigned(std::uint64_t value) { return add({static_cast<double>(value)}) != nullptr; }
  bool number_float(double value, const std::string&) { return add({value}) != nullptr; }
  bool string(std::string& value) { return add({std::move(value)}) != nullptr; }
  template <class Bytes>
  bool binary(Bytes&) {
    return false;
  }
  bool start_object(std::size_t) { return open({JsonObject{}}); }
  bool start_array(std::size_t) { return open({JsonArray{}}); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }
  bool key(std::string& name) {
    key_ = std::move(name);
    return true;
  }
  bool parse_error(std::size_t position, const std::string& token, const std::exception&) {
    error_at = position;
    error_token = token;
    return false;
  }

  bool too_deep = false;
  std::size_t error_at = 0; ///< the byte behind the one at which the text ceases to be JSON
  std::string error_token;

private:
  JsonValue* add(JsonValue value) {
    if (open_.empty()) {
      root_ = std::move(value);
      return &root_;
    }
    if (auto* array = std::get_if<JsonArray>(&open_.back()->value))
      return &array->emplace_back(std::move(value));
    auto& object = std::get<JsonObject>(open_.back()->value);
    return &object.emplace_back(std::move(key_), std::move(value)).second;
  }
  bool open(JsonValue value) {
    too_deep = open_.size() >= kMostNesting;
    if (too_deep) return false;
    open_.push_back(add(std::move(value))); // it stays where it is until it is closed
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }

  JsonValue& root_;
  std::vector<JsonValue*> open_;
  std::string key_;
};

SourcePosition place_of(std::string_view text, std::size_t byte, const std::string& file) {
  const std::string_view before = text.substr(0, std::min(byte, text.size()));
  SourcePosition where{file, 1, 1};
  where.line += static_cast<int>(std::ranges::count(before, '\n'));
  const std::size_t line = before.rfind('\n');
  for (const char c : line == before.npos ? before : before.substr(line + 1))
    if ((static_cast<unsigned char>(c) & 0xC0u) != 0x80u) ++where.column;
  return where;
}

} // namespace

const JsonValue* JsonValue::member(std::string_view name) const {
  const auto* object = std::get_if<JsonObject>(&value);
  if (!object) return nullptr;
  const auto found = std::ranges::find(*object, name, &JsonObject::value_type::first);
  return found == object->end() ? nullptr : &found->second;
}

JsonValue read_json(std::string_view text, const std::string& file) {
  JsonValue root;
  TreeBuilder builder(root);
  if (nlohmann::json::sax_parse(text.begin(), text.end(), &builder)) return root;
  if (builder.too_deep)
    throw ReadError(file, "the JSON nests too deeply",
                    "more than " + std::to_string(kMostNesting) + " values lie in each other",
                    "Write the file again");
  const std::size_t at = builder.error_at > 0 ? builder.error_at - 1 : 0;
  throw ReadError(place_of(text, at, file), "this is no JSON",
                  builder.error_token.empty() || at >= text.size() ? "the text ends too early"
                                                                   : "no value can go on so",
                  "Write the file again");
}

} // namespace abbe
