// Expressions of lesson files: their values, checked against numbers computed by hand, and proof that none can do harm.
#include "lesson/formulas/expression.h"

#include <gtest/gtest.h>

#include "lesson/formulas/names.h"

namespace viewing {
namespace {

Surroundings around() {
    Surroundings result;
    result.look_up = [](const std::string& name, std::span<const double> arguments) -> Result<Json> {
        if (name == "V") return Json::parse("[[1, 0, 0, -2], [0, 1, 0, -1], [0, 0, 1, -10], [0, 0, 0, 1]]");
        if (name == "camera") return Json::parse(R"({"position": [2, 1, 10], "yaw": 30, "target": null})");
        if (name == "depth_step") return Json(arguments[0] * arguments[0] / 128.0);
        if (name == "problems") return Json::array({"one", "two"});
        return Error{name + " is not here"};
    };
    result.answer = Json::array({2, 1, -10});
    return result;
}

double number(const std::string& expression) {
    const Result<Json> value = evaluate(expression, around());
    EXPECT_TRUE(value) << expression << ": " << (value ? "" : value.error());
    return value && value->is_number() ? value->get<double>() : -12345.0;
}

bool truth(const std::string& expression) {
    const Result<bool> value = holds(expression, around());
    EXPECT_TRUE(value) << expression << ": " << (value ? "" : value.error());
    return value && *value;
}

/// Allows functions and loops, which the word check would otherwise refuse first.
constexpr ExpressionLimits anything{.closed_list = false};

std::string trouble(const std::string& expression, const ExpressionLimits& limits = anything) {
    const Result<Json> value = evaluate(expression, around(), limits);
    EXPECT_FALSE(value) << expression;
    return value ? "" : value.error();
}

TEST(Expression, ListsOfTheStateCountFromZero) {
    EXPECT_EQ(number("V[2][3]"), -10.0);
    EXPECT_EQ(number("camera.position[1]"), 1.0);
    EXPECT_EQ(number("answer[2]"), -10.0);
    EXPECT_EQ(number("#V"), 4.0);
    EXPECT_EQ(number("count(problems)"), 2.0);
    EXPECT_EQ(number("count({1, 2, 3})"), 3.0);
    EXPECT_TRUE(truth("camera.target == nil"));
}

TEST(Expression, UnterminatedStringIsRefused) {
    for (const char* const source : {"\"", "'", "\"\\", "near == \"abc\\", "'a\\'"})
        EXPECT_FALSE(check_expression(source)) << source;
}

TEST(Expression, BracesAlsoMakeAVector) {
    EXPECT_EQ(number("apply(V, {0, 0, 0})[2]"), -10.0);
    EXPECT_TRUE(truth("close(apply(V, camera.position), {0, 0, 0}, 1e-12)"));
    EXPECT_TRUE(truth("close(answer, {2, 1, -10}, 0) and not close(answer, {2, 1}, 1)"));
}

TEST(Expression, MathMatchesValuesComputedByHand) {
    EXPECT_NEAR(number("depth_step(4)"), 0.125, 0.0);
    EXPECT_NEAR(number("degrees(2 * atan(tan(22.5)))"), 58.31, 0.01);  // 45 mistaken for radians
    EXPECT_NEAR(number("det({{2, 0, 0}, {0, 3, 0}, {0, 0, -4}})"), -24.0, 1e-12);
    EXPECT_NEAR(number("det({{0, 1}, {1, 0}})"), -1.0, 1e-12);
    EXPECT_NEAR(number("det({{1, 2}, {2, 4}})"), 0.0, 0.0);
    EXPECT_NEAR(number("norm({3, 4})"), 5.0, 1e-12);
    EXPECT_NEAR(number("dot({1, 2, 3}, {4, 5, 6})"), 32.0, 0.0);
    EXPECT_TRUE(truth("close(cross({1, 0, 0}, {0, 1, 0}), {0, 0, 1}, 0)"));
    EXPECT_TRUE(truth("close(unit({0, 2, 0, 1}), {0, 1, 0, 0.5}, 0)"));
    EXPECT_TRUE(truth("close(mul(V, inverse(V)), identity, 1e-12)"));
    EXPECT_TRUE(truth("close(times(rotation_y(90), {1, 0, 0, 1}), {0, 0, -1, 1}, 1e-12)"));
    EXPECT_TRUE(truth("close(times(rotation_x(90), {0, 1, 0, 1}), {0, 0, 1, 1}, 1e-12)"));
    EXPECT_TRUE(truth("close(times(rotation_z(90), {1, 0, 0, 1}), {0, 1, 0, 1}, 1e-12)"));
    EXPECT_TRUE(truth("close(mul(translation({1, 2, 3}), {0, 0, 0, 1}), {1, 2, 3, 1}, 0)"));
    EXPECT_TRUE(truth("close(transpose({{1, 2}, {3, 4}}), {{1, 3}, {2, 4}}, 0)"));
    EXPECT_TRUE(truth("same_map({1, -2, 4}, {-2, 4, -8}, 1e-12) and not same_map({1, 2}, {1, 2.1}, 1e-3)"));
    // A floor mirrors y. A light 4 above the floor flattens points onto it along the rays.
    EXPECT_TRUE(truth("close(apply(reflection_matrix({0, 1, 0, 0}), {1, 2, 3}), {1, -2, 3}, 1e-12)"));
    EXPECT_TRUE(truth("close(apply(shadow_matrix({0, 1, 0, 0}, {0, 4, 0, 1}), {1, 2, 0}), {2, 0, 0}, 1e-12)"));
    EXPECT_EQ(number("min(3, 1, 2) + max(3, 1, 2)"), 4.0);
}

TEST(Expression, ErrorIsOneSentence) {
    EXPECT_EQ(trouble("camera.positon"), "camera has no positon; did you mean position?");
    EXPECT_EQ(trouble("camera.position[3]"), "camera.position has 3 elements, counted from 0, but no [3]");
    EXPECT_EQ(trouble("camera.position.x"), "camera.position has numbered members: camera.position[0]");
    EXPECT_EQ(trouble("inverse({{1, 2}, {2, 4}})"), "the matrix has no inverse");
    EXPECT_NE(trouble("apply(V, {1, 2})").find("must have 3 entries"), std::string::npos);
    EXPECT_NE(trouble("close(V, 1)").find("number expected"), std::string::npos);
    EXPECT_EQ(trouble("S"), "S is not here");
    EXPECT_EQ(trouble("reversed()"), "bad argument #1 to 'reversed' (table expected, got no value)");
    // With several wrong arguments, the first is named, whatever order the compiler reads them in.
    for (const char* const wrong : {"times(1, 1)", "close('a', 'b', 'c')", "shadow_matrix({1}, {2})"})
        EXPECT_TRUE(trouble(wrong).starts_with("bad argument #1 to")) << wrong << ": " << trouble(wrong);
    EXPECT_NE(trouble("apply"), "");
    EXPECT_EQ(holds("1 + 1", around()).error(), "must be true or false, got the number 2");
    for (const char* const broken : {"1 +", "V[", "}", "", "a b", "\"", "1 = 2"})
        EXPECT_NE(trouble(broken), "") << broken;
}

TEST(Expression, UnknownNameIsReportedBeforeRunning) {
    EXPECT_TRUE(check_expression("close(V, identity, 1e-9) and camera.yaw == 30 and 'x' ~= \"function\""));
    EXPECT_EQ(check_expression("clos(V, identity, 1)").error(), "unknown name clos; did you mean close?");
    for (const char* const forbidden :
         {"os.exit()", "io.open('x')", "require('os')", "load('1')()", "dofile('x')", "print(1)", "_G", "_ENV",
          "string", "setmetatable({}, {})", "(function() return 1 end)()", "pcall(V)", "debug"})
        EXPECT_FALSE(check_expression(forbidden)) << forbidden;
}

TEST(Expression, LuaLibrariesAreUnavailable) {
    for (const char* const forbidden : {"os.exit()", "io", "require", "load", "print", "_G", "string", "setmetatable",
                                        "rawset", "coroutine", "collectgarbage", "('x'):rep(9)"})
        EXPECT_NE(trouble(forbidden), "") << forbidden;
    EXPECT_NE(trouble("(function() x = 1 end)()").find("cannot assign"), std::string::npos);
}

TEST(Expression, EndlessLoopsHugeStringsAndDeepRecursionEnd) {
    EXPECT_EQ(trouble("(function() while true do end end)()"), "takes too long");
    EXPECT_EQ(trouble("(function() local t = {} for i = 1, 1e9 do t[i] = {} end end)()",
                      {.instructions = 2'000'000'000, .closed_list = false}),
              "needs too much memory");
    EXPECT_EQ(trouble("(function() local s = 'x' while true do s = s .. s end end)()"), "needs too much memory");
    EXPECT_NE(trouble("(function() local f f = function() return 1 + f() end return f() end)()"), "");
    EXPECT_NE(trouble("(function() local t = {} t[1] = t return t end)()"), "");
    const std::string deep = std::string(1500, '(') + "1" + std::string(1500, ')');
    EXPECT_NE(trouble(deep), "");
    EXPECT_NE(trouble(std::string(5000, '1')), "");
    std::string lists;
    for (int i = 0; i < 100; ++i) lists = "{" + lists + "}";
    EXPECT_NE(trouble(lists), "");
}

TEST(Expression, EveryNameIsExplained) {
    for (const ExpressionName& name : expression_names()) {
        EXPECT_FALSE(name.help.empty()) << name.name;
        EXPECT_TRUE(check_expression(name.name)) << name.name;
    }
}

}  // namespace
}  // namespace viewing
