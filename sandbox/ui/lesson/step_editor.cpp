#include "ui/lesson/step_editor.h"

#include <imgui.h>
//

#include "platform/file.h"
#include "platform/text_file.h"
#include "text/catalogue.h"
#include "text/words.h"
#include "ui/lesson/full_page.h"
#include "ui/parts/look.h"
#include "ui/parts/panel_parts.h"

namespace viewing {
namespace {

std::string letter_of(std::size_t choice) {
    return std::string(1, static_cast<char>('A' + choice % 26));
}

/// The label of a part's field.
std::string label_of(const StepPart& part) {
    const std::string letter = letter_of(part.number);
    const std::size_t number = part.number + 1;
    switch (part.kind) {
        case StepPart::Kind::say:
            return tr("Text");
        case StepPart::Kind::question:
            return tr("Question");
        case StepPart::Kind::choice:
            return say("Choice {choice}", "choice"_a = letter);
        case StepPart::Kind::why:
            return say("Why {choice} is wrong", "choice"_a = letter);
        case StepPart::Kind::right:
            return say("{choice} is right", "choice"_a = letter);
        case StepPart::Kind::answer:
            return part.place.ends_with("until")       ? tr("Goal")
                   : part.place.ends_with("tolerance") ? tr("Tolerance")
                                                       : tr("Answer");
        case StepPart::Kind::item:
            return say("Item {number}", "number"_a = number);
        case StepPart::Kind::hint:
            return say("Hint {number}", "number"_a = number);
        case StepPart::Kind::wrong_when:
            return say("Wrong answer {number}: when", "number"_a = number);
        case StepPart::Kind::wrong_say:
            return say("Wrong answer {number}", "number"_a = number);
        case StepPart::Kind::reveal:
            return tr("After the answer");
        case StepPart::Kind::note:
            return tr("Note for the lecturer");
        case StepPart::Kind::other:
            break;
    }
    return part.place;
}

/// Draws a button on the current line if there is room, otherwise on the next.
bool flowing_button(const char* label, const char* tip, bool enabled = true, const char* why_not = "") {
    behind(widgets::SmallButtonWidth(label));
    const bool clicked = widgets::SmallButton(label, enabled, why_not);
    widgets::Tooltip(label, tip);
    return clicked;
}

}  // namespace

std::vector<std::string> StepEditor::texts() const {
    std::vector<std::string> all{error_};
    for (const StepPart& part : parts_) all.push_back(part.text);
    return all;
}

void StepEditor::follow(const LessonRun& run) {
    const bool is_new = run.shared_lesson() != lesson_;
    if (is_new) {
        if (lesson_ && lesson_->file != run.lesson().file) earlier_.clear();
        lesson_ = run.shared_lesson();
        const std::filesystem::path& file = lesson_->file;
        Result<std::string> text = read_text_file(file);
        if (!text) error_ = text.error();
        source_ = {text ? *std::move(text) : "", file.filename().string(), file.parent_path()};
    }
    if (!is_new && step_ == run.index() && language_ == spoken_language() && !parts_.empty()) return;
    step_ = run.index();
    language_ = spoken_language();
    parts_ = step_parts(source_, step_, language_);
}

void StepEditor::write(const Result<std::string>& text, Guide& guide) {
    error_.clear();
    parts_.clear();  // so that follow() reads them again from the file's text
    if (!text) {
        error_ = text.error();
        return;
    }
    if (*text == source_.text) return;
    if (const Status written = write_file(guide.run()->lesson().file, *text); !written) {
        error_ = written.error();
        return;
    }
    earlier_.push_back(std::exchange(source_.text, *text));
    guide.look_at_file();
}

void StepEditor::draw_steps(Guide& guide, Session& session) {
    const std::size_t count = guide.run()->lesson().steps.size();
    const auto place = static_cast<std::ptrdiff_t>(step_);
    if (widgets::SmallButton("◂###step before", step_ > 0, "this is the first step")) guide.go_to(step_ - 1, session);
    if (flowing_button("▸###step after", "", step_ + 1 < count, marked("this is the last step")))
        guide.go_to(step_ + 1, session);
    if (flowing_button("Move up", marked("Swaps this step with the previous one."), step_ > 0,
                       marked("this is the first step")))
        write(with_moved_step(source_, step_, place - 1), guide);
    if (flowing_button("Move down", marked("Swaps this step with the next one."), step_ + 1 < count,
                       marked("this is the last step")))
        write(with_moved_step(source_, step_, place + 1), guide);
    if (flowing_button("Duplicate", marked("Inserts a copy of this step after it.")))
        write(with_doubled_step(source_, step_), guide);
    if (flowing_button("Remove", marked("Removes this step from the file. \"Undo the edit\" restores it."), count > 1,
                       marked("a lesson needs at least one step")))
        write(with_removed_step(source_, step_), guide);
    if (flowing_button("Undo the edit", marked("Restores the text that the file had before the last edit."),
                       !earlier_.empty(), marked("nothing has been edited yet"))) {
        const std::string before = std::move(earlier_.back());
        earlier_.pop_back();
        write(before, guide);
        if (error_.empty()) earlier_.pop_back();  // undoing does not count as an edit
    }
}

void StepEditor::draw_states(Guide& guide, Session& session) {
    const std::string preset = session.preset() ? session.preset()->name : "";
    const LessonStep& step = guide.run()->step();
    if (widgets::SmallButton("Use screen as question"))
        write(with_start(source_, step_, session.params, preset), guide);
    widgets::Tooltip(
        "Use screen as question",
        "The step begins with the state on the screen, including its views, its layout and the followed point.");
    if (flowing_button("Use screen as answer", marked("The answer reveals the state on the screen.")))
        write(with_revealed(source_, step_, step.start.params, session.params), guide);
    if (!step.ask.choices.empty() && flowing_button("Add a choice", marked("Adds a wrong choice.")))
        write(with_choice(source_, step_), guide);
}

void StepEditor::draw_parts(Guide& guide) {
    for (const StepPart& part : std::vector<StepPart>(parts_)) {
        const std::string label = label_of(part);
        ImGui::PushID(part.place.c_str());
        if (part.kind == StepPart::Kind::right) {
            bool is_right = part.text == "true";
            if (widgets::Toggle(label.c_str(), is_right, is_right) && is_right)
                write(with_part(source_, step_, part, language_), guide);
        } else {
            StepPart edited = part;
            widgets::Note(label.c_str());
            ImGui::SetNextItemWidth(-1.0F);
            if (widgets::ParagraphField("##text", edited.text))
                write(with_part(source_, step_, edited, language_), guide);
            widgets::Record(part.place.c_str(), part.text);
        }
        ImGui::PopID();
    }
}

void StepEditor::draw(Guide& guide, Session& session, const Rect& area) {
    if (!guide.is_shown() || !guide.watches_file()) is_open_ = false;
    if (!is_open_) return;
    follow(*guide.run());
    const widgets::Group group("step editor");
    ImGui::SetNextWindowPos(area.min);
    ImGui::SetNextWindowSize({area.width(), area.height()});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, palette().raised);
    ImGui::Begin("step editor", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings);
    ImGui::PushFont(widgets::CurrentContext().fonts.heading);
    ImGui::TextUnformatted(say("Step {step} of {steps} · {file}", "step"_a = step_ + 1,
                               "steps"_a = guide.run()->lesson().steps.size(), "file"_a = source_.name)
                               .c_str());
    ImGui::PopFont();
    if (button_at_right("Close")) close();
    draw_steps(guide, session);
    draw_states(guide, session);
    if (!error_.empty()) widgets::Trouble(printable(error_).c_str());
    draw_parts(guide);
    ImGui::End();
    ImGui::PopStyleColor();
}

}  // namespace viewing
