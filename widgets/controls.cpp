// Controls other than numbers: toggles, choices, segments, colors, buttons, and sections.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <utility>

#include "text/numbers.h"
#include "widgets/inner.h"

namespace widgets {

namespace {

bool ResetClicked() {
    return ImGui::IsItemHovered() && ImGui::IsMouseClicked(ImGuiMouseButton_Right);
}

void DrawTextIn(ImDrawList* draw, ImVec2 at, float height, ImU32 color, std::string_view text, ImFont* font = nullptr) {
    const inner::Face face = inner::FaceOf(font);
    face.Draw(draw, ImVec2(at.x, std::floor(at.y + (height - face.size) * 0.5F)), inner::Shown(color), text);
}

void DrawCheckBox(ImDrawList* draw, ImVec2 min, float side, bool on, bool hovered) {
    const Palette& palette = CurrentContext().palette;
    const float rounding = ImGui::GetStyle().FrameRounding;
    const ImVec2 max(min.x + side, min.y + side);
    if (!on) {
        inner::DrawField(draw, min, max, hovered, false, false, Role::none);
        draw->AddRect(min, max, inner::Shown(palette.border), rounding, 0, inner::Px(1) * palette.stroke);
        return;
    }
    const ImU32 fill = hovered ? inner::Mix(palette.accent, palette.text, 0.15F) : palette.accent;
    draw->AddRectFilled(min, max, inner::Shown(fill), rounding);
    const ImVec2 tick[] = {ImVec2(min.x + side * 0.24F, min.y + side * 0.53F),
                           ImVec2(min.x + side * 0.43F, min.y + side * 0.71F),
                           ImVec2(min.x + side * 0.78F, min.y + side * 0.31F)};
    draw->AddPolyline(tick, 3, inner::Shown(inner::InkOn(palette.accent)), 0, side * 0.12F);
}

float CheckBoxSide() {
    return std::floor(ImGui::GetFrameHeight() * 0.76F);
}

}  // namespace

float ToggleWidth(const char* label) {
    return LabelledWidth(label, CheckBoxSide());
}

bool Toggle(const char* label, bool& value, bool default_value) {
    const float height = ImGui::GetFrameHeight(), side = CheckBoxSide(), gap = inner::Px(7);
    const std::string shown = BrokenAtBlanks(tr_part(inner::ShownPart(label)), inner::LabelRoom() - side - gap);
    const ImVec2 text = ImGui::CalcTextSize(shown.c_str());
    const float text_width = shown.empty() ? 0.0F : gap + text.x;
    const float further_lines = std::max(text.y - ImGui::GetTextLineHeight(), 0.0F);
    const ImVec2 min = ImGui::GetCursorScreenPos();
    bool edited = value;
    if (ImGui::InvisibleButton(label, ImVec2(side + text_width, height + further_lines))) edited = !value;
    if (ResetClicked()) edited = default_value;
    const bool changed = edited != value;
    value = edited;
    if (ImGui::IsItemVisible()) {
        ImDrawList* draw = ImGui::GetWindowDrawList();
        const float top = std::floor(min.y + (height - side) * 0.5F);
        DrawCheckBox(draw, ImVec2(min.x, top), side, value, ImGui::IsItemHovered());
        const ImU32 ink = CurrentContext().palette.text;
        if (!shown.empty()) DrawTextIn(draw, ImVec2(min.x + side + gap, min.y), height, ink, shown);
    }
    inner::RecordSwitch(label, ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), value ? "on" : "off");
    return changed;
}

namespace {

/// Draws the items of an open Choice.
void ShowItems(const char* label, int& index, std::span<const char* const> names) {
    const Group items(label);
    for (std::size_t i = 0; i < names.size(); ++i) {
        const int item = static_cast<int>(i);
        ImGui::PushID(item);
        if (ImGui::Selectable(LabelText(names[i]).c_str(), item == index)) index = item;
        ImGui::PopID();
        Record(names[i]);
    }
}

}  // namespace

bool ClosePopupOnEscape() {
    // An active item handles Escape itself: a text field restores its old text.
    const bool pressed = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false);
    if (!pressed || !ImGui::IsWindowFocused() || ImGui::IsAnyItemActive()) return false;
    ImGui::CloseCurrentPopup();
    return true;
}

