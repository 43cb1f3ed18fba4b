// Diagnoses of pasted matrices: on random states, each kind of mistake is named correctly, and a correct matrix is
// never reported as wrong. The matrices come from GLM and from the slides' formulas, written out here.
#include "topics/matrices/numbers/explain_matrix.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "topics/matrices/numbers/pasted_matrix.h"
#include "topics/matrices/numbers/take_matrix.h"
#include "unit/geometry/random.h"

namespace viewing {
namespace {

using glm::dmat4;
using glm::dvec2;
using glm::dvec3;
using glm::dvec4;

/// A random state and its matrices, named as in textbooks.
struct Sample {
    Params params;
    double aspect;
    dvec3 eye, center, up;
    dmat4 v, c, p, s, r;
    double fovy, near, far;
    dvec4 plane, light;  // the plane has a unit normal

    explicit Sample(Random& random) {
        const double from = 5.0;
        do {
            eye = random.vec3(20);
            center = random.vec3(4);
            up = random.direction();
        } while (glm::distance(eye, center) < from || glm::length(glm::cross(up, glm::normalize(center - eye))) < 0.2);
        v = glm::lookAtRH(eye, center, up);
        c = glm::inverse(v);
        params.camera.look({eye, center, up});
        fovy = random.number(20, 100);
        near = random.number(0.1, 2);
        far = random.number(10, 200);
        aspect = random.number(1.2, 2.5);
        params.projection.fovy = fovy;
        params.projection.near = near;
        params.projection.far = far;
        p = glm::perspectiveRH_NO(glm::radians(fovy), aspect, near, far);
        plane = dvec4(random.direction(), random.number(0.5, 3));
        light = dvec4(random.vec3(5) + dvec3(0, 9, 0), random.number(0, 1) < 0.5 ? 0.0 : 1.0);
        params.planes.front().equation = random.number(1.5, 3) * plane;
        params.lights.front().position = light;
        s = shadow(plane, light);
        r = mirror(plane);
    }

    static dmat4 shadow(const dvec4& n, const dvec4& l) {
        dmat4 m;
        for (int row = 0; row < 4; ++row)
            for (int column = 0; column < 4; ++column)
                m[column][row] = (row == column ? glm::dot(n, l) : 0.0) - l[row] * n[column];
        return m;
    }
    static dmat4 mirror(const dvec4& n) {
        dmat4 m(1.0);
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 4; ++column) m[column][row] -= 2.0 * n[row] * n[column];
        return m;
    }

