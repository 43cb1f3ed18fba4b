#include "app/minimum_gap.h"

#include <algorithm>
#include <cmath>

#include "app/fighting_measure.h"
#include "geometry/shapes.h"

namespace viewing {
namespace {

constexpr glm::ivec2 size_px(48, 48);
constexpr double most_turned_deg = 8.0;  ///< away from the eye, as the pairs of the scene `coplanar` are
constexpr double share_of_view = 0.6;    ///< of its half height: half the side of a quad
constexpr double share_of_room = 0.9;    ///< of the way to the near plane: the widest gap tried
constexpr double narrowest = 1e-12;      ///< of the distance: the smallest gap tried
constexpr int places = 8;                ///< of the pair for each gap
constexpr int halvings = 4;              ///< of the factor 2 between too narrow and wide enough

/// The state with a camera at the origin, looking along −z, and nothing that moves depth.
Params plain(const Params& state) {
    Params params;
    params.projection = state.projection;
    params.depth = state.depth;
    params.depth.clear = true;
    params.camera.position = glm::dvec3(0.0);
    params.camera.yaw = params.camera.pitch = params.camera.roll = 0.0;
    return params;
}

/// The far end of a code, next to the distance. Of a float format every distance is as good.
double far_end_of_a_code(const DepthCoding& coding, double distance) {
    if (coding.precision.is_float) return distance;
    const double levels = std::exp2(coding.precision.bits) - 1.0;
    const double code = window_depth(coding.lens, coding.mapping, distance) * levels;
    // Depth is rounded to the nearest code, so a code ends halfway to the next one; a hundredth before that is sure.
    const double end = std::min(std::floor(code), levels - 1.0) + 0.5;
    const double inside = coding.mapping == DepthMapping::reversed ? 0.01 : -0.01;
    return distance_of_window_depth(coding.lens, coding.mapping, (end + inside) / levels);
}

class GapSearch {
public:
    GapSearch(Renderer& renderer, const Params& params, double distance, WorkProgress* progress)
        : renderer_(renderer), params_(params), lens_(params.projection.lens()), progress_(progress) {
        const DepthCoding coding =
            depth_coding(params, derive(params, Scene{}, {size_px, renderer.capabilities().clip_control}));
        found_.distance = far_end_of_a_code(coding, std::clamp(distance, lens_.near, lens_.far));
        room_ = (found_.distance - lens_.near) * share_of_room;
        if (!(room_ > 0.0)) return;
        sine_ = std::min(std::sin(glm::radians(most_turned_deg)), 0.2 * room_ / half_side(found_.distance));
        found_.predicted = fighting_onset(coding, found_.distance, 2.0 * half_side(found_.distance) * sine_);
        // Rounding differs from place to place: each is many units in the last place from the next and, where codes are
        // as narrow as float32's numbers, elsewhere within its code. Wide codes are left where they are.
        const double code = found_.predicted.quantisation;  // 0 where a float's numbers are finer than a double's
        const bool is_narrow = (coding.precision.is_float || coding.precision.bits >= 24) && code > 0.0;
        for (int place = 0; place < places; ++place) {
            const double shift = place * 1.3e-6 * found_.distance;
            shifts_.push_back(is_narrow ? code * (std::floor(shift / code) + std::fmod(place * 0.37, 1.0)) : shift);
        }
    }

    Result<MinimumGap> run() {
        if (!(room_ > 0.0)) return without("Nothing fits between the near plane and the pair.");
        double wide = std::min(found_.predicted.gap(), room_);
        while (!is_wide_enough(wide)) {
            if (!error_.empty()) return Error{error_};
            if (wide >= room_) return without("Not even a surface next to the near plane is told apart everywhere.");
            wide = std::min(2.0 * wide, room_);
        }
        double narrow = wide / 2.0;
        while (is_wide_enough(narrow)) {
            if (narrow < found_.distance * narrowest) return without("However narrow the gap, no pixel was wrong.");
            wide = narrow;
            narrow /= 2.0;
        }
        for (int halving = 0; halving < halvings; ++halving) {
            const double between = std::sqrt(narrow * wide);
            (is_wide_enough(between) ? wide : narrow) = between;
        }
        if (!error_.empty()) return Error{error_};
        found_.gap = wide;
        return found_;
    }

private:
    MinimumGap without(const char* problem) const {
        MinimumGap result = found_;
        result.problem = problem;
        return result;
    }

    /// Of a quad at a distance: the same part of the view.
    double half_side(double distance) const {
        const double half_height =
            lens_.orthographic ? lens_.height / 2.0 : distance * std::tan(glm::radians(lens_.fovy_deg) / 2.0);
        return half_height * share_of_view;
    }

    /// A quad around the line of sight.
    SceneObject quad(double distance) const {
        const double turned_deg = glm::degrees(std::asin(sine_));
        SceneObject made;
        made.mesh = mesh_;
        made.world_from_model = world_from_model(glm::dvec3(0.0, 0.0, -distance), {turned_deg, 90.0 + turned_deg, 0.0},
                                                 glm::dvec3(half_side(distance)));
        return made;
    }

    bool is_wide_enough(double gap) {
        for (const double shift : shifts_)
            for (const bool front_first : {false, true})
                if (!is_told_apart(found_.distance - shift, gap, front_first)) return false;
        return true;
    }

    /// False too after an error, so that the search ends.
    bool is_told_apart(double distance, double gap, bool front_first) {
        Scene scene;
        scene.objects = {quad(distance), quad(distance - gap)};
        if (front_first) std::swap(scene.objects[0], scene.objects[1]);
        const FlatPair pair{.first = 0, .second = 1, .offset = gap};
        const auto counts = count_fighting(renderer_, params_, scene, {&pair, 1}, size_px, progress_);
        ++found_.pictures;
        if (!counts) error_ = counts.error();
        return counts && counts->pairs[0].wrong == 0 && counts->pairs[0].pixels > 0;
    }

    Renderer& renderer_;
    const Params& params_;
    const Lens lens_;
    WorkProgress* progress_;
    double room_ = 0.0;  ///< the widest gap
    double sine_ = 0.0;  ///< of the angle by which quads are turned twice: so little that they keep off the near plane
    std::vector<double> shifts_;  ///< of the pair towards the eye
    MinimumGap found_;
    std::string error_;
    const std::shared_ptr<const Mesh> mesh_ = std::make_shared<const Mesh>(quad_mesh());
};

}  // namespace

Result<MinimumGap> find_minimum_gap(Renderer& renderer, const Params& params, double distance, WorkProgress* progress) {
    const Params searched = plain(params);
    return GapSearch(renderer, searched, distance, progress).run();
}

}  // namespace viewing
