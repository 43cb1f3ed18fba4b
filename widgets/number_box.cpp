// A number's box, for dragging, sliding and typing; the basis of Number, Slider and Numbers (number.cpp). A press
// starts a drag, a double-click or Ctrl-click turns the box into a text field, and a right-click resets the number.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>

#include "widgets/inner.h"

namespace widgets::inner {

namespace {

double Clamped(double value, const NumberStyle& style) {
    if (style.integer) value = std::round(value);
    return std::clamp(value, style.min, style.max);
}

/// Returns the style with its range limited to the drag range.
NumberStyle ForDrags(NumberStyle style) {
    if (style.drag_min != style.drag_max) {
        style.min = style.drag_min;
        style.max = style.drag_max;
    }
    return style;
}

double RoundedTo(double value, int decimals) {
    if (decimals > 15 || !std::isfinite(value)) return value;
    const double grid = std::pow(10.0, std::abs(decimals));
    return decimals >= 0 ? std::round(value * grid) / grid : std::round(value / grid) * grid;
}

int SignificantDecimals(double value, int digits) {
    if (value == 0.0) return digits;
    return digits - 1 - static_cast<int>(std::floor(std::log10(std::abs(value))));
}

// ---- typing ----------------------------------------------------------------------------------------

void StartTyping(Editing& editing, ImGuiID id, double value, const NumberStyle& style) {
    editing.typing = id;
    ++editing.typing_count;
    editing.typing_frame = ImGui::GetFrameCount();
    editing.type_now = 0;
    editing.focused = false;
    editing.frames_waited = 0;
    const bool has_text = style.unread && !style.unread->empty();
    const std::string text = has_text ? *style.unread : viewing::plain_number(value);
    std::snprintf(editing.text, sizeof editing.text, "%s", text.c_str());
    std::copy(std::begin(editing.text), std::end(editing.text), std::begin(editing.text_before));
}

int OnTab(ImGuiInputTextCallbackData* data) {
    static_cast<Editing*>(data->UserData)->tab = ImGui::GetIO().KeyShift ? -1 : 1;
    return 0;
}

/// Shows the box as a text field. Returns the new value in the frame in which typing ends, if the text is a new number.
std::optional<double> TypeInBox(const NumberStyle& style, ImVec2 size) {
    Context& context = CurrentContext();
    Editing& editing = context.editing;
    editing.typing_frame = ImGui::GetFrameCount();
    AskForRedraw(caret_blink_s);

    const FontScope font(context.fonts.number);
    const float padding_y = std::max(0.0F, (size.y - ImGui::GetFontSize()) * 0.5F);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(Px(5), padding_y));
    ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, Px(1.5F) * context.palette.stroke);
    ImGui::PushStyleColor(ImGuiCol_Border, context.palette.accent);
    ImGui::SetNextItemWidth(size.x);
    // A completion callback keeps ImGui from handling Tab itself.
    constexpr ImGuiInputTextFlags flags = ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll |
                                          ImGuiInputTextFlags_CallbackCompletion;
    ImGui::PushID(editing.typing_count);  // a new id, to discard the undo history of another text: see TextField
    const bool entered = ImGui::InputText("##typing", editing.text, sizeof editing.text, flags, OnTab, &editing);
    // Called after the item: Dear ImGui 1.90 loses a request to focus the next item if another window had the focus.
    if (!editing.focused) ImGui::SetKeyboardFocusHere(-1);
    const bool active = ImGui::IsItemActive();
    // From ImGui 1.89 on, only Tab calls the callback, not Shift+Tab.
    if (editing.focused && ImGui::GetIO().KeyShift && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Tab)))
        editing.tab = -1;
    ImGui::PopID();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(2);

    constexpr int patience_frames = 10;
    const bool lost = editing.focused ? !active : ++editing.frames_waited > patience_frames;
    if (active) editing.focused = true;
    if (!entered && !lost && editing.tab == 0 && !editing.ends) return std::nullopt;

    if (entered) editing.entered = editing.typing;
    editing.typing = 0;
    if (editing.tab < 0) editing.type_next = editing.last_number;
    // On Escape, ImGui has restored the original text. Unchanged text keeps the value, even if it is out of range.
    if (std::string_view(editing.text) == editing.text_before) return std::nullopt;
    std::optional<double> typed = ParseNumber(editing.text, style.unit);
    if (!typed && style.read) typed = style.read(editing.text);
    if (style.unread) *style.unread = typed ? "" : editing.text;
    return typed ? std::optional(Clamped(*typed, style)) : std::nullopt;
}

