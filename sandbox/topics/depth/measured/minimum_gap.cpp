#include "topics/depth/measured/minimum_gap.h"

#include <algorithm>
#include <cmath>

#include "frame/object_reach.h"
#include "geometry/shapes.h"
#include "text/catalogue.h"
#include "topics/depth/measured/fighting_measure.h"

namespace viewing {
namespace {

constexpr glm::ivec2 size_px(48, 48);
constexpr double most_turned_deg = 8.0;      ///< rotation of the quads, as in the pairs of the scene `coplanar`
constexpr double share_of_view = 0.6;        ///< half the side of a quad, relative to half the view's height
constexpr double share_of_room = 0.9;        ///< the widest gap, relative to the pair's distance from the near plane
constexpr double narrowest = 1e-12;          ///< the smallest gap tried, relative to the distance
constexpr double widest_narrow_code = 1e-3;  ///< the widest code that counts as narrow, relative to the distance
constexpr int places = 8;                    ///< positions of the pair for each gap
constexpr int halvings = 4;                  ///< bisections; the first interval spans a factor of 2

/// Returns the state with a camera at the origin that looks along −z, without settings that offset depth or keep it
/// from being cleared.
Params plain(const Params& state) {
    Params params;
    params.projection = state.projection.centered();
    params.depth = state.depth;
    params.depth.clear_value = 1.0;
    params.depth.clear = params.depth.write_while_clearing = params.depth.reversed_clear = true;
    params.camera.position = glm::dvec3(0.0);
    params.camera.yaw = params.camera.pitch = params.camera.roll = 0.0;
    return params;
}

/// Returns the far end of a depth code near the distance. For a float format, returns the distance itself: every
/// distance is equally good.
double far_end_of_a_code(const DepthCoding& coding, double distance) {
    if (coding.precision.is_float) return distance;
    const double levels = coding.precision.greatest_code();
    const double code = window_depth(coding.lens, coding.mapping, distance) * levels;
    // Depth is rounded to the nearest code, so a code ends halfway to the next one. Stay a hundredth of a code before
    // that end.
    const double end = std::min(std::floor(code), levels - 1.0) + 0.5;
    const double inside = coding.mapping == DepthMapping::reversed ? 0.01 : -0.01;
    return distance_of_window_depth(coding.lens, coding.mapping, (end + inside) / levels);
}

/// Returns half the side of a quad that covers the same part of the view at any distance.
double half_side(const Lens& lens, double distance) {
    return 0.5 * picture_height(lens, distance) * share_of_view;
}

}  // namespace

/// Doubles the gap until it is wide enough, halves it until it is too narrow, and then bisects.
struct MinimumGapSearch::Implementation {
    enum class Phase { widening, narrowing, between, done };

    Implementation(const Renderer& renderer, const Params& state, double distance)
        : params(plain(state)), lens(params.lens()) {
        const DepthCoding coding =
            depth_coding(params, derive(params, Scene{}, renderer.viewport(size_px, params.depth.format)));
        found.distance = far_end_of_a_code(coding, std::clamp(distance, lens.near, lens.far));
        room = (found.distance - lens.near) * share_of_room;
        if (!(room > 0.0)) {
            end(tr("Nothing fits between the near plane and the pair."));
            return;
        }
        sine = std::min(std::sin(glm::radians(most_turned_deg)), 0.2 * room / half_side(lens, found.distance));
        found.predicted = fighting_onset(coding, found.distance, 2.0 * half_side(lens, found.distance) * sine);
        gap = std::min(found.predicted.gap(), room);
        // Rounding varies with the position, so try several, many units in the last place apart. If codes are as narrow
        // as float32's steps, the positions are also at different points within a code; if codes are wide, the shifts
        // are smaller than a code.
        const double code = found.predicted.quantization;  // 0 where a float's steps are finer than a double's
        const bool is_fine = coding.precision.is_float || coding.precision.bits >= 24;
        const bool is_narrow = is_fine && code > 0.0 && code < widest_narrow_code * found.distance;
        for (int place = 0; place < places; ++place) {
            const double shift = place * 1.3e-6 * found.distance;
            shifts.push_back(is_narrow ? code * (std::floor(shift / code) + std::fmod(place * 0.37, 1.0)) : shift);
        }
    }

    void end(const char* problem) {
        found.problem = problem;
        phase = Phase::done;
    }

