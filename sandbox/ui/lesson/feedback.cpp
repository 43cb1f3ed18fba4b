#include "ui/lesson/feedback.h"

#include <algorithm>
#include <cmath>

#include "lesson/questions/question_kind.h"
#include "text/catalogue.h"
#include "text/numbers.h"
#include "text/words.h"
#include "ui/lesson/lesson_text.h"
#include "ui/parts/look.h"

namespace viewing {
namespace {

std::string what_cannot_be_read(const std::string& typed) {
    return say("{typed} is not a number. You can type 4/2.7, sqrt(2), cos(30°) or pi.", "typed"_a = excerpt(typed));
}

/// Draws feedback with ✓ or ✗ in front of it, so that color is not the only cue.
void draw_told(bool is_right, const std::string& text, float width, const char* label) {
    const widgets::Context& context = widgets::CurrentContext();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImU32 color = is_right ? palette().plane : palette().trouble;
    ImGui::GetWindowDrawList()->AddText(context.fonts.heading, context.fonts.heading->FontSize, corner, color,
                                        is_right ? "✓" : "✗");
    const float sign = px(24.0F);
    ImGui::SetCursorScreenPos({corner.x + sign, corner.y});
    paragraph(text, context.fonts.text, width - sign).draw(label, palette().text);
}

/// Returns "x, z" or "1, 3".
std::string places_in_words(const Ask& ask, const std::vector<int>& places) {
    const bool has_letters = ask.rows == 3 && ask.columns == 1;
    std::string text;
    for (const int place : places)
        text += (text.empty() ? "" : ", ") + (has_letters ? std::string(1, "xyz"[place - 1]) : std::to_string(place));
    return text;
}

/// Returns "(0, 1, 0, −0.5)"; a light's w is left out if it is 1.
std::string numbers_in_words(std::vector<double> numbers, bool is_light) {
    if (is_light && std::abs(numbers.back() - 1.0) < 5e-4) numbers.pop_back();
    return figures_of(numbers, 3);
}

/// Returns a sentence about the row that belongs to another plane or light; "" if there is none.
std::string other_row_in_words(const Verdict& verdict) {
    if (verdict.other_row == 0) return "";
    if (!verdict.other_plane.empty())
        return say("Row {row} belongs to the plane {plane}.", "row"_a = verdict.other_row,
                   "plane"_a = numbers_in_words(verdict.other_plane, false));
    return say("Row {row} belongs to the light {light}.", "row"_a = verdict.other_row,
               "light"_a = numbers_in_words(verdict.other_light, true));
}

/// Returns feedback on an answer that matches no known mistake: what is right about it, but none of the right answer's
/// numbers.
std::string not_yet(const Ask& ask, const Verdict& verdict, int hints_shown) {
    const std::string places = places_in_words(ask, verdict.places);
    const bool is_matrix = ask.columns > 1;
    switch (verdict.near) {
        case Near::factor:
            return tr("Not yet: all numbers are right up to one common factor.");
        case Near::sign:
            if (ask.rows == 1) return tr("Not yet: only the sign is wrong.");
            return is_matrix ? say("Not yet: only signs in these rows are wrong: {places}.", "places"_a = places)
                             : say("Not yet: only the sign is wrong here: {places}.", "places"_a = places);
        case Near::half:
            return tr("Not yet: this is half the right value.");
        case Near::twice:
            return tr("Not yet: this is twice the right value.");
        case Near::reciprocal:
            return tr("Not yet: this is the reciprocal of the right value.");
        case Near::radians:
            return tr("Not yet: this would be right in radians. Answer in degrees.");
        case Near::degrees:
            return tr("Not yet: this would be right in degrees. Answer in radians.");
        case Near::decimal:
            return tr("Not yet: only the decimal point is in the wrong place.");
        case Near::right_parts:
            return is_matrix ? say("Not yet. These rows are right: {places}.", "places"_a = places)
                             : say("Not yet. These numbers are right: {places}.", "places"_a = places);
        case Near::first_items:
            return say_count(verdict.places.front(), "Not yet: the first tile is right.",
                             "Not yet: the first {count} tiles are right.");
        case Near::first_wrong:
            return tr("Not yet: another tile comes first.");
        case Near::no_items:
            return tr("Not yet: none of your choices is right.");
        case Near::some_items:
            return say_count(verdict.places.front(), "Not yet: one of your choices is right.",
                             "Not yet: {count} of your choices are right.");
        case Near::incomplete:
            return tr("Not yet: your choices are right, but something is missing.");
        case Near::too_many:
            return tr("Not yet: you chose all the right ones, but others too.");
        case Near::nothing:
            break;
    }
    const int hints = static_cast<int>(ask.hints.size());
    if (hints_shown < hints) return tr("Not yet. Try again, or ask for a hint.");
    return hints > 0 ? tr("Not yet. Look at the hints again.") : tr("Not yet. Try again.");
}

/// Returns not_yet(), plus the sentence about the row that belongs to another plane or light, if there is one.
std::string feedback_on(const LessonRun& run, const Verdict& verdict) {
    const Ask& ask = run.step().ask;
    const Answer& answer = run.answer();
    const std::string own = not_yet(ask, verdict, run.hints_shown());
    if (kind_of(ask).has_items && answer.empty()) return tr("Nothing is chosen yet.");
    const std::string other = other_row_in_words(verdict);
    if (other.empty()) return own;
    return (verdict.near == Near::nothing ? std::string(tr("Not yet.")) : own) + " " + other;
}

}  // namespace

float feedback_height(const LessonRun& run, float width, const widgets::Context& context, bool presents) {
    const LessonStep& step = run.step();
    float height = paragraph(run.reveal_say().shown(), context.fonts.caption, width).height;
    if (presents) return height;
    const auto say = [&](const LessonText& text) {
        const float sign = 24.0F * context.scale;
        height = std::max(height, paragraph(text.shown(), context.fonts.text, width - sign).height);
    };
    for (const LessonChoice& choice : step.ask.choices) say(choice.why);
    for (const WrongAnswer& wrong : step.ask.wrong) say(wrong.say);
    if (kind_of(step.ask).is_typed) say(LessonText{{what_cannot_be_read("0.0.0.0.0.0.0.0.0.0")}});
    return height;
}

void draw_feedback(const LessonRun& run, const StripLook& look, float width) {
    const widgets::Context& context = widgets::CurrentContext();
    const LessonStep& step = run.step();
    if (look.is_checking) {
        paragraph(tr("Checking…"), context.fonts.text, width).draw("checking", palette().quiet);
        return;
    }
    if (run.is_revealed()) {
        const std::string& said = run.reveal_say().shown();
        if (!said.empty()) paragraph(said, context.fonts.caption, width).draw("reveal", palette().accent);
        return;
    }
    if (look.presents) return;
    if (const std::string unread = run.first_unread(); !unread.empty())
        return draw_told(false, what_cannot_be_read(unread), width, "trouble");
    if (!run.trouble().empty()) return draw_told(false, run.trouble(), width, "trouble");
    if (!run.verdict()) return;
    const Verdict& verdict = *run.verdict();
    if (verdict.right)
        draw_told(true, tr("Goal met."), width, "verdict");
    else if (!verdict.say.empty())
        draw_told(false, verdict.say.shown(), width, "verdict");
    else if (!kind_of(step.ask).is_on_screen)
        draw_told(false, feedback_on(run, verdict), width, "verdict");
}

}  // namespace viewing
