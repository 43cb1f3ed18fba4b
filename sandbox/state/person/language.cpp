#include "state/person/language.h"

#include <atomic>
#include <cstdlib>

#include "platform/text_file.h"
#include "state/scene.h"
#include "text/catalogue.h"

namespace viewing {
namespace {

std::atomic<Language> spoken = Language::en;

}  // namespace

Status speak(Language language) {
    speak_english();
    spoken = Language::en;
    if (language == Language::en) return std::monostate{};
    const std::filesystem::path file = assets_directory() / "text" / (std::string(name_of(language)) + ".po");
    const Result<std::string> content = read_text_file(file);
    if (!content) return Error{content.error()};
    const Result<std::vector<PoEntry>> entries = read_po(*content);
    if (!entries) return Error{file.string() + ": " + entries.error()};
    speak(*entries);
    spoken = language;
    return std::monostate{};
}

Language spoken_language() {
    return spoken;
}

Language system_language() {
    for (const char* variable : {"LC_ALL", "LC_MESSAGES", "LANG"}) {
        const char* value = std::getenv(variable);
        if (!value || !*value) continue;
        const std::string_view locale = value, code = locale.substr(0, locale.find_first_of("_.@"));
        for (std::size_t i = 0; i < language_count; ++i)
            if (code == names_of<Language>()[i]) return static_cast<Language>(i);
        break;
    }
    return Language::en;
}

}  // namespace viewing
