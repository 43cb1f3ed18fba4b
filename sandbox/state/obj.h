// Internal to state/: reading Wavefront OBJ from a stream. load_obj() of scene.h opens the file.
#pragma once

#include <cstdint>
#include <istream>
#include <string>

#include "geometry/mesh.h"
#include "state/scene.h"
#include "text/result.h"

namespace viewing {

inline constexpr std::uint64_t max_obj_bytes = 4ULL << 30U;
inline constexpr std::uint64_t max_obj_triangles = 50'000'000;

/// A part of a longer job: what is done of it is shown between `begin` and `end`.
struct ProgressSpan {
    LoadProgress* progress = nullptr;
    float begin = 0.0F, end = 1.0F;

    void show(double fraction) const;
    bool cancelled() const;
};

/// Reads a mesh, centred and scaled to fit. `name` opens every message; `size_bytes` only scales the progress.
Result<Mesh> read_obj(std::istream& stream, std::uint64_t size_bytes, const std::string& name,
                      const ProgressSpan& progress);

/// load_obj() with a part of the progress.
Result<Mesh> load_obj_file(const std::filesystem::path& file, const ProgressSpan& progress);

}  // namespace viewing
