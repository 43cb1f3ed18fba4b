// The desk gives every student a sheet of their own and writes answers to the disk before anything can lose them. The
// steps are made by hand, since the content of an exercise does not matter here.
#include "session/exercise_desk.h"

#include <gtest/gtest.h>

#include <chrono>
#include <limits>
#include <memory>
#include <set>
#include <thread>

#include "lesson/questions/judge.h"
#include "lesson/variants.h"
#include "platform/shared_file.h"
#include "platform/text_file.h"
#include "session/guide.h"
#include "state/file/state_json.h"
#include "unit/state/scratch_folder.h"

namespace viewing {
namespace {

namespace fs = std::filesystem;

constexpr const char *number_id = "E06-radians", *matrix_id = "E16-shadow-matrix", *goal_id = "E18-place-the-light",
                     *order_id = "E08-bsp-order";
const Student anna{"viewing-2026", "32201234", "김학생"}, ben{"viewing-2026", "32201235", "Ben"};

/// Makes a matrix, list, goal or number step, depending on its id; the correct answer to a number step is 7.
LessonStep step_of(const std::string& id) {
    LessonStep step;
    step.id = id;
    step.start = *load_state("");
    step.revealed = step.start.params;
    step.say = {{"Look.", ""}};
    step.ask.hints = {{{"one", ""}}, {{"two", ""}}, {{"three", ""}}};
    step.ask.kind = AskKind::number;
    step.ask.expect = "7";
    if (id == matrix_id) {
        step.ask.kind = AskKind::matrix;
        step.ask.rows = step.ask.columns = 4;
    } else if (id == order_id) {
        step.ask.kind = AskKind::subset;
        step.ask.items.resize(4);
        step.ask.expected_items = {{0, 2}};
    } else if (id == goal_id) {
        step.ask.kind = AskKind::goal;
        step.ask.until = "true";
        step.ask.allow = {"light.position"};
        step.revealed.lights[0].position = {9, 9, 9, 1};
    }
    return step;
}

Params with_light(Params params, double x) {
    params.lights[0].position = {x, 4.5, -0.25, 1.0};
    return params;
}

Verdict right() {
    Verdict verdict;
    verdict.right = true;
    return verdict;
}

Verdict wrong(const std::string& tag = "") {
    Verdict verdict;
    verdict.tag = tag;
    return verdict;
}

class ExerciseDeskTest : public testing::ScratchFolder {
protected:
    /// Returns a desk where this student sits and every step is made.
    std::unique_ptr<ExerciseDesk> desk_of(const Student& student) {
        auto desk = std::make_unique<ExerciseDesk>();
        desk->keep_in(answers_, "viewing-sandbox test");
        desk->open();
        desk->sit_down(student);
        settle(*desk);
        return desk;
    }
    /// Updates until the file is read and the steps are made.
    void settle(ExerciseDesk& desk) {
        for (const double end_s = now_s() + patience_s; now_s() < end_s;) {
            update(desk);
            while (const std::optional<std::size_t> next = desk.next_to_make())
                desk.take_step(*next, step_of(desk.entries()[*next].exercise.id));
            if (desk.is_ready()) return;
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        ADD_FAILURE() << "the desk never becomes ready";
    }
    /// Keeps updating for a while, as a window does.
    void wait(ExerciseDesk& desk, double seconds = 0.6) {
        for (const double end_s = now_s() + seconds; now_s() < end_s;) {
            update(desk);
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
    }
    /// Updates until the draft is in the file, which takes a while on a slow disk.
    void wait_until_written(ExerciseDesk& desk, const Student& student, const std::vector<double>& draft) {
        const auto is_there = [&] {
            const Result<HandIn> read = load_hand_in(file_of(student));
            const HandInItem* const item = read ? read->find(number_id) : nullptr;
            return item && item->draft == draft;
        };
        for (const double end_s = now_s() + patience_s; !is_there() && now_s() < end_s;) wait(desk, 0.01);
        EXPECT_TRUE(is_there());
    }
    void update(ExerciseDesk& desk) { hear(desk.update(now_s())); }
    void finish(ExerciseDesk& desk) { hear(desk.finish()); }
    void hear(const Status& status) {
        if (!status) told_ = status.error();
    }
    double now_s() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun_).count(); }

    static std::size_t place(const ExerciseDesk& desk, const std::string& id) {
        for (std::size_t i = 0; i < desk.entries().size(); ++i)
            if (desk.entries()[i].exercise.id == id) return i;
        ADD_FAILURE() << id;
        return 0;
    }
    /// Returns a run through all exercises, positioned at the given one.
    static LessonRun run_at(const ExerciseDesk& desk, const std::string& id) {
        std::vector<std::size_t> places;
        for (std::size_t i = 0; i < desk.entries().size(); ++i) places.push_back(i);
        LessonRun run = desk.sheet(places);
        run.go_to(place(desk, id));
        return run;
    }
    void type(ExerciseDesk& desk, const std::string& id, std::vector<double> numbers) {
        LessonRun run = run_at(desk, id);
        run.answer() = {std::move(numbers), {}};
        desk.follow(run, run.step().start.params, true, now_s());
    }
    static void check(ExerciseDesk& desk, const std::string& id, const Answer& answer, const Verdict& verdict) {
        LessonRun run = run_at(desk, id);
        run.answer() = answer;
        run.take(verdict);
        desk.record(run, verdict, run.step().start.params);
    }

