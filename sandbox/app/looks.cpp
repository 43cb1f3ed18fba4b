#include "app/looks.h"

#include <backends/imgui_impl_opengl3.h>

#include "state/person/language.h"
#include "text/catalogue.h"
#include "ui/window/font_files.h"
#include "ui/window/fonts.h"
#include "ui/window/theme.h"

namespace viewing {

widgets::Fonts upload_fonts(float scale, Syllables& korean, const TypeSizes& type) {
    const widgets::Fonts fonts = load_fonts(scale, korean, type);
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
    return fonts;
}

bool Looks::follow(const UiParams& ui, double device_scale, ImVec2 window_px, const Arrangement& arrangement,
                   Syllables& korean, widgets::Context& context) {
    const widgets::Palette& palette = palette_of(ui.theme);
    const float usual_scale = static_cast<float>(device_scale * ui.scale) * palette.type_scale;
    const float scale = usual_scale * enlargement(window_px, usual_scale, arrangement);
    const TypeSizes type = type_sizes(arrangement);
    const bool speaks_anew = ui.language != language_;
    if (speaks_anew) {
        // Another window of the process may already have set this language, or a different one.
        const Status spoken = ui.language == spoken_language() ? Status(std::monostate{}) : speak(ui.language);
        trouble_ = spoken ? "" : spoken.error();
        language_ = ui.language;
        korean.want(spoken_texts());
    }
    const bool wants_fonts =
        scale != scale_ || type != type_ || korean.has_new() || arrived_font_files() != font_files_;
    if (!wants_fonts && !speaks_anew && ui.theme == theme_) return false;
    context.palette = palette;
    context.scale = scale;
    if (wants_fonts) context.fonts = upload_fonts(scale, korean, type);
    widgets::ApplyStyle(context);
    scale_ = scale;
    type_ = type;
    font_files_ = arrived_font_files();
    theme_ = ui.theme;
    return true;
}

}  // namespace viewing
