#include "ui/window/matrix_dialog.h"

#include <utility>

#include "state/file/link.h"
#include "text/catalogue.h"
#include "topics/matrices/numbers/fault_words.h"
#include "topics/matrices/numbers/take_matrix.h"
#include "ui/parts/look.h"
#include "ui/window/dialogs.h"

namespace viewing {
namespace {

constexpr const char* no_state = marked("the pasted matrix was rejected: its values are not allowed in a state");

/// Sets a matrix of the state and reports this in a message.
void take_into(Session& session, char letter, const glm::dmat4& matrix, double view_aspect, double tolerance) {
    if (!take_matrix(session.params, letter, matrix, view_aspect, tolerance))
        return session.report(Error{tr(no_state)});
    const bool is_camera = letter == 'V' || letter == 'C';
    const std::string name(1, letter);
    session.message = {is_camera       ? say("the camera now comes from the pasted {matrix}", "matrix"_a = name)
                       : letter == 'P' ? tr("the projection now comes from the pasted P")
                                       : say("{matrix} was entered by hand, as pasted", "matrix"_a = name),
                       false};
}

/// Puts the matrix, unchanged, in place of the state's, like one entered by hand, and reports this in a message.
void enter_into(Session& session, char letter, const glm::dmat4& matrix) {
    if (!enter_by_hand(session.params, letter, matrix)) return session.report(Error{tr(no_state)});
    session.message = {
        say("{matrix} was entered by hand, as pasted", "matrix"_a = std::string(1, letter == 'C' ? 'V' : letter)),
        false};
}

}  // namespace

bool MatrixDialog::is_matrix(const std::string& text) {
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    const bool is_state = first != std::string::npos && text[first] == '{' && text.find('"') != std::string::npos;
    return !is_state && !is_link(text) && read_pasted_matrix(text);
}

void MatrixDialog::paste(const std::string& text, char letter) {
    wanted_ = {text, letter};
}

void MatrixDialog::take(const Paste& paste, Session& session, const Derived& derived) {
    const Result<PastedMatrix> pasted = read_pasted_matrix(paste.text);
    if (!pasted) return session.report(Error{tr("the clipboard holds no matrix of 16 numbers")});
    const char letter = pasted->letter != 0 ? pasted->letter : paste.letter;
    const ExplainedMatrix found =
        explain_matrix(pasted->matrix, letter, session.params, derived.view_aspect, pasted->tolerance);
    const bool is_wrong_name = is_misnamed(pasted->letter, found);
    if (is_takeable(found) && !is_wrong_name)
        return take_into(session, found.letter, pasted->matrix, derived.view_aspect, pasted->tolerance);
    trouble_ = Trouble{*pasted, found, is_wrong_name ? pasted->matrix : fixed_matrix(pasted->matrix, found),
                       is_wrong_name || found.letter == 0 ? letter : found.letter};
}

void MatrixDialog::draw(Session& session, const Derived& derived) {
    if (const std::optional<Paste> paste = std::exchange(wanted_, std::nullopt)) take(*paste, session, derived);
    const widgets::Group group("pasted");
    if (trouble_) ImGui::OpenPopup("pasted");
    if (!begin_dialog("pasted", {px(520.0F), px(230.0F)})) return;
    if (!trouble_) {
        ImGui::CloseCurrentPopup();
        return ImGui::EndPopup();
    }
    const auto& [pasted, found, fixed, letter] = *trouble_;
    const FaultWords words = fault_words(found);
    dialog_title(marked("The pasted matrix"));
    ImGui::BeginChild("sentences", {0.0F, -ImGui::GetFrameHeightWithSpacing() - px(4.0F)});
    const char* const title = tr(matrix_title(found.letter));
    const std::string read =
        pasted.by_columns ? say("{matrix}, read as columns ({syntax})", "matrix"_a = title, "syntax"_a = pasted.syntax)
                          : say("{matrix}, read as rows ({syntax})", "matrix"_a = title, "syntax"_a = pasted.syntax);
    widgets::Note(read.c_str());
    widgets::Trouble(
        is_misnamed(pasted.letter, found)
            ? say("its name says {named}, but it is another matrix", "named"_a = std::string(1, pasted.letter)).c_str()
            : tr(words.wrong));
    if (*words.fix != '\0') widgets::Note(say("Fix: {how}", "how"_a = tr(words.fix)).c_str());
    ImGui::EndChild();
    const bool fixes = fixed && widgets::Button("Fix and use it");
    if (fixed) ImGui::SameLine();
    const bool enters = letter != 0 && widgets::Button("Show it as it is");
    if (letter != 0) {
        widgets::Tooltip("Show it as it is",
                         "Enters the matrix by hand, fault included: the picture shows its effect until you press "
                         "Release.");
        ImGui::SameLine();
    }
    const bool closes = widgets::Button("Close") || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
    if (fixes) take_into(session, found.letter, *fixed, derived.view_aspect, pasted.tolerance);
    if (enters) enter_into(session, letter, pasted.matrix);
    if (fixes || enters || closes) {
        trouble_.reset();
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

}  // namespace viewing
