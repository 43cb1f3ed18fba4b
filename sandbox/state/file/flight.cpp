#include "state/file/flight.h"

#include <algorithm>

#include "state/file/form.h"
#include "state/file/schema.h"
#include "state/file/state_json.h"
#include "text/numbers.h"

namespace viewing {
namespace {

constexpr double longest_s = 1e9;

/// Reads a frame. Its settings are applied to `params` right away, so that an error can name its place in the file.
form::Form<FlightFrame> frame_form(Params& params, double& before_s) {
    const auto apply = [&](const FlightFrame& frame, const Where& where) {
        if (frame.t_s < before_s)
            where.key("t").refuse("must be at least " + format_number(before_s) +
                                  ", the time of the previous frame, got " + format_number(frame.t_s));
        before_s = frame.t_s;
        Result<Params> changed = apply_settings(params, frame.settings, where.prefix + where.path + ": ");
        if (!changed) throw Refusal(changed.error());
        params = *std::move(changed);
    };
    return form::Object<FlightFrame>()
        .required("t", form::number({0.0, longest_s}), &FlightFrame::t_s)
        .required("set", form::settings(), &FlightFrame::settings)
        .form()
        .then(apply);
}

form::Form<Params> start_form() {
    const auto read = [](const Json& value, const Where& where) {
        const std::string prefix = where.prefix + "state: ";
        Params start;
        read_group(start, value, {prefix, ""});
        check_together(start, prefix);
        return start;
    };
    return {"a state", &Json::is_object, read, state_without_titles};
}

/// `params` and `before_s` are those of the latest frame read.
form::Object<Flight> flight_form(Params& params, double& before_s) {
    static constexpr std::array kinds{"flight"};
    const auto start = [&](Flight& flight, const Params& read) { flight.start = params = read; };
    const std::string frames = "a list of frames, at most " + std::to_string(most_flight_pictures - 1);
    auto seconds = form::number({0.0, longest_s});
    seconds.read = [&](const Json& value, const Where& where) {
        return read_number(value, where, {before_s, longest_s});
    };
    return form::Object<Flight>()
        .version("version")
        .checked("kind", form::choice(kinds), true)
        .required("state", start_form(), start)
        .required("frames", form::list(frame_form(params, before_s), frames, {most_flight_pictures - 1}),
                  &Flight::frames)
        .optional("seconds", seconds, &Flight::seconds);
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
    // Every JSON value except the first follows one of these four characters.
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
    Params params;
    double end_s = 0.0;
    Flight flight = flight_form(params, end_s).read(document, where);
    flight.seconds = std::max(flight.seconds, end_s);
    return flight;
}

std::string flight_schema() {
    Params params;
    double end_s = 0.0;
    return form::document("A flight of Viewing Sandbox", flight_form(params, end_s));
}

}  // namespace viewing
