// Everything that turns a session into pixels: renderer, views, user interface, and the framebuffer of the whole
// window. Needs a current GL context, on screen or not; knows no window system.
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

    /// One colour for all grounds, in pictures and around them, in the place of the theme's; before the first frame.
    void set_ground(Color color);

    /// Copies the latest frame to the framebuffer of the screen.
    void present() const;
    Image read() const;
    /// The latest frame as shapes, text and pictures, where its lines were drawn without textures.
    Drawing record() const;
    /// The camera's picture alone, of shown_state(): drawn now where another view has the window, or where it is behind
    /// what is moved by hand.
    const View& camera_view();
    /// The state that the latest frame showed, as text: what moves by itself is where it was then.
    std::string shown_state() const;
    /// The latest frame's parameters and what follows from them.
    const ShownFrame& shown() const { return shown_; }

    /// In how many seconds another frame is wanted though no input comes: 0 at once, negative never.
    double redraw_in_s() const { return redraw_in_s_; }

    /// Whether the next frame reads a pixel back, for which some drivers wait until all that was drawn is there.
    bool reads_back() const { return inspection_.reads_back(); }

private:
    /// Makes and draws again what the latest frame's parameters, sizes and answers have changed.
    void update(const Layout& layout, const Surroundings& surroundings);
    Status draw_views(const Layout& layout, const Scene& scene, bool is_interactive);
    Params shown_params() const;
    StatusLine status(bool shows_time);
    Requests draw_interface(const Surroundings& surroundings);
    /// Of the student's sheet one exercise a frame is made, since its numbers may be measured in pictures.
    void make_exercise();
    void record(double dt_s);
    double next_redraw_in_s() const;
    bool is_held() const;  ///< something is moved by hand

    Renderer& renderer_;
    std::string renderer_name_;
    Looks looks_;
    std::optional<ImU32> ground_;  ///< in the place of the theme's
    ShownFrame shown_;
    ShownAnswer answer_;
    ViewPictures pictures_;
    Inspection inspection_;
    PresetPictures preset_pictures_;
    StandIns stand_ins_;
    AnswerJudge judge_;
    gl::ColorTarget window_;

    // What the pictures were drawn for: nothing is drawn again while it is the same.
    struct Drawn {
        Params params;
        int scene_version = -1;
        Params animated;  ///< the same, as they are at the time
        glm::ivec2 camera_px{0}, beside_px{0}, lower_left_px{0}, lower_right_px{0};
        std::shared_ptr<const HiddenAnswer> hidden;
        bool is_coarse = false;     ///< stand-ins were drawn
        bool knows_driver = false;  ///< what the driver stores as depth was measured
        bool operator==(const Drawn&) const = default;
    };
    Drawn drawn_;
    bool views_are_behind_ = false;  ///< some view shows an earlier frame, until nothing is held
    bool camera_is_behind_ = true;   ///< the camera's does, or a coarse one

    Moment moment_;           ///< of what moves by itself
    bool moves_ = false;      ///< something does
    int settling_ = 0;        ///< frames until ImGui has laid out what changed
    bool is_frozen_ = false;  ///< the window keeps what it shows
    double frame_ms_ = 0.0;
    double redraw_in_s_ = 0.0;
};

}  // namespace viewing
