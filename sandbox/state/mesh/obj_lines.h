// Internal to state/: reads an OBJ file line by line. None of Debian's libraries is suitable: they read anything that
// is not a number as 0, do not report line numbers and cannot be canceled.
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

/// One corner of a face, with indices that count from 0.
struct ObjCorner {
    static constexpr int no_normal = -1;
    int position;
    int normal;
};

/// Consecutive faces with equal corner counts and the same smoothing group.
struct ObjFaces {
    static constexpr int no_statement = -1;  ///< no "s" line precedes them
    static constexpr int smoothing_off = 0;
    std::uint32_t corners_each, count;
    int smoothing;
};

/// The parts of a file that can be shaded, and counts of the parts that are skipped.
struct ObjContent {
    std::vector<glm::dvec3> positions;
    std::vector<glm::vec3> normals;  ///< of length 1; 0 if the line gives no direction
    std::vector<ObjCorner> corners;  ///< of all faces; every position is usable, and no normal is 0
    std::vector<ObjFaces> faces;
    StatementLines position_lines, normal_lines, face_lines;
    std::uint64_t triangle_count = 0;
    std::uint64_t line_count = 0, point_count = 0, surface_count = 0;  ///< skipped statements
    std::vector<std::string> notes;  ///< on skipped or replaced parts, one sentence each
};

/// Reads until the end, the first invalid line, or cancellation, in time proportional to the file's length. Lines end
/// with LF, CR or both; a \ at the end continues the line. Data that no face uses may be invalid. Errors and notes name
/// the line: "line 3: not a number: 1.2.3". `size_bytes` determines the scale of the progress and the amount of memory
/// reserved.
Result<ObjContent> read_obj_lines(std::istream& stream, std::uint64_t size_bytes, WorkProgress* progress);

}  // namespace viewing
