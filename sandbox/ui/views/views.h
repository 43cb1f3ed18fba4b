// The pictures with what is drawn over them and what the mouse does in them.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>

#include "frame/depth/depth_data.h"
#include "frame/pinned_pixel.h"
#include "frame/problems.h"
#include "session/session.h"
#include "ui/depth/cell_view.h"
#include "ui/hidden/hidden_state.h"
#include "ui/parts/handles.h"
#include "ui/parts/input.h"
#include "ui/parts/stage.h"
#include "ui/parts/topics.h"
#include "ui/planes/mirror_ways_view.h"
#include "ui/planes/passes_view.h"
#include "ui/views/observer_parts.h"

namespace viewing {

/// A small picture of a preset; null while it is not there.
struct PresetPicture {
    std::string name;  ///< of the preset
    ImTextureID texture = nullptr;
};

/// Finished pictures to show, null while there is none, and what was found for them.
struct Pictures {
    ImTextureID camera = nullptr, beside = nullptr;
    std::array<ImTextureID, 2> lower{};  ///< of each Slot
    PassPictures passes{};
    MirrorWaysShown mirror_ways;
    HiddenStatus hidden;
    DepthData depth;
    PresetPicture preset;
    std::vector<PresetPicture> cards;  ///< of lessons and steps, by their keys
};

/// Which of the lower views a person wants to see where there is room for one only, as long as they show these topics.
struct LowerChoice {
    Slot slot;
    Topic left, right;
};

/// What the mouse is doing in the views; kept between frames.
struct ViewState {
    bool handles = true;
    /// While a lesson's step asks: the fields and groups that handles may move, unless Ctrl is held. Nothing: all.
    std::optional<std::vector<std::string>> movable;
    Grip grip;
    bool looking = false;                     ///< dragging to turn the camera
    float dragged_px = 0.0F;                  ///< since the press: a click that did not move picks a vertex
    glm::ivec2 camera_px{0};                  ///< size of the camera's picture when it was last seen
    double pan_distance = 1.0;                ///< eye distance of what the middle or right button has taken hold of
    std::optional<glm::ivec2> hovered_pixel;  ///< of the camera's picture, top left origin
    std::optional<glm::ivec2> method_pixel;   ///< of the picture that a method has found, under the pointer
    std::optional<glm::ivec2> told_pixel;     ///< the last one of these, while the pointer is elsewhere
    ViewName hovered = ViewName::none;
    std::optional<LowerChoice> lower;
    HiddenState hidden;
    widgets::StepPlayer call_player;        ///< of the draw calls
    widgets::StepPlayer pass_player;        ///< of the passes
    widgets::StepPlayer derivation_player;  ///< of the lines of a derivation
    glm::ivec2 cells{0};                    ///< columns and rows that the cell view had room for
    LightRays light_rays;                   ///< of the observer
    std::optional<Stage::Target> target;    ///< a place that is marked
    PinnedPixel pinned;                     ///< of the camera's picture, as the state says
};

/// Whether something goes on by itself, step by step.
inline bool is_playing(const ViewState& state) {
    return state.hidden.panel.player.playing || state.call_player.playing || state.pass_player.playing;
}

/// The camera's picture; adds what the mouse did to the motion input.
void draw_camera_view(ViewState& state, Session& session, const Derived& derived, const std::vector<Problem>& problems,
                      const Rect& rect, const Pictures& pictures, const FrameInput& input, MotionInput& motion);

/// Part of it. Pressing takes a handle or begins to look; dragging moves it; a click that stayed in place picks a
/// vertex, or nothing where it meets no object. `hovered`: the handle under the pointer.
void camera_mouse(ViewState& state, Session& session, const Derived& derived, Overlay& overlay, Handle hovered,
                  const HiddenStatus& hidden, const FrameInput& input, MotionInput& motion);

/// The second picture of the camera's view, which answers the mouse as the first one does.
void draw_beside_view(ViewState& state, Session& session, const Derived& derived, const Layout& layout,
                      const Pictures& pictures, const FrameInput& input, MotionInput& motion);

/// Pins a pixel of the camera's picture, whatever was pinned before; a click on the pinned one lets it go.
void pin(Params& params, const PinnedPixel& pinned, glm::ivec2 pixel);

/// The camera's pixel that shows what another picture of the same camera shows under the pointer, the last item;
/// nothing where the camera's picture ends before.
std::optional<glm::ivec2> camera_pixel_at(const Rect& rect, ImVec2 pointer, glm::ivec2 camera_px);

/// The lower view that is seen where there is room for one only.
Slot lower_shown(const ViewState& state, const Params& params);

/// One of the two views below; `plan` is the camera's frame. `is_alone`: the other one has no room, and its name leads
/// to it.
void draw_lower_view(Slot slot, ViewState& state, Session& session, const Derived& derived, const FramePlan& plan,
                     const Rect& rect, const Pictures& pictures, bool is_alone);

/// The observer's picture with what is drawn over it; its headline stands already.
void draw_observer_view(ViewState& state, Session& session, const Derived& derived, const Rect& rect,
                        ImTextureID picture, const HiddenStatus& hidden);

/// The world as it moves before a camera that stays where it is.
void draw_moving_world_view(Session& session, ViewState& state, const Derived& derived, const Rect& rect,
                            ImTextureID picture);

/// The handle itself, or none where it may not be moved now.
Handle movable_handle(const ViewState& state, Handle handle);

}  // namespace viewing
