// The names by which lessons cover and highlight things: each is known, and the error for a misspelled name suggests
// the nearest one.
#include "lesson/target_names.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace viewing {
namespace {

TEST(Targets, AcceptFormerNames) {
    EXPECT_EQ(*read_target("button:mend"), "button:fix");
    EXPECT_EQ(*read_target("button:normalise"), "button:normalize");
    EXPECT_EQ(*read_target("chart:precision.quantisation"), "chart:precision.quantization");
}

TEST(Targets, EveryListedNameReadsAsItself) {
    const std::vector<std::string> names = target_names();
    EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size()) << "no duplicates";
    for (const std::string& name : names) {
        const Result<std::string> read = read_target(name);
        ASSERT_TRUE(read) << read.error();
        EXPECT_EQ(*read, name);
    }
}

TEST(Targets, IncludesNamesThatLessonsUse) {
    for (const char* name : {"matrix:V",
                             "matrix:V[2][3]",
                             "matrix:S[3]",
                             "matrix:R[1][0]",
                             "code:display",
                             "code:display.translate",
                             "code:passes",
                             "call:glEnable(GL_CULL_FACE)",
                             "control:camera",
                             "control:camera.position",
                             "control:light.position[3]",
                             "control:plane.equation[1]",
                             "control:depth.offset.units",
                             "control:slips.swapped_order",
                             "section:projection",
                             "section:slips",
                             "section:visibility",
                             "view:camera",
                             "view:observer",
                             "view:moving_world",
                             "view:shadow_derivation",
                             "chart:precision.near",
                             "chart:precision.quantization",
                             "column:fighting.safe_gap",
                             "column:fighting.step",
                             "fact:det_mirror",
                             "fact:rank_shadow",
                             "fact:plane_dot_light",
                             "follow:mirrored",
                             "follow:foot",
                             "follow:S p",
                             "lamps",
                             "button:show C",
                             "button:normalize",
                             "text:mirror_derivation",
                             "text:mirror_derivation.matrix",
                             "label:mirrored",
                             "label:heights",
                             "note:depth_step",
                             "bar:pixel"}) {
        const Result<std::string> read = read_target(name);
        EXPECT_TRUE(read) << read.error();
    }
}

TEST(Targets, CameraViewMayNameItsContent) {
    const Result<std::string> read = read_target("view:camera(difference)");
    ASSERT_TRUE(read) << read.error();
    EXPECT_EQ(*read, "view:camera");
    EXPECT_FALSE(read_target("view:camera(nonsense)"));
    EXPECT_FALSE(read_target("view:observer(difference)"));
}

TEST(Targets, MisspelledNameSuggestsTheNearest) {
    const auto error = [](const char* name) {
        const Result<std::string> read = read_target(name);
        return read ? std::string("accepted") : read.error();
    };
    EXPECT_NE(error("view:obsever").find("did you mean view:observer?"), std::string::npos) << error("view:obsever");
    EXPECT_NE(error("control:camera.jaw").find("did you mean control:camera.yaw?"), std::string::npos);
    EXPECT_NE(error("matrix:VC[0]").find("did you mean matrix:V?"), std::string::npos) << error("matrix:VC[0]");
    EXPECT_NE(error("everything").find("names begin with view, control, section"), std::string::npos);
    EXPECT_NE(error("").find("nothing in the window has this name"), std::string::npos);
}

TEST(Targets, EntriesCountFromZeroToTheLast) {
    for (const char* name : {"matrix:V[4]", "matrix:V[0][4]", "matrix:V[0][0][0]", "matrix:V[-1]", "matrix:V[",
                             "matrix:V[2]x", "control:camera.position[3]", "control:light.position[4]"}) {
        const Result<std::string> read = read_target(name);
        ASSERT_FALSE(read) << name;
        EXPECT_NE(read.error().find("from 0 to "), std::string::npos) << read.error();
    }
    const Result<std::string> read = read_target("control:camera.yaw[0]");
    ASSERT_FALSE(read);
    EXPECT_NE(read.error().find("has no entries"), std::string::npos) << read.error();
}

}  // namespace
}  // namespace viewing
