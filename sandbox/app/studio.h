// Everything that turns a session into pixels: renderer, views, user interface, and the framebuffer of the whole
// window. Needs a current GL context, on screen or not, and is independent of the window system.
#pragma once

#include <memory>
#include <optional>

#include "app/answer_judge.h"
#include "app/inspection.h"
#include "app/looks.h"
#include "app/preset_pictures.h"
#include "app/shown_answer.h"
#include "app/stand_ins.h"
#include "app/view_pictures.h"
#include "figure/drawing.h"
#include "frame/animation.h"
#include "ui/window/workbench.h"

namespace viewing {

class Studio {
public:
    /// `renderer` and its context must outlive the studio. Creates the ImGui context and its GL backend.
    Studio(Renderer& renderer, Session session);
    ~Studio();
    Studio(const Studio&) = delete;
    Studio& operator=(const Studio&) = delete;

    Session session;
    Workbench workbench;

    /// External inputs of a frame. `shows_time` is false in pictures that must be reproducible.
    struct Surroundings {
        glm::ivec2 size_px{1280, 720};
        double device_scale = 1.0;  ///< of the monitor; multiplied by the state's ui.scale and the theme's type scale
        bool shows_time = false;
        FrameInput input;
    };

    /// Makes one frame, with the edits that its input makes; on screen (`shows_time`), also paints the frame.
    /// ImGui's IO must already have the mouse and text input. A view that cannot be drawn keeps its last picture, and
    /// the message says why, so that a lecture can go on.
    Requests frame(const Surroundings& surroundings);

    /// Draws the latest frame into the studio's own framebuffer, unless it is there already. present() and read() paint
    /// first, so a frame that nobody sees costs no drawing.
    void paint();

    /// Uses one color instead of the theme's for all backgrounds, in pictures and around them. Call before the first
    /// frame.
    void set_ground(Color color);

    /// Copies the latest frame to the default framebuffer.
    void present();
    Image read();
    /// Returns the latest frame as shapes, text and pictures. Its lines must have been drawn without textures.
    Drawing record() const;
    /// Returns only the camera's picture, which shows the state that shown_state() returns. Draws it now if another
    /// view fills the window, or if it lags behind a drag.
    const View& camera_view();
    /// Returns the state that the latest frame showed, as text, with animations at that frame's time.
    std::string shown_state() const;
    /// Returns the latest frame's parameters and everything derived from them.
    const ShownFrame& shown() const { return shown_; }

    /// Returns the number of seconds until another frame is needed if no input comes; 0 means immediately, and a
    /// negative number means never.
    double redraw_in_s() const { return redraw_in_s_; }

    /// Whether the next frame reads a pixel back, which makes some drivers block until all drawing is done.
    bool reads_back() const { return inspection_.reads_back(); }

private:
    /// Lets the interface take the input and edit the session.
    Requests react(const Surroundings& surroundings);
    /// Brings everything that the interface shows up to date with the session.
    void prepare(const Surroundings& surroundings);
    void follow_looks(const Surroundings& surroundings);
    void animate(const Surroundings& surroundings);
    /// Recomputes and redraws everything that is affected by changes in the frame's parameters, sizes or results.
    void update(const Layout& layout, const Surroundings& surroundings);
    void derive_before(const Viewport& viewport);
    Status draw_views(const Layout& layout, const Scene& scene, bool is_interactive);
    Params shown_params() const;
    void gather_content(const Surroundings& surroundings);
    StatusLine status(bool shows_time);
    WindowContent content() const;
    /// Makes exercises of the student's sheet, for a moment in each frame: their numbers may have to be measured in
    /// pictures.
    void make_exercises();
    void record(double dt_s);
    double next_redraw_in_s() const;
    bool is_held() const;  ///< something is being dragged

    Renderer& renderer_;
    std::string renderer_name_;
    Looks looks_;
    std::optional<ImU32> ground_;  ///< replaces the theme's background
    ShownFrame shown_;
    Pictures shown_pictures_;
    StatusLine shown_status_;
    ShownAnswer answer_;
    ViewPictures pictures_;
    Inspection inspection_;
    PresetPictures preset_pictures_;
    StandIns stand_ins_;
    AnswerJudge judge_;
    gl::ColorTarget window_;

    // The inputs of the latest pictures: nothing is redrawn while they are unchanged.
    struct Drawn {
        Params params;
        int scene_version = -1;
        Params animated;  ///< `params` with the animations at the frame's time
        glm::ivec2 camera_px{0}, beside_px{0}, lower_left_px{0}, lower_right_px{0};
        std::shared_ptr<const HiddenAnswer> hidden;
        bool is_coarse = false;     ///< stand-ins were drawn
        bool knows_driver = false;  ///< the driver's depth storage was measured
        bool operator==(const Drawn&) const = default;
    };
    Drawn drawn_;
    struct {
        Params params;
        Viewport viewport;
    } before_of_;                    ///< what ShownFrame::before was derived from
    bool views_are_behind_ = false;  ///< some view shows an earlier frame, until the drag ends
    bool camera_is_behind_ = true;   ///< the camera's view shows an earlier frame or stand-ins

    Moment moment_;           ///< how far the animations have advanced
    bool moves_ = false;      ///< an animation is running
    int settling_ = 0;        ///< remaining frames until ImGui has laid out the changes
    bool is_frozen_ = false;  ///< the window keeps its picture
    bool is_painted_ = true;  ///< the framebuffer has the latest frame
    double frame_ms_ = 0.0;
    double redraw_in_s_ = 0.0;
};

}  // namespace viewing
