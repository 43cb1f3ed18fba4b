// libFuzzer: reads arbitrary text as a student's hand-in. An accepted hand-in must read back after it is written, yield
// the same text when it is written again, and merge with itself. Only the first write may change how a setting's number
// is written.
#include "fuzz.h"
#include "lesson/hand_in.h"

using namespace viewing;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const Result<HandIn> hand_in = parse_hand_in(fuzz::as_text(data, size), "fuzz");
    if (!hand_in) {
        fuzz::check_message(hand_in.error());
        return 0;
    }
    const std::string written = hand_in_as_text(*hand_in);
    const Result<HandIn> back = parse_hand_in(written, "written");
    fuzz::check(back && hand_in_as_text(*back) == written);
    const HandIn both = merged(*hand_in, {}, *back);
    fuzz::check(both.items.size() == hand_in->items.size());
    return 0;
}
