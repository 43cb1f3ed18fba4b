// Records a flight: the parameters of every frame that is drawn. Read state/file/flight.h first.
#pragma once

#include <filesystem>
#include <optional>

#include "state/file/flight.h"

namespace viewing {

class FlightRecorder {
public:
    /// The next frame that is noted is the start.
    void begin();
    bool is_recording() const { return is_recording_; }
    /// The time since the frame before, for each frame. Nothing before the start.
    void pass(double dt_s);
    /// The parameters of a frame that was drawn. Nothing while nothing is recorded.
    void note(const Params& drawn);
    double seconds() const { return seconds_; }
    /// Whether nothing more fits: it wants to be ended.
    bool is_full() const { return is_full_; }
    /// What was recorded; none where nothing was.
    std::optional<Flight> end();

private:
    bool is_recording_ = false, is_full_ = false;
    double seconds_ = 0.0;
    std::optional<Flight> flight_;
    Params last_;
    FlightSize size_;
};

/// A file in the working folder that is not there yet: flight-YYYYMMDD-HHMMSS.json, with "-2", "-3" … behind it where
/// that is taken.
std::filesystem::path new_flight_file();

}  // namespace viewing
