// libFuzzer: reads arbitrary text as a lesson. An accepted lesson must have steps whose states round-trip exactly.
#include "fuzz.h"
#include "lesson/lesson.h"
#include "state/file/state_json.h"
#include "state/scene.h"

namespace {

using namespace viewing;

void check_state(const Params& params) {
    const Result<Params> back = parse_state(write_state(params), "written");
    fuzz::check(back && *back == params);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const std::filesystem::path folder = assets_directory() / "lessons";
    const Result<Lesson> lesson = parse_lesson(fuzz::as_text(data, size), "fuzz", folder);
    if (!lesson) {
        fuzz::check_message(lesson.error());
        return 0;
    }
    fuzz::check(!lesson->id.empty() && !lesson->steps.empty());
    for (const LessonStep& step : lesson->steps) {
        check_state(step.start.params);
        check_state(step.revealed);
    }
    return 0;
}
