// Names of what is on screen, such as "matrix:V[2][3]", by which it is covered or pointed out from outside. Who draws a
// thing asks whether its name is covered, and draws a plate in its place; who has drawn it marks where it is. A name
// contains those that go on behind it with '.', '[' or, for a kind, ':' ("matrix:V" contains "matrix:V[2][3]").
// Without names in Targets none of this does anything.
#pragma once

#include <imgui.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace widgets {

struct Targets {
    std::vector<std::string> covered;      ///< nothing of these is drawn, told or copied
    std::vector<std::string> listed;       ///< where there are any, a panel shows controls of these names alone
    std::vector<std::string> highlighted;  ///< these are marked, brought into view and framed
    /// Where there are any, even none: the only switches, beside numbers and the steps of what goes step by step. A
    /// kind by itself ("button") stands for all of it.
    std::optional<std::vector<std::string>> offered;

    /// Where something highlighted is seen in this frame: of all its parts in one window together.
    struct Found {
        std::string name;
        const ImDrawList* window;
        ImVec2 min, max;
    };
    std::vector<Found> found;

    // What the library remembers between the calls.
    std::vector<std::string> sought;  ///< the highlighted ones that are brought into view, for so many frames
    int frames_of_search = 0;
    std::vector<const ImDrawList*> scrolled;  ///< windows that do so in this frame
    bool opens_next = false;                  ///< the next Section
    std::vector<std::vector<std::string>> scopes;

    bool empty() const { return covered.empty() && highlighted.empty(); }
};

/// Whether one name stands for the other, too.
bool Contains(std::string_view whole, std::string_view part);

bool IsCovered(std::string_view name);
/// Whether the name or a part of it is.
bool IsPartCovered(std::string_view name);
/// Whether it, what it is a part of, or a part of it is highlighted.
bool IsHighlighted(std::string_view name);
/// Whether something highlighted that these contain has still to be brought into view, so that what folds opens.
bool IsSought(std::span<const char* const> names);
/// Opens the next Section, whatever it was.
void OpenNextSection();

/// Whether a panel is to show the thing of this name; where nothing is listed, all.
bool IsListed(std::string_view name);
/// Whether only what is listed is shown: no headlines, nothing that has no name.
bool IsListing();

/// Whether a switch of this name is drawn: "control:view.shows", "button:show C", "speed".
bool Offers(std::string_view name);
/// Whether some are left out: what shows something has a title in large type in the place of its switches.
bool HasPlainTitles();

/// The last item, or a rectangle of the current window, bears this name.
void MarkTarget(std::string_view name);
void MarkTarget(std::string_view name, ImVec2 min, ImVec2 max);

/// The highlighted names that were found nowhere in this frame.
std::vector<std::string> MissingTargets();

/// An item that hides what would stand here: an opaque plate with "?". Recorded under `label` with the text "?".
void Plate(const char* label, ImVec2 size);
/// A control that is covered: a plate so wide, 0: the item width, and its label as usual.
void CoveredControl(const char* label, float width = 0.0F);
/// The same as Plate without an item.
void DrawPlate(ImDrawList* draw, ImVec2 min, ImVec2 max);

/// Inside it a number box is the thing of this name, and the boxes of a row are its components "[0]", "[1]" …, or the
/// things of these names one by one.
struct TargetScope {
    explicit TargetScope(std::string_view name);
    explicit TargetScope(std::span<const char* const> names);
    ~TargetScope();
    TargetScope(const TargetScope&) = delete;
    TargetScope& operator=(const TargetScope&) = delete;
};

/// Frames what was found and dims everything else a little, over all windows that lie below: call it last in a frame.
/// The pointer goes through. What lies below `bottom`, in pixels, stays as it is.
void DrawHighlights(float bottom);

}  // namespace widgets
