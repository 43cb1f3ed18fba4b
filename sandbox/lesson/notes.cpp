#include "lesson/notes.h"

#include <algorithm>

#include "lesson/questions/question_kind.h"
#include "text/catalogue.h"
#include "text/numbers.h"
#include "text/per_enum.h"
#include "text/words.h"

namespace viewing {
namespace {

constexpr std::size_t line_width = 78, label_width = 8;  // "Ask     …": later lines are indented by label_width

int minutes_of(double seconds) {
    return static_cast<int>(seconds / 60.0);
}

std::string time_text(const Lesson& lesson, double presented_s) {
    const int passed = minutes_of(presented_s);
    if (lesson.minutes == 0) return say("{passed} min so far", "passed"_a = passed);
    const double left_s = lesson.minutes * 60.0 - presented_s;
    if (left_s < 0.0)
        return say("{passed} of {minutes} min, {over} over", "passed"_a = passed, "minutes"_a = lesson.minutes,
                   "over"_a = minutes_of(-left_s));
    return say("{passed} of {minutes} min, {left} left", "passed"_a = passed, "minutes"_a = lesson.minutes,
               "left"_a = minutes_of(left_s));
}

/// The planned start and end of a step, in seconds.
struct Planned {
    double from_s = 0.0, to_s = 0.0;
};

/// Returns the plan for the current step, assuming that all steps of a part take equally long. A lesson is one part.
Planned planned(const LessonRun& run) {
    const Lesson& lesson = run.lesson();
    double before_min = 0.0, minutes = lesson.minutes;
    std::size_t first = 0, count = lesson.steps.size();
    if (lesson.lecture) {
        const std::size_t now = lesson.lecture->part_of(run.index());
        for (std::size_t i = 0; i < now; ++i) before_min += lesson.lecture->parts[i].minutes;
        const Lecture::Part& part = lesson.lecture->parts[now];
        minutes = part.minutes;
        first = part.first;
        count = part.count;
    }
    const auto at_s = [&](std::size_t step) {
        return 60.0 * (before_min + minutes * static_cast<double>(step - first) / static_cast<double>(count));
    };
    return {at_s(run.index()), at_s(run.index() + 1)};
}

/// Whether the lecturer is behind schedule.
bool is_late(const LessonRun& run, double presented_s) {
    constexpr double patience_s = 120.0;
    return run.lesson().minutes > 0 && presented_s > planned(run).to_s + patience_s;
}

/// Returns how far a lecture is ahead of its plan or behind it.
std::string plan_text(const LessonRun& run, double presented_s) {
    const Planned plan = planned(run);
    const int behind = minutes_of(presented_s - plan.to_s), ahead = minutes_of(plan.from_s - presented_s);
    if (behind > 0) return say("{minutes} min behind", "minutes"_a = behind);
    if (ahead > 0) return say("{minutes} min ahead", "minutes"_a = ahead);
    return tr("on time");
}

/// Returns the lecture's current part: which one, its planned minutes, and the step inside it.
std::string part_text(const LessonRun& run) {
    const Lecture& lecture = *run.lesson().lecture;
    const std::size_t now = lecture.part_of(run.index());
    const Lecture::Part& part = lecture.parts[now];
    return say("part {part} / {parts}, {minutes} min · step {step} / {steps}", "part"_a = now + 1,
               "parts"_a = lecture.parts.size(), "minutes"_a = part.minutes, "step"_a = run.index() - part.first + 1,
               "steps"_a = part.count);
}

std::string next_text(const LessonRun& run) {
    const Lesson& lesson = run.lesson();
    if (run.is_last()) return tr(lesson.lecture ? marked("End of the lecture.") : marked("End of the lesson."));
    const std::size_t next = run.index() + 1;
    const LessonStep& step = lesson.steps[next];
    const std::string begins = step.only_shows() ? step.say.shown() : step.ask.question.shown();
    if (!lesson.lecture) return begins;
    const Lecture::Part& part = lesson.lecture->parts[lesson.lecture->part_of(next)];
    return part.first == next && !step.only_shows() ? part.title.shown() + ": " + begins : begins;
}

}  // namespace

std::string answer_in_words(const Ask& ask, const Surroundings& surroundings) {
    const Result<Answer> model = model_answer(ask, surroundings);
    return model ? kind_of(ask).in_words(ask, *model) : ask.expect;
}

Notes notes_of(const LessonRun& run, StepPhase phase, const Surroundings& surroundings, double presented_s) {
    static constexpr auto phases =
        per_enum<StepPhase>(marked("asking"), marked("showing"), marked("answered"), marked("end of the lesson"));
    const Lesson& lesson = run.lesson();
    const LessonStep& step = run.step();
    Notes notes;
    notes.title = lesson.title.shown();
    notes.place =
        lesson.lecture ? part_text(run) : std::to_string(run.index() + 1) + " / " + std::to_string(lesson.steps.size());
    if (!step.only_shows() || phase == StepPhase::ended) notes.place += std::string(" · ") + tr(phases[phase]);
    notes.place += " · " + time_text(lesson, presented_s);
    if (lesson.lecture) {
        notes.title += " · " + lesson.lecture->parts[lesson.lecture->part_of(run.index())].title.shown();
        notes.place += " · " + plan_text(run, presented_s);
    }
    notes.is_late = is_late(run, presented_s);
    std::vector<Notes::Part> parts;
    if (phase == StepPhase::ended && run.end())
        for (const LessonText& said : run.end()->says) parts.push_back({tr("Say"), said.shown()});
    else if (step.only_shows())
        parts = {{tr("Say"), step.say.shown()}, {"", step.ask.question.shown()}};
    else
        parts = {{tr("Say"), step.say.shown()},
                 {tr("Ask"), step.ask.question.shown()},
                 {tr("Answer"), answer_in_words(step.ask, surroundings)},
                 {tr("Reveal"), filled_or_same(step.reveal.say, with_constants(step.ask, surroundings)).shown()},
                 {tr("Note"), step.note.shown()}};
    parts.push_back({tr("Then"), next_text(run)});
    for (const Notes::Part& part : parts)
        if (!part.text.empty()) notes.parts.push_back(part);
    return notes;
}

std::string notes_page(const Notes& notes) {
    std::string page = notes.title + "\n" + notes.place + "\n\n";
    for (const Notes::Part& part : notes.parts) {
        const std::size_t length = character_count(part.label);
        const std::string blanks(length < label_width ? label_width - length : 1, ' ');
        page += in_lines(part.text, line_width, part.label + blanks, label_width);
    }
    return page;
}

}  // namespace viewing
