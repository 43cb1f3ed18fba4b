// libFuzzer: reads arbitrary text as a state file and as settings. An accepted state must round-trip exactly, and
// clamping must leave it unchanged.
#include <cstdlib>

#include "state/fields.h"
#include "state/file/state_json.h"

namespace {

using namespace viewing;

void check(bool holds) {
    if (!holds) {
        std::abort();
    }
}

void check_state(const Params& params) {
    const std::string written = write_state(params);
    const Result<Params> back = parse_state(written, "written");
    check(static_cast<bool>(back));
    check(*back == params);
    check(write_state(*back) == written);
    Params clamped = params;
    clamp_to_ranges(clamped);
    check(clamped == params);
}

void check_message(const std::string& message) {
    check(!message.empty() && message.find('\n') == std::string::npos);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    if (const Result<Params> params = parse_state(text, "fuzz")) {
        check_state(*params);
    } else {
        check_message(params.error());
    }

    std::vector<std::string> settings;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        settings.emplace_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    if (const Result<Params> params = apply_settings({}, settings)) {
        check_state(*params);
    }
    return 0;
}
