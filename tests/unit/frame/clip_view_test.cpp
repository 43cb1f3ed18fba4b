// The view "Clip space" leads from eye space to NDC by maps that keep straight lines straight and never turn space
// inside out.
#include "topics/camera/numbers/clip_space.h"
#include "unit/frame/frame_test.h"
#include "unit/geometry/random.h"

namespace viewing {
namespace {

using glm::dvec3;
using glm::dvec4;

dvec3 sent(const glm::dmat4& m, const dvec3& p) {
    const dvec4 h = m * dvec4(p, 1.0);
    return dvec3(h) / h.w;
}

std::vector<Params> clip_states() {
    std::vector<Params> states;
    for (const char* const projection :
         {R"({"far": 30})", R"({"far": "infinite"})", R"({"type": "orthographic", "near": -2, "far": 30})",
          R"({"type": "frustum", "left": -0.1, "right": 0.6, "bottom": 0.05, "top": 0.4, "far": 12})"})
        for (const char* const mapping : {"standard", "reversed"})
            states.push_back(testing::params_with(
                {std::string("projection=") + projection, std::string("depth.mapping=") + mapping}));
    return states;
}

TEST(ClipView, EndsAtTheCubeOrHalfOfIt) {
    for (Params params : clip_states()) {
        params.view.division = 1.0;
        const Derived derived = derive(params, testing::box_scene(), {});
        const Lens lens = params.lens();
        const double half = derived.clip_zero_to_one ? 0.5 : 1.0;
        const glm::dmat4 m = division_from_view(params, derived);
        for (const double x : {-1.0, 1.0})
            for (const double y : {-1.0, 1.0}) {
                const Edges near = lens.edges_at(lens.near, derived.aspect);
                EXPECT_LT(glm::distance(sent(m, {near.at({x, y}), -lens.near}), dvec3(x, y, half)), 1e-9);
                if (lens.is_infinite()) continue;
                const Edges far = lens.edges_at(lens.far, derived.aspect);
                EXPECT_LT(glm::distance(sent(m, {far.at({x, y}), -lens.far}), dvec3(x, y, -half)), 1e-9);
            }
        const dvec4 direction = m * dvec4(0.0, 0.0, -1.0, 0.0);
        if (lens.is_infinite()) {
            EXPECT_NEAR(direction.z / direction.w, -half, 1e-9) << "the far plane";
        }
    }
}

TEST(ClipView, BeginsWithEyeSpaceMovedAndScaled) {
    for (Params params : clip_states()) {
        params.view.division = 0.0;
        const Derived derived = derive(params, testing::box_scene(), {});
        const glm::dmat4 m = division_from_view(params, derived);
        const dvec3 origin = sent(m, dvec3(0.0));
        const double scale = glm::distance(sent(m, dvec3(1, 0, 0)), origin);
        EXPECT_GT(scale, 0.0);
        for (int axis = 0; axis < 3; ++axis) {
            dvec3 unit(0.0);
            unit[axis] = 1.0;
            EXPECT_LT(glm::distance(sent(m, unit) - origin, scale * unit), 1e-12);
        }
        for (const dvec3& corner : frustum_corners(params, derived, glm::dmat4(1.0)))
            EXPECT_LE(glm::length(sent(m, corner)), std::sqrt(3.0) + 1e-9) << "fits the cube";
    }
}

// Between the ends, w > 0 beyond the near plane, collinear points stay collinear, and four points keep their
// orientation.
TEST(ClipView, KeepsLinesAndOrientationOnTheWay) {
    Random random(seed);
    for (Params params : clip_states())
        for (int trial = 0; trial < 50; ++trial) {
            SCOPED_TRACE("seed " + std::to_string(seed) + " trial " + std::to_string(trial));
            params.view.division = random.number(0, 1);
            const Derived derived = derive(params, testing::box_scene(), {});
            const glm::dmat4 m = division_from_view(params, derived);
            const auto point = [&] {
                return dvec3(random.number(-3, 3), random.number(-3, 3),
                             -random.number(std::max(params.projection.near, 0.1), 11));
            };
            const dvec3 a = point(), b = point(), c = point(), d = point(), middle = 0.3 * a + 0.7 * b;
            EXPECT_GT((m * dvec4(a, 1.0)).w, 0.0);
            const dvec3 on = sent(m, b) - sent(m, a), way = sent(m, middle) - sent(m, a);
            EXPECT_LT(glm::length(glm::cross(on, way)), 1e-9 * std::max(1.0, glm::dot(on, on)));
            const auto volume = [](const dvec3& p, const dvec3& q, const dvec3& r, const dvec3& s) {
                return glm::dot(glm::cross(q - p, r - p), s - p);
            };
            const double before = volume(a, b, c, d), after = volume(sent(m, a), sent(m, b), sent(m, c), sent(m, d));
            if (std::abs(before) > 0.01) {
                EXPECT_GT(before * after, 0.0);
            }
        }
}

glm::dmat4 way_at(Params params, double way) {
    params.view.way = way;
    return way_from_world(params, derive(params, testing::box_scene(), {}));
}

TEST(WayView, PassesThroughTheSpacesWithoutAJump) {
    Random random(seed);
    for (const Params& params : clip_states())
        for (int trial = 0; trial < 30; ++trial) {
            SCOPED_TRACE("seed " + std::to_string(seed) + " trial " + std::to_string(trial));
            const Derived derived = derive(params, testing::box_scene(), {});
            const dvec3 in_view(random.number(-2, 2), random.number(-2, 2), -random.number(1, 11));
            const dvec3 p = sent(glm::inverse(derived.view_from_world), in_view);
            for (const int space : {1, 2, 3}) {
                const dvec3 at = sent(way_at(params, space), p);
                EXPECT_LT(glm::distance(sent(way_at(params, space - 1e-9), p), at), 1e-6) << space;
                EXPECT_LT(glm::distance(sent(way_at(params, space + 1e-9), p), at), 1e-6) << space;
            }
            EXPECT_LT(glm::distance(sent(way_at(params, 4.0), p), sent(way_at(params, 4.0 - 1e-9), p)), 1e-6);
        }
}

TEST(WayView, ClipSpacesSideFacesAreWhereXAndYAreW) {
    for (const Params& params : clip_states()) {
        if (params.projection.is_orthographic()) continue;
        const Derived derived = derive(params, testing::box_scene(), {});
        const Lens lens = params.lens();
        const glm::dmat4 m = way_at(params, 2.0) * glm::inverse(derived.view_from_world);
        const dvec3 eye = sent(m, dvec3(0.0));
        for (const double distance : {lens.near, 3.0, 10.0})
            for (const double x : {-1.0, 1.0})
                for (const double y : {-1.0, 1.0}) {
                    const dvec3 edge{lens.edges_at(distance, derived.aspect).at({x, y}), -distance};
                    const dvec3 seen = sent(m, edge) - eye;
                    EXPECT_NEAR(seen.x, -x * seen.z, 1e-9);
                    EXPECT_NEAR(seen.y, -y * seen.z, 1e-9);
                }
    }
}

TEST(WayView, TheWindowIsTheCamerasPicture) {
    Random random(seed);
    constexpr Edges free{-1.0, 0.2, -0.4, 1.0};
    for (Params params : clip_states())
        for (int trial = 0; trial < 30; ++trial) {
            params.view.way = 4.0;
            params.observer.yaw = random.number(-700, 700);
            const Viewport camera{{1200, 900}}, lower{{500, 300}};
            const Derived derived = derive(params, testing::box_scene(), camera);
            const glm::dmat4 m = derive_way_view(params, derived, lower, free).clip_from_world;
            const dvec3 middle{params.lens().edges_at(params.lens().near, derived.aspect).center(),
                               -params.lens().near};
            const auto in_picture = [&](const glm::dvec3& in_view) {
                return glm::dvec2(sent(m * glm::inverse(derived.view_from_world), in_view));
            };
            EXPECT_LT(glm::distance(in_picture(middle), free.center()), 1e-9);
            const dvec3 p(random.number(-1, 1), random.number(-1, 1), -random.number(1, 11));
            const glm::dvec2 ndc(sent(derived.clip_from_view, p));
            if (glm::length(ndc) > 1.0) continue;
            // The picture keeps its shape, except for the slight perspective of the front view.
            const double scale = 0.5 * free.height() / 1.25, shape = 1200.0 / 900.0 / (500.0 / 300.0);
            const double shrunk = std::min(1.0, 500.0 * free.width() / (300.0 * free.height()) / (1200.0 / 900.0));
            const glm::dvec2 expected = free.center() + shrunk * scale * ndc * glm::dvec2(shape, 1.0);
            EXPECT_LT(glm::distance(in_picture(p), expected), 0.03);
        }
}

}  // namespace
}  // namespace viewing
