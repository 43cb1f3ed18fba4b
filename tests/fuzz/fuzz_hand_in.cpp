// libFuzzer: any text as a student's hand-in. Accepted answers must read back after writing, give the same text when
// they are written again, and merge with themselves. Only the first write may change the form of a setting's number.
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
