#include "app/figure.h"

#include "app/resting_window.h"

namespace viewing {
namespace {

/// A picture alone, as large as the drawing.
Drawing drawing_of(Image image) {
    const glm::vec2 size(image.width, image.height);
    const DrawingBox box{glm::vec2(0.0F), size};
    return {size, {{box, Inset{std::make_shared<const Image>(std::move(image)), box, box, {}, {255, 255, 255, 255}}}}};
}

Result<Drawing> draw_on(Renderer& renderer, const LoadedState& state, const Scene& scene, const PictureRequest& request,
                        std::optional<Color> ground) {
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
    LoadedState wanted = state;
    wanted.params = drawn_params(state.params, request);
    if (!request.transparent) return draw_on(renderer, wanted, scene, request, std::nullopt);
    const Result<Drawing> on_black = draw_on(renderer, wanted, scene, request, Color{0, 0, 0});
    if (!on_black) return on_black;
    const Result<Drawing> on_white = draw_on(renderer, wanted, scene, request, Color{255, 255, 255});
    if (!on_white) return on_white;
    return without_ground(*on_black, *on_white);
}

}  // namespace viewing
