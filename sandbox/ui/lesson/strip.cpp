#include "ui/lesson/strip.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "lesson/questions/question_kind.h"
#include "text/catalogue.h"
#include "ui/lesson/answers.h"
#include "ui/lesson/feedback.h"
#include "ui/lesson/lesson_text.h"
#include "ui/lesson/product_row.h"
#include "ui/parts/look.h"

namespace viewing {
namespace {

constexpr float strip_margin = 14.0F, between = 26.0F, line_gap = 6.0F;  ///< design pixels
constexpr float button_gap = 8.0F;
constexpr float least_two_columns = 760.0F;
constexpr float left_share = 0.36F;

struct Columns {
    bool are_two = false;
    float left = 0.0F, right = 0.0F;  ///< widths in pixels
};

Columns columns_of(float width, float scale) {
    const float inner = width - 2.0F * strip_margin * scale;
    if (width < least_two_columns * scale) return {false, inner, inner};
    const float left = std::floor((inner - between * scale) * left_share);
    return {true, left, inner - between * scale - left};
}

float button_height(const widgets::Context& context) {
    return context.fonts.text->FontSize + 8.0F * context.scale;
}

/// Returns a step's button labels, in order.
std::vector<const char*> button_labels(const LessonRun& run, const StripLook& look) {
    std::vector<const char*> labels{"◂###back"};
    const bool is_sheet = run.lesson().sheet.has_value();
    labels.push_back(run.is_revealed() || is_sheet ? marked("Next ▸") : marked("Show the answer"));
    const bool has_more_hints = run.hints_shown() < std::ssize(run.step().ask.hints);
    if (!run.is_revealed() && has_more_hints) labels.push_back(marked("Hint"));
    if (look.departs) labels.push_back(marked("Restore"));
    labels.push_back(is_sheet ? marked("All exercises") : marked("All steps"));
    labels.push_back(marked("Explore freely"));
    if (look.can_edit) labels.push_back(marked("Edit"));
    return labels;
}

/// Returns a text's width; also works outside a frame.
float text_width(ImFont* font, const std::string& text) {
    return font->CalcTextSizeA(font->FontSize, FLT_MAX, 0.0F, text.c_str()).x;
}

float button_width(const char* label, const widgets::Context& context) {
    const std::string_view shown = std::string_view(label).substr(0, std::string_view(label).find("##"));
    return text_width(context.fonts.text, std::string(tr_part(shown))) + 2.0F * ImGui::GetStyle().FramePadding.x;
}

/// Returns, for each button, whether it starts a new line because it does not fit on the current one.
std::vector<bool> line_breaks(const std::vector<const char*>& labels, float width, const widgets::Context& context) {
    std::vector<bool> breaks;
    const float space = button_gap * context.scale;
    float x = 0.0F;
    for (const char* const label : labels) {
        const float one = button_width(label, context);
        breaks.push_back(x > 0.0F && x + one > width);
        x = (breaks.back() ? 0.0F : x) + one + space;
    }
    return breaks;
}

/// Height of the buttons, including space for Restore, which may appear later.
float buttons_height(const LessonRun& run, float width, const widgets::Context& context, StripLook look) {
    look.departs = true;
    const std::vector<bool> breaks = line_breaks(button_labels(run, look), width, context);
    const auto rows = static_cast<float>(1 + std::count(breaks.begin(), breaks.end(), true));
    return rows * (button_height(context) + line_gap * context.scale);
}

/// Returns the lesson's title or, for an exercise, the exercise's number, title, and points.
std::string title_of(const LessonRun& run) {
    if (run.lesson().lecture && !run.step().only_shows())
        return run.lesson().lecture->parts[run.lesson().lecture->part_of(run.index())].title.shown();
    if (!run.lesson().sheet) return run.lesson().title.shown();
    const Sheet::Item& item = run.lesson().sheet->items[run.index()];
    const std::string number = item.exercise.substr(0, item.exercise.find('-'));
    const bool is_practice = run.lesson().sheet->student.empty() && run.lesson().sheet->course.empty();
    return (is_practice ? std::string(tr("Practice: not handed in")) + " · " : "") + number + " · " +
           item.title.shown() + " · " + say_count(item.points, "one point", "{count} points");
}

std::string place_of(const LessonRun& run) {
    return say("{step} / {steps}", "step"_a = run.index() + 1, "steps"_a = run.lesson().steps.size());
}

constexpr float dot_room = 14.0F, clock_gap = 14.0F;  ///< design pixels

/// Returns the title, wrapped to leave space for the progress, the dot, and the clock, if any, to its right.
Paragraph heading(const LessonRun& run, float width, const widgets::Context& context, bool has_clock) {
    ImFont* const font = context.fonts.note;
    const float clock = has_clock ? text_width(context.fonts.caption, "00:00") + clock_gap * context.scale : 0.0F;
    return paragraph(title_of(run), font,
                     width - text_width(font, place_of(run)) - clock - (dot_room + 12.0F) * context.scale);
}

/// Draws the title, the progress, and the clock. A dot shows that the state differs from the step's.
void draw_heading(const LessonRun& run, const StripLook& look, float width) {
    const widgets::Context& context = widgets::CurrentContext();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    float right = corner.x + width;
    const auto at_right = [&](const std::string& text, const char* recorded, ImFont* font, ImU32 color) {
        right -= text_width(font, text);
        // Center the text vertically on the title's first line.
        ImGui::SetCursorScreenPos({right, corner.y + (context.fonts.note->FontSize - font->FontSize) * 0.5F});
        ImGui::PushFont(font);
        ImGui::PushStyleColor(ImGuiCol_Text, color);
        ImGui::TextUnformatted(text.c_str());
        ImGui::PopStyleColor();
        ImGui::PopFont();
        widgets::Record(recorded);
    };
    at_right(place_of(run), "place", context.fonts.note, palette().quiet);
    if (look.departs) {
        right -= px(dot_room);
        const ImVec2 middle(right + px(6.0F), corner.y + context.fonts.note->FontSize * 0.5F);
        ImGui::GetWindowDrawList()->AddCircleFilled(middle, px(3.0F), palette().accent);
    }
    right -= px(clock_gap);
    if (!look.clock.empty()) at_right(look.clock, "clock", context.fonts.caption, palette().text);
    ImGui::SetCursorScreenPos(corner);
    heading(run, width, context, !look.clock.empty()).draw("lesson", palette().quiet);
}

float left_height(const LessonRun& run, float width, const widgets::Context& context, const StripLook& look) {
    const LessonStep& step = run.step();
    const float gap = line_gap * context.scale;
    float height = heading(run, width, context, !look.clock.empty()).height + gap;
    height += paragraph(step.say.shown(), context.fonts.caption, width).height + gap;
    if (look.presents) return height;
    for (const LessonText& hint : step.ask.hints)
        height += paragraph(hint.shown(), context.fonts.text, width).height + gap;
    return height + buttons_height(run, width, context, look);
}

float right_height(const LessonRun& run, float width, const widgets::Context& context, bool presents) {
    const LessonStep& step = run.step();
    const float gap = line_gap * context.scale;
    float height = paragraph(step.ask.question.shown(), context.fonts.caption, width).height + gap;
    height += answers_height(step.ask, width, context, presents);
    if (!presents && !step.ask.factors.empty()) height += product_row_height(step.ask, width, context) + gap;
    height += static_cast<float>(step.ask.progress.size()) * (context.fonts.text->FontSize + gap);
    if (!presents && kind_of(step.ask).needs_check) height += button_height(context) + gap;
    return height + feedback_height(run, width, context, presents);
}

/// Draws a paragraph; draws nothing if the text is empty.
void draw_paragraph(const LessonText& text, ImFont* font, float width, const char* label, ImU32 color) {
    if (text.empty()) return;
    paragraph(text.shown(), font, width).draw(label, color);
}

void draw_buttons(LessonRun& run, const StripLook& look, float width, StripWishes& wishes) {
    const bool is_revealed = run.is_revealed(), is_sheet = run.lesson().sheet.has_value();
    const std::vector<const char*> labels = button_labels(run, look);
    const std::vector<bool> breaks = line_breaks(labels, width, widgets::CurrentContext());
    std::size_t place = 0;
    const auto button = [&](bool enabled, const char* why, const char* tip) {
        if (place > 0 && !breaks[place]) ImGui::SameLine(0.0F, px(button_gap));
        const bool pressed = widgets::Button(labels[place], enabled, why);
        widgets::Tooltip(labels[place], tip);
        ++place;
        return pressed;
    };
    if (is_sheet) {
        wishes.previous =
            button(!run.is_first(), marked("this is the first exercise"), marked("The previous exercise."));
        wishes.next = button(!run.is_last(), marked("this is the last exercise"), marked("The next exercise."));
    } else {
        wishes.previous =
            button(!run.is_first() || (is_revealed && !run.step().only_shows()), marked("this is the first step"),
                   marked("Goes back to the question first, then to the previous step."));
        const bool is_next =
            is_revealed
                ? button(!run.is_last() || run.end(), marked("this is the last step"), marked("The next step."))
                : button(true, "", marked("Shows the result and explains it. You learn more if you answer first."));
        // The second click of a double-click was not meant for the button that has just appeared here.
        wishes.next = is_next && ImGui::GetIO().MouseClickedLastCount[0] < 2;
    }
    if (place + 2 + (look.departs ? 1U : 0U) + (look.can_edit ? 1U : 0U) < labels.size() &&
        button(true, "", marked("Shows a hint toward the answer.")))
        run.show_hint();
    if (look.departs) wishes.again = button(true, "", marked("Restores the step's state. Ctrl+Z undoes this."));
    wishes.overview = button(true, "",
                             is_sheet ? marked("Shows the list of exercises and your progress.")
                                      : marked("Shows the steps of this lesson as pictures."));
    wishes.leave = button(
        true, "", marked("Leaves the lesson and keeps the current state; the Lesson button returns to this step."));
    if (look.can_edit) wishes.edit = button(true, "", marked("Edits the texts, answers and states of this step."));
}

void draw_left(LessonRun& run, const StripLook& look, float width, StripWishes& wishes) {
    const widgets::Context& context = widgets::CurrentContext();
    const LessonStep& step = run.step();
    draw_heading(run, look, width);
    draw_paragraph(step.say, context.fonts.caption, width, "say", palette().text);
    if (look.presents) return;
    draw_buttons(run, look, width, wishes);
    for (int i = 0; i < run.hints_shown(); ++i)  // below the buttons, which stay where they are
        draw_paragraph(step.ask.hints[i], context.fonts.text, width, "hint", palette().quiet);
}

/// Draws the progress toward a goal, one line for each of its numbers.
void draw_progress(const LessonRun& run, float width) {
    const std::vector<GoalNumber>& numbers = run.step().ask.progress;
    if (run.is_revealed()) return;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const std::vector<std::string>& values = run.progress().numbers;
        const std::string text =
            say("{name} = {value}, needed: {needed}", "name"_a = numbers[i].name.shown(),
                "value"_a = i < values.size() ? values[i] : "…", "needed"_a = numbers[i].needed.shown());
        paragraph(text, widgets::CurrentContext().fonts.text, width).draw("progress", palette().text);
    }
}

void draw_right(LessonRun& run, const StripLook& look, float width, StripWishes& wishes) {
    const widgets::Context& context = widgets::CurrentContext();
    const LessonStep& step = run.step();
    draw_paragraph(step.ask.question, context.fonts.caption, width, "question", palette().text);
    const AnswerStyle style{!run.is_revealed() && !look.presents, run.is_revealed(), look.presents};
    wishes.check = draw_answers(run, style, width);
    if (!look.presents) draw_product_row(run, width);
    draw_progress(run, width);
    if (!look.presents && kind_of(step.ask).needs_check) {
        const bool is_open = !run.is_revealed();
        wishes.check = widgets::Button("Check", is_open, "") || wishes.check;
        if (step.ask.rows > 1) {
            ImGui::SameLine(0.0F, px(button_gap));
            wishes.paste = widgets::Button("Paste", is_open, "");
            widgets::Tooltip("Paste",
                             "Pastes the numbers from the clipboard row by row; accepts NumPy, MATLAB and plain text.");
        }
        if (!step.ask.shows_as.empty()) {
            ImGui::SameLine(0.0F, px(button_gap));
            wishes.show_matrix = widgets::Button("What my matrix does", run.verdict().has_value() || run.is_revealed(),
                                                 marked("check it first"));
            widgets::Tooltip("What my matrix does",
                             "Shows the picture that your matrix produces, next to the correct one.");
        }
    }
    wishes.check = wishes.check && run.first_unread().empty();
    draw_feedback(run, look, width);
}

}  // namespace

