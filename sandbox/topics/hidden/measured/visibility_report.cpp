#include "topics/hidden/measured/visibility_report.h"

#include <algorithm>

#include "gl/gl.h"
#include "platform/stopwatch.h"
#include "report/as_json.h"
#include "state/fields.h"
#include "topics/hidden/measured/hidden_answers.h"
#include "topics/hidden/methods/difference.h"
#include "topics/hidden/numbers/hidden_drawing.h"

namespace viewing {
namespace {

/// Returns the time that GL needs to draw only the objects of the camera view. Draws them once beforehand, to warm up.
double time_of_gl_ms(Renderer& renderer, Params params, const Derived& derived, const Scene& scene,
                     glm::ivec2 size_px) {
    params.view.shows = Shows::color;
    FramePlan frame = plan(params, derived);
    frame.samples = 0;
    std::erase_if(frame.passes, [](const Pass& pass) {
        return pass.is_mirror_image || pass.subject != Subject::objects || pass.shading == Shading::flat;
    });
    View view;
    const auto draw = [&] {
        or_refuse(renderer.draw(frame, scene, size_px, view));
        glFinish();
    };
    draw();
    const Stopwatch watch;
    draw();
    return watch.ms();
}

/// Returns a count or a time; null if the method does not have it.
template <typename Number>
Json counter_as_json(Number counter) {
    return counter >= 0 ? Json(counter) : Json();
}

Json counters_as_json(const HiddenCounters& counters) {
    return {{"comparisons", counter_as_json(counters.comparisons)},
            {"swaps", counter_as_json(counters.swaps)},
            {"splits", counter_as_json(counters.splits)},
            {"fragments", counter_as_json(counters.fragments)},
            {"tree_depth", counter_as_json(counters.tree_depth)},
            {"pixels_tested", counter_as_json(counters.pixels_tested)},
            {"pixels_written", counter_as_json(counters.pixels_written)},
            {"overdraw", counters.pixels_tested >= 0 ? Json(counters.overdraw()) : Json()},
            {"rays", counter_as_json(counters.rays)},
            {"intersection_tests", counter_as_json(counters.intersection_tests)}};
}

Json culling_as_json(const Params& params, const Viewpoint& viewpoint, const std::vector<Polygon>& polygons) {
    const CullCounts counts = count_facing(polygons, viewpoint, params.cull.front_face);
    const std::size_t left = culled(polygons, viewpoint, params.cull.face, params.cull.front_face).size();
    return {{"enabled", params.cull.enabled},
            {"face", name_of(params.cull.face)},
            {"front_face", name_of(params.cull.front_face)},
            {"by_plane", {{"front", counts.facing_towards}, {"back", counts.facing_away}, {"edge_on", counts.edge_on}}},
            {"by_winding", {{"front", counts.gl_front}, {"back", counts.gl_back}, {"not_drawn", counts.gl_none}}},
            {"disagree", counts.disagree},
            {"before", counts.input},
            {"after", left}};
}

/// Measures one state with each method in turn.
class Measurement {
public:
    Measurement(Renderer& renderer, const Params& params, const Scene& scene, glm::ivec2 size_px)
        : renderer_(renderer),
          params_(params),
          scene_(scene),
          derived_(derive(params, scene, renderer.viewport(size_px))),
          request_(hidden_request(params, derived_, size_px)),
          solver_(scene),
          objects_(solver_.surface()->object_of_source()) {
        request_.visibility.step = -1;
        request_.visibility.method = reference_method;
        HiddenRequest triangles = request_;
        triangles.visibility.exact_curves = false;
        reference_ = solver_.solve(triangles)->image;
    }

    Json all() {
        const auto& polygons = solver_.surface()->polygons;
        Json methods = Json::object();
        const std::span<const char* const> names = names_of<VisibilityMethod>();
        for (std::size_t index = 0; index < names.size(); ++index)
            methods[names[index]] = of_method(static_cast<VisibilityMethod>(index));
        return {{"scene", scene_name(params_)},
                {"size", as_json(request_.size_px)},
                {"polygons", polygons.size()},
                {"dropped", solver_.surface()->dropped},
                {"methods", std::move(methods)},
                {"painter_keys", painter_keys()},
                {"culling", culling_as_json(params_, request_.viewpoint, polygons)}};
    }

private:
    Json of_method(VisibilityMethod method) {
        request_.visibility.method = method;
        const auto result = solver_.solve(request_);
        double time_ms = result->time_ms;
        if (is_drawn_by_gl_alone(method)) {
            Params params = params_;
            params.visibility = request_.visibility;
            time_ms = time_of_gl_ms(renderer_, params, derived_, scene_, request_.size_px);
        }
        Json row{{"time_ms", time_ms},
                 {"painting_ms", counter_as_json(result->painting_ms)},
                 {"build_ms", counter_as_json(result->build_ms)}};
        row.update(counters_as_json(result->counters));
        row["wrong_pixels"] = wrong_pixels(*result);
        row["problem"] = result->problem.empty() ? Json() : Json(say(result->problem));
        return row;
    }

    Json painter_keys() {
        request_.visibility.method = VisibilityMethod::painter;
        Json wrong = Json::object();
        const std::span<const char* const> names = names_of<PainterKey>();
        for (std::size_t index = 0; index < names.size(); ++index) {
            request_.visibility.sort_key = static_cast<PainterKey>(index);
            wrong[names[index]] = wrong_pixels(*solver_.solve(request_));
        }
        return wrong;
    }

    /// Counts the pixels that differ from the reference. The polygons of exact curves are numbered differently, so
    /// objects are compared instead.
    std::int64_t wrong_pixels(const HiddenResult& result) {
        const IdImage image = or_refuse(polygon_ids_drawn(renderer_, params_, derived_, scene_, result));
        if (!uses_exact_curves(result.request)) return difference_from_drawn(reference_, image, result).different;
        return difference(with_ids(reference_, objects_), with_ids(image, objects_)).different;
    }

    Renderer& renderer_;
    const Params& params_;
    const Scene& scene_;
    const Derived derived_;
    HiddenRequest request_;  ///< for the method being measured
    HiddenSurfaceSolver solver_;
    const std::vector<int> objects_;
    IdImage reference_;
};

}  // namespace

Result<Json> visibility_as_json(Renderer& renderer, const Params& params, const Scene& scene, glm::ivec2 size_px) {
    return guarded([&] { return Measurement(renderer, params, scene, size_px).all(); });
}

}  // namespace viewing
