#include "ui/lesson/end_card.h"

#include <algorithm>

#include "lesson/exercise.h"
#include "text/catalogue.h"
#include "ui/lesson/full_page.h"
#include "ui/parts/look.h"
#include "ui/parts/view_parts.h"

namespace viewing {
namespace {

constexpr float card_width = 46.0F;  ///< width of the card's lines, in ems

std::string short_id(const std::string& exercise) {
    return exercise.substr(0, exercise.find('-'));
}

/// Draws a sentence with its number in front of it.
void draw_numbered(std::size_t number, const std::string& text, float width) {
    ImFont* const font = widgets::CurrentContext().fonts.caption;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float indent = font->FontSize * 1.6F;
    const std::string label = std::to_string(number);
    ImGui::GetWindowDrawList()->AddText(font, font->FontSize, corner, palette().accent, label.c_str());
    ImGui::SetCursorScreenPos({corner.x + indent, corner.y});
    paragraph(text, font, width - indent).draw(("sentence " + label).c_str(), palette().text);
    ImGui::SetCursorScreenPos({corner.x, ImGui::GetCursorScreenPos().y + font->FontSize * 0.5F});
}

}  // namespace

void EndCard::read(const LessonRun& run) {
    if (run.end() == of_ && run.shared_lesson() == lesson_) return;
    lesson_ = run.shared_lesson();
    of_ = run.end();
    next_.reset();
    needs_.clear();
    next_part_ = exercise_ = {};
    if (!of_) return;
    if (!of_->exercise.empty()) exercise_ = exercise_title(of_->exercise);
    const std::vector<LessonFile> all = lessons();
    const auto at = [&](const std::string& id) {
        return std::find_if(all.begin(), all.end(), [&](const LessonFile& file) { return file.id == id; });
    };
    if (lesson_->lecture) {
        const std::size_t next = lesson_->lecture->part_of(run.index()) + 1;
        if (next < lesson_->lecture->parts.size()) next_part_ = lesson_->lecture->parts[next].title;
        return;
    }
    for (const std::string& id : lesson_->needs)
        if (const auto needed = at(id); needed != all.end()) needs_.push_back(needed->title);
    if (const auto own = at(lesson_->id); own != all.end() && own + 1 != all.end()) next_ = *(own + 1);
}

std::vector<std::string> EndCard::texts(const LessonRun& run) {
    read(run);
    std::vector<std::string> all{next_part_.shown(), exercise_.shown(), next_ ? next_->title.shown() : ""};
    for (const LessonText& title : needs_) all.push_back(title.shown());
    return all;
}

CardPicture EndCard::wanted_picture(const LessonRun& run) {
    const std::shared_ptr<const Lesson>& lesson = run.shared_lesson();
    const std::size_t step = lesson->lecture ? lesson->lecture->parts[lesson->lecture->part_of(run.index())].first : 0;
    return {"end/" + lesson->id + "/" + std::to_string(step),
            [lesson, step]() -> Result<LoadedState> {
                LoadedState state = lesson->steps[step].start;
                state.params = lesson->steps[step].revealed;
                return state;
            },
            {960, 540}};
}

EndCard::Wishes EndCard::draw(const LessonRun& run, bool presents, const Pictures& pictures) {
    Wishes wishes;
    read(run);
    if (!of_) return wishes;
    const Page page("lesson end");
    const widgets::Group group("end");
    const widgets::Fonts& fonts = widgets::CurrentContext().fonts;
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float line = fonts.caption->FontSize, whole = std::min(room.x, line * card_width);
    const float gap = line * 1.5F, picture = std::floor(whole * 0.46F), width = whole - picture - gap;
    std::string title = lesson_->title.shown();
    if (lesson_->lecture) title = lesson_->lecture->parts[lesson_->lecture->part_of(run.index())].title.shown();
    ImGui::SetCursorPos(
        {ImGui::GetCursorPosX() + (room.x - whole) * 0.5F,
         ImGui::GetCursorPosY() + std::max(0.0F, room.y - picture * 9.0F / 16.0F - line * 8.0F) * 0.4F});
    ImGui::BeginGroup();
    paragraph(say("What you have seen: {lesson}", "lesson"_a = title), fonts.caption, whole)
        .draw("title", palette().quiet);
    ImGui::Dummy({0.0F, line * 0.6F});
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const Rect rect{corner, {corner.x + picture, corner.y + std::round(picture * 9.0F / 16.0F)}};
    ImGui::GetWindowDrawList()->AddRectFilled(rect.min, rect.max, palette().view_ground, px(3.0F));
    if (ImTextureID const texture = texture_in(pictures, wanted_picture(run).key)) draw_picture(rect, texture);
    ImGui::SetCursorScreenPos({rect.max.x + gap, corner.y});
    ImGui::BeginGroup();
    for (std::size_t i = 0; i < of_->says.size(); ++i) draw_numbered(i + 1, of_->says[i].shown(), width);
    ImGui::EndGroup();
    ImGui::SetCursorScreenPos({corner.x, std::max(rect.max.y, ImGui::GetItemRectMax().y) + line * 0.8F});
    draw_what_follows(presents, whole, wishes);
    ImGui::EndGroup();
    return wishes;
}

void EndCard::draw_what_follows(bool presents, float width, Wishes& wishes) const {
    const widgets::Fonts& fonts = widgets::CurrentContext().fonts;
    const float line = fonts.caption->FontSize;
    const auto told = [&](const std::string& text, const char* label) {
        paragraph(text, presents ? fonts.caption : fonts.text, width).draw(label, palette().quiet);
        ImGui::Dummy({0.0F, line * 0.2F});
    };
    const std::string exercise =
        exercise_.empty()
            ? ""
            : say("Exercise {number}: {title}", "number"_a = short_id(of_->exercise), "title"_a = exercise_.shown());
    const std::string next = next_                ? say("Next lesson: {title}", "title"_a = next_->title.shown())
                             : next_part_.empty() ? ""
                                                  : say("Next: {title}", "title"_a = next_part_.shown());
    for (const LessonText& title : needs_)
        told(say("This lesson built on: {title}", "title"_a = title.shown()), "needs");
    if (presents) {
        if (!exercise.empty()) told(exercise, "exercise");
        if (!next.empty()) told(next, "next");
        return;
    }
    if (!next.empty() && widgets::Button((next + "###next").c_str())) {
        wishes.next = !next_;
        if (next_) wishes.lesson = next_->path.string();
    }
    if (!exercise.empty() && widgets::Button((exercise + "###exercise").c_str())) wishes.exercise = of_->exercise;
    ImGui::Dummy({0.0F, line * 0.4F});
    wishes.back = widgets::Button("Back to the last step");
    ImGui::SameLine(0.0F, px(8.0F));
    wishes.overview = widgets::Button("All steps");
}

}  // namespace viewing
