#include "topics/planes/shown/derivation_forms.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "text/catalogue.h"
#include "topics/planes/shown/derivation_text.h"
#include "ui/parts/links.h"
#include "ui/parts/look.h"

namespace viewing {
namespace {

/// One of the three forms. Its symbols are drawn under its numbers, and its entries are linked to the same controls as
/// those of S.
struct Form {
    const char* name;
    const glm::dmat4* matrix;             ///< null: undefined for this light and plane
    const char* needs;                    ///< condition on the plane, besides l_w = 1
    std::array<const char*, 16> symbols;  ///< null: the symbol of S
};

void show_form(const Form& form, float width) {
    ImGui::BeginGroup();
    ImGui::TextUnformatted(tr(form.name));
    if (form.matrix) {
        MatrixCells cells = shadow_cells();
        for (std::size_t cell = 0; cell < cells.size(); ++cell)
            if (form.symbols[cell]) cells[cell].symbol = form.symbols[cell];
        widgets::Matrix(form.name, *form.matrix, {.cells = cells, .roles = derivation_roles(), .target = "matrix:S"},
                        width);
    } else {
        equation({marked("only for"), form.needs, "l_w = 1"}, width);
    }
    ImGui::EndGroup();
}

std::string difference_text(double difference) {
    if (difference == 0.0) return tr("Largest difference between matching entries: 0.");
    const int exponent = static_cast<int>(std::floor(-std::log10(difference)));
    return say("Largest difference between matching entries: below {bound}.",
               "bound"_a = "10⁻" + raised_text(std::max(exponent, 0)));
}

}  // namespace

void show_three_forms(const ShadowForms& forms) {
    derivation_heading(marked("The same matrix in three forms"));
    const Form shown[] = {
        {marked("for y = 0 (Blinn)"),
         forms.blinn ? &*forms.blinn : nullptr,
         "n = (0, 1, 0), d = 0,",
         {"l_y", "-l_x", "0", "0", "0", "0", "0", "0", "0", "-l_z", "l_y", "0", "0", "-1", "0", "l_y"}},
        {marked("with d"),
         forms.with_d ? &*forms.with_d : nullptr,
         "",
         {"n·l + d − l_x n_x", "−l_x n_y", "−l_x n_z", "−l_x d", "−l_y n_x", "n·l + d − l_y n_y", "−l_y n_z", "−l_y d",
          "−l_z n_x", "−l_z n_y", "n·l + d − l_z n_z", "−l_z d", "−n_x", "−n_y", "−n_z", "n·l"}},
        {marked("as 4-vectors: (Π·L) I − L Πᵀ"), &forms.four_vectors, "", {}}};
    if (forms.with_d) widgets::Note(difference_text(forms.largest_difference).c_str());
    const float room = ImGui::GetContentRegionAvail().x, gap = px(10.0F);
    const bool in_a_row = room >= 3.0F * px(250.0F) + 2.0F * gap;
    const float width = in_a_row ? std::floor((room - 2.0F * gap) / 3.0F) : std::min(room, px(420.0F));
    for (std::size_t form = 0; form < std::size(shown); ++form) {
        if (in_a_row && form > 0) ImGui::SameLine(0.0F, gap);
        show_form(shown[form], width);
    }
}

}  // namespace viewing
