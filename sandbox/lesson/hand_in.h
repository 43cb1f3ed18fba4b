// What a student hands in: one JSON file with every attempt, readable by a person. Whoever grades it trusts only the
// student's number, the answers and the changes; what was told is there to be read. Read report/grading.h next.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lesson/lesson.h"

namespace viewing {

struct Attempt {
    std::string at;                             ///< local time, "2026-11-21T10:03:12"
    std::optional<std::vector<double>> answer;  ///< what was typed, row by row, or the places of what was chosen
    std::vector<std::string> settings;          ///< of a goal: what was changed, PATH=VALUE
    bool is_goal = false;                       ///< `settings` is the answer, though it may be empty
    int hint = 0;                               ///< 1 and more: this hint was looked at, and nothing answered
    std::string told;                           ///< "right", the tag of a misconception, or ""
    bool operator==(const Attempt&) const = default;
};

/// A change of the state on the way to a goal.
struct ReplayStep {
    double after_s = 0.0;  ///< since the exercise was opened
    std::vector<std::string> settings;
    bool operator==(const ReplayStep&) const = default;
};

struct HandInItem {
    std::string exercise;
    std::size_t variant = 0;
    std::vector<Attempt> attempts;
    std::vector<ReplayStep> replay;
    std::optional<std::vector<double>> draft;  ///< what is typed and not checked yet; nothing that is graded
    std::vector<std::string> draft_settings;   ///< the same of a goal
    bool operator==(const HandInItem&) const = default;
};

struct HandIn {
    std::string program, course, student, name;
    std::vector<HandInItem> items;
    bool operator==(const HandIn&) const = default;

    HandInItem* find(const std::string& exercise);
    const HandInItem* find(const std::string& exercise) const;
};

inline constexpr std::size_t most_replay_steps = 200, most_attempts = 1000;

/// The error is one sentence with file and field. `source` opens it.
Result<HandIn> parse_hand_in(std::string_view json, const std::string& source);
Result<HandIn> load_hand_in(const std::filesystem::path& file);

/// A goal is watched: the same mistake twice, on the way to it, is one attempt, the latter.
bool replaces(const Attempt& attempt, const Attempt& before);

std::string hand_in_as_text(const HandIn& hand_in);

/// An attempt's answer as judge() takes it; none where it cannot be one to this question: places beyond the list.
std::optional<Answer> answer_in(const Attempt& attempt, const Ask& ask);

/// The same as an attempt has it; what is no number is 0 there, and infinity a large one.
std::vector<double> answer_numbers(const Answer& answer);

/// Whatever the way in which their numbers are written.
bool are_same_settings(const std::vector<std::string>& a, const std::vector<std::string>& b);

/// What a file of one student is to hold that others write as well. `kept`: what it holds. `known`: what this window
/// knew of it when it read or wrote it last, HandIn{} where it never did. `now`: what the window has. Attempts are
/// united, each once, in the order of their times; what is typed, the way to a goal and the name are the window's where
/// it has changed them since, else the file's. Merging the same once more changes nothing.
HandIn merged(const HandIn& kept, const HandIn& known, const HandIn& now);

/// Writes that, under a lock; the result is what the file holds then, `now` where nothing was answered yet and there is
/// no file. One that cannot be read gets another name (set_aside). The error is one sentence.
Result<HandIn> merge_hand_in(const std::filesystem::path& file, const HandIn& known, const HandIn& now);

/// Every second one left out until there are not more than most_replay_steps; the last one stays.
void thin(std::vector<ReplayStep>& replay);

}  // namespace viewing