    fs::path file_of(const Student& student) const { return answers_ / answers_file_name(student); }
    HandIn written(const Student& student) const {
        const Result<HandIn> read = load_hand_in(file_of(student));
        EXPECT_TRUE(read) << (read ? "" : read.error());
        return read ? *read : HandIn{};
    }
    std::vector<fs::path> files() const {
        std::vector<fs::path> found;
        for (const auto& entry : fs::recursive_directory_iterator(folder_))
            if (entry.is_regular_file() && entry.path().filename() != FolderLock::file_name)
                found.push_back(entry.path());
        return found;
    }

    static constexpr double patience_s = 60.0;
    std::string told_;  ///< the latest error
    fs::path answers_ = folder_ / "deep" / "answers";
    std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
};

TEST_F(ExerciseDeskTest, EachStudentHasOwnVariants) {
    ExerciseDesk desk;
    desk.keep_in(answers_, "p");
    EXPECT_FALSE(desk.is_open());
    EXPECT_TRUE(desk.entries().empty());
    desk.open();
    EXPECT_TRUE(desk.is_open());
    ASSERT_EQ(desk.entries().size(), 26U);
    EXPECT_TRUE(desk.trouble());
    for (const Student& student : {anna, ben, Student{"그래픽스", "../..", ""}}) {
        desk.sit_down(student);
        EXPECT_EQ(desk.student(), student);
        EXPECT_FALSE(desk.is_ready());
        EXPECT_EQ(desk.next_to_make(), 0U) << "every step is made again";
        for (const ExerciseDesk::Entry& entry : desk.entries()) {
            EXPECT_FALSE(entry.step);
            EXPECT_EQ(entry.variant,
                      variant_of(student.course, student.number, entry.exercise.id, entry.exercise.variants.size()));
        }
        settle(desk);
        EXPECT_TRUE(desk.is_ready());
    }
    EXPECT_EQ(desk.points(), 0);
    EXPECT_EQ(desk.points_of(), 53);
    EXPECT_TRUE(files().empty()) << "nothing has been answered";
}

TEST_F(ExerciseDeskTest, StepThatCannotBeMadeIsSkipped) {
    ExerciseDesk desk;
    desk.open();
    while (const std::optional<std::size_t> next = desk.next_to_make())
        if (*next == 1)
            desk.take_step(*next, Error{"no"});
        else
            desk.take_step(*next, step_of(desk.entries()[*next].exercise.id));
    EXPECT_TRUE(desk.is_ready());
    const LessonRun run = desk.sheet({0, 1, 2});
    ASSERT_EQ(run.lesson().steps.size(), 2U);
    EXPECT_EQ(run.lesson().sheet->items[1].exercise, desk.entries()[2].exercise.id);
}

TEST_F(ExerciseDeskTest, TypedAnswersAreSavedAutomatically) {
    const auto desk = desk_of(anna);
    type(*desk, number_id, {0.125});
    wait_until_written(*desk, anna, {0.125});
    EXPECT_EQ(told_, "");
    const HandIn read = written(anna);  // the desk was not closed, as if it had been killed
    EXPECT_EQ(read.student, anna.number);
    EXPECT_EQ(read.course, anna.course);
    EXPECT_EQ(read.name, anna.name);
    EXPECT_EQ(read.program, "viewing-sandbox test");
    ASSERT_TRUE(read.find(number_id));
    EXPECT_EQ(read.find(number_id)->draft, std::optional(std::vector{0.125}));
    EXPECT_EQ(read.find(number_id)->variant, desk->entries()[place(*desk, number_id)].variant);
    EXPECT_TRUE(read.find(number_id)->attempts.empty());
    // Changes made during a write are written too.
    for (int i = 1; i <= 50; ++i) {
        type(*desk, number_id, {static_cast<double>(i)});
        wait(*desk, 0.01);
    }
    wait_until_written(*desk, anna, {50.0});
    EXPECT_EQ(files().size(), 1U) << "no other file remains";
}

TEST_F(ExerciseDeskTest, SleepingWindowKnowsWhenTheNextWriteIsDue) {
    const auto desk = desk_of(anna);
    const auto draft = [this] { return written(anna).find(number_id)->draft; };
    const auto sleep = [] { std::this_thread::sleep_for(std::chrono::milliseconds(5)); };
    double window_s = 100.0;
    EXPECT_LT(desk->update_due_in_s(window_s), 0.0) << "no write is pending";
    type(*desk, number_id, {1.0});
    EXPECT_EQ(desk->update_due_in_s(window_s), 0.0);
    hear(desk->update(window_s));
    EXPECT_LT(desk->update_due_in_s(window_s), 0.0) << "the end of the write wakes the window";

    type(*desk, number_id, {2.0});  // comes during the write; no more input follows
    window_s += 0.1;
    for (const double end_s = now_s() + patience_s; desk->update_due_in_s(window_s) < 0.0 && now_s() < end_s;) {
        sleep();
        hear(desk->update(window_s));
    }
    EXPECT_EQ(draft(), std::optional(std::vector{1.0}));
    ASSERT_NEAR(desk->update_due_in_s(window_s), 0.2, 1e-9) << "writes are throttled";
    window_s += desk->update_due_in_s(window_s);
    hear(desk->update(window_s));
    for (const double end_s = now_s() + patience_s; draft() != std::vector{2.0} && now_s() < end_s;) sleep();
    EXPECT_EQ(draft(), std::optional(std::vector{2.0}));
    EXPECT_EQ(told_, "");
}

TEST_F(ExerciseDeskTest, FinishWritesImmediately) {
    const auto desk = desk_of(anna);
    for (int i = 1; i <= 5; ++i) {
        type(*desk, number_id, {static_cast<double>(i)});
        update(*desk);
    }
    type(*desk, number_id, {6.0});
    finish(*desk);
    EXPECT_EQ(told_, "");
    EXPECT_EQ(written(anna).find(number_id)->draft, std::optional(std::vector{6.0}));
}

TEST_F(ExerciseDeskTest, EverythingComesBackUnchanged) {
    std::vector<double> matrix(16);
    for (std::size_t i = 0; i < 16; ++i) matrix[i] = static_cast<double>(i) / 3.0 - 1.0;
    {
        const auto desk = desk_of(anna);
        check(*desk, number_id, {{6.5}, {}}, wrong("M02"));
        check(*desk, number_id, {{7.0}, {}}, right());
        check(*desk, order_id, {{}, {3, 1}}, wrong());
        type(*desk, matrix_id, matrix);
        LessonRun run = run_at(*desk, matrix_id);
        run.show_hint();
        run.show_hint();
        desk->follow(run, run.step().start.params, true, now_s());
        desk->follow(run, run.step().start.params, true, now_s());
        LessonRun goal = run_at(*desk, goal_id);
        desk->follow(goal, goal.step().start.params, true, 10.0);
        desk->follow(goal, with_light(goal.step().start.params, 1.5), true, 12.0);
        desk->follow(goal, with_light(goal.step().start.params, 99.0), false, 13.0);
        desk->follow(goal, with_light(goal.step().start.params, 2.5), true, 14.5);
        EXPECT_TRUE(desk->is_right(number_id));
        EXPECT_FALSE(desk->is_right(order_id));
        EXPECT_TRUE(desk->is_tried(order_id));
        EXPECT_FALSE(desk->is_tried(matrix_id)) << "a hint is not an attempt";
        finish(*desk);
        EXPECT_EQ(told_, "");
    }
    const auto desk = desk_of(anna);
    const HandInItem* const item = desk->hand_in().find(number_id);
    ASSERT_TRUE(item);
    ASSERT_EQ(item->attempts.size(), 2U);
    EXPECT_EQ(item->attempts[0].answer, std::optional(std::vector{6.5}));
    EXPECT_EQ(item->attempts[0].told, "M02");
    EXPECT_EQ(item->attempts[0].at.size(), std::string("2026-11-21T10:03:12").size());
    EXPECT_EQ(item->attempts[1].told, "right");
    LessonRun run = run_at(*desk, number_id);
    EXPECT_TRUE(run.is_revealed());
    EXPECT_TRUE(run.is_done(run.index()));
    EXPECT_EQ(run.answer().numbers, std::vector{7.0});
    EXPECT_EQ(desk->points(), desk->entries()[place(*desk, number_id)].exercise.points);
    run.go_to(place(*desk, order_id));
    EXPECT_FALSE(run.is_revealed());
    EXPECT_EQ(run.answer().items, (std::vector{3, 1}));
    run.go_to(place(*desk, matrix_id));
    EXPECT_EQ(run.answer().numbers, matrix);
    EXPECT_EQ(run.hints_shown(), 2);
    const std::vector<Attempt>& hints = desk->hand_in().find(matrix_id)->attempts;
    ASSERT_EQ(hints.size(), 2U) << "each hint counts once";
    EXPECT_EQ(hints[0].hint, 1);
    EXPECT_EQ(hints[1].hint, 2);
    run.go_to(place(*desk, goal_id));
    EXPECT_FALSE(run.is_revealed());
    ASSERT_TRUE(run.reached());
    EXPECT_EQ(*run.reached(), with_light(run.step().start.params, 2.5));
    const std::vector<ReplayStep>& replay = desk->hand_in().find(goal_id)->replay;
    ASSERT_EQ(replay.size(), 2U) << "a held drag is not a step";
    EXPECT_EQ(replay[0].after_s, 2.0);
    EXPECT_EQ(replay[1].after_s, 4.5);
}

TEST_F(ExerciseDeskTest, ReachedGoalComesBackUnchanged) {
    {
        const auto desk = desk_of(anna);
        LessonRun run = run_at(*desk, goal_id);
        desk->follow(run, with_light(run.step().start.params, 1.0), true, 1.0);
        for (int i = 0; i < 5; ++i) desk->record(run, wrong("M26"), with_light(run.step().start.params, 1.0 + i));
        desk->follow(run, with_light(run.step().start.params, 3.0), true, 3.0);
        run.take(right());
        desk->record(run, right(), with_light(run.step().start.params, 4.0));
        desk->follow(run, with_light(run.step().start.params, 8.0), true, 9.0);  // ignored: already revealed
        finish(*desk);
    }
    const auto desk = desk_of(anna);
    LessonRun run = run_at(*desk, goal_id);
    EXPECT_TRUE(run.is_revealed());
    ASSERT_TRUE(run.reached());
    EXPECT_EQ(*run.reached(), with_light(run.step().start.params, 4.0));
    const std::vector<Attempt>& attempts = desk->hand_in().find(goal_id)->attempts;
    ASSERT_EQ(attempts.size(), 2U) << "the same mistake along the way is one attempt";
    EXPECT_EQ(attempts[0].told, "M26");
    EXPECT_TRUE(attempts[1].is_goal);
    const Result<Params> kept = apply_settings(run.step().start.params, attempts[1].settings);
    ASSERT_TRUE(kept) << kept.error();
    EXPECT_EQ(*kept, with_light(run.step().start.params, 4.0));
}

TEST_F(ExerciseDeskTest, ReturningChangesNothing) {
    {
        const auto desk = desk_of(anna);
        LessonRun run = run_at(*desk, goal_id);
        desk->follow(run, with_light(run.step().start.params, 2.0), true, 1.0);
        type(*desk, number_id, {4.0});
        finish(*desk);
    }
    const std::string before = *read_text_file(file_of(anna));
    const auto desk = desk_of(anna);
    LessonRun run = run_at(*desk, goal_id);
    ASSERT_TRUE(run.reached());
    desk->follow(run, *run.reached(), true, 1.0);
    run.go_to(place(*desk, number_id));
    desk->follow(run, run.step().start.params, true, 2.0);
    EXPECT_EQ(desk->hand_in().find(goal_id)->replay.size(), 1U);
    finish(*desk);
    EXPECT_TRUE(*read_text_file(file_of(anna)) == before) << *read_text_file(file_of(anna));
}

TEST_F(ExerciseDeskTest, DraftIsNewerThanTheCheckedAnswer) {
    {
        const auto desk = desk_of(anna);
        check(*desk, number_id, {{6.5}, {}}, wrong());
        type(*desk, number_id, {6.75});
        finish(*desk);
        EXPECT_EQ(run_at(*desk, number_id).answer().numbers, std::vector{6.75});
    }
    const auto desk = desk_of(anna);
    EXPECT_EQ(run_at(*desk, number_id).answer().numbers, std::vector{6.75});
    check(*desk, number_id, {{6.875}, {}}, wrong());
    EXPECT_EQ(run_at(*desk, number_id).answer().numbers, std::vector{6.875});
    EXPECT_FALSE(desk->hand_in().find(number_id)->draft) << "checking removes the draft";
}

TEST_F(ExerciseDeskTest, OtherStudentsSheetIsBlankAndNothingIsLost) {
    const auto desk = desk_of(anna);
    check(*desk, number_id, {{7.0}, {}}, right());
    type(*desk, matrix_id, std::vector<double>(16, 0.5));
    desk->sit_down(ben);  // immediately: nothing is written yet
    settle(*desk);
    EXPECT_TRUE(desk->hand_in().items.empty());
    EXPECT_EQ(desk->points(), 0);
    EXPECT_TRUE(run_at(*desk, matrix_id).answer().empty());
    type(*desk, number_id, {3.0});
    desk->sit_down(anna);
    settle(*desk);
    EXPECT_TRUE(desk->is_right(number_id));
    EXPECT_EQ(run_at(*desk, matrix_id).answer().numbers, std::vector<double>(16, 0.5));
    finish(*desk);
    EXPECT_EQ(written(anna).items.size(), 2U);
    EXPECT_EQ(written(ben).find(number_id)->draft, std::optional(std::vector{3.0}));
    EXPECT_EQ(written(ben).items.size(), 1U);
    EXPECT_EQ(written(ben).name, "Ben");
}

TEST_F(ExerciseDeskTest, SheetBelongsToTheLastStudent) {
    {
        const auto desk = desk_of(anna);
        LessonRun run = run_at(*desk, goal_id);
        for (int i = 0; i < 900; ++i)  // enough to take a while to read
            desk->record(run, wrong(std::to_string(i)), with_light(run.step().start.params, i));
        finish(*desk);
    }
    const auto desk = desk_of({"viewing-2026", "nobody", ""});
    for (int turn = 0; turn < 10; ++turn) {
        desk->sit_down(anna);
        desk->sit_down(ben);  // while the first student's file is being read
        settle(*desk);
        wait(*desk, 0.1);
        ASSERT_EQ(desk->student(), ben);
        ASSERT_TRUE(desk->hand_in().items.empty()) << "the answers of " << desk->hand_in().student;
    }
    type(*desk, number_id, {1.0});
    finish(*desk);
    EXPECT_EQ(written(ben).items.size(), 1U);
    EXPECT_EQ(written(anna).find(goal_id)->attempts.size(), 900U);
}

TEST_F(ExerciseDeskTest, SheetInProgressStaysWithItsStudent) {
    const auto desk = desk_of(anna);
    LessonRun run = run_at(*desk, number_id);
    run.answer().numbers = {5.0};
    run.show_hint();
    desk->follow(run, run.step().start.params, true, now_s());
    desk->sit_down(ben);
    settle(*desk);
    // The window's guide still shows the exercise that was started before the other student sat down.
    desk->follow(run, run.step().start.params, true, now_s());
    desk->record(run, wrong("M02"), run.step().start.params);
    EXPECT_TRUE(desk->hand_in().items.empty()) << "the sheet was the other student's";
    finish(*desk);
    EXPECT_EQ(written(anna).find(number_id)->draft, std::optional(std::vector{5.0}));
}

TEST_F(ExerciseDeskTest, FilesForAnyStudentNumberStayInTheFolder) {
    const std::string numbers[] = {"../../x", "한국", "..",   ".",   "a/b\\c", "con",
                                   " ",       "%2F",  "x\ty", "-rf", "A",      "a%62"};
    std::set<std::string> names;
    for (const std::string& number : numbers) {
        const std::string name = answers_file_name({"viewing-2026", number, ""});
        EXPECT_TRUE(names.insert(name).second) << number << " has another student's file";
        EXPECT_LT(name.size(), 255U);
        EXPECT_EQ(name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_%.~"),
                  std::string::npos)
            << name;
        EXPECT_EQ(name.find('.'), name.size() - 5) << name;
        const Student student{"../" + number, number, ""};
        const auto desk = desk_of(student);
        type(*desk, number_id, {2.5});
        finish(*desk);
        EXPECT_EQ(told_, "");
    }
    EXPECT_EQ(files().size(), std::size(numbers));
    for (const fs::path& file : files()) EXPECT_EQ(file.parent_path(), answers_) << file;
    const std::string many(5000, 'x'), more = many + "y";
    EXPECT_LT(answers_file_name({"c", many, ""}).size(), 255U);
    EXPECT_LT(answers_file_name({many, "한국", ""}).size(), 255U);
    EXPECT_NE(answers_file_name({"c", many, ""}), answers_file_name({"c", more, ""}));
    EXPECT_NE(answers_file_name({"c", "1", "Anna"}), answers_file_name({"d", "1", "Anna"}));
    EXPECT_EQ(answers_file_name({"c", "1", "Anna"}), answers_file_name({"c", "1", "Ben"})) << "the name is ignored";
}

TEST_F(ExerciseDeskTest, CourseAndNumberAreNotMixedUp) {
    EXPECT_NE(answers_file_name({"a|b", "c", ""}), answers_file_name({"a", "b|c", ""}));
    EXPECT_NE(answers_file_name({"ab", "c", ""}), answers_file_name({"a", "bc", ""}));
}

TEST_F(ExerciseDeskTest, AnswersComeBackForAnyStudentNumber) {
    for (const std::string& number : {std::string("../../x"), std::string("한국"), std::string(" "),
                                      std::string("x\ty"), std::string(), std::string(5000, 'x')}) {
        const Student student{"viewing-2026", number, "n"};
        {
            const auto desk = desk_of(student);
            type(*desk, number_id, {2.5});
            finish(*desk);
        }
        const auto desk = desk_of(student);
        const HandInItem* const item = desk->hand_in().find(number_id);
        EXPECT_TRUE(item && item->draft) << "\"" << number.substr(0, 20) << "\": the answers are gone";
    }
}

TEST_F(ExerciseDeskTest, BrokenFileIsReportedAndKept) {
    fs::create_directories(answers_);
    const std::string broken = R"({"answers": 1, "student": "32201234", "items": [{"exercise": "E16")";
    std::ofstream(file_of(anna)) << broken;
    ExerciseDesk desk;
    desk.keep_in(answers_, "p");
    desk.open();
    desk.sit_down(anna);
    settle(desk);
    EXPECT_NE(told_.find(answers_file_name(anna)), std::string::npos) << told_;
    EXPECT_EQ(told_.find('\n'), std::string::npos);
    wait(desk, 0.2);
    EXPECT_EQ(*read_text_file(file_of(anna)), broken) << "nothing has been answered since";
    type(desk, number_id, {2.5});
    wait(desk);
    finish(desk);
    bool is_kept = false;
    for (const fs::path& file : files()) is_kept = is_kept || *read_text_file(file) == broken;
    EXPECT_TRUE(is_kept) << "the broken file, which may be repairable, is gone";
}

TEST_F(ExerciseDeskTest, EveryRecordReadsBack) {
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double number : {1e301, -1e308, infinity, -infinity, std::nan(""), 5e-324}) {
        fs::remove_all(answers_);
        const auto desk = desk_of(anna);
        type(*desk, order_id, {});
        check(*desk, matrix_id, {std::vector<double>(16, 1.0), {}}, right());
        type(*desk, number_id, {number});
        finish(*desk);
        const auto again = desk_of(anna);
        EXPECT_TRUE(again->is_right(matrix_id)) << number << " lost everything";
        finish(*again);
    }
}

TEST_F(ExerciseDeskTest, MoreThanAThousandAttemptsReadBack) {
    {
        const auto desk = desk_of(anna);
        LessonRun run = run_at(*desk, number_id);
        run.answer().numbers = {1.0};
        for (int i = 0; i < 1100; ++i) desk->record(run, wrong(std::to_string(i)), run.step().start.params);
        run.show_hint();
        desk->follow(run, run.step().start.params, true, now_s());
        finish(*desk);
    }
    const Result<HandIn> read = load_hand_in(file_of(anna));
    ASSERT_TRUE(read) << read.error();
    EXPECT_GE(read->find(number_id)->attempts.size(), 900U);
}

TEST_F(ExerciseDeskTest, MissingFolderIsReported) {
    write("file", "x");
    answers_ = folder_ / "file" / "answers";
    const auto desk = desk_of(anna);
    type(*desk, number_id, {1.0});
    wait(*desk, 0.3);
    finish(*desk);
    EXPECT_NE(told_.find("file"), std::string::npos) << told_;
    EXPECT_EQ(desk->hand_in().find(number_id)->draft, std::optional(std::vector{1.0})) << "it can still be saved";
}

TEST_F(ExerciseDeskTest, NothingIsWrittenWithoutAFolder) {
    answers_.clear();
    const auto desk = desk_of(anna);
    type(*desk, number_id, {1.0});
    wait(*desk, 0.2);
    EXPECT_EQ(told_, "");
    finish(*desk);
    EXPECT_EQ(told_, "");
    EXPECT_TRUE(files().empty());
}

TEST(HandInName, IsNumberAndName) {
    EXPECT_EQ(hand_in_file_name({"viewing-2026", "32201234", "홍길동"}), "32201234_홍길동.json");
    EXPECT_EQ(hand_in_file_name({"viewing-2026", "32201234", ""}), "32201234.json");
    EXPECT_EQ(hand_in_file_name({"", "", "Anna Lee"}), "Anna-Lee.json");
    EXPECT_EQ(hand_in_file_name({"viewing-2026", "", ""}), "answers.json");
    EXPECT_EQ(hand_in_file_name({"", "../a:b*c", "d?\"<>|e"}), "-.-a-b-c_d-----e.json");
    const std::string longest = hand_in_file_name({"", std::string(400, '7'), "홍길동"});
    EXPECT_LE(longest.size(), 125U);
}

TEST_F(ExerciseDeskTest, OpenedHandInBecomesItsStudentsSheet) {
    {
        const auto desk = desk_of(ben);
        check(*desk, number_id, {{7.0}, {}}, right());
        finish(*desk);
    }
    const fs::path elsewhere = folder_ / "answers-ben.json";
    fs::rename(file_of(ben), elsewhere);
    const auto desk = desk_of(anna);
    type(*desk, matrix_id, std::vector<double>(16, 2.0));
    desk->open_hand_in(elsewhere);
    settle(*desk);
    EXPECT_EQ(desk->student(), ben);
    EXPECT_TRUE(desk->is_right(number_id));
    for (const ExerciseDesk::Entry& entry : desk->entries())
        EXPECT_EQ(entry.variant, variant_of(ben.course, ben.number, entry.exercise.id, entry.exercise.variants.size()));
    finish(*desk);
    EXPECT_EQ(written(ben).items.size(), 1U) << "it continues in the folder";
    EXPECT_EQ(written(anna).items.size(), 1U);
    const auto other = desk_of(anna);
    other->open_hand_in(folder_ / "nowhere.json");
    settle(*other);
    EXPECT_NE(told_.find("nowhere.json"), std::string::npos) << told_;
    EXPECT_EQ(other->student(), anna);
    EXPECT_TRUE(other->hand_in().find(matrix_id)) << "a missing file changes nothing";
}

TEST_F(ExerciseDeskTest, OpeningAnOldFileKeepsNewerAnswers) {
    const fs::path old = folder_ / "old.json";
    {
        const auto desk = desk_of(anna);
        check(*desk, number_id, {{6.0}, {}}, wrong());
        finish(*desk);
        fs::copy_file(file_of(anna), old);
        check(*desk, matrix_id, {std::vector<double>(16, 1.0), {}}, right());
        desk->open_hand_in(old);
        settle(*desk);
        wait(*desk, 0.5);
        finish(*desk);
    }
    bool is_kept = false;
    for (const fs::path& file : files()) {
        const Result<HandIn> read = load_hand_in(file);
        is_kept = is_kept || (read && read->find(matrix_id));
    }
    EXPECT_TRUE(is_kept) << "a right answer is lost";
}

TEST_F(ExerciseDeskTest, AnswersToOtherNumbersAreNeitherShownNorCounted) {
    const auto desk = desk_of(anna);
    HandIn hand_in{"p", anna.course, anna.number, anna.name, {}};
    const std::size_t variant = desk->entries()[place(*desk, number_id)].variant;
    Attempt attempt;
    attempt.answer = {7.0};
    attempt.told = "right";
    hand_in.items = {{number_id, variant + 1, {attempt}, {}, {}, {}}};
    desk->take_hand_in(hand_in);
    settle(*desk);
    const LessonRun run = run_at(*desk, number_id);
    EXPECT_FALSE(run.is_revealed());
    EXPECT_TRUE(run.answer().empty());
    EXPECT_EQ(desk->points(), 0) << "the sheet does not show the exercise as done";
}

TEST_F(ExerciseDeskTest, ForgedFileDoesNoHarm) {
    const auto desk = desk_of(anna);
    HandIn hand_in{"p", anna.course, anna.number, anna.name, {}};
    const auto item = [&](const char* id) {
        return HandInItem{id, desk->entries()[place(*desk, id)].variant, {}, {}, {}, {}};
    };
    HandInItem matrix = item(matrix_id), order = item(order_id), goal = item(goal_id);
    matrix.draft = std::vector<double>(5, 1.0);
    Attempt beyond;
    beyond.answer = {0.0, 17.0};
    order.attempts = {beyond};
    Attempt hint;
    hint.hint = 99;
    order.attempts.push_back(hint);
    goal.draft_settings = {"camera.yaw=3"};
    hand_in.items = {matrix, order, goal, {"E99-unknown", 0, {beyond}, {}, {}, {}}};
    desk->take_hand_in(hand_in);
    settle(*desk);
    LessonRun run = run_at(*desk, matrix_id);
    EXPECT_TRUE(run.answer().empty());
    run.go_to(place(*desk, order_id));
    EXPECT_TRUE(run.answer().empty());
    EXPECT_EQ(run.hints_shown(), 3);
    run.go_to(place(*desk, goal_id));
    EXPECT_FALSE(run.reached()) << "the goal does not allow this change";
    finish(*desk);
    EXPECT_EQ(desk->points(), 0);
}

// ---- two windows with the same answers ------------------------------------------------------------------------------

TEST_F(ExerciseDeskTest, TwoWindowsLoseNothingOfEachOther) {
    const auto one = desk_of(anna), other = desk_of(anna);
    check(*one, number_id, {{7.0}, {}}, right());
    finish(*one);
    check(*other, order_id, {{}, {0, 2}}, right());
    finish(*other);
    check(*one, matrix_id, {std::vector<double>(16, 1.0), {}}, wrong("M33"));
    finish(*one);
    EXPECT_EQ(written(anna).items.size(), 3U);
    EXPECT_TRUE(one->is_right(order_id)) << "the write merged the other window's answer";
    EXPECT_FALSE(other->is_tried(matrix_id));
    other->read_again();  // the window receives focus
    finish(*other);
    EXPECT_TRUE(other->is_tried(matrix_id));
    EXPECT_EQ(other->hand_in(), one->hand_in());
    EXPECT_EQ(one->points(), other->points());
    EXPECT_EQ(told_, "");
}

TEST_F(ExerciseDeskTest, TwoWindowsKeepAllAttemptsAndTheLatestDraft) {
    const auto one = desk_of(anna), other = desk_of(anna);
    LessonRun old = run_at(*one, number_id);
    old.answer() = {{1.0}, {}};
    one->follow(old, old.step().start.params, true, now_s());
    finish(*one);
    check(*other, number_id, {{2.0}, {}}, wrong());
    type(*other, number_id, {3.0});
    finish(*other);
    one->follow(old, old.step().start.params, true, now_s());  // this run still has the earlier input
    one->read_again();
    finish(*one);
    one->follow(old, old.step().start.params, true, now_s());
    finish(*one);
    EXPECT_EQ(written(anna).find(number_id)->draft, std::optional(std::vector{3.0})) << "this draft was typed later";
    check(*one, number_id, {{7.0}, {}}, right());
    finish(*one);
    EXPECT_EQ(written(anna).find(number_id)->attempts.size(), 2U);
}

TEST_F(ExerciseDeskTest, StudentChosenBeforeExercisesLoadHasTheirSheet) {
    {
        const auto desk = desk_of(anna);
        check(*desk, number_id, {{7.0}, {}}, right());
        finish(*desk);
    }
    ExerciseDesk desk;  // as when a window starts
    desk.keep_in(answers_, "p");
    desk.sit_down(anna);
    desk.open();
    settle(desk);
    EXPECT_TRUE(desk.is_right(number_id));
    for (const ExerciseDesk::Entry& entry : desk.entries())
        EXPECT_EQ(entry.variant,
                  variant_of(anna.course, anna.number, entry.exercise.id, entry.exercise.variants.size()));
}

TEST_F(ExerciseDeskTest, ChangingOnlyTheNameKeepsTheSheet) {
    const auto desk = desk_of(anna), other = desk_of(anna);
    check(*desk, number_id, {{7.0}, {}}, right());
    finish(*desk);
    desk->sit_down({anna.course, anna.number, "Anna"});
    EXPECT_TRUE(desk->is_ready()) << "no step is made again";
    finish(*desk);
    EXPECT_EQ(written(anna).name, "Anna");
    check(*other, order_id, {{}, {0, 2}}, right());
    finish(*other);
    EXPECT_EQ(written(anna).name, "Anna") << "the other window did not change the name";
    EXPECT_EQ(other->student().name, "Anna");
    desk->sit_down({anna.course, anna.number, ""});
    finish(*desk);
    EXPECT_EQ(written(anna).name, "");
    EXPECT_EQ(desk->student().name, "");
}

TEST_F(ExerciseDeskTest, FailedWriteIsRetriedByTheNext) {
    const auto desk = desk_of(anna);
    write("file", "x");
    fs::create_directories(folder_ / "deep");
    fs::create_symlink(folder_ / "file" / "nowhere", answers_);
    type(*desk, number_id, {1.0});
    finish(*desk);
    EXPECT_NE(told_, "");
    fs::remove(answers_);
    finish(*desk);
    EXPECT_EQ(written(anna).find(number_id)->draft, std::optional(std::vector{1.0}));
}

// ---- practice ------------------------------------------------------------------------------------------------------

TEST_F(ExerciseDeskTest, PracticeWithoutNumberOrCourseHasOneFile) {
    for (const Student& nobody : {Student{}, {"viewing-2026", "", ""}, {"", "32201234", ""}, {"", "", "Kim"}}) {
        const auto desk = desk_of(nobody);
        EXPECT_TRUE(desk->is_practice());
        EXPECT_FALSE(desk->has_own_sheet());
        EXPECT_EQ(desk->student().number, nobody.number) << "the partial input stays in its field";
        EXPECT_EQ(desk->student().course, nobody.course);
        check(*desk, number_id, {{static_cast<double>(files().size())}, {}}, wrong());
        finish(*desk);
    }
    EXPECT_EQ(files().size(), 1U) << "partial numbers wrote files of their own";
    EXPECT_EQ(written({}).student, "");
    const auto desk = desk_of(anna);
    EXPECT_FALSE(desk->is_practice());
    EXPECT_TRUE(desk->has_own_sheet());
}

TEST_F(ExerciseDeskTest, PracticeIsAdoptedWhereTheNumbersMatch) {
    // Find a student whose numbers equal those of practice in one exercise and differ in another.
    Student student{"viewing-2026", "", ""};
    {
        const auto practice = desk_of({});
        const auto variant_at = [](const ExerciseDesk& desk, const char* id) {
            return desk.entries()[place(desk, id)].variant;
        };
        ExerciseDesk own;
        own.open();
        for (int i = 0; i < 10000; ++i) {
            student.number = std::to_string(i);
            own.sit_down(student);
            if (variant_at(own, number_id) == variant_at(*practice, number_id) &&
                variant_at(own, matrix_id) != variant_at(*practice, matrix_id))
                break;
        }
        check(*practice, number_id, {{6.0}, {}}, wrong("M02"));
        check(*practice, number_id, {{7.0}, {}}, right());
        check(*practice, matrix_id, {std::vector<double>(16, 1.0), {}}, right());
        type(*practice, order_id, {});
        finish(*practice);
    }
    const auto desk = desk_of(student);
    EXPECT_FALSE(desk->is_right(number_id)) << "not adopted without a request";
    EXPECT_EQ(desk->practiced().all, 2);
    EXPECT_EQ(desk->practiced().with_own_numbers, 1);
    type(*desk, number_id, {5.0});
    desk->take_over_practice();
    EXPECT_TRUE(desk->is_right(number_id));
    EXPECT_FALSE(desk->is_tried(matrix_id)) << "an answer to different numbers";
    EXPECT_EQ(desk->practiced().with_own_numbers, 0) << "already adopted";
    EXPECT_EQ(desk->practiced().all, 2);
    finish(*desk);
    EXPECT_EQ(written(student).find(number_id)->attempts.size(), 2U) << "the wrong attempt too";
    EXPECT_EQ(written(student).find(number_id)->draft, std::optional(std::vector{5.0}));
    EXPECT_EQ(written(student).student, student.number);
    EXPECT_FALSE(written(student).find(matrix_id));
    EXPECT_EQ(written({}).items.size(), 2U) << "practice keeps its answers";

    desk->sit_down(student, true);
    settle(*desk);
    EXPECT_TRUE(desk->is_practice());
    EXPECT_TRUE(desk->has_own_sheet()) << "there is a way back";
    EXPECT_EQ(desk->student(), student);
    EXPECT_TRUE(desk->is_right(matrix_id)) << "the practice answers are back";
    check(*desk, order_id, {{}, {0, 2}}, right());
    desk->sit_down(student);
    settle(*desk);
    EXPECT_FALSE(desk->is_practice());
    EXPECT_TRUE(desk->is_right(number_id));
    EXPECT_FALSE(desk->is_right(order_id));
    finish(*desk);
    EXPECT_EQ(written({}).items.size(), 3U);
    EXPECT_EQ(told_, "");
}

// ---- guided sheet ---------------------------------------------------------------------------------------------------

class SheetGuide : public ExerciseDeskTest {};

TEST_F(SheetGuide, AdvancingNeverReveals) {
    const auto desk = desk_of(anna);
    Session session = *Session::make(*load_state(""));
    Guide guide;
    guide.begin(run_at(*desk, desk->entries().front().exercise.id), session);
    ASSERT_TRUE(guide.is_sheet());
    for (std::size_t i = 0; i < 30; ++i) {
        EXPECT_EQ(guide.run()->index(), std::min<std::size_t>(i, 25));
        EXPECT_FALSE(guide.run()->is_revealed());
        guide.next(session);
        guide.update(session, 0.1);
    }
    for (std::size_t i = 0; i < 30; ++i) {
        EXPECT_FALSE(guide.run()->is_revealed());
        guide.previous(session);
    }
    EXPECT_EQ(guide.run()->index(), 0U);
    for (std::size_t i = 0; i < 24; ++i) {
        guide.go_to(i, session);
        EXPECT_FALSE(guide.run()->is_revealed());
    }
}

TEST_F(SheetGuide, KeepsReachedAndRightAnswers) {
    const auto desk = desk_of(anna);
    Session session = *Session::make(*load_state(""));
    Guide guide;
    guide.begin(run_at(*desk, goal_id), session);
    const Params start = session.params;
    session.params = with_light(session.params, 3.25);
    guide.run()->reached() = session.params;  // as the window does in every frame
    guide.next(session);
    EXPECT_EQ(session.params.lights, start.lights) << "another exercise starts from its own state";
    guide.run()->answer().numbers = {7.0};
    guide.run()->take(right());
    guide.previous(session);
    EXPECT_EQ(guide.run()->step().id, goal_id);
    EXPECT_EQ(session.params, with_light(start, 3.25));
    EXPECT_FALSE(guide.run()->is_revealed());
    guide.next(session);
    EXPECT_TRUE(guide.run()->is_revealed()) << "a right answer stays revealed";
    EXPECT_EQ(guide.run()->answer().numbers, std::vector{7.0});
    guide.leave();
    session.params.camera.yaw += 5.0;
    guide.go_to(place(*desk, goal_id), session);
    EXPECT_EQ(session.params, with_light(start, 3.25));
    guide.return_to_step(session);
    EXPECT_EQ(session.params, start) << "the state of the file";
}

TEST_F(SheetGuide, BeginsWithAnswersReachedEarlier) {
    {
        const auto desk = desk_of(anna);
        LessonRun run = run_at(*desk, goal_id);
        desk->follow(run, with_light(run.step().start.params, 6.5), true, 1.0);
        finish(*desk);
    }
    const auto desk = desk_of(anna);
    Session session = *Session::make(*load_state(""));
    const Params start = session.params;
    Guide guide;
    guide.begin(run_at(*desk, goal_id), session);
    EXPECT_EQ(session.params, with_light(start, 6.5));
    EXPECT_FALSE(guide.run()->is_revealed());
}

}  // namespace
}  // namespace viewing