// ---- dragging --------------------------------------------------------------------------------------

double Dragged(double value, float pixels, double factor, const NumberStyle& style) {
    constexpr double log_step = 0.01;
    if (!style.logarithmic) return std::clamp(value + pixels * style.step * factor, style.min, style.max);
    return std::clamp(std::max(value, style.min) * std::pow(1.0 + log_step * factor, pixels), style.min, style.max);
}

/// Rounds to the decimals of the step, so that a drag yields round numbers.
double RoundedForDrag(double value, double factor, const NumberStyle& style) {
    const int fine = factor < 1.0 ? 2 : 0;
    if (style.logarithmic) return Clamped(RoundedTo(value, SignificantDecimals(value, 4 + fine)), style);
    const double step = std::abs(style.step) > 0.0 ? std::abs(style.step) : 1.0;
    return Clamped(RoundedTo(value, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)) + fine), style);
}

std::optional<double> DragInBox(double value, const NumberStyle& style) {
    Editing& editing = CurrentContext().editing;
    const ImGuiIO& io = ImGui::GetIO();
    if (ImGui::IsItemActivated()) {
        editing.drag_value = value;
        editing.drag_distance = 0.0F;
        return std::nullopt;
    }
    if (!ImGui::IsItemActive() || io.MouseDelta.x == 0.0F) return std::nullopt;
    const double factor = io.KeyShift ? 10.0 : io.KeyAlt ? 0.01 : 1.0;
    editing.drag_value = Dragged(editing.drag_value, io.MouseDelta.x / CurrentContext().scale, factor, style);
    editing.drag_distance += std::abs(io.MouseDelta.x);
    if (editing.drag_distance < Px(3)) return std::nullopt;
    return RoundedForDrag(editing.drag_value, factor, style);
}

// ---- sliding ---------------------------------------------------------------------------------------

double FractionOf(double value, const NumberStyle& style) {
    const double inside = std::isnan(value) ? style.min : std::clamp(value, style.min, style.max);
    if (style.logarithmic) return std::log(inside / style.min) / std::log(style.max / style.min);
    return (inside - style.min) / (style.max - style.min);
}

double AtFraction(double fraction, bool fine, const NumberStyle& style) {
    if (fraction <= 0.0) return style.min;
    if (fraction >= 1.0) return style.max;
    const int more = fine ? 2 : 0;
    if (style.logarithmic) {
        const double value = style.min * std::pow(style.max / style.min, fraction);
        return Clamped(RoundedTo(value, SignificantDecimals(value, 3 + more)), style);
    }
    return Clamped(RoundedTo(style.min + fraction * (style.max - style.min), style.decimals + more), style);
}

/// The knob's range, in screen x coordinates.
struct Track {
    float begin, end, knob_width;

    Track(float min_x, float max_x)
        : begin(min_x + Px(6)), end(std::max(max_x - Px(6), begin + 1.0F)), knob_width(Px(6)) {}
    float At(double fraction) const { return begin + static_cast<float>(fraction) * (end - begin); }
};

std::optional<double> SlideInBox(double value, const NumberStyle& style, const Track& track) {
    Editing& editing = CurrentContext().editing;
    const ImGuiIO& io = ImGui::GetIO();
    const double pixels_of_track = track.end - track.begin;
    if (ImGui::IsItemActivated()) {
        editing.value_before = value;
        editing.drag_value = FractionOf(value, style);
        const bool on_knob = std::abs(io.MousePos.x - track.At(editing.drag_value)) <= track.knob_width;
        editing.jumped_at_s = on_knob ? -1.0 : ImGui::GetTime();
        if (on_knob) return std::nullopt;
        editing.drag_value = std::clamp((io.MousePos.x - track.begin) / pixels_of_track, 0.0, 1.0);
        return AtFraction(editing.drag_value, false, style);
    }
    if (!ImGui::IsItemActive() || io.MouseDelta.x == 0.0F) return std::nullopt;
    editing.drag_value += io.MouseDelta.x / pixels_of_track * (io.KeyAlt ? 0.01 : 1.0);
    return AtFraction(std::clamp(editing.drag_value, 0.0, 1.0), io.KeyAlt, style);
}

// ---- the box ---------------------------------------------------------------------------------------

/// Returns the number of characters of this size that fit into the box.
int ColumnsOf(const NumberStyle& style, float width, const Face& face) {
    const float digit = face.font->GetCharAdvance('0') * face.size / face.font->FontSize;
    return std::max(1, static_cast<int>((width - Px(style.role == Role::none ? 6 : 9)) / digit + 0.01F));
}