namespace {

constexpr float arrow_room = 18.0F;  ///< design pixels for the triangle of a closed list

/// Draws a preview in the small font, in two tight lines if one is not enough and the field is high enough for two;
/// else shortens the text.
void DrawLongPreview(ImDrawList* draw, ImVec2 min, float height, const char* preview, float room) {
    const inner::FontScope font(CurrentContext().fonts.note);
    const std::string broken = BrokenAtBlanks(preview, room);
    const std::size_t end = broken.find('\n');
    // Lines of digits and letters may be tight; syllables, whose first byte is EA to ED, fill their lines.
    const bool has_syllables = std::any_of(preview, preview + std::strlen(preview), [](char byte) {
        return static_cast<unsigned char>(byte) >= 0xEA && static_cast<unsigned char>(byte) <= 0xED;
    });
    const bool has_two_lines = (has_syllables ? 1.9F : 1.5F) * ImGui::GetFontSize() <= height;
    const bool fits = ImGui::CalcTextSize(broken.c_str()).x <= room && end == broken.rfind('\n') &&
                      (end == std::string::npos || has_two_lines);
    const ImU32 ink = CurrentContext().palette.text;
    const ImVec2 at(min.x + ImGui::GetStyle().FramePadding.x, min.y);
    if (!fits || end == std::string::npos) {
        DrawTextIn(draw, at, height, ink, fits ? broken : Shortened(preview, room));
        return;
    }
    DrawTextIn(draw, at, height * 0.5F, ink, broken.substr(0, end));
    DrawTextIn(draw, ImVec2(at.x, at.y + height * 0.5F), height * 0.5F, ink, broken.substr(end + 1));
}

}  // namespace

bool BeginChoice(const char* label, const char* preview, float width) {
    ImDrawList* draw = ImGui::GetWindowDrawList();
    if (width <= 0.0F) width = ImGui::CalcItemWidth();
    const ImVec2 min = ImGui::GetCursorScreenPos();
    const ImVec2 max(min.x + width, min.y + ImGui::GetFrameHeight());
    inner::RecordSwitch(label, min, max, preview);
    const float text_room = width - ImGui::GetStyle().FramePadding.x * 2.0F - inner::Px(arrow_room);
    const bool is_long = inner::FaceOf(nullptr).Measure(preview).x > text_room + 1.0F;
    ImGui::PushID(label);
    ImGui::SetNextItemWidth(width);
    const bool open = ImGui::BeginCombo("##combo", is_long ? "" : tr(preview),
                                        ImGuiComboFlags_NoArrowButton | ImGuiComboFlags_HeightLargest);
    if (is_long) DrawLongPreview(draw, min, max.y - min.y, tr(preview), text_room + 1.0F);
    inner::DrawTriangle(draw, ImVec2(max.x - inner::Px(13), (min.y + max.y) * 0.5F), inner::Px(4), true,
                        inner::Shown(CurrentContext().palette.quiet));
    if (open) {
        ClosePopupOnEscape();
    } else {
        ImGui::PopID();
    }
    return open;
}

void EndChoice() {
    ImGui::EndCombo();
    ImGui::PopID();
}

bool ClosedList(const char* label, const char* preview, float width) {
    const ImVec2 min = ImGui::GetCursorScreenPos();
    const ImVec2 max(min.x + width, min.y + ImGui::GetFrameHeight());
    const bool clicked = ImGui::InvisibleButton(label, {width, max.y - min.y});
    ImDrawList* draw = ImGui::GetWindowDrawList();
    inner::DrawField(draw, min, max, ImGui::IsItemHovered(), ImGui::IsItemActive(), false, Role::none);
    const float padding = ImGui::GetStyle().FramePadding.x;
    const float room = width - padding * 2.0F - inner::Px(arrow_room);
    if (inner::FaceOf(nullptr).Measure(preview).x > room)
        DrawLongPreview(draw, min, max.y - min.y, tr(preview), room);
    else
        DrawTextIn(draw, ImVec2(min.x + padding, min.y), max.y - min.y, CurrentContext().palette.text, preview);
    inner::DrawTriangle(draw, ImVec2(max.x - inner::Px(13), (min.y + max.y) * 0.5F), inner::Px(4), true,
                        inner::Shown(CurrentContext().palette.quiet));
    inner::RecordSwitch(label, min, max, preview);
    return clicked;
}

