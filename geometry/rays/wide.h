#pragma once

namespace abbe {

/// Four doubles that one instruction works on: the coordinates of a point or vector; the fourth has
/// no meaning.
using Wide = double __attribute__((vector_size(32)));

} // namespace abbe
