// camera.look_at in files and settings: it is read instead of position and angles, refused if it is given together with
// them, and never written.
#include <gtest/gtest.h>

#include "state/file/state_json.h"

namespace viewing {
namespace {

CameraParams camera_in(const std::string& look_at) {
    const Result<Params> params = parse_state(R"({"camera": {"look_at": )" + look_at + "}}", "a.json");
    EXPECT_TRUE(params) << params.error();
    return params ? params->camera : CameraParams{};
}

std::string refused_file(const std::string& camera) {
    const Result<Params> params = parse_state("{\"camera\": " + camera + "}", "a.json");
    EXPECT_FALSE(params) << camera;
    return params ? "" : params.error();
}

CameraParams looking(const std::vector<std::string>& settings) {
    const Result<Params> params = apply_settings({}, settings);
    EXPECT_TRUE(params) << params.error();
    return params ? params->camera : CameraParams{};
}

std::string refused_setting(const std::vector<std::string>& settings) {
    const Result<Params> params = apply_settings({}, settings);
    EXPECT_FALSE(params);
    return params ? "" : params.error();
}

TEST(LookAtFile, IsReadAsAngles) {
    const CameraParams ahead = camera_in(R"({"eye": [0, 0, 5], "center": [0, 0, 0]})");
    EXPECT_EQ(ahead.position, glm::dvec3(0, 0, 5));
    EXPECT_EQ(ahead.angles(), Angles{});
    EXPECT_EQ(ahead.look_at().center, glm::dvec3(0, 0, 0)) << "the center given, not another point of the same ray";
    // From (3, 3√2, 3) to the origin: yaw 45°, pitch −45°.
    const CameraParams down = camera_in(R"({"eye": [3, 4.242640687119285, 3], "center": [0, 0, 0], "up": [0, 2, 0]})");
    EXPECT_NEAR(down.yaw, 45.0, 1e-12);
    EXPECT_NEAR(down.pitch, -45.0, 1e-12);
    EXPECT_EQ(down.roll, 0.0);
    const CameraParams tilted = camera_in(R"({"eye": [0, 0, 5], "center": [0, 0, 0], "up": [-1, 1, 0]})");
    EXPECT_NEAR(tilted.roll, 45.0, 1e-12) << "leaning to the left";
}

TEST(LookAtFile, IsWrittenAsAngles) {
    const Result<Params> params =
        parse_state(R"({"camera": {"look_at": {"eye": [1, 1, 3], "center": [0, 0, 0]}, "navigation": "orbit"}})", "a");
    ASSERT_TRUE(params) << params.error();
    EXPECT_EQ(params->camera.navigation, Navigation::orbit);
    const std::string written = write_state(*params);
    EXPECT_EQ(written.find("look_at"), std::string::npos);
    EXPECT_EQ(*parse_state(written, "again"), *params);
}

TEST(LookAtFile, RefusesWhatIsNotOneCamera) {
    EXPECT_EQ(refused_file(R"({"look_at": {"eye": [0, 0, 5], "center": [0, 0, 0]}, "yaw": 3})"),
              "a.json: camera.look_at: is given together with camera.yaw: write the camera either as look_at or as "
              "position, yaw, pitch and roll");
    EXPECT_EQ(refused_file(R"({"look_at": {"eye": [1, 2, 3], "center": [1, 2, 3]}})"),
              "a.json: camera.look_at.center: must differ from eye: the camera looks from eye toward center");
    EXPECT_EQ(refused_file(R"({"look_at": {"eye": [0, 5, 0], "center": [0, 0, 0]}})").substr(0, 50),
              "a.json: camera.look_at.up: must be neither zero no");
    EXPECT_EQ(refused_file(R"({"look_at": {"eye": [0, 5, 0]}})").substr(0, 43),
              "a.json: camera.look_at.center: is missing: ");
    EXPECT_EQ(refused_file(R"({"look_at": {"eye": [0, 5, 1e9], "center": [0, 0, 0]}})"),
              "a.json: camera.look_at.eye[2]: must be a number from -1e6 to 1e6, got the number 1e9");
    EXPECT_EQ(refused_file(R"({"look_at": 3})").substr(0, 36), "a.json: camera.look_at: must be {\"ey");
    EXPECT_EQ(refused_file(R"({"lookat": 3})"), "a.json: camera.lookat: no such field; did you mean camera.look_at?");
    EXPECT_EQ(refused_file(R"({"look_at": {"eye": [0, 0, 5], "centre": [0, 0, 0]}})").substr(0, 33),
              "a.json: camera.look_at.centre: no");
}

TEST(LookAtSettings, PartsCountTogether) {
    // Alone, the first setting would put the eye at the look-at center of the opening view.
    const CameraParams whole = looking({"camera.look_at={\"eye\":[0,0.75,0],\"center\":[0,0.75,-1]}"});
    EXPECT_EQ(looking({"camera.look_at.eye=[0,0.75,0]", "camera.look_at.center=[0,0.75,-1]"}), whole);
    EXPECT_EQ(looking({"camera.look_at.center=[0,0.75,-1]", "camera.look_at.eye=[0,0.75,0]"}), whole);
    EXPECT_EQ(
        looking({"camera.look_at.eye=[0,0.75,0]", "camera.look_at.center=[0,0.75,0]", "camera.look_at.center[2]=-1"}),
        whole);
    EXPECT_EQ(looking({R"(camera={"look_at":{"eye":[0,0.75,0],"center":[0,0.75,-1]}})"}), whole);
    EXPECT_EQ(whole.angles(), Angles{});
    EXPECT_NEAR(looking({"camera.look_at.up=[-1,0,0]"}).roll, 90.0, 40.0);
}

TEST(LookAtSettings, RefuseTwoWaysAtOnce) {
    EXPECT_EQ(refused_setting({"camera.look_at.eye=[0,0,5]", "camera.yaw=3"}),
              "--set camera.look_at: is given together with camera.yaw: write the camera either as look_at or as "
              "position, yaw, pitch and roll");
    EXPECT_NE(refused_setting({"camera.position[1]=2", "camera.look_at.eye=[0,0,5]"}).find("camera.position"),
              std::string::npos);
    EXPECT_EQ(refused_setting({"camera.look_at.centr=[0,0,5]"}).substr(0, 33), "--set camera.look_at.centr: no su");
    EXPECT_EQ(refused_setting({"camera.look_at=3"}).substr(0, 35), "--set camera.look_at: must be {\"eye");
    looking({"camera.look_at.eye=[0,0,5]", "camera.navigation=walk", "camera.target=[0,0,0]"});
}

}  // namespace
}  // namespace viewing
