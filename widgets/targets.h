// Names of parts on screen, such as "matrix:V[2][3]", for covering or highlighting them from outside. Code that draws a
// part first checks whether its name is covered. If so, it draws a plate instead; otherwise it marks the part's area. A
// name contains every longer name that continues it with '.', '[' or, after a kind, ':' ("matrix:V" contains
// "matrix:V[2][3]"). Nothing happens while Targets holds no names.
#pragma once

#include <imgui.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace widgets {

struct Targets {
    std::vector<std::string> covered;      ///< not drawn, reported or copied
    std::vector<std::string> listed;       ///< if not empty, a panel shows only controls with these names
    std::vector<std::string> highlighted;  ///< marked, scrolled into view and framed
    /// If set, even if empty: the only switches to offer, besides numbers and step bars. A kind by itself ("button")
    /// includes all switches of that kind.
    std::optional<std::vector<std::string>> offered;

    /// The visible area of a highlighted target in this frame, including all its parts in the same window.
    struct Found {
        std::string name;
        const ImDrawList* window;
        ImVec2 min, max;
        ImVec2 clip_min;  ///< of the area that contains the target: a window may draw several views
    };
    std::vector<Found> found;

    // Internal state between calls.
    std::vector<std::string> sought;  ///< highlighted names to scroll into view in the next frames_of_search frames
    int frames_of_search = 0;
    std::vector<const ImDrawList*> scrolled;  ///< windows that have scrolled in this frame
    bool opens_next = false;                  ///< opens the next Section
    std::vector<std::vector<std::string>> scopes;

    bool empty() const { return covered.empty() && highlighted.empty(); }
};

/// Whether the name `whole` includes `part`.
bool Contains(std::string_view whole, std::string_view part);

bool IsCovered(std::string_view name);
/// Whether the name or a part of it is covered.
bool IsPartCovered(std::string_view name);
/// Whether the name, a name that contains it, or a part of it is highlighted.
bool IsHighlighted(std::string_view name);
/// Whether a highlighted target within one of these names still has to scroll into view. If so, folded parts must open.
bool IsSought(std::span<const char* const> names);
/// Opens the next Section, whatever its state.
void OpenNextSection();

/// Whether a panel should show the part with this name. True for all if nothing is listed.
bool IsListed(std::string_view name);
/// Whether only listed parts are shown: no headlines, no unnamed parts.
bool IsListing();

/// Whether to draw a switch with this name: "control:view.shows", "button:show C", "speed".
bool Offers(std::string_view name);
/// Whether only some switches are offered: views then show a large title instead of their switches.
bool HasPlainTitles();

/// Gives this name to the last item, or to a rectangle of the current window.
void MarkTarget(std::string_view name);
void MarkTarget(std::string_view name, ImVec2 min, ImVec2 max);

/// Like MarkTarget, for one of several lines of text: the frame does not extend into the neighboring lines.
void MarkLine(std::string_view name);
void MarkLine(std::string_view name, ImVec2 min, ImVec2 max);

/// Draws an opaque plate with "?" that replaces a covered part. Recorded under `label` with the text "?".
void Plate(const char* label, ImVec2 size);
/// Draws a plate of this width (0: the item width) for a covered control, with the control's usual label.
void CoveredControl(const char* label, float width = 0.0F);
/// Draws a plate without an item.
void DrawPlate(ImDrawList* draw, ImVec2 min, ImVec2 max);

/// Names the number boxes inside this scope: a single box gets the name itself; the boxes of a row get its components
/// "[0]", "[1]" …, or one of `names` each.
struct TargetScope {
    explicit TargetScope(std::string_view name);
    explicit TargetScope(std::span<const char* const> names);
    ~TargetScope();
    TargetScope(const TargetScope&) = delete;
    TargetScope& operator=(const TargetScope&) = delete;
};

/// Frames the highlighted targets on top of all windows, but nothing below `bottom`, in pixels. Call last in a frame.
/// Does not block the pointer.
void DrawHighlights(float bottom);

}  // namespace widgets
