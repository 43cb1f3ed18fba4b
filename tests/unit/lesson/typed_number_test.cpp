// Input that students type into a number field.
#include "lesson/formulas/typed_number.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

namespace viewing::test {
namespace {

TEST(TypedNumber, IsAFormulaOfTheLessonLanguage) {
    const std::pair<const char*, double> formulas[] = {
        {"4/2.7", 1.48148148148148},
        {"sqrt(2)/2", 0.70710678118654752},
        {"−√(2)", -1.4142135623730951},
        {"cos(30°)", 0.86602540378443865},
        {"cos(radians(30))", 0.86602540378443865},
        {"cos(30)", 0.15425144988758405},
        {"π/2", 1.5707963267948966},
        {"2·3 − 1", 5.0},
        {"6×7÷2", 21.0},
        {"30°", 30.0},
        {"2^0.5", 1.4142135623730951},
    };
    for (const auto& [text, value] : formulas) {
        ASSERT_TRUE(typed_number(text)) << text;
        EXPECT_NEAR(*typed_number(text), value, 1e-12) << text;
    }
}

TEST(TypedNumber, IsNoneForAnythingElse) {
    for (const char* text : {"", " ", "abc", "1/0", "4,0/2.7", "1 2", "2/", "camera.yaw", "V[3][0]", "answer", "pi)",
                             "'4'", "{1, 2}", "sqrt(-1)", "true", "2 sqrt(3)", "1 -- 2", "error()"})
        EXPECT_FALSE(typed_number(text)) << text;
    EXPECT_FALSE(typed_number(std::string(60, '(') + "2^2^2^2^2^2"));
}

}  // namespace
}  // namespace viewing::test
