// Recording and replay: changes are replayed at the times when they were recorded, and changes that the user makes
// meanwhile take precedence.
#include <gtest/gtest.h>

#include "session/flight_recorder.h"
#include "session/replay.h"
#include "state/file/state_json.h"

namespace viewing {
namespace {

Session opening() {
    Result<Session> session = Session::make(*load_state(""));
    EXPECT_TRUE(session) << session.error();
    return std::move(*session);
}

Params at_yaw(double yaw) {
    Params params;
    params.camera.yaw = yaw;
    return params;
}

TEST(FlightRecorder, RecordsDifferencesWithTimesSinceTheStart) {
    FlightRecorder recorder;
    recorder.pass(1.0);
    recorder.note(at_yaw(1));
    EXPECT_FALSE(recorder.end()) << "recording has not started";
    recorder.begin();
    recorder.pass(5.0);
    recorder.note(at_yaw(1));
    for (const double yaw : {2.0, 2.0, 3.0, 3.0}) {
        recorder.pass(0.25);
        recorder.note(at_yaw(yaw));
    }
    EXPECT_EQ(recorder.seconds(), 1.0);
    const std::optional<Flight> flight = recorder.end();
    ASSERT_TRUE(flight);
    EXPECT_EQ(flight->start, at_yaw(1));
    EXPECT_EQ(flight->frames, (std::vector<FlightFrame>{{0.25, {"camera.yaw=2.0"}}, {0.75, {"camera.yaw=3.0"}}}));
    EXPECT_EQ(flight->seconds, 1.0);
    EXPECT_FALSE(recorder.is_recording());
}

TEST(FlightRecorder, EndsWhenNoMorePicturesFit) {
    FlightRecorder recorder;
    recorder.begin();
    for (int i = 0; i < 20'000 && !recorder.is_full(); ++i) {
        recorder.pass(0.01);
        recorder.note(at_yaw(i % 90));
    }
    ASSERT_TRUE(recorder.is_full());
    const std::optional<Flight> flight = recorder.end();
    ASSERT_TRUE(flight);
    EXPECT_EQ(flight->picture_count(), 10'000U);
    EXPECT_TRUE(parse_state_document(write_flight(*flight), "f.json"));
}

/// If each frame changes a lot, the frames fill the file before there are 10,000.
TEST(FlightRecorderSlowTest, EndsBeforeItsFileIsTooLarge) {
    FlightRecorder recorder;
    Params params;
    SceneDescription scene;
    for (int i = 0; i < 150; ++i) {
        ObjectDescription object;
        object.name = "box " + std::to_string(i);
        scene.objects.push_back(object);
    }
    recorder.begin();
    int frames = 0;
    for (; frames < 20'000 && !recorder.is_full(); ++frames) {
        scene.objects[0].position.x = frames;
        params.scene = scene;
        recorder.pass(0.01);
        recorder.note(params);
    }
    EXPECT_LT(frames, 9'000);
    const std::optional<Flight> flight = recorder.end();
    ASSERT_TRUE(flight);
    const Result<StateDocument> back = parse_state_document(write_flight(*flight), "f.json");
    ASSERT_TRUE(back) << back.error();
    EXPECT_EQ(*back->flight, *flight);
}

std::shared_ptr<const Flight> two_turns() {
    return std::make_shared<const Flight>(Flight{Params{}, {{0.5, {"camera.yaw=10"}}, {1.0, {"camera.yaw=20"}}}, 1.5});
}

TEST(Replay, PlaysAFlightOnceAtItsOwnTimes) {
    Session session = opening();
    session.params.ui.theme = Theme::light;
    Replay replay;
    replay.begin(two_turns());
    const double first = session.params.camera.yaw;
    std::vector<double> yaws;
    for (int frame = 0; frame < 8 && replay.is_playing(); ++frame) {
        replay.update(session, frame == 0 ? 7.0 : 0.25);
        yaws.push_back(session.params.camera.yaw);
    }
    EXPECT_EQ(yaws, (std::vector<double>{first, first, 10, 10, 20, 20, 20}));
    EXPECT_FALSE(replay.is_playing());
    EXPECT_EQ(session.params.ui.theme, Theme::light) << "appearance belongs to the user";
}

TEST(Replay, EndsWhenTheUserChangesSomething) {
    Session session = opening();
    Replay replay;
    replay.begin(two_turns());
    replay.update(session, 0.0);
    replay.update(session, 0.6);
    session.params.ui.theme = Theme::projector;
    session.params.view.layout.big = ViewName::camera;
    replay.update(session, 0.1);
    EXPECT_TRUE(replay.is_playing()) << "appearance and layout do not count as a change";
    session.params.camera.pitch = 5.0;
    replay.update(session, 1.0);
    EXPECT_FALSE(replay.is_playing());
    EXPECT_EQ(session.params.camera.yaw, 10.0);
    EXPECT_EQ(session.params.camera.pitch, 5.0);
}

TEST(Replay, PlaysAHandInWithShortPauses) {
    Session session = opening();
    LessonStep step;
    step.start.params = session.params;
    Replay replay;
    replay.begin(step, {{100.0, {"camera.yaw=1"}}, {100.01, {"nonsense=1"}}, {900.0, {"camera.pitch=2"}}});
    double time_s = 0.0;
    std::vector<double> changes_s;
    for (Params before = session.params; replay.is_playing() && time_s < 10.0; before = session.params) {
        replay.update(session, 0.1);
        if (session.params != before) changes_s.push_back(time_s);
        time_s += 0.1;
    }
    ASSERT_EQ(changes_s.size(), 2U);
    EXPECT_NEAR(changes_s[0], 1.5, 0.11);
    EXPECT_NEAR(changes_s[1], 1.5 + 0.2 + 1.5, 0.11);
    EXPECT_EQ(session.params.camera.yaw, step.start.params.camera.yaw) << "an entry holds all changes since the start";
    EXPECT_EQ(session.params.camera.pitch, 2.0);
}

}  // namespace
}  // namespace viewing
