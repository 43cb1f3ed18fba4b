#include "ui/lesson/exercise_page.h"

#include <imgui.h>
//

#include <algorithm>
#include <array>
#include <utility>

#include "lesson/questions/typed_matrix.h"
#include "text/catalogue.h"
#include "text/words.h"
#include "ui/lesson/full_page.h"
#include "ui/parts/look.h"

namespace viewing {
namespace {

/// The name of a set of exercises in the exercise files, and its label in the window.
struct SetName {
    const char *name, *label;
};
constexpr std::array sets{SetName{"", marked("all")},
                          SetName{"camera", marked("camera")},
                          SetName{"hidden", marked("hidden surfaces")},
                          SetName{"depth", marked("depth")},
                          SetName{"shadow", marked("shadow")},
                          SetName{"mirror", marked("mirror")}};

constexpr glm::ivec2 compared_px{960, 540};

std::string key_of(const ExerciseDesk::Entry& entry) {
    return "exercise/" + entry.exercise.id + "/" + std::to_string(entry.variant);
}

/// Draws a field with its label before it. Returns true when its text has changed.
bool text_field(const char* label, std::string& text, float width, const char* tip) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(tr(label));
    ImGui::SameLine();
    ImGui::SetNextItemWidth(px(width));
    const bool is_new = widgets::EntryField(("##" + std::string(label)).c_str(), text);
    widgets::Record(label);
    widgets::Tooltip(label, tip);
    return is_new;
}

std::string what_practice_is(const ExerciseDesk& desk) {
    const bool has_number = !desk.student().number.empty(), has_course = !desk.student().course.empty();
    const char* const why = has_number && has_course ? marked("Practice: these are not your numbers.")
                            : has_number             ? marked("Practice: no course entered.")
                            : has_course             ? marked("Practice: the student number is missing.")
                                                     : marked("Practice: student number and course are missing.");
    return std::string(tr(why)) + " " + tr("Answers are kept on this computer and are not handed in.");
}

/// Says how many exercises the student has practiced, and how many of these can be imported.
std::string told_of_practice(const ExerciseDesk::Practiced& practiced) {
    const std::string all = say_count(practiced.all, "You practiced one exercise.", "You practiced {count} exercises.");
    if (practiced.with_own_numbers == 0) return all + " " + tr("The answers are kept under Practice.");
    return all + " " +
           say_count(practiced.with_own_numbers, "One of them has your numbers: you can import its answers.",
                     "{count} of them have your numbers: you can import their answers.");
}

}  // namespace

void ExercisePage::open(ExerciseDesk& desk) {
    desk.open();
    is_open_ = true;
}

std::vector<std::size_t> ExercisePage::shown(const ExerciseDesk& desk) const {
    std::vector<std::size_t> places;
    const std::string set = sets[set_].name;
    for (std::size_t i = 0; i < desk.entries().size(); ++i)
        if (set.empty() || desk.entries()[i].exercise.is_in(set)) places.push_back(i);
    return places;
}

std::vector<CardPicture> ExercisePage::wanted_pictures(const ExerciseDesk& desk) const {
    std::vector<CardPicture> wanted;
    if (!is_open_) return wanted;
    for (const std::size_t place : shown(desk)) {
        const ExerciseDesk::Entry& entry = desk.entries()[place];
        if (entry.step && *entry.step)
            wanted.push_back(
                {key_of(entry), [start = (*entry.step)->start]() -> Result<LoadedState> { return start; }});
    }
    return wanted;
}

void ExercisePage::draw_student(ExerciseDesk& desk, Guide& guide) {
    Student typed = desk.student();
    bool is_new = text_field(marked("Student number"), typed.number, 110.0F,
                             marked("Your student number and course determine the numbers in your questions."));
    ImGui::SameLine(0.0F, px(18.0F));
    is_new |= text_field(marked("Course"), typed.course, 130.0F,
                         marked("The course name exactly as the lecturer writes it."));
    ImGui::SameLine(0.0F, px(18.0F));
    is_new |=
        text_field(marked("Name"), typed.name, 130.0F, marked("Appears in the hand-in file and changes nothing else."));
    if (!is_new) return;
    const bool is_another = typed.number != desk.student().number || typed.course != desk.student().course;
    if (is_another && guide.is_sheet()) guide.close();
    desk.sit_down(typed, !is_another && desk.is_practice() && desk.has_own_sheet());
}

