// Everything that turns a session into pixels: renderer, views, user interface, and the framebuffer of the whole
// window. Needs a current GL context, on screen or not; knows no window system.
#pragma once

#include <memory>

#include "frame/animation.h"
#include "measure/depth_inspector.h"
#include "measure/fighting_counter.h"
#include "measure/hidden_worker.h"
#include "render/renderer.h"
#include "ui/window/workbench.h"

namespace viewing {

class Studio {
public:
    /// `renderer` and the context behind it must outlive the studio. Makes the ImGui context and its GL backend.
    Studio(Renderer& renderer, Session session);
    ~Studio();
    Studio(const Studio&) = delete;
    Studio& operator=(const Studio&) = delete;

    Session session;
    Workbench workbench;

    /// What a frame needs from outside. `shows_time`: false in pictures that have to repeat.
    struct Surroundings {
        glm::ivec2 size_px{1280, 720};
        double device_scale = 1.0;  ///< of the monitor; the state's ui.scale and the theme's type multiply it
        bool shows_time = false;
        FrameInput input;
    };

    /// Draws one frame into the studio's own framebuffer. ImGui's mouse and text input must be in its IO by then.
    /// What cannot be drawn keeps its last picture, and the message says why: a lecture goes on.
    Requests frame(const Surroundings& surroundings);

    GLuint framebuffer() const { return window_.framebuffer(); }
    Image read() const;
    /// The camera's picture alone.
    const View& camera_view() const { return camera_; }

    /// In how many seconds another frame is wanted though no input comes: 0 at once, negative never.
    double redraw_in_s() const { return redraw_in_s_; }

private:
    void apply_looks(double device_scale);
    Status draw_views(const Layout& layout, bool is_interactive);
    Status draw_camera_view(const Layout& layout);
    Status draw_beside_view(const Layout& layout);
    Status draw_after_pass(glm::ivec2 size_px);
    Status draw_mirror_ways();
    Status draw_lower_view(Slot slot, const Layout& layout);
    Status draw_depth_below(glm::ivec2 size_px, View& view);
    /// What GL's own methods show of their steps.
    HiddenPictures pictures_by_gl() const;
    std::vector<std::string> pixel_parts();
    Status inspect();
    /// Asks the worker for what the camera view needs; what is not there in a moment is taken when it comes.
    Status update_hidden(glm::ivec2 camera_px, bool is_interactive);

    Renderer& renderer_;
    std::string renderer_name_;
    glm::ivec2 camera_px_{1280, 720};  ///< of the camera's view when it was shown last
    View camera_, beside_;
    std::array<View, 2> lower_;  ///< of each Slot
    std::array<View, mirror_way_count> mirror_way_views_;
    std::shared_ptr<const MirrorWays> mirror_ways_;
    std::array<View, 3> after_pass_;  ///< colour, depth and stencil
    gl::ColorTarget window_;
    HiddenWorker hidden_worker_;
    std::shared_ptr<const HiddenAnswer> hidden_;  ///< what the camera view shows
    DepthParams hidden_depth_;                    ///< that its difference was made with
    bool hidden_is_behind_ = false;               ///< a newer answer is awaited
    DepthInspector inspector_;
    FightingCounter fighting_;
    bool views_are_behind_ = false;  ///< some view shows an earlier frame, until nothing is held

    // What the pictures were drawn for: nothing is drawn again while it is the same.
    struct Drawn {
        Params params;
        int scene_version = -1;
        Params animated;  ///< the same, as they are at the time
        glm::ivec2 camera_px{0}, beside_px{0}, lower_left_px{0}, lower_right_px{0};
        std::shared_ptr<const HiddenAnswer> hidden;
        bool operator==(const Drawn&) const = default;
    };
    Drawn drawn_;
    Params params_;  ///< the session's, as they are at the time: of all pictures
    Derived derived_, before_;
    FramePlan plan_;
    std::vector<Problem> problems_;
    FramePlan inspected_;  ///< the same with its colours, to be read

    Theme theme_ = Theme::dark;
    float looks_scale_ = 0.0F;
    int settling_ = 0;  ///< frames until ImGui has laid out what changed
    Moment moment_;     ///< of what moves by itself
    double frame_ms_ = 0.0;
    double redraw_in_s_ = 0.0;
};

}  // namespace viewing
