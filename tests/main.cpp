// Catch2 2 wants its main function compiled here; Catch2 3 links one.
#if !__has_include(<catch2/catch_test_macros.hpp>)
#define CATCH_CONFIG_MAIN
#include <catch2/catch.hpp>
#endif

#include "geometry/rays/float_traps.h"

#ifdef ABBE_TRAPS
namespace {
/// From before main on. Threads that the tests begin inherit it.
const abbe::FloatTraps traps_on(true);
} // namespace
#endif