float strip_height(const LessonRun& run, float width, const widgets::Context& context, const StripLook& look) {
    if (!context.fonts.caption) return 0.0F;
    const Columns columns = columns_of(width, context.scale);
    const float left = left_height(run, columns.left, context, look);
    const float right = right_height(run, columns.right, context, look.presents);
    const float frame = 2.0F * strip_margin * context.scale;
    return std::ceil((columns.are_two ? std::max(left, right) : left + right + line_gap * context.scale) + frame);
}

float tallest_strip(const LessonRun& run, float width, const widgets::Context& context, const StripLook& look) {
    struct Key {
        std::shared_ptr<const Lesson> lesson;  ///< kept alive, so that no other lesson can get its address
        std::size_t first = 0;
        float width = 0.0F, scale = 0.0F;
        Language language{};
        bool has_clock = false, presents = false;
        bool operator==(const Key&) const = default;
    };
    static Key known;
    static float height = 0.0F;
    const Lesson& lesson = run.lesson();
    std::size_t first = 0, count = lesson.steps.size();
    if (lesson.lecture) {
        const Lecture::Part& part = lesson.lecture->parts[lesson.lecture->part_of(run.index())];
        first = part.first;
        count = part.count;
    }
    const Key now{run.shared_lesson(), first,        width, context.scale, spoken_language(),
                  !look.clock.empty(), look.presents};
    if (now == known) return height;
    known = now;
    height = strip_height(run, width, context, look);
    LessonRun other(lesson);
    for (std::size_t step = first; step < first + count; ++step) {
        other.go_to(step);
        height = std::max(height, strip_height(other, width, context, look));
    }
    return height;
}

