#include "io/commands/selftest_command.h"

#include "io/console/exit_codes.h"
#include "io/console/terminal.h"
#include "io/selftest/selftest.h"

#include <CLI/CLI.hpp>

namespace abbe {

void add_options(CLI::App& app, SelftestCommand& command) {
  app.add_flag("--json", command.json, "The same for programs, as JSON");
}

int run(const SelftestCommand& command) {
  return tell(run_selftest(), command.json);
}

int tell(const SelftestRows& rows, bool json) {
  say(json ? selftest_json(rows) : selftest_table(rows));
  return failures(rows) == 0 ? 0 : kExitFailure;
}

} // namespace abbe
