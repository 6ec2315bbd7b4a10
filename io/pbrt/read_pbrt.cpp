// A scene of pbrt-v4 is a row of directives with their parameters. Those before WorldBegin are
// about the picture as a whole:
//
//   LookAt 0 1.6 6  0 0.9 0  0 1 0
//   Camera "perspective" "float fov" 35
//   WorldBegin
//   AttributeBegin
//     Translate 0 1 0
//     Material "dielectric" "float eta" 1.5
//     Shape "sphere"
//   AttributeEnd

#include "io/pbrt/read_pbrt.h"

#include "io/pbrt/pbrt_statement.h"
#include "io/text/similar_names.h"
#include "io/text/token.h"

#include <fmt/format.h>

#include <array>
#include <span>
#include <stdexcept>
#include <utility>

namespace abbe {
namespace {

constexpr std::size_t kMostNesting = 64; ///< of files that include files

void read_tokens(PbrtState& state, std::string_view text, const std::string& file,
                 std::size_t nesting);

void read_attribute_begin(const Statement& s) {
  s.state.kept.push_back({s.state.now, s.where});
}
void read_attribute_end(const Statement& s) {
  if (s.state.kept.empty())
    throw ReadError(s.where, "nothing has begun that ends here", "AttributeBegin comes before it",
                    "Remove it");
  s.state.now = std::move(s.state.kept.back().attributes);
  s.state.kept.pop_back();
}
void read_attribute(const Statement& s) {
  const std::string target = s.string();
  const PbrtParameters parameters = PbrtParameters::read(s.tokens);
  PbrtAttributes& now = s.state.now;
  if (target == "shape")
    now.shape_defaults.add_defaults(parameters);
  else if (target == "light")
    now.light_defaults.add_defaults(parameters);
  else if (target == "material")
    now.material_defaults.add_defaults(parameters);
  else
    refuse(s.state, s.where, fmt::format("attributes of \"{}\"", target),
           "shape, light and material have some");
}
void read_reverse(const Statement& s) {
  s.state.now.reversed = !s.state.now.reversed;
}

void read_shape(const Statement& s) {
  const std::string type = s.string();
  PbrtParameters parameters = PbrtParameters::read(s.tokens);
  parameters.add_defaults(s.state.now.shape_defaults);
  read_pbrt_shape(s.state, s.where, type, parameters);
}
void read_light_source(const Statement& s) {
  const std::string type = s.string();
  PbrtParameters parameters = PbrtParameters::read(s.tokens);
  parameters.add_defaults(s.state.now.light_defaults);
  read_pbrt_light(s.state, s.where, type, parameters);
}
void read_area_light_source(const Statement& s) {
  const std::string type = s.string();
  PbrtParameters parameters = PbrtParameters::read(s.tokens);
  parameters.add_defaults(s.state.now.light_defaults);
  read_pbrt_area_light(s.state, s.where, type, parameters);
}
void read_material(const Statement& s) {
  const std::string type = s.string();
  PbrtParameters parameters = PbrtParameters::read(s.tokens);
  parameters.add_defaults(s.state.now.material_defaults);
  s.state.now.material =
      std::make_shared<const PbrtMaterial>(read_pbrt_material(s.state, s.where, type, parameters));
}
void read_make_named_material(const Statement& s) {
  const std::string name = s.string();
  PbrtParameters parameters = PbrtParameters::read(s.tokens);
  const std::string type = parameters.string("type", "");
  s.state.materials[name] =
      std::make_shared<const PbrtMaterial>(read_pbrt_material(s.state, s.where, type, parameters));
}
void read_named_material(const Statement& s) {
  const std::string name = s.string();
  const auto found = s.state.materials.find(name);
  if (found == s.state.materials.end()) {
    std::vector<std::string> names;
    for (const auto& [known, material] : s.state.materials)
      names.push_back(known);
    throw ReadError(s.where, fmt::format("unknown material \"{}\"", name),
                    "no MakeNamedMaterial has given this name before",
                    did_you_mean(name, names, "Check the name"));
  }
  s.state.now.material = found->second;
}
void read_texture(const Statement& s) {
  std::vector<std::string> words;
  for (int i = 0; i < 3; ++i)
    words.push_back(s.string());
  PbrtParameters parameters = PbrtParameters::read(s.tokens);
  read_pbrt_texture(s.state, s.where, parameters, words);
}
void read_make_named_medium(const Statement& s) {
  const std::string name = s.string();
  PbrtParameters parameters = PbrtParameters::read(s.tokens);
  read_pbrt_medium(s.state, s.where, name, parameters);
}
void read_medium_interface(const Statement& s) {
  s.state.now.inside = s.string();
  s.state.now.outside =
      s.tokens.peek().kind == PbrtTokenKind::quoted ? s.string() : s.state.now.inside;
  if (!s.state.now.outside.empty() && s.state.now.outside != s.state.now.inside)
    refuse(s.state, s.where, "a medium outside of shapes", "air is there");
}

void read_object_begin(const Statement& s) {
  if (s.state.open_object)
    throw ReadError(s.where, "ObjectBegin within an object", "objects do not nest",
                    "Add ObjectEnd before it");
  read_attribute_begin(s);
  s.state.open_object = s.string();
  s.state.objects[*s.state.open_object].clear();
}
void read_object_end(const Statement& s) {
  if (!s.state.open_object)
    throw ReadError(s.where, "no object has begun that ends here", "ObjectBegin comes before it",
                    "Remove it");
  s.state.open_object.reset();
  read_attribute_end(s);
}
void read_object_instance(const Statement& s) {
  const std::string name = s.string();
  const auto found = s.state.objects.find(name);
  if (found == s.state.objects.end() || s.state.open_object)
    throw ReadError(s.where, fmt::format("\"{}\" is no object that can be placed here", name),
                    "ObjectBegin and ObjectEnd come before it", "Check the name");
  for (const PbrtObjectShape& part : found->second)
    place_pbrt_shape(s.state, part.where, part.shape, s.state.now.transform * part.to_object,
                     part.material);
}

void read_include(const Statement& s) {
  const std::string name = s.string();
  const std::filesystem::path file = s.state.folder / name;
  if (s.nesting >= kMostNesting)
    throw ReadError(s.where, "files include each other without end",
                    fmt::format("{} of them are open", s.nesting), "Remove one of the includes");
  s.state.files.push_back(file);
  std::string text;
  try {
    text = read_text_file(file);
  } catch (const ReadError& fault) {
    throw fault.with(fmt::format(" [included at {}]", to_string(s.where)));
  }
  read_tokens(s.state, text, file.string(), s.nesting + 1);
}

constexpr std::array kDirectives{
    Directive{"AttributeBegin", read_attribute_begin, Part::world},
    Directive{"AttributeEnd", read_attribute_end, Part::world},
    Directive{"TransformBegin", read_attribute_begin, Part::world},
    Directive{"TransformEnd", read_attribute_end, Part::world},
    Directive{"Attribute", read_attribute},
    Directive{"ReverseOrientation", read_reverse, Part::world},
    Directive{"Shape", read_shape, Part::world},
    Directive{"LightSource", read_light_source, Part::world},
    Directive{"AreaLightSource", read_area_light_source, Part::world},
    Directive{"Material", read_material, Part::world},
    Directive{"MakeNamedMaterial", read_make_named_material, Part::world},
    Directive{"NamedMaterial", read_named_material, Part::world},
    Directive{"Texture", read_texture, Part::world},
    Directive{"MakeNamedMedium", read_make_named_medium},
    Directive{"MediumInterface", read_medium_interface},
    Directive{"ObjectBegin", read_object_begin, Part::world},
    Directive{"ObjectEnd", read_object_end, Part::world},
    Directive{"ObjectInstance", read_object_instance, Part::world},
    Directive{"Include", read_include},
    Directive{"Import", read_include, Part::world},
};

/// The row of this name in any table; null: there is none.
const Directive* find_directive(std::string_view name) {
  for (const std::span<const Directive> table :
       {std::span<const Directive>(kDirectives), pbrt_transforms(), pbrt_options()})
    for (const Directive& directive : table)
      if (directive.name == name) return &directive;
  return nullptr;
}

[[noreturn]] void fail_unknown(const SourcePosition& where, std::string_view name) {
  std::vector<std::string> names;
  for (const std::span<const Directive> table :
       {std::span<const Directive>(kDirectives), pbrt_transforms(), pbrt_options()})
    for (const Directive& directive : table)
      names.emplace_back(directive.name);
  throw ReadError(where, fmt::format("unknown directive \"{}\"", name), "pbrt-v4 has none such",
                  did_you_mean(name, names, "Check the end of the directive before it"));
}

void check_part(const PbrtState& state, const SourcePosition& where, const Directive& directive) {
  if (directive.part == Part::world && !state.in_world)
    throw ReadError(where, fmt::format("{} stands too early", directive.name),
                    "it belongs behind WorldBegin", "Move it, or add WorldBegin");
  if (directive.part == Part::options && state.in_world)
    throw ReadError(where, fmt::format("{} stands too late", directive.name),
                    "it belongs before WorldBegin", "Move it");
}

void read_tokens(PbrtState& state, std::string_view text, const std::string& file,
                 std::size_t nesting) {
  PbrtTokens tokens(text, file);
  for (;;) {
    const PbrtToken token = tokens.next();
    if (token.kind == PbrtTokenKind::end) return;
    const SourcePosition where = tokens.where(token);
    const Directive* directive =
        token.kind == PbrtTokenKind::word ? find_directive(token.text) : nullptr;
    if (!directive) fail_unknown(where, token.text);
    check_part(state, where, *directive);
    try {
      directive->read({state, tokens, where, nesting});
    } catch (const std::invalid_argument& fault) { // from below: numbers of an absurd size
      throw ReadError(where, fmt::format("{} cannot be carried out", directive->name), fault.what(),
                      "Give numbers of an ordinary size");
    }
  }
}

Scene read(std::string_view text, const std::filesystem::path& file, const Warn& warn,
           InputFiles* files, Strictness strictness) {
  PbrtState state;
  state.scene.title = file.stem().string();
  state.folder = file.parent_path();
  state.now.material = std::make_shared<const PbrtMaterial>(default_pbrt_material());
  state.warn = warn ? warn : [](const std::string&) {};
  state.strictness = strictness;
  state.scene.settings.integrator = Integrator::path;
  state.scene.settings.max_depth = 5;
  state.scene.settings.width = 1280;
  state.scene.settings.height = 720;
  read_tokens(state, text, file.string(), 1);
  if (!state.in_world)
    throw ReadError(file, "the scene has no WorldBegin", "its shapes and lights stand behind it",
                    "Add it");
  if (!state.kept.empty())
    throw ReadError(state.kept.back().where, "this has no end", "the file ends before it",
                    "Add AttributeEnd or ObjectEnd");
  join_caps(state);
  state.builder.warn_of_the_whole(state.warn);
  if (files) files->insert(files->end(), state.files.begin(), state.files.end());
  return state.builder.take();
}

} // namespace

void refuse(const PbrtState& state, const SourcePosition& where, const std::string& what,
            const std::string& why) {
  if (state.strictness == Strictness::strict)
    throw ReadError(where, what + " is not understood", why,
                    "Change it, or give --lenient to go on without");
  state.warn(fmt::format("{}: {} is not understood ({})", to_string(where), what, why));
}

void refuse_unused(const PbrtState& state, const PbrtParameters& parameters) {
  for (const PbrtParameter& parameter : parameters.all())
    if (!parameter.used)
      refuse(state, parameter.where, fmt::format("the parameter \"{}\"", parameter.name),
             "nothing here has it");
}

Scene read_pbrt_text(std::string_view text, const std::filesystem::path& file, const Warn& warn,
                     Strictness strictness) {
  return read(text, file, warn, nullptr, strictness);
}

Scene read_pbrt(const std::filesystem::path& file, const Warn& warn, InputFiles* files,
                Strictness strictness) {
  const std::string text = read_text_file(file);
  if (files) files->push_back(file);
  return read(text, file, warn, files, strictness);
}

} // namespace abbe
