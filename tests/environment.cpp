// Linked into every test program: where the assets, the program and the tests lie, unless the environment says so
// already. A test program needs no other set-up, whether ctest starts it or a person. Shaders are compiled anew in
// every test, what an earlier run left in Mesa's cache decides nothing, and quickly, as the headless commands do.
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