void ExercisePage::draw_whose(ExerciseDesk& desk, Guide& guide) {
    const ExerciseDesk::Practiced practiced = desk.practiced();
    const bool offers_practice = !desk.is_practice() && practiced.all > 0;
    if (desk.is_practice())
        widgets::Note(what_practice_is(desk).c_str());
    else
        widgets::Note(
            "Each student gets different numbers. Every answer is saved on this computer immediately; you hand in one "
            "file.");
    widgets::Record("whose");
    if (offers_practice) widgets::Note(told_of_practice(practiced).c_str());
    if (offers_practice) widgets::Record("practised");
    if (offers_practice && practiced.with_own_numbers > 0) {
        if (widgets::SmallButton("Import")) {
            if (guide.is_sheet()) guide.close();  // the open exercise still shows the old answers
            desk.take_over_practice();
        }
        widgets::Tooltip("Import", "Adds these answers, with all their attempts, to your hand-in.");
        ImGui::SameLine();
    }
    const bool goes_back = desk.is_practice() && desk.has_own_sheet();
    if (!offers_practice && !goes_back) return;
    if (!widgets::SmallButton(goes_back ? marked("My sheet") : marked("Practice"))) return;
    if (guide.is_sheet()) guide.close();
    desk.sit_down(desk.student(), !goes_back);
}

ExercisePage::Wishes ExercisePage::draw(ExerciseDesk& desk, Guide& guide, Session& session, const Pictures& pictures) {
    Wishes wishes;
    if (!is_open_) return wishes;
    const Page page("exercise page");
    const widgets::Group group("exercises");
    page_heading(say("Exercises: {points} of {of} points", "points"_a = desk.points(), "of"_a = desk.points_of()),
                 "title");
    if (button_at_right("Close")) close();
    draw_student(desk, guide);
    draw_whose(desk, guide);
    static const std::array<const char*, sets.size()> labels = [] {
        std::array<const char*, sets.size()> names{};
        for (std::size_t i = 0; i < sets.size(); ++i) names[i] = sets[i].label;
        return names;
    }();
    widgets::Segments("##set", set_, labels, 0);
    wishes.save = widgets::Button("Save answers…", !desk.is_practice() && !desk.hand_in().items.empty(),
                                  desk.is_practice() ? marked("practice is not handed in") : marked("no answers yet"));
    widgets::Tooltip("Save answers", "Saves the file that you hand in.");
    ImGui::SameLine();
    wishes.open_answers = widgets::Button("Open answers…");
    widgets::Tooltip("Open answers", "Continues from a file saved here or on another computer.");
    std::string trouble = desk.trouble() ? "" : desk.trouble().error();
    std::vector<Card> cards;
    const std::vector<std::size_t> places = shown(desk);
    for (const std::size_t place : places) {
        const ExerciseDesk::Entry& entry = desk.entries()[place];
        const Exercise& exercise = entry.exercise;
        const bool is_right = desk.is_right(exercise.id);
        const std::string points = say_count(exercise.points, "one point", "{count} points");
        if (entry.step && !*entry.step && trouble.empty()) trouble = entry.step->error();
        const std::string note = entry.step && !*entry.step ? tr("cannot be shown here")
                                 : !is_right && desk.is_tried(exercise.id)
                                     ? say("{points} · started, not correct yet", "points"_a = points)
                                     : points;
        cards.push_back({key_of(entry), exercise.short_id() + " · " + exercise.title.shown(), note, is_right, false});
    }
    if (!trouble.empty()) widgets::Trouble(printable(trouble).c_str());
    ImGui::Dummy({0.0F, px(4.0F)});
    ImGui::BeginChild("cards");
    if (cards.empty()) widgets::Note("There are no exercises: the folder assets/exercises was not found.");
    const int clicked = draw_cards(
        cards, [&](const std::string& key) { return texture_in(pictures, key); }, -1);
    ImGui::EndChild();
    if (clicked >= 0) chosen_ = desk.entries()[places[clicked]].exercise.id;
    if (chosen_.empty() || !desk.is_ready()) return wishes;
    std::optional<LessonRun> run = desk.sheet_at(std::exchange(chosen_, {}), places);
    if (!run) return wishes;
    guide.begin(*std::move(run), session);
    close();
    return wishes;
}

