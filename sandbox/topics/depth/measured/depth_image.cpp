#include "topics/depth/measured/depth_image.h"

#include "frame/derive.h"
#include "render/buffer_read.h"
#include "topics/hidden/measured/hidden_answers.h"

namespace viewing {

Result<DepthImage> depth_image(Renderer& renderer, Params params, const Scene& scene, glm::ivec2 size_px) {
    params.view.samples = 0;
    params.view.shows = Shows::color;
    const Derived derived = derive(params, scene, renderer.viewport(size_px, params.depth.format));
    Result<FramePlan> frame = plan_at_once(renderer, params, derived, scene, size_px);
    if (!frame) return Error{frame.error()};
    frame->samples = 0;
    Result<BufferReader> reader = BufferReader::make(renderer.capabilities());
    if (!reader) return Error{reader.error()};
    View view;
    if (const Status drawn = renderer.draw(*frame, scene, size_px, view); !drawn) return Error{drawn.error()};
    DepthImage image{size_px.x, size_px.y, {}};
    for (const StoredPixel& pixel : reader->stored(view, params.depth.format, {{0, 0}, size_px}))
        image.depths.push_back(pixel.window_depth);
    return image;
}

}  // namespace viewing
