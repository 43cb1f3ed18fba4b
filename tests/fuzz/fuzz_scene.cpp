// libFuzzer: reads arbitrary text as a scene file. An accepted scene must round-trip exactly.
#include <cstdlib>

#include "state/file/reader.h"
#include "state/file/state_json.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const auto scene = viewing::parse_scene(text, "fuzz");
    if (!scene) {
        return 0;
    }
    const std::string written = scene_as_json(*scene).dump();
    const auto back = viewing::parse_scene(written, "written");
    if (!back || *back != *scene || scene_as_json(*back).dump() != written) {
        std::abort();
    }
    return 0;
}
