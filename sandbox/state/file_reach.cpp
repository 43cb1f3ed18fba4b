#include "state/file_reach.h"

#include <algorithm>

#include "state/scene.h"

namespace viewing {

namespace fs = std::filesystem;

namespace {

bool is_within(const fs::path& file, const fs::path& place) {
    return std::mismatch(place.begin(), place.end(), file.begin(), file.end()).first == place.end();
}

}  // namespace

fs::path resolved(const fs::path& path) {
    std::error_code error;
    const fs::path absolute = fs::absolute(path, error);
    const fs::path followed = fs::weakly_canonical(absolute, error);
    return error ? absolute.lexically_normal() : followed;
}

void FileReach::add(const FileReach& other) {
    is_everywhere = is_everywhere || other.is_everywhere;
    places.insert(places.end(), other.places.begin(), other.places.end());
}

bool FileReach::includes(const fs::path& file) const {
    if (is_everywhere) return true;
    const fs::path real = resolved(file);
    const fs::path assets = assets_directory();
    if (!assets.empty() && is_within(real, resolved(assets))) return true;
    return std::any_of(places.begin(), places.end(), [&](const fs::path& place) { return is_within(real, place); });
}

FileReach reach_of_folder(const fs::path& folder) {
    FileReach reach{false, {}};
    reach.add(folder.empty() ? fs::path(".") : folder);
    return reach;
}

}  // namespace viewing
