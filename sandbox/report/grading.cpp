#include "report/grading.h"

#include <algorithm>
#include <numeric>
#include <set>

#include "lesson/allowed.h"
#include "lesson/variants.h"
#include "report/state_numbers.h"
#include "text/numbers.h"
#include "text/words.h"

namespace viewing {
namespace {

constexpr double least_thought_s = 5.0;  // between two exercises, for a person who reads them

template <typename Of>
int sum(const std::vector<ItemGrade>& items, const Of& of) {
    return std::accumulate(items.begin(), items.end(), 0,
                           [&](int total, const ItemGrade& item) { return total + of(item); });
}

/// Told apart by their lengths too: names in a file may hold any character.
std::string key_of(std::size_t exercise, std::size_t variant, const Attempt& attempt) {
    std::string key =
        std::to_string(exercise) + " " + std::to_string(variant) + (attempt.is_goal ? " goal" : " answer");
    if (attempt.answer)
        for (const double number : *attempt.answer) key += " " + shortest_number(number);
    for (const std::string& setting : attempt.settings) key += "\n" + std::to_string(setting.size()) + " " + setting;
    return key;
}

/// Seconds since midnight of "2026-11-21T10:03:12"; none for another form.
std::optional<double> clock_s(const std::string& at) {
    if (at.size() < 19 || at[10] != 'T') return std::nullopt;
    const auto two = [&](std::size_t begin) { return (at[begin] - '0') * 10 + (at[begin + 1] - '0'); };
    return two(11) * 3600.0 + two(14) * 60.0 + two(17);
}

/// All right at once, faster than one can read.
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
    constexpr std::size_t telling = 3;  // one drag or two may be alike by chance
    return std::any_of(a.items.begin(), a.items.end(), [&](const HandInItem& item) {
        const HandInItem* const other = b.find(item.exercise);
        return other && item.replay.size() >= telling && item.replay == other->replay;
    });
}

/// Whom a variant was given to: the first one of the class, and how many more.
std::string whose_variant(const std::vector<StudentGrade>& grades, const std::string& exercise, std::size_t variant) {
    std::string first;
    int others = 0;
    for (const StudentGrade& grade : grades)
        for (const ItemGrade& item : grade.items) {
            if (item.exercise != exercise || item.variant != variant) continue;
            if (first.empty())
                first = printable(grade.hand_in.student);
            else
                ++others;
        }
    return others == 0 ? first : first + " and " + std::to_string(others) + " more";
}

}  // namespace

Result<Verdict> judge_attempt(const LessonStep& step, const Attempt& attempt, Renderer& renderer) {
    LoadedState now = step.start;
    Answer answer;
    if (step.ask.kind == AskKind::goal) {
        if (!attempt.is_goal) return Verdict{};
        const Result<Params> changed = changed_start(step, attempt.settings);
        if (!changed) return Verdict{};
        now.params = *changed;
    } else {
        const std::optional<Answer> given = answer_in(attempt, step.ask);
        if (!given) return Verdict{};
        answer = *given;
    }
    Result<Surroundings> numbers = numbers_of(now, step.start.params, &renderer);
    if (!numbers) return Error{numbers.error()};
    return judge(step.ask, answer, *std::move(numbers));
}

