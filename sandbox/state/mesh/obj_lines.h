// Internal to state/: what an OBJ file says, line by line. Read by hand and not by a library: Debian's take what is not
// a number for 0, know no line numbers and cannot be stopped.
#pragma once

#include <cstdint>
#include <istream>
#include <string>
#include <vector>

#include "geometry/mesh.h"
#include "platform/progress.h"
#include "state/mesh/statement_lines.h"
#include "text/result.h"

namespace viewing {

/// One corner of a face: indices from 0.
struct ObjCorner {
    static constexpr int no_normal = -1;
    int position;
    int normal;
};

/// Faces that follow one another, have as many corners each and belong to one smoothing group.
struct ObjFaces {
    static constexpr int no_statement = -1;  ///< no "s" line stands before them
    static constexpr int smoothing_off = 0;
    std::uint32_t corners_each, count;
    int smoothing;
};

/// What can be shaded of a file, and how much of it cannot.
struct ObjContent {
    std::vector<glm::dvec3> positions;
    std::vector<glm::vec3> normals;  ///< of length 1; 0 where the line gives no direction
    std::vector<ObjCorner> corners;  ///< of all faces; they name usable positions and normals with a direction
    std::vector<ObjFaces> faces;
    StatementLines position_lines, normal_lines, face_lines;
    std::uint64_t triangle_count = 0;
    std::uint64_t line_count = 0, point_count = 0, surface_count = 0;  ///< statements that are left out
    std::vector<std::string> notes;  ///< what was left out or replaced, a sentence each
};

/// Reads to the end, to the first line that is wrong, or until it is cancelled; the time is proportional to the file's
/// length. Lines end with LF, CR or both; one that ends with \ goes on in the next. What no face uses may hold
/// anything. Errors and notes name the line: "line 3: not a number: 1.2.3". `size_bytes` scales the progress and what
/// is set aside.
Result<ObjContent> read_obj_lines(std::istream& stream, std::uint64_t size_bytes, WorkProgress* progress);

}  // namespace viewing
