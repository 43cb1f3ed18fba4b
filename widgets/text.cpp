// Text that is not a control: notes, troubles, values, labels beside controls, and tooltips.
#include <algorithm>
#include <string>

#include "text/words.h"
#include "widgets/inner.h"

namespace widgets {

std::string Shortened(std::string text, float width) {
    const inner::Face face = inner::FaceOf(nullptr);
    if (face.Measure(text).x <= width) return text;
    while (!text.empty() && face.Measure(text + "…").x > width) viewing::remove_last_character(text);
    while (text.ends_with(' ')) text.pop_back();
    return text + "…";
}

namespace {

/// Wraps a text at spaces. `width_of` measures a line.
template <typename Measure>
std::string Broken(std::string_view text, float width, const Measure& width_of) {
    if (std::string whole(text); width_of(whole) <= width) return whole;
    std::string broken, line;
    while (!text.empty()) {
        std::string_view word = viewing::unbroken_start(text);
        if (width_of(std::string(word)) > width) word = text.substr(0, text.find(' '));
        text.remove_prefix(std::min(text.size(), word.size() + 1));
        const std::string longer = line.empty() ? std::string(word) : line + ' ' + std::string(word);
        const bool fits = line.empty() || width_of(longer) <= width;
        if (!fits) broken += line + '\n';
        line = fits ? longer : std::string(word);
    }
    return broken + line;
}

}  // namespace

std::string BrokenAtBlanks(std::string_view text, float width) {
    return Broken(text, width, [](const std::string& line) { return ImGui::CalcTextSize(line.c_str()).x; });
}

std::string BrokenAtBlanks(std::string_view text, float width, const ImFont& font) {
    return Broken(text, width, [&font](const std::string& line) {
        return font.CalcTextSizeA(font.FontSize, FLT_MAX, 0.0F, line.c_str()).x;
    });
}

namespace {

/// Draws text in one color, wrapped at the window's edge, and records it.
void WrappedText(const char* recorded_as, const char* text, ImU32 color) {
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    ImGui::PushTextWrapPos(0.0F);  // for words that are wider than a line
    ImGui::TextUnformatted(BrokenAtBlanks(tr(text), ImGui::GetContentRegionAvail().x).c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    inner::RecordRect(recorded_as, ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), text);
}

}  // namespace

void Note(const char* text) {
    const inner::FontScope font(CurrentContext().fonts.note);
    WrappedText("note", text, CurrentContext().palette.quiet);
}

ImU32 ColorOf(Tone tone) {
    const Palette& palette = CurrentContext().palette;
    return tone == Tone::wrong ? palette.trouble : tone == Tone::note ? palette.text : palette.quiet;
}

void DrawSign(ImDrawList* draw, ImVec2 min, float size, Tone tone) {
    const ImU32 color = inner::Shown(ColorOf(tone)), ink = inner::Shown(CurrentContext().palette.ground);
    const float width = size * 0.95F, top = min.y + size * 0.08F, bottom = min.y + size * 0.92F;
    const float middle = min.x + width * 0.5F, stroke = size * 0.10F;
    if (tone == Tone::window)
        return draw->AddRect({min.x + stroke, top + stroke}, {min.x + width - stroke, bottom - stroke}, color, stroke,
                             0, stroke);
    if (tone == Tone::note) {
        draw->AddCircleFilled({middle, 0.5F * (top + bottom)}, 0.42F * size, color);
        draw->AddCircleFilled({middle, top + size * 0.20F}, stroke * 0.7F, ink, 8);
        draw->AddLine({middle, top + size * 0.36F}, {middle, bottom - size * 0.16F}, ink, stroke);
        return;
    }
    draw->AddTriangleFilled({middle, top}, {min.x + width, bottom}, {min.x, bottom}, color);
    draw->AddLine({middle, top + size * 0.28F}, {middle, bottom - size * 0.28F}, ink, stroke);
    draw->AddCircleFilled({middle, bottom - size * 0.15F}, stroke * 0.6F, ink, 8);
}

void Trouble(const char* sentence) {
    const float size = ImGui::GetFontSize();
    DrawSign(ImGui::GetWindowDrawList(), ImGui::GetCursorScreenPos(), size, Tone::wrong);
    ImGui::Dummy(ImVec2(size * 0.95F, size));
    ImGui::SameLine(0.0F, inner::Px(6));
    WrappedText("trouble", sentence, ColorOf(Tone::wrong));
}

float TroubleHeight(const char* sentence, float width) {
    const float beside_sign = width - ImGui::GetFontSize() * 0.95F - inner::Px(6);
    return ImGui::CalcTextSize(BrokenAtBlanks(tr(sentence), beside_sign).c_str(), nullptr, false, beside_sign).y;
}

void ValueText(const char* text, Role role) {
    const inner::FontScope font(CurrentContext().fonts.number);
    ImGui::PushStyleColor(ImGuiCol_Text, CurrentContext().palette.of(role));
    ImGui::TextUnformatted(text);
    ImGui::PopStyleColor();
    inner::RecordRect("value", ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), text);
}

