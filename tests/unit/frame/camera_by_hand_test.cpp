// V and P entered by hand: they are uploaded unchanged, the sentence names what is wrong with them, its fix repairs
// the picture, and no matrix breaks the program.
#include <glm/gtc/matrix_transform.hpp>

#include "frame/matrix_facts.h"
#include "geometry/camera.h"
#include "state/file/state_json.h"
#include "topics/matrices/numbers/take_matrix.h"
#include "unit/frame/frame_test.h"
#include "unit/geometry/random.h"

namespace viewing {
namespace {

using glm::dmat4;
using glm::dvec3;
using glm::dvec4;

constexpr glm::ivec2 by_hand_px(1600, 900);

Derived derived_by_hand(const Params& params) {
    return derive(params, testing::box_scene(), Viewport{by_hand_px});
}

std::vector<Problem> problems_by_hand(const Params& params) {
    return testing::problems_of(params, testing::box_scene(), Viewport{by_hand_px});
}

const Problem* problem_with_id(const std::vector<Problem>& problems, std::string_view id) {
    const auto found =
        std::find_if(problems.begin(), problems.end(), [&](const Problem& problem) { return problem.id == id; });
    return found == problems.end() ? nullptr : &*found;
}

/// Makes a random V with GLM.
dmat4 random_v(Random& random) {
    const dvec3 eye = random.vec3(8) + dvec3(0.0, 0.0, 12.0), center = random.vec3(2);
    return glm::lookAtRH(eye, center, dvec3(0.0, 1.0, 0.0));
}

TEST(CameraByHand, BothAreUploadedAsEntered) {
    Random random(seed);
    for (int trial = 0; trial < 100; ++trial) {
        Params params;
        params.slips.camera_as_view = params.slips.degrees_as_radians = true;
        dmat4 v, p;
        for (int i = 0; i < 16; ++i) {
            v[i / 4][i % 4] = random.number(-3, 3);
            p[i / 4][i % 4] = random.number(-3, 3);
        }
        params.camera_overrides = {v, p};
        const Derived derived = derived_by_hand(params);
        EXPECT_EQ(derived.view_from_world, v);
        EXPECT_EQ(derived.clip_from_view, p);
        const Params read = *parse_state(write_state(params), "test");
        EXPECT_EQ(read.camera_overrides, params.camera_overrides);
    }
}

TEST(CameraByHand, TheEyeIsWherePVSendsXYAndWToZero) {
    SCOPED_TRACE(seed);
    Random random(seed);
    for (int trial = 0; trial < 200; ++trial) {
        Params params;
        const dmat4 v = random_v(random);
        params.camera_overrides.view_from_world = v;
        if (trial % 2 == 1) params.projection.type = ProjectionType::orthographic;
        const dvec4 eye = derived_by_hand(params).eye_world;
        const dmat4 c = glm::inverse(v);
        const dvec4 expected = trial % 2 == 1 ? c[2] : c[3];
        for (int axis = 0; axis < 4; ++axis) EXPECT_NEAR(eye[axis], expected[axis], 1e-9) << trial;
    }
}

TEST(CameraByHand, AProjectionThatALensMakesHasItsNearFarAndEdges) {
    SCOPED_TRACE(seed);
    Random random(seed + 1);
    for (int trial = 0; trial < 200; ++trial) {
        const double n = random.number(0.1, 2), f = n + random.number(1, 100), l = random.number(-3, -0.5);
        const double r = random.number(0.5, 3), b = random.number(-3, -0.5), t = random.number(0.5, 3);
        const double factor = random.number(0.5, 2);  // a multiple of P is the same map
        Params params;
        const bool orthographic = trial % 2 == 1, reversed = trial % 4 >= 2;
        params.depth.mapping = reversed ? DepthMapping::reversed : DepthMapping::standard;
        const dmat4 p = orthographic
                            ? (reversed ? glm::orthoRH_ZO(l, r, b, t, f, n) : glm::orthoRH_NO(l, r, b, t, n, f))
                        : reversed ? glm::frustumRH_ZO(l * f / n, r * f / n, b * f / n, t * f / n, f, n)
                                   : glm::frustumRH_NO(l, r, b, t, n, f);
        params.camera_overrides.clip_from_view = factor * p;
        const std::optional<Lens> lens = params.lens_by_hand();
        ASSERT_TRUE(lens) << trial;
        EXPECT_EQ(lens->orthographic, orthographic);
        EXPECT_NEAR(lens->near, n, 1e-9 * f);
        EXPECT_NEAR(lens->far, f, 1e-6 * f);
        EXPECT_NEAR(lens->window->left, l, 1e-9);
        EXPECT_NEAR(lens->window->right, r, 1e-9);
        EXPECT_NEAR(lens->window->bottom, b, 1e-9);
        EXPECT_NEAR(lens->window->top, t, 1e-9);
        const Params typed = params.with_projection_by_hand();
        EXPECT_LT(largest_entry(derived_by_hand(typed).clip_from_view - p), 1e-6) << trial;
    }
}

TEST(CameraByHand, EachFaultIsNamedAndItsFixRepairsThePicture) {
    SCOPED_TRACE(seed);
    Random random(seed + 2);
    for (int trial = 0; trial < 50; ++trial) {
        Params own;
        const dmat4 v = random_v(random);
        ASSERT_TRUE(take_matrix(own, 'V', v, 16.0 / 9.0));
        own.projection.fovy = random.number(20, 80);
        const Derived right = derived_by_hand(own);
        dmat4 in_row = right.view_from_world;
        for (int axis = 0; axis < 3; ++axis) std::swap(in_row[axis][3], in_row[3][axis]);
        const dmat4 p = right.clip_from_view;
        struct Fault {
            const char* said;
            char letter;
            dmat4 entered;
        };
        for (const Fault& each :
             {Fault{"rows and columns are swapped", 'V', glm::transpose(v)},
              {"where V belongs", 'V', glm::inverse(right.view_from_world)},
              {"translation is in the last row", 'V', in_row},
              {"do not have length 1", 'V', glm::scale(dmat4(1.0), dvec3(2.0)) * v},
              {"left-handed", 'V', glm::scale(dmat4(1.0), dvec3(1.0, 1.0, -1.0)) * v},
              {"rows and columns are swapped", 'P', glm::transpose(p)},
              {"left-handed", 'P', glm::scale(p, dvec3(1.0, 1.0, -1.0))},
              {"in degrees", 'P',
               glm::perspectiveRH_NO(own.projection.fovy, right.aspect, own.projection.near, own.projection.far)}}) {
            Params params = own;
            ASSERT_TRUE(enter_by_hand(params, each.letter, each.entered));
            const std::vector<Problem> problems = problems_by_hand(params);
            const Problem* const problem = problem_with_id(problems, "by_hand.wrong_camera");
            ASSERT_TRUE(problem) << trial << " " << each.said;
            EXPECT_NE(say(problem->sentence).find(each.said), std::string::npos) << say(problem->sentence);
            EXPECT_EQ(problem->kind, ProblemKind::wrong);
            const Result<Params> fixed = apply_settings(params, {&problem->fixed_by, 1});
            ASSERT_TRUE(fixed) << problem->fixed_by;
            const Derived after = derived_by_hand(*fixed);
            EXPECT_LT(largest_entry(after.clip_from_world - right.clip_from_world), 1e-6) << trial << " " << each.said;
            EXPECT_FALSE(problem_with_id(problems_by_hand(*fixed), "by_hand.wrong_camera")) << each.said;
        }
    }
}

TEST(CameraByHand, ARightMatrixIsNeverCalledWrong) {
    SCOPED_TRACE(seed);
    Random random(seed + 3);
    for (int trial = 0; trial < 200; ++trial) {
        Params params;
        params.camera_overrides.view_from_world = random_v(random);
        const double n = random.number(0.05, 1);
        params.camera_overrides.clip_from_view =
            glm::perspectiveRH_NO(random.number(0.3, 2), 16.0 / 9.0, n, n + random.number(5, 100));
        for (const Problem& problem : problems_by_hand(params))
            EXPECT_FALSE(problem.kind == ProblemKind::wrong && problem.id.starts_with("by_hand"))
                << say(problem.sentence);
    }
}

TEST(CameraByHand, WhatHasNoLensIsSaidAndOffersToComputeItAgain) {
    Params params;
    const dmat4 product = derived_by_hand(params).clip_from_world;  // P V where P belongs
    params.camera_overrides.clip_from_view = product;
    EXPECT_TRUE(problem_with_id(problems_by_hand(params), "by_hand.wrong_camera"));
    params.camera_overrides.clip_from_view = product * glm::translate(dmat4(1.0), {1, 2, 3});
    const std::vector<Problem> problems = problems_by_hand(params);
    const Problem* const problem = problem_with_id(problems, "by_hand.no_lens");
    ASSERT_TRUE(problem);
    EXPECT_EQ(problem->fixed_by, "overrides.clip_from_view=null");
    EXPECT_FALSE(derived_by_hand(params).has_distances);
    params.camera_overrides = {dmat4(0.0), std::nullopt};
    EXPECT_TRUE(problem_with_id(problems_by_hand(params), "by_hand.flat"));
}

TEST(CameraByHand, OtherFixesThatHaveNoEffectAreNotOffered) {
    Params params;
    params.projection.near = 1e-4;  // leaves hardly any depth precision
    params.camera_overrides.clip_from_view = derived_by_hand(params).clip_from_view;
    bool is_said = false;
    for (const Problem& problem : problems_by_hand(params)) {
        EXPECT_FALSE(problem.fixed_by.starts_with("projection")) << say(problem.sentence);
        is_said =
            is_said || say(problem.sentence).find("0.0001") != std::string::npos || problem.id.starts_with("depth");
    }
    EXPECT_TRUE(is_said) << "near is that of the entered P";
}

}  // namespace
}  // namespace viewing
