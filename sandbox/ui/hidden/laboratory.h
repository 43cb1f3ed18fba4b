// The hidden-surface laboratory's part of the interface: what is remembered between frames, and its pieces in the
// panel, over the camera view and below it. Read laboratory_panel.cpp, then laboratory_views.cpp.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <vector>

#include "frame/hidden/hidden_views.h"
#include "platform/background.h"
#include "session/session.h"
#include "ui/hidden/growth_log.h"
#include "ui/hidden/tree_index.h"
#include "ui/parts/overlay.h"
#include "ui/window/layout.h"
#include "visibility/failure_search.h"
#include "visibility/growth.h"
#include "widgets/diagrams.h"

namespace viewing {

/// What hidden-surface methods have found for the camera view, and whether they are still at it.
struct HiddenStatus {
    std::shared_ptr<const HiddenAnswer> answer;  ///< the newest, maybe of an earlier camera; null: none
    std::optional<float> fraction;               ///< 0 … 1 while a method works on a newer one
    bool shows_time = false;                     ///< false in pictures that have to repeat
};

/// Linked between tree, list, camera view and observer: a polygon of the result's `fragments`, and a node of its tree.
/// −1: none. Hovered ones are set by whoever has the pointer and hold for one frame.
struct PolygonLink {
    int hovered_fragment = -1, selected_fragment = -1;
    int hovered_node = -1, selected_node = -1;

    int shown_fragment() const { return hovered_fragment >= 0 ? hovered_fragment : selected_fragment; }
    int shown_node() const { return hovered_node >= 0 ? hovered_node : selected_node; }
};

/// Short names for choices and sentences, in the order of VisibilityMethod.
inline constexpr const char* method_names[] = {"GL depth buffer", "none",           "painter",    "Newell",
                                               "BSP tree",        "soft. z-buffer", "ray casting"};

/// A part of the window that shall be written as a picture.
struct ViewPicture {
    Rect rect;  ///< pixels of the window
    std::filesystem::path file;
};

struct LaboratoryState {
    PolygonLink link;       ///< of this frame
    PolygonLink next_link;  ///< gathered while it is drawn; takes over at its end

    std::shared_ptr<const std::vector<Polygon>> linked_fragments;  ///< the ones that the links are indices into

    int scene_version = -1;       ///< of this frame
    int last_step = -1;           ///< as the step bar left it
    bool has_step_bar = false;    ///< it was drawn in this frame
    bool restart_method = false;  ///< asked for: what was cancelled shall be begun again
    bool cancel_method = false;   ///< asked for: the work on the current question shall be given up
    bool playing = false;
    float steps_per_s = 4.0F;
    double carry_steps = 0.0;

    widgets::TreeDiagramState tree;
    TreeIndex tree_index;             ///< of the latest result with a tree
    std::uint64_t tree_revision = 0;  ///< counts the trees that `tree` was laid out for
    int tree_revealed = -1;           ///< the node that `tree` was last moved to, as it was selected
    ImVec2 tree_size_px{0.0F, 0.0F};  ///< that it was fitted to
    int tree_current = -1;            ///< and as the step reached it
    int order_revealed = -1;          ///< the fragment that the order list was last scrolled to
    int order_current = -1;           ///< the place in the order that it was last scrolled to

    /// What a search was started for; when any of it changes the search is given up.
    struct FailureAsked {
        int scene_version = -1;
        VisibilityParams visibility;
        CameraParams camera;
        ProjectionParams projection;
        bool operator==(const FailureAsked&) const = default;
    };
    BackgroundTask<FailureView> failure_search;
    FailureAsked failure_asked;
    BackgroundTask<std::vector<GrowthRow>> growth;
    std::shared_ptr<GrowthLog> growth_log;              ///< filled while it is measured
    std::array<std::vector<GrowthRow>, 3> growth_rows;  ///< of each GrowthScene
    int growth_scene = 0;                               ///< the one that is shown, and measured
    int growth_of_version = -1;                         ///< the session's scene that its rows are of
    bool growth_shows_operations = false;
    bool growth_wants_picture = false;          ///< of the chart, as the next frame shows it
    std::optional<ViewPicture> wanted_picture;  ///< asked for in this frame

    /// Whether something here wants frames although no input comes.
    bool is_busy() const { return playing || failure_search.is_running() || growth.is_running(); }
};

/// The method's options, steps and counters: the laboratory's part of the panel's section on hidden surfaces.
void draw_laboratory_panel(LaboratoryState& state, Session& session, const HiddenStatus& hidden);

/// Once a frame, before anything is drawn: playing ends when somebody else has changed the step.
void begin_laboratory_frame(LaboratoryState& state, const Session& session);

/// Once a frame, at its end: what was found takes effect (a view where the sort key fails), and playing ends when its
/// bar is not on screen.
void end_laboratory_frame(LaboratoryState& state, Session& session);

/// When other fragments take over: what is selected becomes a piece of the same triangle, if there is one, and nodes
/// and hovered polygons are let go.
void keep_selection(LaboratoryState& state, const HiddenStatus& hidden);

/// Over the camera's picture: polygon numbers, the linked polygon, the pair, pixel or ray of the step.
void draw_laboratory_overlay(const LaboratoryState& state, const Session& session, const HiddenStatus& hidden,
                             Overlay& overlay);

/// The polygon of `fragments` that is seen at a pixel of the camera's picture; −1: none, or not known.
int fragment_at(const HiddenStatus& hidden, const Overlay& overlay, glm::ivec2 pixel);

/// Over the observer's picture: the linked polygon, its node's plane and half-spaces, the ray of the step.
void draw_laboratory_observer(const LaboratoryState& state, const HiddenStatus& hidden, Overlay& overlay);

/// The lower right view's topics: the tree, the order, and the costs as they grow.
void draw_tree_view(LaboratoryState& state, Session& session, const HiddenStatus& hidden, const Rect& rect);
void draw_order_view(LaboratoryState& state, Session& session, const HiddenStatus& hidden, const Rect& rect);
void draw_growth_view(LaboratoryState& state, Session& session, const Rect& rect);

/// The rows that have been measured so far become `growth_rows`; once a frame, whichever view is shown.
void take_growth_rows(LaboratoryState& state);

}  // namespace viewing
