// Pastes a matrix from the clipboard. A correct V, C, P, S or R replaces the state's own; for any other matrix, a
// dialog says what is wrong.
#pragma once

#include <optional>
#include <string>

#include "frame/derive.h"
#include "session/session.h"
#include "topics/matrices/numbers/explain_matrix.h"
#include "topics/matrices/numbers/pasted_matrix.h"

namespace viewing {

class MatrixDialog {
public:
    /// Returns whether a text is a matrix rather than a state or a link.
    static bool is_matrix(const std::string& text);
    /// If the text is a matrix, takes it the next time the dialog is drawn. `letter`: the matrix to replace, unless the
    /// text names another; 0: not specified.
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
        char letter;  ///< the matrix in whose place it can be entered by hand; 0: none
    };
    void take(const Paste& paste, Session& session, const Derived& derived);

    std::optional<Paste> wanted_;
    std::optional<Trouble> trouble_;
};

}  // namespace viewing
