#include "topics/matrices/numbers/display_code.h"

#include <algorithm>
#include <cmath>

#include "text/numbers.h"

namespace viewing {
namespace {

/// One of the factors of W.
struct Factor {
    std::string code, comment, part;
};

/// Returns, from left to right, the factors of W, the matrix that replaces this state's V. To undo the camera's motion,
/// their numbers are negated, unless C itself is uploaded.
std::vector<Factor> factors_of(const Params& params) {
    const bool is_camera_itself = params.slips.camera_as_view;
    const double sign = is_camera_itself ? 1.0 : -1.0;
    const char* const minus = is_camera_itself ? "" : "−";
    // Adding 0 keeps −1 · 0 from printing as −0.
    const auto number = [sign](double value, int decimals) { return plain_decimals(0.0 + sign * value, decimals); };
    const CameraParams& camera = params.camera;
    const auto turn = [&](double angle_deg, const char* axis, const char* name, const char* part) -> Factor {
        return {"rotate(radians(" + number(angle_deg, 1) + "), " + axis + ")", std::string(minus) + name, part};
    };
    std::vector<Factor> turns = {turn(camera.yaw, "y", "yaw", "rotate.yaw"),
                                 turn(camera.pitch, "x", "pitch", "rotate.pitch"),
                                 turn(camera.roll, "z", "roll", "rotate.roll")};
    const Factor move = {"translate(" + number(camera.position.x, 2) + ", " + number(camera.position.y, 2) + ", " +
                             number(camera.position.z, 2) + ")",
                         "", "translate"};
    const bool moves_last = params.slips.swapped_order;  // C = R T instead of T R
    turns.insert(moves_last ? turns.end() : turns.begin(), move);
    if (!is_camera_itself) std::reverse(turns.begin(), turns.end());
    return turns;
}

}  // namespace

std::vector<DisplayLine> display_lines(const Params& params, const Derived& derived) {
    const ProjectionParams& projection = params.projection;
    const bool is_infinite = std::isinf(projection.far);
    const std::string near = plain_decimals(projection.near, 3);
    // GLM has no frustum with an infinite far, so a comment gives the limit.
    const std::string range = is_infinite && projection.has_window() ? near + ", f);  // f → ∞"
                              : is_infinite                          ? near + ");"
                                            : near + ", " + plain_decimals(projection.far, 1) + ");";

    std::vector<DisplayLine> lines = {{"void display() {"}};
    if (params.camera_overrides.clip_from_view) {
        lines.push_back({"  P = mat4(…);  // entered by hand", false, "projection"});
    } else if (projection.type == ProjectionType::perspective) {
        const std::string degrees = plain_decimals(projection.fovy, 1);
        const std::string angle = params.slips.degrees_as_radians ? degrees : "radians(" + degrees + ")";
        lines.push_back(
            {(is_infinite ? "  P = infinitePerspective(" : "  P = perspective(") + angle + ",", false, "projection"});
        lines.push_back({"      " + plain_decimals(derived.aspect, 3) + ", " + range, false, "projection"});
    } else {
        const Edges edges = params.lens().edges_at(projection.near, derived.aspect);
        const bool orthographic = projection.is_orthographic();
        const auto pair = [decimals = orthographic ? 2 : 3](double low, double high) {
            return plain_decimals(low, decimals) + ", " + plain_decimals(high, decimals) + ",";
        };
        lines.push_back(
            {(orthographic ? "  P = ortho(" : "  P = frustum(") + pair(edges.left, edges.right), false, "projection"});
        lines.push_back({"      " + pair(edges.bottom, edges.top) + " " + range, false, "projection"});
    }
    lines.push_back({"  V = mat4(1);  // move the world instead:"});
    if (params.camera_overrides.view_from_world) lines.push_back({"  W = mat4(…);  // entered by hand", true});
    const std::vector<Factor> factors =
        params.camera_overrides.view_from_world ? std::vector<Factor>() : factors_of(params);
    for (std::size_t i = 0; i < factors.size(); ++i) {
        const std::string& comment = factors[i].comment;
        lines.push_back({(i == 0 ? "  W = " : "    * ") + factors[i].code + (i + 1 == factors.size() ? ";" : "") +
                             (comment.empty() ? "" : "  // " + comment),
                         true, factors[i].part});
    }
    lines.push_back({"  drawObjects();  // with P V W"});
    lines.push_back({"}"});
    return lines;
}

}  // namespace viewing
