// libFuzzer: reads arbitrary text as a link. A state accepted from a link must round-trip through its own link exactly.
#include <cstdlib>

#include "platform/text_file.h"
#include "state/file/link.h"
#include "state/file/state_json.h"

namespace {

using namespace viewing;

void check(bool holds) {
    if (!holds) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const Result<Link> link = read_link({reinterpret_cast<const char*>(data), size});
    if (!link) {
        check(!link.error().empty() && link.error().find('\n') == std::string::npos);
        return 0;
    }
    check(link->text.size() <= max_document_bytes);
    if (link->kind != Link::Kind::state) return 0;
    const Result<Params> params = parse_state(link->text, "link");
    if (!params) return 0;
    const Result<Link> again = read_link(link_fragment(*params));
    check(static_cast<bool>(again));
    const Result<Params> back = parse_state(again->text, "link");
    check(back && *back == *params);
    return 0;
}
