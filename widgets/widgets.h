// A small library that extends Dear ImGui with what a lecture on viewing needs: numbers with units, planes,
// lights, matrices with symbolic entries, lamps. It knows imgui.h and GLM, nothing of the sandbox.
// Every widget edits the value it is given and says whether it did. Run `widgets-demo` to see each one.
//
// Conventions, as in Dear ImGui: `bool Name(label, value&, tuning…)`; true only in a frame in which the value changed;
// "##id" parts of a label are not shown. Labels stand to the right of a control, quiet; above it where there is no room
// for them. Every text that a widget is given is looked up in the catalogue (text/catalogue.h) where it is drawn; ids
// and what the recorder tells stay English.
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

/// What a colour means; the same wherever the thing appears.
enum class Role { none, light, plane, camera, mirror, point, trouble };

/// The palette of a theme; colours as ImGui packs them (IM_COL32).
struct Palette {
    ImU32 ground, raised, field, field_hovered, field_active, border, text, quiet, accent, view_ground;
    ImU32 light, plane, camera, mirror, point, trouble;  ///< chosen with enough contrast on this ground
    float stroke = 1.0F;      ///< line weight multiplier: 1 on dark, heavier on the projector
    float type_scale = 1.0F;  ///< 1.3 on the projector

    ImU32 of(Role role) const;
};

enum class ThemeKind { dark, light, projector };
const Palette& palette_of(ThemeKind theme);

/// Fonts already in the atlas; any may be null (then ImGui's current font is used).
struct Fonts {
    ImFont* text = nullptr;          ///< proportional 14
    ImFont* heading = nullptr;       ///< semibold 14
    ImFont* note = nullptr;          ///< proportional 11
    ImFont* number = nullptr;        ///< monospaced 14
    ImFont* small_number = nullptr;  ///< monospaced 11
    ImFont* caption = nullptr;       ///< proportional 17: sentences to be read from the back row
};

/// Where a widget with a label was drawn, for tests that click by name.
struct RecordedItem {
    std::string window;
    std::string label;  ///< the full path of labels: "camera/position/x"
    ImVec2 min, max;
    bool enabled = true;
    std::string text;        ///< what it shows: a number, the chosen name, "on" or "off"; else empty
    bool is_switch = false;  ///< a control to be set, or a button
};

/// A set of named quantities, one bit each: which parameters an entry depends on.
using Links = std::uint64_t;

/// The one edit that can be going on, and the tooltip that is about to show: the widgets' memory between frames.
struct Editing {
    ImGuiID typing = 0;       ///< the number that is being typed
    int typing_count = 0;     ///< how often a number was typed: see TextField
    ImGuiID type_now = 0;     ///< the number that starts to be typed in this frame, and
    ImGuiID type_next = 0;    ///< in the next one (Tab, Shift+Tab)
    ImGuiID last_number = 0;  ///< the one drawn before, where Shift+Tab leads
    int tab = 0;              ///< +1: the next number drawn takes over, −1: the one before
    bool focused = false;     ///< the text field has taken the keyboard
    int typing_frame = 0;     ///< the frame in which it was last drawn, and
    int frames_waited = 0;    ///< how many it has waited for the keyboard
    char text[64] = {};
    char text_before[64] = {};
    bool ends = false, ends_next = false;  ///< see EndTyping

    double drag_value = 0.0;     ///< where a drag has led, before rounding
    float drag_distance = 0.0F;  ///< pixels since the press
    double value_before = 0.0;   ///< before a slider's knob jumped to the pointer,
    double jumped_at_s = -1.0;   ///< which it did then, by ImGui's clock; negative: it did not
    glm::vec3 color{0.0F};       ///< what the open colour picker shows, finer than 8 bits

    ImVec4 tooltip_of{-1.0F, -1.0F, -1.0F, -1.0F};  ///< rectangle of the item that the pointer rests on
    int tooltip_frame = 0;
    float tooltip_time_s = 0.0F;
    bool tooltip_muted = false;  ///< the item was clicked: until the pointer has left it
    ImVec2 tooltip_size;         ///< of the one shown
    int tooltip_frames_due = 0;  ///< frames since it may show
    float redraw_in_s = -1.0F;
};

/// How often a field for text was left, and when it was active last.
struct TextFieldUse {
    int times = 0, active_frame = 0;
    bool is_used = false;
    std::optional<std::string> entry;  ///< of an EntryField: what is typed and does not count yet
};

