// What follows a directive of pbrt: pairs of "TYPE NAME" and one value, or several in brackets.
//
//   Shape "sphere" "float radius" 2 "point3 P" [ 0 0 0 ]

#include "io/pbrt/pbrt_parameters.h"

#include "io/text/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace abbe {
namespace {

void add_value(PbrtParameter& parameter, const PbrtToken& token, const SourcePosition& where) {
  if (token.kind == PbrtTokenKind::quoted) {
    parameter.strings.emplace_back(token.text);
    return;
  }
  if (token.text == "true" || token.text == "false") {
    parameter.strings.emplace_back(token.text);
    return;
  }
  const auto number = parse_finite(token.text);
  if (!number)
    throw ReadError(where, fmt::format("\"{}\" is not a number", token.text),
                    fmt::format("it is a value of {}", parameter.name),
                    "Give a number, or a string in quotes");
  parameter.numbers.push_back(*number);
}

} // namespace

PbrtParameters PbrtParameters::read(PbrtTokens& tokens) {
  PbrtParameters found;
  while (tokens.peek().kind == PbrtTokenKind::quoted) {
    const PbrtToken head = tokens.next();
    PbrtParameter parameter;
    parameter.where = tokens.where(head);
    const std::size_t begin = head.text.find_first_not_of(' ');
    const std::size_t blank = head.text.find(' ', std::min(begin, head.text.size()));
    const std::size_t name = head.text.find_first_not_of(' ', std::min(blank, head.text.size()));
    if (name == std::string_view::npos)
      throw ReadError(parameter.where, fmt::format("\"{}\" is no parameter", head.text),
                      "a parameter is a type and a name, such as \"float radius\"",
                      "Write both in one pair of quotes");
    parameter.type = head.text.substr(begin, blank - begin);
    parameter.name = head.text.substr(name, head.text.find(' ', name) - name);
    const PbrtToken value = tokens.next();
    if (value.kind == PbrtTokenKind::open_bracket) {
      while (tokens.peek().kind != PbrtTokenKind::close_bracket) {
        const PbrtToken token = tokens.next();
        if (token.kind == PbrtTokenKind::end || token.kind == PbrtTokenKind::open_bracket)
          throw ReadError(parameter.where,
                          fmt::format("the values of {} have no end", parameter.name),
                          "a closing bracket is missing", "Add it");
        add_value(parameter, token, tokens.where(token));
      }
      (void)tokens.next();
    } else if (value.kind == PbrtTokenKind::end || value.kind == PbrtTokenKind::close_bracket) {
      throw ReadError(parameter.where, fmt::format("{} has no value", parameter.name),
                      "one value or several in brackets follow", "Add them");
    } else {
      add_value(parameter, value, tokens.where(value));
    }
    found.parameters_.push_back(std::move(parameter));
  }
  return found;
}

const PbrtParameter* PbrtParameters::find(std::string_view name) {
  for (PbrtParameter& parameter : parameters_)
    if (parameter.name == name) {
      parameter.used = true;
      return &parameter;
    }
  return nullptr;
}

std::optional<double> PbrtParameters::number(std::string_view name) {
  const PbrtParameter* found = find(name);
  if (!found) return std::nullopt;
  if (found->numbers.size() != 1)
    throw ReadError(found->where, fmt::format("{} is not one number", name),
                    fmt::format("{} numbers follow", found->numbers.size()), "Give one number");
  return found->numbers[0];
}

double PbrtParameters::number(std::string_view name, double otherwise) {
  return number(name).value_or(otherwise);
}

bool PbrtParameters::flag(std::string_view name, bool otherwise) {
  const PbrtParameter* found = find(name);
  if (!found) return otherwise;
  if (found->strings.size() != 1 || (found->strings[0] != "true" && found->strings[0] != "false"))
    throw ReadError(found->where, fmt::format("{} is neither true nor false", name),
                    "its type is bool", "Give true or false");
  return found->strings[0] == "true";
}

std::string PbrtParameters::string(std::string_view name, const std::string& otherwise) {
  const PbrtParameter* found = find(name);
  if (!found) return otherwise;
  if (found->strings.size() != 1)
    throw ReadError(found->where, fmt::format("{} is not one string", name),
                    fmt::format("{} strings follow", found->strings.size()),
                    "Give one string in quotes");
  return found->strings[0];
}

std::optional<std::vector<glm::dvec3>> PbrtParameters::points(std::string_view name) {
  const PbrtParameter* found = find(name);
  if (!found) return std::nullopt;
  if (found->numbers.size() % 3 != 0)
    throw ReadError(found->where, fmt::format("{} holds no points", name),
                    fmt::format("{} numbers are no multiple of three", found->numbers.size()),
                    "Give x, y and z of each");
  std::vector<glm::dvec3> points;
  points.reserve(found->numbers.size() / 3);
  for (std::size_t i = 0; i < found->numbers.size(); i += 3)
    points.emplace_back(found->numbers[i], found->numbers[i + 1], found->numbers[i + 2]);
  return points;
}

std::vector<double> PbrtParameters::numbers(std::string_view name) {
  const PbrtParameter* found = find(name);
  return found ? found->numbers : std::vector<double>();
}

void PbrtParameters::ignore(std::initializer_list<std::string_view> names) {
  for (const std::string_view name : names)
    (void)find(name);
}

const PbrtParameter* PbrtParameters::unused() const {
  const auto found = std::ranges::find_if(parameters_, [](const auto& p) { return !p.used; });
  return found == parameters_.end() ? nullptr : &*found;
}

void PbrtParameters::add_defaults(const PbrtParameters& defaults) {
  for (const PbrtParameter& parameter : defaults.parameters_)
    if (std::ranges::none_of(parameters_,
                             [&](const auto& p) { return p.name == parameter.name; })) {
      parameters_.push_back(parameter);
      parameters_.back().used = true; // what it does not know a shape leaves out
    }
}

} // namespace abbe