float ChoiceWidth(std::span<const char* const> names) {
    float width = 0.0F;
    for (const char* name : names) width = std::max(width, inner::FaceOf(nullptr).Measure(name).x);
    return std::ceil(width + ImGui::GetStyle().FramePadding.x * 2.0F + inner::Px(arrow_room));
}

bool Choice(const char* label, int& index, std::span<const char* const> names, int default_index, float width) {
    const int count = static_cast<int>(names.size());
    if (width <= 0.0F) width = ChoiceWidth(names);
    const char* preview = index >= 0 && index < count ? names[index] : "—";
    int edited = index;

    {
        const inner::Labelled labelled(label, width);
        if (BeginChoice(label, preview, width)) {
            ShowItems(label, edited, names);
            EndChoice();
        } else if (ResetClicked()) {
            edited = default_index;
        }
    }
    const bool changed = edited != index;
    index = edited;
    return changed;
}

namespace inner {

namespace {

bool DrawSegment(const Segment& segment, ImVec2 size, bool selected, ImDrawFlags corners) {
    const Palette& palette = CurrentContext().palette;
    const ImGuiStyle& style = ImGui::GetStyle();
    ImGui::BeginDisabled(!segment.enabled);
    const ImVec2 min = ImGui::GetCursorScreenPos();
    const ImVec2 max(min.x + size.x, min.y + size.y);
    const bool clicked = ImGui::InvisibleButton(segment.recorded_name, size);
    ImDrawList* draw = ImGui::GetWindowDrawList();
    ImU32 fill = ImGui::IsItemHovered() ? palette.field_hovered : palette.field;
    if (selected) fill = Mix(fill, palette.accent, 0.42F);
    draw->AddRectFilled(min, max, Shown(fill), style.FrameRounding, corners);
    const float border = selected ? std::max(style.FrameBorderSize, Px(1)) : style.FrameBorderSize;
    const ImU32 line = selected ? palette.accent : palette.border;
    if (border > 0.0F) draw->AddRect(min, max, Shown(line), style.FrameRounding, corners, border);
    const float text_width = FaceOf(nullptr).Measure(segment.name).x;
    const ImVec2 text_at(std::floor(min.x + (size.x - text_width) * 0.5F), min.y);
    DrawTextIn(draw, text_at, size.y, selected ? palette.text : Mix(palette.quiet, palette.text, 0.35F), segment.name);
    RecordSwitch(segment.recorded_name, min, max, selected ? "on" : "off");
    ImGui::EndDisabled();
    Tooltip(*segment.tip ? segment.name : "", segment.tip);
    if (!segment.enabled) Tooltip("", segment.why_disabled);
    return clicked;
}

}  // namespace

int SegmentBar(std::span<const Segment> segments, int selected) {
    const float padding = Px(9), gap = Px(1), height = ImGui::GetFrameHeight();
    const float room = ImGui::GetContentRegionAvail().x;
    const auto width_of = [padding](const Segment& segment) {
        return std::ceil(FaceOf(nullptr).Measure(segment.name).x + 2.0F * padding);
    };
    int clicked = -1;
    float used = 0.0F;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const float width = width_of(segments[i]);
        const bool starts_row = i == 0 || used + gap + width > room;
        if (!starts_row) ImGui::SameLine(0.0F, gap);
        used = starts_row ? width : used + gap + width;
        const bool ends_row = i + 1 == segments.size() || used + gap + width_of(segments[i + 1]) > room;
        const ImDrawFlags corners = (starts_row ? ImDrawFlags_RoundCornersLeft : ImDrawFlags_None) |
                                    (ends_row ? ImDrawFlags_RoundCornersRight : ImDrawFlags_None);
        const bool is_selected = static_cast<int>(i) == selected;
        if (DrawSegment(segments[i], ImVec2(width, height), is_selected,
                        corners == ImDrawFlags_None ? ImDrawFlags_RoundCornersNone : corners)) {
            clicked = static_cast<int>(i);
        }
    }
    return clicked;
}

}  // namespace inner

