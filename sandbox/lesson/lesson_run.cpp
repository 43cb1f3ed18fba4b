#include "lesson/lesson_run.h"

#include <algorithm>

#include "lesson/questions/question_kind.h"

namespace viewing {

LessonRun::LessonRun(Lesson lesson, std::size_t step)
    : lesson_(std::make_shared<const Lesson>(std::move(lesson))), visits_(lesson_->steps.size()) {
    for (std::size_t i = 0; i < visits_.size(); ++i) {
        const Ask& ask = lesson_->steps[i].ask;
        visits_[i].ballot = Ballot(ask.choices.size());
        if (kind_of(ask).sorts)  // all items, in the order of the file
            for (std::size_t item = 0; item < ask.items.size(); ++item)
                visits_[i].answer.items.push_back(static_cast<int>(item));
    }
    go_to(step);
}

void LessonRun::go_to(std::size_t step) {
    now().trouble.clear();
    index_ = std::min(step, lesson_->steps.size() - 1);
    shows_end_ = false;
}

const LessonEnd* LessonRun::end() const {
    const LessonEnd* end = is_last() ? &lesson_->end : nullptr;
    if (lesson_->lecture) {
        const Lecture::Part& part = lesson_->lecture->parts[lesson_->lecture->part_of(index_)];
        end = index_ + 1 == part.first + part.count ? &part.end : nullptr;
    }
    return end && !end->says.empty() ? end : nullptr;
}

void LessonRun::take(const Verdict& verdict) {
    forget_verdict();
    now().verdict = verdict;
    if (!verdict.right) {
        now().tried.insert(now().tried.end(), answer().items.begin(), answer().items.end());
        return;
    }
    now().done = true;
    reveal();
}

std::string LessonRun::first_unread() const {
    const std::vector<std::string>& texts = now().unread;
    const auto at = std::find_if(texts.begin(), texts.end(), [](const std::string& text) { return !text.empty(); });
    return at == texts.end() ? "" : *at;
}

bool LessonRun::is_tried(std::size_t choice) const {
    const std::vector<int>& tried = now().tried;
    return std::find(tried.begin(), tried.end(), static_cast<int>(choice)) != tried.end();
}

void LessonRun::restore(std::size_t step, const Answer& answer, int hints, bool is_done,
                        std::optional<Params> reached) {
    Visit& visit = visits_[step];
    if (!answer.empty()) visit.answer = answer;
    visit.hints = std::min(hints, static_cast<int>(lesson_->steps[step].ask.hints.size()));
    visit.done = visit.revealed = is_done;
    visit.reached = std::move(reached);
}

void LessonRun::show_hint() {
    now().hints = std::min(now().hints + 1, static_cast<int>(step().ask.hints.size()));
}

const std::vector<int>& LessonRun::shown_items() const {
    return is_revealed() ? step().ask.expected_items.front() : answer().items;
}

}  // namespace viewing
