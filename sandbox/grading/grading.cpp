#include "grading/grading.h"

#include <algorithm>
#include <chrono>
#include <numeric>
#include <set>

#include "grading/state_numbers.h"
#include "lesson/allowed.h"
#include "lesson/questions/question_kind.h"
#include "lesson/variants.h"
#include "text/numbers.h"
#include "text/words.h"

namespace viewing {
namespace {

constexpr double least_thought_s = 5.0;  // people who read the questions take longer, on average, between two answers

template <typename Of>
int sum(const std::vector<ItemGrade>& items, const Of& of) {
    return std::accumulate(items.begin(), items.end(), 0,
                           [&](int total, const ItemGrade& item) { return total + of(item); });
}

/// Returns a key for the content of an attempt. Each setting is preceded by its length, since names in a file may
/// contain any character.
std::string key_of(const Attempt& attempt) {
    std::string key = attempt.is_goal ? " goal" : " answer";
    if (attempt.answer)
        for (const double number : *attempt.answer) key += " " + shortest_number(number);
    for (const std::string& setting : attempt.settings) key += "\n" + std::to_string(setting.size()) + " " + setting;
    return key;
}

/// Returns the seconds since 1970 for a time such as "2026-11-21T10:03:12"; nothing if it has another form.
std::optional<double> clock_s(const std::string& at) {
    if (at.size() < 19 || at[10] != 'T') return std::nullopt;
    const auto two = [&](std::size_t begin) { return (at[begin] - '0') * 10 + (at[begin + 1] - '0'); };
    const std::chrono::year_month_day date{std::chrono::year(two(0) * 100 + two(2)),
                                           std::chrono::month(static_cast<unsigned>(two(5))),
                                           std::chrono::day(static_cast<unsigned>(two(8)))};
    if (!date.ok()) return std::nullopt;
    const std::chrono::seconds midnight = std::chrono::sys_days(date).time_since_epoch();
    return static_cast<double>(midnight.count()) + two(11) * 3600.0 + two(14) * 60.0 + two(17);
}

/// Whether all answers are correct on the first try and were entered faster than anyone can read the questions.
bool is_hasty(const StudentGrade& grade) {
    std::vector<double> times;
    for (const HandInItem& item : grade.hand_in.items)
        for (const Attempt& attempt : item.attempts)
            if (const auto at = clock_s(attempt.at); at && attempt.hint == 0) times.push_back(*at);
    constexpr std::size_t least = 3;
    if (times.size() < least || !grade.is_all_right() || grade.at_first_try() < grade.tried()) return false;
    const auto [first, last] = std::minmax_element(times.begin(), times.end());
    return (*last - *first) / static_cast<double>(times.size() - 1) < least_thought_s;
}

std::vector<std::string> times_of(const HandIn& hand_in) {
    std::vector<std::string> times;
    for (const HandInItem& item : hand_in.items)
        for (const Attempt& attempt : item.attempts)
            if (!attempt.at.empty()) times.push_back(attempt.at);
    return times;
}

bool has_equal_replay(const HandIn& a, const HandIn& b) {
    constexpr std::size_t telling = 3;  // one or two drags may be equal by chance
    return std::any_of(a.items.begin(), a.items.end(), [&](const HandInItem& item) {
        const HandInItem* const other = b.find(item.exercise);
        return other && item.replay.size() >= telling && item.replay == other->replay;
    });
}

/// Returns whose variant this is: the first student in the class who has it, and how many others have it too.
std::string whose_variant(const std::vector<StudentGrade>& grades, const std::string& exercise, std::size_t variant) {
    std::string first;
    int others = 0;
    for (const StudentGrade& grade : grades)
        for (const ItemGrade& item : grade.items) {
            if (item.exercise != exercise || item.variant != variant) continue;
            if (first.empty())
                first = printable(grade.name());
            else
                ++others;
        }
    return others == 0 ? first : first + " and " + std::to_string(others) + " more";
}

/// Says which items answer another variant than the student's, and what decides the variant; "" if there are none.
std::string other_variants(const StudentGrade& grade, const std::string& course) {
    std::string items;
    for (const ItemGrade& item : grade.items)
        if (item.standing == Standing::other_variant)
            items += (items.empty() ? "" : ", ") + item.exercise + " has variant " +
                     std::to_string(grade.hand_in.find(item.exercise)->variant) + " instead of " +
                     std::to_string(item.variant);
    if (items.empty()) return "";
    return items + ": made for another number than \"" + excerpt(grade.hand_in.student) +
           "\" or another course than \"" + excerpt(course) + "\"";
}

/// Returns the verdict on an answer that the program itself never writes: the file was changed by hand.
Verdict not_an_answer(std::string english, std::string korean = "") {
    Verdict verdict;
    verdict.say.by_language[Language::en] = std::move(english);
    verdict.say.by_language[Language::ko] = std::move(korean);
    return verdict;
}

}  // namespace

Result<Verdict> judge_attempt(const LessonStep& step, const Attempt& attempt, const Measurer& measurer) {
    LoadedState now = step.start;
    Answer answer;
    if (kind_of(step.ask).is_on_screen) {
        if (!attempt.is_goal)
            return not_an_answer("The file has numbers as the answer, but the exercise needs a state.",
                                 "파일의 답은 숫자인데, 이 연습 문제의 답은 상태여야 합니다.");
        const Result<Params> changed = changed_start(step, attempt.settings);
        if (!changed) return not_an_answer(changed.error());
        now.params = *changed;
    } else {
        const std::optional<Answer> given = answer_in(attempt, step.ask);
        if (!given)
            return not_an_answer("The answer in the file does not have the form that the question needs.",
                                 "파일의 답이 문제에 맞는 형식이 아닙니다.");
        answer = *given;
    }
    Result<Surroundings> numbers = numbers_of(now, step.start.params, measurer);
    if (!numbers) return Error{numbers.error()};
    return judge(step.ask, answer, *std::move(numbers));
}

std::string ItemGrade::last_tag() const {
    return verdicts.empty() || !verdicts.back() || verdicts.back()->right ? "" : verdicts.back()->tag;
}
std::size_t ItemGrade::judged() const {
    return static_cast<std::size_t>(
        std::count_if(verdicts.begin(), verdicts.end(), [](const auto& verdict) { return verdict.has_value(); }));
}

int StudentGrade::points() const {
    return sum(items, [](const ItemGrade& item) { return item.points; });
}
int StudentGrade::of() const {
    return sum(items, [](const ItemGrade& item) { return item.of; });
}
int StudentGrade::tried() const {
    return sum(items, [](const ItemGrade& item) { return item.tries > 0 ? 1 : 0; });
}
int StudentGrade::at_first_try() const {
    return sum(items, [](const ItemGrade& item) { return item.at_first_try ? 1 : 0; });
}
int StudentGrade::hints() const {
    return sum(items, [](const ItemGrade& item) { return item.hints; });
}
bool StudentGrade::is_all_right() const {
    return error.empty() && std::all_of(items.begin(), items.end(),
                                        [](const ItemGrade& item) { return item.standing == Standing::right; });
}

std::vector<std::size_t> order_of_judging(const std::vector<const Attempt*>& answers) {
    std::vector<std::size_t> order;
    if (answers.empty()) return order;
    const std::size_t last = answers.size() - 1;
    order.push_back(last);
    if (last > 0) order.push_back(0);
    for (const bool called_right : {true, false})
        for (std::size_t at = last; at-- > 1;)
            if ((answers[at]->told == "right") == called_right) order.push_back(at);
    return order;
}

Grader::Grader(std::vector<Exercise> exercises, const Measurer& measurer)
    : exercises_(std::move(exercises)), measurer_(measurer) {}

const Result<LessonStep>& Grader::step(std::size_t exercise, std::size_t variant) {
    const auto key = std::pair(exercise, variant);
    const auto known = steps_.find(key);
    if (known != steps_.end()) return known->second;
    return steps_.emplace(key, variant_step(exercises_[exercise], variant, numbers_at_start(measurer_))).first->second;
}

const Result<Verdict>& Grader::verdict(const std::string& key, const LessonStep& step, const Attempt& attempt) {
    constexpr std::size_t most_kept = 4096;
    const auto known = verdicts_.find(key);
    if (known != verdicts_.end()) return known->second;
    if (verdicts_.size() >= most_kept) verdicts_.clear();
    return verdicts_.emplace(key, judge_attempt(step, attempt, measurer_)).first->second;
}

void Grader::stop_when(std::function<bool()> is_over, std::string why) {
    is_over_ = std::move(is_over);
    why_over_ = std::move(why);
}

/// Returns everything about an exercise except the verdicts on its answers. If there are no answers to judge, the
/// standing is final; otherwise, the result has an empty place for each verdict, or its `trouble` says why nothing
/// is judged.
ItemGrade Grader::before_judging(std::size_t exercise, const ReadableHandIn& handed_in, const std::string& course) {
    const HandIn& hand_in = handed_in.hand_in;
    const Exercise& asked = exercises_[exercise];
    ItemGrade grade;
    grade.exercise = asked.id;
    grade.of = asked.points;
    grade.variant = variant_of(course, hand_in.student, asked.id, asked.variants.size());
    const HandInItem* const item = hand_in.find(asked.id);
    if (item)
        for (const Attempt& attempt : item->attempts) (attempt.hint > 0 ? grade.hints : grade.tries) += 1;
    if (grade.tries == 0) {
        const auto left_out = std::find_if(handed_in.left_out.begin(), handed_in.left_out.end(),
                                           [&](const LeftOut& part) { return part.exercise == asked.id; });
        if (left_out == handed_in.left_out.end()) return grade;
        grade.standing = Standing::not_judged;
        grade.trouble = left_out->why;
        return grade;
    }
    if (item->variant != grade.variant) {
        grade.standing = Standing::other_variant;
        return grade;
    }
    grade.standing = Standing::not_judged;
    if (is_over())
        grade.trouble = why_over_;
    else if (const Result<LessonStep>& made = step(exercise, grade.variant); !made)
        grade.trouble = made.error();
    else
        grade.verdicts.resize(static_cast<std::size_t>(grade.tries));
    return grade;
}

/// The answers to an exercise that are still to be judged.
struct Grader::Turns {
    ItemGrade& item;
    const LessonStep& step;
    std::string key;  ///< identifies the exercise and its variant
    int cost;         ///< of judging one answer
    std::vector<const Attempt*> answers;
    std::vector<std::size_t> order;
    std::size_t done = 0;

