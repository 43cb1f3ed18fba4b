#include "app/looks.h"

#include <backends/imgui_impl_opengl3.h>

#include "ui/window/fonts.h"
#include "ui/window/theme.h"

namespace viewing {

bool Looks::follow(const UiParams& ui, double device_scale, ImVec2 window_px, const Arrangement& arrangement,
                   widgets::Context& context) {
    const widgets::Palette& palette = palette_of(ui.theme);
    const float usual_scale = static_cast<float>(device_scale * ui.scale) * palette.type_scale;
    const float scale = usual_scale * enlargement(window_px, usual_scale, arrangement);
    if (scale == scale_ && ui.theme == theme_) return false;
    context.palette = palette;
    context.scale = scale;
    if (scale != scale_) {
        context.fonts = load_fonts(scale);
        ImGui_ImplOpenGL3_DestroyFontsTexture();
        ImGui_ImplOpenGL3_CreateFontsTexture();
    }
    widgets::ApplyStyle(context);
    scale_ = scale;
    theme_ = ui.theme;
    return true;
}

}  // namespace viewing
