#include "lesson/notes.h"

#include "text/numbers.h"
#include "text/words.h"

namespace viewing {
namespace {

constexpr std::size_t line_width = 78, label_width = 8;

/// "Asks    …", with what goes on in further lines below its beginning.
std::string paragraph(const std::string& label, const std::string& text) {
    if (text.empty()) return "";
    return in_lines(text, line_width, label + std::string(label_width - label.size(), ' '), label_width);
}

std::string joined_texts(const std::vector<std::string>& texts, const char* between) {
    std::string all;
    for (const std::string& text : texts) all += (all.empty() ? "" : between) + text;
    return all;
}

std::string minutes_text(double seconds) {
    return std::to_string(static_cast<int>(seconds / 60.0)) + " min";
}

std::string time_text(const Lesson& lesson, double presented_s) {
    if (lesson.minutes == 0) return minutes_text(presented_s) + " so far";
    const double left_s = lesson.minutes * 60.0 - presented_s;
    const std::string left = left_s >= 0.0 ? minutes_text(left_s) + " left" : minutes_text(-left_s) + " over";
    return minutes_text(presented_s) + " of " + std::to_string(lesson.minutes) + ", " + left;
}

}  // namespace

std::string answer_in_words(const Ask& ask, const Surroundings& surroundings) {
    if (ask.kind == AskKind::goal) return joined_texts(ask.model, ", ");
    const Result<Answer> model = model_answer(ask, surroundings);
    if (!model) return ask.expect;
    if (ask.kind == AskKind::choice) {
        const auto index = static_cast<std::size_t>(model->items.front());
        return std::string(1, static_cast<char>('A' + index)) + ": " + ask.choices[index].say.shown();
    }
    std::vector<std::string> parts;
    for (const double number : model->numbers) parts.push_back(number_text(number, 3));
    for (const int item : model->items) parts.push_back(ask.items[static_cast<std::size_t>(item)].shown());
    const bool is_one_after_another = ask.kind == AskKind::order || ask.kind == AskKind::sequence;
    return joined_texts(parts, is_one_after_another ? " → " : ask.kind == AskKind::product ? " · " : ", ");
}

std::string notes_page(const LessonRun& run, StepPhase phase, const Surroundings& surroundings, double presented_s) {
    static constexpr const char* phases[] = {"asks", "shows", "answered"};
    const Lesson& lesson = run.lesson();
    const LessonStep& step = run.step();
    std::string page = lesson.title.shown() + "\n" + std::to_string(run.index() + 1) + " / " +
                       std::to_string(lesson.steps.size()) + " · " + phases[static_cast<std::size_t>(phase)] + " · " +
                       time_text(lesson, presented_s) + "\n\n";
    page += paragraph("Says", step.say.shown());
    page += paragraph("Asks", step.ask.question.shown());
    page += paragraph("Right", answer_in_words(step.ask, surroundings));
    page += paragraph("Shows", step.reveal.say.shown());
    page += paragraph("Note", step.note.shown());
    page += run.is_last() ? paragraph("Then", "the lesson ends.")
                          : paragraph("Then", lesson.steps[run.index() + 1].ask.question.shown());
    return page;
}

}  // namespace viewing
