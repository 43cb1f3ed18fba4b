// A window without a screen that is drawn until it rests: what pictures and figures of the user interface are taken
// from.
#pragma once

#include "app/picture.h"
#include "app/studio.h"

namespace viewing {

class RestingWindow {
public:
    /// Needs a current context. `ground`: see Studio::set_ground.
    RestingWindow(Renderer& renderer, const LoadedState& state, const Scene& scene,
                  std::optional<Color> ground = std::nullopt);

    /// Draws what is asked for until two frames are equal. Where a view by itself would have to be scrolled, everything
    /// in it is drawn smaller until all of it is seen. The error is what the window says, or that the size is too
    /// small for that and which one is not.
    Status rest(const PictureRequest& request);

    Image read() const { return studio_.read(); }
    /// The same as shapes, text and pictures; draws it once more.
    Drawing record();

private:
    Status settle();
    /// Finds the height that has room for all of it.
    std::string too_small(glm::ivec2 size_px);

    Studio studio_;
    Studio::Surroundings surroundings_;  ///< in which it rests
};

/// The topic of the lower views that a view shows by itself; automatic for all that are none.
Topic topic_of(PictureView view, const Params& params);

}  // namespace viewing
