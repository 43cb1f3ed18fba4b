#include "lesson/typed_matrix.h"

#include "state/file/json.h"
#include "text/numbers.h"

namespace viewing {
namespace {

/// Returns the w of (0, 0.5, 0), a point in the middle of the scene.
double w_of_middle(const std::vector<double>& rows) {
    constexpr double height = 0.5;
    return rows[13] * height + rows[15];
}

}  // namespace

LoadedState with_right_matrix(const LessonStep& step) {
    LoadedState state = step.start;
    state.params.shadow.clip_to_receiver = false;
    return state;
}

Result<LoadedState> with_typed_matrix(const LessonStep& step, const std::vector<double>& numbers) {
    const double sign = step.ask.up_to_factor && w_of_middle(numbers) < 0.0 ? -1.0 : 1.0;
    std::string rows;
    for (std::size_t i = 0; i < numbers.size(); ++i)
        rows += std::string(i == 0 ? "[[" : i % 4 == 0 ? "], [" : ", ") + format_number(sign * numbers[i]);
    LoadedState state = with_right_matrix(step);
    const std::vector<std::string> setting{step.ask.shows_as + "=" + rows + "]]"};
    Result<Params> changed = apply_settings(state.params, setting);
    if (!changed) return Error{changed.error()};
    state.params = *std::move(changed);
    return state;
}

}  // namespace viewing
