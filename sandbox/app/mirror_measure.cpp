#include "app/mirror_measure.h"

#include <algorithm>
#include <set>

#include "frame/pixel_report.h"

namespace viewing {
namespace {

FramePlan plan_of(const Params& state, MirrorWay way, const Scene& scene, const Viewport& viewport) {
    Params params = probed(mirrored_in(state, way));
    params.view.samples = 0;
    params.view.call = params.view.triangle = params.view.pass = -1;
    return plan(params, derive(params, scene, viewport));
}

/// The pass after which the first image is there and its mirror not yet; −1 without a mirror.
int last_pass_of_image(const FramePlan& frame) {
    const auto first = std::ranges::find_if(frame.passes, &Pass::is_mirror_image);
    if (first == frame.passes.end()) return -1;
    const auto after = std::find_if(first, frame.passes.end(), [](const Pass& pass) { return !pass.is_mirror_image; });
    return static_cast<int>(after - frame.passes.begin()) - 1;
}

/// The depths that the image leaves inside its mask.
Status read_depths(Renderer& renderer, BufferReader& reader, FramePlan frame, const Scene& scene, glm::ivec2 size_px,
                   MirrorWayReport& report) {
    frame.limit.pass = last_pass_of_image(frame);
    if (frame.limit.pass < 0) return std::monostate{};
    const int region = frame.passes[static_cast<std::size_t>(frame.limit.pass)].stencil.reference;
    View view;
    if (Status drawn = renderer.draw(frame, scene, size_px, view); !drawn) return drawn;
    std::set<std::uint32_t> codes;
    for (const StoredPixel& pixel : reader.stored(view, frame.depth_format, {{0, 0}, size_px})) {
        const bool is_inside = region == 0 || (pixel.stencil & stencil_region_bits) == region;
        if (!is_inside || pixel.window_depth == frame.clear_depth_value) continue;
        const bool is_first = report.image_pixels++ == 0;
        report.first_depth = is_first ? pixel.window_depth : std::min(report.first_depth, pixel.window_depth);
        report.last_depth = is_first ? pixel.window_depth : std::max(report.last_depth, pixel.window_depth);
        codes.insert(pixel.code);
    }
    report.distinct_depths = static_cast<std::int64_t>(codes.size());
    return std::monostate{};
}

/// Lays what differs over the picture.
void show_difference(FramePlan& frame, DifferenceDrawing drawing) {
    frame.hidden.difference = std::make_shared<const DifferenceDrawing>(std::move(drawing));
    Pass pass;
    pass.name = "Difference";
    pass.reason = "red where the picture differs from the first way's, a veil elsewhere";
    pass.subject = Subject::difference;
    pass.shading = Shading::flat;
    pass.depth = {false, CompareFunc::always, false};
    pass.blend = Blend::alpha;
    frame.passes.push_back(pass);
}

}  // namespace

Result<MirrorWays> compare_mirror_ways(Renderer& renderer, const Params& state, const Scene& scene, glm::ivec2 size_px,
                                       std::array<View, mirror_way_count>* pictures) {
    Result<BufferReader> reader = BufferReader::make(renderer.capabilities());
    if (!reader) return Error{reader.error()};
    const Viewport viewport{size_px, renderer.capabilities().clip_control};
    MirrorWays ways{.size_px = size_px, .reports = {}};
    Image reference;
    for (std::size_t index = 0; index < mirror_way_count; ++index) {
        FramePlan frame = plan_of(state, static_cast<MirrorWay>(index), scene, viewport);
        View own;
        View& view = pictures ? (*pictures)[index] : own;
        if (Status drawn = renderer.draw(frame, scene, size_px, view); !drawn) return Error{drawn.error()};
        Image picture = renderer.read(view);
        if (index == 0) reference = picture;
        PictureDifference found = picture_difference(reference.rgba, picture.rgba, size_px);
        ways.reports[index] = found.report;
        if (Status read = read_depths(renderer, *reader, frame, scene, size_px, ways.reports[index]); !read)
            return Error{read.error()};
        if (!pictures || index == 0) continue;
        show_difference(frame, std::move(found.drawing));
        if (Status drawn = renderer.draw(frame, scene, size_px, view); !drawn) return Error{drawn.error()};
    }
    return ways;
}

}  // namespace viewing