/// Everything the widgets share in one program. Owned by the caller; there is no hidden state beside it.
struct Context {
    Palette palette = palette_of(ThemeKind::dark);
    Fonts fonts;
    float scale = 1.0F;          ///< pixels per design pixel: every constant size is multiplied by it
    Links hovered = 0;           ///< what the pointer was over in the last frame: these are highlighted
    Links hovered_next = 0;      ///< collected in this frame
    bool entry_hovered = false;  ///< `hovered` comes from a matrix entry: other entries stay as they are
    bool entry_hovered_next = false;
    bool record = false;                  ///< tests switch this on
    std::vector<RecordedItem> recorded;   ///< of this frame
    std::vector<std::string> label_path;  ///< see Group
    Editing editing;
    std::unordered_map<ImGuiID, TextFieldUse> text_fields;
    Targets targets;
    bool printed = false;  ///< a figure: nothing in it can be pressed, so nothing looks as if it could
    std::string offered;   ///< in this frame, in the place of a view that has nothing to show
    /// Of the windows that scroll, in this frame: the share of its content that the one shows that shows the least of
    /// it, and the share of its height that the one takes that takes the most; their number.
    float seen_share = 1.0F, used_share = 0.0F;
    int scrolled_count = 0;
};

/// Makes a context current for all widgets; call once a frame before the first. Moves hovered_next to hovered.
void NewFrame(Context& context);
Context& CurrentContext();

/// Ask after the last widget of a frame: in how many seconds another frame is wanted though no input comes (a tooltip
/// is due, highlights have to follow the pointer, the caret blinks); 0 at once, negative never.
float RedrawIn(const Context& context);

/// Another frame is wanted in so many seconds though no input comes: of several wishes the soonest.
void AskForRedraw(float in_s);

/// After a button that acts on and on while it is held (ImGui::PushButtonRepeat): a hand that rests makes no frames.
void GoOnWhileHeld();

/// Whether a click has just moved a slider's knob that a second one would put back, to begin to type: what it did is
/// not done yet.
bool MayBeTakenBack(const Context& context);

/// From the next frame's beginning what is typed counts, as if its field were left: before a key, a file or another
/// window takes the field away. A number's box is left by it, a text's goes on.
void EndTyping(Context& context);
/// Whether something is typed that does not count yet.
bool IsTyping(const Context& context);

/// Colours and metrics of ImGui itself, set from the palette (call when theme or scale changes).
void ApplyStyle(const Context& context);

/// Names the widgets inside for the recorder ("camera/…") and pushes an ImGui id.
struct Group {
    explicit Group(const char* name);
    ~Group();
    Group(const Group&) = delete;
    Group& operator=(const Group&) = delete;
};

/// Records the last ImGui item under `label` (for items that are not made by this library).
void Record(const char* label);

/// Counts the current window, a child or a table that scrolls into Context::seen_share and used_share; call before it
/// ends. `is_filled`: by another one that is counted itself, so that its own height says nothing.
void CountScrolled(bool is_filled = false);

/// A label for ImGui itself: what is shown in the language spoken now, under an id that is English in all of them.
std::string LabelText(const char* label);
/// The same in as many lines as it takes in the room from the cursor on, of which ImGui itself needs `taken` pixels.
std::string BrokenLabelText(const char* label, float taken);

// ---- text ------------------------------------------------------------------------------------------

/// What a person may type for a number: "1e-3", "−2" with either minus, a decimal comma, blanks around it, the unit
/// behind it, or what number_text wrote. Empty when it is not one finite number.
std::optional<double> ParseNumber(std::string_view text, std::string_view unit = {});

/// The text with line breaks at blanks alone, so that each line is at most so many pixels wide where it can be, in the
/// current font. ImGui would break within "0.5" too.
std::string BrokenAtBlanks(std::string_view text, float width);
/// The same in a font of its own size, also outside a frame.
std::string BrokenAtBlanks(std::string_view text, float width, const ImFont& font);
/// The start of the text that fits into so many pixels in the current font, with "…" where something was left out.
std::string Shortened(std::string text, float width);
void Note(const char* text);                               ///< small and quiet, wraps
void Trouble(const char* sentence);                        ///< one sentence in the trouble colour with a sign, wraps
float TroubleHeight(const char* sentence, float width);    ///< of a Trouble in the current font, that has such a width
void ValueText(const char* text, Role role = Role::none);  ///< monospaced

/// Which role a letter has in a symbol: "l" → light.
struct LetterRole {
    char32_t letter;
    Role role;
};

