// libFuzzer: reads arbitrary text as a flight. An accepted flight must round-trip exactly. Each of its first pictures
// must either yield an error or be a state that round-trips, and must not depend on how playback reached it.
#include "fuzz.h"
#include "state/file/flight.h"
#include "state/file/state_json.h"

using namespace viewing;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const Result<StateDocument> document = parse_state_document(fuzz::as_text(data, size), "fuzz");
    if (!document) {
        fuzz::check_message(document.error());
        return 0;
    }
    if (!document->flight) return 0;
    const Flight& flight = *document->flight;
    const Result<StateDocument> back = parse_state_document(write_flight(flight), "written");
    fuzz::check(back && back->flight && *back->flight == flight);
    FlightWalk walk(document->flight);
    const std::size_t count = std::min<std::size_t>(flight.picture_count(), 20);
    for (std::size_t i = 0; i < count; ++i) {
        const Result<Params> there = walk.at(i);
        if (!there) {
            fuzz::check_message(there.error());
            return 0;
        }
        const Result<Params> read = parse_state(write_state(*there), "written");
        fuzz::check(read && *read == *there);
    }
    const Result<Params> last = walk.at(count - 1), first = walk.at(0), again = walk.at(count - 1);
    fuzz::check(first && *first == flight.start && again && *again == *last);
    return 0;
}
