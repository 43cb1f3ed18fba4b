// A flight: a recording of the window, stored as its initial state and the later changes, each with its time.
// session/flight_recorder.h records it, and session/replay.h plays it.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "state/params.h"
#include "text/result.h"

namespace viewing {

/// The maximum number of pictures in a flight, including its initial state.
inline constexpr std::size_t most_flight_pictures = 10'000;

struct FlightFrame {
    double t_s = 0.0;                   ///< seconds since the start
    std::vector<std::string> settings;  ///< the changes since the previous frame, each as PATH=VALUE
    bool operator==(const FlightFrame&) const = default;
};

struct Flight {
    Params start;
    std::vector<FlightFrame> frames;  ///< in chronological order, without the start
    double seconds = 0.0;             ///< the end of the recording, no earlier than the last frame
    bool operator==(const Flight&) const = default;

    /// Returns the number of pictures: the start and all frames.
    std::size_t picture_count() const { return frames.size() + 1; }
    /// Returns the index of the picture shown at a time: the last one at or before it. The start has index 0.
    std::size_t picture_at(double t_s) const;
    /// Returns the time at which picture `index` first appears.
    double time_s(std::size_t index) const { return index == 0 ? 0.0 : frames[index - 1].t_s; }
};

/// Returns the text of the file: `{"version": 1, "kind": "flight", "seconds": …, "state": {…}, "frames": [{"t": …,
/// "set": {PATH: VALUE}}]}`, with one line per frame. parse_state_document() reads back exactly the same flight.
/// Without `seconds`, a flight ends with its last frame.
std::string write_flight(const Flight& flight);

/// Steps through the pictures of a flight.
class FlightWalk {
public:
    explicit FlightWalk(std::shared_ptr<const Flight> flight) : flight_(std::move(flight)), params_(flight_->start) {}

    /// Returns the parameters of a picture. Going forward applies only the changes in between; going back starts over.
    /// Fails if the caller replaced the start and a change does not fit the new one.
    Result<Params> at(std::size_t index);
    const Flight& flight() const { return *flight_; }

private:
    std::shared_ptr<const Flight> flight_;
    Params params_;
    std::size_t index_ = 0;
};

/// Estimates the size of the file being recorded, so that the recording ends before the reader would refuse the file.
class FlightSize {
public:
    static constexpr std::string_view of_each_frame = "{\"t\": 1000000.000001, \"set\": {}},\n";
    /// Adds the start, the text around a frame, or one of its settings.
    void add(std::string_view text);
    bool is_too_much() const;

private:
    std::size_t bytes_ = 0, values_ = 0;
};

}  // namespace viewing
