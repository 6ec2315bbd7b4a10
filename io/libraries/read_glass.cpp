// A glass or a metal of the catalogue, in a scene or in a material library:
//
//   glass N-BK7
//   metal Au

#include "io/libraries/read_glass.h"

#include "io/text/similar_names.h"

namespace abbe {

const Glass& read_glass(Arguments& arguments) {
  const Token name = arguments.name_token("the name of a glass");
  if (const Glass* glass = find_glass(name.text)) return *glass;
  std::vector<std::string> names;
  for (const Glass& glass : glass_catalogue())
    names.push_back(glass.name);
  throw ReadError(name.where, "unknown glass " + shown(name), "no such name in the glass catalogue",
                  did_you_mean(name.text, names, "abbe list glasses shows them all"));
}

const Metal& read_metal(Arguments& arguments) {
  const Token name = arguments.name_token("the name of a metal");
  if (const Metal* metal = find_metal(name.text)) return *metal;
  std::string symbols;
  for (const Metal& metal : metal_catalogue())
    symbols += (symbols.empty() ? "" : " ") + metal.name;
  throw ReadError(name.where, "unknown metal " + shown(name),
                  "no such symbol in the catalogue of metals", "The metals are " + symbols);
}

} // namespace abbe
