#include "cli/results/explained_text.h"

#include <cmath>
#include <vector>

#include "report/as_json.h"
#include "text/numbers.h"
#include "topics/camera/numbers/look_at_text.h"
#include "topics/matrices/numbers/fault_words.h"
#include "topics/matrices/numbers/take_matrix.h"

namespace viewing {
namespace {

constexpr int digits = 6;

std::string text_of(double value) {
    return figures(value, digits);
}
/// Leaves out what only rounding makes different from 0, beside numbers of this size.
std::string text_of(double value, double size) {
    constexpr double rounding = 1e-12;
    return text_of(std::abs(value) < rounding * size ? 0.0 : value);
}
template <int count>
std::string text_of(const glm::vec<count, double>& v) {
    std::string text;
    for (int i = 0; i < count; ++i) text += (i == 0 ? "(" : ", ") + text_of(v[i], glm::length(v));
    return text + ")";
}
std::string degrees_text(double angle_deg) {
    return text_of(angle_deg, 180.0) + "°";
}

std::string depth_text(const FoundLens& lens) {
    const bool is_reversed = lens.near > lens.far;
    const double near = is_reversed ? lens.far : lens.near, far = is_reversed ? lens.near : lens.far;
    std::string text = "near " + text_of(near) + ", far " + (std::isinf(far) ? "infinite" : text_of(far));
    text += lens.zero_to_one ? ", clip range 0 … 1" : ", clip range −1 … 1";
    return text + (is_reversed ? ", reversed" : "");
}

std::string edges_text(const FoundLens& lens) {
    const Edges& edges = lens.edges;
    return "left " + text_of(edges.left) + ", right " + text_of(edges.right) + ", bottom " + text_of(edges.bottom) +
           ", top " + text_of(edges.top);
}

/// Describes the matrix's parts in sentences.
std::vector<std::string> contents(const ExplainedMatrix& found) {
    std::vector<std::string> lines;
    if (found.camera) {
        lines.push_back("eye " + text_of(found.camera->eye) + ", looking along " +
                        text_of(found.camera->center - found.camera->eye) + ", up " + text_of(found.camera->up));
        lines.push_back("yaw " + degrees_text(found.angles.yaw_deg) + ", pitch " +
                        degrees_text(found.angles.pitch_deg) + ", roll " + degrees_text(found.angles.roll_deg));
    }
    if (found.fault == MatrixFault::scaled) lines.push_back("lengths of the axes " + text_of(found.scale));
    if (found.lens) {
        const FoundLens& lens = *found.lens;
        lines.push_back((lens.orthographic ? "orthographic, height " + text_of(lens.height)
                                           : "perspective, fovy " + text_of(lens.fovy_deg) + "°") +
                        ", aspect " + text_of(lens.aspect) + ", " + depth_text(lens) +
                        (lens.off_center ? ", off-center: " + edges_text(lens) : ""));
    }
    if (found.found_plane) lines.push_back("plane " + text_of(*found.found_plane));
    if (found.found_light)
        lines.push_back((found.found_light->w == 0.0 ? "parallel light from " : "point light ") +
                        text_of(*found.found_light));
    return lines;
}

std::vector<std::string> verdict(const PastedMatrix& pasted, const ExplainedMatrix& found) {
    const FaultWords words = fault_words(found);
    std::vector<std::string> lines;
    const std::string off = "; the largest difference from the state's " + std::string(1, found.letter) +
                            (found.letter == 'S' ? ", apart from a factor, is " : " is ") + text_of(found.off);
    if (is_misnamed(pasted.letter, found)) {
        lines.push_back(std::string("wrong: its name says ") + pasted.letter + ", but it is " +
                        (found.fault == MatrixFault::none ? "the state's " : "a ") + found.letter);
    } else if (found.fault == MatrixFault::none) {
        lines.push_back("right: it is the state's " + std::string(1, found.letter));
        if (found.letter == 'C') lines.push_back("where V belongs, use its inverse");
    } else if (found.fault == MatrixFault::different) {
        lines.push_back("well formed, but not the state's" + off);
    } else if (found.fault == MatrixFault::unknown) {
        lines.push_back("wrong: " + std::string(words.wrong));
    } else {
        lines.push_back("wrong: " + std::string(words.wrong) + (found.right ? off : ""));
        lines.push_back("fix: " + std::string(words.fix));
    }
    if (pasted.has_more) lines.push_back("more numbers follow: only the first matrix is explained");
    return lines;
}

std::string reading(const PastedMatrix& pasted) {
    return std::string("read as ") + (pasted.by_columns ? "columns" : "rows") + " (" + pasted.syntax + ")";
}

Json finite_or_null(double value) {
    return std::isfinite(value) ? Json(value) : Json();
}

}  // namespace

std::string explained_text(const PastedMatrix& pasted, const ExplainedMatrix& found, const ExplainedMatrix& own) {
    std::string text = std::string(matrix_title(found.letter)) + ", " + reading(pasted) + "\n";
    for (const std::string& line : contents(found)) text += "  " + line + "\n";
    for (const std::string& line : verdict(pasted, found)) text += "  " + line + "\n";
    const std::vector<std::string> state = contents(own);
    if (state == contents(found)) return text;
    for (const std::string& line : state) text += "  the state has: " + line + "\n";
    return text;
}

Json explained_json(const PastedMatrix& pasted, const ExplainedMatrix& found) {
    const bool is_wrong = is_misnamed(pasted.letter, found) ||
                          (found.fault != MatrixFault::none && found.fault != MatrixFault::different);
    Json json{{"matrix", found.letter == 0 ? Json() : Json(std::string(1, found.letter))},
              {"fault", is_misnamed(pasted.letter, found) ? "misnamed" : fault_words(found).name},
              {"wrong", is_wrong},
              {"read_as", pasted.by_columns ? "columns" : "rows"},
              {"syntax", pasted.syntax}};
    json["say"] = verdict(pasted, found);
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
