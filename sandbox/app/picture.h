// One picture of a state, without a window: what `snapshot` writes and what tests look at. The same code draws the
// window on screen.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "image/png.h"
#include "lesson/lesson.h"
#include "render/renderer.h"
#include "session/session.h"
#include "state/presets.h"
#include "state/scene.h"
#include "ui/hidden/growth_view.h"

namespace viewing {

/// A step of a lesson as the window shows it.
struct LessonPicture {
    Lesson lesson;
    std::size_t step = 0;  ///< from 0 on
    bool revealed = false;
    bool presents = false;  ///< as a room sees it
    bool has_strip = true;  ///< with its texts
};

/// The whole window, the camera's picture or its buffers, and each other view by itself: the matrices, and the topics
/// of the lower views. `derivation` is the mirror's where the state shows that one, else the shadow's.
enum class PictureView {
    window,
    camera,
    depth,
    stencil,
    observer,
    matrices,
    derivation,
    shadow_derivation,
    mirror_derivation,
    tree,
    order,
    precision,
    codes,
    histogram,
    cells,
    pixel,
    fighting,
    passes,
    moving_world,
    from_light,
    mirror_ways,
    lecture_code,
    display_code
};
/// In that order.
inline constexpr std::array picture_view_names{"window",
                                               "camera",
                                               "depth",
                                               "stencil",
                                               "observer",
                                               "matrices",
                                               "derivation",
                                               "shadow_derivation",
                                               "mirror_derivation",
                                               "tree",
                                               "order",
                                               "precision",
                                               "codes",
                                               "histogram",
                                               "cells",
                                               "pixel",
                                               "fighting",
                                               "passes",
                                               "moving_world",
                                               "from_light",
                                               "mirror_ways",
                                               "lecture_code",
                                               "display_code"};

struct PictureRequest {
    PictureView view = PictureView::window;
    glm::ivec2 size_px{1280, 720};
    std::optional<int> samples = {};  ///< 0 or 4; left out: as the state says. Depth and stencil always 0.
    std::shared_ptr<const LessonPicture> lesson = {};  ///< of the whole window; the state is then the step's
    bool labels = false;       ///< of the camera's picture: what the window draws over it, and the picture beside it
    bool transparent = false;  ///< nothing where there is only ground
    double dpi = usual_dpi;    ///< type has the same height in points with any of them
};

/// The state of a step, which `request` then shows: a picture of the window with the lesson itself. Elsewhere a
/// revealed step is the state after its answer.
LoadedState show_step(LessonPicture step, PictureRequest& request);

/// The parameters with what the request says itself: its samples, and what its view shows. What a picture carries.
Params drawn_params(Params params, const PictureRequest& request);

/// Whether the view can be drawn at this size: is_image_size, and the window and its views need room. One sentence, to
/// be read behind the name of what says the size.
Status check_picture_size(PictureView view, glm::ivec2 size_px);

/// Whether nothing of the user interface is in it.
bool is_drawn_by_gl(const PictureRequest& request);

/// Needs a current context. Draws until two frames are equal where the user interface is part of the picture.
Result<Image> draw_picture(Renderer& renderer, const LoadedState& state, const Scene& scene,
                           const PictureRequest& request);

/// The chart of the costs that a view shows, drawn anew at a size that can be printed: 1920 pixels wide.
Result<Image> draw_growth_chart(Renderer& renderer, const Session& session, const GrowthViewState& shown);

}  // namespace viewing
