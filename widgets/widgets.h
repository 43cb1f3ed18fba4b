// A small library that extends Dear ImGui for a lecture on viewing: numbers with units, planes, lights, matrices with
// symbolic entries, and lamps. It depends on imgui.h, GLM, and text/, and on nothing else in the sandbox. Every widget
// edits the value it is given and returns whether it did. Run `widgets-demo` to see each one.
//
// Conventions, as in Dear ImGui: `bool Name(label, value&, tuning…)`; true only in a frame in which the value changed;
// "##id" parts of a label are hidden. Labels are to the right of a control, in the quiet color, or above it if they do
// not fit. Every text passed to a widget is looked up in the catalog (text/catalogue.h) when drawn; ids and recorder
// texts stay English.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "text/numbers.h"
#include "widgets/targets.h"

namespace widgets {

// ---- look ------------------------------------------------------------------------------------------

/// The meaning of a color. A thing has the same color wherever it appears.
enum class Role { none, light, plane, camera, mirror, point, trouble };

/// A theme's palette; colors as ImGui packs them (IM_COL32).
struct Palette {
    ImU32 ground, raised, field, field_hovered, field_active, border, text, quiet, accent, view_ground;
    ImU32 light, plane, camera, mirror, point, trouble;  ///< chosen for enough contrast with this background
    float stroke = 1.0F;                                 ///< line width multiplier; larger than 1 on the projector
    float type_scale = 1.0F;                             ///< 1.3 on the projector

    ImU32 of(Role role) const;
};

enum class ThemeKind { dark, light, projector };
const Palette& palette_of(ThemeKind theme);

/// Fonts already in the atlas. Any of them may be null; widgets then use ImGui's current font.
struct Fonts {
    ImFont* text = nullptr;          ///< proportional 14
    ImFont* heading = nullptr;       ///< semibold 14
    ImFont* note = nullptr;          ///< proportional 11
    ImFont* number = nullptr;        ///< monospaced 14
    ImFont* matrix = nullptr;        ///< monospaced 14, larger for an audience
    ImFont* small_number = nullptr;  ///< monospaced 11
    ImFont* caption = nullptr;       ///< proportional 17: sentences readable from the back row
};

/// Area of a drawn widget that has a label, for tests that click by name.
struct RecordedItem {
    std::string window;
    std::string label;  ///< the full path of labels: "camera/position/x"
    ImVec2 min, max;
    bool enabled = true;
    std::string text;        ///< the text that it shows: a number, the chosen name, "on" or "off"; may be empty
    bool is_switch = false;  ///< a control to set, or a button
};

/// A set of named quantities, one bit each: the parameters that an entry depends on.
using Links = std::uint64_t;

/// Memory of the widgets between frames: the edit in progress, of which there is at most one, and the pending tooltip.
struct Editing {
    ImGuiID typing = 0;       ///< the number being typed
    int typing_count = 0;     ///< counts the numbers typed so far: see TextField
    ImGuiID type_now = 0;     ///< the number where typing starts in this frame
    ImGuiID type_next = 0;    ///< the number where it starts in the next frame (Tab, Shift+Tab)
    ImGuiID last_number = 0;  ///< the number drawn most recently; Shift+Tab moves to it
    int tab = 0;              ///< typing moves to another number; +1: the next one drawn, −1: the previous one
    ImGuiID entered = 0;      ///< the number in which Enter has ended typing in this frame
    bool focused = false;     ///< the text field has keyboard focus
    int typing_frame = 0;     ///< the frame in which the text field was last drawn
    int frames_waited = 0;    ///< frames that it has waited for keyboard focus
    char text[64] = {};
    char text_before[64] = {};
    bool ends = false, ends_next = false;  ///< see EndTyping

    double drag_value = 0.0;     ///< position of a drag, before rounding
    float drag_distance = 0.0F;  ///< pixels since the press
    double value_before = 0.0;   ///< the value before a slider's knob jumped to the pointer
    double jumped_at_s = -1.0;   ///< time of that jump, by ImGui's clock; negative: none
    glm::vec3 color{0.0F};       ///< color of the open picker, finer than 8 bits

