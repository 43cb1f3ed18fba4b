// Where the assets directory is.
#include <cstdlib>

#include "state/scene.h"

namespace viewing {

std::filesystem::path assets_directory() {
    namespace fs = std::filesystem;
    std::error_code error;
    if (const char* chosen = std::getenv("VIEWING_SANDBOX_ASSETS"); chosen != nullptr && *chosen != '\0') {
        return fs::is_directory(chosen, error) ? fs::path(chosen) : fs::path();
    }
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    if (error) {
        return {};
    }
    const fs::path beside = program.parent_path();
    for (const fs::path& candidate : {beside / "assets", beside.parent_path() / "share" / "viewing-sandbox"}) {
        if (fs::is_directory(candidate, error)) {
            return candidate;
        }
    }
    return {};
}

}  // namespace viewing
