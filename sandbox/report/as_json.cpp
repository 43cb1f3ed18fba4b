#include "report/as_json.h"

#include "text/numbers.h"
#include "text/per_enum.h"

namespace viewing {

Json as_json(const glm::ivec2& pair) {
    return Json::array({pair.x, pair.y});
}

Json as_json(const glm::dvec3& vector) {
    return Json::array({vector.x + 0.0, vector.y + 0.0, vector.z + 0.0});
}

Json as_json(const glm::dvec4& vector) {
    return Json::array({vector.x + 0.0, vector.y + 0.0, vector.z + 0.0, vector.w + 0.0});
}

Json as_json(const glm::dmat4& matrix) {
    Json rows = Json::array();
    for (glm::length_t row = 0; row < 4; ++row) {
        Json entries = Json::array();
        for (glm::length_t column = 0; column < 4; ++column) entries.push_back(matrix[column][row] + 0.0);
        rows.push_back(std::move(entries));
    }
    return rows;
}

std::string as_text(const Color& color) {
    return hex_color(color.r, color.g, color.b);
}

Json as_json(const std::vector<Problem>& problems) {
    Json sentences = Json::array();
    for (const Problem& problem : problems) sentences.push_back(say(problem.sentence));
    return sentences;
}

Json details_of(const std::vector<Problem>& problems) {
    static constexpr auto kinds = per_enum<ProblemKind>("wrong", "note", "window");
    Json details = Json::array();
    for (const Problem& problem : problems) {
        Json values = Json::object();
        for (const auto& [name, text] : problem.sentence.said_values()) {
            const std::optional<double> number = read_figures(text);
            values[name] = number ? Json(*number) : Json(text);
        }
        details.push_back({{"id", problem.id},
                           {"kind", kinds[problem.kind]},
                           {"values", std::move(values)},
                           {"say", say(problem.sentence)},
                           {"fix", problem.fixed_by.empty() ? Json() : Json(problem.fixed_by)}});
    }
    return details;
}

Json without_times(Json json) {
    if (json.is_object())
        for (const char* const key : {"time_ms", "time_least_ms", "time_most_ms", "runs", "painting_ms", "build_ms"})
            json.erase(key);
    if (json.is_structured())
        for (Json& part : json) part = without_times(std::move(part));
    return json;
}

std::string scene_name(const Params& params) {
    const auto* name = std::get_if<std::string>(&params.scene);
    return name != nullptr ? *name : "inline";
}

}  // namespace viewing
