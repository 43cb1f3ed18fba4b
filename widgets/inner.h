// Internals that the widgets share: scaled lengths, fonts, colors, recorder access, and formula layout. Read widgets.h
// first.
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

/// Converts design pixels to pixels.
inline float Px(float design_pixels) {
    return design_pixels * CurrentContext().scale;
}

struct Box {
    ImVec2 min, max;
};

/// A font and the size at which to draw it. FaceOf(nullptr) returns ImGui's current font.
struct Face {
    ImFont* font;
    float size;

    ImVec2 Measure(std::string_view text) const;
    void Draw(ImDrawList* draw, ImVec2 position, ImU32 color, std::string_view text) const;
};
Face FaceOf(ImFont* font);

/// Pushes a font until the end of the scope; does nothing if it is null.
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

/// Interpolates: a at t = 0, b at t = 1.
ImU32 Mix(ImU32 a, ImU32 b, float t);
ImU32 WithAlpha(ImU32 color, float alpha);
/// Returns black or white, whichever is readable on this color.
ImU32 InkOn(ImU32 color);
/// Returns the color as it is currently drawn: paler inside ImGui::BeginDisabled.
inline ImU32 Shown(ImU32 color) {
    return ImGui::GetColorU32(color);
}
/// Returns whether widgets are inside ImGui::BeginDisabled. ApplyStyle sets the alpha to 1, and only BeginDisabled
/// lowers it.
inline bool IsDisabled() {
    return ImGui::GetStyle().Alpha < 0.99F;
}

/// Returns the visible part of a label, which ends before "##".
std::string_view ShownPart(const char* label);
/// Returns the part that the recorder uses: the text after "###" or, if there is none, the visible part or, if that is
/// empty, the text after "##".
std::string_view RecordedPart(const char* label);
void RecordRect(const char* label, ImVec2 min, ImVec2 max, std::string_view text = {});
/// Like RecordRect, for buttons and for controls that set a value.
void RecordSwitch(const char* label, ImVec2 min, ImVec2 max, std::string_view text = {});

/// Starts a new frame for the covered and highlighted targets.
void BeginTargets(Targets& targets);
/// If the box's name is covered, draws a plate and returns true. `component`: the box's index in a row, or −1
/// for a box on its own.
bool CoveredBox(const char* id_text, int component, ImVec2 size);
/// Marks the last item, a box, with the name that the current scope gives this box.
void MarkBox(int component);

/// Returns the width available for a label, which may wrap: at least 160 design pixels, since a popup that fits its
/// content has no width of its own.
float LabelRoom();

/// Draws the label to the right of a control, in the quiet color.
void LabelBehind(const char* label);

/// Groups a control and its label into one item. The label is to the right of the control, or above it if a control of
/// this width leaves no space. The group ends when this object goes out of scope.
struct Labelled {
    Labelled(const char* label, float control_width);
    ~Labelled();
    Labelled(const Labelled&) = delete;
    Labelled& operator=(const Labelled&) = delete;
    const char* label_behind;  ///< null: the label is above
};

/// Draws a field's rounded frame, with a stripe in its role's color at the left. Tints and outlines it when `lit`.
void DrawField(ImDrawList* draw, ImVec2 min, ImVec2 max, bool hovered, bool active, bool lit, Role role);
/// Draws a small solid triangle that points down or, unless `down`, to the right.
void DrawTriangle(ImDrawList* draw, ImVec2 center, float radius, bool down, ImU32 color);

/// If the last item is hovered, adds these links to those under the pointer. Returns whether to highlight a control
/// with these links.
bool FollowLinks(Links links);

/// Call while the pointer is over an item that represents a matrix entry.
void PointAtEntry(Links own, Links links);
/// Returns whether to highlight an item that represents a matrix entry, because the pointer is over the entry or over
/// the control of one of its parameters.
bool IsEntryLit(Links own, Links links);

/// Returns whether the pointer has rested long enough on the item with this rectangle. Returns true only for the first
/// item that asks in a frame, so a part takes precedence over its group.
bool TooltipDue(bool hovered, ImVec2 min, ImVec2 max);
/// Returns the maximum width of a tooltip's lines: they fit beside the column, unless they would then be too short to
/// read comfortably.
float TooltipTextWidth();
/// Opens the tooltip window in its usual style; call EndTooltipWindow afterward. `told`: the text to record.
void BeginTooltipWindow();
void EndTooltipWindow(std::string_view told = {});

using viewing::NumberChars;
using viewing::Tiny;

/// A formula split into pieces, each of one size and color, ready to be drawn anywhere.
struct FormulaLayout {
    struct Piece {
        short begin, end;  ///< in `text`
        float x, y, size;
        ImU32 color;
    };
    static constexpr int max_pieces = 48;
    static constexpr int max_bytes = 256;  ///< longer text is cut off

    FormulaLayout(const char* formula, std::span<const LetterRole> roles, ImU32 base, Face face);
    void Draw(ImDrawList* draw, ImVec2 position, float opacity = 1.0F) const;

    char text[max_bytes];
    Piece pieces[max_pieces];
    int piece_count = 0;
    int bytes = 0;
    ImVec2 size;
    ImFont* font;
};

/// The font and the number of decimals that all numbers of a row share. LookOf chooses them for boxes of a given width.
struct NumberLook {
    Face face;
    int decimals;
};
NumberLook LookOf(std::span<const double> values, const NumberStyle& style, float width);

enum class BoxKind { drag, slider };
/// Draws the box of a Number, without the label. `id` is unique in its ImGui id scope and names the box for the
/// recorder. If `look` is null, the box chooses one for this number alone.
bool NumberBox(const char* id, double& value, const NumberStyle& style, float width, BoxKind kind = BoxKind::drag,
               const NumberLook* look = nullptr);

/// Draws a row of equally wide numbers, without a label. `names` are for the recorder. `first`: the index of the first
/// number among the components of its scope (TargetScope).
bool NumberRow(std::span<double> values, std::span<const char* const> names, const NumberStyle& style,
               std::span<const double> defaults, std::span<const Links> links, float width, int first = 0);

/// One of several choices in a bar that wraps if it is too long.
struct Segment {
    const char* name;
    const char* recorded_name;
    bool enabled = true;
    const char* why_disabled = "";
    const char* tip = "";
};
/// Returns the index of the clicked segment, otherwise −1. `selected` may be −1.
int SegmentBar(std::span<const Segment> segments, int selected);

}  // namespace widgets::inner
