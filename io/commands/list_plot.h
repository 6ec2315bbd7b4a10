#pragma once

#include "io/commands/list_command.h"
#include "io/plots/plot.h"

namespace abbe {

/// The curve that `--plot` names: a light's spectrum, a material's reflectance, a metal's at normal
/// incidence or a glass's n, among what `list` was asked for, else among all, in this order. A
/// library's entry comes before a built-in light, with a warning.
/// Throws UserError, with similar names, when there is none.
[[nodiscard]] Plot find_plot(const ListCommand& command);

/// Draws it to the terminal, or to the PNG that `--plot-file` names.
void list_plot(const ListCommand& command);

/// The library asked for, else the one beside the scenes, where it exists.
[[nodiscard]] std::optional<std::filesystem::path> listed_library(const ListCommand& command,
                                                                  const char* name);

} // namespace abbe
