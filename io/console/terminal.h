#pragma once

#include <string>
#include <string_view>

namespace abbe {

/// Makes sure that the three standard streams are open, so that no file of ours takes the place of
/// one that the caller has closed.
void open_standard_streams();

/// From now on a reader of our output who goes away does not end the program, whose work would be
/// lost.
void outlive_readers();

/// Tells a line on standard output. What cannot be said is left unsaid; see `all_was_said`.
void say(std::string_view line);
/// The same on standard error.
void say_error(std::string_view line);
/// A warning on standard error; none where the message is empty.
void say_warning(std::string_view message);
/// Writes to standard error as it is, and at once.
void put_error(std::string_view text);

/// False when something could not be written to standard output. Flushes it.
[[nodiscard]] bool all_was_said();

/// The text with control characters, which could command a terminal, as \x1b and the like. Line
/// feeds and tabs stay.
[[nodiscard]] std::string escaped(std::string_view text);

} // namespace abbe
