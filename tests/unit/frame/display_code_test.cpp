// The lecture's display(): the test parses its code as a compiler would and multiplies its matrices.
#include "topics/matrices/numbers/display_code.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <regex>

#include "unit/frame/frame_test.h"

namespace viewing {
namespace {

std::string code_of(const Params& params, const Derived& derived) {
    std::string code;
    for (const DisplayLine& line : display_lines(params, derived)) code += line.code + "\n";
    return code;
}

/// Returns the numbers in a function call, with those inside radians() converted to radians.
std::vector<double> arguments(const std::string& code, const std::string& function) {
    const std::size_t at = code.find(function + "(");
    EXPECT_NE(at, std::string::npos) << function << " in\n" << code;
    std::vector<double> numbers;
    const std::string call = code.substr(at + function.size(), code.find(";", at) - at);
    const std::regex argument(R"((radians\()?(-?[0-9.]+))");
    for (std::sregex_iterator found(call.begin(), call.end(), argument), end; found != end; ++found) {
        const double number = std::stod((*found)[2]);
        numbers.push_back((*found)[1].matched ? glm::radians(number) : number);
    }
    return numbers;
}

glm::dmat4 projection_in(const std::string& code) {
    if (code.find("infinitePerspective(") != std::string::npos) {
        const std::vector<double> n = arguments(code, "infinitePerspective");
        return glm::infinitePerspective(n.at(0), n.at(1), n.at(2));
    }
    if (code.find("perspective(") != std::string::npos) {
        const std::vector<double> n = arguments(code, "perspective");
        return glm::perspectiveRH_NO(n.at(0), n.at(1), n.at(2), n.at(3));
    }
    if (code.find("frustum(") != std::string::npos) {
        const std::vector<double> n = arguments(code, "frustum");
        return glm::frustumRH_NO(n.at(0), n.at(1), n.at(2), n.at(3), n.at(4), n.at(5));
    }
    const std::vector<double> n = arguments(code, "ortho");
    return glm::orthoRH_NO(n.at(0), n.at(1), n.at(2), n.at(3), n.at(4), n.at(5));
}

/// Multiplies the factors of W from left to right.
glm::dmat4 world_in(const std::string& code) {
    const std::regex factor(R"(rotate\(radians\((-?[0-9.]+)\), ([xyz])\)|translate\((\S+), (\S+), (\S+)\))");
    glm::dmat4 product(1.0);
    for (std::sregex_iterator found(code.begin(), code.end(), factor), end; found != end; ++found) {
        const std::smatch& part = *found;
        if (!part[1].matched) {
            product = glm::translate(product, {std::stod(part[3]), std::stod(part[4]), std::stod(part[5])});
            continue;
        }
        glm::dvec3 axis(0.0);
        axis[part[2].str()[0] - 'x'] = 1.0;
        product = glm::rotate(product, glm::radians(std::stod(part[1])), axis);
    }
    return product;
}

double largest_difference(const glm::dmat4& a, const glm::dmat4& b) {
    double largest = 0.0;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) largest = std::max(largest, std::abs(a[column][row] - b[column][row]));
    return largest;
}

TEST(DisplayCode, MakesTheMatricesOfTheStateWithEveryMistake) {
    const std::vector<std::string> camera = {"camera.position=[1.25,-2,3.5]", "camera.yaw=40.5", "camera.pitch=-12",
                                             "camera.roll=7.5", "projection.aspect=1.5"};
    const std::vector<std::vector<std::string>> cases = {
        {},
        {"slips.swapped_order=true"},
        {"slips.camera_as_view=true"},
        {"slips.swapped_order=true", "slips.camera_as_view=true"},
        {"slips.degrees_as_radians=true", "projection.fovy=45"},
        {"projection.type=orthographic", "projection.height=4", "slips.degrees_as_radians=true"},
        {"projection.far=infinite"},
        {"projection.type=frustum", "projection.left=-0.125", "slips.degrees_as_radians=true"},
        {"projection.type=orthographic_window", "projection.left=-1.5", "projection.top=2.25"}};
    for (const std::vector<std::string>& settings : cases) {
        std::vector<std::string> all = camera;
        all.insert(all.end(), settings.begin(), settings.end());
        const Params params = testing::params_with(all);
        const Derived derived = derive(params, testing::box_scene(), {});
        const std::string code = code_of(params, derived);
        EXPECT_LT(largest_difference(world_in(code), derived.view_from_world), 1e-9) << code;
        EXPECT_LT(largest_difference(projection_in(code), derived.clip_from_view), 1e-9) << code;
    }
}

TEST(DisplayCode, ConvertsToRadiansUnlessTheMistakeOmitsIt) {
    Params params;
    const auto has_radians = [&] {
        return code_of(params, derive(params, testing::box_scene(), {})).find("perspective(radians(") !=
               std::string::npos;
    };
    EXPECT_TRUE(has_radians());
    params.slips.degrees_as_radians = true;
    EXPECT_FALSE(has_radians());
}

TEST(DisplayCode, FitsTheMatrixColumn) {
    for (const char* const setting :
         {"camera.position=[-123.456,-100,-99.99]", "camera.yaw=-123.4", "projection.type=orthographic",
          "projection.type=frustum", "projection.far=100000"}) {
        const Params params = testing::params_with({setting});
        for (const DisplayLine& line : display_lines(params, derive(params, testing::box_scene(), {})))
            EXPECT_LE(line.code.size(), 48U) << line.code;
    }
}

}  // namespace
}  // namespace viewing
