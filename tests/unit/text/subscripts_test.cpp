// Subscripts in sentences.
#include "text/subscripts.h"

#include <gtest/gtest.h>

namespace viewing::test {
namespace {

using Parts = std::vector<TextPart>;

TEST(Subscripts, AreTheLettersBehindASingleLetter) {
    EXPECT_EQ(subscript_parts("w = ℓ_y − p_y."), (Parts{{"w = ℓ"}, {"y", true}, {" − p"}, {"y", true}, {"."}}));
    EXPECT_EQ(subscript_parts("z_ndc"), (Parts{{"z"}, {"ndc", true}}));
    EXPECT_EQ(subscript_parts("−l_w Πᵀ"), (Parts{{"−l"}, {"w", true}, {" Πᵀ"}}));
    EXPECT_EQ(subscript_parts("l_y는 R_y R_x"),
              (Parts{{"l"}, {"y", true}, {"는 R"}, {"y", true}, {" R"}, {"x", true}}));
}

TEST(Subscripts, AreNotInNames) {
    for (const char* text : {"glCullFace(GL_BACK)", "walk_slows", "plane_dot_light", "gl_FragDepth", "a_window", "l_y1",
                             "x_y_z", "_y", "l_", "aℓ_y", "ℓ_y1", "l_ y", "", "plain"}) {
        const Parts parts = subscript_parts(text);
        EXPECT_EQ(parts.size(), *text == '\0' ? 0U : 1U) << text;
    }
}

}  // namespace
}  // namespace viewing::test
