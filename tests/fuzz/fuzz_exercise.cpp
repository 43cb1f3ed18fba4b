// libFuzzer: reads arbitrary text as an exercise. The text must yield combinations or an error that says why it does
// not. Each of the first two variants of an accepted exercise must become a step or report why it cannot. Nothing is
// measured: every looked-up value is 1.5.
#include "fuzz.h"
#include "lesson/exercise.h"
#include "state/file/state_json.h"
#include "state/scene.h"

using namespace viewing;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const std::filesystem::path folder = assets_directory() / "exercises";
    const std::string_view text = fuzz::as_text(data, size);
    const Result<std::vector<std::string>> all = combinations(text, "fuzz");
    if (!all) fuzz::check_message(all.error());
    const Result<Exercise> exercise = parse_exercise(text, "fuzz", folder);
    if (!exercise) {
        fuzz::check_message(exercise.error());
        return 0;
    }
    fuzz::check(!exercise->id.empty());
    const NumbersAt nothing_measured = [](const LoadedState&) -> Result<Surroundings> {
        return Surroundings{[](const std::string&, std::span<const double>) -> Result<Json> { return Json(1.5); },
                            nullptr, nullptr};
    };
    for (std::size_t variant = 0; variant < std::min<std::size_t>(exercise->variants.size(), 2); ++variant) {
        const Result<LessonStep> step = variant_step(*exercise, variant, nothing_measured);
        if (!step) {
            fuzz::check_message(step.error());
            continue;
        }
        const Result<Params> back = parse_state(write_state(step->start.params), "written");
        fuzz::check(back && *back == step->start.params);
    }
    return 0;
}