/// Draws a formula such as "-l_x n_y", "n·l - l_x n_x", "1 - 2a^2": `_x` is lowered, `^2` raised (one character or
/// `{…}`), "-" a real minus, "*" a dot, "l" alone ℓ, a blank between two factors of one letter a thin one; letters take
/// their role's colour, and what is lowered or raised that of its letter, the rest `base`. Three or more letters in a
/// row are a word without roles. Returns the size. Draws nothing when `draw` is null.
ImVec2 Formula(ImDrawList* draw, ImVec2 position, const char* formula, std::span<const LetterRole> roles, ImU32 base,
               ImFont* font = nullptr);

/// A tooltip for the last item after the usual delay, beside the column that the item is in, or below the item where a
/// column is as wide as the window; it goes with a click and while text is typed. `title` in semibold, then lines;
/// empty ones are skipped, and so is a tooltip without any. `formula` may be several with "; " between; `path`, what a
/// script calls the thing, stands small and quiet below. Works on disabled items. Inside a group the item's own tooltip
/// comes before the group's.
void Tooltip(const char* title, const char* body, const char* formula = "", const char* gl_call = "",
             std::span<const LetterRole> roles = {}, const char* path = "");

// ---- values ----------------------------------------------------------------------------------------

/// How a number is edited.
struct NumberStyle {
    double min = -1e12, max = 1e12;         ///< of what is typed
    double drag_min = 0.0, drag_max = 0.0;  ///< what a drag or a slider reaches; both 0: min … max
    double step = 0.01;                     ///< change per design pixel of a drag (Shift ×10, Alt ÷100)
    int decimals = 2;
    const char* unit = "";       ///< shown behind the number: "°"
    bool logarithmic = false;    ///< a drag multiplies, 1 % a pixel; a slider is spaced by decades. Needs min > 0
    bool integer = false;        ///< whole numbers only
    double default_value = 0.0;  ///< right-click resets to it
    Links links = 0;             ///< highlighted with matrix entries that depend on it
    Role role = Role::none;
};

/// A number to drag; double-click or Ctrl-click types, right-click resets. `width` 0: the item width. Where the
/// decimals have no room they are written smaller, and fewer where that is not enough; a sign that is not there keeps
/// its place, so that they stay when it comes.
bool Number(const char* label, double& value, const NumberStyle& style, float width = 0.0F);

/// The same as a slider with a knob between min and max.
bool Slider(const char* label, double& value, const NumberStyle& style, float width = 0.0F);

/// Several numbers with the same decimals and size in one row with one label behind. `links[i]` per component when
/// given.
bool Numbers(const char* label, std::span<double> values, const NumberStyle& style,
             std::span<const double> defaults = {}, std::span<const Links> links = {});
bool Vec3(const char* label, glm::dvec3& value, const NumberStyle& style, const glm::dvec3& default_value = {},
          std::span<const Links> links = {});

/// Pixels of a control that is so wide together with the label behind it.
float LabelledWidth(const char* label, float control_width);

bool Toggle(const char* label, bool& value, bool default_value);  ///< checkbox; right-click resets
float ToggleWidth(const char* label);                             ///< of a Toggle in one line, pixels
/// Combo over names; right-click resets to `default_index`. `width` 0: as wide as its longest name.
bool Choice(const char* label, int& index, std::span<const char* const> names, int default_index, float width = 0.0F);
float ChoiceWidth(std::span<const char* const> names);  ///< in which the longest name is shown whole, pixels
/// The same as a row of radio buttons. `tips`: what each one means, on hover.
bool Segments(const char* label, int& index, std::span<const char* const> names, int default_index,
              std::span<const char* const> tips = {});

/// A closed list that looks like a Choice, for items that are no enumeration: when true, draw them, then EndChoice.
/// The label is not shown. `width` in pixels, 0: the item width. A preview that is too long for it is written small,
/// in two lines if need be, and shortened where that is not enough.
bool BeginChoice(const char* label, const char* preview, float width = 0.0F);
void EndChoice();

/// What looks like a closed Choice: says whether it was clicked; what opens then is the caller's.
bool ClosedList(const char* label, const char* preview, float width);

/// Closes the popup that is being drawn when Escape is pressed; call right after its Begin. Says whether it did. A
/// number that is being typed and a list that is open inside it come first. Choices and colours close by themselves.
bool ClosePopupOnEscape();

bool ColorField(const char* label, glm::u8vec3& rgb, const glm::u8vec3& default_value);
bool Button(const char* label, bool enabled = true, const char* why_disabled = "");

/// ImGui's field for text as wide as the next item, for a text that others write into as well; what it answers is
/// ImGui's. `hint` stands in an empty one.
bool TextField(const char* label, std::string& text, const char* hint = "", ImGuiInputTextFlags flags = 0);
/// A field for a text that counts when it is whole: `value` changes in the frame in which the field is left with
/// another text, by Enter, Tab, a click elsewhere or EndTyping. Escape puts back what was there.
bool EntryField(const char* label, std::string& value);
bool SmallButton(const char* label, bool enabled = true, const char* why_disabled = "");
float SmallButtonWidth(const char* label);  ///< in one line, pixels
bool OffersButton(const char* label);       ///< whether one of either kind is drawn at all

