// Texts with {expressions}, filled with values given by hand.
#include "lesson/filled_text.h"

#include <gtest/gtest.h>

#include <limits>

namespace viewing {
namespace {

Surroundings light_at(double x) {
    Surroundings result;
    result.look_up = [x](const std::string&, std::span<const double>) -> Result<Json> {
        return Json{{"position", {x, 5.2, -1.0}}};
    };
    return result;
}

TEST(FilledText, HasTheValuesInEveryLanguage) {
    const LessonText text{
        {"t = {light.position[1]} / 3.8 = {light.position[1] / 3.8}.", "t는 {light.position}입니다."}};
    EXPECT_TRUE(has_places(text));
    const Result<LessonText> told = filled(text, light_at(2.0));
    ASSERT_TRUE(told) << told.error();
    EXPECT_EQ(told->by_language[0], "t = 5.2 / 3.8 = 1.368.");
    EXPECT_EQ(told->by_language[1], "t는 (2, 5.2, −1)입니다.");
    EXPECT_FALSE(has_places(*told));
}

TEST(FilledText, StaysAsItIsIfItCannotBeFilled) {
    for (const char* const wrong : {"{1 +", "{1 +}", "{light.color}"}) {
        const LessonText text{{wrong, ""}};
        EXPECT_FALSE(filled(text, light_at(2.0))) << wrong;
        EXPECT_EQ(filled_or_same(text, light_at(2.0)), text) << wrong;
    }
    const Result<LessonText> nothing =
        filled(LessonText{{"{light.position[0]}", ""}}, light_at(std::numeric_limits<double>::quiet_NaN()));
    ASSERT_FALSE(nothing);
    EXPECT_EQ(nothing.error(), "{light.position[0]} has no value");
}

}  // namespace
}  // namespace viewing
