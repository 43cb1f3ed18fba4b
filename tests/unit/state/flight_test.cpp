// A saved flight reads back exactly, whichever fields change in it. An error names the broken file and the frame.
#include <gtest/gtest.h>

#include "platform/sanitized.h"
#include "random_params.h"
#include "state/file/flight.h"
#include "state/file/state_json.h"
#include "trials.h"

namespace viewing {
namespace {

Result<Flight> flight_of(const std::string& text) {
    const Result<StateDocument> document = parse_state_document(text, "f.json");
    if (!document) return Error{document.error()};
    if (!document->flight) return Error{"this is no flight"};
    EXPECT_EQ(document->params, document->flight->start);
    return *document->flight;
}

TEST(Flight, ChangesBetweenAnyTwoStatesAreExact) {
    testing::RandomParams random(7);
    Params before;
    for (int i = 0; i < testing::trials(is_sanitized ? 75 : 300); ++i) {
        const Params after = random.make();
        const Result<Params> changed = apply_settings(before, settings_to(before, after));
        ASSERT_TRUE(changed) << changed.error();
        ASSERT_EQ(*changed, after) << i;
        before = after;
    }
    EXPECT_TRUE(settings_to(before, before).empty());
}

TEST(Flight, FileReadsBackToTheSamePictures) {
    testing::RandomParams random(11);
    Flight flight{random.make(), {}, 4.1};
    std::vector<Params> pictures{flight.start};
    for (int i = 0; i < 40; ++i) {
        pictures.push_back(random.make());
        flight.frames.push_back({0.1 * i, settings_to(pictures[pictures.size() - 2], pictures.back())});
    }
    const std::string text = write_flight(flight);
    const Result<Flight> back = flight_of(text);
    ASSERT_TRUE(back) << back.error();
    EXPECT_EQ(*back, flight);
    EXPECT_EQ(write_flight(*back), text);
    FlightWalk walk(std::make_shared<const Flight>(*back));
    for (const std::size_t index : {0U, 1U, 40U, 17U, 18U, 0U}) {
        const Result<Params> params = walk.at(index);
        ASSERT_TRUE(params) << params.error();
        EXPECT_EQ(*params, pictures[index]) << index;
    }
}

TEST(Flight, ShowsTheLastPictureAtOrBeforeATime) {
    const Flight flight{{}, {{0.5, {}}, {1.0, {}}, {1.0, {}}, {2.0, {}}}, 3.0};
    EXPECT_EQ(flight.picture_at(0.0), 0U);
    EXPECT_EQ(flight.picture_at(0.499), 0U);
    EXPECT_EQ(flight.picture_at(0.5), 1U);
    EXPECT_EQ(flight.picture_at(1.0), 3U);
    EXPECT_EQ(flight.picture_at(99.0), 4U);
    EXPECT_EQ(flight.time_s(0), 0.0);
    EXPECT_EQ(flight.time_s(4), 2.0);
}

TEST(Flight, EndsAtItsLastFrameByDefault) {
    const Result<Flight> flight = flight_of(
        R"({"version": 1, "kind": "flight", "state": {}, "frames": [{"t": 0.25, "set": {"camera.yaw": 3}}]})");
    ASSERT_TRUE(flight) << flight.error();
    EXPECT_EQ(flight->seconds, 0.25);
}

TEST(Flight, ReportsMistakesByFileAndFrame) {
    const auto trouble = [](const std::string& frames, const std::string& more = "") {
        const Result<Flight> flight =
            flight_of(R"({"version": 1, "kind": "flight", "state": {}, )" + more + "\"frames\": [" + frames + "]}");
        return flight ? "nothing" : flight.error();
    };
    const std::string first = R"({"t": 1, "set": {"camera.yaw": 3}}, )";
    EXPECT_EQ(trouble(first + R"({"t": 2, "set": {"camera.yav": 3}})"),
              "f.json: frames[1]: camera.yav: no such field; did you mean camera.yaw?");
    EXPECT_EQ(trouble(first + R"({"t": 2, "set": {"camera.yaw": "3"}})").substr(0, 46),
              "f.json: frames[1]: camera.yaw: must be a numbe");
    EXPECT_EQ(trouble(first + R"({"t": 0.5, "set": {}})"),
              "f.json: frames[1].t: must be at least 1, the time of the previous frame, got 0.5");
    EXPECT_EQ(trouble(first + R"({"t": -1, "set": {}})").substr(0, 22), "f.json: frames[1].t: m");
    EXPECT_EQ(trouble(R"({"set": {}})"), "f.json: frames[0].t: is missing: a number from 0 to 1e9");
    EXPECT_EQ(trouble(R"({"t": 0})"), "f.json: frames[0].set: is missing: an object of paths and values");
    EXPECT_EQ(trouble(R"({"t": 0, "sett": {}})").substr(0, 37), "f.json: frames[0].sett: no such field");
    EXPECT_EQ(trouble(R"({"t": 0, "set": [3]})").substr(0, 30), "f.json: frames[0].set: must be");
    EXPECT_EQ(trouble(R"({"t": 0, "set": {"camera.yaw=3": 3}})").substr(0, 20), "f.json: frames[0].se");
    EXPECT_EQ(trouble(R"({"t": 0, "set": {"projection.near": 50}})").substr(0, 40),
              "f.json: frames[0]: projection.near: must");
    EXPECT_EQ(trouble(first.substr(0, first.size() - 2), "\"seconds\": 0.5, ").substr(0, 23),
              "f.json: seconds: must b");
    EXPECT_EQ(trouble("", "\"speed\": 1, ").substr(0, 27), "f.json: speed: no such fiel");
    for (const char* text : {R"({"kind": "flight"})", R"({"kind": "flight", "version": 2, "state": {}, "frames": []})",
                             R"({"kind": "flight", "version": 1, "state": 3, "frames": []})",
                             R"({"kind": "flight", "version": 1, "state": {}, "frames": {}})",
                             R"({"kind": "flights", "version": 1, "state": {}, "frames": []})"})
        EXPECT_FALSE(flight_of(text)) << text;
    std::string many;
    for (int i = 0; i < 10'000; ++i) many += std::string(i ? "," : "") + R"({"t":0,"set":{}})";
    EXPECT_NE(trouble(many).find("at most 9999"), std::string::npos) << trouble(many);
}

}  // namespace
}  // namespace viewing
