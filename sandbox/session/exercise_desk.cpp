#include "session/exercise_desk.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <string_view>
#include <utility>

#include "lesson/allowed.h"
#include "lesson/questions/question_kind.h"
#include "lesson/variants.h"
#include "platform/file.h"
#include "text/words.h"

namespace viewing {
namespace {

constexpr double least_between_writes_s = 0.3;

std::string local_time() {
    const std::time_t now = std::time(nullptr);
    char text[32];
    std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%S", std::localtime(&now));
    return text;
}

/// Returns the most recently checked answer; empty if there is none.
std::vector<double> latest_answer(const HandInItem& item) {
    const auto latest = std::find_if(item.attempts.rbegin(), item.attempts.rend(),
                                     [](const Attempt& attempt) { return attempt.answer.has_value(); });
    return latest == item.attempts.rend() ? std::vector<double>() : *latest->answer;
}

bool is_said_right(const Attempt& attempt) {
    return attempt.told == "right";
}

}  // namespace

std::string answers_file_name(const Student& student) {
    const auto plain = [](const std::string& text) {
        std::string name;
        for (const char c : text) {
            const bool is_plain =
                (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
            name += is_plain ? std::string(1, c) : percent_encoded(c);
        }
        return name;
    };
    std::string name = plain(student.course) + "~" + plain(student.number);
    constexpr std::size_t longest = 200;
    if (name.size() > longest) name = name.substr(0, longest) + "-" + std::to_string(fnv1a(name));
    return name + ".json";
}

std::string hand_in_file_name(const Student& student) {
    const bool has_both = !student.number.empty() && !student.name.empty();
    std::string name = student.number + (has_both ? "_" : "") + student.name;
    constexpr std::size_t longest = 120;  // bytes; common file systems allow 255
    while (name.size() > longest) remove_last_character(name);
    const auto is_refused = [](char c) {
        return static_cast<unsigned char>(c) <= ' ' || c == 0x7F ||
               std::string_view("\"*/:<>?\\|").find(c) != std::string_view::npos;
    };
    std::replace_if(name.begin(), name.end(), is_refused, '-');
    if (name.starts_with('.')) name[0] = '-';
    return (name.empty() ? "answers" : name) + ".json";
}

void ExerciseDesk::keep_in(std::filesystem::path folder, std::string program) {
    folder_ = std::move(folder);
    program_ = std::move(program);
}

std::filesystem::path ExerciseDesk::file(const Student& owner) const {
    return folder_.empty() ? folder_ : folder_ / answers_file_name(owner);
}

void ExerciseDesk::open() {
    if (is_read_) return;
    is_read_ = true;
    for (Result<Exercise>& exercise : exercises()) {
        if (exercise)
            entries_.push_back({*std::move(exercise), 0, std::nullopt});
        else if (trouble_)
            trouble_ = Error{exercise.error()};
    }
    begin_sheet();
}

void ExerciseDesk::choose_variants() {
    for (Entry& entry : entries_) {
        entry.variant = variant_of(owner_.course, owner_.number, entry.exercise.id, entry.exercise.variants.size());
        entry.step.reset();
    }
    followed_.clear();
}

void ExerciseDesk::sit_down(const Student& student, bool practices) {
    const bool is_the_same = student.course == student_.course && student.number == student_.number &&
                             practices == (is_practice() && has_own_sheet());
    if (is_the_same && is_read_ && !reading_.is_running()) {  // only the name differs
        student_.name = owner_.name = hand_in_.name = student.name;
        has_changed_ |= !hand_in_.items.empty();
        return;
    }
    if (Status done = finish(); !done) trouble_ = std::move(done);
    student_ = student;
    owner_ = has_own_sheet() && !practices ? student : Student{"", "", student.name};
    begin_sheet();
}

void ExerciseDesk::begin_sheet() {
    reading_.drop();
    is_another_ = false;
    hand_in_ = {program_, owner_.course, owner_.number, owner_.name, {}};
    known_ = hand_in_;
    practice_ = {};
    choose_variants();
    if (!is_read_ || folder_.empty()) return;
    const std::filesystem::path kept = file(owner_), practice = is_practice() ? "" : file({});
    if (is_there(kept) || is_there(practice))
        reading_.start([kept, practice](WorkProgress&) -> Result<Opened> {
            Result<HandIn> read = is_there(kept) ? load_hand_in(kept) : HandIn{};
            if (!read) return Error{read.error()};
            Opened opened{{}, *std::move(read), {}};
            if (Result<HandIn> practiced = load_hand_in(practice)) opened.practice = *std::move(practiced);
            return opened;
        });
}

void ExerciseDesk::open_hand_in(const std::filesystem::path& opened) {
    if (Status done = finish(); !done) trouble_ = std::move(done);
    is_another_ = true;
    reading_.start([opened, folder = folder_](WorkProgress&) -> Result<Opened> {
        Result<HandIn> read = load_hand_in(opened);
        if (!read) return Error{read.error()};
        if (folder.empty()) return Opened{*std::move(read), {}, {}};
        const std::filesystem::path kept = folder / answers_file_name({read->course, read->student, read->name});
        Result<HandIn> known = is_there(kept) ? load_hand_in(kept) : HandIn{};
        // A draft stored in `folder` replaces that of the opened file.
        return known ? Opened{merged(*read, {}, *known), *known, {}} : Opened{*std::move(read), {}, {}};
    });
}

void ExerciseDesk::take_hand_in(HandIn hand_in) {
    open();
    reading_.drop();
    student_ = owner_ = {hand_in.course, hand_in.student, hand_in.name};
    hand_in_ = std::move(hand_in);
    known_ = practice_ = {};
    choose_variants();
}

void ExerciseDesk::take_from_disk(HandIn on_disk, const HandIn& known) {
    if (on_disk == HandIn{}) return;
    hand_in_ = merged(on_disk, known, hand_in_);
    known_ = std::move(on_disk);
    student_.name = owner_.name = hand_in_.name;
}

Status ExerciseDesk::take_what_was_read() {
    std::optional<Result<Opened>> read = reading_.take();
    if (!read) return std::monostate{};
    const bool is_another = std::exchange(is_another_, false);
    if (!*read) return Error{read->error()};
    if (is_another) {
        take_hand_in(std::move((*read)->hand_in));
        known_ = std::move((*read)->on_disk);
        has_changed_ = true;
    } else {
        practice_ = std::move((*read)->practice);
        take_from_disk(std::move((*read)->on_disk), {});  // a name that was just typed replaces the file's
    }
    return std::monostate{};
}

Status ExerciseDesk::take_what_was_written() {
    std::optional<Result<HandIn>> written = writing_.take();
    if (!written) return std::monostate{};
    is_unwritten_ = !*written;
    if (is_unwritten_) return Error{written->error()};
    take_from_disk(**std::move(written), sent_);
    return std::monostate{};
}

void ExerciseDesk::write_what_changed() {
    if (!has_changed_ || writing_.is_running() || folder_.empty()) return;
    has_changed_ = false;
    sent_ = hand_in_;
    writing_.start(
        [kept = file(owner_), known = known_, now = sent_](WorkProgress&) { return merge_hand_in(kept, known, now); });
}

void ExerciseDesk::read_again() {
    has_changed_ |= is_read_;  // writing merges with the file's content
}

Status ExerciseDesk::update(double now_s) {
    Status status = take_what_was_read();
    if (Status written = take_what_was_written(); !written) status = std::move(written);
    if (update_due_in_s(now_s) == 0.0) {
        written_s_ = now_s;
        write_what_changed();
    }
    return status;
}

double ExerciseDesk::update_due_in_s(double now_s) const {
    // A read or write in progress reports by itself when it ends.
    if (!has_changed_ || folder_.empty() || reading_.is_running() || writing_.is_running()) return -1.0;
    return written_s_ < 0.0 ? 0.0 : std::max(written_s_ + least_between_writes_s - now_s, 0.0);
}

Status ExerciseDesk::finish() {
    Status last = std::monostate{};
    for (int turn = 0; turn < 2; ++turn) {  // first the write in progress, then later changes
        writing_.wait(-1.0);
        if (Status written = take_what_was_written(); !written) last = std::move(written);
        if (turn > 0) break;
        has_changed_ |= is_unwritten_;
        write_what_changed();
    }
    return last;
}

std::optional<std::size_t> ExerciseDesk::next_to_make() const {
    if (reading_.is_running()) return std::nullopt;
    const auto at = std::find_if(entries_.begin(), entries_.end(), [](const Entry& entry) { return !entry.step; });
    return at == entries_.end() ? std::nullopt : std::optional(static_cast<std::size_t>(at - entries_.begin()));
}

std::optional<LessonRun> ExerciseDesk::sheet_at(const std::string& exercise,
                                                const std::vector<std::size_t>& places) const {
    const auto is_made_one = [&](std::size_t place) {
        const Entry& entry = entries_[place];
        return entry.exercise.id == exercise && entry.step && *entry.step;
    };
    if (std::none_of(places.begin(), places.end(), is_made_one)) return std::nullopt;
    LessonRun run = sheet(places);
    const std::vector<Sheet::Item>& items = run.lesson().sheet->items;
    const auto at =
        std::find_if(items.begin(), items.end(), [&](const auto& item) { return item.exercise == exercise; });
    run.go_to(static_cast<std::size_t>(at - items.begin()));
    return run;
}

LessonRun ExerciseDesk::sheet(const std::vector<std::size_t>& places) const {
    Lesson lesson = empty_sheet(owner_.course, owner_.number);
    std::vector<const HandInItem*> known;
    for (const std::size_t place : places) {
        const Entry& entry = entries_[place];
        if (!entry.step || !*entry.step) continue;
        add_to_sheet(lesson, entry.exercise, entry.variant, **entry.step);
        known.push_back(hand_in_.find(entry.exercise.id));
    }
    LessonRun run(std::move(lesson));
    for (std::size_t i = 0; i < known.size(); ++i) {
        const HandInItem* const item = known[i];
        if (!item || item->variant != run.lesson().sheet->items[i].variant) continue;
        const LessonStep& step = run.lesson().steps[i];
        Attempt latest;
        latest.answer = item->draft;
        latest.settings = item->draft_settings;
        int hints = 0;
        bool is_done = false;
        for (const Attempt& attempt : item->attempts) {
            hints = std::max(hints, attempt.hint);
            if (attempt.hint > 0 || is_done) continue;
            is_done = is_said_right(attempt);
            if (is_done || !item->draft) latest.answer = attempt.answer;
            if (is_done || item->draft_settings.empty()) latest.settings = attempt.settings;
        }
        std::optional<Params> reached;
        if (!latest.settings.empty())
            if (const Result<Params> changed = changed_start(step, latest.settings)) reached = *changed;
        run.restore(i, answer_in(latest, step.ask).value_or(Answer{}), hints, is_done, std::move(reached));
    }
    return run;
}

const HandInItem* ExerciseDesk::own_item(const std::string& exercise) const {
    const HandInItem* const item = hand_in_.find(exercise);
    const auto is_its = [&](const Entry& entry) { return entry.exercise.id == exercise; };
    const auto entry = std::find_if(entries_.begin(), entries_.end(), is_its);
    return item && entry != entries_.end() && item->variant == entry->variant ? item : nullptr;
}

bool ExerciseDesk::is_right(const std::string& exercise) const {
    const HandInItem* const item = own_item(exercise);
    return item && std::any_of(item->attempts.begin(), item->attempts.end(), is_said_right);
}

bool ExerciseDesk::is_tried(const std::string& exercise) const {
    const HandInItem* const item = own_item(exercise);
    return item && std::any_of(item->attempts.begin(), item->attempts.end(),
                               [](const Attempt& attempt) { return attempt.hint == 0; });
}

HandIn ExerciseDesk::practice_with_own_numbers() const {
    HandIn own = hand_in_;
    own.items.clear();
    for (const Entry& entry : entries_) {
        const HandInItem* const item = practice_.find(entry.exercise.id);
        if (item && item->variant == entry.variant && !item->attempts.empty()) own.items.push_back(*item);
    }
    return own;
}

ExerciseDesk::Practiced ExerciseDesk::practiced() const {
    Practiced practiced;
    for (const HandInItem& item : practice_.items) practiced.all += item.attempts.empty() ? 0 : 1;
    for (const HandInItem& item : practice_with_own_numbers().items) {
        const HandInItem* const own = own_item(item.exercise);
        const auto is_here = [own](const Attempt& attempt) {
            return own && std::find(own->attempts.begin(), own->attempts.end(), attempt) != own->attempts.end();
        };
        if (!std::all_of(item.attempts.begin(), item.attempts.end(), is_here)) ++practiced.with_own_numbers;
    }
    return practiced;
}

void ExerciseDesk::take_over_practice() {
    hand_in_ = merged(practice_with_own_numbers(), {}, hand_in_);
    has_changed_ = true;
}

int ExerciseDesk::points() const {
    int points = 0;
    for (const Entry& entry : entries_) points += is_right(entry.exercise.id) ? entry.exercise.points : 0;
    return points;
}

int ExerciseDesk::points_of() const {
    int points = 0;
    for (const Entry& entry : entries_) points += entry.exercise.points;
    return points;
}

HandInItem& ExerciseDesk::item(const std::string& exercise, std::size_t variant) {
    hand_in_.program = program_;
    hand_in_.course = owner_.course;
    hand_in_.student = owner_.number;
    hand_in_.name = owner_.name;
    HandInItem* item = hand_in_.find(exercise);
    if (item && item->variant != variant) *item = {exercise, variant, {}, {}, {}, {}};  // drop answers to other numbers
    if (item) return *item;
    return hand_in_.items.emplace_back(HandInItem{exercise, variant, {}, {}, {}, {}});
}

bool ExerciseDesk::is_of_student(const LessonRun& run) const {
    const std::optional<Sheet>& sheet = run.lesson().sheet;
    return sheet && sheet->course == owner_.course && sheet->student == owner_.number;
}

void ExerciseDesk::add(HandInItem& item, Attempt attempt) {
    if (item.attempts.size() >= most_attempts) item.attempts.erase(item.attempts.begin());
    item.attempts.push_back(std::move(attempt));
    has_changed_ = true;
}

void ExerciseDesk::record(const LessonRun& run, const Verdict& verdict, const Params& params) {
    if (!is_of_student(run)) return;
    const Sheet::Item& asked = run.lesson().sheet->items[run.index()];
    HandInItem& item = this->item(asked.exercise, asked.variant);
    Attempt attempt;
    attempt.at = local_time();
    attempt.told = verdict.right ? "right" : verdict.tag;
    if (kind_of(run.step().ask).is_on_screen) {
        attempt.is_goal = true;
        attempt.settings = settings_between(run.step().start.params, params);
    } else {
        attempt.answer = answer_numbers(run.answer());
    }
    if (!item.attempts.empty() && replaces(attempt, item.attempts.back())) item.attempts.pop_back();
    add(item, std::move(attempt));
    item.draft.reset();
}

void ExerciseDesk::follow(const LessonRun& run, const Params& params, bool is_at_rest, double now_s) {
    if (!is_of_student(run)) return;
    const Sheet::Item& asked = run.lesson().sheet->items[run.index()];
    const LessonStep& step = run.step();
    if (followed_ != asked.exercise) {
        followed_ = asked.exercise;
        followed_since_s_ = now_s;
        last_.reset();
        last_typed_.reset();
    }
    const HandInItem* const known = hand_in_.find(asked.exercise);
    int hints = 0;
    if (known)
        for (const Attempt& attempt : known->attempts) hints = std::max(hints, attempt.hint);
    for (int hint = hints + 1; hint <= run.hints_shown(); ++hint) {
        Attempt attempt;
        attempt.at = local_time();
        attempt.hint = hint;
        add(item(asked.exercise, asked.variant), std::move(attempt));
    }
    if (run.is_revealed()) return;
    if (!kind_of(step.ask).is_on_screen) {
        const std::vector<double> typed = answer_numbers(run.answer());
        if (typed == std::exchange(last_typed_, typed)) return;  // unchanged here; another window's answer may be newer
        const bool is_blank = std::all_of(typed.begin(), typed.end(), [](double number) { return number == 0.0; });
        if (typed.empty() || (is_blank && (!known || !known->draft))) return;
        if (known && (known->draft ? *known->draft : latest_answer(*known)) == typed) return;
        item(asked.exercise, asked.variant).draft = typed;
        has_changed_ = true;
        return;
    }
    if (!is_at_rest || last_ == params) return;
    last_ = params;
    const std::vector<std::string> settings = settings_between(step.start.params, params);
    if (are_same_settings(settings, known ? known->draft_settings : std::vector<std::string>())) return;
    HandInItem& noted = item(asked.exercise, asked.variant);
    noted.draft_settings = settings;
    noted.replay.push_back({std::round((now_s - followed_since_s_) * 10.0) / 10.0, settings});
    thin(noted.replay);
    has_changed_ = true;
}

}  // namespace viewing