    ExplainedMatrix explained(const dmat4& matrix, char named = 0) const {
        return explain_matrix(matrix, named, params, aspect);
    }
};

struct MatrixCase {
    const char* name;
    char letter;
    MatrixFault fault;
    dmat4 (*make)(const Sample& sample, Random& random);
    char named = 0;
};

dmat4 diagonal(double x, double y, double z, double w = 1.0) {
    dmat4 made = glm::scale(dmat4(1.0), {x, y, z});
    made[3][3] = w;
    return made;
}
dmat4 with_row_of_translation(dmat4 m) {
    for (int axis = 0; axis < 3; ++axis) std::swap(m[axis][3], m[3][axis]);
    return m;
}

using F = MatrixFault;

const MatrixCase spoiled_matrices[] = {
    {"V transposed", 'V', F::transposed, [](const Sample& x, Random&) { return glm::transpose(x.v); }},
    {"C in place of V", 'V', F::inverse, [](const Sample& x, Random&) { return x.c; }, 'V'},
    {"V scaled", 'V', F::scaled,
     [](const Sample& x, Random& random) { return x.v * glm::scale(dmat4(1.0), dvec3(random.number(1.5, 3))); }},
    {"V scaled unevenly", 'V', F::scaled, [](const Sample& x, Random&) { return diagonal(2, 1, 1.5) * x.v; }},
    {"V left-handed", 'V', F::left_handed, [](const Sample& x, Random&) { return diagonal(1, 1, -1) * x.v; }},
    {"V of lookAtLH", 'V', F::looks_back,
     [](const Sample& x, Random&) { return glm::lookAtLH(x.eye, x.center, x.up); }},
    {"V of +eye", 'V', F::eye_not_negated,
     [](const Sample& x, Random&) { return dmat4(glm::dmat3(x.v)) * glm::translate(dmat4(1.0), x.eye); }},
    {"V rotated first", 'V', F::wrong_order,
     [](const Sample& x, Random&) { return glm::translate(dmat4(1.0), -x.eye) * dmat4(glm::dmat3(x.v)); }},
    {"V with w in the wrong row", 'V', F::translation_in_row,
     [](const Sample& x, Random&) { return with_row_of_translation(x.v); }},
    {"P in degrees", 'P', F::degrees,
     [](const Sample& x, Random&) { return glm::perspectiveRH_NO(x.fovy, x.aspect, x.near, x.far); }},
    {"P transposed", 'P', F::transposed, [](const Sample& x, Random&) { return glm::transpose(x.p); }},
    {"P for 0 … 1", 'P', F::zero_to_one,
     [](const Sample& x, Random&) { return glm::perspectiveRH_ZO(glm::radians(x.fovy), x.aspect, x.near, x.far); }},
    {"P of another lens for 0 … 1", 'P', F::zero_to_one,
     [](const Sample& x, Random& random) {
         const double near = std::round(random.number(1, 20)) / 10.0;  // rounded, as in textbooks
         return glm::perspectiveRH_ZO(glm::radians(x.fovy), x.aspect, near, x.far + 10.0);
     }},
    {"P for 0 … 1, infinite far, the state's near", 'P', F::zero_to_one,
     [](const Sample& x, Random&) {
         dmat4 p = glm::infinitePerspective(glm::radians(x.fovy), x.aspect, x.near);
         p[3][2] = -x.near;
         return p;
     }},
    {"P reversed", 'P', F::reversed,
     [](const Sample& x, Random&) { return glm::perspectiveRH_ZO(glm::radians(x.fovy), x.aspect, x.far, x.near); }},
    {"P with 1/aspect", 'P', F::inverse_aspect,
     [](const Sample& x, Random&) {
         return glm::perspectiveRH_NO(glm::radians(x.fovy), 1.0 / x.aspect, x.near, x.far);
     }},
    {"P left-handed", 'P', F::left_handed,
     [](const Sample& x, Random&) { return glm::perspectiveLH_NO(glm::radians(x.fovy), x.aspect, x.near, x.far); }},
    {"P that lost the sign of −1", 'P', F::lost_sign,
     [](const Sample& x, Random&) { return diagonal(1, 1, 1, -1) * x.p; }},
    {"P of another lens that lost the sign of −1", 'P', F::lost_sign,
     [](const Sample& x, Random&) {
         return diagonal(1, 1, 1, -1) * glm::perspectiveRH_NO(glm::radians(x.fovy), x.aspect, 1.5 * x.near, x.far);
     }},
    {"P of another lens, left-handed", 'P', F::left_handed,
     [](const Sample& x, Random&) {
         return glm::perspectiveLH_NO(glm::radians(x.fovy), x.aspect, 1.5 * x.near, x.far);
     }},
    {"P with +2fn", 'P', F::depth_signs,
     [](const Sample& x, Random&) {
         dmat4 p = x.p;
         p[3][2] = 2.0 * x.far * x.near / (x.far - x.near);
         return p;
     }},
    {"P of another lens with +(f + n)", 'P', F::depth_signs,
     [](const Sample& x, Random&) {
         dmat4 p = glm::perspectiveRH_NO(glm::radians(x.fovy), x.aspect, 1.5 * x.near, x.far);
         p[2][2] = -p[2][2];
         return p;
     }},
    {"P V", 0, F::product, [](const Sample& x, Random&) { return x.p * x.v; }},
    {"−P", 'P', F::negated, [](const Sample& x, Random&) { return -x.p; }},
    {"−V", 'V', F::negated, [](const Sample& x, Random&) { return -x.v; }, 'V'},
    {"−R", 'R', F::negated, [](const Sample& x, Random&) { return -x.r; }},
    {"S transposed", 'S', F::transposed, [](const Sample& x, Random&) { return glm::transpose(x.s); }},
    {"S of another light", 'S', F::other_light,
     [](const Sample& x, Random& random) {
         return Sample::shadow(x.plane, {random.vec3(5) + dvec3(0, 9, 0), 1.0});
     }},
    {"S of another plane", 'S', F::other_plane,
     [](const Sample& x, Random& random) {
         return 2.0 * Sample::shadow({random.direction(), 4.0}, x.light);
     }},
    {"V R", 0, F::mirrored_view, [](const Sample& x, Random&) { return x.v * x.r; }},
    {"P with (f − n)/(f + n)", 'P', F::negative_depth,
     [](const Sample& x, Random&) {
         dmat4 p = x.p;
         p[2][2] = 1.0 / p[2][2];
         return p;
     }},
    {"R without the factor 2", 'R', F::lost_factor, [](const Sample& x, Random&) { return 0.5 * (dmat4(1.0) + x.r); }},
    {"R transposed", 'R', F::transposed, [](const Sample& x, Random&) { return glm::transpose(x.r); }},
    {"R of another plane", 'R', F::other_plane,
     [](const Sample&, Random& random) {
         return Sample::mirror({random.direction(), random.number(1, 2)});
     }},
    {"R of a normal that is not a unit vector", 'R', F::not_unit_normal,
     [](const Sample& x, Random&) { return Sample::mirror(x.params.planes.front().equation); }},
};

const MatrixCase right_matrices[] = {
    {"V", 'V', F::none, [](const Sample& x, Random&) { return x.v; }},
    {"V, named", 'V', F::none, [](const Sample& x, Random&) { return x.v; }, 'V'},
    {"C", 'C', F::none, [](const Sample& x, Random&) { return x.c; }},
    {"C, named", 'C', F::none, [](const Sample& x, Random&) { return x.c; }, 'C'},
    {"P", 'P', F::none, [](const Sample& x, Random&) { return x.p; }},
    {"S", 'S', F::none, [](const Sample& x, Random&) { return x.s; }},
    {"3 S", 'S', F::none, [](const Sample& x, Random&) { return 3.0 * x.s; }},
    {"R", 'R', F::none, [](const Sample& x, Random&) { return x.r; }},
    {"V of another camera", 'V', F::different,
     [](const Sample& x, Random&) { return glm::lookAtRH(x.eye + dvec3(0, 1, 0), x.center, x.up); }},
    {"P of another lens", 'P', F::different,
     [](const Sample& x, Random&) {
         return glm::perspectiveRH_NO(glm::radians(x.fovy), x.aspect, 1.5 * x.near, x.far);
     }},
    {"P of another lens in round numbers", 'P', F::different,
     [](const Sample& x, Random& random) {
         const double near = std::round(random.number(1, 20)) / 10.0;
         return glm::perspectiveRH_NO(glm::radians(x.fovy), x.aspect, near, x.far + 10.0);
     }},
    {"P reversed for 0 … 1, of another lens", 'P', F::different,
     [](const Sample& x, Random&) {
         return glm::perspectiveRH_ZO(glm::radians(x.fovy), x.aspect, 3.0 * x.far, x.near);
     }},
    {"P of glFrustum", 'P', F::different,
     [](const Sample& x, Random&) { return glm::frustumRH_NO(-0.2, 0.5, -0.3, 0.4, x.near, x.far); }},
    {"P of an infinite far", 'P', F::different,
     [](const Sample& x, Random&) { return glm::infinitePerspective(glm::radians(x.fovy), x.aspect, x.near); }},
};

template <std::size_t count>
void check(const MatrixCase (&cases)[count]) {
    for (const MatrixCase& one : cases) {
        SCOPED_TRACE(one.name);
        Random random(seed);
        int named_rightly = 0;
        for (int i = 0; i < 200; ++i) {
            const Sample sample(random);
            const ExplainedMatrix found = sample.explained(one.make(sample, random), one.named);
            named_rightly += found.letter == one.letter && found.fault == one.fault ? 1 : 0;
        }
        EXPECT_EQ(named_rightly, 200);
    }
}

TEST(ExplainMatrix, NamesEachWayToSpoilAMatrix) {
    check(spoiled_matrices);
}

TEST(ExplainMatrix, NeverCallsARightMatrixWrong) {
    check(right_matrices);
    // In this state, V and C are the identity and R is symmetric, so they equal their own transposes.
    for (const char named : {'\0', 'V', 'C', 'P', 'S', 'R'}) {
        Params params;
        params.camera.look({{0, 0, 0}, {0, 0, -1}, {0, 1, 0}});
        EXPECT_EQ(explain_matrix(dmat4(1.0), named, params, 1.5).fault, MatrixFault::none) << named;
        EXPECT_EQ(explain_matrix(Sample::mirror({0, 1, 0, 0}), named, params, 1.5).fault, MatrixFault::none);
        EXPECT_EQ(explain_matrix(Sample::shadow({0, 1, 0, 0}, params.lights[0].position), named, params, 1.5).fault,
                  MatrixFault::none);
    }
}

/// The program uploads the S that gives casters a positive w. S as in the lecture and the uploaded one are right.
TEST(ExplainMatrix, BothSignsOfSAreRightIfTheUploadedOneIsNegated) {
    Random random(seed);
    int negative = 0;
    for (int i = 0; i < 200; ++i) {
        const Sample sample(random);
        // The last row of S is (−Lw n, Π·L − Lw d): for a caster p with Lw (n·p + d) < |Π·L|, w has the sign of Π·L.
        const bool is_negative = glm::dot(sample.plane, sample.light) < 0.0;
        for (const double factor : {1.0, 3.0}) EXPECT_EQ(sample.explained(factor * sample.s).fault, F::none);
        EXPECT_EQ(sample.explained(-3.0 * sample.s).fault, is_negative ? F::none : F::negated);
        negative += is_negative;
    }
    EXPECT_GT(negative, 20);
    EXPECT_LT(negative, 180);
}

/// Negated rows of P, V and C, and what the fix does to them.
TEST(ExplainMatrix, ANegatedRowIsNamedAndItsFixIsRight) {
    Random random(seed);
    for (int i = 0; i < 100; ++i) {
        const Sample sample(random);
        for (int axis = 0; axis < 3; ++axis) {
            dvec4 signs(1.0);
            signs[axis] = -1.0;
            const dmat4 flip = diagonal(signs.x, signs.y, signs.z);
            for (const bool is_view : {true, false}) {
                const dmat4 wrong = is_view ? flip * sample.v : sample.c * flip;
                const ExplainedMatrix found = sample.explained(wrong, is_view ? 'V' : 'C');
                EXPECT_EQ(found.fault, F::left_handed) << axis;
                EXPECT_EQ(found.negated_axis, axis);
                const std::optional<dmat4> fixed = fixed_matrix(wrong, found);
                ASSERT_TRUE(fixed);
                EXPECT_EQ(sample.explained(*fixed, is_view ? 'V' : 'C').fault, F::none) << axis;
            }
        }
        for (const dvec2& signs : {dvec2(-1, 1), dvec2(1, -1), dvec2(-1, -1)}) {
            const dmat4 wrong = diagonal(signs.x, signs.y, 1.0) * sample.p;
            const ExplainedMatrix found = sample.explained(wrong);
            EXPECT_EQ(found.letter, 'P');
            EXPECT_EQ(found.fault, F::mirrored);
            EXPECT_EQ(found.lens->mirrored_x, signs.x < 0.0);
            EXPECT_EQ(found.lens->mirrored_y, signs.y < 0.0);
            EXPECT_NEAR(found.lens->fovy_deg, sample.fovy, 1e-6);
            const std::optional<dmat4> fixed = fixed_matrix(wrong, found);
            ASSERT_TRUE(fixed);
            EXPECT_EQ(sample.explained(*fixed).fault, F::none);
        }
    }
}

TEST(ExplainMatrix, AnOrthographicPIsNoCameraAndItsProductWithVIsAProduct) {
    Random random(seed);
    for (int i = 0; i < 100; ++i) {
        Sample sample(random);
        const double height = random.number(2, 9), width = sample.aspect * height;
        const dmat4 p =
            glm::orthoRH_NO(-0.5 * width, 0.5 * width, -0.5 * height, 0.5 * height, sample.near, sample.far);
        const ExplainedMatrix found = sample.explained(p);  // the state is perspective
        EXPECT_EQ(found.letter, 'P');
        EXPECT_EQ(found.fault, F::different);
        EXPECT_TRUE(found.lens && found.lens->orthographic);
        sample.params.projection.type = ProjectionType::orthographic;
        sample.params.projection.height = height;
        EXPECT_EQ(sample.explained(p).fault, F::none);
        EXPECT_EQ(sample.explained(p * sample.v).fault, F::product);
        dmat4 left_handed = p;
        left_handed[2][2] = -left_handed[2][2];
        EXPECT_EQ(sample.explained(left_handed, 'P').letter, 'P');
    }
}

TEST(ExplainMatrix, ASignLostInTheLastRowOfSIsNoOtherLight) {
    Random random(seed);
    for (int i = 0; i < 200; ++i) {
        const Sample x(random);
        if (x.light.w == 0.0) continue;
        dmat4 s = x.s;
        for (int column = 0; column < 3; ++column) s[column][3] = -s[column][3];
        EXPECT_EQ(x.explained(s).fault, MatrixFault::lost_sign);
        EXPECT_EQ(x.explained(s).letter, 'S');
    }
}

TEST(ExplainMatrix, ANameThatSaysAnotherMatrixIsAMistake) {
    Random random(seed);
    const Sample x(random);
    const std::pair<char, dmat4> all[] = {{'V', x.v}, {'C', x.c}, {'P', x.p}, {'S', x.s}, {'R', x.r}};
    for (const auto& [letter, matrix] : all)
        for (const char named : {'\0', 'V', 'C', 'P', 'S', 'R'}) {
            const bool swaps = (letter == 'V' && named == 'C') || (letter == 'C' && named == 'V');
            const ExplainedMatrix found = x.explained(matrix, named);
            EXPECT_EQ(is_misnamed(named, found), named != 0 && named != letter && !swaps) << letter << named;
            EXPECT_EQ(found.fault, swaps ? MatrixFault::inverse : MatrixFault::none) << letter << named;
        }
    EXPECT_TRUE(is_misnamed('R', x.explained(glm::lookAtRH(x.eye + dvec3(0, 1, 0), x.center, x.up), 'R')));
}

TEST(ExplainMatrix, TellsWhatItHolds) {
    Random random(seed);
    for (int i = 0; i < 200; ++i) {
        const Sample x(random), other(random);
        const ExplainedMatrix v = x.explained(other.v), p = x.explained(other.p), s = x.explained(other.s);
        ASSERT_TRUE(v.camera && p.lens && s.found_plane && s.found_light);
        EXPECT_LT(glm::distance(v.camera->eye, other.eye), 1e-9);
        EXPECT_LT(worst_difference(view_from_world(world_from_view(v.camera->eye, v.angles)), other.v), 1e-9);
        EXPECT_NEAR(p.lens->fovy_deg, other.fovy, 1e-9);
        EXPECT_NEAR(p.lens->aspect, other.aspect, 1e-9);
        EXPECT_NEAR(p.lens->near, other.near, 1e-9 * other.far);
        EXPECT_NEAR(p.lens->far, other.far, 1e-7 * other.far * other.far / other.near);
        const double sign = glm::dot(*s.found_plane, other.plane) < 0.0 ? -1.0 : 1.0;
        EXPECT_LT(glm::length(sign * *s.found_plane - other.plane), 1e-9);
        if (other.light.w == 1.0) {
            EXPECT_LT(glm::length(*s.found_light - other.light), 1e-8);
        }
    }
    const ExplainedMatrix far_away = explain_matrix(glm::infinitePerspective(1.0, 2.0, 0.25), 'P', Params{}, 2.0);
    ASSERT_TRUE(far_away.lens);
    EXPECT_TRUE(std::isinf(far_away.lens->far));
    EXPECT_NEAR(far_away.lens->near, 0.25, 1e-12);
    EXPECT_TRUE(explain_matrix(glm::frustumRH_NO(-1.0, 2.0, -1.0, 1.0, 1.0, 9.0), 'P', Params{}, 2.0).lens->off_center);
    EXPECT_EQ(explain_matrix(dmat4(3.0, 1, 4, 1, 5, 9, 2, 6, 5, 3, 5, 8, 9, 7, 9, 3), 0, Params{}, 2.0).letter, 0);
}

TEST(PastedMatrix, ReadsEachLanguage) {
    dmat4 expected;
    for (int i = 0; i < 16; ++i) expected[i % 4][i / 4] = i + 0.5;  // rows 0.5 1.5 2.5 3.5 | 4.5 …
    const std::string rows[] = {
        "np.array([[0.5, 1.5, 2.5, 3.5],\n [4.5, 5.5, 6.5, 7.5], [8.5, 9.5, 10.5, 11.5], [12.5, 13.5, 14.5, 15.5]], "
        "dtype=np.float32)",
        "[[ 0.5  1.5  2.5  3.5]\n [ 4.5  5.5  6.5  7.5]\n [ 8.5  9.5 10.5 11.5]\n [12.5 13.5 14.5 15.5]]",
        "V = [0.5 1.5 2.5 3.5; 4.5 5.5 6.5 7.5; 8.5 9.5 10.5 11.5; 12.5 13.5 14.5 15.5]; % the view",
        R"({"view_from_world": [[0.5,1.5,2.5,3.5],[4.5,5.5,6.5,7.5],[8.5,9.5,10.5,11.5],[12.5,13.5,14.5,15.5]]})",
        "V =\n  0.5 1.5 2.5 3.5\n  4.5 5.5 6.5 7.5\n  8.5 9.5 10.5 11.5\n  12.5 13.5 14.5 15.5\n"};
    for (const std::string& text : rows) {
        const Result<PastedMatrix> pasted = read_pasted_matrix(text);
        ASSERT_TRUE(pasted) << text << pasted.error();
        EXPECT_EQ(pasted->matrix, expected) << text;
        EXPECT_FALSE(pasted->by_columns);
    }
    const std::string columns[] = {
        "const glm::dmat4 view(0.5, 4.5, 8.5, 12.5, 1.5, 5.5, 9.5, 13.5,  // columns\n"
        " 2.5, 6.5, 10.5, 14.5, 3.5, 7.5, 11.5, 15.5);",
        "mat4 V = mat4(vec4(0.5f, 4.5f, 8.5f, 12.5f), vec4(1.5f, 5.5f, 9.5f, 13.5f), vec4(2.5f, 6.5f, 10.5f, 14.5f), "
        "vec4(3.5f, 7.5f, 11.5f, 15.5f));",
        "GLfloat V[16] = {0.5, 4.5, 8.5, 12.5, 1.5, 5.5, 9.5, 13.5, 2.5, 6.5, 10.5, 14.5, 3.5, 7.5, 11.5, 15.5};",
        "[0.5, 4.5, 8.5, 12.5, 1.5, 5.5, 9.5, 13.5, 2.5, 6.5, 10.5, 14.5, 3.5, 7.5, 11.5, 15.5]"};
    for (const std::string& text : columns) {
        const Result<PastedMatrix> pasted = read_pasted_matrix(text);
        ASSERT_TRUE(pasted) << text << pasted.error();
        EXPECT_EQ(pasted->matrix, expected) << text;
        EXPECT_TRUE(pasted->by_columns);
        EXPECT_EQ(pasted->letter, text.front() == '[' ? 0 : 'V');
    }
    EXPECT_EQ(read_pasted_matrix("1 2 3").error(), "a matrix has 16 numbers, but there are 3");
    const std::string rows_of_5 = "5 5 5 5\n5 5 5 5\n5 5 5 5\n5 5 5 5\n";
    EXPECT_EQ(read_pasted_matrix("V =\n   1.0e+03 *\n" + rows_of_5)->matrix[3][3], 5000.0);
    EXPECT_EQ(read_pasted_matrix("V = 2 *\n" + rows_of_5)->matrix[0][0], 10.0);
    EXPECT_FALSE(read_pasted_matrix("V =\n" + rows_of_5)->has_more);
    EXPECT_TRUE(read_pasted_matrix("V =\n" + rows_of_5 + "P =\n" + rows_of_5)->has_more);
    EXPECT_EQ(read_pasted_matrix("nan " + rows_of_5.substr(2)).error(),
              "a matrix has 16 numbers, but there are 15; nan and inf are none");
    EXPECT_EQ(read_pasted_matrix("info 1 2").error(), "a matrix has 16 numbers, but there are 2");
    std::string commas;
    for (int i = 0; i < 16; ++i) commas += "0,5 ";
    EXPECT_EQ(read_pasted_matrix(commas).error(),
              "a matrix has 16 numbers, but there are 32; write decimals with a point instead of a comma");
    EXPECT_EQ(read_pasted_matrix("m[0] = " + rows_of_5 + "m[1] = 3").error(),
              "a matrix has 16 numbers, but there are 19; leave out indices and labels");
    EXPECT_FALSE(read_pasted_matrix(""));
}

/// Prints rows of a matrix as C's printf does; `trims`: without zeros at the end, as C++ streams do.
std::string printed(const dmat4& matrix, const char* format, int places, bool trims) {
    std::string text;
    for (int i = 0; i < 16; ++i) {
        std::array<char, 64> buffer;
        std::snprintf(buffer.data(), buffer.size(), format, places, matrix[i % 4][i / 4]);
        std::string number = buffer.data();
        if (trims && number.find('.') != std::string::npos && number.find('e') == std::string::npos) {
            number.erase(number.find_last_not_of('0') + 1);
            if (number.back() == '.') number.pop_back();
        }
        text += number + (i % 4 == 3 ? "\n" : " ");
    }
    return text;
}

TEST(PastedMatrix, ARightMatrixIsRightHoweverItIsPrinted) {
    struct Style {
        const char* format;
        int least, most;
        bool trims;
    };
    constexpr Style styles[] = {{"%.*f", 3, 9, false},
                                {"%.*f", 3, 9, true},
                                {"%.*g", 5, 9, true},
                                {"%#.*g", 5, 9, false},
                                {"%.*e", 4, 8, false}};
    Random random(seed);
    for (int trial = 0; trial < 40; ++trial) {
        const Sample x(random);
        const std::pair<char, dmat4> all[] = {{'V', x.v}, {'C', x.c}, {'P', x.p}, {'S', x.s}, {'R', x.r}};
        const auto explained = [&](char letter, const std::string& rows) {
            const Result<PastedMatrix> pasted = read_pasted_matrix(std::string(1, letter) + " =\n" + rows);
            EXPECT_TRUE(pasted) << rows << pasted.error();
            return explain_matrix(pasted->matrix, pasted->letter, x.params, x.aspect, pasted->tolerance);
        };
        for (const auto& [letter, matrix] : all) {
            for (const Style& style : styles)
                for (int places = style.least; places <= style.most; ++places) {
                    const std::string rows = printed(matrix, style.format, places, style.trims);
                    const ExplainedMatrix found = explained(letter, rows);
                    EXPECT_EQ(found.letter, letter) << "seed " << seed << "\n" << rows;
                    EXPECT_EQ(found.fault, MatrixFault::none) << "seed " << seed << "\n" << letter << "\n" << rows;
                }
            dmat4 other = matrix;
            other[0][1] += 0.005;
            EXPECT_NE(explained(letter, printed(other, "%.*g", 6, true)).fault, MatrixFault::none) << letter;
        }
    }
}

TEST(PastedMatrix, TheRoundingIsThatOfTheLeastExactEntry) {
    const auto tolerance_of = [](const std::string& text) { return read_pasted_matrix(text)->tolerance; };
    // Six significant digits: 8.20128 has five decimals, 0.00277944 has eight.
    EXPECT_NEAR(tolerance_of("V =\n0.860742 0 -0.509041 0.00277944\n-0.143723 0.959314 -0.243023 -0.713467\n"
                             "0.488331 0.282341 0.825722 -8.20128\n0 0 0 1\n"),
                0.51e-5, 1e-12);
    // Two decimals, with zeros left out.
    EXPECT_NEAR(tolerance_of("0.86 0 -0.5 0.03\n-0.14 0.96 -0.24 -0.71\n0.49 0.28 0.83 -8.2\n0 0 0 1\n"), 0.51e-2,
                1e-9);
    EXPECT_NEAR(tolerance_of("1.25e-01 0 0 0\n0 2.5e-01 0 0\n0 0 1.0e+00 -1.37e-03\n0 0 0 1\n"), 0.51e-2, 1e-9);
    EXPECT_EQ(tolerance_of("1 0 0 0\n0 1 0 0\n0 0 1 -2\n0 0 0 1\n"), 1e-9);
    EXPECT_EQ(tolerance_of("0.0 0.0 0.0 0.0\n0.0 0.0 0.0 0.0\n0.0 0.0 0.0 0.0\n0.0 0.0 0.0 0.0\n"), 1e-9);
}

TEST(PastedMatrix, OtherNumbersMayBeBesideTheMatrix) {
    const std::string rows = "0.5 1.5 2.5 3.5\n4.5 5.5 6.5 7.5\n8.5 9.5 10.5 11.5\n12.5 13.5 14.5 15.5\n";
    const dmat4 expected = read_pasted_matrix(rows)->matrix;
    const std::string texts[] = {
        "S =\n" + rows + "\nthe part of box that is not between light 2 and plane 3 (w = 0.25 there) casts no shadow\n",
        "frame 12, 3 objects\nS\n" + rows + "took 1.25 ms\n",
        R"({"shadow_from_world": [[0.5,1.5,2.5,3.5],[4.5,5.5,6.5,7.5],[8.5,9.5,10.5,11.5],[12.5,13.5,14.5,15.5]],
            "shadow_sign": 1, "problems": ["between light 2 and plane 3"]})",
        R"({"shadow_sign": 1,
            "S": [[0.5,1.5,2.5,3.5],[4.5,5.5,6.5,7.5],[8.5,9.5,10.5,11.5],[12.5,13.5,14.5,15.5]], "camera": 2})"};
    for (const std::string& text : texts) {
        const Result<PastedMatrix> pasted = read_pasted_matrix(text);
        ASSERT_TRUE(pasted) << text << pasted.error();
        EXPECT_EQ(pasted->matrix, expected) << text;
        EXPECT_EQ(pasted->letter, 'S') << text;
        EXPECT_NEAR(pasted->tolerance, 5.1e-3, 1e-9) << text;
    }
    EXPECT_FALSE(read_pasted_matrix("1 2 3 4\n5 6 7 8\nand\n9 10 11 12\n13 14 15 16\n17"));
    EXPECT_FALSE(read_pasted_matrix(std::string(1 << 20, '(')));
    EXPECT_FALSE(read_pasted_matrix("."));
}

}  // namespace
}  // namespace viewing
