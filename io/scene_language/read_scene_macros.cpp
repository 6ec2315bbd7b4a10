// A macro is a name for a row of statements; an included file is read where it is named:
//
//   include chess_pieces.sdl
//   def pawn {
//     push translate 0 0 1 scale 0.5 0.5 0.5 sphere pop
//     cone
//   }
//   use pawn
//   push translate 2 0 0 use pawn pop
//
// The statements act as if they stood in place of `use` or `include`.

#include "io/scene_language/read_scene_state.h"
#include "io/text/similar_names.h"
#include "spectral/data_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace abbe {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kDeepestMacro = 200; ///< more inside each other would exhaust the call stack
/// All words that macros and included files bring; each may be a shape of some hundred bytes.
constexpr std::size_t kMostExpanded = 10'000'000;

/// The tokens after `{` up to its `}`, and an end that names the macro.
std::vector<Token> read_body(Arguments& arguments, const Token& name) {
  TokenReader& reader = arguments.reader();
  if (reader.peek().kind != TokenKind::open_brace)
    throw ReadError(reader.peek().where, shown(reader.peek()) + " stands where { should",
                    arguments.takes(), "Put the macro's statements in braces");
  const SourcePosition opened = reader.next().where;
  std::vector<Token> body;
  for (int open = 1;;) {
    const Token token = reader.next();
    if (token.kind == TokenKind::end)
      throw ReadError(opened, fmt::format("the brace of macro {} is not closed", name.text),
                      shown(token) + " comes before", "Add } after the macro's statements");
    open += token.kind == TokenKind::open_brace ? 1 : token.kind == TokenKind::close_brace ? -1 : 0;
    if (open == 0) {
      body.push_back({TokenKind::end, "macro " + name.text, token.where});
      return body;
    }
    body.push_back(token);
  }
}

void read_def(SceneState& state, Arguments& arguments) {
  const Token name = arguments.name_token("the name of a macro");
  Macro macro{name.text, arguments.keyword().where, read_body(arguments, name)};
  if (const auto known = state.macro_names.find(name.text)) {
    state.macros[*known] = std::move(macro);
    return;
  }
  state.macro_names.add(name.text, state.macros.size());
  state.macros.push_back(std::move(macro));
}

/// Reads all statements. What is said about them is followed by `note`.
void read_statements(SceneState& state, TokenReader reader, const std::string& note) {
  const Warn warn = state.warn;
  state.warn = [&](const std::string& message) { warn(message + note); };
  try {
    while (!reader.at_end())
      read_statement(state, reader);
  } catch (const ReadError& error) {
    throw error.with(note);
  }
  state.warn = warn;
}

void check_depth(const SceneState& state, const SourcePosition& where) {
  if (state.open_macros.size() + state.open_files.size() > kDeepestMacro)
    throw ReadError(where, "too many macros and files inside each other",
                    fmt::format("at most {} are read", kDeepestMacro), "Nest fewer of them");
}

/// Counts the words that `what` brings, before they are read.
void check_expansion(SceneState& state, const SourcePosition& where, std::size_t count,
                     const std::string& what) {
  state.expanded += count;
  if (state.expanded > kMostExpanded)
    throw ReadError(
        where, fmt::format("the scene grows too large at {}", what),
        fmt::format("macros and included files bring more than {} words in all", kMostExpanded),
        "Use fewer macros inside each other, or a mesh for many shapes");
}

const Macro& find_macro(const SceneState& state, const Token& name) {
  if (const auto known = state.macro_names.find(name.text)) return state.macros[*known];
  std::vector<std::string> names;
  for (const Macro& macro : state.macros)
    names.push_back(macro.name);
  throw ReadError(name.where, "unknown macro " + shown(name), "no def before it has this name",
                  did_you_mean(name.text, names, "Define it with def, before its use"));
}

void read_use(SceneState& state, Arguments& arguments) {
  const Token name = arguments.name_token("the name of a macro");
  const Macro macro = find_macro(state, name); // a copy: it may be defined anew while it is used
  auto& open = state.open_macros;
  const auto itself = std::find_if(open.begin(), open.end(), [&](const std::string& other) {
    return same_name(other, macro.name);
  });
  if (itself != open.end()) {
    std::string way;
    for (auto step = itself; step != open.end(); ++step)
      way += *step + " uses ";
    throw ReadError(name.where, fmt::format("macro {} uses itself", macro.name), way + macro.name,
                    "Remove this use");
  }
  check_depth(state, name.where);
  check_expansion(state, name.where, macro.body.size(), "macro " + macro.name);
  open.push_back(macro.name);
  read_statements(state, TokenReader(macro.body),
                  fmt::format(" [in macro {}, defined at {}, used at {}]", macro.name,
                              to_string(macro.where), to_string(name.where)));
  open.pop_back();
}

void read_include(SceneState& state, Arguments& arguments) {
  const Token name = arguments.name_token("the name of a file");
  const fs::path file =
      input_file(state.files, name, fs::path(name.where.file).parent_path(),
                 {"file", "files are found relative to the one that includes them"});
  std::error_code error;
  const fs::path path = fs::weakly_canonical(file, error);
  auto& open = state.open_files;
  if (std::find(open.begin(), open.end(), path) != open.end())
    throw ReadError(name.where, fmt::format("\"{}\" includes itself", file.string()),
                    "it is being read already", "Remove this include");
  check_depth(state, name.where);
  TokenReader reader(read_text_file(file), file.string());
  check_expansion(state, name.where, reader.count(), shown(name));
  open.push_back(path);
  read_statements(state, std::move(reader),
                  fmt::format(" [included at {}]", to_string(name.where)));
  open.pop_back();
}

constexpr std::array kMacroKeywords{
    SceneKeyword{"def NAME { ... }", read_def, true},
    SceneKeyword{"use NAME", read_use, true},
    SceneKeyword{"include FILE", read_include, true},
};

} // namespace

std::span<const SceneKeyword> macro_keywords() {
  return kMacroKeywords;
}

} // namespace abbe