std::string ItemGrade::last_tag() const {
    return verdicts.empty() || verdicts.back().right ? "" : verdicts.back().tag;
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

Grader::Grader(std::vector<Exercise> exercises, Renderer& renderer)
    : exercises_(std::move(exercises)), renderer_(renderer) {}

const Result<LessonStep>& Grader::step(std::size_t exercise, std::size_t variant) {
    const auto key = std::pair(exercise, variant);
    const auto known = steps_.find(key);
    if (known != steps_.end()) return known->second;
    return steps_.emplace(key, variant_step(exercises_[exercise], variant, numbers_at_start(&renderer_))).first->second;
}

const Result<Verdict>& Grader::verdict(std::size_t exercise, std::size_t variant, const Attempt& attempt) {
    const std::string key = key_of(exercise, variant, attempt);
    const auto known = verdicts_.find(key);
    if (known != verdicts_.end()) return known->second;
    return verdicts_.emplace(key, judge_attempt(*step(exercise, variant), attempt, renderer_)).first->second;
}

ItemGrade Grader::grade_item(std::size_t exercise, const HandIn& hand_in, const std::string& course) {
    const Exercise& asked = exercises_[exercise];
    ItemGrade grade;
    grade.exercise = asked.id;
    grade.of = asked.points;
    grade.variant = variant_of(course, hand_in.student, asked.id, asked.variants.size());
    const HandInItem* const item = hand_in.find(asked.id);
    if (!item) return grade;
    for (const Attempt& attempt : item->attempts) (attempt.hint > 0 ? grade.hints : grade.tries) += 1;
    if (grade.tries == 0) return grade;
    if (item->variant != grade.variant) {
        grade.standing = Standing::other_variant;
        return grade;
    }
    const auto give_up = [&](const std::string& why) {
        grade.standing = Standing::not_judged;
        grade.trouble = why;
    };
    if (const Result<LessonStep>& made = step(exercise, grade.variant); !made) {
        give_up(made.error());
        return grade;
    }
    for (const Attempt& attempt : item->attempts) {
        if (attempt.hint > 0) continue;
        const Result<Verdict>& judged = verdict(exercise, grade.variant, attempt);
        if (!judged) {
            give_up(judged.error());
            return grade;
        }
        grade.verdicts.push_back(*judged);
        grade.points = std::max(grade.points, judged->right ? asked.points : std::min(judged->points, asked.points));
    }
    const bool is_right =
        std::any_of(grade.verdicts.begin(), grade.verdicts.end(), [](const Verdict& verdict) { return verdict.right; });
    grade.at_first_try = grade.verdicts.front().right;
    grade.standing = is_right ? Standing::right : grade.points > 0 ? Standing::partly : Standing::wrong;
    return grade;
}

StudentGrade Grader::grade(HandIn hand_in, const std::string& file, const std::optional<std::string>& course) {
    StudentGrade grade;
    grade.file = file;
    grade.hand_in = std::move(hand_in);
    const std::string of_course = course.value_or(grade.hand_in.course);
    if (grade.hand_in.course != of_course)
        grade.notes.push_back("made for the course \"" + excerpt(grade.hand_in.course) + "\"");
    for (std::size_t exercise = 0; exercise < exercises_.size(); ++exercise)
        grade.items.push_back(grade_item(exercise, grade.hand_in, of_course));
    for (const HandInItem& item : grade.hand_in.items)
        if (std::none_of(exercises_.begin(), exercises_.end(),
                         [&](const Exercise& exercise) { return exercise.id == item.exercise; }) &&
            std::find(also_known_.begin(), also_known_.end(), item.exercise) == also_known_.end())
            grade.notes.push_back("has \"" + excerpt(item.exercise) + "\", which is no exercise here");
    if (is_hasty(grade)) grade.notes.emplace_back("all right at the first try, within seconds");
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
            const std::string other = printable(theirs.student);
            if (mine.student == theirs.student) {
                notes.push_back("another file of the same student: " + grades[k].file);
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
    for (const StudentGrade& grade : grades) {
        std::set<std::string> shown, last, possible;  // possible: told apart by an exercise that was tried
        for (std::size_t i = 0; i < grade.items.size(); ++i) {
            const ItemGrade& item = grade.items[i];
            if (item.verdicts.empty()) continue;
            for (const auto& [tag, text] : exercises[i].tags) possible.insert(tag);
            for (const Verdict& verdict : item.verdicts) shown.insert(verdict.tag);
            last.insert(item.last_tag());
            possible.insert(shown.begin(), shown.end());
        }
        for (auto& [tag, count] : counts) {
            count.students += shown.contains(tag) ? 1 : 0;
            count.at_last += last.contains(tag) ? 1 : 0;
            count.students_of += possible.contains(tag) ? 1 : 0;
        }
    }
    std::vector<TagCount> sorted;
    for (const auto& [tag, count] : counts)
        if (count.students > 0) sorted.push_back(count);
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const TagCount& a, const TagCount& b) { return a.students > b.students; });
    return sorted;
}

}  // namespace viewing