bool Segments(const char* label, int& index, std::span<const char* const> names, int default_index,
              std::span<const char* const> tips) {
    constexpr std::size_t most = 16;
    IM_ASSERT(names.size() <= most);
    inner::Segment segments[most];
    for (std::size_t i = 0; i < names.size(); ++i) {
        segments[i] = {.name = names[i], .recorded_name = names[i], .tip = i < tips.size() ? tips[i] : ""};
    }

    int edited = index;
    ImGui::BeginGroup();
    {
        const Group group(label);
        const int clicked = inner::SegmentBar({segments, names.size()}, index);
        if (clicked >= 0) edited = clicked;
    }
    inner::LabelBehind(label);
    ImGui::EndGroup();
    if (ResetClicked()) edited = default_index;
    const bool changed = edited != index;
    index = edited;
    return changed;
}

namespace {

glm::vec3 FloatsOf(const glm::u8vec3& rgb) {
    return glm::vec3(rgb) / 255.0F;
}
glm::u8vec3 BytesOf(const glm::vec3& color) {
    return glm::u8vec3(glm::round(glm::clamp(color, 0.0F, 1.0F) * 255.0F));
}

void DrawColorBox(ImVec2 min, ImVec2 max, const glm::u8vec3& rgb, const char* hex) {
    const Palette& palette = CurrentContext().palette;
    ImDrawList* draw = ImGui::GetWindowDrawList();
    inner::DrawField(draw, min, max, ImGui::IsItemHovered(), ImGui::IsItemActive(), false, Role::none);
    const float inset = inner::Px(4), rounding = ImGui::GetStyle().GrabRounding;
    const ImVec2 swatch_min(min.x + inset, min.y + inset);
    const ImVec2 swatch_max(swatch_min.x + inner::Px(20), max.y - inset);
    draw->AddRectFilled(swatch_min, swatch_max, inner::Shown(IM_COL32(rgb.r, rgb.g, rgb.b, 255)), rounding);
    draw->AddRect(swatch_min, swatch_max, inner::Shown(palette.border), rounding, 0, inner::Px(1));
    DrawTextIn(draw, ImVec2(swatch_max.x + inner::Px(7), min.y), max.y - min.y, palette.text, hex,
               CurrentContext().fonts.number);
}

}  // namespace

bool ColorField(const char* label, glm::u8vec3& rgb, const glm::u8vec3& default_value) {
    glm::vec3& working = CurrentContext().editing.color;
    glm::u8vec3 edited = rgb;
    const std::string hex = viewing::hex_color(rgb.r, rgb.g, rgb.b);

    const float width = std::ceil(inner::Px(38) + inner::FaceOf(CurrentContext().fonts.number).Measure(hex).x);
    const inner::Labelled labelled(label, width);
    ImGui::PushID(label);
    if (ImGui::InvisibleButton("##box", ImVec2(width, ImGui::GetFrameHeight()))) {
        working = FloatsOf(rgb);
        ImGui::OpenPopup("picker");
    }
    if (ResetClicked()) edited = default_value;
    DrawColorBox(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), rgb, hex.c_str());
    inner::RecordSwitch(label, ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), hex.c_str());
    if (ImGui::BeginPopup("picker")) {
        ClosePopupOnEscape();
        // Keep the finer copy while it still matches: 8 bits would lose hue and saturation.
        if (BytesOf(working) != rgb) working = FloatsOf(rgb);
        ImGui::SetNextItemWidth(inner::Px(200));
        if (ImGui::ColorPicker3("##picker", &working[0],
                                ImGuiColorEditFlags_NoSidePreview | ImGuiColorEditFlags_NoOptions |
                                    ImGuiColorEditFlags_DisplayHex | ImGuiColorEditFlags_NoLabel)) {
            edited = BytesOf(working);
        }
        inner::RecordRect("picker", ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
        ImGui::EndPopup();
    }
    ImGui::PopID();

    const bool changed = edited != rgb;
    rgb = edited;
    return changed;
}

namespace {

/// Returns a button's name as a target: "button:show C" for the button "Show C".
std::string TargetOfButton(const char* label) {
    const Targets& targets = CurrentContext().targets;
    if (targets.empty() && !targets.offered) return {};
    std::string name = "button:" + std::string(inner::RecordedPart(label));
    constexpr std::size_t first = std::string_view("button:").size();
    if (name.size() > first && name[first] >= 'A' && name[first] <= 'Z') name[first] += 'a' - 'A';
    return name;
}

}  // namespace

