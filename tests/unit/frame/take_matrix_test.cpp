// A pasted V, C or P replaces the state's own: it survives a round trip through text in every syntax, and each known
// fault is fixed.
#include "topics/matrices/numbers/take_matrix.h"

#include <glm/gtc/matrix_transform.hpp>

#include "topics/matrices/numbers/matrix_text.h"
#include "topics/matrices/numbers/pasted_matrix.h"
#include "unit/frame/frame_test.h"
#include "unit/geometry/random.h"

namespace viewing {
namespace {

using glm::dmat4;
using glm::dvec3;

constexpr glm::ivec2 taken_px(1600, 900);

double worst_entry(const dmat4& a, const dmat4& b) {
    double worst = 0.0;
    for (int i = 0; i < 16; ++i) worst = std::max(worst, std::abs(a[i / 4][i % 4] - b[i / 4][i % 4]));
    return worst;
}

Derived derived_when_taken(const Params& params) {
    return derive(params, testing::box_scene(), Viewport{taken_px});
}

dmat4 view_of_glm(Random& random) {
    dvec3 eye, center, up;
    do {
        eye = random.vec3(20);
        center = random.vec3(4);
        up = random.direction();
    } while (glm::distance(eye, center) < 1.0 || glm::length(glm::cross(up, glm::normalize(center - eye))) < 0.1);
    return glm::lookAtRH(eye, center, up);
}

/// Makes a random P with GLM's perspective, frustum, ortho or infinite perspective.
dmat4 random_projection(Random& random, int kind) {
    const double n = random.number(0.05, 2), f = n + random.number(1, 500), fovy = random.number(0.1, 2.5);
    const double l = random.number(-3, 0), b = random.number(-3, 0);
    const double r = l + random.number(0.5, 4), t = b + random.number(0.5, 4), aspect = random.number(0.5, 2.5);
    switch (kind % 7) {
        case 0:
            return glm::perspectiveRH_NO(fovy, aspect, n, f);
        case 1:
            return glm::frustumRH_NO(l, r, b, t, n, f);
        case 2:
            return glm::orthoRH_NO(l, r, b, t, -n, f);
        case 3:
            return glm::orthoRH_NO(-2.0 * aspect, 2.0 * aspect, -2.0, 2.0, n, f);
        case 4:
            return glm::infinitePerspective(fovy, aspect, n);
        case 5:
            return glm::perspectiveRH_ZO(fovy, aspect, f, n);
        default:
            return glm::perspectiveRH_NO(fovy, 16.0 / 9.0, n, f);
    }
}

constexpr MatrixFormat syntaxes[] = {MatrixFormat::glm, MatrixFormat::numpy, MatrixFormat::matlab, MatrixFormat::text};

PastedMatrix through_text(const dmat4& matrix, const char* name, int trial) {
    const Result<PastedMatrix> read = read_pasted_matrix(matrix_text(name, matrix, syntaxes[trial % 4]));
    if (!read) throw std::runtime_error(read.error());
    return *read;
}

TEST(TakeMatrix, AThousandViewsThereAndBack) {
    SCOPED_TRACE(seed);
    Random random(seed);
    Params params;
    params.slips.camera_as_view = true;
    for (int trial = 0; trial < 1000; ++trial) {
        const bool by_camera = trial % 3 == 0;
        const dmat4 v = view_of_glm(random);
        const PastedMatrix pasted =
            through_text(by_camera ? glm::inverse(v) : v, by_camera ? "world_from_view" : "view_from_world", trial);
        const ExplainedMatrix found = explain_matrix(pasted.matrix, pasted.letter, params, 1.5, pasted.tolerance);
        ASSERT_TRUE(is_takeable(found)) << trial;
        ASSERT_TRUE(take_matrix(params, found.letter, pasted.matrix, 16.0 / 9.0, pasted.tolerance)) << trial;
        EXPECT_LT(worst_entry(derived_when_taken(params).view_from_world, v), 1e-9) << trial;
    }
}

TEST(TakeMatrix, AThousandProjectionsThereAndBack) {
    SCOPED_TRACE(seed);
    Random random(seed);
    Params params;
    params.slips.degrees_as_radians = true;
    for (int trial = 0; trial < 1000; ++trial) {
        const dmat4 p = random_projection(random, trial);
        const PastedMatrix pasted = through_text(p, "clip_from_view", trial);
        const ExplainedMatrix found =
            explain_matrix(pasted.matrix, pasted.letter, params, 16.0 / 9.0, pasted.tolerance);
        ASSERT_EQ(found.letter, 'P') << trial;
        ASSERT_TRUE(is_takeable(found)) << trial;
        ASSERT_TRUE(take_matrix(params, 'P', pasted.matrix, 16.0 / 9.0, pasted.tolerance)) << trial;
        const Derived derived = derived_when_taken(params);
        EXPECT_LT(worst_entry(derived.clip_from_view, p), 1e-9 * std::max(1.0, largest_entry(p))) << trial;
        EXPECT_EQ(params.projection.type == ProjectionType::frustum, trial % 7 == 1) << trial;
        EXPECT_EQ(std::isinf(params.projection.far), trial % 7 == 4) << trial;
        EXPECT_EQ(params.depth.mapping == DepthMapping::reversed, trial % 7 == 5) << trial;
        if (trial % 7 == 6) {
            EXPECT_EQ(params.projection.aspect, 0.0) << "the view's own";
        }
    }
}

TEST(TakeMatrix, EveryFaultOfACameraIsMended) {
    Random random(seed + 1);
    for (int trial = 0; trial < 200; ++trial) {
        SCOPED_TRACE("seed " + std::to_string(seed + 1) + " trial " + std::to_string(trial));
        const dmat4 v = view_of_glm(random), c = glm::inverse(v);
        const Params opening;
        const dmat4 own = derived_when_taken(opening).view_from_world;
        dmat4 left_handed = v, in_row = own;
        for (int column = 0; column < 4; ++column) left_handed[column][2] = -left_handed[column][2];
        for (int axis = 0; axis < 3; ++axis) std::swap(in_row[axis][3], in_row[3][axis]);
        const double scale = random.number(1.5, 3);
        struct Fault {
            const char* what;
            dmat4 pasted, right;
            char named;
        };
        for (const Fault& each : {Fault{"transposed", glm::transpose(v), v, 'V'},
                                  {"scaled", glm::scale(dmat4(1.0), dvec3(scale)) * v, v, 'V'},
                                  {"C in its place", glm::inverse(own), own, 'V'},
                                  {"left-handed", left_handed, v, 'V'},
                                  {"w in the wrong row", in_row, own, 'V'},
                                  {"C transposed", glm::transpose(c), c, 'C'}}) {
            const ExplainedMatrix found = explain_matrix(each.pasted, each.named, opening, 1.5);
            EXPECT_FALSE(is_takeable(found)) << each.what;
            const std::optional<dmat4> fixed = fixed_matrix(each.pasted, found);
            ASSERT_TRUE(fixed) << each.what;
            EXPECT_LT(worst_entry(*fixed, each.right), 1e-9) << each.what;
            Params params;
            EXPECT_TRUE(take_matrix(params, found.letter, *fixed, 1.5)) << each.what;
        }
    }
}

TEST(TakeMatrix, FaultsOfAProjectionAreMended) {
    const Params opening;
    const double aspect = 16.0 / 9.0;
    const dmat4 right = derived_when_taken(opening).clip_from_view, other = glm::perspectiveRH_NO(1.1, 1.3, 0.2, 70.0);
    const dmat4 cases[][2] = {{glm::transpose(right), right},
                              {glm::transpose(other), other},
                              {glm::perspectiveLH_NO(1.1, 1.3, 0.2, 70.0), other},
                              {glm::perspectiveRH_NO(40.0, aspect, 0.5, 40.0), right},
                              {glm::perspectiveRH_ZO(glm::radians(40.0), aspect, 0.5, 40.0), right},
                              {glm::perspectiveRH_NO(glm::radians(40.0), 1.0 / aspect, 0.5, 40.0), right}};
    for (const auto& [pasted, wanted] : cases) {
        const ExplainedMatrix found = explain_matrix(pasted, 'P', opening, aspect);
        EXPECT_FALSE(is_takeable(found));
        const std::optional<dmat4> fixed = fixed_matrix(pasted, found);
        ASSERT_TRUE(fixed);
        EXPECT_LT(worst_entry(*fixed, wanted), 1e-12);
    }
}

TEST(TakeMatrix, AProjectionForZeroToOneKeepsItsLens) {
    Params params;
    const dmat4 pasted = glm::perspectiveRH_ZO(1.1, 1.3, 0.2, 70.0);
    const ExplainedMatrix found = explain_matrix(pasted, 'P', params, 1.3);
    ASSERT_EQ(found.fault, MatrixFault::zero_to_one);
    EXPECT_NEAR(found.lens->near, 0.2, 1e-12);
    const std::optional<dmat4> fixed = fixed_matrix(pasted, found);
    ASSERT_TRUE(fixed);
    EXPECT_LT(worst_entry(*fixed, glm::perspectiveRH_NO(1.1, 1.3, 0.2, 70.0)), 1e-12);
    ASSERT_TRUE(take_matrix(params, 'P', *fixed, 1.3));
    EXPECT_NEAR(params.projection.near, 0.2, 1e-12);

    // If depth is reversed, the third row alone determines the range, even while the state's switch says −1 … 1.
    params.depth.reversed_zero_to_one = false;
    const dmat4 reversed = glm::perspectiveRH_ZO(1.1, 16.0 / 9.0, 70.0, 0.2);
    ASSERT_TRUE(is_takeable(explain_matrix(reversed, 'P', params, 16.0 / 9.0)));
    ASSERT_TRUE(take_matrix(params, 'P', reversed, 16.0 / 9.0));
    EXPECT_EQ(params.depth.mapping, DepthMapping::reversed);
    EXPECT_TRUE(params.depth.reversed_zero_to_one);
    EXPECT_LT(worst_entry(derived_when_taken(params).clip_from_view, reversed), 1e-9);
}

TEST(TakeMatrix, WhatNoStateMayHaveChangesNothing) {
    Params params;
    const Params before = params;
    EXPECT_FALSE(take_matrix(params, 'V', glm::lookAtRH(dvec3(1e8, 0, 0), dvec3(0.0), dvec3(0, 1, 0)), 1.5));
    EXPECT_FALSE(take_matrix(params, 'P', dmat4(0.0), 1.5));
    EXPECT_FALSE(take_matrix(params, 'P', glm::perspectiveRH_NO(1.0, 1.0, 1e-9, 1.0), 1.5)) << "near below 1e-6";
    EXPECT_EQ(params, before);
    const dmat4 mirror = glm::scale(dmat4(1.0), dvec3(1, -1, 1));
    EXPECT_TRUE(take_matrix(params, 'R', mirror, 1.5));
    EXPECT_EQ(params.overrides[0].mirrored_world_from_world, mirror);
}

}  // namespace
}  // namespace viewing
