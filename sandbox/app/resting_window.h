// A window without a screen that is drawn until it rests: what pictures and figures of the user interface are taken
// from.
#pragma once

#include "app/picture.h"
#include "app/studio.h"
#include "image/matte.h"

namespace viewing {

/// The longest that the user interface may need to come to rest: ImGui lays out in two frames, sections in one more.
inline constexpr int most_frames = 12;

/// One view alone, with nothing that can only be pressed, or the whole window; the pointer is nowhere.
void show(Studio& studio, ViewName maximised);

class RestingWindow {
public:
    /// Needs a current context. `ground`: see Studio::set_ground.
    RestingWindow(Renderer& renderer, const LoadedState& state, const Scene& scene,
                  std::optional<Color> ground = std::nullopt);

    /// Draws what is asked for until two frames are equal. Where a view by itself would have to be scrolled or cut,
    /// everything in it is drawn smaller until all of it is seen, and larger where it leaves room. The error is what
    /// the window says, or that the size is too small for that and which one is not.
    Status rest(const PictureRequest& request);

    /// Whether nothing is cut off or has to be scrolled.
    bool fits() const;

    Image read() const { return studio_.read(); }
    /// The same as shapes, text and pictures; draws it once more.
    Drawing record();

private:
    Status settle();
    /// What it shows now, without its pictures.
    Drawing sketch() const;
    /// Finds the size at which all is drawn.
    Status fit();
    /// Finds the height that has room for all of it.
    std::string too_small(glm::ivec2 size_px);

    Studio studio_;
    Studio::Surroundings surroundings_;  ///< in which it rests
};

/// What `draw` makes of the state as the request has it: once, or, where it is to be transparent, on black and on
/// white, of which what is no ground is left.
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

/// The topic of the lower views that a view shows by itself; automatic for all that are none.
Topic topic_of(PictureView view, const Params& params);

}  // namespace viewing
