// Scans the orbit coarsely, then takes small steps from the worst view. Read bsp_build.cpp next.
#include "topics/hidden/methods/failure_search.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/camera.h"
#include "text/catalogue.h"
#include "topics/hidden/methods/difference.h"
#include "topics/hidden/methods/ray_cast.h"
#include "topics/hidden/methods/software_zbuffer.h"

namespace viewing {
namespace {

constexpr int yaws_round = 24;
constexpr double yaw_step_deg = 360.0 / yaws_round, pitch_step_deg = 10.0, steepest_deg = 89.0;
constexpr std::array further_pitches_deg{-12.0, -32.0, -58.0};
constexpr std::array refining_steps_deg{6.0, 3.0, 1.5, 0.75};
constexpr int views_of_a_scan = yaws_round * (1 + static_cast<int>(further_pitches_deg.size()));
constexpr int most_views = 2 * views_of_a_scan + 4 * static_cast<int>(refining_steps_deg.size());

double wrapped(double yaw_deg) {
    const double yaw = std::remainder(yaw_deg, 360.0);
    return yaw <= -180.0 ? 180.0 : yaw;
}

bool is_finite(const Orbit& orbit, const OrbitView& view) {
    double sum = orbit.target_world.x + orbit.target_world.y + orbit.target_world.z + orbit.distance + view.yaw_deg +
                 view.pitch_deg;
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) sum += orbit.clip_from_view[column][row];
    }
    return std::isfinite(sum);
}

Message name_of(PainterKey key) {
    switch (key) {
        case PainterKey::nearest:
            return message("the nearest vertex");
        case PainterKey::farthest:
            return message("the farthest vertex");
        case PainterKey::centroid:
            return message("the centroid");
    }
    return {};
}

class Search {
public:
    Search(std::span<const Polygon> polygons, const Orbit& orbit, const FailureSearchOptions& options,
           WorkProgress* progress)
        : polygons_(polygons), orbit_(orbit), options_(options), progress_(progress), rays_(polygons, {}, progress) {
        start_ = {wrapped(options.start.yaw_deg), std::clamp(options.start.pitch_deg, -steepest_deg, steepest_deg)};
        worst_.view = start_;
    }

    FailureView run() {
        scan(start_);
        if (worst_.wrong_pixels == 0) {
            scan({start_.yaw_deg + 0.5 * yaw_step_deg, start_.pitch_deg + 0.5 * pitch_step_deg});
        }
        if (worst_.wrong_pixels > 0) refine();
        worst_.found = worst_.wrong_pixels > 0;
        worst_.position_world = eye_on_orbit(orbit_, worst_.view);
        return worst_;
    }

private:
    /// Scans the full circle at several pitches, beginning with the views nearest to `start`.
    void scan(const OrbitView& start) {
        const double pitch_shift = start.pitch_deg - start_.pitch_deg;
        round(start);
        for (const double pitch : further_pitches_deg) round({start.yaw_deg, pitch + pitch_shift});
    }

    void round(const OrbitView& start) {
        for (int i = 0; i < yaws_round; ++i) {
            const int turns = i % 2 == 0 ? -i / 2 : (i + 1) / 2;
            attempt({start.yaw_deg + turns * yaw_step_deg, start.pitch_deg});
        }
    }

    void refine() {
        for (const double step : refining_steps_deg) {
            for (const OrbitView& turn : {OrbitView{step, 0}, OrbitView{-step, 0}, {0, step}, {0, -step}}) {
                attempt({worst_.view.yaw_deg + turn.yaw_deg, worst_.view.pitch_deg + turn.pitch_deg});
            }
        }
    }

    void attempt(OrbitView view) {
        worst_.canceled = worst_.canceled || is_canceled(progress_);
        if (worst_.canceled) return;
        view = {wrapped(view.yaw_deg), std::clamp(view.pitch_deg, -steepest_deg, std::max(start_.pitch_deg, 0.0))};
        const std::int64_t wrong = wrong_pixels(viewpoint_on_orbit(orbit_, view));
        if (wrong > worst_.wrong_pixels) {
            worst_.wrong_pixels = wrong;
            worst_.view = view;
        }
        ++worst_.views_tried;
        report(progress_, static_cast<double>(worst_.views_tried) / most_views);
    }

