// A student's exercises in the window: the student, the sheet with their numbers, and every attempt, saved in a file
// immediately. Read lesson/exercise.h for the exercises, lesson/hand_in.h for the file.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "lesson/exercise.h"
#include "lesson/hand_in.h"
#include "lesson/lesson_run.h"
#include "platform/background.h"
#include "session/session.h"
#include "state/person/lesson_progress.h"

namespace viewing {

class ExerciseDesk {
public:
    struct Entry {
        Exercise exercise;
        std::size_t variant = 0;
        std::optional<Result<LessonStep>> step;  ///< none until it is made
    };

    /// Sets the folder for answers. If the path is empty, as when the program only draws a picture, nothing is saved.
    void keep_in(std::filesystem::path folder, std::string program);
    /// Reads the exercises on first use. If one cannot be read, trouble() returns the error.
    void open();
    bool is_open() const { return is_read_; }
    const Status& trouble() const { return trouble_; }

    /// Returns the student's data as typed, complete or not.
    const Student& student() const { return student_; }
    /// Opens a student's sheet and restores its earlier answers. If the number or the course is missing, or if the
    /// student `practices`, opens the practice sheet instead. Its numbers belong to nobody, and it is never handed in.
    void sit_down(const Student& student, bool practices = false);
    bool is_practice() const { return owner_.course.empty() && owner_.number.empty(); }
    /// Whether the student's number and course are known; if so, a practicing student can return to their own sheet.
    bool has_own_sheet() const { return !student_.course.empty() && !student_.number.empty(); }
    /// The number of exercises that the student has tried in practice, and the number of those that have the student's
    /// own numbers and include attempts that the open sheet lacks.
    struct Practiced {
        int all = 0, with_own_numbers = 0;
    };
    Practiced practiced() const;
    /// Adds to the sheet those practice attempts and answers that have the student's own numbers; the practice sheet
    /// keeps them too.
    void take_over_practice();
    /// Continues with a file of saved answers, merged with those stored for the same student; update() reports the
    /// outcome.
    void open_hand_in(const std::filesystem::path& file);
    /// Opens the sheet of the student named in a hand-in, with the attempts that the hand-in contains.
    void take_hand_in(HandIn hand_in);

    /// Called once a frame: applies finished reads, and writes changes in the background. Returns the error of a read
    /// or write.
    Status update(double now_s);
    /// Returns the time until a pending change needs an update(), even if nothing else happens; negative if no change
    /// is pending.
    double update_due_in_s(double now_s) const;
    /// Writes all pending changes now.
    Status finish();
    /// Makes update() merge with this student's file again, which another window may have written.
    void read_again();

    const std::vector<Entry>& entries() const { return entries_; }
    /// Returns the index of the next exercise whose step must be made; none if all are made, or while a file is being
    /// read. The caller makes the step, which computes the exercise's numbers, and passes it to take_step().
    std::optional<std::size_t> next_to_make() const;
    void take_step(std::size_t entry, Result<LessonStep> step) { entries_[entry].step = std::move(step); }
    bool is_ready() const { return is_read_ && !reading_.is_running() && !next_to_make(); }

    /// Returns the exercises at these indices as a run, with the earlier work on each.
    LessonRun sheet(const std::vector<std::size_t>& places) const;
    /// Returns the same run, opened at one of the exercises; none if that exercise could not be made.
    std::optional<LessonRun> sheet_at(const std::string& exercise, const std::vector<std::size_t>& places) const;
    const HandIn& hand_in() const { return hand_in_; }
    bool is_right(const std::string& exercise) const;
    bool is_tried(const std::string& exercise) const;
    int points() const, points_of() const;

    /// Records a judged answer.
    void record(const LessonRun& run, const Verdict& verdict, const Params& params);
    /// Called once a frame while a sheet is open: records hints shown, answers typed, and changes on the way to a goal.
    /// `is_at_rest` is true if no control is held.
    void follow(const LessonRun& run, const Params& params, bool is_at_rest, double now_s);

private:
    /// The contents of an opened file, of the student's file on disk, and of the practice file.
    struct Opened {
        HandIn hand_in, on_disk, practice;
    };
    void begin_sheet();
    Status take_what_was_read();
    Status take_what_was_written();
    void take_from_disk(HandIn on_disk, const HandIn& known);
    void write_what_changed();
    bool is_of_student(const LessonRun& run) const;  ///< an open sheet may be another student's
    void add(HandInItem& item, Attempt attempt);
    HandInItem& item(const std::string& exercise, std::size_t variant);
    const HandInItem* own_item(const std::string& exercise) const;  ///< null if its variant is another student's
    /// Returns the attempted items of the practice sheet whose variant is also the one in the student's own sheet.
    HandIn practice_with_own_numbers() const;
    void choose_variants();
    std::filesystem::path file(const Student& owner) const;

    bool is_read_ = false, has_changed_ = false;
    Status trouble_ = std::monostate{};
    std::filesystem::path folder_;
    std::string program_;
    Student student_;  ///< as typed
    Student owner_;    ///< the student whose numbers and file are used; for practice, number and course are empty
    HandIn practice_;  ///< the practice sheet, read when another sheet was opened
    std::vector<Entry> entries_;
    HandIn hand_in_;
    HandIn known_;  ///< the file's content when last read or written; other windows write it too
    HandIn sent_;   ///< the content being written
    BackgroundTask<Opened> reading_;
    bool is_another_ = false;    ///< the file being read determines the student
    bool is_unwritten_ = false;  ///< the last write failed; finish() retries it
    BackgroundTask<HandIn> writing_;
    double written_s_ = -1.0;

    std::string followed_;  ///< the current exercise
    double followed_since_s_ = 0.0;
    std::optional<Params> last_;                     ///< the exercise's last recorded state
    std::optional<std::vector<double>> last_typed_;  ///< the exercise's last answer in this window, recorded or not
};

/// Returns the name of the file with a student's answers in a course. The name keeps letters, digits, - and _, writes
/// other bytes as %XX, and has a tilde between course and number.
std::string answers_file_name(const Student& student);

/// Returns the usual name of a file to hand in: "32201234_홍길동.json". Characters that some file systems refuse become
/// "-". If both number and name are empty, the file is "answers.json".
std::string hand_in_file_name(const Student& student);

}  // namespace viewing
