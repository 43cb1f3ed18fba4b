// This file is linked into every test program. It sets the locations of the assets, the program and the tests, unless
// the environment already sets them. No other setup is needed, whether ctest or a user starts the program. Tests
// compile their shaders with the fast settings of the headless commands, and share them in a cache of their build. Each
// width of vectors has its own cache, in case Mesa's key of a shader lacks the width.
#include <cstdlib>
#include <string>

namespace {

[[maybe_unused]] const bool is_set = [] {
    setenv("VIEWING_SANDBOX_ASSETS", VIEWING_TEST_ASSETS, 0);
    setenv("VIEWING_SANDBOX", VIEWING_TEST_PROGRAM, 0);
    setenv("TEST_SOURCE_DIR", VIEWING_TEST_SOURCES, 0);
    setenv("GALLIVM_PERF", "nopt", 0);
    setenv("LP_NATIVE_VECTOR_WIDTH", "128", 0);
    const std::string width = std::getenv("LP_NATIVE_VECTOR_WIDTH");
    setenv("MESA_SHADER_CACHE_DIR", (VIEWING_TEST_SHADERS + width).c_str(), 0);
    return true;
}();

}  // namespace