    ImVec4 tooltip_of{-1.0F, -1.0F, -1.0F, -1.0F};  ///< rectangle of the item under the resting pointer
    int tooltip_frame = 0;
    float tooltip_time_s = 0.0F;
    float tooltip_rest_s = 0.0F;  ///< time since the pointer last moved over the item
    bool tooltip_muted = false;   ///< the item was clicked: no tooltip until the pointer leaves it
    ImVec2 tooltip_size;          ///< of the shown tooltip
    int tooltip_frames_due = 0;   ///< frames since the tooltip became due
    float redraw_in_s = -1.0F;
};

/// The use of a text field so far: the number of times it was left, and the frame in which it was last active.
struct TextFieldUse {
    int times = 0, active_frame = 0;
    bool is_used = false;
    std::optional<std::string> entry;  ///< typed text of an EntryField, not yet committed
};

/// A heading of a panel, and its position in the window's content.
struct SectionPlace {
    std::string label, shown;  ///< its name, and its text in the current language
    float top_px = 0.0F;
};

/// Everything the widgets of a program share. Owned by the caller; there is no other hidden state.
struct Context {
    Palette palette = palette_of(ThemeKind::dark);
    Fonts fonts;
    float scale = 1.0F;          ///< pixels per design pixel; multiplies every constant size
    Links hovered = 0;           ///< quantities under the pointer in the last frame, highlighted now
    Links hovered_next = 0;      ///< collected in this frame
    bool entry_hovered = false;  ///< `hovered` comes from a matrix entry: do not highlight other entries
    bool entry_hovered_next = false;
    bool record = false;                  ///< set by tests
    std::vector<RecordedItem> recorded;   ///< in this frame
    std::vector<std::string> label_path;  ///< see Group
    Editing editing;
    std::unordered_map<ImGuiID, TextFieldUse> text_fields;
    Targets targets;
    bool is_on_stage = false;            ///< in front of an audience: a tooltip disappears if the pointer keeps resting
    float matrix_growth = 1.0F;          ///< at least 1: scales the height of the matrices drawn next; their type grows
                                         ///< along, by 1.4 at most and as far as their width allows
    bool printed = false;                ///< for a printed figure, where nothing should look pressable
    std::vector<SectionPlace> sections;  ///< of the panel, in this frame
    std::string section_asked;           ///< a section to open and scroll to
    std::string offered;                 ///< advice that an empty view shows in this frame
    /// Over all scrolling windows in this frame: the smallest visible fraction of a window's content, the largest used
    /// fraction of a window's height, and the number of windows.
    float seen_share = 1.0F, used_share = 0.0F;
    int scrolled_count = 0;
};

/// Makes a context current for all widgets and moves hovered_next to hovered. Call before each frame's first widget.
void NewFrame(Context& context);
Context& CurrentContext();

/// Call after a frame's last widget. Returns the seconds until another frame is needed even without input (a tooltip is
/// due, highlights must follow the pointer, the caret blinks). 0: immediately; negative: never.
float RedrawIn(const Context& context);

/// Requests another frame in `in_s` seconds even without input. The soonest request wins.
void AskForRedraw(float in_s);

/// Call after a button that repeats while held (ImGui::PushButtonRepeat), since a mouse at rest triggers no frames.
void GoOnWhileHeld();

/// Returns whether a click has just moved a slider's knob, so that a second click would undo the move and start typing.
/// While this is true, the edit is not final.
bool MayBeTakenBack(const Context& context);

/// Commits typed text at the start of the next frame, as if its field had lost focus. Call before acting on a key that
/// leads elsewhere or on a dropped file, and when the window loses focus or closes. A number box then closes; a text
/// field stays active.
void EndTyping(Context& context);
/// Returns whether any typed text is not committed yet.
bool IsTyping(const Context& context);

/// Sets the colors and metrics of ImGui itself from the palette. Call when the theme or the scale changes.
void ApplyStyle(const Context& context);

/// Prefixes the recorder names of the widgets inside ("camera/…") and pushes an ImGui id.
struct Group {
    explicit Group(const char* name);
    ~Group();
    Group(const Group&) = delete;
    Group& operator=(const Group&) = delete;
};

/// Records the last ImGui item under `label` with the text that it shows, for items that this library does not draw.
void Record(const char* label, std::string_view text = {});

/// Counts the current window, a scrolling child or table, in Context::seen_share and used_share, and marks its lower
/// edge if its content continues below. Call before the window ends.
/// `is_filled`: another counted window fills this one, whose used height is ignored. `fade`: height of the mark, in
/// design pixels.
void CountScrolled(bool is_filled = false, float fade = 34.0F);

/// Returns a label for ImGui itself: the text in the current language, with an id that is English in every language.
std::string LabelText(const char* label);
/// Returns the label of LabelText, wrapped to the width available at the cursor. ImGui itself needs `taken` pixels of
/// that width.
std::string BrokenLabelText(const char* label, float taken);

// ---- text ------------------------------------------------------------------------------------------

/// Parses a typed number: "1e-3", "−2" with either minus sign, a decimal comma, surrounding spaces, a trailing unit, or
/// the output of number_text. Returns nullopt unless the text is exactly one finite number.
std::optional<double> ParseNumber(std::string_view text, std::string_view unit = {});

/// Wraps text only at spaces, so that lines are at most `width` pixels wide in the current font if possible. ImGui
/// would also break within "0.5".
std::string BrokenAtBlanks(std::string_view text, float width);
/// Wraps text in the same way, but in the given font at its own size; also works outside a frame.
std::string BrokenAtBlanks(std::string_view text, float width, const ImFont& font);
/// Returns as much of the beginning of the text as fits into `width` pixels in the current font, with "…" if anything
/// was cut.
std::string Shortened(std::string text, float width);
void Note(const char* text);  ///< small, quiet, wraps
/// The topic of a sentence. Each tone has its own icon and color: a red triangle with an exclamation mark if the
/// picture is wrong, a letter i in a circle for something worth knowing, and a frame for something about the window.
enum class Tone { wrong, note, window };
ImU32 ColorOf(Tone tone);
void DrawSign(ImDrawList* draw, ImVec2 min, float size, Tone tone);  ///< 0.95 × `size` wide
void Trouble(const char* sentence);                        ///< one sentence in the trouble color with an icon, wraps
float TroubleHeight(const char* sentence, float width);    ///< height of a Trouble of this width in the current font
void ValueText(const char* text, Role role = Role::none);  ///< monospaced

/// The role of a letter in a symbol: "l" → light.
struct LetterRole {
    char32_t letter;
    Role role;
};

/// Draws a formula such as "-l_x n_y", "n·l - l_x n_x", "1 - 2a^2": `_x` becomes a subscript and `^2` a superscript (of
/// one character or `{…}`), "-" becomes a real minus, "*" a dot, a lone "l" ℓ, and a space between two one-letter
/// factors a thin space. Letters have the color of their role, subscripts and superscripts that of their letter,
/// everything else `base`. Three or more letters in a row are a word without roles. Returns the size. Draws nothing if
/// `draw` is null.
ImVec2 Formula(ImDrawList* draw, ImVec2 position, const char* formula, std::span<const LetterRole> roles, ImU32 base,
               ImFont* font = nullptr);

/// Draws a delayed tooltip for the last item: beside the item's column or, if it does not fit there, below or above the
/// item. A click or typing hides it. A semibold `title` is followed by lines; empty ones are skipped, and if all are
/// empty, there is no tooltip. `formula` may hold several formulas, separated by "; ". `path`, the name for scripts, is
/// at the bottom, small and quiet. Works on disabled items. Inside a group, the item's own tooltip takes precedence
/// over the group's.
void Tooltip(const char* title, const char* body, const char* formula = "", const char* gl_call = "",
             std::span<const LetterRole> roles = {}, const char* path = "");

// ---- values ----------------------------------------------------------------------------------------

/// Reads a number from text in a special format; none if the text is not a number.
using NumberReader = std::optional<double> (*)(std::string_view text);

/// Settings for editing a number.
struct NumberStyle {
    double min = -1e12, max = 1e12;         ///< for typing
    double drag_min = 0.0, drag_max = 0.0;  ///< for dragging and sliding; both 0: min … max
    double step = 0.01;                     ///< change per design pixel of a drag (Shift ×10, Alt ÷100)
    int decimals = 2;
    const char* unit = "";       ///< after the number: "°"
    bool logarithmic = false;    ///< a drag multiplies, by 1 % per pixel; a slider is spaced by decades. Needs min > 0
    bool integer = false;        ///< whole numbers only
    bool shows_tiny = false;     ///< writes 4·10⁻⁵ instead of 0.00; a logarithmic number always does
    double default_value = 0.0;  ///< right-click resets to it
    Links links = 0;             ///< highlighted together with matrix entries that depend on them
    Role role = Role::none;
    NumberReader read = nullptr;    ///< reads typed text that ParseNumber does not
    std::string* unread = nullptr;  ///< typed text that is not a number, for the box to show; in a row, an array
};

/// Draws a number that can be dragged; a double-click or Ctrl-click starts typing, and a right-click resets it. `width`
/// 0: the item width. A number that does not fit loses a final zero; if that is not enough, it is written smaller, and
/// then with fewer decimals. Reserves space for a sign, so that the decimals stay in place when it appears.
bool Number(const char* label, double& value, const NumberStyle& style, float width = 0.0F);

/// Returns whether Enter has just ended typing in the last number drawn.
bool IsLastEntered();

/// Draws a number as a slider, with a knob between min and max.
bool Slider(const char* label, double& value, const NumberStyle& style, float width = 0.0F);

/// Draws several numbers in one row, all with the same size and number of decimals, and one label after them.
/// `links[i]` belongs to component i, if given.
bool Numbers(const char* label, std::span<double> values, const NumberStyle& style,
             std::span<const double> defaults = {}, std::span<const Links> links = {});
bool Vec3(const char* label, glm::dvec3& value, const NumberStyle& style, const glm::dvec3& default_value = {},
          std::span<const Links> links = {});

/// Returns the width in pixels of a control together with its label.
float LabelledWidth(const char* label, float control_width);

bool Toggle(const char* label, bool& value, bool default_value);  ///< checkbox; right-click resets
float ToggleWidth(const char* label);                             ///< width of a Toggle on one line, in pixels
/// Draws a combo box of names; a right-click resets to `default_index`. `width` 0: as wide as the longest name.
bool Choice(const char* label, int& index, std::span<const char* const> names, int default_index, float width = 0.0F);
float ChoiceWidth(std::span<const char* const> names);  ///< width that shows the longest name in full, in pixels
/// Like Choice, but draws a row of radio buttons. `tips` explain the buttons on hover.
bool Segments(const char* label, int& index, std::span<const char* const> names, int default_index,
              std::span<const char* const> tips = {});

/// Draws a list that looks like a Choice, for items that are not an enumeration. If it returns true, draw the items,
/// then call EndChoice. The label is hidden. `width` in pixels, 0: the item width. If the preview is too long, it is
/// written smaller, in two lines if necessary; if that is not enough, it is shortened.
bool BeginChoice(const char* label, const char* preview, float width = 0.0F);
void EndChoice();

/// Draws only the closed list of a Choice. Returns whether it was clicked; the caller opens its own list.
bool ClosedList(const char* label, const char* preview, float width);

/// Closes the current popup on Escape; call right after its Begin. Returns whether it did. A number being typed and an
/// open list inside the popup take precedence. Choices and color pickers already do this themselves.
bool ClosePopupOnEscape();

bool ColorField(const char* label, glm::u8vec3& rgb, const glm::u8vec3& default_value);
bool Button(const char* label, bool enabled = true, const char* why_disabled = "");

/// Draws ImGui's text field, with the width set for the next item. Use it for text that other code may also change.
/// Returns ImGui's result. `hint` shows in an empty field. `to_end`: if true, as soon as the field is active, the caret
/// moves to the end of the text, nothing is selected, and the flag becomes false.
bool TextField(const char* label, std::string& text, const char* hint = "", ImGuiInputTextFlags flags = 0,
               bool* to_end = nullptr);
/// Draws a field for text that counts only when complete: `value` changes only in the frame in which the user leaves
/// the field with a different text (by Enter, Tab, a click elsewhere or EndTyping). Escape restores the old text.
bool EntryField(const char* label, std::string& value);
/// Draws an EntryField for a paragraph, as wide as the available space and as high as the wrapped text. Enter ends
/// typing.
bool ParagraphField(const char* label, std::string& value);
bool SmallButton(const char* label, bool enabled = true, const char* why_disabled = "");
float SmallButtonWidth(const char* label);  ///< width on one line, in pixels
bool OffersButton(const char* label);       ///< whether a Button or SmallButton with this label is drawn at all

/// Draws a header that folds the content below it; ImGui keeps the state. Returns whether it is open. `note`: quiet
/// text at its right end. `trouble`: a problem inside, shown by its tone's icon with a tooltip, so that nothing below
/// moves when it appears.
bool Section(const char* label, bool open_by_default = true, const char* note = "", const char* trouble = "",
             Tone tone = Tone::wrong);

// ---- the lecture's objects -------------------------------------------------------------------------

/// Edits a plane a x + b y + c z + d = 0 with four numbers, the buttons yz, xz and xy, and Normalize.
/// Rejects edits that would make the normal zero. `links`: one per component. `d_of_buttons`: the d that yz, xz and xy
/// set; pressed again, they set d = 0.
bool PlaneEquation(const char* label, glm::dvec4& plane, const glm::dvec4& default_value,
                   std::span<const Links> links = {}, const glm::dvec3& d_of_buttons = glm::dvec3(0.0));

/// Edits a point light (w = 1) or parallel light (w = 0) with two radio buttons, three numbers and w. The four
/// components are never all zero.
bool Light(const char* label, glm::dvec4& light, const glm::dvec4& default_value, std::span<const Links> links = {});

/// One cell of a displayed matrix.
struct MatrixCell {
    const char* symbol = "";  ///< a Formula, drawn under the number
    Links links = 0;          ///< the parameters it depends on
    bool changed = false;     ///< changed by the last edit; tinted
    Links own = 0;            ///< the entry itself, highlighted together with other references to it: see FollowEntry
};

/// Settings for drawing a matrix. Its rows are as on the slides: cells[4 * row + column] belongs to value[column][row],
/// since GLM indexes columns first.
struct MatrixStyle {
    int decimals = 3;
    std::span<const MatrixCell> cells = {};  ///< 16, or empty
    std::span<const LetterRole> roles = {};
    bool editable = false;                 ///< makes each entry a Number
    bool overridden = false;               ///< entered by hand: brackets in the trouble color
    const glm::dmat4* defaults = nullptr;  ///< a right-click resets an entry to its value here; null: the identity
    const char* target = nullptr;          ///< its name as in targets.h, "matrix:V"; null: none
    int* hovered_cell = nullptr;           ///< receives 4 * row + column under the pointer, or −1
    NumberReader read = nullptr;           ///< see NumberStyle
    std::string* unread = nullptr;         ///< see NumberStyle: 16, row by row
};

/// Draws a 4×4 matrix in square brackets, with aligned columns, quiet zeros, and symbols under the numbers. Only zeros
/// and rounding residues are shown as zero. Hovering over a cell highlights its linked controls; hovering over a linked
/// control highlights the cell. Returns true when an entry was edited. `width` 0: the available width.
bool Matrix(const char* label, glm::dmat4& value, const MatrixStyle& style, float width = 0.0F);
/// Draws a matrix in the same way, but does not edit it.
void Matrix(const char* label, const glm::dmat4& value, const MatrixStyle& style, float width = 0.0F);
/// Returns the height of a matrix that is not being edited.
float MatrixHeight(bool has_symbols);

/// Makes the last item, such as the line of code that fills a matrix entry, represent that entry: hovering over the
/// item or the entry highlights both, and the entry's parameters. Returns whether to highlight the item.
bool FollowEntry(Links own, Links links);

/// The lamp of one degree of freedom: whether the current mode has it, and whether it is moving now.
struct Lamp {
    const char* label;
    bool available;
    bool active;
    const char* keys = "";  ///< after the label: "W S"
    bool asked = false;     ///< its key is pressed; a lamp that is not available then lights up as trouble
};
/// Draws lamps in one row if they fit, otherwise in several rows of equal length.
void Lamps(const char* label, std::span<const Lamp> lamps, Role role);

/// Draws a splitter, `length` pixels long, between two areas. Dragging moves `position`, in design pixels; `direction`
/// −1 moves it against the pointer, for an area at the right or bottom. `vertical`: the areas are side by side.
bool Splitter(const char* id, bool vertical, float& position, float min, float max, float length,
              float direction = 1.0F);

// ---- drawing in a view -----------------------------------------------------------------------------

/// Draws text on a plate in the views' background color, with which all role colors contrast.
void PlateText(ImDrawList* draw, ImVec2 position, ImU32 color, const char* text, ImFont* font = nullptr);

/// Places labels beside their points so that none covers another or leaves the view: it tries eight directions around
/// each point, near positions first, and takes the first free one. Omits labels that do not fit. With roles, the text
/// is a Formula. Labels are on plates, as with PlateText.
class LabelPlacer {
public:
    LabelPlacer(ImDrawList* draw, ImVec2 min, ImVec2 max) : draw_(draw), min_(min), max_(max) {}
    void Avoid(ImVec2 min, ImVec2 max);      ///< keeps labels off this rectangle
    void AvoidLine(ImVec2 from, ImVec2 to);  ///< keeps labels off this line, if there is a free place beside it
    /// Returns whether the label fit. It is never placed nearer to one of the rivals than to its own point.
    bool Place(ImVec2 point, const char* text, ImU32 color, std::span<const LetterRole> roles = {},
               std::span<const ImVec2> rivals = {});

private:
    struct Box {
        ImVec2 min, max;
    };
    struct Line {
        ImVec2 from, to;
    };
    bool IsFree(const Box& box) const;
    bool IsCrossed(const Box& box) const;
    std::optional<Box> Find(ImVec2 point, ImVec2 size, std::span<const ImVec2> rivals) const;

    ImDrawList* draw_;
    ImVec2 min_, max_;
    std::vector<Box> taken_;
    std::vector<Line> lines_;
};

}  // namespace widgets
