// Records a flight: the parameters of every drawn frame. Read state/file/flight.h first.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "session/session.h"
#include "state/file/flight.h"

namespace viewing {

class FlightRecorder {
public:
    /// Starts a recording; the next frame passed to note() becomes its first.
    void begin();
    bool is_recording() const { return is_recording_; }
    /// Adds the time since the previous frame; does nothing before the first frame is recorded.
    void pass(double dt_s);
    /// Records the parameters of a drawn frame; does nothing unless recording.
    void note(const Params& drawn);
    double seconds() const { return seconds_; }
    /// Whether nothing more fits, so that the recording must end.
    bool is_full() const { return is_full_; }
    /// Returns the recording; none if nothing was recorded.
    std::optional<Flight> end();
    /// Ends the recording and writes it to a new file in the background.
    void write(Session& session);
    /// Starts a recording, or ends it and writes it.
    void toggle(Session& session);
    /// Returns the sign with the recording's duration; "" while nothing is recorded.
    std::string sign() const;

private:
    bool is_recording_ = false, is_full_ = false;
    double seconds_ = 0.0;
    std::optional<Flight> flight_;
    Params last_;
    FlightSize size_;
};

/// Returns a new file in the working folder: flight-YYYYMMDD-HHMMSS.json, with "-2", "-3" … appended if the name is
/// taken.
std::filesystem::path new_flight_file();

}  // namespace viewing
