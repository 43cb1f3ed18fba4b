#include "text/catalogue.h"

#include <array>
#include <atomic>
#include <map>
#include <memory>
#include <mutex>

#include "text/particles.h"
#include "text/words.h"

namespace viewing {

namespace {

/// Translations by English text.
using Texts = std::map<std::string, std::string, std::less<>>;

/// The current translations; null for English.
std::atomic<const Texts*> spoken = nullptr;

/// Makes `texts` the current translations. Never frees translations: a string that was looked up may be shown for as
/// long as the program runs.
void speak_texts(Texts texts) {
    static std::mutex mutex;
    static std::vector<std::unique_ptr<const Texts>> all;
    const std::lock_guard lock(mutex);
    all.push_back(std::make_unique<const Texts>(std::move(texts)));
    spoken = all.back().get();
}

const std::string* find_text(std::string_view english) {
    const Texts* texts = spoken;
    if (!texts) return nullptr;
    const auto found = texts->find(english);
    return found == texts->end() ? nullptr : &found->second;
}

/// Replacements for a … z and A … Z: letters of Latin-1 that the fonts have and English does not use.
constexpr std::array<const char*, 26> small_letters = {"å", "þ", "ç", "ð", "é", "ß", "ñ", "ü", "í", "ì", "ø", "î", "ù",
                                                       "ñ", "ö", "þ", "ð", "ë", "ß", "ï", "ú", "ý", "û", "æ", "ÿ", "ç"};
constexpr std::array<const char*, 26> capital_letters = {"Å", "Þ", "Ç", "Ð", "É", "È", "Ñ", "Ü", "Í",
                                                         "Ì", "Ø", "Î", "Ù", "Ñ", "Ö", "Þ", "Ð", "Ë",
                                                         "Ê", "Ï", "Ú", "Ý", "Û", "Æ", "Ø", "Ç"};

}  // namespace

void speak_english() {
    spoken = nullptr;
}

void speak(std::span<const PoEntry> entries) {
    Texts texts;
    for (const PoEntry& entry : entries) {
        if (!entry.is_fuzzy && !entry.translation.empty()) texts.emplace(entry.english, entry.translation);
    }
    speak_texts(std::move(texts));
}

void speak_pseudo(std::span<const PoEntry> entries) {
    Texts texts;
    for (const PoEntry& entry : entries) texts.emplace(entry.english, pseudo_text(entry.english));
    speak_texts(std::move(texts));
}

std::string spoken_texts() {
    std::string all;
    if (const Texts* texts = spoken)
        for (const auto& [english, translation] : *texts) all += translation + '\n';
    return all;
}

std::string pseudo_text(std::string_view english) {
    std::string text = "[";
    std::size_t characters = 0;
    bool in_place = false;
    for (const char byte : english) {
        in_place |= byte == '{';
        const bool is_small = !in_place && byte >= 'a' && byte <= 'z';
        const bool is_capital = !in_place && byte >= 'A' && byte <= 'Z';
        if (is_small) {
            text += small_letters[byte - 'a'];
        } else if (is_capital) {
            text += capital_letters[byte - 'A'];
        } else {
            text += byte;
        }
        if (!in_place && !continues_character(byte)) ++characters;
        in_place &= byte != '}';
    }
    // Add words of five letters, so that lines can still break.
    const std::size_t stretch = (2 * characters + 4) / 5;
    for (std::size_t i = 0; i < stretch; ++i) text += i % 6 == 0 ? " " : "å";
    return text + "]";
}

const char* tr(const char* english) {
    const std::string* text = find_text(english);
    return text ? text->c_str() : english;
}

std::string_view tr_part(std::string_view english) {
    const std::string* text = find_text(english);
    return text ? std::string_view(*text) : english;
}

std::string object_text(std::string_view name) {
    const std::size_t end = name.find_last_not_of("0123456789");
    const bool is_numbered = end != std::string_view::npos && end + 1 < name.size() && name[end] == ' ';
    if (!is_numbered) return std::string(tr_part(name));
    return std::string(tr_part(name.substr(0, end))) + std::string(name.substr(end));
}

std::string say_with(fmt::string_view english, fmt::format_args values) {
    if (const std::string* text = find_text({english.data(), english.size()})) {
        try {
            return with_particles(fmt::vformat(*text, values));
        } catch (const fmt::format_error&) {
            // A translator's mistake: fall back to English.
        }
    }
    return fmt::vformat(english, values);
}

}  // namespace viewing
