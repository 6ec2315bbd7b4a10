#pragma once

#include "core/scene/reach.h"
#include "io/text/read_error.h"

#include <string>

namespace abbe {

/// Throws ReadError where something reaches farther from the origin than rays can be followed.
/// `what` names it: "the eye".
void check_reach(const SourcePosition& where, const std::string& what, double reach);

} // namespace abbe
