#include "grading/exercise_check.h"

#include "grading/grading.h"
#include "grading/state_numbers.h"
#include "lesson/hand_in.h"
#include "lesson/questions/question_kind.h"

namespace viewing {
namespace {

/// Returns the attempt after writing it to a file and reading it back.
Result<Attempt> handed_in(const Attempt& attempt) {
    HandIn hand_in;
    hand_in.student = "test";
    hand_in.items.push_back({"exercise", 0, {attempt}, {}, {}, {}});
    Result<HandIn> read = parse_hand_in(hand_in_as_text(hand_in), "hand-in");
    if (!read) return Error{read.error()};
    return read->items.front().attempts.front();
}

class AnswerCheck {
public:
    AnswerCheck(const LessonStep& step, const Measurer& measurer) : step_(step), measurer_(measurer) {}

    LessonFindings all() {
        const Ask& ask = step_.ask;
        if (kind_of(ask).is_on_screen) {
            expect(goal(ask.model), "the model", {}, true);
            for (const WrongAnswer& wrong : ask.wrong) expect(goal(wrong.settings), "a wrong answer", wrong.say, false);
            return findings_;
        }
        const Result<Surroundings> numbers = numbers_of(step_.start, step_.start.params, measurer_);
        const Result<Answer> model = numbers ? model_answer(ask, *numbers) : Result<Answer>(Error{numbers.error()});
        if (!model) return {model.error()};
        expect(answered(*model), "the model", {}, true);
        for (const WrongAnswer& wrong : ask.wrong) expect(answered(wrong.sample), "a wrong answer", wrong.say, false);
        return findings_;
    }

private:
    static Attempt goal(const std::vector<std::string>& settings) {
        Attempt attempt;
        attempt.is_goal = true;
        attempt.settings = settings;
        return attempt;
    }
    static Attempt answered(const Answer& answer) {
        Attempt attempt;
        attempt.answer = answer_numbers(answer);
        return attempt;
    }
    void expect(const Attempt& attempt, const std::string& what, const LessonText& say, bool is_right) {
        const Result<Attempt> read = handed_in(attempt);
        const Result<Verdict> verdict = read ? judge_attempt(step_, *read, measurer_) : Error{read.error()};
        if (!verdict)
            findings_.push_back(what + " as a hand-in: " + verdict.error());
        else if (verdict->right != is_right || !(verdict->say == say))
            findings_.push_back(what + " gets different feedback as a hand-in: " + verdict->say.in_english());
    }

    const LessonStep& step_;
    const Measurer& measurer_;
    LessonFindings findings_;
};

}  // namespace

VariantCheck check_variant(const Exercise& exercise, std::size_t variant, const Measurer& measurer) {
    VariantCheck check{variant_step(exercise, variant, numbers_at_start(measurer)), {}, 0};
    if (!check.step) {
        check.findings.push_back(check.step.error());
        return check;
    }
    check.step->id = "variant " + std::to_string(variant);
    Lesson lesson;
    lesson.id = exercise.id;
    lesson.tags = exercise.tags;
    check.findings = check_step(lesson, *check.step, measurer);
    if (check.findings.empty())
        for (const std::string& found : AnswerCheck(*check.step, measurer).all())
            check.findings.push_back(exercise.id + ", step " + check.step->id + ": " + found);
    if (check.findings.empty()) check.wrong_answers = static_cast<int>(check.step->ask.wrong.size());
    return check;
}

}  // namespace viewing
