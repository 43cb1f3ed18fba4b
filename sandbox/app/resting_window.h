// A window without a screen, drawn until nothing changes: the source of pictures and figures with user interface.
#pragma once

#include "app/picture.h"
#include "app/studio.h"
#include "image/matte.h"

namespace viewing {

/// The maximum number of frames until the user interface settles: ImGui needs two for its layout, sections one more.
inline constexpr int most_frames = 12;

/// Shows one view alone, without controls that only make sense on screen, or the whole window; there is no pointer.
void show(Studio& studio, ViewName maximized);

class RestingWindow {
public:
    /// Needs a current context. `ground`: see Studio::set_ground.
    RestingWindow(Renderer& renderer, const LoadedState& state, const Scene& scene,
                  std::optional<Color> ground = std::nullopt);

    /// Draws the requested view until two frames are equal. If a view by itself would have to scroll or be cut off, its
    /// contents are drawn smaller until all of it is visible; if it leaves space, larger. The error is the window's own
    /// message, or says that the size is too small and which one would do.
    Status rest(const PictureRequest& request);

    /// Whether everything is visible without cuts or scrolling.
    bool fits() const;

    Image read() const { return studio_.read(); }
    /// Returns the window as shapes, text and pictures; draws it once more.
    Drawing record();

private:
    Status settle();
    /// Returns the current window as shapes and text, without its pictures.
    Drawing sketch() const;
    /// Finds the scale at which everything fits.
    Status fit();
    /// Finds the height at which everything fits, and returns the error that names it.
    std::string too_small(glm::ivec2 size_px);

    Studio studio_;
    Studio::Surroundings surroundings_;  ///< size and scale; no input
};

/// Calls `draw` on the state with the request's changes applied: once, or, for a transparent picture, on black and on
/// white, to remove the background.
template <typename Draw>
auto drawn_without_ground(const LoadedState& state, const PictureRequest& request, const Draw& draw)
    -> decltype(draw(state, std::optional<Color>())) {
    LoadedState wanted = state;
    wanted.params = drawn_params(state.params, request);
    if (!request.transparent) return draw(wanted, std::nullopt);
    auto on_black = draw(wanted, Color{0, 0, 0});
    if (!on_black) return on_black;
    const auto on_white = draw(wanted, Color{255, 255, 255});
    if (!on_white) return on_white;
    return without_ground(*on_black, *on_white);
}

/// Returns the topic of the lower view that `view` shows by itself; automatic for views without one.
Topic topic_of(PictureView view, const Params& params);

}  // namespace viewing
