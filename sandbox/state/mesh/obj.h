// Internal to state/: reads Wavefront OBJ from a stream. load_obj() of scene.h opens the file.
#pragma once

#include <cstdint>
#include <istream>
#include <string>

#include "state/scene.h"

namespace viewing {

inline constexpr std::uint64_t max_obj_bytes = 4ULL << 30U;
inline constexpr std::uint64_t max_obj_triangles = 50'000'000;

/// Works like load_obj(). `name` starts every message; `size_bytes` affects only the reported progress and the amount
/// of memory reserved.
Result<ObjMesh> read_obj(std::istream& stream, std::uint64_t size_bytes, const std::string& name,
                         const MeshReading& reading, WorkProgress* progress);

}  // namespace viewing
