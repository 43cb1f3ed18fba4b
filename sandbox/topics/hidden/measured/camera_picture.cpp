#include "topics/hidden/measured/camera_picture.h"

#include "topics/hidden/measured/hidden_answers.h"

namespace viewing {

Result<Image> camera_picture(Renderer& renderer, const Params& params, const Scene& scene, glm::ivec2 size_px,
                             std::optional<Color> background) {
    const Viewport viewport = renderer.viewport(size_px);
    Result<FramePlan> frame = plan_at_once(renderer, params, derive(params, scene, viewport), scene, size_px);
    if (!frame) return Error{frame.error()};
    if (background) frame->background = *background;
    View view;
    if (Status drawn = renderer.draw(*frame, scene, size_px, view); !drawn) return Error{drawn.error()};
    return renderer.read(view);
}

}  // namespace viewing
