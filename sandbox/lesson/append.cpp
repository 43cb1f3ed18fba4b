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

Json step_of(const Params& params, const LoadedState& preset, const std::string& name, std::size_t number) {
    Json settings = Json::object();
    Params now = params;
    now.ui = preset.params.ui;  // belongs to the user, not to the step
    for (const std::string& path : changed_fields(preset.params, now)) settings[path] = field_as_json(field(path), now);
    return {{"id", "step-" + std::to_string(number)},
            {"state", {{"preset", name}, {"set", std::move(settings)}}},
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

Result<std::string> with_step(std::string_view existing, const std::string& source, const Params& params,
                              const std::string& preset) {
    return guarded([&] {
        const Where root{source + ": ", ""};
        Json lesson = existing.empty() ? new_lesson(source) : parse_document(existing, root.prefix);
        if (!lesson.is_object() || !lesson.contains("lesson") || !lesson.contains("steps") ||
            !lesson["steps"].is_array())
            root.refuse("is not a lesson: it must have \"lesson\" and a list of \"steps\"");
        const std::string name = preset.empty() ? "opening" : preset;
        const Result<LoadedState> known = load_state(name);
        if (!known) root.refuse(known.error());
        lesson["steps"].push_back(step_of(params, *known, name, lesson["steps"].size() + 1));
        return print_document(lesson) + "\n";
    });
}

}  // namespace viewing
