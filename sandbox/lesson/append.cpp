#include "lesson/append.h"

#include <filesystem>

#include "lesson/allowed.h"
#include "state/file/reader.h"
#include "state/presets.h"

namespace viewing {
namespace {

Json new_lesson(const std::string& source) {
    return {{"lesson", 1},
            {"id", std::filesystem::path(source).stem().string()},
            {"title", std::filesystem::path(source).stem().string()},
            {"steps", Json::array()}};
}

Json step_of(Json state, std::size_t number) {
    return {{"id", "step-" + std::to_string(number)},
            {"state", std::move(state)},
            {"say", template_texts.say},
            {"ask",
             {{"kind", "choice"},
              {"question", template_texts.question},
              {"choices",
               {{{"say", template_texts.right}, {"right", true}},
                {{"say", template_texts.wrong}, {"why", template_texts.why}}}}}},
            {"reveal", {{"set", Json::object()}, {"say", template_texts.reveal}}}};
}

}  // namespace

Json lesson_document(std::string_view text, const std::string& source) {
    const Where root{source + ": ", ""};
    Json lesson = parse_document(text, root.prefix);
    if (!lesson.is_object() || !lesson.contains("lesson") || !lesson.contains("steps") || !lesson["steps"].is_array())
        root.refuse("is not a lesson: it must have \"lesson\" and a list of \"steps\"");
    return lesson;
}

Json state_of_step(const Params& params, const std::string& preset, const std::string& source) {
    const std::string name = preset.empty() ? "opening" : preset;
    const Result<LoadedState> known = load_state(name);
    if (!known) throw Refusal(source + ": " + known.error());
    Json settings = Json::object();
    Params now = params;
    now.ui = known->params.ui;  // belongs to the user, not to the step
    for (const std::string& path : changed_fields(known->params, now)) settings[path] = field_as_json(field(path), now);
    return {{"preset", name}, {"set", std::move(settings)}};
}

Result<std::string> with_step(std::string_view existing, const std::string& source, const Params& params,
                              const std::string& preset, const std::vector<std::string>& highlight) {
    return guarded([&] {
        Json lesson = existing.empty() ? new_lesson(source) : lesson_document(existing, source);
        Json step = step_of(state_of_step(params, preset, source), lesson["steps"].size() + 1);
        if (!highlight.empty()) step["highlight"] = highlight;
        lesson["steps"].push_back(std::move(step));
        return print_document(lesson) + "\n";
    });
}

}  // namespace viewing
