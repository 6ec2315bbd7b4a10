#pragma once

#include "core/film/film.h"

namespace abbe {

/// Adds what another film holds. Exact, and the same in any order, for films whose samples differ.
/// Sums that would overflow stay as they are and count as refused. Errors: std::invalid_argument,
/// which says in what the films do not fit together.
void merge(Film& film, const Film& other);

} // namespace abbe
