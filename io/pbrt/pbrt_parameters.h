#pragma once

#include "io/pbrt/pbrt_tokens.h"

#include <glm/vec3.hpp>

#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

namespace abbe {

/// One parameter of a directive: "float radius" 2.
struct PbrtParameter {
  std::string type, name;
  std::vector<double> numbers;
  std::vector<std::string> strings; ///< of type string, texture, spectrum by name; bools too
  SourcePosition where;
  bool used = false;
};

/// The parameters of one directive. What is asked for counts as used.
class PbrtParameters {
public:
  /// Reads all parameters that follow.
  [[nodiscard]] static PbrtParameters read(PbrtTokens& tokens);

  [[nodiscard]] const PbrtParameter* find(std::string_view name);
  /// A number of this name, or `otherwise`. Throws ReadError for anything but one number.
  [[nodiscard]] double number(std::string_view name, double otherwise);
  [[nodiscard]] std::optional<double> number(std::string_view name);
  [[nodiscard]] bool flag(std::string_view name, bool otherwise);
  [[nodiscard]] std::string string(std::string_view name, const std::string& otherwise);
  /// Points or vectors; nothing where there is no such parameter.
  [[nodiscard]] std::optional<std::vector<glm::dvec3>> points(std::string_view name);
  [[nodiscard]] std::vector<double> numbers(std::string_view name);
  /// Takes parameters as used that change nothing in a picture.
  void ignore(std::initializer_list<std::string_view> names);

  /// The first that nobody has asked for; null: none.
  [[nodiscard]] const PbrtParameter* unused() const;
  [[nodiscard]] const std::vector<PbrtParameter>& all() const { return parameters_; }
  /// Adds those of another list whose names are not there, as Attribute does.
  void add_defaults(const PbrtParameters& defaults);

private:
  std::vector<PbrtParameter> parameters_;
};

} // namespace abbe
