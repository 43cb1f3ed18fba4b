// Runs the lecture's code: a small parser for C expressions evaluates every line and fills an array of sixteen numbers.
// The array is read column by column, as GL does, and compared with S and R, which are defined by their effect on
// points.
#include "topics/planes/numbers/lecture_code.h"

#include <gtest/gtest.h>

#include <sstream>

#include "unit/geometry/random.h"

namespace viewing {
namespace {

/// The variables plane, lightpos and dot of the lecture's function, which computes dot in the same way.
struct Arguments {
    glm::dvec4 plane, light;
    double dot = plane[0] * light[0] + plane[1] * light[1] + plane[2] * light[2] + plane[3] * light[3];
};

double factor_of(const std::string& word, const Arguments& arguments) {
    if (word == "dot") return arguments.dot;
    const std::size_t bracket = word.find('[');
    if (bracket == std::string::npos) return std::stod(word);
    const int index = std::stoi(word.substr(bracket + 1));
    return word.substr(0, bracket) == "plane" ? arguments.plane[index] : arguments.light[index];
}

/// Evaluates a sum of products, given as words separated by spaces.
double evaluate(const std::string& expression, const Arguments& arguments) {
    std::istringstream words(expression);
    double sum = 0.0, product = 1.0, sign = 1.0;
    bool has_factor = false;
    for (std::string word; words >> word;) {
        if (word == "*") continue;
        if (word == "-") {
            if (has_factor) sum += sign * product;
            product = 1.0;
            sign = -1.0;
            has_factor = false;
            continue;
        }
        product *= factor_of(word, arguments);
        has_factor = true;
    }
    return sum + sign * product;
}

/// Returns the matrix that GL reads from the array after the function has run; entries that no line sets are NaN.
glm::dmat4 read_by_gl(const CodeLines& lines, const Arguments& arguments) {
    std::array<double, 16> array;
    array.fill(std::nan(""));
    for (const CodeLine& line : lines)
        array[static_cast<std::size_t>(line.index)] = evaluate(line.expression, arguments);
    glm::dmat4 matrix;
    for (std::size_t i = 0; i < 16; ++i) matrix[static_cast<int>(i / 4)][static_cast<int>(i % 4)] = array[i];
    return matrix;
}

/// Expects each line to state the correct place in GL's matrix and the correct value for its entry.
void expect_entries(const CodeLines& lines, const glm::dmat4& matrix) {
    for (int index = 0; index < 16; ++index) {
        const CodeLine& line = lines[static_cast<std::size_t>(index)];
        EXPECT_EQ(line.index, index);
        EXPECT_EQ(4 * line.column + line.row, index);
        EXPECT_NEAR(line.value, matrix[line.column][line.row], 1e-12) << line.expression;
    }
}

TEST(LectureCode, IsThatOfTheSlides) {
    const glm::dvec4 plane(0, 1, 0, 0), light(1, 2, 3, 1);
    const CodeLines shadow = shadow_code(plane, light);
    EXPECT_EQ(shadow[0].expression, "dot - lightpos[0] * plane[0]");
    EXPECT_EQ(shadow[4].expression, "0.f - lightpos[0] * plane[1]");
    EXPECT_EQ(shadow[11].expression, "0.f - lightpos[3] * plane[2]");
    const CodeLines printed = mirror_code(plane, true);
    EXPECT_EQ(printed[3].expression, "- 2 * plane[0] * plane[3]");
    EXPECT_EQ(printed[4].expression, "- 2 * plane[1] * plane[0]");
    EXPECT_EQ(printed[10].expression, "1 - 2 * plane[2] * plane[2]");
    EXPECT_EQ(printed[12].expression, "0.0");
    EXPECT_EQ(mirror_code(plane, false)[12].expression, "- 2 * plane[0] * plane[3]");
}

TEST(LectureCode, ShadowMatrixProjectsPointsAlongTheirRays) {
    Random random(seed);
    for (int i = 0; i < 300; ++i) {
        const glm::dvec4 plane(random.direction(), random.number(-5, 5));
        const Arguments arguments{plane, {random.vec3(8.0), i % 3 * 0.5}};
        const CodeLines lines = shadow_code(plane, arguments.light);
        const glm::dmat4 read = read_by_gl(lines, arguments);
        expect_entries(lines, read);
        // S² = (Π·L) S, S L = 0, and points of the plane stay where they are: only one matrix satisfies all three.
        EXPECT_LT(worst_difference(read * read, arguments.dot * read), 1e-9);
        EXPECT_LT(glm::length(read * arguments.light), 1e-9);
        const glm::dvec3 foot = -plane.w * glm::dvec3(plane);
        const glm::dvec4 in_plane(foot + glm::cross(glm::dvec3(plane), random.vec3(3.0)), 1.0);
        EXPECT_LT(glm::length(read * in_plane - arguments.dot * in_plane), 1e-9);
    }
}

TEST(LectureCode, ReflectionMatrixByColumnsReflects) {
    Random random(seed);
    for (int i = 0; i < 300; ++i) {
        const glm::dvec4 plane(random.direction(), random.number(-5, 5));
        const CodeLines lines = mirror_code(plane, false);
        const glm::dmat4 read = read_by_gl(lines, {plane, glm::dvec4(0.0)});
        expect_entries(lines, read);
        const glm::dvec4 point(random.vec3(6.0), 1.0);
        const glm::dvec3 expected = glm::dvec3(point) - 2.0 * glm::dot(plane, point) * glm::dvec3(plane);
        EXPECT_LT(glm::length(read * point - glm::dvec4(expected, 1.0)), 1e-12);
    }
}

TEST(LectureCode, GlReadsTheTransposeOfThePrintedCode) {
    Random random(seed);
    for (int i = 0; i < 300; ++i) {
        const double d = i % 5 == 0 ? 0.0 : random.number(-5, 5);
        const glm::dvec4 plane(random.direction(), d);
        const Arguments arguments{plane, glm::dvec4(0.0)};
        const CodeLines lines = mirror_code(plane, true);
        const glm::dmat4 printed = read_by_gl(lines, arguments),
                         right = read_by_gl(mirror_code(plane, false), arguments);
        expect_entries(lines, printed);
        EXPECT_EQ(printed, glm::transpose(right));
        const bool is_right = worst_difference(printed, right) < 1e-12;
        EXPECT_EQ(is_right, d == 0.0) << "d = " << d;
        // The translation is in the bottom row, so w is no longer 1.
        const glm::dvec4 point(random.vec3(6.0), 1.0);
        EXPECT_NEAR((printed * point).w, 1.0 - 2.0 * d * glm::dot(glm::dvec3(plane), glm::dvec3(point)), 1e-12);
    }
}

}  // namespace
}  // namespace viewing