/// A header that folds what follows; the open state is kept by ImGui. Returns whether it is open.
/// `note` stands quiet at its right end. `trouble`: what is wrong inside; a sign there that tells it on hover, so that
/// nothing below moves when it comes.
bool Section(const char* label, bool open_by_default = true, const char* note = "", const char* trouble = "");

// ---- the lecture's things --------------------------------------------------------------------------

/// a x + b y + c z + d = 0: four numbers, buttons yz, xz, xy (keeping d's place: d = 0) and normalise. A normal can
/// never become zero: an edit that would make it so is not applied. `links`: one per component.
bool PlaneEquation(const char* label, glm::dvec4& plane, const glm::dvec4& default_value,
                   std::span<const Links> links = {});

/// Point (w = 1) or parallel (w = 0) light: two radio buttons, three numbers and w. Never all zero.
bool Light(const char* label, glm::dvec4& light, const glm::dvec4& default_value, std::span<const Links> links = {});

/// One cell of a matrix on show.
struct MatrixCell {
    const char* symbol = "";  ///< a Formula, drawn under the number
    Links links = 0;          ///< the parameters it comes from
    bool changed = false;     ///< since the last edit: tinted
    Links own = 0;            ///< the entry itself: what names it elsewhere lights up with it, see FollowEntry
};

/// Rows as on the slides: cells[4 * row + column] belongs to value[column][row], since GLM indexes columns first.
struct MatrixStyle {
    int decimals = 3;
    std::span<const MatrixCell> cells = {};  ///< 16, or empty
    std::span<const LetterRole> roles = {};
    bool editable = false;                 ///< each entry is then a Number
    bool overridden = false;               ///< entered by hand: brackets in the trouble colour, no symbols
    const glm::dmat4* defaults = nullptr;  ///< what right-click resets an entry to; null: the identity
    const char* target = nullptr;          ///< its name as in targets.h, "matrix:V"; null: none
    int* hovered_cell = nullptr;           ///< receives 4 * row + column under the pointer, or −1
};

/// A 4×4 matrix in square brackets: aligned columns, zeros quiet, symbols under the numbers. Hovering a cell highlights
/// what it is linked to, and it lights up when one of its parameters is hovered. True when an entry was edited. `width`
/// 0: what is there.
bool Matrix(const char* label, glm::dmat4& value, const MatrixStyle& style, float width = 0.0F);
/// The same without editing.
void Matrix(const char* label, const glm::dmat4& value, const MatrixStyle& style, float width = 0.0F);

/// Lets the last item stand for a matrix entry, as the line of code that fills it does: hovering either lights both and
/// what the entry comes from. Says whether the item is to be lit.
bool FollowEntry(Links own, Links links);

/// One lamp of a row: does this degree of freedom exist in the mode, and is it moving now?
struct Lamp {
    const char* label;
    bool available;
    bool active;
};
/// In one row where they fit, else in several of equal length.
void Lamps(const char* label, std::span<const Lamp> lamps, Role role);

/// A splitter between two areas, `length` pixels long; `position` in design pixels moves while dragged (with
/// `direction` −1 against the pointer: for an area at the right or bottom). Vertical: a bar between left and right.
bool Splitter(const char* id, bool vertical, float& position, float min, float max, float length,
              float direction = 1.0F);

// ---- drawing in a view -----------------------------------------------------------------------------

/// Text with a thin halo of the ground colour.
void HaloText(ImDrawList* draw, ImVec2 position, ImU32 color, const char* text, ImFont* font = nullptr);

/// Places labels beside their points so that none covers another or leaves the view: greedy over eight positions around
/// each point, near ones first. A label for which there is no room is left out. With roles the text is a Formula.
class LabelPlacer {
public:
    LabelPlacer(ImDrawList* draw, ImVec2 min, ImVec2 max) : draw_(draw), min_(min), max_(max) {}
    void Avoid(ImVec2 min, ImVec2 max);  ///< nothing is placed over this rectangle
    /// Whether there was room.
    bool Place(ImVec2 point, const char* text, ImU32 color, std::span<const LetterRole> roles = {});

private:
    struct Box {
        ImVec2 min, max;
    };
    bool IsFree(const Box& box) const;

    ImDrawList* draw_;
    ImVec2 min_, max_;
    std::vector<Box> taken_;
};

}  // namespace widgets
