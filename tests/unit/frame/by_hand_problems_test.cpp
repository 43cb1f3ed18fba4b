// For an S or R entered by hand, a sentence appears if and only if the matrix lacks a property of the correct one. The
// matrices are the slides' formulas written out, and the properties are checked on points.
#include "unit/frame/frame_test.h"
#include "unit/geometry/random.h"

namespace viewing {
namespace {

using glm::dmat4;
using glm::dvec3;
using glm::dvec4;

dmat4 slides_shadow(const dvec4& n, const dvec4& l) {
    dmat4 m;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            m[column][row] = (row == column ? glm::dot(n, l) : 0.0) - l[row] * n[column];
    return m;
}

dmat4 slides_mirror(const dvec4& n) {
    dmat4 m(1.0);
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column) m[column][row] -= 2.0 * n[row] * n[column];
    return m;
}

/// Returns the sentences that report a wrong matrix.
std::vector<std::string> broken_by_hand(const Params& params) {
    std::vector<Problem> problems;
    find_by_hand_problems(problems, params, derive(params, testing::box_scene(), {}));
    std::vector<std::string> sentences;
    for (const Problem& problem : problems)
        if (problem.kind == ProblemKind::wrong) sentences.push_back(say(problem.sentence));
    return sentences;
}

struct HandSample {
    Params params;
    dvec4 plane, light, other_plane, other_light;  // planes with a unit normal, lights on their positive side

