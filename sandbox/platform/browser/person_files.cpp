#include "platform/person_files.h"

#include <emscripten.h>

#include <utility>

// page_ask_for_file and the next function call app/browser/page/page.js.
EM_JS(void, page_ask_for_file, (), { page.askForFile(); });
EM_JS(void, page_hand_over, (const char* file), { page.handOver(UTF8ToString(file)); });

namespace viewing {
namespace {

std::optional<std::filesystem::path> chosen;

}  // namespace

bool ask_for_file() {
    chosen.reset();
    page_ask_for_file();
    return true;
}

std::optional<std::filesystem::path> chosen_file() {
    return std::exchange(chosen, std::nullopt);
}

void hand_over(const std::filesystem::path& written) {
    page_hand_over(written.c_str());
}

bool can_replace_files() {
    return false;
}

std::string place_for_person(const std::filesystem::path& written) {
    return written.filename().string();
}

}  // namespace viewing

/// Called when the page has stored the chosen file in its file system.
extern "C" EMSCRIPTEN_KEEPALIVE void page_file_is_chosen(const char* file) {
    viewing::chosen = file;
}
