#include "io/manual/shell_completion.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace abbe {
namespace {

/// The text between single quotes, as zsh reads it.
std::string in_quotes(std::string_view text) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'')
      result += "'\\''";
    else
      result += c;
  }
  return result + "'";
}

std::string joined(std::span<const std::string> words, std::string_view between) {
  return fmt::format("{}", fmt::join(words, between));
}

std::vector<std::string> names_of(std::span<const CommandFacts> commands) {
  std::vector<std::string> names;
  for (const CommandFacts& command : commands)
    names.push_back(command.name);
  return names;
}

} // namespace

std::string bash_completion(std::span<const CommandFacts> commands) {
  std::string script = "# Completion of abbe for bash, made by: abbe manual bash\n"
                       "_abbe() {\n"
                       "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]}\n"
                       "  COMPREPLY=()\n"
                       "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n";
  script += fmt::format("    COMPREPLY=($(compgen -W '{}' -- \"$word\"))\n    return\n  fi\n"
                        "  case \"${{COMP_WORDS[1]}} $before\" in\n",
                        joined(names_of(commands), " "));
  for (const CommandFacts& command : commands)
    for (const OptionFacts& option : command.options) {
      if (option.positional || option.value.empty()) continue;
      std::vector<std::string> patterns;
      for (const std::string& name : option.names)
        patterns.push_back(fmt::format("'{} {}'", command.name, name));
      const std::vector<std::string> words = choices(option);
      const std::string reply =
          !words.empty()
              ? fmt::format("COMPREPLY=($(compgen -W '{}' -- \"$word\"))", joined(words, " "))
          : takes_file(option) ? std::string("COMPREPLY=($(compgen -f -- \"$word\"))")
                               : std::string(":");
      script += fmt::format("    {}) {}; return ;;\n", joined(patterns, "|"), reply);
    }
  script += "  esac\n  if [[ $word == -* ]]; then\n    case \"${COMP_WORDS[1]}\" in\n";
  for (const CommandFacts& command : commands) {
    std::vector<std::string> names;
    for (const OptionFacts& option : command.options)
      if (!option.positional) names.insert(names.end(), option.names.begin(), option.names.end());
    script += fmt::format("      {}) COMPREPLY=($(compgen -W '{}' -- \"$word\")) ;;\n",
                          command.name, joined(names, " "));
  }
  return script + "    esac\n  else\n    COMPREPLY=($(compgen -f -- \"$word\"))\n  fi\n}\n"
                  "complete -o filenames -F _abbe abbe\n";
}

std::string zsh_completion(std::span<const CommandFacts> commands) {
  // _arguments takes brackets and colons of its lines for marks of its own.
  const auto safe = [](std::string_view text) {
    std::string result;
    for (const char c : text) {
      if (c == '[' || c == ']' || c == ':') result += '\\';
      result += c;
    }
    return result;
  };
  std::string script = "#compdef abbe\n# Completion of abbe for zsh, made by: abbe manual zsh\n"
                       "_abbe() {\n  local -a commands=(\n";
  for (const CommandFacts& command : commands)
    script += fmt::format("    {}\n", in_quotes(fmt::format("{}:{}", command.name, command.help)));
  script += "  )\n  if (( CURRENT == 2 )); then\n    _describe command commands\n    return\n  fi\n"
            "  local command=$words[2]\n  shift words\n  (( CURRENT-- ))\n  case $command in\n";
  for (const CommandFacts& command : commands) {
    script += fmt::format("    {}) _arguments", command.name);
    for (const OptionFacts& option : command.options) {
      if (option.positional) continue;
      const std::vector<std::string> words = choices(option);
      const std::string action = !words.empty()       ? fmt::format("({})", joined(words, " "))
                                 : takes_file(option) ? std::string("_files")
                                                      : std::string(" ");
      const std::string value =
          option.value.empty() ? "" : fmt::format(":{}:{}", safe(option.value), action);
      for (const std::string& name : option.names)
        script += fmt::format(" \\\n      {}",
                              in_quotes(fmt::format("{}[{}]{}", name, safe(option.help), value)));
    }
    script += " \\\n      '*:file:_files' ;;\n";
  }
  return script + "  esac\n}\n_abbe \"$@\"\n";
}

std::string fish_completion(std::span<const CommandFacts> commands) {
  // Between fish's single quotes a backslash may stand before a quote, and nowhere else here.
  const auto text = [](std::string_view words) {
    std::string result = "'";
    for (const char c : words) {
      if (c == '\'' || c == '\\') result += '\\';
      result += c;
    }
    return result + "'";
  };
  std::string script = "# Completion of abbe for fish, made by: abbe manual fish\n";
  for (const CommandFacts& command : commands) {
    script += fmt::format("complete -c abbe -n __fish_use_subcommand -f -a {} -d {}\n",
                          command.name, text(command.help));
    for (const OptionFacts& option : command.options) {
      if (option.positional) continue;
      script += fmt::format("complete -c abbe -n '__fish_seen_subcommand_from {}'", command.name);
      for (const std::string& name : option.names)
        script += name.starts_with("--") ? fmt::format(" -l {}", name.substr(2))
                                         : fmt::format(" -s {}", name.substr(1));
      const std::vector<std::string> words = choices(option);
      if (!words.empty())
        script += fmt::format(" -x -a '{}'", joined(words, " "));
      else if (takes_file(option))
        script += " -r";
      else if (!option.value.empty())
        script += " -x";
      script += fmt::format(" -d {}\n", text(option.help));
    }
  }
  return script;
}

} // namespace abbe
