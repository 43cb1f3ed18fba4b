// A student's hand-in: one JSON file with every attempt, which people can read, too. Grading trusts only the student
// number, the answers and the changes; the verdicts are for human readers. Read grading/grading.h next.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lesson/lesson.h"

namespace viewing {

struct Attempt {
    std::string at;                             ///< local time, "2026-11-21T10:03:12"
    std::optional<std::vector<double>> answer;  ///< entered numbers row by row, or indices of the chosen items
    std::vector<std::string> settings;          ///< for a goal: the changes, PATH=VALUE
    bool is_goal = false;                       ///< `settings` is the answer, even if empty
    int hint = 0;                               ///< if above 0, this hint was shown, and nothing was answered
    std::string told;                           ///< "right", the tag of a misconception, or ""
    bool operator==(const Attempt&) const = default;
};

/// A change of the state while the student works toward a goal.
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
    std::optional<std::vector<double>> draft;  ///< entered but not checked yet; not graded
    std::vector<std::string> draft_settings;   ///< for a goal: changes that are not checked yet
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

/// Reads a hand-in. The error is one sentence that names the file and the field, and begins with `source`.
Result<HandIn> parse_hand_in(std::string_view json, const std::string& source);
Result<HandIn> load_hand_in(const std::filesystem::path& file);

/// An exercise, or an attempt at it, that cannot be read.
struct LeftOut {
    std::string exercise;  ///< "" if its name cannot be read either
    std::string why;       ///< names the place in the file: "items[2].attempts[0].answer must be numbers"
};

/// The readable part of a hand-in, for grading. A window must not write this over the student's file.
struct ReadableHandIn {
    HandIn hand_in;
    std::vector<LeftOut> left_out;  ///< in the order of the file
};

/// Reads a hand-in and leaves out what cannot be read: single attempts, otherwise whole exercises; also the second
/// and later items of an exercise. The error means that nothing of the file can be graded.
Result<ReadableHandIn> load_readable_hand_in(const std::filesystem::path& file);

/// Returns the JSON Schema of hand-ins.
std::string hand_in_schema();

/// Whether an attempt replaces the previous one. Goals are checked continuously, so the same mistake twice in a row
/// counts as one attempt, the later one.
bool replaces(const Attempt& attempt, const Attempt& before);

std::string hand_in_as_text(const HandIn& hand_in);

/// Returns an attempt's answer for judge(); none if it cannot answer this question, for example with an index out of
/// range.
std::optional<Answer> answer_in(const Attempt& attempt, const Ask& ask);

/// Returns the answer in the form that an attempt stores. NaN becomes 0, and infinity becomes a large number.
std::vector<double> answer_numbers(const Answer& answer);

/// Compares settings by value: the same number may be written in different ways.
bool are_same_settings(const std::vector<std::string>& a, const std::vector<std::string>& b);

/// Merges this window's answers with a student's file, which several windows may write. `kept` is the file's content,
/// `known` is the content that this window last read or wrote (HandIn{} if it never did), and `now` has its current
/// answers. Keeps every attempt from `kept` and `now`, without duplicates, in chronological order. Drafts, replays and
/// the name come from this window if it has changed them since `known`, otherwise from the file; if both have changed a
/// replay, the longer one is kept. Merging again changes nothing.
HandIn merged(const HandIn& kept, const HandIn& known, const HandIn& now);

/// Merges the answers into the file under a lock. Returns the file's new content, or `now` if there is no file and
/// nothing has been answered yet. Renames a file that cannot be read (set_aside). The error is one sentence.
Result<HandIn> merge_hand_in(const std::filesystem::path& file, const HandIn& known, const HandIn& now);

/// Drops every second step, repeatedly, until at most most_replay_steps are left. Always keeps the last step.
void thin(std::vector<ReplayStep>& replay);

}  // namespace viewing
