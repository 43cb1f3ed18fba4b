// Collects Korean text that is not in the catalog, for the fonts. The catalog's own text is collected when the language
// changes.
#include "ui/window/workbench.h"

namespace viewing {
namespace {

/// Collects all of the lesson's text in the current language.
void want_texts(const Lesson& lesson, Syllables& korean) {
    const auto want = [&korean](const LessonText& text) { korean.want(text.shown()); };
    want(lesson.title);
    for (const LessonText& said : lesson.end.says) want(said);
    if (lesson.lecture)
        for (const Lecture::Part& part : lesson.lecture->parts) {
            want(part.title);
            for (const LessonText& said : part.end.says) want(said);
        }
    for (const LessonStep& step : lesson.steps) {
        for (const LessonText* text : {&step.say, &step.ask.question, &step.reveal.say, &step.note}) want(*text);
        for (const LessonText& hint : step.ask.hints) want(hint);
        for (const LessonText& item : step.ask.items) want(item);
        for (const LessonChoice& choice : step.ask.choices) {
            want(choice.say);
            want(choice.why);
        }
        for (const WrongAnswer& wrong : step.ask.wrong) want(wrong.say);
        if (step.target) want(step.target->label);
    }
}

}  // namespace

void LongTexts::want(const Session& session, const Guide& guide, Syllables& korean) {
    if (scene_version_ != session.scene_version()) {
        scene_version_ = session.scene_version();
        for (const SceneObject& object : session.scene().objects) korean.want(object.description.name);
    }
    const std::shared_ptr<const Lesson> lesson = guide.run() ? guide.run()->shared_lesson() : nullptr;
    if (lesson && (lesson != lesson_ || spoken_language() != language_)) want_texts(*lesson, korean);
    lesson_ = lesson;
    language_ = spoken_language();
}

void Workbench::want_korean(const Session& session) {
    korean.want(session.message.text);
    if (guide.run()) korean.want(guide.run()->trouble());
    korean.want(presets_.search());
    korean.want(search_.typed());
    for (const SearchEntry& entry : search_.entries()) {
        korean.want(entry.title);
        korean.want(entry.note);
    }
    if (file_dialog_.is_open()) file_dialog_.want(korean);
    if (step_editor_.is_open())
        for (const std::string& text : step_editor_.texts()) korean.want(text);
    if (const auto* scene = std::get_if<std::string>(&session.params.scene)) korean.want(*scene);
    if (start_page.is_open()) {
        for (const LessonFile& file : start_page.lessons()) korean.want(file.title.shown());
        for (const std::string& file : past.recent) korean.want(file);
    }
    if (exercises.page.is_open()) {
        for (const ExerciseDesk::Entry& entry : exercises.desk.entries()) korean.want(entry.exercise.title.shown());
        const Student& student = exercises.desk.student();
        for (const std::string& text : {student.number, student.course, student.name}) korean.want(text);
        for (const auto& field : widgets.text_fields) korean.want(field.second.entry.value_or(""));
    }
    if (guide.is_shown() && guide.run()->shows_end())
        for (const std::string& text : end_card_.texts(*guide.run())) korean.want(text);
    long_texts_.want(session, guide, korean);
}

}  // namespace viewing