Tiny TinyOf(const NumberStyle& style) {
    return style.shows_tiny ? Tiny::exact : style.logarithmic ? Tiny::exponent : Tiny::zero;
}

int WantedDecimals(const NumberStyle& style) {
    return style.integer ? 0 : style.decimals;
}

/// Returns the largest number of decimals with which the number fits, including its unit and, if it may be negative, a
/// sign. Returns nullopt if the number does not fit at all; it is then written as a power of ten.
std::optional<int> DecimalsInBox(double value, const NumberStyle& style, int columns) {
    const int wanted = WantedDecimals(style);
    const double widest = style.min < 0.0 ? -std::abs(value) : value;
    NumberChars unit;
    unit.append(style.unit);
    for (int decimals = wanted; decimals >= std::min(wanted, 1); --decimals) {
        if (viewing::number_chars(widest, decimals, TinyOf(style)).columns + unit.columns <= columns) return decimals;
    }
    return std::nullopt;
}

NumberChars TextInBox(double value, const NumberStyle& style, float width, const NumberLook& look) {
    return viewing::fitted_number(value, look.decimals, TinyOf(style), style.unit, ColumnsOf(style, width, look.face));
}

/// Draws the knob, a slim bar on its tinted track. The number is drawn over it.
void DrawKnob(ImDrawList* draw, float x, float half, ImVec2 min, ImVec2 max, ImU32 track, ImU32 color) {
    const float inset = Px(1), rounding = ImGui::GetStyle().FrameRounding;
    draw->AddRectFilled(min, ImVec2(x, max.y), Shown(WithAlpha(track, 0.22F)), rounding, ImDrawFlags_RoundCornersLeft);
    draw->AddRectFilled(ImVec2(x - half, min.y + inset), ImVec2(x + half, max.y - inset), Shown(color), half);
}

void DrawBox(double value, const NumberStyle& style, ImVec2 min, ImVec2 max, BoxKind kind, bool lit,
             const NumberLook& look) {
    const Palette& palette = CurrentContext().palette;
    const Face& face = look.face;
    ImDrawList* draw = ImGui::GetWindowDrawList();
    const bool slides = kind == BoxKind::slider, active = ImGui::IsItemActive();
    const Role stripe = slides ? Role::none : style.role;
    DrawField(draw, min, max, ImGui::IsItemHovered(), active && !slides, lit, stripe);

    const NumberChars text = TextInBox(value, style, max.x - min.x, look);
    const float text_width = face.Measure(text.view()).x;
    const float middle = (min.x + max.x) * 0.5F + (stripe == Role::none ? 0.0F : Px(1));
    const ImVec2 at(std::floor(middle - text_width * 0.5F), std::floor((min.y + max.y - face.size) * 0.5F));
    if (slides) {
        const Track track(min.x, max.x);
        const float x = track.At(FractionOf(value, style)), half = Px(active ? 2.5F : 1.5F);
        // Dim the knob behind the digits, so that both are readable.
        const bool behind_text = std::abs(x - middle) < text_width * 0.5F + half;
        const ImU32 color = style.role == Role::none ? palette.accent : palette.of(style.role);
        DrawKnob(draw, x, half, min, max, color, behind_text ? Mix(palette.field, color, 0.6F) : color);
    }
    face.Draw(draw, at, Shown(palette.text), text.view());
}

/// Draws the box with typed text that is not a number.
void DrawUnread(const std::string& text, ImVec2 min, ImVec2 max) {
    const Palette& palette = CurrentContext().palette;
    ImDrawList* draw = ImGui::GetWindowDrawList();
    DrawField(draw, min, max, ImGui::IsItemHovered(), false, false, Role::none);
    draw->AddRect(min, max, Shown(palette.trouble), ImGui::GetStyle().FrameRounding, 0, Px(1.5F) * palette.stroke);
    const FontScope font(CurrentContext().fonts.number);
    const std::string shown = Shortened(text, max.x - min.x - Px(8));
    const float y = std::floor((min.y + max.y - ImGui::GetFontSize()) * 0.5F);
    draw->AddText({min.x + Px(4), y}, Shown(palette.trouble), shown.c_str());
}

/// Implements Tab while the user types in a number: it moves to the next number drawn, Shift+Tab to the previous one.
void FollowTab(Editing& editing, ImGuiID id) {
    if (IsDisabled()) return;
    if (editing.tab > 0 && editing.typing == 0) {
        editing.type_next = id;
        editing.tab = 0;
    }
    editing.last_number = id;
}

