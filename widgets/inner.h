// What the widgets share among themselves and nobody else needs: scaled lengths, fonts, colours, the recorder's
// back door, laid-out formulas. Read widgets.h first.
#pragma once

#include <string_view>

#include "text/catalogue.h"
#include "widgets/widgets.h"

namespace widgets {

using viewing::marked;
using viewing::say;
using viewing::say_count;
using viewing::tr;
using viewing::tr_part;
using viewing::operator""_a;

}  // namespace widgets

namespace widgets::inner {

constexpr float caret_blink_s = 0.2F;

/// Pixels for a length in design pixels.
inline float Px(float design_pixels) {
    return design_pixels * CurrentContext().scale;
}

struct Box {
    ImVec2 min, max;
};

/// A font with the size it is drawn at; ImGui's current one where the caller has none.
struct Face {
    ImFont* font;
    float size;

    ImVec2 Measure(std::string_view text) const;
    void Draw(ImDrawList* draw, ImVec2 position, ImU32 color, std::string_view text) const;
};
Face FaceOf(ImFont* font);

/// Pushes a font while it lives; nothing for null.
struct FontScope {
    explicit FontScope(ImFont* font) : pushed(font != nullptr) {
        if (pushed) ImGui::PushFont(font);
    }
    ~FontScope() {
        if (pushed) ImGui::PopFont();
    }
    FontScope(const FontScope&) = delete;
    FontScope& operator=(const FontScope&) = delete;
    bool pushed;
};

/// a where t = 0, b where t = 1.
ImU32 Mix(ImU32 a, ImU32 b, float t);
ImU32 WithAlpha(ImU32 color, float alpha);
/// Dark or light, whichever can be read on this colour.
ImU32 InkOn(ImU32 color);
/// The colour as it is drawn now: paler inside ImGui::BeginDisabled.
inline ImU32 Shown(ImU32 color) {
    return ImGui::GetColorU32(color);
}
/// Inside ImGui::BeginDisabled; ApplyStyle sets the alpha to 1, and only that block lowers it.
inline bool IsDisabled() {
    return ImGui::GetStyle().Alpha < 0.99F;
}

/// The part of a label that is shown: up to "##".
std::string_view ShownPart(const char* label);
/// The part that the recorder uses: what follows "###", else what is shown, else what follows "##".
std::string_view RecordedPart(const char* label);
void RecordRect(const char* label, ImVec2 min, ImVec2 max, std::string_view text = {});
/// The same of what sets a value or is pressed.
void RecordSwitch(const char* label, ImVec2 min, ImVec2 max, std::string_view text = {});

/// A new frame of what is covered and pointed out.
void BeginTargets(Targets& targets);
/// In place of a number box whose name is covered, a plate: says whether it was. `component` −1: the box is alone.
bool CoveredBox(const char* id_text, int component, ImVec2 size);
/// The last item is the box with the name that its scope gives it.
void MarkBox(int component);

/// The room from the cursor on for a label that may be broken. At least 160 design pixels: a popup that fits itself to
/// what is in it has no width of its own.
float LabelRoom();

/// The label behind a control, quiet, on the same line.
void LabelBehind(const char* label);

/// One item of a control and its label: the label stands behind, or above where there is no room behind a control of
/// this width. Ends with its scope.
struct Labelled {
    Labelled(const char* label, float control_width);
    ~Labelled();
    Labelled(const Labelled&) = delete;
    Labelled& operator=(const Labelled&) = delete;
    const char* label_behind;  ///< null: it stands above
};

/// The frame of a field: rounded, tinted and outlined when `lit`, with a stripe in its role's colour at the left.
void DrawField(ImDrawList* draw, ImVec2 min, ImVec2 max, bool hovered, bool active, bool lit, Role role);
/// A warning sign: a triangle with a stroke and a dot, in shape as well as in colour. As wide as it is high, but for a
/// twentieth.
void DrawWarning(ImDrawList* draw, ImVec2 min, float size);
/// A small solid triangle that points down, or right when folded.
void DrawTriangle(ImDrawList* draw, ImVec2 center, float radius, bool down, ImU32 color);

/// Adds to the links under the pointer for the last item, and says whether a control with these links is to be lit.
bool FollowLinks(Links links);

/// The pointer is over something that stands for a matrix entry.
void PointAtEntry(Links own, Links links);
/// Whether what stands for a matrix entry is to be lit: for itself, or for a parameter whose control is hovered.
bool IsEntryLit(Links own, Links links);

/// Whether the pointer has rested long enough on the item with this rectangle. In a frame only the first item that asks
/// gets a yes: a part explains itself before the group around it.
bool TooltipDue(bool hovered, ImVec2 min, ImVec2 max);
/// The tooltip window with its usual look; End after. `told`: what the recorder keeps of it.
/// How wide a tooltip's lines may be: less where the column leaves less room, as long as that is enough to be read.
float TooltipTextWidth();
void BeginTooltipWindow();
void EndTooltipWindow(std::string_view told = {});

using viewing::NumberChars;
using viewing::Tiny;

/// A formula split into pieces of one size and colour, ready to be drawn anywhere.
struct FormulaLayout {
    struct Piece {
        short begin, end;  ///< in `text`
        float x, y, size;
        ImU32 color;
    };
    static constexpr int max_pieces = 48;
    static constexpr int max_bytes = 256;  ///< what is longer is cut off

    FormulaLayout(const char* formula, std::span<const LetterRole> roles, ImU32 base, Face face);
    void Draw(ImDrawList* draw, ImVec2 position, float opacity = 1.0F) const;
    /// In one colour throughout: for halos.
    void DrawIn(ImDrawList* draw, ImVec2 position, ImU32 color) const;

    char text[max_bytes];
    Piece pieces[max_pieces];
    int piece_count = 0;
    int bytes = 0;
    ImVec2 size;
    ImFont* font;

private:
    void DrawPiece(ImDrawList* draw, ImVec2 position, const Piece& piece, ImU32 color) const;
};

/// How the numbers of a row are written, each in a box of this width: the same everywhere.
struct NumberLook {
    Face face;
    int decimals;
};
NumberLook LookOf(std::span<const double> values, const NumberStyle& style, float width);

/// The box of a Number without its label; `id` is unique in its ImGui id scope and is its name for the recorder.
/// `look` null: that of the number alone.
enum class BoxKind { drag, slider };
bool NumberBox(const char* id, double& value, const NumberStyle& style, float width, BoxKind kind = BoxKind::drag,
               const NumberLook* look = nullptr);

/// Numbers without a label, sharing a width; the component names are for the recorder. `first`: which component of
/// their scope (TargetScope) the first one is.
bool NumberRow(std::span<double> values, std::span<const char* const> names, const NumberStyle& style,
               std::span<const double> defaults, std::span<const Links> links, float width, int first = 0);

/// Several choices as one bar, wrapped where it is too long.
struct Segment {
    const char* name;
    const char* recorded_name;
    bool enabled = true;
    const char* why_disabled = "";
    const char* tip = "";
};
/// The index of the one that was clicked, else −1. `selected` may be −1.
int SegmentBar(std::span<const Segment> segments, int selected);

}  // namespace widgets::inner