bool Button(const char* label, bool enabled, const char* why_disabled) {
    const std::string target = TargetOfButton(label),
                      text = BrokenLabelText(label, 2.0F * ImGui::GetStyle().FramePadding.x);
    if (IsCovered(target)) {
        const ImVec2 padding = ImGui::GetStyle().FramePadding, size = ImGui::CalcTextSize(text.c_str(), nullptr, true);
        Plate(label, {size.x + 2.0F * padding.x, size.y + 2.0F * padding.y});
        MarkTarget(target);
        return false;
    }
    if (!Offers(target)) {
        ImGui::Dummy(ImVec2(0.0F, ImGui::CalcTextSize(text.c_str()).y + 2.0F * ImGui::GetStyle().FramePadding.y));
        return false;
    }
    ImGui::BeginDisabled(!enabled);
    const bool clicked = ImGui::Button(text.c_str());
    inner::RecordSwitch(label, ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
    MarkTarget(target);
    ImGui::EndDisabled();
    if (!enabled) Tooltip("", why_disabled);
    return clicked;
}

namespace {

constexpr float small_padding = 8.0F;  ///< design pixels on each side of a small button's text

}  // namespace

float SmallButtonWidth(const char* label) {
    return inner::FaceOf(nullptr).Measure(inner::ShownPart(label)).x + 2.0F * inner::Px(small_padding);
}

bool OffersButton(const char* label) {
    return Offers(TargetOfButton(label));
}

bool SmallButton(const char* label, bool enabled, const char* why_disabled) {
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(inner::Px(small_padding), inner::Px(2)));
    const bool clicked = Button(label, enabled, why_disabled);
    ImGui::PopStyleVar();
    return clicked;
}

bool Section(const char* label, bool open_by_default, const char* note, const char* trouble, Tone tone) {
    if (IsListing()) return true;
    const Context& context = CurrentContext();
    const Palette& palette = context.palette;
    ImGuiStorage* storage = ImGui::GetStateStorage();
    const ImGuiID id = ImGui::GetID(label);
    if (std::exchange(CurrentContext().targets.opens_next, false)) storage->SetBool(id, true);
    const bool is_asked = CurrentContext().section_asked == label;
    if (is_asked) {
        storage->SetBool(id, true);
        CurrentContext().section_asked.clear();
        ImGui::SetScrollHereY(0.0F);
    }
    bool open = storage->GetBool(id, open_by_default);

    ImGui::Dummy(ImVec2(0.0F, inner::Px(1)));
    CurrentContext().sections.push_back(
        {label, std::string(viewing::tr_part(inner::ShownPart(label))), ImGui::GetCursorPosY()});
    const ImVec2 min = ImGui::GetCursorScreenPos();
    const ImVec2 size(std::max(ImGui::GetContentRegionAvail().x, 1.0F), ImGui::GetFrameHeight());
    const ImVec2 max(min.x + size.x, min.y + size.y);
    if (ImGui::InvisibleButton(label, size)) {
        open = !open;
        storage->SetBool(id, open);
    }
    ImDrawList* draw = ImGui::GetWindowDrawList();
    const ImU32 fill =
        ImGui::IsItemHovered() ? inner::Mix(palette.raised, palette.field_hovered, 0.8F) : palette.raised;
    draw->AddRectFilled(min, max, inner::Shown(fill), ImGui::GetStyle().FrameRounding);
    inner::DrawTriangle(draw, ImVec2(min.x + inner::Px(14), (min.y + max.y) * 0.5F), inner::Px(4.5F), open,
                        inner::Shown(inner::Mix(palette.quiet, palette.text, 0.5F)));
    DrawTextIn(draw, ImVec2(min.x + inner::Px(28), min.y), size.y, palette.text, inner::ShownPart(label),
               context.fonts.heading);
    if (*trouble) {
        const float sign = ImGui::GetFontSize();
        DrawSign(draw, ImVec2(max.x - inner::Px(9) - sign, min.y + (size.y - sign) * 0.5F), sign, tone);
        inner::RecordRect((std::string(inner::RecordedPart(label)) + "/trouble").c_str(), min, max, trouble);
        Tooltip("", trouble);
    } else if (*note) {
        const float width = inner::FaceOf(context.fonts.note).Measure(note).x;
        DrawTextIn(draw, ImVec2(max.x - width - inner::Px(9), min.y), size.y, palette.quiet, note, context.fonts.note);
    }
    inner::RecordRect(label, min, max, open ? "open" : "folded");
    return open;
}

}  // namespace widgets
