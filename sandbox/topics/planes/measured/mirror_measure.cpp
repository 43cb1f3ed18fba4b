#include "topics/planes/measured/mirror_measure.h"

#include <algorithm>
#include <set>

#include "image/compare.h"
#include "text/catalogue.h"
#include "topics/hidden/numbers/hidden_drawing.h"

namespace viewing {
namespace {

/// Returns the plan for one of the ways, with GL's depth buffer and in color, whatever the state's own view shows.
FramePlan plan_of(const Params& state, MirrorWay way, const Scene& scene, const Viewport& viewport) {
    Params params = mirrored_in(state, way);
    params.visibility = {};
    params.view = ViewParams{};
    params.view.samples = 0;
    return plan(params, derive(params, scene, viewport));
}

/// Returns the frame up to and including the first mirror image, without the mirror itself. If there is no mirror, the
/// frame has no passes.
FramePlan until_image(FramePlan frame) {
    const auto first =
        std::find_if(frame.passes.begin(), frame.passes.end(), [](const Pass& pass) { return pass.is_mirror_image; });
    const auto after = std::find_if(first, frame.passes.end(), [](const Pass& pass) { return !pass.is_mirror_image; });
    frame.passes.erase(after, frame.passes.end());
    if (frame.passes.empty() || !frame.passes.back().is_mirror_image) {
        frame.passes.clear();
    } else if (!frame.passes.back().stencil.test) {  // no stencil bit marks the image's own pixels
        std::erase_if(frame.passes, [](const Pass& pass) { return !pass.is_mirror_image; });
    }
    return frame;
}

/// Reads the depths that the first mirror image writes inside its stencil mask.
Status read_depths(Renderer& renderer, BufferReader& reader, const FramePlan& whole, const Scene& scene,
                   glm::ivec2 size_px, MirrorWayReport& report) {
    const FramePlan frame = until_image(whole);
    if (frame.passes.empty()) return std::monostate{};
    const StencilState& mask = frame.passes.back().stencil;
    View view;
    if (Status drawn = renderer.draw(frame, scene, size_px, view); !drawn) return drawn;
    std::set<std::uint32_t> codes;
    for (const StoredPixel& pixel : reader.stored(view, frame.depth_format, {{0, 0}, size_px})) {
        const bool is_inside = !mask.test || (pixel.stencil & mask.read_bits) == mask.reference;
        if (!is_inside || pixel.window_depth == frame.clear_depth_value) continue;
        const bool is_first = report.image_pixels++ == 0;
        report.first_depth = is_first ? pixel.window_depth : std::min(report.first_depth, pixel.window_depth);
        report.last_depth = is_first ? pixel.window_depth : std::max(report.last_depth, pixel.window_depth);
        codes.insert(pixel.code);
    }
    report.distinct_depths = static_cast<std::int64_t>(codes.size());
    return std::monostate{};
}

/// Marks the pixels that differ from the first way's picture; an edge that moved by a pixel does not count.
std::vector<std::uint8_t> differing(const Image& reference, const Image& picture, MirrorWayReport& report) {
    constexpr CompareOptions alike{.worst = 2, .share = 0.0, .reach_px = 1};
    std::vector<std::uint8_t> pixels = pixel_differences(reference, picture, alike);
    report.compared = static_cast<std::int64_t>(pixels.size());
    for (std::uint8_t& pixel : pixels) {
        if (pixel <= alike.worst) {
            pixel = 0;
            continue;
        }
        ++report.different;
        report.worst = std::max<int>(report.worst, pixel);
    }
    return pixels;
}

/// Draws the differences over the picture.
void show_difference(FramePlan& frame, std::span<const std::uint8_t> differs, glm::ivec2 size_px) {
    frame.hidden.difference = std::make_shared<const DifferenceDrawing>(difference_drawing(differs, size_px));
    frame.passes.push_back(
        difference_pass(message("red where the picture differs from the first method's, dimmed elsewhere")));
}

}  // namespace

Result<MirrorWays> compare_mirror_ways(Renderer& renderer, const Params& state, const Scene& scene, glm::ivec2 size_px,
                                       std::array<View, mirror_way_count>* pictures) {
    Result<BufferReader> reader = BufferReader::make(renderer.capabilities());
    if (!reader) return Error{reader.error()};
    const Viewport viewport = renderer.viewport(size_px);
    MirrorWays ways{.size_px = size_px, .reports = {}};
    Image reference;
    for (std::size_t index = 0; index < mirror_way_count; ++index) {
        FramePlan frame = plan_of(state, static_cast<MirrorWay>(index), scene, viewport);
        View own;
        View& view = pictures ? (*pictures)[index] : own;
        if (Status drawn = renderer.draw(frame, scene, size_px, view); !drawn) return Error{drawn.error()};
        Image picture = renderer.read(view);
        if (index == 0) reference = picture;
        const std::vector<std::uint8_t> differs = differing(reference, picture, ways.reports[index]);
        if (Status read = read_depths(renderer, *reader, frame, scene, size_px, ways.reports[index]); !read)
            return Error{read.error()};
        if (!pictures || index == 0) continue;
        show_difference(frame, differs, size_px);
        if (Status drawn = renderer.draw(frame, scene, size_px, view); !drawn) return Error{drawn.error()};
    }
    return ways;
}

}  // namespace viewing