void TypedMatrix::open(const LessonRun& run) {
    const LessonStep& step = run.step();
    trouble_.clear();
    if (!step.ask.factors.empty() && run.products().matrices.empty()) return;
    const glm::dmat4 matrix =
        step.ask.factors.empty() ? matrix_of_rows(run.answer().numbers) : run.products().matrices.back();
    const Result<LoadedState> typed = with_typed_matrix(step, matrix);
    if (!typed) trouble_ = typed.error();
    std::string numbers;
    for (int i = 0; i < 16; ++i) numbers += " " + format_number(matrix[i % 4][i / 4]);
    const std::string key = step.id + "/" + step.ask.constants;
    const LoadedState right = with_right_matrix(step);
    mine_ = CardPicture{"typed/" + key + numbers, [typed] { return typed; }, compared_px};
    right_ = CardPicture{"right/" + key, [right]() -> Result<LoadedState> { return right; }, compared_px};
}

std::vector<CardPicture> TypedMatrix::wanted_pictures() const {
    if (!mine_) return {};
    if (!trouble_.empty()) return {*right_};
    return {*mine_, *right_};
}

void TypedMatrix::draw(const Pictures& pictures) {
    if (!mine_) return;
    const Page page("typed matrix");
    const widgets::Group group("typed matrix");
    page_heading(tr("What your matrix does"), "title");
    if (button_at_right("Close")) return close();
    ImGui::Dummy({0.0F, px(8.0F)});
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float gap = px(18.0F), label = ImGui::GetTextLineHeightWithSpacing();
    const bool are_beside = room.x > room.y;
    const float widest = are_beside ? (room.x - gap) * 0.5F : room.x;
    const float highest = are_beside ? room.y - label : (room.y - gap) * 0.5F - label;
    const float width = std::floor(std::min(widest, highest * 16.0F / 9.0F));
    const ImVec2 size(width, std::floor(width * 9.0F / 16.0F));
    const float height = are_beside ? size.y + label : 2.0F * (size.y + label) + gap;
    ImGui::Dummy({0.0F, std::max(0.0F, (room.y - height) * 0.4F)});
    const auto show = [&](const CardPicture& card, const char* name) {
        ImGui::BeginGroup();
        ImGui::TextUnformatted(tr(name));
        widgets::Record(name);
        const ImVec2 corner = ImGui::GetCursorScreenPos();
        ImGui::Dummy(size);
        const ImVec2 end(corner.x + size.x, corner.y + size.y);
        ImDrawList* draw = ImGui::GetWindowDrawList();
        draw->AddRectFilled(corner, end, palette().view_ground, px(6.0F));
        if (const ImTextureID texture = texture_in(pictures, card.key))
            draw->AddImageRounded(texture, corner, end, {0.0F, 1.0F}, {1.0F, 0.0F}, IM_COL32_WHITE, px(6.0F));
        ImGui::EndGroup();
    };
    show(*mine_, marked("your matrix"));
    if (are_beside) ImGui::SameLine(0.0F, gap);
    show(*right_, marked("correct matrix"));
    if (!trouble_.empty()) widgets::Trouble(printable(trouble_).c_str());
}

}  // namespace viewing
