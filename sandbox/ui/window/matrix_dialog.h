// Takes a matrix from the clipboard: a right V, C or P becomes the state's own, and a dialog says what is wrong with
// any other.
#pragma once

#include <optional>
#include <string>

#include "frame/explain/explain_matrix.h"
#include "frame/explain/pasted_matrix.h"
#include "session/session.h"

namespace viewing {

class MatrixDialog {
public:
    /// Returns whether a text is a matrix rather than a state or a link.
    static bool is_matrix(const std::string& text);
    /// Takes the matrix, if the text is one, when the dialog is drawn next. `letter`: the matrix in whose place it is
    /// pasted unless the text names another; 0: open.
    void paste(const std::string& text, char letter);
    /// Draws the dialog while it is open, and edits the session's parameters.
    void draw(Session& session, const Derived& derived);
    bool is_open() const { return trouble_.has_value(); }

private:
    struct Paste {
        std::string text;
        char letter = 0;
    };
    struct Trouble {
        PastedMatrix pasted;
        ExplainedMatrix found;
        std::optional<glm::dmat4> fixed;
        char letter;  ///< of the matrix that it can be entered as; 0: none
    };
    void take(const Paste& paste, Session& session, const Derived& derived);

    std::optional<Paste> wanted_;
    std::optional<Trouble> trouble_;
};

}  // namespace viewing
