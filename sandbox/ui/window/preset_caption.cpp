#include "ui/window/preset_caption.h"

#include <algorithm>
#include <cmath>

#include "text/catalogue.h"
#include "ui/parts/look.h"

namespace viewing {
namespace {

constexpr float arrow_room = 20.0F;  ///< design pixels left of the text, for the fold arrow
constexpr float part_gap = 10.0F;    ///< design pixels between the parts of a line

float width_in(const ImFont& font, const char* text) {
    return font.CalcTextSizeA(font.FontSize, FLT_MAX, 0.0F, text).x;
}

/// Returns the width of "changed" and the "restore" button. Both keep their space while hidden, so that nothing jumps.
float marks_width(const widgets::Context& context) {
    const float scale = context.scale;
    return width_in(*context.fonts.heading, tr("changed")) + width_in(*context.fonts.text, tr("restore")) +
           (part_gap + 2.0F * part_gap + 16.0F) * scale;
}

float line_height(const widgets::Context& context) {
    return context.fonts.text->FontSize + 8.0F * context.scale;
}

std::string sentence_of(const NamedFile& preset, const widgets::Context& context, float width) {
    const float room = width - arrow_room * context.scale - marks_width(context);
    return widgets::BrokenAtBlanks(tr(preset.about.c_str()), std::max(room, 1.0F), *context.fonts.caption);
}

}  // namespace

Caption caption_of(const NamedFile& preset, const widgets::Context& context, ImVec2 picture_px, CaptionFold wanted) {
    if (!context.fonts.caption || preset.about.empty()) return {};
    constexpr float most_of_picture = 0.3F;
    const std::string sentence = sentence_of(preset, context, picture_px.x);
    const auto lines = static_cast<float>(1 + std::count(sentence.begin(), sentence.end(), '\n'));
    const float folded = line_height(context), whole = std::max(folded, lines * context.fonts.caption->FontSize);
    const bool is_folded = wanted.value_or(whole > most_of_picture * picture_px.y);
    return {is_folded ? folded : whole, is_folded};
}

void draw_caption(const NamedFile& preset, Session& session, const Rect& rect, bool is_folded, CaptionFold& wanted) {
    if (rect.empty()) return;
    const widgets::Group group("caption");
    const widgets::Context& context = widgets::CurrentContext();
    ImDrawList* draw = ImGui::GetWindowDrawList();
    const float marks = marks_width(context);
    const bool is_changed = session.departs_from_preset();

    ImGui::SetCursorScreenPos(rect.min);
    const float text_width = std::max(rect.width() - (is_folded && !is_changed ? 0.0F : marks), 1.0F);
    if (ImGui::InvisibleButton("text", {text_width, rect.height()})) wanted = !is_folded;
    const ImVec2 corner = ImGui::GetItemRectMax();
    widgets::Record("text");
    widgets::Tooltip(preset.title.c_str(),
                     is_folded ? marked("Shows what this preset is about (C).") : marked("Folds the description (C)."));

    const ImFont& font = is_folded ? *context.fonts.heading : *context.fonts.caption;
    ImGui::PushFont(context.fonts.heading);
    std::string text = is_folded ? widgets::Shortened(tr(preset.title.c_str()), text_width - px(arrow_room))
                                 : sentence_of(preset, context, rect.width());
    if (text == "…") text.clear();  // no letter of the title fits
    ImGui::PopFont();
    const float top = is_folded ? std::floor((rect.height() - font.FontSize) * 0.5F) : 0.0F;
    const ImU32 ink = is_changed ? palette().quiet : palette().text;
    draw->PushClipRect(rect.min, corner, true);
    const ImVec2 middle(rect.min.x + px(7.0F), rect.min.y + top + font.FontSize * 0.5F);
    const float r = px(4.0F);
    if (is_folded)
        draw->AddTriangleFilled({middle.x - r, middle.y - r}, {middle.x + r, middle.y}, {middle.x - r, middle.y + r},
                                palette().quiet);
    else
        draw->AddTriangleFilled({middle.x - r, middle.y - r}, {middle.x + r, middle.y - r}, {middle.x, middle.y + r},
                                palette().quiet);
    draw->AddText(&font, font.FontSize, {rect.min.x + px(arrow_room), rect.min.y + top}, ink, text.c_str());
    draw->PopClipRect();

    if (!is_changed) return;
    const float y = rect.min.y + std::floor((line_height(context) - context.fonts.heading->FontSize) * 0.5F);
    const float x = rect.max.x - marks + px(part_gap);
    draw->AddText(context.fonts.heading, context.fonts.heading->FontSize, {x, y}, palette().accent, tr("changed"));
    ImGui::SetCursorScreenPos(
        {x + width_in(*context.fonts.heading, tr("changed")) + px(part_gap), rect.min.y + px(1.0F)});
    if (widgets::SmallButton("restore")) session.return_to_preset();
    widgets::Tooltip("restore", marked("Restores the preset's state. Ctrl+Z undoes this."));
}

}  // namespace viewing
