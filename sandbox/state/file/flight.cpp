#include "state/file/flight.h"

#include <algorithm>

#include "state/file/json.h"
#include "state/file/reader.h"
#include "text/numbers.h"

namespace viewing {
namespace {

constexpr double longest_s = 1e9;

const Json& member(const Json& object, const char* key, const Where& where) {
    if (!object.contains(key)) where.key(key).refuse("is missing");
    return object[key];
}

/// Reads a frame and applies its settings right away, so that an error can name its place in the file.
FlightFrame read_frame(const Json& frame, const Where& where, double before_s, Params& params) {
    require_keys(frame, where, {"t", "set"});
    FlightFrame read;
    read.t_s = read_number(member(frame, "t", where), where.key("t"), {0.0, longest_s});
    if (read.t_s < before_s)
        where.key("t").refuse("must be at least " + format_number(before_s) + ", the time of the previous frame, got " +
                              format_number(read.t_s));
    const std::string prefix = where.prefix + where.path + ": ";
    read.settings = read_settings(member(frame, "set", where), where.key("set"));
    Result<Params> changed = apply_settings(params, read.settings, prefix);
    if (!changed) throw Refusal(changed.error());
    params = *std::move(changed);
    return read;
}

}  // namespace

std::size_t Flight::picture_at(double t_s) const {
    const auto later = std::upper_bound(frames.begin(), frames.end(), t_s,
                                        [](double time_s, const FlightFrame& frame) { return time_s < frame.t_s; });
    return static_cast<std::size_t>(later - frames.begin());
}

Result<Params> FlightWalk::at(std::size_t index) {
    if (index < index_) {
        params_ = flight_->start;
        index_ = 0;
    }
    for (; index_ < index; ++index_) {
        Result<Params> changed = apply_settings(std::move(params_), flight_->frames[index_].settings,
                                                "frames[" + std::to_string(index_) + "]: ");
        if (!changed) return changed;
        params_ = *std::move(changed);
    }
    return params_;
}

void FlightSize::add(std::string_view text) {
    bytes_ += text.size();
    // Every JSON value except the first follows one of these.
    values_ += static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char sign) { return sign == ',' || sign == ':' || sign == '[' || sign == '{'; }));
}

bool FlightSize::is_too_much() const {
    constexpr std::size_t spare = 1000;  // for the text around the frames
    return bytes_ + spare > max_document_bytes || values_ + spare > max_document_values;
}

std::string write_flight(const Flight& flight) {
    std::string text = "{\n\"version\": 1,\n\"kind\": \"flight\",\n\"seconds\": " + format_number(flight.seconds) +
                       ",\n\"state\": " + write_state(flight.start) + ",\n\"frames\": [";
    const char* between = "\n";
    for (const FlightFrame& frame : flight.frames) {
        text += between + ("{\"t\": " + format_number(frame.t_s)) +
                ", \"set\": " + settings_as_json(frame.settings).dump() + "}";
        between = ",\n";
    }
    return text + "\n]\n}\n";
}

bool is_flight(const Json& document) {
    return document.is_object() && document.contains("kind") && document["kind"] == "flight";
}

Flight read_flight(const Json& document, const Where& where) {
    require_keys(document, where, {"version", "kind", "seconds", "state", "frames"});
    const Json& version = member(document, "version", where);
    if (version != 1)
        refuse_value(version, where.key("version"), "1, the version of the format that this program reads");
    Flight flight;
    read_group(flight.start, member(document, "state", where), {where.prefix + "state: ", ""});
    check_together(flight.start, where.prefix + "state: ");
    const Json& frames = member(document, "frames", where);
    const Where of_frames = where.key("frames");
    require_array(frames, of_frames, most_flight_pictures - 1,
                  "a list of frames, at most " + std::to_string(most_flight_pictures - 1));
    Params params = flight.start;
    for (std::size_t i = 0; i < frames.size(); ++i)
        flight.frames.push_back(read_frame(frames[i], of_frames.at(i), flight.time_s(i), params));
    flight.seconds = flight.time_s(frames.size());
    if (document.contains("seconds"))
        flight.seconds = read_number(document["seconds"], where.key("seconds"), {flight.seconds, longest_s});
    return flight;
}

}  // namespace viewing
