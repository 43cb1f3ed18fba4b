#include "ui/window/clipboard.h"

#include "state/file/link.h"
#include "text/catalogue.h"
#include "text/numbers.h"
#include "ui/window/matrix_dialog.h"
#include "widgets/widgets.h"

namespace viewing {

/// Returns whether the state may be copied. While a control is covered, refuses and shows a message.
static bool may_tell_state(Session& session) {
    if (!widgets::IsPartCovered("control")) return true;
    session.message = {tr("the state was not copied: it reveals parts that are hidden until answered"), false};
    return false;
}

void copy(Session& session) {
    if (!may_tell_state(session)) return;
    ImGui::SetClipboardText(session.text().c_str());
    session.message = {tr("the whole state is on the clipboard"), false};
}

/// Returns a link to the current step of a built-in lesson if nothing has changed; otherwise "".
static std::string step_link(const Guide& guide, const Session& session) {
    if (!guide.is_shown() || guide.is_sheet() || guide.departs(session)) return {};
    return link_to(guide.run()->lesson(), guide.run()->index()).value_or("");
}

void copy_link(const Guide& guide, Session& session, const std::string& address) {
    const std::string step = step_link(guide, session);
    if (!step.empty() && (!guide.run()->is_revealed() || guide.run()->step().only_shows())) {
        ImGui::SetClipboardText((address + step).c_str());
        session.message = {tr("a link to this step of the lesson is on the clipboard"), false};
        return;
    }
    if (!may_tell_state(session)) return;
    ImGui::SetClipboardText((address + link_fragment(session.portable(session.params))).c_str());
    session.message = {tr("a link to this state is on the clipboard"), false};
}

Result<std::string> link_for_code(const Guide& guide, Session& session, const std::string& address) {
    if (!address.starts_with("https://") && !address.starts_with("http://"))
        return Error{tr("A QR code needs the address of the page: start the program with --base https://…")};
    if (const std::string step = step_link(guide, session); !step.empty()) return address + step;
    if (widgets::IsPartCovered("control"))
        return Error{tr("No QR code: the state reveals parts that are hidden until answered.")};
    return address + link_fragment(session.portable(session.params));
}

/// Whether the current question is about a matrix or vector, so that pasted numbers are its answer.
static bool takes_pasted_answer(const Guide& guide) {
    return guide.is_shown() && !guide.run()->is_revealed() && guide.run()->step().ask.rows > 1;
}

void paste_answer(Guide& guide) {
    if (!takes_pasted_answer(guide)) return;
    LessonRun* const run = guide.run();
    const Ask& ask = run->step().ask;
    const char* const text = ImGui::GetClipboardText();
    const std::vector<double> numbers = numbers_in(text ? text : "");
    const int wanted = ask.rows * ask.columns;
    if (std::ssize(numbers) != wanted) {
        run->tell_trouble(say("The clipboard has {count} numbers; the answer needs {wanted}.",
                              "count"_a = numbers.size(), "wanted"_a = wanted));
        return;
    }
    run->answer().numbers = numbers;
    run->unread().clear();
    run->forget_verdict();
}

void paste(Guide& guide, MatrixDialog& dialog, Session& session) {
    const char* const held = ImGui::GetClipboardText();
    const std::string text = held ? held : "";
    const bool is_link_or_state = text.find_first_of("#{") != std::string::npos;
    if (takes_pasted_answer(guide) && !is_link_or_state)
        paste_answer(guide);
    else if (MatrixDialog::is_matrix(text))
        dialog.paste(text, 0);
    else if (const std::optional<Link> step = lesson_link(text))
        guide.open(*step);
    else
        session.report(session.paste(text));
}

}  // namespace viewing
