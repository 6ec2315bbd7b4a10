// A scene is a row of keywords with their arguments, read from top to bottom:
//
//   ! prism.sdl: a white beam is spread into a spectrum
//   eye 0 0 12   lookAt 0 0 0   imageSize 640 480
//   spotlight 2a  -6 0 0  1  1 0 0  1
//   glass N-SF11
//   push
//     rotate 90 1 0 0
//     prism
//   pop
//
// The keywords are rows of tables, one table per group, in read_scene_*.cpp.

#include "io/scene_language/read_scene.h"

#include "io/scene_language/read_scene_state.h"
#include "io/text/similar_names.h"

#include <fmt/format.h>

#include <array>
#include <stdexcept>
#include <utility>

namespace abbe {
namespace {

std::string_view name_of(const SceneKeyword& keyword) {
  return keyword.usage.substr(0, keyword.usage.find(' '));
}

/// All rows of all tables.
const std::vector<SceneKeyword>& all_keywords() {
  static const std::vector<SceneKeyword> list = [] {
    std::vector<SceneKeyword> rows;
    for (const auto& table :
         {table_keywords(), setting_keywords(), camera_keywords(), camera_lens_keywords(),
          transform_keywords(), material_keywords(), surface_keywords(), drop_keywords(),
          texture_keywords(), mixture_keywords(), light_keywords(), shape_keywords(),
          name_keywords(), lens_keywords(), boolean_keywords(), macro_keywords()})
      rows.insert(rows.end(), table.begin(), table.end());
    return rows;
  }();
  return list;
}

/// Notes a statement whose effect hangs on what it applies to.
void note_statement(SceneState& state, std::string_view keyword, const SourcePosition& where) {
  KeywordLedger& ledger = state.builder.keywords();
  if (const MaterialEffect* effect = material_effect(keyword)) {
    NotedKeyword& slot = state.material.given[effect->slot];
    if (effect->is_neutral(state.material)) {
      ledger.keep(slot);
      slot = {};
    } else {
      ledger.note(slot, effect->keyword, where);
    }
  }
  note_given(state.given, keyword, where);
  if (const LightEffect* effect = light_effect(keyword))
    ledger.note(state.light.given[effect->slot], effect->keyword, where);
}

const SceneKeyword* find_keyword(const Token& token) {
  for (const SceneKeyword& keyword : all_keywords())
    if (is_word(token, name_of(keyword))) return &keyword;
  return nullptr;
}

/// What other programs call things that have another name here.
struct ForeignWord {
  std::string_view theirs, ours;
};
constexpr std::array<ForeignWord, 24> kForeignWords{{
    {"ior", "speedOfLight"},
    {"eta", "speedOfLight"},
    {"fov", "fieldOfView"},
    {"fovy", "fieldOfView"},
    {"resolution", "imageSize"},
    {"size", "imageSize"},
    {"spp", "samples"},
    {"pixelSamples", "samples"},
    {"color", "diffuse"},
    {"colour", "diffuse"},
    {"albedo", "diffuse"},
    {"kd", "diffuse"},
    {"material", "UseMaterial"},
    {"position", "eye"},
    {"camera", "eye"},
    {"target", "lookAt"},
    {"maxDepth", "maxRecursionDepth"},
    {"depth", "maxRecursionDepth"},
    {"emission", "emissive"},
    {"dielectric", "glass"},
    {"shininess", "specularExponent"},
    {"box", "cube"},
    {"disk", "disc"},
    {"envmap", "environment"},
}};

[[noreturn]] void fail_unknown(const Token& token) {
  if (token.kind == TokenKind::word && parse_finite(token.text))
    throw ReadError(token.where, shown(token) + " stands where a keyword should",
                    "the statement before it has all its arguments",
                    "Remove it, or check the statement before it");
  if (token.kind == TokenKind::quoted)
    throw ReadError(token.where, "unknown keyword " + shown(token), "it stands in quotes",
                    "Remove the quotes");
  for (const ForeignWord& word : kForeignWords)
    if (is_word(token, word.theirs))
      throw ReadError(token.where, "unknown keyword " + shown(token),
                      "no such word in the scene language",
                      fmt::format("Did you mean {}?", word.ours));
  std::vector<std::string> names;
  for (const SceneKeyword& keyword : all_keywords())
    names.emplace_back(name_of(keyword));
  throw ReadError(token.where, "unknown keyword " + shown(token),
                  "no such word in the scene language",
                  did_you_mean(token.text, names, "docs/scene_format.md lists the keywords"));
}

void check_pushes(const SceneState& state) {
  if (state.pushed.empty()) return;
  throw ReadError(state.pushed.back().where, "push has no pop", "the file ends before it",
                  "Add a pop after the shapes it is meant for");
}

} // namespace

bool name_follows(const Arguments& arguments) {
  const Token& token = arguments.reader().peek();
  return token.kind == TokenKind::quoted ||
         (token.kind == TokenKind::word && !arguments.number_follows() && !find_keyword(token));
}

void read_statement(SceneState& state, TokenReader& reader) {
  if (state.boolean) check_operands(state, reader.peek());
  const Token token = reader.next();
  const SceneKeyword* keyword = find_keyword(token);
  if (!keyword) fail_unknown(token);
  if (state.boolean && !keyword->in_boolean)
    throw ReadError(
        token.where,
        fmt::format("{} cannot stand inside {}", name_of(*keyword), state.boolean->keyword),
        "only solids, transforms and materials can",
        fmt::format("Move it before {}", state.boolean->keyword));
  Arguments arguments(reader, token, keyword->usage);
  try {
    keyword->read(state, arguments);
    note_statement(state, name_of(*keyword), token.where);
  } catch (const std::invalid_argument& error) { // from below: numbers of an absurd size
    throw ReadError(token.where, fmt::format("{} cannot be carried out", name_of(*keyword)),
                    error.what(), "Give numbers of an ordinary size");
  }
}

Scene read_scene_text(std::string_view text, const std::filesystem::path& file, const Warn& warn,
                      InputFiles* files, GivenKeywords* given) {
  SceneState state;
  state.scene.title = file.stem().string();
  state.libraries.folder = file.parent_path();
  state.warn = warn ? warn : [](const std::string&) {};
  std::error_code error;
  state.open_files.push_back(std::filesystem::weakly_canonical(file, error));
  TokenReader reader(text, file.string());
  while (!reader.at_end())
    read_statement(state, reader);
  check_pushes(state);
  if (state.camera_at) check_view(*state.camera_at, state.scene.camera);
  finish_camera_lens(state);
  state.builder.warn_of_the_whole(state.warn);
  if (state.crop_at) check_crop(*state.crop_at, state.scene.settings);
  if (given) *given = std::move(state.given);
  if (files) {
    files->push_back(file);
    files->insert(files->end(), state.files.begin(), state.files.end());
    files->insert(files->end(), state.libraries.files.begin(), state.libraries.files.end());
  }
  return state.builder.take();
}

Scene read_scene(const std::filesystem::path& file, const Warn& warn, InputFiles* files,
                 GivenKeywords* given) {
  return read_scene_text(read_text_file(file), file, warn, files, given);
}

} // namespace abbe
