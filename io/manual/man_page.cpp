#include "io/manual/man_page.h"

#include <fmt/format.h>

#include <string_view>

namespace abbe {
namespace {

/// The text with what man(7) would take for marks of its own made plain.
std::string plain(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\') {
      result += "\\e";
    } else if (c == '-') {
      result += "\\-"; // a minus, which can be copied into a shell, and no hyphen
    } else if ((c == '.' || c == '\'') && result.empty()) {
      result += "\\&";
      result += c;
    } else {
      result += c;
    }
  }
  return result;
}

void add_option(std::string& page, const OptionFacts& option) {
  page += ".TP\n";
  for (std::size_t i = 0; i < option.names.size(); ++i)
    page += fmt::format("{}\\fB{}\\fR", i == 0 ? "" : ", ", plain(option.names[i]));
  if (!option.value.empty() && !option.positional)
    page += fmt::format(" \\fI{}\\fR", plain(option.value));
  page += fmt::format("\n{}\n", plain(option.help));
}

} // namespace

std::string man_page(std::span<const CommandFacts> commands, const std::string& version) {
  std::string page = fmt::format(".TH ABBE 1 \"\" \"abbe {}\" \"User Commands\"\n", version);
  page += ".SH NAME\nabbe \\- render light through glass, with all wavelength bands\n"
          ".SH SYNOPSIS\n.B abbe\n.I COMMAND\n[\\fIOPTION\\fR ...] [\\fIFILE\\fR ...]\n"
          ".SH DESCRIPTION\nabbe renders scenes with prisms, lenses, gems and drops. Every path of "
          "light carries all wavelength bands from 380 to 780 nm, and glass bends each of them by "
          "its own index. Pictures are written as EXR, TIFF or PNG.\n.SH COMMANDS\n";
  for (const CommandFacts& command : commands) {
    page += fmt::format(".SS abbe {}\n{}.\n", plain(command.name), plain(command.help));
    for (const OptionFacts& option : command.options)
      add_option(page, option);
  }
  page += ".SH EXIT STATUS\n0 where all went well, 2 where the command line or a scene has a "
          "mistake, 1 where anything else "
          "fails or a comparison finds a difference, 130 after Ctrl\\-C.\n"
          ".SH EXAMPLES\n.EX\nabbe render lens.sdl \\-o lens.exr \\-\\-spp 64\n"
          "abbe pixel lens.exr 200 180\n.EE\n";
  return page;
}

} // namespace abbe
