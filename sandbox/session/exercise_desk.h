// A student's exercises in the window: whose they are, the sheet with the numbers that are theirs, and every attempt,
// kept in a file from the moment it is made. Read lesson/exercise.h for the exercises, lesson/hand_in.h for the file.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "lesson/exercise.h"
#include "lesson/hand_in.h"
#include "lesson/run.h"
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

    /// Where answers are kept; empty: nowhere, as in a picture.
    void keep_in(std::filesystem::path folder, std::string program);
    /// Reads the exercises when they are wanted first; an error is one that cannot be read.
    void open();
    bool is_open() const { return is_read_; }
    const Status& trouble() const { return trouble_; }

    /// What was typed of them, complete or not.
    const Student& student() const { return student_; }
    /// Another one's sheet; what was answered at it before comes back. Without a number or a course, and where a
    /// student `practises`, it is the sheet of practice: with numbers that are nobody's, and never handed in.
    void sit_down(const Student& student, bool practises = false);
    bool is_practice() const { return owner_.course.empty() && owner_.number.empty(); }
    /// Number and course are there: a person who practises has a sheet to go back to.
    bool has_own_sheet() const { return !student_.course.empty() && !student_.number.empty(); }
    /// How many exercises of practice were tried, and how many of them ask for the numbers of this student as well and
    /// have attempts that this sheet does not have. Where numbers differ an answer is no answer here.
    struct Practised {
        int all = 0, with_own_numbers = 0;
    };
    Practised practised() const;
    /// Adds the attempts and answers of these to the sheet; practice keeps them too.
    void take_over_practice();
    /// Goes on with answers that were saved, as update() tells; with those that are kept here for the same student.
    void open_hand_in(const std::filesystem::path& file);
    /// A hand-in that was opened from a file: its student's sheet with its attempts.
    void take_hand_in(HandIn hand_in);

    /// Called once a frame: what was read is taken over, what has changed is written beside the window. The error is
    /// that of a file.
    Status update(double now_s);
    /// Until what waits to be written wants an update(), though nothing else happens; negative: nothing waits.
    double update_due_in_s(double now_s) const;
    /// All that waits is written, now.
    Status finish();
    /// Another window may have written the same student's answers: the next update() takes them over.
    void read_again();

    const std::vector<Entry>& entries() const { return entries_; }
    /// The place of the variant that is to be made next: by whoever knows its numbers. None: all are there.
    std::optional<std::size_t> next_to_make() const;
    void take_step(std::size_t entry, Result<LessonStep> step) { entries_[entry].step = std::move(step); }
    bool is_ready() const { return is_read_ && !reading_.is_running() && !next_to_make(); }

    /// The exercises at these places as something that leads, with what was done at each.
    LessonRun sheet(const std::vector<std::size_t>& places) const;
    /// The same, standing at one of them; none where that could not be made.
    std::optional<LessonRun> sheet_at(const std::string& exercise, const std::vector<std::size_t>& places) const;
    const HandIn& hand_in() const { return hand_in_; }
    bool is_right(const std::string& exercise) const;
    bool is_tried(const std::string& exercise) const;
    int points() const, points_of() const;

    /// An answer that was judged.
    void record(const LessonRun& run, const Verdict& verdict, const Params& params);
    /// Called once a frame while a sheet leads: hints that were looked at, what is typed, what is changed on the way to
    /// a goal. `is_at_rest`: nothing is held.
    void follow(const LessonRun& run, const Params& params, bool is_at_rest, double now_s);

private:
    /// What is had of a file, and what is on the disk.
    struct Opened {
        HandIn hand_in, on_disk, practice;
    };
    void begin_sheet();
    Status take_what_was_read();
    Status take_what_was_written();
    void take_from_disk(HandIn on_disk, const HandIn& known);
    void write_what_changed();
    bool is_of_student(const LessonRun& run) const;  ///< a sheet that still leads may be another's
    void add(HandInItem& item, Attempt attempt);
    HandInItem& item(const std::string& exercise, std::size_t variant);
    const HandInItem* own_item(const std::string& exercise) const;  ///< null where its variant is another's
    /// What this student practised with numbers that are theirs too.
    HandIn practice_with_own_numbers() const;
    void choose_variants();
    std::filesystem::path file(const Student& owner) const;

    bool is_read_ = false, has_changed_ = false;
    Status trouble_ = std::monostate{};
    std::filesystem::path folder_;
    std::string program_;
    Student student_;  ///< as typed
    Student owner_;    ///< whose numbers and file: of practice no number and no course
    HandIn practice_;  ///< beside another sheet, as it was when that was opened
    std::vector<Entry> entries_;
    HandIn hand_in_;
    HandIn known_;  ///< what the file held when it was read or written last: other windows write it too
    HandIn sent_;   ///< what is being written
    BackgroundTask<Opened> reading_;
    bool is_another_ = false;    ///< what is being read says itself whose it is
    bool is_unwritten_ = false;  ///< the latest writing failed: finish() tries once more
    BackgroundTask<HandIn> writing_;
    double written_s_ = -1.0;

    std::string followed_;  ///< the exercise that is being done
    double followed_since_s_ = 0.0;
    std::optional<Params> last_;                     ///< its latest state that was noted
    std::optional<std::vector<double>> last_typed_;  ///< its latest answer here, noted or not
};

/// The file's name in which a student's answers to a course are kept: letters, digits, - and _, others as %XX, and a
/// tilde between the two.
std::string answers_file_name(const Student& student);

}  // namespace viewing
