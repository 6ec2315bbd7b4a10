#pragma once

namespace abbe::stress {

/// The shares of light that a surface reflects and lets through.
struct Split {
  long double reflected, passed;
};

/// A boundary of two clear media; `sine` is that of the angle on the side the light comes from.
[[nodiscard]] Split boundary_split(long double sine, long double n_before, long double n_after);

/// The same below a film, by the characteristic matrix of the layer [BW99, 1.6].
struct FilmLayer {
  long double index, thickness_nm, lambda_nm;
};
[[nodiscard]] Split filmed_split(long double sine, long double n_before, const FilmLayer& film,
                                 long double n_after);

/// A pane in a medium: the reflections between its faces, added up one by one.
struct PaneLayer {
  long double index, thickness, absorption;
};
[[nodiscard]] Split pane_split(long double sine, long double n_around, const PaneLayer& pane);

} // namespace abbe::stress
