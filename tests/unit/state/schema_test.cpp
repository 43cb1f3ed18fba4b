// The JSON Schemas of states, scenes and flights accept the files that the readers accept.
#include <gtest/gtest.h>

#include "agreement.h"
#include "state/file/schema.h"
#include "state/file/state_json.h"

namespace viewing {
namespace {

TEST(StateSchemas, OfAStateAcceptsWhatTheReaderAccepts) {
    if (!has_validator()) GTEST_SKIP() << no_validator;
    const auto complaint = [](const std::string& text) {
        const Result<StateDocument> read = parse_state_document(text, "a.json");
        return read ? "" : read.error();
    };
    expect_agreement(state_schema(), files_of("presets"), 12, 77, complaint, {"must be less than"});
}

TEST(StateSchemas, OfASceneAcceptsWhatTheReaderAccepts) {
    if (!has_validator()) GTEST_SKIP() << no_validator;
    const auto complaint = [](const std::string& text) {
        const Result<SceneDescription> read = parse_scene(text, "a.json");
        return read ? "" : read.error();
    };
    expect_agreement(scene_schema(), files_of("scenes"), 40, 78, complaint, {"an earlier object", "has no area"});
}

TEST(StateSchemas, OfAFlightAcceptsWhatTheReaderAccepts) {
    if (!has_validator()) GTEST_SKIP() << no_validator;
    const Json flight = Json::parse(R"({"version": 1, "kind": "flight", "seconds": 1.05,
        "state": {"camera": {"yaw": 20}, "shadow": {"opacity": 0.5}}, "frames": [
        {"t": 0.25, "set": {"camera.yaw": 25.000000000000004, "light.position": [1, 5, 2, 1]}},
        {"t": 0.5, "set": {"camera.position": [3.3, 2.1, 6.6], "projection.near": 0.7}},
        {"t": 0.5, "set": {"scene": "letters", "view.shows": "facing"}}]})");
    const auto complaint = [](const std::string& text) {
        const Result<StateDocument> read = parse_state_document(text, "a.json");
        if (read && !read->flight) return std::string("a state");  // without "kind", the file is read as a state
        return read ? "" : read.error();
    };
    // Only the reader checks the settings of a frame ("frames[0]: camera.yaw: …"), near < far and so on, and the
    // order of times.
    expect_agreement(flight_schema(), {flight}, 800, 73, complaint,
                     {"]: ", "the time of the previous frame", "seconds: must be a number from"});
}

}  // namespace
}  // namespace viewing