namespace {

/// Draws the formulas, which are separated by "; ", one below the other.
void TooltipFormulas(std::string_view formulas, std::span<const LetterRole> roles) {
    constexpr std::string_view between = "; ";
    while (!formulas.empty()) {
        const std::string formula(formulas.substr(0, formulas.find(between)));
        const inner::FormulaLayout layout(formula.c_str(), roles, CurrentContext().palette.text,
                                          inner::FaceOf(nullptr));
        layout.Draw(ImGui::GetWindowDrawList(), ImGui::GetCursorScreenPos());
        ImGui::Dummy(layout.size);
        formulas.remove_prefix(std::min(formulas.size(), formula.size() + between.size()));
    }
}

void TooltipLine(const char* text, ImU32 color, ImFont* font) {
    const inner::FontScope scope(font);
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    ImGui::TextUnformatted(text);
    ImGui::PopStyleColor();
}

}  // namespace

void Tooltip(const char* title, const char* body, const char* formula, const char* gl_call,
             std::span<const LetterRole> roles, const char* path) {
    if (!*title && !*body && !*formula && !*gl_call) return;
    const bool hovered = ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled);
    if (!inner::TooltipDue(hovered, ImGui::GetItemRectMin(), ImGui::GetItemRectMax())) return;
    const Context& context = CurrentContext();
    inner::BeginTooltipWindow();
    if (*title) {
        const inner::FontScope font(context.fonts.heading);
        ImGui::TextUnformatted(BrokenAtBlanks(tr(title), inner::TooltipTextWidth()).c_str());
    }
    if (*body) ImGui::TextUnformatted(BrokenAtBlanks(tr(body), inner::TooltipTextWidth()).c_str());
    const bool has_formula = *formula && !IsCovered("formulas");
    if (has_formula) TooltipFormulas(formula, roles);
    if (*gl_call) TooltipLine(gl_call, context.palette.accent, context.fonts.number);
    if (*path) TooltipLine(path, context.palette.quiet, context.fonts.small_number);
    std::string all = title;
    for (const char* line : {body, has_formula ? formula : "", gl_call, path}) {
        if (*line) all.append("\n").append(line);
    }
    inner::EndTooltipWindow(all);
}