    /// Chooses the next gap, given the result for this one.
    void decide(bool is_wide_enough) {
        next_picture = 0;
        switch (phase) {
            case Phase::widening:
                if (is_wide_enough) {
                    phase = Phase::narrowing;
                    wide = gap;
                    gap /= 2.0;
                } else if (gap >= room) {
                    end(tr("Even with one surface right at the near plane, some pixels are wrong."));
                } else {
                    gap = std::min(2.0 * gap, room);
                }
                break;
            case Phase::narrowing:
                if (!is_wide_enough) {
                    phase = Phase::between;
                    narrow = gap;
                    gap = std::sqrt(narrow * wide);
                } else if (gap < found.distance * narrowest) {
                    end(tr("No pixel was wrong, however narrow the gap."));
                } else {
                    wide = gap;
                    gap /= 2.0;
                }
                break;
            case Phase::between:
                (is_wide_enough ? wide : narrow) = gap;
                gap = std::sqrt(narrow * wide);
                if (++halved < halvings) break;
                found.gap = wide;
                phase = Phase::done;
                break;
            case Phase::done:
                break;
        }
    }

    /// Returns a quad centered on the view axis.
    SceneObject quad(double distance) const {
        const double turned_deg = glm::degrees(std::asin(sine));
        SceneObject made;
        made.mesh = mesh;
        made.world_from_model = world_from_model(glm::dvec3(0.0, 0.0, -distance), {turned_deg, 90.0 + turned_deg, 0.0},
                                                 glm::dvec3(half_side(lens, distance)));
        return made;
    }

    /// Draws the next picture. Returns whether it shows the pair without a wrong pixel.
    Result<bool> is_told_apart(Renderer& renderer, WorkProgress* progress) {
        const double distance = found.distance - shifts[next_picture / 2];
        Scene scene;
        scene.objects = {quad(distance), quad(distance - gap)};
        if (next_picture % 2 == 1) std::swap(scene.objects[0], scene.objects[1]);
        FlatPair pair;
        pair.second = 1;
        pair.offset = gap;
        const auto counts = count_fighting(renderer, params, scene, {&pair, 1}, size_px, progress);
        if (!counts) return Error{counts.error()};
        ++found.pictures;
        ++next_picture;
        return counts->pairs[0].wrong == 0 && counts->pairs[0].pixels > 0;
    }

    Params params;
    Lens lens;
    double room = 0.0;           ///< the widest gap
    double sine = 0.0;           ///< of both rotation angles; a rotated quad must not reach the near plane
    std::vector<double> shifts;  ///< shifts of the pair toward the eye
    Phase phase = Phase::widening;
    double gap = 0.0;                 ///< the gap being tried
    std::size_t next_picture = 0;     ///< for this gap: two per shift, the second with the nearer quad drawn first
    double narrow = 0.0, wide = 0.0;  ///< too narrow, wide enough
    int halved = 0;
    MinimumGap found;
    std::shared_ptr<const Mesh> mesh = std::make_shared<const Mesh>(quad_mesh());
};

MinimumGapSearch::MinimumGapSearch(const Renderer& renderer, const Params& state, double distance)
    : implementation_(std::make_unique<Implementation>(renderer, state, distance)) {}
MinimumGapSearch::MinimumGapSearch(MinimumGapSearch&&) noexcept = default;
MinimumGapSearch& MinimumGapSearch::operator=(MinimumGapSearch&&) noexcept = default;
MinimumGapSearch::~MinimumGapSearch() = default;

bool MinimumGapSearch::is_done() const {
    return implementation_->phase == Implementation::Phase::done;
}

const MinimumGap& MinimumGapSearch::found() const {
    return implementation_->found;
}

Status MinimumGapSearch::step(Renderer& renderer, WorkProgress* progress) {
    Implementation& search = *implementation_;
    if (is_done()) return std::monostate{};
    const Result<bool> is_told_apart = search.is_told_apart(renderer, progress);
    if (!is_told_apart) {
        search.phase = Implementation::Phase::done;
        return Error{is_told_apart.error()};
    }
    if (!*is_told_apart || search.next_picture == 2 * search.shifts.size()) search.decide(*is_told_apart);
    return std::monostate{};
}

Result<MinimumGap> find_minimum_gap(Renderer& renderer, const Params& params, double distance, WorkProgress* progress) {
    MinimumGapSearch search(renderer, params, distance);
    while (!search.is_done())
        if (Status done = search.step(renderer, progress); !done) return Error{done.error()};
    return search.found();
}

}  // namespace viewing
