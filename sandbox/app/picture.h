// Draws one picture of a state without a window, for `snapshot` and for tests. The same code draws the window on
// screen.
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
#include "topics/hidden/shown/growth_view.h"

namespace viewing {

/// A step of a lesson, shown as in the window.
struct LessonPicture {
    Lesson lesson;
    std::size_t step = 0;  ///< counted from 0
    bool revealed = false;
    bool presents = false;          ///< shows the step as the audience sees it
    bool has_strip = true;          ///< shows the lesson strip with the step's texts
    std::string code_address = {};  ///< adds the QR code of a link that begins with this address; "": no code
    bool ends = false;              ///< shows the card that follows the step
};

/// The content of a picture: the whole window, the camera's picture or one of its buffers, or another view by itself
/// (the matrices, or a topic of the lower views). `derivation` is the mirror's derivation if the state shows that one,
/// otherwise the shadow's.
#define VIEWING_PICTURE_VIEWS(VIEW) \
    VIEW(window)                    \
    VIEW(camera) VIEW(depth) VIEW(stencil) VIEWING_LOWER_VIEWS(VIEW, VIEWING_NOTHING) VIEW(matrices) VIEW(derivation)
enum class PictureView { VIEWING_PICTURE_VIEWS(VIEWING_ENUMERATOR) };
inline constexpr std::array picture_view_names{VIEWING_PICTURE_VIEWS(VIEWING_NAME)};

struct PictureRequest {
    PictureView view = PictureView::window;
    glm::ivec2 size_px{1280, 720};
    std::optional<int> samples = {};                   ///< 0 or 4; empty: the state's; always 0 for depth and stencil
    std::shared_ptr<const LessonPicture> lesson = {};  ///< for the whole window; the state is then the step's
    bool presents = false;     ///< for the whole window: shows it as an audience would see it, even without a lesson
    bool labels = false;       ///< for the camera's picture: adds the window's overlay and the second picture
    bool transparent = false;  ///< makes the bare background transparent
    double dpi = usual_dpi;    ///< text has the same height in points at any dpi
};

/// Returns the state of a step and sets `request` to show it. A picture of the window shows the lesson itself; for
/// other views of a revealed step, returns the state after its answer.
LoadedState show_step(LessonPicture step, PictureRequest& request);

/// Returns the parameters with the request's samples and with the settings that its view needs. The picture's file
/// stores the result.
Params drawn_params(Params params, const PictureRequest& request);

/// Checks whether the view can be drawn at this size: is_image_size() must be true, and the window and its views must
/// have enough space. The error completes a sentence that begins with the option or field that sets the size.
Status check_picture_size(PictureView view, glm::ivec2 size_px);

/// Whether the picture contains no user interface.
bool is_drawn_by_gl(const PictureRequest& request);

/// Draws a picture; needs a current context. If it contains any user interface, draws frames until two in a row are
/// equal.
Result<Image> draw_picture(Renderer& renderer, const LoadedState& state, const Scene& scene,
                           const PictureRequest& request);

/// Redraws the cost chart that a view shows, at a printable size: 1920 pixels wide.
Result<Image> draw_growth_chart(Renderer& renderer, const Session& session, const GrowthViewState& shown);

}  // namespace viewing