namespace inner {

Face FaceOf(ImFont* font) {
    if (!font) return {ImGui::GetFont(), ImGui::GetFontSize()};
    return {font, font->FontSize * font->Scale * ImGui::GetIO().FontGlobalScale};
}

ImVec2 Face::Measure(std::string_view text) const {
    text = tr_part(text);
    return font->CalcTextSizeA(size, 1e9F, 0.0F, text.data(), text.data() + text.size());
}

void Face::Draw(ImDrawList* draw, ImVec2 position, ImU32 color, std::string_view text) const {
    text = tr_part(text);
    draw->AddText(font, size, position, color, text.data(), text.data() + text.size());
}

float LabelRoom() {
    return std::max(ImGui::GetContentRegionAvail().x, Px(160));
}

namespace {

constexpr float label_gap = 7.0F;  ///< design pixels between a control and its label

void QuietText(std::string_view text) {
    ImGui::PushStyleColor(ImGuiCol_Text, CurrentContext().palette.quiet);
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopStyleColor();
}

}  // namespace

void LabelBehind(const char* label) {
    const std::string_view shown = tr_part(ShownPart(label));
    if (shown.empty()) return;
    ImGui::SameLine(0.0F, Px(label_gap));
    ImGui::AlignTextToFramePadding();
    QuietText(shown);
}

Labelled::Labelled(const char* label, float control_width) : label_behind(label) {
    ImGui::BeginGroup();
    const std::string_view shown = tr_part(ShownPart(label));
    if (shown.empty() || LabelledWidth(label, control_width) <= LabelRoom()) return;
    label_behind = nullptr;
    QuietText(BrokenAtBlanks(shown, LabelRoom()));
}

Labelled::~Labelled() {
    if (label_behind) LabelBehind(label_behind);
    ImGui::EndGroup();
}

namespace {

constexpr float tooltip_gap = 8.0F, tooltip_padding = 11.0F;  ///< design pixels
constexpr float column_share = 0.5F;                          ///< of the display's width; wider windows are not columns

/// Returns the space in pixels beside the current window, on the side that has more; 0 if the window is not a column.
float RoomBesideColumn() {
    const float screen = ImGui::GetIO().DisplaySize.x, left = ImGui::GetWindowPos().x;
    if (ImGui::GetWindowWidth() > column_share * screen) return 0.0F;
    return std::max(left, screen - left - ImGui::GetWindowWidth()) - 2.0F * Px(tooltip_gap);
}

/// Returns the position of a tooltip of this size: beside the column, so that it covers neither the item nor its
/// neighbors, or, if it does not fit there, below or above the item.
ImVec2 TooltipPlace(const ImVec4& item, ImVec2 size) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float left = ImGui::GetWindowPos().x, right = left + ImGui::GetWindowWidth(), gap = Px(tooltip_gap);
    if (size.x <= RoomBesideColumn())
        return {right + gap + size.x <= screen.x ? right + gap : left - gap - size.x,
                std::max(std::min(item.y, screen.y - size.y), 0.0F)};
    const bool fits_below = item.w + gap + size.y <= screen.y;
    return {std::max(std::min(item.x, screen.x - size.x), 0.0F),
            fits_below ? item.w + gap : std::max(item.y - gap - size.y, 0.0F)};
}

}  // namespace

float TooltipTextWidth() {
    const float usual = Px(340), least = Px(200), room = RoomBesideColumn() - 2.0F * Px(tooltip_padding);
    return room >= least ? std::min(usual, room) : usual;
}

void BeginTooltipWindow() {
    const Editing& editing = CurrentContext().editing;
    const float text_width = TooltipTextWidth();
    ImGui::SetNextWindowPos(TooltipPlace(editing.tooltip_of, editing.tooltip_size));
    // The explanation of a disabled item must not be pale.
    ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 1.0F);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(Px(tooltip_padding), Px(9)));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(Px(6), Px(5)));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, Px(6));
    ImGui::BeginTooltip();
    ImGui::BeginGroup();
    ImGui::PushTextWrapPos(Px(tooltip_padding) + text_width);
}

void EndTooltipWindow(std::string_view told) {
    ImGui::PopTextWrapPos();
    ImGui::EndGroup();
    // Measure the content: the window's own size is one frame late.
    const ImVec2 content = ImGui::GetItemRectSize(), padding = ImGui::GetStyle().WindowPadding;
    CurrentContext().editing.tooltip_size = {content.x + 2.0F * padding.x, content.y + 2.0F * padding.y};
    const ImVec2 min = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    RecordRect("tooltip", min, ImVec2(min.x + size.x, min.y + size.y), told);
    ImGui::EndTooltip();
    ImGui::PopStyleVar(4);
}

}  // namespace inner

std::string BrokenLabelText(const char* label, float taken) {
    return BrokenAtBlanks(tr_part(inner::ShownPart(label)), inner::LabelRoom() - taken) + "###" + label;
}

float LabelledWidth(const char* label, float control_width) {
    const std::string_view shown = inner::ShownPart(label);
    return shown.empty() ? control_width
                         : control_width + inner::Px(inner::label_gap) + inner::FaceOf(nullptr).Measure(shown).x;
}

}  // namespace widgets
