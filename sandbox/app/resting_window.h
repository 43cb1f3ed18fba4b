// A window without a screen, which is drawn until nothing changes. It is the source of all pictures and figures that
// show the user interface.
#pragma once

#include "app/picture.h"
#include "app/studio.h"
#include "image/matte.h"
#include "lesson/questions/seen_answer.h"

namespace viewing {

/// The user interface must settle within this number of frames: ImGui needs two for its layout, and sections need one
/// more.
inline constexpr int most_frames = 12;

/// Shows the whole window, or one view alone without the controls that make sense only on screen. Hides the pointer.
void show(Studio& studio, ViewName maximized);

class RestingWindow {
public:
    /// Needs a current context. `ground`: see Studio::set_ground.
    RestingWindow(Renderer& renderer, const LoadedState& state, const Scene& scene,
                  std::optional<Color> ground = std::nullopt);

    /// Lays out the requested view until two frames in a row are equal. If a view by itself would have to scroll or be
    /// cut off, draws its contents smaller until all of them are visible; if they leave space, draws them larger. The
    /// error is the window's own message, or says that the size is too small and names one that is large enough.
    Status rest(const PictureRequest& request);

    /// Whether everything is visible without cuts or scrolling.
    bool fits() const;

    Image read() { return studio_.read(); }
    Layout layout() const;
    /// Draws the window once more and returns it as shapes, text and pictures.
    Drawing record();
    /// Draws the window once more and returns its visible texts, line by line.
    std::vector<SeenText> texts();

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

/// Calls `draw` with the state, changed as the request requires. For a transparent picture, calls `draw` twice, with a
/// black and with a white background, and removes the background.
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

/// Returns the topic that `view` shows by itself in a lower view; Topic::automatic if it shows none.
Topic topic_of(PictureView view, const Params& params);

}  // namespace viewing
