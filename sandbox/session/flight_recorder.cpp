#include "session/flight_recorder.h"

#include <cmath>
#include <ctime>
#include <utility>

#include "platform/file.h"
#include "platform/free_file.h"
#include "state/file/state_json.h"
#include "text/catalogue.h"

namespace viewing {
namespace {

/// Rounds to whole microseconds, which are precise enough and keep the file short.
double in_microseconds(double seconds) {
    return std::round(seconds * 1e6) / 1e6;
}

}  // namespace

void FlightRecorder::begin() {
    *this = {};
    is_recording_ = true;
}

void FlightRecorder::pass(double dt_s) {
    if (flight_ && !is_full_) seconds_ += dt_s;
}

void FlightRecorder::note(const Params& drawn) {
    if (!is_recording_ || is_full_) return;
    if (!flight_) {
        flight_ = Flight{drawn, {}, 0.0};
        size_.add(write_state(drawn));
        last_ = drawn;
        return;
    }
    if (drawn == last_) return;
    FlightFrame frame{in_microseconds(seconds_), settings_to(last_, drawn)};
    size_.add(FlightSize::of_each_frame);
    for (const std::string& setting : frame.settings) size_.add(setting);
    is_full_ = size_.is_too_much();
    if (is_full_) return;
    flight_->frames.push_back(std::move(frame));
    last_ = drawn;
    is_full_ = flight_->picture_count() == most_flight_pictures;
}

std::optional<Flight> FlightRecorder::end() {
    if (flight_) flight_->seconds = in_microseconds(seconds_);
    std::optional<Flight> recorded = std::move(flight_);
    *this = {};
    return recorded;
}

void FlightRecorder::write(Session& session) {
    const bool was_full = is_full_;
    const std::optional<Flight> flight = end();
    if (!flight) return;
    const std::filesystem::path file = new_flight_file();
    const std::string seconds = fmt::format("{:.1f}", flight->seconds);
    session.write(
        [file, flight] { return write_file(file, write_flight(*flight)); },
        was_full ? say("maximum flight length reached: {seconds} s written to {file}", "seconds"_a = seconds,
                       "file"_a = file.string())
                 : say("flight of {seconds} s written to {file}", "seconds"_a = seconds, "file"_a = file.string()));
}

void FlightRecorder::toggle(Session& session) {
    if (is_recording_) return write(session);
    begin();
    session.message = {tr("recording a flight: F9 stops it and writes the file"), false};
}

std::string FlightRecorder::sign() const {
    if (!is_recording_) return "";
    const auto seconds = static_cast<int>(seconds_);
    return say("● REC {clock}", "clock"_a = fmt::format("{:02}:{:02}", seconds / 60, seconds % 60));
}

std::filesystem::path new_flight_file() {
    const std::time_t now = std::time(nullptr);
    char name[64];
    std::strftime(name, sizeof name, "flight-%Y%m%d-%H%M%S", std::localtime(&now));
    return free_file(name, ".json");
}

}  // namespace viewing
