// Font files in the browser: embedded in the program, or fetched from the page's folder.
#include "ui/window/font_files.h"

#include <emscripten.h>

#include <map>
#include <string>
#include <vector>

#include "embedded/fonts.h"

EM_JS(void, page_fetch_font, (const char* name), { page.fetchFont(UTF8ToString(name)); });

namespace viewing {
namespace {

/// The files requested so far; each one is empty until it arrives.
std::map<std::string, std::vector<std::byte>, std::less<>> fetched;
int arrived = 0;

}  // namespace

std::span<const std::byte> font_file(std::string_view name) {
    if (const std::span<const std::byte> part = embedded_font(name); !part.empty()) return part;
    const auto [at, is_new] = fetched.try_emplace(std::string(name));
    if (is_new) page_fetch_font(at->first.c_str());
    return at->second;
}

int arrived_font_files() {
    return arrived;
}

}  // namespace viewing

/// The page calls this function when a requested file has arrived.
extern "C" EMSCRIPTEN_KEEPALIVE void page_font_has_come(const char* name, const std::byte* bytes, int size) {
    viewing::fetched[name].assign(bytes, bytes + size);
    ++viewing::arrived;
}
