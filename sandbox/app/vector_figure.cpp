#include "app/vector_figure.h"

#include "app/resting_window.h"

namespace viewing {
namespace {

/// Returns a drawing that contains only this picture and has its size.
Drawing drawing_of(Image image) {
    const glm::vec2 size(image.width, image.height);
    const DrawingBox box{glm::vec2(0.0F), size};
    return {size, {{box, Inset{std::make_shared<const Image>(std::move(image)), box, box, {}, {255, 255, 255, 255}}}}};
}

Result<Drawing> record_on(Renderer& renderer, const LoadedState& state, const Scene& scene,
                          const PictureRequest& request, std::optional<Color> ground) {
    RestingWindow window(renderer, state, scene, ground);
    if (Status rests = window.rest(request); !rests) return Error{rests.error()};
    return window.record();
}

}  // namespace

Result<Drawing> draw_figure(Renderer& renderer, const LoadedState& state, const Scene& scene,
                            const PictureRequest& request) {
    if (is_drawn_by_gl(request)) {
        Result<Image> image = draw_picture(renderer, state, scene, request);
        if (!image) return Error{image.error()};
        return drawing_of(*std::move(image));
    }
    return drawn_without_ground(state, request, [&](const LoadedState& wanted, std::optional<Color> ground) {
        return record_on(renderer, wanted, scene, request, ground);
    });
}

}  // namespace viewing
