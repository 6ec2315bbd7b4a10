#include "io/outputs/write_each.h"

#include "io/console/terminal.h"

#include <fmt/format.h>

#include <exception>

namespace abbe {

bool write_each(const std::vector<OutputJob>& jobs, bool quiet) {
  bool all = true;
  for (const OutputJob& job : jobs) {
    try {
      const std::string note = job.write();
      if (!quiet) say(fmt::format("wrote {}", job.path.string()));
      if (!note.empty()) say_error("warning: " + note);
    } catch (const std::exception& error) {
      say_error(fmt::format("abbe: {}", error.what()));
      all = false;
    }
  }
  return all;
}

} // namespace abbe