std::optional<double> PointAtBox(ImGuiID id, double value, const NumberStyle& style, const Track& track, BoxKind kind) {
    Editing& editing = CurrentContext().editing;
    if (ImGui::IsItemHovered()) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
        if (ImGui::IsMouseClicked(ImGuiMouseButton_Right)) return style.default_value;
        const bool doubled = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
        if (doubled || (ImGui::IsMouseClicked(ImGuiMouseButton_Left) && ImGui::GetIO().KeyCtrl)) {
            // The first click of a double-click may have moved the knob.
            const bool moved = doubled && kind == BoxKind::slider;
            const double typed_from = moved ? editing.value_before : value;
            StartTyping(editing, id, typed_from, style);
            editing.jumped_at_s = -1.0;
            return moved ? std::optional(typed_from) : std::nullopt;
        }
    }
    return kind == BoxKind::slider ? SlideInBox(value, style, track) : DragInBox(value, style);
}

}  // namespace

NumberLook LookOf(std::span<const double> values, const NumberStyle& style, float width) {
    const Fonts& fonts = CurrentContext().fonts;
    const Face small = FaceOf(fonts.small_number);
    constexpr float least_size = 10.5F;  // design pixels; smaller digits are unreadable
    const Face sizes[] = {FaceOf(fonts.number), small, {small.font, std::min(small.size, Px(least_size))}};
    const Face& smallest = sizes[std::size(sizes) - 1];
    const int wanted = WantedDecimals(style), most_columns = ColumnsOf(style, width, smallest);
    // Prefer fewer decimals to a smaller font, as long as the displayed value stays the same.
    const auto is_told = [wanted](double value, int decimals) {
        return std::abs(RoundedTo(value, decimals) - RoundedTo(value, wanted)) < 1e-9 * std::max(1.0, std::abs(value));
    };
    for (const Face& face : sizes) {
        const int columns = ColumnsOf(style, width, face);
        for (int decimals = wanted; decimals >= std::max(wanted - 1, 0); --decimals) {
            const bool all_fit = std::all_of(values.begin(), values.end(), [&](double value) {
                const bool never_fits = !DecimalsInBox(value, style, most_columns);
                return never_fits ||
                       (DecimalsInBox(value, style, columns).value_or(-1) >= decimals && is_told(value, decimals));
            });
            if (all_fit) return {face, decimals};
        }
    }
    int decimals = wanted;
    for (const double value : values)
        decimals = std::min(decimals, DecimalsInBox(value, style, most_columns).value_or(wanted));
    return {smallest, decimals};
}

bool NumberBox(const char* id_text, double& value, const NumberStyle& style, float width, BoxKind kind,
               const NumberLook* shared_look) {
    Context& context = CurrentContext();
    Editing& editing = context.editing;
    ImGui::PushID(id_text);
    const ImGuiID id = ImGui::GetID("##box");
    const ImVec2 size(std::max(width, 1.0F), ImGui::GetFrameHeight());
    const ImVec2 min = ImGui::GetCursorScreenPos();
    const ImVec2 max(min.x + size.x, min.y + size.y);
    if (editing.type_now == id) StartTyping(editing, id, value, style);
    if (editing.typing == id && IsDisabled()) editing.typing = 0;

    const NumberLook look = shared_look ? *shared_look : LookOf({&value, 1}, style, size.x);
    const NumberStyle drags = ForDrags(style);
    std::optional<double> edited;
    if (editing.typing == id) {
        edited = TypeInBox(style, size);
        FollowLinks(style.links);
        if (editing.tab <= 0) editing.last_number = id;
    } else {
        FollowTab(editing, id);
        ImGui::InvisibleButton("##box", size);
        const bool lit = FollowLinks(style.links);
        edited = PointAtBox(id, value, drags, Track(min.x, max.x), kind);
        const bool has_text = style.unread && !style.unread->empty() && !edited;
        if (has_text)
            DrawUnread(*style.unread, min, max);
        else if (ImGui::IsItemVisible())
            DrawBox(edited.value_or(value), drags, min, max, kind, lit, look);
    }
    ImGui::PopID();

    const bool changed = edited && !(*edited == value);
    if (changed) value = *edited;
    if (edited && style.unread) style.unread->clear();
    const bool has_text = style.unread && !style.unread->empty();
    if (context.record)
        RecordSwitch(id_text, min, max,
                     has_text ? std::string_view(*style.unread) : TextInBox(value, drags, size.x, look).view());
    return changed;
}

}  // namespace widgets::inner
