// This file is linked into every test program. It sets the locations of the assets, the program and the tests, unless
// the environment already sets them. No other setup is needed, whether ctest or a user starts the program. Every test
// compiles its shaders anew, with the fast settings of the headless commands, so that no result depends on what an
// earlier run left in Mesa's cache.
#include <cstdlib>

namespace {

[[maybe_unused]] const bool is_set = [] {
    setenv("VIEWING_SANDBOX_ASSETS", VIEWING_TEST_ASSETS, 0);
    setenv("VIEWING_SANDBOX", VIEWING_TEST_PROGRAM, 0);
    setenv("TEST_SOURCE_DIR", VIEWING_TEST_SOURCES, 0);
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 0);
    setenv("GALLIVM_PERF", "nopt", 0);
    setenv("LP_NATIVE_VECTOR_WIDTH", "128", 0);
    return true;
}();

}  // namespace
