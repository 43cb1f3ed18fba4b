// Tests expressions that use all of Lua. Random expressions, most of them hostile, must end within the limits
// with a value or one sentence, and no disguise may hide a word from the check.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cmath>
#include <functional>
#include <random>

#include "lesson/formulas/expression.h"
#include "platform/sanitized.h"
#include "text/words.h"

namespace viewing {
namespace {

constexpr unsigned seed = 20261126;
constexpr ExpressionLimits within_reason{.instructions = 200'000, .memory_bytes = 1U << 20U, .closed_list = false};
constexpr int deepest = 16;  // maximum nesting of lists in a value

/// Provides lists and objects like those of a state, whose tables have metatables; `calls` counts the lookups.
Surroundings counting(int& calls) {
    return {[&calls](const std::string& name, std::span<const double>) -> Result<Json> {
                ++calls;
                if (name == "V") return Json::parse("[[1, 2], [3, 4]]");
                if (name == "camera") return Json::parse(R"({"position": [1, 2, 3], "target": null})");
                return Json(0.5);
            },
            nullptr, nullptr};
}

Result<Json> value_of(const std::string& source, const ExpressionLimits& limits = within_reason) {
    int calls = 0;
    return evaluate(source, counting(calls), limits);
}

std::string function(const std::string& body) {
    return "(function() " + body + " end)()";
}

void expect_one_sentence(const std::string& sentence, const std::string& source) {
    EXPECT_FALSE(sentence.empty()) << source;
    EXPECT_LT(sentence.size(), 300U) << source;
    EXPECT_TRUE(is_utf8(sentence)) << source;
    for (const char c : sentence) EXPECT_TRUE(static_cast<unsigned char>(c) >= 0x20 && c != 0x7f) << sentence;
}

/// Writes a string as a Lua literal with each byte as a numeric escape.
std::string as_lua_bytes(const std::string& bytes) {
    std::string text = "\"";
    for (const char byte : bytes) {
        const std::string number = std::to_string(static_cast<unsigned char>(byte));
        text += "\\" + std::string(3 - number.size(), '0') + number;
    }
    return text + "\"";
}

/// A source and its expected result: a value, an error, or either.
struct Case {
    std::string source;
    std::optional<Json> value = {};
    bool fails = false;
};

class RandomValues {
public:
    explicit RandomValues(unsigned of_seed) : random_(of_seed) {}

    Case next() {
        using Kind = Case (RandomValues::*)();
        constexpr Kind kinds[] = {&RandomValues::plain,  &RandomValues::fan,   &RandomValues::loop,
                                  &RandomValues::deep,   &RandomValues::wide,  &RandomValues::huge_text,
                                  &RandomValues::bytes,  &RandomValues::state, &RandomValues::no_number,
                                  &RandomValues::endless};
        return (this->*kinds[kind_++ % std::size(kinds)])();
    }

private:
    int below(int end) { return std::uniform_int_distribution(0, end - 1)(random_); }

    /// Makes lists of numbers, strings and booleans as literals, so the value is known.
    Json tree(int depth) {
        const int kind = below(depth == 0 ? 3 : 5);
        if (kind == 0) return below(1000) - 500.0;
        if (kind == 1) return below(2) == 0;
        if (kind == 2) return std::string(static_cast<std::size_t>(below(5)), 'q');
        Json list = Json::array();
        for (int i = below(4); i >= 0; --i) list.push_back(tree(depth - 1));
        return list;
    }
    static std::string in_lua(const Json& value) {
        if (!value.is_array()) return value.dump();
        std::string list;
        for (const Json& entry : value) list += in_lua(entry) + ",";
        return "{" + list + "}";
    }
    Case plain() {
        const Json value = tree(4);
        return {in_lua(value), value};
    }

    /// Makes a list that contains another list `width` times, which in turn contains another, and so on. It is small in
    /// Lua but large outside.
    Case fan() {
        const int width = 1 + below(10), levels = 1 + below(8);
        std::string again = "t";
        for (int i = 1; i < width; ++i) again += ",t";
        Case made{
            function("local t = {7} for i = 1, " + std::to_string(levels) + " do t = {" + again + "} end return t")};
        double entries = 0.0;
        for (int level = 0; level <= levels; ++level) entries += std::pow(width, level);
        constexpr double least_bytes = 8.0;  // minimum for an entry outside Lua, in any representation
        made.fails = entries * least_bytes > static_cast<double>(within_reason.memory_bytes);
        if (entries > 4000) return made;
        made.value = Json::array({7.0});
        for (int i = 0; i < levels; ++i) made.value = Json(static_cast<std::size_t>(width), *made.value);
        return made;
    }

    Case loop() {
        const std::string length = std::to_string(1 + below(20));
        return {function("local first = {} local t = first for i = 1, " + length + " do t = {t, i} end first[" +
                         std::to_string(below(2)) + "] = t first[1] = t return t"),
                {},
                true};
    }

    Case deep() {
        const int levels = 1 + below(2 * deepest);
        Case made{function("local t = 1 for i = 1, " + std::to_string(levels) + " do t = {t} end return t")};
        made.fails = levels > deepest;
        if (made.fails) return made;
        made.value = 1.0;
        for (int i = 0; i < levels; ++i) made.value = Json::array({*made.value});
        return made;
    }

    Case wide() {
        const int entries = 1 << below(24);
        Case made{function("local t = {} for i = 1, " + std::to_string(entries) + " do t[i] = i end return t")};
        made.fails = entries >= 1 << 20;
        if (entries > 1 << 12) return made;
        made.value = Json::array();
        for (int i = 1; i <= entries; ++i) made.value->push_back(static_cast<double>(i));
        return made;
    }

    /// Makes a huge string, once or many times in one list.
    Case huge_text() {
        const int doublings = below(40), times = 1 + below(2) * 4000;
        const double bytes = std::pow(2.0, doublings) * times;
        Case made{function("local s = 'x' for i = 1, " + std::to_string(doublings) +
                           " do s = s .. s end local t = {} for i = 1, " + std::to_string(times) +
                           " do t[i] = s end return t")};
        made.fails = bytes > static_cast<double>(within_reason.memory_bytes);
        return made;
    }

    Case bytes() {
        std::string text;
        for (int i = below(6); i >= 0; --i) text += static_cast<char>(below(256));
        if (below(3) == 0) text = "눈 " + std::string(1, '\0') + "²";
        Case made{below(2) == 0 ? as_lua_bytes(text) : "{1, {" + as_lua_bytes(text) + "}}"};
        made.fails = !is_utf8(text);
        if (!made.fails) made.value = made.source.front() == '{' ? Json({1.0, Json::array({text})}) : Json(text);
        return made;
    }

    /// Uses values with metatables. Lists of the state are valid values, but its groups are not.
    Case state() {
        if (below(2) == 0) return {"{V, camera.position}", Json::parse("[[[1.0, 2.0], [3.0, 4.0]], [1.0, 2.0, 3.0]]")};
        constexpr const char* none[] = {"camera",         "{V, camera}", "apply",   "{1, apply}", "{}",
                                        "camera.nothing", "V.rows.x",    "('x').y", "camera[1]",  function_of_state};
        return {none[below(std::size(none))], {}, true};
    }
    static constexpr const char* function_of_state =
        "(function() camera.position = camera camera[0] = camera return camera end)()";

    Case no_number() {
        constexpr const char* sources[] = {"0/0", "{-(0/0), 1/0}", "-1/0", "math", "sqrt(-1)", "{nil}", "1e308 * 10"};
        return {sources[below(std::size(sources))]};
    }

    Case endless() {
        constexpr const char* bodies[] = {"while true do end",
                                          "local s = 'x' while true do s = s .. 'x' end",
                                          "local function f(n) return 1 + f(n + 1) end return f(1)",
                                          "local function f(n) return f(n + 1) end return f(1)",
                                          "while true do local t = {{}, {}, {}} end",
                                          "while true do depth_step(1) end",
                                          "while true do local c = camera end",
                                          "local t = {} while true do t = {t} end",
                                          "local t = {} while true do t[{}] = t end",
                                          "::again:: goto again"};
        return {function(bodies[below(std::size(bodies))]), {}, true};
    }

    std::mt19937 random_;
    std::size_t kind_ = 0;
};

long peak_megabytes() {
    rusage used{};
    ::getrusage(RUSAGE_SELF, &used);
    return used.ru_maxrss / 1024;
}

TEST(ExpressionLimits, RandomValuesEndWithinThemOrWithOneSentence) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomValues values(seed);
    const long before_mb = peak_megabytes();
    int failed = 0, known = 0;
    for (int i = 0; i < 360; ++i) {
        const Case made = values.next();
        const Result<Json> value = value_of(made.source);
        EXPECT_FALSE(made.fails && value) << made.source;
        if (made.value) {
            ++known;
            ASSERT_TRUE(value) << made.source << ": " << value.error();
            EXPECT_EQ(*value, *made.value) << made.source;
        }
        if (value) continue;
        ++failed;
        expect_one_sentence(value.error(), made.source);
    }
    EXPECT_GT(failed, 120) << "most cases are hostile";
    EXPECT_GT(known, 80) << "many cases have a known value";
    if (!is_sanitized) {  // a sanitizer keeps freed memory for a while and adds redzones
        EXPECT_LT(peak_megabytes() - before_mb, 200) << "1 MB in Lua and as much outside for each";
    }
}

TEST(ExpressionLimits, SharedListsCountOncePerCopy) {
    const auto fan = [](int levels) {
        return function("local t = {1,1,1,1,1,1,1,1,1,1} for i = 1, " + std::to_string(levels) +
                        " do t = {t,t,t,t,t,t,t,t,t,t} end return t");
    };
    ExpressionLimits roomy = within_reason;
    roomy.instructions = 100'000'000;
    EXPECT_TRUE(value_of(fan(2), roomy));
    EXPECT_EQ(value_of(fan(5), roomy).error(), "needs too much memory");
    ExpressionLimits patient = within_reason;
    patient.memory_bytes = 1U << 30U;
    EXPECT_EQ(value_of(fan(5), patient).error(), "takes too long");
    for (const int levels : {9, 13}) EXPECT_FALSE(value_of(fan(levels), {.closed_list = false})) << levels;
}

TEST(ExpressionLimits, StringThatIsNotUtf8IsRefused) {
    EXPECT_EQ(value_of("\"\\xff\"").error(), "its value \\xff is not valid UTF-8");
    EXPECT_EQ(*value_of("'a\\0b'"), std::string("a\0b", 3));
}

TEST(ExpressionLimits, EachMeasuredCallCosts) {
    const auto calls_of = [](int calls, bool& has_value) {
        std::string source = "depth_step(1)";
        for (int i = 1; i < calls; ++i) source += " + depth_step(1)";
        int counted = 0;
        has_value = static_cast<bool>(evaluate(source, counting(counted)));
        return counted;
    };
    bool has_value = false;
    EXPECT_EQ(calls_of(40, has_value), 40);
    EXPECT_TRUE(has_value);
    EXPECT_LE(calls_of(200, has_value), 50);
    EXPECT_FALSE(has_value);
}

// ---- words ----------------------------------------------------------------------------------------------------------

/// Returns spaces and comments that may separate two tokens. The word inside the comments is not a name.
std::vector<std::string> comments_around(const std::string& word) {
    return {" --" + word + "\n",
            " --'" + word + "\n",
            " --[" + word + "\r",
            " --[=" + word + "\n",
            " --[[" + word + "\n" + word + "]]",
            " --[==[ ]] ' " + word + " ]=] \" ]==]",
            " --[[ -- ]]",
            "\t\v\f\n"};
}

/// Returns strings that contain this word.
std::vector<std::string> texts_around(const std::string& word) {
    return {"'" + word + "'",    "\"--" + word + "\"",        "'\\'" + word + "\"'",  "\"\\\\\" .. '" + word + "'",
            "[[" + word + "']]", "[=[ ]] " + word + " --]=]", "'\\z\n " + word + "'", "[[--]] .. '" + word + "'"};
}

TEST(ExpressionWords, CommentsAndStringsHideNothing) {
    std::mt19937 random(seed);
    const auto one_of = [&](const std::vector<std::string>& of) {
        return of[std::uniform_int_distribution<std::size_t>(0, of.size() - 1)(random)];
    };
    const std::string word = "zzz";
    for (int i = 0; i < 400; ++i) {
        std::string source = "1", hostile;
        const int operands = std::uniform_int_distribution(1, 4)(random);
        const int at = std::uniform_int_distribution(0, operands - 1)(random);
        for (int k = 0; k < operands; ++k) {
            source += one_of(comments_around(word)) + " .. " + one_of(comments_around(word));
            if (k == at) hostile = source + word;
            source += one_of(texts_around(word));
            if (k == at) continue;
            if (!hostile.empty()) hostile += " .. 'x'";
        }
        EXPECT_TRUE(check_expression(source)) << source << ": " << check_expression(source).error();
        EXPECT_EQ(check_expression(hostile).error(), "unknown name zzz") << hostile;
    }
}

TEST(ExpressionWords, StatementsAreRefusedInAnyDisguise) {
    const std::string hidden[] = {"(function() return true end)()", "(--'\n(function() return true end)() --'\n)",
                                  "([[']] and (function() return true end)())", "(--[[']]function() end--'\n)()"};
    for (const std::string& source : hidden) {
        EXPECT_EQ(
            check_expression(source).error(),
            "function is not allowed: the only Lua keywords in an expression are and, or, not, true, false and nil")
            << source;
        int calls = 0;
        EXPECT_EQ(evaluate(source, counting(calls)).error(), check_expression(source).error()) << source;
    }
}

TEST(ExpressionWords, MemberIsNotANameButAWordAfterTwoDotsIs) {
    EXPECT_TRUE(check_expression("camera.zzz .. camera --.\n.zzz .. .5e3 .. 0x1fp2"));
    EXPECT_FALSE(check_expression("1 ..zzz"));
    EXPECT_FALSE(check_expression("camera.yaw ..zzz"));
    EXPECT_FALSE(check_expression("V:zzz()"));
}

TEST(ExpressionWords, NamesInStringsAndCommentsAreNotMeasured) {
    EXPECT_TRUE(is_measured("1 + --'\n fighting().x --'"));
    EXPECT_FALSE(is_measured("'fighting()' --fighting()"));
    EXPECT_FALSE(is_measured("[[fighting()]] .. camera.order"));
}

}  // namespace
}  // namespace viewing
