#include "ui/lesson/cards.h"

#include <algorithm>
#include <cmath>

#include "ui/lesson/lesson_text.h"
#include "ui/parts/look.h"

namespace viewing {
namespace {

constexpr float least_card = 232.0F, card_gap = 14.0F, inset = 8.0F;  ///< design pixels

struct CardSize {
    float width = 0.0F, picture = 0.0F;
    float height = 0.0F;  ///< of the whole row
};

float text_height(const Card& card, float width, const widgets::Context& context) {
    return paragraph(card.title, context.fonts.heading, width - px(2.0F * inset)).height + px(4.0F) +
           context.fonts.note->FontSize;
}

/// Draws a card's background and its picture, which has round corners where it reaches the card's corners.
void draw_ground(ImVec2 min, ImVec2 max, ImVec2 picture_max, ImTextureID texture, ImDrawFlags corners,
                 bool is_hovered) {
    ImDrawList* draw = ImGui::GetWindowDrawList();
    const float rounding = px(6.0F);
    draw->AddRectFilled(min, max, is_hovered ? palette().field_hovered : palette().field, rounding);
    draw->AddRectFilled(min, picture_max, palette().view_ground, rounding, corners);
    if (!texture) return;
    // A picture narrower than 16:9 shows the middle of the thumbnail.
    const float share = std::min(1.0F, (picture_max.x - min.x) / (picture_max.y - min.y) * 9.0F / 16.0F);
    draw->AddImageRounded(texture, min, picture_max, {0.5F - 0.5F * share, 1.0F}, {0.5F + 0.5F * share, 0.0F},
                          IM_COL32_WHITE, rounding, corners);
}

/// Draws a card's title starting at `text`, its note and check mark at the lower edge, and its frame.
void draw_text(const Card& card, ImVec2 min, ImVec2 max, ImVec2 text, bool is_chosen) {
    const widgets::Context& context = widgets::CurrentContext();
    ImDrawList* draw = ImGui::GetWindowDrawList();
    const Paragraph title = paragraph(card.title, context.fonts.heading, max.x - text.x - px(inset));
    draw->AddText(title.font, title.font->FontSize, text, palette().text, title.lines.c_str());
    const ImVec2 note(text.x, max.y - px(inset) - context.fonts.note->FontSize);
    draw->AddText(context.fonts.note, context.fonts.note->FontSize, note, palette().quiet, card.note.c_str());
    if (card.is_done) {
        const ImVec2 sign = context.fonts.heading->CalcTextSizeA(context.fonts.heading->FontSize, FLT_MAX, 0.0F, "✓");
        draw->AddText(context.fonts.heading, context.fonts.heading->FontSize,
                      {max.x - px(inset) - sign.x, max.y - px(inset) - sign.y}, palette().plane, "✓");
    }
    const bool is_framed = is_chosen || card.is_current;
    draw->AddRect(min, max,
                  is_chosen         ? palette().accent
                  : card.is_current ? palette().text
                                    : palette().border,
                  px(6.0F), 0, px(is_framed ? 2.5F : 1.0F));
}

void draw_card(const Card& card, ImVec2 min, const CardSize& size, ImTextureID texture, bool is_chosen,
               bool is_hovered) {
    const ImVec2 max(min.x + size.width, min.y + size.height), picture_max(max.x, min.y + size.picture);
    draw_ground(min, max, picture_max, texture, ImDrawFlags_RoundCornersTop, is_hovered);
    draw_text(card, min, max, {min.x + px(inset), picture_max.y + px(inset)}, is_chosen);
}

}  // namespace

float least_height(const Card& card, const FlatCard& size) {
    return text_height(card, size.width - size.picture, widgets::CurrentContext()) + px(2.0F * inset);
}

bool draw_flat_card(const Card& card, const char* name, const FlatCard& size, ImTextureID texture) {
    const ImVec2 min = ImGui::GetCursorScreenPos(), max(min.x + size.width, min.y + size.height);
    const bool clicked = ImGui::InvisibleButton(name, {size.width, size.height});
    widgets::Record(name);
    draw_ground(min, max, {min.x + size.picture, max.y}, size.picture > 0.0F ? texture : nullptr,
                ImDrawFlags_RoundCornersLeft, ImGui::IsItemHovered());
    draw_text(card, min, max, {min.x + size.picture + px(inset), min.y + px(inset)}, false);
    return clicked;
}

int card_columns() {
    const float width = ImGui::GetIO().DisplaySize.x - px(2.0F * page_margin) - ImGui::GetStyle().ScrollbarSize;
    return std::max(1, static_cast<int>((width + px(card_gap)) / px(least_card + card_gap)));
}

int draw_cards(const std::vector<Card>& cards, const std::function<ImTextureID(const std::string&)>& texture_of,
               int chosen) {
    const widgets::Context& context = widgets::CurrentContext();
    const float width = ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ScrollbarSize;
    const int columns = card_columns();
    CardSize size;
    size.width = std::floor((width - px(card_gap) * static_cast<float>(columns - 1)) / static_cast<float>(columns));
    size.picture = std::floor(size.width * 9.0F / 16.0F);
    int clicked = -1;
    const float left = ImGui::GetCursorPosX();
    for (std::size_t row = 0; row < cards.size(); row += static_cast<std::size_t>(columns)) {
        const std::size_t end = std::min(cards.size(), row + static_cast<std::size_t>(columns));
        size.height = 0.0F;
        for (std::size_t i = row; i < end; ++i)
            size.height = std::max(
                size.height, std::ceil(size.picture + text_height(cards[i], size.width, context) + px(3.0F * inset)));
        const float top = ImGui::GetCursorPosY();
        for (std::size_t i = row; i < end; ++i) {
            ImGui::SetCursorPos({left + static_cast<float>(i - row) * (size.width + px(card_gap)), top});
            const ImVec2 min = ImGui::GetCursorScreenPos();
            const std::string name = "card " + std::to_string(i + 1);
            if (ImGui::InvisibleButton(name.c_str(), {size.width, size.height})) clicked = static_cast<int>(i);
            widgets::Record(name.c_str());
            const bool is_chosen = static_cast<int>(i) == chosen;
            if (is_chosen) ImGui::SetScrollHereY(0.5F);
            draw_card(cards[i], min, size, texture_of(cards[i].key), is_chosen, ImGui::IsItemHovered());
        }
        ImGui::SetCursorPos({left, top + size.height + px(card_gap)});
        ImGui::Dummy({0.0F, 0.0F});
    }
    return clicked;
}

}  // namespace viewing
