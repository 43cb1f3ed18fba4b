// Tests that `matrices` prints the chosen matrices in every format, as digits and as symbols, so that Python and LaTeX
// can read them.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "cli/program.h"

namespace cli_tests {
namespace {

using Json = nlohmann::json;
using Words = std::vector<std::string>;

/// Settings that create two planes and two lights; the first light is behind the second plane.
const Words two{"--set", R"(planes=[{"equation":[0,0,-2,-6]}])", "--set", R"(lights=[{"position":[1,4,2,0]}])"};

class ChosenMatrices : public Program {
protected:
    Ended matrices(const Words& more) const {
        Words words{"matrices"};
        words.insert(words.end(), two.begin(), two.end());
        words.insert(words.end(), more.begin(), more.end());
        return expect(0, words);
    }
};

TEST_F(ChosenMatrices, ArePrintedInTheGivenOrder) {
    const Json all = matrices({}).json();
    const auto some = nlohmann::ordered_json::parse(matrices({"--only", "R,S[2,1],PV,S[2,2],R[2],C,S"}).out);
    std::string keys;
    for (const auto& [key, value] : some.items()) keys += key + " ";
    EXPECT_EQ(keys,
              "mirror_from_world shadow_from_world[2,1] shadow_sign[2,1] clip_from_world shadow_from_world[2,2] "
              "shadow_sign[2,2] mirror_from_world[2] world_from_view shadow_from_world shadow_sign problems "
              "problem_details ");
    const Json chosen = some;
    EXPECT_EQ(chosen["shadow_from_world"], all["shadow_from_world"]);
    EXPECT_EQ(chosen["clip_from_world"], all["clip_from_world"]);
    EXPECT_EQ(chosen["mirror_from_world[2]"], all["planes"][1]["mirror_from_world"]);
    for (std::size_t light : {0, 1}) {
        const std::string index = "[2," + std::to_string(light + 1) + "]";
        EXPECT_EQ(chosen["shadow_from_world" + index], all["planes"][1]["shadows"][light]["shadow_from_world"]);
        EXPECT_EQ(chosen["shadow_sign" + index], all["planes"][1]["shadows"][light]["shadow_sign"]);
    }
    EXPECT_EQ(chosen["shadow_sign[2,1]"], -1);
}

TEST_F(ChosenMatrices, UnknownNamesAreRefused) {
    for (const char* list : {"X", "", "S,", "S[1]", "S[1,1,1]", "S[1,1", "V[1]", "R[1,1]", "R[]", "S[a,b]", "SR"})
        refused({"matrices", "--only", list}, {"--only", "C, V, P, PV, S, S[plane,light], R or R[plane]"});
    refused({"matrices", "--only", "R[2]"}, {"R[2]: there is no plane 2, only 1"});
    refused({"matrices", "--only", "S[1,2]"}, {"S[1,2]: there is no light 2, only 1"});
    refused({"matrices", "--only", "S[0,1]"}, {"there is no plane 0"});
    refused({"matrices", "--digits", "0"}, {"--digits", "1 to 17"});
    refused({"matrices", "--digits", "18"}, {"--digits", "1 to 17"});
}

TEST_F(ChosenMatrices, HaveTheRequestedDigits) {
    const Json all = matrices({}).json(), four = matrices({"--digits", "4"}).json();
    for (const char* name : {"view_from_world", "clip_from_view", "shadow_from_world"})
        for (std::size_t row = 0; row < 4; ++row)
            for (std::size_t column = 0; column < 4; ++column) {
                char text[32];
                const double exact = all[name][row][column];
                std::snprintf(text, sizeof text, "%.3e", exact);
                EXPECT_EQ(four[name][row][column].get<double>(), std::strtod(text, nullptr)) << exact;
            }
    EXPECT_TRUE(has(matrices({"--only", "P", "--digits", "3", "--format", "text"}).out, "2.75"));
    EXPECT_EQ(matrices({"--digits", "17"}).json(), all);
}

TEST_F(ChosenMatrices, IncludeTheUploadedSignInEveryFormat) {
    const std::map<std::string, std::string> signs{
        {"text", "shadow_sign[2,1] = -1 (uploaded is shadow_sign[2,1] * S[2,1])\n"},
        {"latex", "\\mathrm{shadow\\_sign}_{2,1} = -1\n"},
        {"glm", "const double shadow_sign_2_1 = -1.0;"},
        {"glsl", "const float shadow_sign_2_1 = -1.0;"},
        {"numpy", "shadow_sign_2_1 = -1.0  # "},
        {"matlab", "shadow_sign_2_1 = -1;  % "}};
    for (const auto& [format, sign] : signs) {
        const std::string text = matrices({"--only", "S[2,1]", "--format", format}).out;
        EXPECT_TRUE(has(text, sign)) << text;
        EXPECT_TRUE(has(matrices({"--format", format}).out, "shadow")) << format;
    }
    EXPECT_TRUE(has(expect(0, {"matrices", "--format", "numpy"}).out, "\nshadow_sign = 1.0"));
}

TEST_F(ChosenMatrices, HaveTheSymbolsOfTheWindow) {
    const Json symbols = matrices({"--symbolic"}).json();
    EXPECT_EQ(symbols["shadow_from_world"][0][0], "Π·L - l_x n_x");
    EXPECT_EQ(symbols["mirror_from_world"][1][0], "-2ab");
    EXPECT_EQ(symbols["view_from_world"][2][3], "-back·eye");
    EXPECT_EQ(symbols["clip_from_view"][2][3], "2fn/(n-f)");
    EXPECT_TRUE(symbols["clip_from_world"][0][0].is_number()) << "PV has none";
    const std::string by_hand = "overrides.mirror_from_world=[[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]";
    EXPECT_EQ(matrices({"--symbolic", "--only", "R", "--set", by_hand}).json()["mirror_from_world"][0][0], 1.0);
    EXPECT_EQ(matrices({"--symbolic", "--only", "R", "--set", "slips.plus_2ab=true"}).json()["mirror_from_world"][1][0],
              "+2ab");
}

/// Python evaluates the symbols of S, R and P with the state's numbers and compares the results with the matrices.
TEST_F(ChosenMatrices, SymbolsMeanTheNumbers) {
    if (std::system("python3 -c ''") != 0) GTEST_SKIP() << "no python3";
    const Words state{"--set", "plane.equation=[0.36,0.48,0.8,-0.25]", "--set", "light.position=[2,5,1,0.5]"};
    const auto code = [&](const Words& more) {
        Words words{"matrices", "--format", "numpy"};
        words.insert(words.end(), state.begin(), state.end());
        words.insert(words.end(), more.begin(), more.end());
        return expect(0, words).out;
    };
    write("numpy.py", "def array(rows): return rows\n");
    write("compare.py", code({"--only", "S,R,P"}) + "numbers = S, R, P\n" + R"(
import math
n_x, n_y, n_z, d = a, b, c, d = 0.36, 0.48, 0.8, -0.25
l_x, l_y, l_z, l_w = 2, 5, 1, 0.5
plane_dot_light = n_x*l_x + n_y*l_y + n_z*l_z + d*l_w
)" + code({"--only", "S,R", "--symbolic"}) +
                            "n, f, c, aspect = 0.5, 40, 1/math.tan(math.radians(20)), 1280/720\n" +
                            code({"--only", "P", "--symbolic"}) + R"(
worst = max(abs(x - y) for one, other in zip(numbers, (S, R, P)) for r, q in zip(one, other) for x, y in zip(r, q))
print(worst)
assert worst < 1e-12, worst
)");
    EXPECT_EQ(std::system(("cd '" + folder().string() + "' && python3 compare.py > told 2>&1").c_str()), 0)
        << read("told") << read("compare.py");
}

/// Cameras from public questions about their matrices, which are computed here by hand from right, up and back.
TEST_F(ChosenMatrices, ViewMatricesOfPublicReportsAreRight) {
    const double a = std::sqrt(10.0), b = std::sqrt(110.0), c = std::sqrt(11.0);
    const double steep = 89.99 / 180.0 * std::acos(-1.0), sine = std::sin(steep), cosine = std::cos(steep);
    using Rows = std::vector<std::vector<double>>;
    struct Report {
        const char* camera;
        Rows view;
    };
    const Report reports[] = {
        {R"({"look_at":{"eye":[100,30,100],"center":[100,0,100],"up":[0,0,-1]}})",
         {{1, 0, 0, -100}, {0, 0, -1, 100}, {0, 1, 0, -30}, {0, 0, 0, 1}}},
        {R"({"look_at":{"eye":[1,1,3],"center":[0,0,0],"up":[0,1,0]}})",  // tinyrenderer's camera
         {{3 / a, 0, -1 / a, 0}, {-1 / b, 10 / b, -3 / b, 0}, {1 / c, 1 / c, 3 / c, -c}, {0, 0, 0, 1}}},
        {R"({"position":[0,0,0],"yaw":0,"pitch":89.99,"roll":0})",
         {{1, 0, 0, 0}, {0, cosine, sine, 0}, {0, -sine, cosine, 0}, {0, 0, 0, 1}}},
        {R"({"position":[0,0,0],"yaw":0,"pitch":-89.99,"roll":0})",
         {{1, 0, 0, 0}, {0, cosine, -sine, 0}, {0, sine, cosine, 0}, {0, 0, 0, 1}}}};
    for (const Report& report : reports) {
        const Json view = matrices({"--set", std::string("camera=") + report.camera, "--only", "V"}).json();
        for (std::size_t row = 0; row < 4; ++row)
            for (std::size_t column = 0; column < 4; ++column)
                EXPECT_NEAR(view["view_from_world"][row][column].get<double>(), report.view[row][column], 1e-9)
                    << report.camera << " row " << row + 1 << ", column " << column + 1;
    }
}

TEST_F(ChosenMatrices, LatexAcceptsThemBetweenDollars) {
    if (std::system("command -v pdflatex >/dev/null") != 0)
        GTEST_SKIP() << "no pdflatex: Debian's package texlive-latex-base has it";
    std::string text = "\\documentclass{article}\\usepackage{amsmath}\\begin{document}\n";
    for (const Words& more : {Words{}, Words{"--only", "S[2,1],R[2],V", "--digits", "4"}, Words{"--symbolic"},
                              Words{"--set", "slips.swapped_order=true", "--symbolic", "--only", "C,V"},
                              Words{"--set", "projection.type=orthographic", "--symbolic", "--only", "P"},
                              Words{"--set", "light.position=[1e-7,1e5,0,1]"}}) {
        Words words{"--format", "latex"};
        words.insert(words.end(), more.begin(), more.end());
        const std::string latex = matrices(words).out;
        EXPECT_FALSE(has(latex, "\n\n")) << "an empty line ends a formula";
        text += "$" + latex + "$\n\n";
    }
    write("matrices.tex", text + "\\end{document}\n");
    const std::string command =
        "cd '" + folder().string() + "' && pdflatex -halt-on-error -interaction=nonstopmode matrices.tex > told 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0) << read("told");
    EXPECT_TRUE(exists("matrices.pdf"));
}

class ExplainedMatrices : public Program {
protected:
    std::string fault(const std::string& text, const Words& state = {}) const {
        write("pasted.txt", text);
        Words words{"matrices", "--explain", "pasted.txt", "--format", "json"};
        words.insert(words.end(), state.begin(), state.end());
        const Json json = expect(0, words).json();
        const std::string letter = json["matrix"].is_null() ? "-" : json["matrix"].get<std::string>();
        return letter + " " + json["fault"].get<std::string>();
    }
};

TEST_F(ExplainedMatrices, KnowTheirOwnOutputInEveryFormat) {
    for (const char* letter : {"C", "V", "P", "S", "R"}) {
        for (const char* format : {"text", "latex", "glm", "glsl", "numpy", "matlab"}) {
            const std::string text = expect(0, {"matrices", "--only", letter, "--format", format}).out;
            EXPECT_EQ(fault(text), std::string(letter) + " none") << text;
        }
    }
    EXPECT_EQ(fault("5.2 -2.6 0 0\n0 0 0 0\n0 -2.2 5.2 0\n0 -1 0 5.2"), "S none");
    EXPECT_EQ(fault("5.2 0 0 0\n-2.6 0 -2.2 -1\n0 0 5.2 0\n0 0 0 5.2"), "S transposed");
    EXPECT_EQ(fault("V = " + expect(0, {"matrices", "--only", "C", "--format", "numpy"}).out.substr(26)), "V inverse");
    EXPECT_EQ(fault(expect(0, {"matrices", "--only", "P", "--format", "glm"}).out, {"--size", "100x100"}),
              "P different");
    EXPECT_EQ(
        fault(expect(0, {"matrices", "--only", "P", "--format", "glm", "--set", "slips.degrees_as_radians=true"}).out),
        "P degrees");
}

TEST_F(ExplainedMatrices, SayItInWords) {
    const Ended told = expect(0, {"matrices", "--explain", "-"}, {.input = "[1 0 0 0; 0 1 0 0; 0 0 1 -5; 0 0 0 1]"});
    EXPECT_TRUE(has(told.out, "V, view_from_world, read as rows (MATLAB)")) << told.out;
    EXPECT_TRUE(has(told.out, "eye (0, 0, 5)")) << told.out;
    EXPECT_TRUE(has(told.out, "yaw 0°, pitch 0°, roll 0°")) << told.out;
    refused({"matrices", "--explain", "-"}, {"standard input", "16 numbers", "are 3"}, {.input = "1 2 3"});
    refused({"matrices", "--explain", "none.txt"}, {"none.txt"});
    refused({"matrices", "--explain", "-", "--only", "V"}, {"--explain", "--only"});
}

TEST_F(ExplainedMatrices, ComeWithTheCameraAsLookAt) {
    const Words camera{"--set", "camera.look_at.eye=[1,1,3]", "--set", "camera.look_at.center=[0,0,0]"};
    Words words{"matrices"};
    words.insert(words.end(), camera.begin(), camera.end());
    const Json look_at = expect(0, words).json()["look_at"];
    EXPECT_EQ(look_at["eye"], (Json{1.0, 1.0, 3.0}));
    EXPECT_EQ(look_at["up"], (Json{0.0, 1.0, 0.0}));
    EXPECT_NEAR(look_at["center"][0].get<double>() * 3.0 - look_at["center"][2].get<double>(), 0.0, 1e-12);
    words.insert(words.end(), {"--format", "text"});
    EXPECT_TRUE(has(expect(0, words).out, "look_at: gluLookAt(1, 1, 3, "));
}

}  // namespace
}  // namespace cli_tests
