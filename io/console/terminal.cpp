#include "io/console/terminal.h"

#include <fmt/format.h>

#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <iostream>

namespace abbe {
namespace {

void put(std::FILE* stream, std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stream); // the stream remembers that it failed
}

} // namespace

void open_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(stream, F_GETFD) < 0) {
      // The lowest number that is free, so this one; not for writing, so that writing fails.
      if (::open("/dev/null", O_RDONLY) < 0) return;
    }
}

void outlive_readers() {
  std::signal(SIGPIPE, SIG_IGN);
}

void say(std::string_view line) {
  put(stdout, escaped(line) + '\n');
}

void say_error(std::string_view line) {
  put_error(escaped(line) + '\n');
}

void say_warning(std::string_view message) {
  if (!message.empty()) say_error(fmt::format("warning: {}", message));
}

void put_error(std::string_view text) {
  put(stderr, text);
  std::fflush(stderr);
}

bool all_was_said() {
  std::cout.flush();
  const bool flushed = std::fflush(stdout) == 0;
  return flushed && std::ferror(stdout) == 0 && std::cout.good();
}

std::string escaped(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto code = static_cast<unsigned char>(text[i]);
    const bool plain = (code >= 0x20 && code != 0x7F) || code == '\n' || code == '\t';
    // U+0080 to U+009F, which are C2 80 to C2 9F in UTF-8, command terminals too.
    const bool second = code == 0xC2 && i + 1 < text.size() &&
                        static_cast<unsigned char>(text[i + 1]) >= 0x80 &&
                        static_cast<unsigned char>(text[i + 1]) < 0xA0;
    if (second)
      result += fmt::format("\\x{:02x}", static_cast<unsigned char>(text[++i]));
    else if (plain)
      result += text[i];
    else
      result += fmt::format("\\x{:02x}", code);
  }
  return result;
}

} // namespace abbe
