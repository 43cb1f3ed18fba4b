// A flight: what the window showed while it was recorded, as the state at the beginning and what has changed since,
// with times. Who records it is session/flight_recorder.h, who plays it session/replay.h.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "state/params.h"
#include "text/result.h"

namespace viewing {

/// The start among them.
inline constexpr std::size_t most_flight_pictures = 10'000;

struct FlightFrame {
    double t_s = 0.0;                   ///< since the beginning
    std::vector<std::string> settings;  ///< PATH=VALUE of what has changed since the frame before
    bool operator==(const FlightFrame&) const = default;
};

struct Flight {
    Params start;
    std::vector<FlightFrame> frames;  ///< in the order of their times; the start itself is none of them
    double seconds = 0.0;             ///< when the recording ended: not before the last frame
    bool operator==(const Flight&) const = default;

    /// Pictures: the start and the frames.
    std::size_t picture_count() const { return frames.size() + 1; }
    /// The picture that is shown at a time, the start being 0: the last one at or before it.
    std::size_t picture_at(double t_s) const;
    /// When picture `index` is shown first.
    double time_s(std::size_t index) const { return index == 0 ? 0.0 : frames[index - 1].t_s; }
};

/// The file: `{"version": 1, "kind": "flight", "seconds": …, "state": {…}, "frames": [{"t": …, "set": {PATH:
/// VALUE}}]}`, a line for each frame; parse_state_document() reads it back to the same flight exactly. Where `seconds`
/// is left out, it ends with its last frame.
std::string write_flight(const Flight& flight);

/// Goes through a flight from picture to picture.
class FlightWalk {
public:
    explicit FlightWalk(std::shared_ptr<const Flight> flight) : flight_(std::move(flight)), params_(flight_->start) {}

    /// The parameters of a picture. Forwards it costs what lies between; backwards it begins again. The error: another
    /// start than the file's does not take one of its changes.
    Result<Params> at(std::size_t index);
    const Flight& flight() const { return *flight_; }

private:
    std::shared_ptr<const Flight> flight_;
    Params params_;
    std::size_t index_ = 0;
};

/// What recorded frames would take in the file, so that it never becomes one that the reader refuses.
class FlightSize {
public:
    static constexpr std::string_view of_each_frame = "{\"t\": 1000000.000001, \"set\": {}},\n";
    /// The start, what stands around a frame, or one of its settings.
    void add(std::string_view text);
    bool is_too_much() const;

private:
    std::size_t bytes_ = 0, values_ = 0;
};

}  // namespace viewing