    std::int64_t wrong_pixels(const Viewpoint& viewpoint) const {
        const glm::dmat4 clip_from_world = viewpoint.clip_from_world();
        const RayCastResult reference =
            cast_rays(rays_, clip_from_world, {.width = options_.width, .height = options_.height});
        const PainterOrder painter = painter_order(polygons_, viewpoint, options_.key);
        const RasterResult painted =
            rasterize(polygons_, painter.order, clip_from_world,
                      {.rule = PaintRule::overwrite, .width = options_.width, .height = options_.height});
        return difference(reference.image, painted.image).different;
    }

    std::span<const Polygon> polygons_;
    const Orbit& orbit_;
    const FailureSearchOptions& options_;
    WorkProgress* progress_;
    RayScene rays_;
    OrbitView start_;
    FailureView worst_;
};

Message sentence_of(const FailureView& result, PainterKey key) {
    const Message key_name = name_of(key);
    if (!result.found && result.canceled)
        return message(
            "The search was canceled; up to then, sorting by {key} was correct in every view. Views tried: {views}.",
            "views"_a = result.views_tried, "key"_a = key_name);
    if (!result.found)
        return message("No view found where sorting by {key} fails. Views tried: {views}.", "key"_a = key_name,
                       "views"_a = result.views_tried);
    const char* const sentence = result.canceled
                                     ? marked(
                                           "Sorting by {key} gets about {share} of the picture wrong at yaw {yaw}°, "
                                           "pitch {pitch}°. Views tried before the search was canceled: {views}.")
                                     : marked(
                                           "Sorting by {key} gets about {share} of the picture wrong at yaw {yaw}°, "
                                           "pitch {pitch}°. Views tried: {views}.");
    // The search uses small pictures, so a count of their pixels would not match the count in the view.
    const double share = static_cast<double>(result.wrong_pixels) / static_cast<double>(result.compared);
    return message(fmt::runtime(sentence), "key"_a = key_name, "share"_a = percent(share),
                   "yaw"_a = number_text(result.view.yaw_deg, 1), "pitch"_a = number_text(result.view.pitch_deg, 1),
                   "views"_a = result.views_tried);
}

}  // namespace

glm::dvec3 eye_on_orbit(const Orbit& orbit, const OrbitView& view) {
    const glm::dmat4 rotation = rotation_from_angles({view.yaw_deg, view.pitch_deg, 0.0});
    return orbit.target_world + orbit.distance * glm::dvec3(rotation[2]);
}

Viewpoint viewpoint_on_orbit(const Orbit& orbit, const OrbitView& view) {
    const Angles angles{view.yaw_deg, view.pitch_deg, 0.0};
    return {view_from_world(world_from_view(eye_on_orbit(orbit, view), angles)), orbit.clip_from_view};
}

FailureView find_failure(std::span<const Polygon> polygons, const Orbit& orbit, const FailureSearchOptions& options,
                         WorkProgress* progress) {
    const bool has_pixels = options.width > 0 && options.height > 0;
    if (polygons.empty() || !has_pixels || !is_finite(orbit, options.start)) {
        FailureView nothing;
        nothing.view = options.start;
        nothing.sentence = polygons.empty() ? message("There are no polygons that could be sorted wrongly.")
                           : !has_pixels    ? message("There are no pixels to compare.")
                                            : message("The camera's orbit is not finite: no view was tried.");
        return nothing;
    }
    FailureView result = Search(polygons, orbit, options, progress).run();
    result.compared = static_cast<std::int64_t>(options.width) * options.height;
    result.sentence = sentence_of(result, options.key);
    return result;
}

}  // namespace viewing
