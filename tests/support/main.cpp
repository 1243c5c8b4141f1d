// The entry point shared by every doctest runner. Both names: the first is enough only where the header has
// not been precompiled without them.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>