    explicit HandSample(Random& random) {
        plane = dvec4(random.direction(), random.number(0.5, 3));
        other_plane = dvec4(random.direction(), random.number(0.5, 3));
        light = beside(random);
        other_light = beside(random);
        params.camera.position = dvec3(plane) * (5.0 - plane.w);  // on the light's side: the shadow is drawn
        params.planes.front().equation = random.number(0.5, 3) * plane;
        params.lights.front().position = light;
    }
    /// A point light or a parallel light well in front of the plane.
    dvec4 beside(Random& random) const {
        dvec4 light;
        do light = dvec4(random.vec3(6), random.number(0, 1) < 0.5 ? 0.0 : 1.0);
        while (glm::dot(plane, light) < 1.0);
        return light;
    }
    std::vector<std::string> of_shadow(const dmat4& s) {
        params.overrides[0] = {};
        params.overrides[0].shadowed_world_from_world[0] = s;
        return broken_by_hand(params);
    }
    std::vector<std::string> of_mirror(const dmat4& r) {
        params.overrides[0] = {};
        params.overrides[0].mirrored_world_from_world = r;
        return broken_by_hand(params);
    }
};

bool first_says(const std::vector<std::string>& sentences, const std::string& part) {
    return !sentences.empty() && sentences.front().find(part) != std::string::npos;
}

TEST(ByHand, AMatrixIsCalledWhatItIs) {
    Random random(seed);
    for (int trial = 0; trial < 200; ++trial) {
        SCOPED_TRACE("seed " + std::to_string(seed) + " trial " + std::to_string(trial));
        HandSample x(random);
        EXPECT_TRUE(
            first_says(x.of_shadow(glm::transpose(slides_shadow(x.plane, x.light))), "the transpose of the correct S"));
        EXPECT_TRUE(
            first_says(x.of_shadow(slides_shadow(x.plane, x.other_light)), "is the shadow matrix for the light ("));
        EXPECT_TRUE(
            first_says(x.of_shadow(slides_shadow(x.other_plane, x.light)), "is the shadow matrix for the plane "));
        EXPECT_TRUE(first_says(x.of_shadow(slides_mirror(x.plane)), "is the reflection matrix for the plane "));
        EXPECT_TRUE(
            first_says(x.of_mirror(glm::transpose(slides_mirror(x.plane))), "Rᵀ, the transpose of the correct R"));
        EXPECT_TRUE(first_says(x.of_mirror(slides_mirror(x.other_plane)), "is the reflection matrix for the plane "));
        EXPECT_TRUE(first_says(x.of_mirror(slides_mirror(1.7 * x.plane)), "a normal that is not a unit vector"));
        dmat4 slip = slides_mirror(x.plane);
        slip[0][1] = -slip[0][1];
        if (std::abs(slip[0][1]) < 0.01) continue;  // −2ab and +2ab are shown as the same number
        EXPECT_TRUE(first_says(x.of_mirror(slip), "+2ab in row 2, column 1"));
    }
}

TEST(ByHand, WorkedSentences) {
    Params params;  // the floor y = 0, the light at (2.6, 5.2, 2.2)
    const auto of = [&](const dmat4& s, const dmat4& r) {
        params.overrides[0].shadowed_world_from_world[0] = s;
        params.overrides[0].mirrored_world_from_world = r;
        return broken_by_hand(params);
    };
    EXPECT_EQ(of(slides_shadow({0, 1, 0, 0}, {1, 4, 2, 1}), slides_mirror({0, 1, 0, -0.5})),
              (std::vector<std::string>{
                  "S entered by hand is the shadow matrix for the light (1, 4, 2), not for this one",
                  "R entered by hand is the reflection matrix for the plane y = 0.5, not for this one"}));
    EXPECT_EQ(of(slides_shadow({0, 1, 0, 0}, {0, 1, 0, 0}), slides_mirror({0.6, 0.8, 0, -2})),
              (std::vector<std::string>{
                  "S entered by hand is the shadow matrix for the light (0, 1, 0, 0), not for this one",
                  "R entered by hand is the reflection matrix for the plane 0.6 x + 0.8 y − 2 = 0, not for this one"}));
}

// The properties: S p is in the plane for all p, S L = 0, and S leaves points of the plane fixed. R leaves the plane's
// points fixed and maps a point off the plane to its image. A sentence appears if and only if a property is missing.
TEST(ByHand, ASentenceExactlyWhereAPropertyIsMissing) {
    Random random(seed + 1);
    int right = 0, wrong = 0;
    for (int trial = 0; trial < 300; ++trial) {
        SCOPED_TRACE("seed " + std::to_string(seed + 1) + " trial " + std::to_string(trial));
        HandSample x(random);
        const dvec3 n(x.plane);
        const auto in_plane = [&](const dvec3& p) { return p - (glm::dot(n, p) + x.plane.w) * n; };
        const dmat4 s = slides_shadow(x.plane, x.light), r = slides_mirror(x.plane);
        dmat4 changed = s, turned = r;
        changed[trial % 4][(trial / 4) % 4] += 0.4;
        turned[trial % 4][(trial / 4) % 4] += 0.4;
        const dmat4 squeezed = glm::scale(dmat4(1.0), dvec3(0.5)) * s;
        for (const dmat4& by_hand : {s, 2.5 * s, changed, squeezed, slides_shadow(x.plane, x.other_light)}) {
            bool is_right = glm::length(by_hand * x.light) < 1e-6;
            for (int i = 0; i < 8; ++i) {
                const dvec3 p = random.vec3(5);
                const dvec4 image = by_hand * dvec4(p, 1.0), stays = by_hand * dvec4(in_plane(p), 1.0);
                is_right = is_right && std::abs(glm::dot(x.plane, image)) < 1e-6 &&
                           glm::distance(dvec3(stays) / stays.w, in_plane(p)) < 1e-6;
            }
            EXPECT_EQ(x.of_shadow(by_hand).empty(), is_right);
            (is_right ? right : wrong) += 1;
        }
        const dvec3 q = random.vec3(5) + 2.0 * n;
        for (const dmat4& by_hand :
             {r, dmat4(1.0), turned, glm::scale(dmat4(1.0), {1, 1, -1}), slides_mirror(x.other_plane)}) {
            const dvec4 image = by_hand * dvec4(q, 1.0);
            bool is_right = glm::distance(dvec3(image) / image.w, q - 2.0 * (glm::dot(n, q) + x.plane.w) * n) < 1e-6;
            for (int i = 0; i < 3; ++i) {
                const dvec3 p = in_plane(random.vec3(5));
                const dvec4 stays = by_hand * dvec4(p, 1.0);
                is_right = is_right && glm::distance(dvec3(stays) / stays.w, p) < 1e-6;
            }
            EXPECT_EQ(x.of_mirror(by_hand).empty(), is_right);
            (is_right ? right : wrong) += 1;
        }
    }
    EXPECT_EQ(right, 900);
    EXPECT_EQ(wrong, 2100);
}

}  // namespace
}  // namespace viewing