StripWishes draw_strip(LessonRun& run, const Rect& rect, const StripLook& look) {
    const widgets::Group group("lesson strip");
    const widgets::Context& context = widgets::CurrentContext();
    StripWishes wishes;
    ImDrawList* draw = ImGui::GetWindowDrawList();
    draw->AddRectFilled(rect.min, rect.max, palette().raised);
    draw->AddRectFilled(rect.min, {rect.max.x, rect.min.y + px(2.0F)}, palette().accent);
    const Columns columns = columns_of(rect.width(), context.scale);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {px(8.0F), px(line_gap)});
    // A strip that is too short for its content scrolls.
    const ImVec2 corner(rect.min.x + px(strip_margin), rect.min.y + px(strip_margin) - ImGui::GetScrollY());
    ImGui::SetCursorScreenPos(corner);
    ImGui::BeginGroup();
    draw_left(run, look, columns.left, wishes);
    ImGui::EndGroup();
    const float below = ImGui::GetItemRectMax().y + px(line_gap);
    ImGui::SetCursorScreenPos(columns.are_two ? ImVec2(corner.x + columns.left + px(between), corner.y)
                                              : ImVec2(corner.x, below));
    ImGui::BeginGroup();
    draw_right(run, look, columns.right, wishes);
    ImGui::EndGroup();
    ImGui::PopStyleVar();
    if (ImGui::GetScrollMaxY() > 0.0F) widgets::CountScrolled();
    return wishes;
}

}  // namespace viewing
