#include "core/scene/user_error.h"
#include "io/console/exit_codes.h"
#include "io/console/terminal.h"
#include "io/program/command_line.h"
#include "io/text/read_error.h"

#include <fmt/format.h>

#include <stdexcept>

namespace {

using namespace abbe;

int run_and_tell(int argc, char** argv) {
  try {
    return std::visit([](const auto& command) { return run(command); },
                      parse_command_line(argc, argv));
  } catch (const ReadError& error) {
    say_error(error.what());
    return kExitUsage;
  } catch (const UserError& error) {
    say_error(fmt::format("abbe: {}", error.what()));
    return kExitUsage;
  } catch (const std::logic_error& error) { // no input should get here
    say_error(fmt::format("abbe: internal error: {}", error.what()));
    return kExitFailure;
  } catch (const std::exception& error) {
    say_error(fmt::format("abbe: {}", error.what()));
    return kExitFailure;
  }
}

} // namespace

int main(int argc, char** argv) {
  open_standard_streams();
  const int code = run_and_tell(argc, argv);
  if (all_was_said()) return code;
  say_error("abbe: standard output cannot be written");
  return code == 0 ? kExitFailure : code;
}