    bool are_over() const { return done == order.size() || !item.trouble.empty(); }
    const Attempt& next() const { return *answers[order[done]]; }
    std::string next_key() const { return key + key_of(next()); }
};

std::vector<Grader::Turns> Grader::turns_of(StudentGrade& grade) {
    std::vector<Turns> all;
    for (std::size_t exercise = 0; exercise < grade.items.size(); ++exercise) {
        ItemGrade& item = grade.items[exercise];
        if (item.verdicts.empty()) continue;
        const LessonStep& asked = *step(exercise, item.variant);
        Turns turns{item,
                    asked,
                    std::to_string(exercise) + " " + std::to_string(item.variant),
                    is_measured(asked.ask) ? cost_of_measured : 1,
                    {},
                    {}};
        for (const Attempt& attempt : grade.hand_in.find(item.exercise)->attempts)
            if (attempt.hint == 0) turns.answers.push_back(&attempt);
        turns.order = order_of_judging(turns.answers);
        all.push_back(std::move(turns));
    }
    return all;
}

void Grader::judge_next(Turns& turns) {
    const Result<Verdict>& judged = verdict(turns.next_key(), turns.step, turns.next());
    if (judged)
        turns.item.verdicts[turns.order[turns.done]] = *judged;
    else
        turns.item.trouble = judged.error();
    ++turns.done;
}

/// Judges one answer to each exercise in turn, so that no exercise uses up the budget of the others.
void Grader::judge_by_turns(StudentGrade& grade) {
    std::vector<Turns> all = turns_of(grade);
    std::set<std::string> paid;
    int left = budget_of_file;
    bool goes_on = true;
    for (std::size_t round = 0; goes_on; ++round) {
        goes_on = false;
        for (Turns& turns : all) {
            if (turns.are_over()) continue;
            constexpr std::size_t always = 2;
            const bool is_new = paid.insert(turns.next_key()).second;
            if (is_new && round >= always && turns.cost > left) {
                turns.order.resize(turns.done);
                continue;
            }
            if (is_over()) {
                grade.is_cut = true;
                return;
            }
            if (is_new) left -= turns.cost;
            judge_next(turns);
            goes_on = true;
        }
    }
}

void Grader::sum_up(ItemGrade& item, bool is_cut) const {
    bool is_right = false;
    for (const std::optional<Verdict>& verdict : item.verdicts) {
        if (!verdict) continue;
        is_right = is_right || verdict->right;
        item.points = std::max(item.points, verdict->right ? item.of : std::min(verdict->points, item.of));
    }
    if (item.verdicts.empty() || !item.trouble.empty()) return;
    item.at_first_try = item.verdicts.front() && item.verdicts.front()->right;
    if (is_right)
        item.standing = Standing::right;
    else if (is_cut && item.judged() < item.verdicts.size())
        item.trouble = why_over_;
    else
        item.standing = item.points > 0 ? Standing::partly : Standing::wrong;
}

StudentGrade Grader::grade(ReadableHandIn handed_in, const std::string& file,
                           const std::optional<std::string>& course) {
    StudentGrade grade;
    grade.file = file;
    const std::string of_course = course.value_or(handed_in.hand_in.course);
    for (std::size_t exercise = 0; exercise < exercises_.size(); ++exercise)
        grade.items.push_back(before_judging(exercise, handed_in, of_course));
    for (const LeftOut& part : handed_in.left_out)
        if (std::none_of(grade.items.begin(), grade.items.end(),
                         [&](const ItemGrade& item) { return item.trouble == part.why; }))
            grade.notes.push_back("left out: " + part.why);
    grade.hand_in = std::move(handed_in.hand_in);
    if (grade.hand_in.course != of_course)
        grade.notes.push_back("made for the course \"" + excerpt(grade.hand_in.course) + "\"");
    judge_by_turns(grade);
    std::string over_budget;
    for (ItemGrade& item : grade.items) {
        sum_up(item, grade.is_cut);
        grade.is_cut = grade.is_cut || (!item.trouble.empty() && item.trouble == why_over_);
        if (item.trouble.empty() && item.judged() < item.verdicts.size())
            over_budget += (over_budget.empty() ? "" : ", ") + item.exercise + ": " + std::to_string(item.judged()) +
                           " of " + std::to_string(item.verdicts.size());
    }
    if (!over_budget.empty())
        grade.notes.push_back(
            over_budget +
            " answers judged (the last, the first, then the latest marked right): the file exceeds its budget");
    for (const HandInItem& item : grade.hand_in.items)
        if (std::none_of(exercises_.begin(), exercises_.end(),
                         [&](const Exercise& exercise) { return exercise.id == item.exercise; }) &&
            std::find(also_known_.begin(), also_known_.end(), item.exercise) == also_known_.end())
            grade.notes.push_back("has \"" + excerpt(item.exercise) + "\", which is not a known exercise");
    if (const std::string note = other_variants(grade, of_course); !note.empty()) grade.notes.push_back(note);
    if (is_hasty(grade)) grade.notes.emplace_back("everything right on the first try, within seconds");
    return grade;
}

void compare_hand_ins(std::vector<StudentGrade>& grades) {
    std::vector<std::vector<std::string>> times;
    for (const StudentGrade& grade : grades) times.push_back(times_of(grade.hand_in));
    for (std::size_t i = 0; i < grades.size(); ++i) {
        std::vector<std::string>& notes = grades[i].notes;
        const HandIn& mine = grades[i].hand_in;
        for (std::size_t k = 0; k < grades.size() && grades[i].error.empty(); ++k) {
            if (k == i || !grades[k].error.empty()) continue;
            const HandIn& theirs = grades[k].hand_in;
            const std::string other = printable(grades[k].name());
            if (mine.student == theirs.student) {
                notes.push_back("another file from the same student: " + grades[k].file);
                continue;
            }
            constexpr std::size_t telling = 2;
            if (times[i].size() >= telling && times[i] == times[k]) notes.push_back("same attempt times as " + other);
            if (has_equal_replay(mine, theirs)) notes.push_back("same replay as " + other);
        }
        for (const ItemGrade& item : grades[i].items) {
            if (item.standing != Standing::other_variant) continue;
            const std::string whose = whose_variant(grades, item.exercise, mine.find(item.exercise)->variant);
            if (!whose.empty()) notes.push_back(item.exercise + ": the variant of " + whose);
        }
    }
}

std::vector<TagCount> count_tags(const std::vector<Exercise>& exercises, const std::vector<StudentGrade>& grades) {
    std::map<std::string, TagCount> counts;
    for (const Exercise& exercise : exercises)
        for (const auto& [tag, text] : exercise.tags) {
            TagCount& count = counts[tag];
            count.tag = tag;
            if (count.text.empty()) count.text = text;
        }
    struct Tags {
        std::set<std::string> shown, last, possible;  // possible: tags of the exercises that were tried
    };
    std::map<std::string, Tags> tags_of;  // by student, who may have handed in several files
    for (const StudentGrade& grade : grades) {
        auto& [shown, last, possible] = tags_of[grade.hand_in.student];
        for (std::size_t i = 0; i < grade.items.size(); ++i) {
            const ItemGrade& item = grade.items[i];
            if (item.judged() == 0) continue;
            for (const auto& [tag, text] : exercises[i].tags) possible.insert(tag);
            for (const std::optional<Verdict>& verdict : item.verdicts)
                if (verdict) shown.insert(verdict->tag);
            last.insert(item.last_tag());
            possible.insert(shown.begin(), shown.end());
        }
    }
    for (const auto& [student, tags] : tags_of)
        for (auto& [tag, count] : counts) {
            count.students += tags.shown.contains(tag) ? 1 : 0;
            count.at_last += tags.last.contains(tag) ? 1 : 0;
            count.students_of += tags.possible.contains(tag) ? 1 : 0;
        }
    std::vector<TagCount> sorted;
    for (const auto& [tag, count] : counts)
        if (count.students > 0) sorted.push_back(count);
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const TagCount& a, const TagCount& b) { return a.students > b.students; });
    return sorted;
}

}  // namespace viewing
