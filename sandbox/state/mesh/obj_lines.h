// Internal to state/: what an OBJ file says, line by line. Read by hand and not by a library: Debian's take what is not
// a number for 0, know no line numbers and cannot be stopped.
#pragma once

#include <cstdint>
#include <istream>
#include <vector>

#include "geometry/mesh.h"
#include "platform/progress.h"
#include "text/result.h"

namespace viewing {

/// One corner of a face: indices from 0.
struct ObjCorner {
    static constexpr int no_normal = -1;
    int position;
    int normal;
};

/// Faces that follow one another and have as many corners each.
struct ObjFaces {
    std::uint32_t corners_each, count;
};

/// The "v", "vn" and "f" lines of a file; all others are ignored.
struct ObjContent {
    std::vector<glm::vec3> positions, normals;
    std::vector<ObjCorner> corners;  ///< of all faces; they name positions and normals that there are
    std::vector<ObjFaces> faces;
    std::uint64_t face_count = 0;
    std::uint64_t triangle_count = 0;
};

/// Reads to the end, to the first line that is wrong, or until it is cancelled; the time is proportional to the file's
/// length. Errors name the line or the face: "line 3: not a number: 1.2.3". `size_bytes` scales the progress and what
/// is set aside.
Result<ObjContent> read_obj_lines(std::istream& stream, std::uint64_t size_bytes, WorkProgress* progress);

}  // namespace viewing
