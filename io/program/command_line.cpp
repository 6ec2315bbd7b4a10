#include "io/program/command_line.h"

#include "geometry/world/world.h"
#include "io/console/exit_codes.h"
#include "io/states/state_info.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <functional>
#include <memory>

namespace abbe {
namespace {

/// A command that can be given, and what it is when its options have been read.
struct Entry {
  CLI::App* app;
  std::function<Command(const CLI::App&)> command;
};

std::vector<std::string> given_options(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    if (option->count() > 0) names.push_back(option->get_name());
  return names;
}

OptionFacts facts_of(const CLI::Option& option) {
  OptionFacts facts{{}, option.get_type_name(), option.get_description(), false};
  for (const std::string& name : option.get_snames())
    facts.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames())
    facts.names.push_back("--" + name);
  facts.positional = facts.names.empty();
  if (facts.positional) facts.names.push_back(option.get_name());
  return facts;
}

std::vector<CommandFacts> facts_of(const CLI::App& program) {
  std::vector<CommandFacts> commands;
  for (const CLI::App* app : program.get_subcommands([](const CLI::App*) { return true; })) {
    CommandFacts& command =
        commands.emplace_back(CommandFacts{app->get_name(), app->get_description(), {}});
    for (const CLI::Option* option : app->get_options())
      command.options.push_back(facts_of(*option));
  }
  return commands;
}

template <class Kind>
void add_command(CLI::App& app, std::vector<Entry>& entries) {
  if constexpr (requires { Kind::kName; }) {
    CLI::App* const own = app.add_subcommand(Kind::kName, Kind::kHelp);
    const auto kind = std::make_shared<Kind>();
    add_options(*own, *kind);
    entries.push_back({own, [kind]([[maybe_unused]] const CLI::App& parsed) {
                         if constexpr (requires { kind->given; })
                           kind->given = given_options(parsed);
                         if constexpr (requires { kind->commands; })
                           kind->commands = facts_of(*parsed.get_parent());
                         return Command(*kind);
                       }});
  }
}

template <class... Kinds>
std::vector<Entry> add_commands(CLI::App& app, const std::variant<Kinds...>*) {
  std::vector<Entry> entries;
  (add_command<Kinds>(app, entries), ...);
  return entries;
}

} // namespace

Command parse_command_line(int argc, const char* const* argv) {
  CLI::App app("abbe renders light through glass: every path carries all wavelength bands.",
               "abbe");
  app.set_version_flag("--version",
                       fmt::format("abbe {} (Embree {})", program_version(), embree_version()));
  app.require_subcommand(1);
  app.failure_message(CLI::FailureMessage::simple);
  const std::vector<Entry> entries = add_commands(app, static_cast<const Command*>(nullptr));
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return Answered{app.exit(error) == 0 ? 0 : kExitUsage};
  }
  for (const Entry& entry : entries)
    if (entry.app->parsed()) return entry.command(*entry.app);
  return Answered{kExitUsage}; // not reached: one command is required
}

} // namespace abbe
