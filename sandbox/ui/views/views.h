// The views: pictures, their overlays and mouse actions.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>

#include "frame/pinned_pixel.h"
#include "frame/problems.h"
#include "session/session.h"
#include "state/person/mouse_habits.h"
#include "topics/depth/numbers/depth_data.h"
#include "topics/depth/shown/cell_view.h"
#include "topics/hidden/shown/hidden_state.h"
#include "topics/planes/shown/mirror_ways_view.h"
#include "topics/planes/shown/passes_view.h"
#include "topics/why/shown/why_view.h"
#include "ui/parts/handles.h"
#include "ui/parts/input.h"
#include "ui/parts/stage.h"
#include "ui/parts/topics.h"
#include "ui/views/observer_parts.h"

namespace viewing {

/// A preset's thumbnail; the texture is null until it is rendered.
struct PresetPicture {
    std::string name;  ///< the preset's name
    ImTextureID texture = nullptr;
};

/// The finished pictures to show (null where there is none), and the results that belong to them.
struct Pictures {
    ImTextureID camera = nullptr, beside = nullptr;
    std::array<ImTextureID, 2> lower{};  ///< one for each Slot
    PassPictures passes{};
    MirrorWaysShown mirror_ways;
    HiddenStatus hidden;
    DepthData depth;
    PresetPicture preset;
    std::vector<PresetPicture> cards;  ///< of lessons, steps and exercises; `name` is the card's key
};

/// The lower view that the user prefers if only one fits; valid while the two slots show these topics.
struct LowerChoice {
    Slot slot;
    Topic left, right;
};

/// State of the views; persists between frames.
struct ViewState {
    bool handles = true;
    /// The fields and groups that can be changed with handles while a lesson's question is open; nullopt: all of them.
    /// Holding Ctrl lifts the restriction.
    std::optional<std::vector<std::string>> movable;
    bool marks_lights = true, marks_plane = true;  ///< in the camera view
    bool marks_derivation = true;                  ///< also if no point is followed; see derivation_point()
    Grip grip;
    bool looking = false;                     ///< dragging to rotate the camera
    float dragged_px = 0.0F;                  ///< pixels since the press; distinguishes a click from a drag
    glm::ivec2 camera_px{1280, 720};          ///< last known size of the camera's picture
    Rect plate;                               ///< the controls over the camera's picture on stage; may be empty
    MouseHabits mouse;                        ///< the user's
    double pan_distance = 1.0;                ///< eye distance of the point grabbed with the middle or right button
    glm::dvec3 orbit_center{0.0};             ///< the grabbed point, in world space
    std::optional<glm::ivec2> hovered_pixel;  ///< in the camera's picture, from its top left
    std::optional<glm::ivec2> method_pixel;   ///< under the pointer, in a hidden-surface method's picture
    std::optional<glm::ivec2> told_pixel;     ///< the last hovered_pixel, kept while the pointer is elsewhere
    ViewName hovered = ViewName::none;
    std::optional<LowerChoice> lower;
    HiddenState hidden;
    widgets::StepPlayer call_player;        ///< steps through draw calls
    widgets::StepPlayer pass_player;        ///< steps through passes
    widgets::StepPlayer derivation_player;  ///< steps through a derivation's lines
    widgets::StepPlayer way_player;         ///< moves a point from space to space
    bool moves = true;                      ///< whether playback may animate rather than only jump; see Guide::moves
    glm::ivec2 cells{0};                    ///< the number of columns and rows that fit into the cell view
    LightRays light_rays;                   ///< of the observer's view
    std::optional<Stage::Target> target;    ///< the point that a lesson marks
    WhyState why;
    PinnedPixel pinned;  ///< the pixel that the state pins, in the camera's picture
};

/// Returns whether a hidden-surface method, the draw calls, the passes or the path of a point is playing.
inline bool is_playing(const ViewState& state) {
    return state.hidden.panel.player.playing || state.call_player.playing || state.pass_player.playing ||
           state.way_player.playing;
}

/// Draws the camera's picture. Adds mouse actions to the motion input.
void draw_camera_view(ViewState& state, Session& session, const Derived& derived, const std::vector<Problem>& problems,
                      const Rect& rect, const Pictures& pictures, const FrameInput& input, MotionInput& motion);

/// Returns the angles (yaw, pitch) in degrees by which the pointer's movement since the last frame turns a view. A drag
/// to the right turns right, and a drag upward looks up unless the user inverts it. `usual_deg`: degrees per design
/// pixel, before the user's factor.
glm::dvec2 turn_of_drag(const MouseHabits& mouse, double usual_deg);

/// Handles the mouse in the camera's view. Pressing grabs a handle or starts looking around; dragging then moves the
/// handle or turns the camera. A click without motion chooses a pixel if a hidden-surface method or a view examines
/// pixels; otherwise it picks a vertex, or clears the pick if it hits no object. `hovered`: the handle under the
/// pointer.
void camera_mouse(ViewState& state, Session& session, const Derived& derived, Overlay& overlay, Handle hovered,
                  const HiddenStatus& hidden, const FrameInput& input, MotionInput& motion);

/// Draws the second picture of the camera's view, which handles the mouse like the first.
void draw_beside_view(ViewState& state, Session& session, const Derived& derived, const Layout& layout,
                      const Pictures& pictures, const FrameInput& input, MotionInput& motion);

/// Draws a ring around the pinned pixel, large enough to be visible.
void draw_pin(const Overlay& overlay, glm::ivec2 pixel);

/// Pins a pixel of the camera's picture and replaces any other pin. If this pixel is already pinned, removes the pin.
void pin(Params& params, const PinnedPixel& pinned, glm::ivec2 pixel);

/// Returns the pixel of the camera's picture that corresponds to the pointer's position in another picture from the
/// same camera, which fills `rect`; nullopt if the pointer is outside the camera's picture. If the projection has a
/// fixed aspect ratio or an explicit window, the camera's picture is stretched to fill any view.
std::optional<glm::ivec2> camera_pixel_at(const Rect& rect, ImVec2 pointer, glm::ivec2 camera_px,
                                          const ProjectionParams& projection);

/// Returns the lower view to show if only one fits.
Slot lower_shown(const ViewState& state, const Params& params);

/// Returns the handle, or none if it must not move now.
Handle movable_handle(const ViewState& state, Handle handle);

}  // namespace viewing
