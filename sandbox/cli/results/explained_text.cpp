#include "cli/results/explained_text.h"

#include <cmath>
#include <vector>

#include "frame/look_at_text.h"
#include "report/as_json.h"
#include "text/numbers.h"

namespace viewing {
namespace {

constexpr int digits = 6;

std::string text_of(double value) {
    return figures(value, digits);
}
std::string text_of(const glm::dvec3& v) {
    return "(" + text_of(v.x) + ", " + text_of(v.y) + ", " + text_of(v.z) + ")";
}
std::string text_of(const glm::dvec4& v) {
    return "(" + text_of(v.x) + ", " + text_of(v.y) + ", " + text_of(v.z) + ", " + text_of(v.w) + ")";
}

const char* title_of(char letter) {
    switch (letter) {
        case 'V':
            return "V, view_from_world";
        case 'C':
            return "C, world_from_view: the camera's model matrix";
        case 'P':
            return "P, clip_from_view";
        case 'S':
            return "S, shadow_from_world";
        case 'R':
            return "R, mirror_from_world";
        default:
            return "none of V, C, P, S, R";
    }
}

/// The fault's name in JSON, what is wrong, and the fix.
struct FaultWords {
    const char* name;
    const char* wrong;
    const char* fix;
};

FaultWords words_of(const ExplainedMatrix& found) {
    const bool is_camera = found.letter == 'V' || found.letter == 'C';
    switch (found.fault) {
        case MatrixFault::none:
            return {"none", "", ""};
        case MatrixFault::inverse:
            return found.letter == 'V' ? FaultWords{"inverse", "this is C, the camera's model matrix, where V belongs",
                                                    "V = C⁻¹: transpose the 3×3 part, and use −Rᵀ eye as translation"}
                                       : FaultWords{"inverse", "this is V where C belongs", "C = V⁻¹"};
        case MatrixFault::transposed:
            return {"transposed", "rows and columns are swapped",
                    "transpose it: GLM and OpenGL read columns first, NumPy, MATLAB and the slides write rows"};
        case MatrixFault::translation_in_row:
            return {"translation_in_row", "the translation is in the last row, which makes w depend on the point",
                    "put the translation into the last column; the last row is (0, 0, 0, 1)"};
        case MatrixFault::scaled:
            return {"scaled", "its axes do not have length 1",
                    "leave the scale out of the camera, or normalize right, up and back"};
        case MatrixFault::left_handed:
            return is_camera ? FaultWords{"left_handed", "it is left-handed: det = −1, which mirrors the picture",
                                          "negate the third row of V (the third column of C): OpenGL looks along −z"}
                             : FaultWords{"left_handed", "it is left-handed: w = z, so it shows what is behind the eye",
                                          "negate the third column: in OpenGL, w = −z"};
        case MatrixFault::looks_back:
            return {"looks_back", "right and back are negated: the camera looks the opposite way, as lookAtLH makes it",
                    "negate the first and the third row (lookAtRH)"};
        case MatrixFault::degrees:
            return {"degrees", "fovy is in degrees where radians belong", "use glm::radians(fovy)"};
        case MatrixFault::inverse_aspect:
            return {"inverse_aspect", "the aspect ratio is height ÷ width", "use width ÷ height"};
        case MatrixFault::zero_to_one:
            return {"zero_to_one", "it maps near … far to 0 … 1, but the state's clip range is −1 … 1",
                    "use perspectiveRH_NO, or leave GLM_FORCE_DEPTH_ZERO_TO_ONE out"};
        case MatrixFault::minus_one_to_one:
            return {"minus_one_to_one", "it maps near … far to −1 … 1, but the state's clip range is 0 … 1",
                    "use perspectiveRH_ZO with far and near swapped"};
        case MatrixFault::reversed:
            return {"reversed", "near and far are swapped, unlike in the state", "swap near and far"};
        case MatrixFault::other_light:
            return {"other_light", "it is the shadow of another light on the state's plane", "use the state's light"};
        case MatrixFault::other_plane:
            return {"other_plane", "it belongs to another plane", "use the state's plane, divided by |n|"};
        case MatrixFault::not_unit_normal:
            return {"not_unit_normal", "its normal is not a unit vector", "divide (a, b, c, d) by |n| first"};
        case MatrixFault::plus_2ab:
            return {"plus_2ab", "row 2, column 1 is +2ab, as in one line of the slide", "it is −2ab"};
        case MatrixFault::different:
            return {"different", "", ""};
        case MatrixFault::unknown:
            break;
    }
    return {"unknown", "its structure is that of none of the lecture's matrices", ""};
}

std::string depth_text(const FoundLens& lens) {
    const bool is_reversed = lens.near > lens.far;
    const double near = is_reversed ? lens.far : lens.near, far = is_reversed ? lens.near : lens.far;
    std::string text = "near " + text_of(near) + ", far " + (std::isinf(far) ? "infinite" : text_of(far));
    text += lens.zero_to_one ? ", clip range 0 … 1" : ", clip range −1 … 1";
    return text + (is_reversed ? ", reversed" : "");
}

/// Returns what the matrix holds, as sentences.
std::vector<std::string> contents(const ExplainedMatrix& found) {
    std::vector<std::string> lines;
    if (found.camera) {
        lines.push_back("eye " + text_of(found.camera->eye) + ", looking along " +
                        text_of(found.camera->center - found.camera->eye) + ", up " + text_of(found.camera->up));
        lines.push_back("yaw " + text_of(found.angles.yaw_deg) + "°, pitch " + text_of(found.angles.pitch_deg) +
                        "°, roll " + text_of(found.angles.roll_deg) + "°");
    }
    if (found.fault == MatrixFault::scaled) lines.push_back("lengths of the axes " + text_of(found.scale));
    if (found.lens) {
        const FoundLens& lens = *found.lens;
        lines.push_back((lens.orthographic ? "orthographic, height " + text_of(lens.height)
                                           : "perspective, fovy " + text_of(lens.fovy_deg) + "°") +
                        ", aspect " + text_of(lens.aspect) + ", " + depth_text(lens) +
                        (lens.off_center ? ", off-center" : ""));
    }
    if (found.found_plane) lines.push_back("plane " + text_of(*found.found_plane));
    if (found.found_light)
        lines.push_back((found.found_light->w == 0.0 ? "parallel light from " : "point light ") +
                        text_of(*found.found_light));
    return lines;
}

std::vector<std::string> verdict(const ExplainedMatrix& found) {
    const FaultWords words = words_of(found);
    std::vector<std::string> lines;
    const std::string off = "; the largest difference from the state's " + std::string(1, found.letter) +
                            (found.letter == 'S' ? ", apart from a factor, is " : " is ") + text_of(found.off);
    if (found.fault == MatrixFault::none) {
        lines.push_back("right: it is the state's " + std::string(1, found.letter));
        if (found.letter == 'C') lines.push_back("where V belongs, use its inverse");
    } else if (found.fault == MatrixFault::different) {
        lines.push_back("well formed, but not the state's" + off);
    } else if (found.fault == MatrixFault::unknown) {
        lines.push_back("wrong: " + std::string(words.wrong));
    } else {
        lines.push_back("wrong: " + std::string(words.wrong) + off);
        lines.push_back("fix: " + std::string(words.fix));
    }
    return lines;
}

std::string reading(const PastedMatrix& pasted) {
    return std::string("read as ") + (pasted.by_columns ? "columns" : "rows") + " (" + pasted.syntax + ")";
}

Json finite_or_null(double value) {
    return std::isfinite(value) ? Json(value) : Json();
}

}  // namespace

bool is_wrong(const ExplainedMatrix& found) {
    return found.fault != MatrixFault::none && found.fault != MatrixFault::different;
}

std::string explained_text(const PastedMatrix& pasted, const ExplainedMatrix& found, const ExplainedMatrix& own) {
    std::string text = std::string(title_of(found.letter)) + ", " + reading(pasted) + "\n";
    for (const std::string& line : contents(found)) text += "  " + line + "\n";
    for (const std::string& line : verdict(found)) text += "  " + line + "\n";
    const std::vector<std::string> state = contents(own);
    if (state == contents(found)) return text;
    for (const std::string& line : state) text += "  the state has: " + line + "\n";
    return text;
}

Json explained_json(const PastedMatrix& pasted, const ExplainedMatrix& found) {
    Json json{{"matrix", found.letter == 0 ? Json() : Json(std::string(1, found.letter))},
              {"fault", words_of(found).name},
              {"wrong", is_wrong(found)},
              {"read_as", pasted.by_columns ? "columns" : "rows"},
              {"syntax", pasted.syntax}};
    json["say"] = verdict(found);
    if (found.camera)
        json["camera"] = {{"look_at",
                           {{"eye", as_json(found.camera->eye)},
                            {"center", as_json(found.camera->center)},
                            {"up", as_json(found.camera->up)}}},
                          {"yaw", found.angles.yaw_deg},
                          {"pitch", found.angles.pitch_deg},
                          {"roll", found.angles.roll_deg}};
    if (found.lens) {
        const FoundLens& lens = *found.lens;
        json["projection"] = {{"type", lens.orthographic ? "orthographic" : "perspective"},
                              {lens.orthographic ? "height" : "fovy", lens.orthographic ? lens.height : lens.fovy_deg},
                              {"aspect", lens.aspect},
                              {"near", finite_or_null(lens.near)},
                              {"far", finite_or_null(lens.far)},
                              {"zero_to_one", lens.zero_to_one},
                              {"off_center", lens.off_center}};
    }
    if (found.found_plane) json["plane"] = as_json(*found.found_plane);
    if (found.found_light) json["light"] = as_json(*found.found_light);
    if (found.right) {
        json["off"] = found.off;
        json["right"] = as_json(*found.right);
    }
    return json;
}

}  // namespace viewing
