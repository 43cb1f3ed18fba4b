// The derivations as lists of lines: their numbers are right, and each step shows one more line.
#include "topics/planes/shown/derivation_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "text/numbers.h"
#include "unit/geometry/random.h"

namespace viewing {
namespace {

using Lines = std::vector<DerivationLine>;

/// Returns the number after the last "= " of the last line that starts with `begin`.
double last_number(const Lines& lines, const std::string& begin) {
    for (auto line = lines.rbegin(); line != lines.rend(); ++line) {
        if (line->parts.empty() || line->parts.front() != begin || line->parts.size() < 2) continue;
        std::string text = line->parts.back();
        if (!text.starts_with("= ")) text = line->parts[line->parts.size() - 2];
        text = text.substr(2);
        const bool is_negative = text.starts_with("−");
        return (is_negative ? -1.0 : 1.0) * std::stod(is_negative ? text.substr(std::string("−").size()) : text);
    }
    ADD_FAILURE() << "no line " << begin;
    return 0.0;
}

bool has(const Lines& lines, const std::string& name, const std::string& part) {
    return std::any_of(lines.begin(), lines.end(), [&](const DerivationLine& line) {
        return line.parts.front() == name && std::find(line.parts.begin(), line.parts.end(), part) != line.parts.end();
    });
}

TEST(DerivationLines, BlinnsLeadsFromSimilarTrianglesToTheDivisionByW) {
    // l = (2, 6, 1), p = (1, 2, −1): t = 6/4, s = (0.5, 0, −2).
    const ShadowDerivation found = derive_shadow({0, 1, 0, 0}, {2, 6, 1, 1}, {1, 2, -1});
    const Lines lines = shadow_lines(found, true);
    EXPECT_TRUE(has(lines, "(s_x − l_x)/(p_x − l_x)", "= l_y/(l_y − p_y)"));
    EXPECT_TRUE(has(lines, "s_x", "= (l_y p_x − l_x p_y)/(l_y − p_y)"));
    EXPECT_NEAR(last_number(lines, "s_x"), 0.5, 1e-9);
    EXPECT_NEAR(last_number(lines, "s_z"), -2.0, 1e-9);
    EXPECT_TRUE(has(lines, "w", "= −p_y + l_y"));
    EXPECT_NEAR(last_number(lines, "w"), 4.0, 1e-9);
}

TEST(DerivationLines, HoldForAnyPlaneAndLight) {
    Random random(seed);
    for (int trial = 0; trial < 200; ++trial) {
        const glm::dvec4 plane(random.direction(), random.number(-2.0, 2.0));
        const double w = trial % 3 == 0 ? 0.0 : trial % 3 == 1 ? 1.0 : random.number(0.1, 3.0);
        const glm::dvec4 light(random.vec3(5.0), w);
        const glm::dvec3 p = random.vec3(3.0);
        const ShadowDerivation found = derive_shadow(plane, light, p);
        const Lines lines = shadow_lines(found, false);
        if (!found.shadow_world || std::abs(found.w) < 0.1) continue;
        SCOPED_TRACE("seed " + std::to_string(seed) + " trial " + std::to_string(trial));
        // S itself must give the same numbers: S p = (P·L) p − (P·p) L.
        const double to_light = glm::dot(plane, light), to_point = glm::dot(plane, glm::dvec4(p, 1.0));
        const glm::dvec4 sent = to_light * glm::dvec4(p, 1.0) - to_point * light;
        EXPECT_NEAR(last_number(lines, "w"), sent.w, 6e-4);
        const auto of_sent = std::find_if(lines.begin(), lines.end(), [](const DerivationLine& line) {
            return line.parts.front() == "S p" && line.parts.back().starts_with("= (");
        });
        ASSERT_NE(of_sent, lines.end());
        const std::vector<double> numbers = numbers_in(of_sent->parts.back());
        ASSERT_EQ(numbers.size(), 3U);
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(numbers[i], sent[i], 6e-4);
        if (light.w == 0.0) continue;
        EXPECT_NEAR(last_number(lines, "s_x"), sent.x / sent.w, 6e-4);
        EXPECT_NEAR(last_number(lines, "s_y"), sent.y / sent.w, 6e-4);
        EXPECT_NEAR(last_number(lines, "s_z"), sent.z / sent.w, 6e-4);
    }
}

TEST(DerivationLines, AppearOneByOne) {
    const Lines lines = mirror_lines(derive_mirror({0, 1, 0, 0}, {1, 2, 3}));
    const int steps = step_count(lines);
    EXPECT_EQ(steps, 7);  // k, foot, q′, three rows and a note; the heading comes with the first row
    EXPECT_TRUE(lines_until(lines, 0).empty());
    EXPECT_EQ(lines_until(lines, 1).size(), 1U);
    EXPECT_EQ(lines_until(lines, 3).size(), 3U) << "a heading needs a line below it";
    EXPECT_EQ(lines_until(lines, 4).size(), 5U);
    EXPECT_EQ(lines_until(lines, 4)[3].kind, DerivationLine::Kind::heading);
    for (const int all : {-1, steps, steps + 5}) EXPECT_EQ(lines_until(lines, all).size(), lines.size());
}

}  // namespace
}  // namespace viewing
