// Finds the search entries that match the typed words, and sorts them.
#include <algorithm>
#include <tuple>
#include <utility>

#include "state/file/beside.h"
#include "state/slides.h"
#include "text/numbers.h"
#include "text/words.h"
#include "ui/window/search_entries.h"

namespace viewing {
namespace {

using Words = std::span<const std::string>;

/// Splits a query at whitespace and at the characters that separate a name from its value or one number from the next.
std::vector<std::string> words_of(std::string_view query) {
    std::vector<std::string> words;
    constexpr std::string_view between = " \t\n,=";
    while (true) {
        const std::size_t start = query.find_first_not_of(between);
        if (start == std::string_view::npos) return words;
        query.remove_prefix(start);
        const std::size_t length = std::min(query.find_first_of(between), query.size());
        words.push_back(in_lower_case(std::string(query.substr(0, length))));
        query.remove_prefix(length);
    }
}

bool is_letter(char c) {
    return is_digit(c) || (c >= 'a' && c <= 'z') || static_cast<unsigned char>(c) >= 0x80;
}

enum class Fit { start, inside, none };

/// Returns where a text contains a word: at the start of one of the text's words if possible.
Fit fit_of(std::string_view text, std::string_view word) {
    Fit best = Fit::none;
    for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
        if (at == 0 || !is_letter(text[at - 1])) return Fit::start;
        best = Fit::inside;
    }
    return best;
}

/// Each row lists words that people use for the same thing. They also match as the start of a longer word.
constexpr std::string_view synonyms[][4] = {{"below", "under", "beneath", "behind"},
                                            {"twice", "double", "two times", "darkens"},
                                            {"missing", "lost", "gone", "disappear"},
                                            {"flicker", "stripes", "z-fighting", "fight"},
                                            {"upside", "inverted", "inside out", "flipped"}};

constexpr int no_fit = 1000;

/// Returns how badly one word matches; 0 is best.
int cost_of(const SearchEntry& entry, const std::string& word) {
    const auto cost = [&](std::string_view sought) {
        if (const Fit fit = fit_of(entry.names, sought); fit != Fit::none) return static_cast<int>(fit);
        const Fit fit = fit_of(entry.about, sought);
        return fit == Fit::none ? no_fit : 2 + static_cast<int>(fit);
    };
    int best = cost(word);
    constexpr int for_synonym = 4;
    for (const auto& row : synonyms)
        if (std::find(std::begin(row), std::end(row), word) != std::end(row))
            for (const std::string_view other : row) best = std::min(best, for_synonym + cost(other));
    return std::min(best, no_fit);
}

bool has_little_meaning(const std::string& word) {
    static constexpr std::string_view all[] = {"a", "an", "the", "is", "are", "of", "in", "on", "to", "my", "it"};
    return std::find(std::begin(all), std::end(all), word) != std::end(all);
}

/// Whether the whole query is one of the entry's names.
bool is_name(const SearchEntry& entry, Words words) {
    std::string whole;
    for (const std::string& word : words) whole += (whole.empty() ? "" : " ") + word;
    return ("\n" + entry.names + "\n").find("\n" + whole + "\n") != std::string::npos;
}

/// How badly an entry matches: the number of words that it lacks, then how badly the other words match.
struct Misfit {
    int lacks = 0, cost = 0;
};
Misfit misfit_of(const SearchEntry& entry, Words words) {
    Misfit misfit;
    for (const std::string& word : words) {
        const int cost = cost_of(entry, word);
        if (cost < no_fit)
            misfit.cost += cost;
        else if (!has_little_meaning(word))
            ++misfit.lacks;
    }
    return misfit;
}

std::optional<std::string> as_number(std::string word) {
    constexpr std::string_view minus = "−", degree = "°";
    if (word.starts_with(minus)) word.replace(0, minus.size(), "-");
    if (word.ends_with(degree)) word.resize(word.size() - degree.size());
    return parse_double(word) ? std::optional(word) : std::nullopt;
}

std::optional<std::string> as_numbers(Words words, std::size_t count) {
    if (words.size() != count) return std::nullopt;
    std::string all;
    for (const std::string& word : words) {
        const std::optional<std::string> number = as_number(word);
        if (!number) return std::nullopt;
        all += (all.empty() ? "[" : ",") + *number;
    }
    return all + "]";
}

std::optional<std::string> as_switch(const std::string& word) {
    for (const char* on : {"on", "true", "yes", "1", "켜기", "켬"})
        if (word == on) return "true";
    for (const char* off : {"off", "false", "no", "0", "끄기", "끔"})
        if (word == off) return "false";
    return std::nullopt;
}

/// Returns the first name that starts with the words or, if there is none, the first with a later part that starts with
/// them: "offset" gives polygon_offset.
std::optional<std::string> as_name(Words words, std::span<const char* const> names) {
    std::string typed;
    for (const std::string& word : words) typed += (typed.empty() ? "" : "_") + word;
    const std::string later = "_" + typed;
    for (const char* name : names)
        if (std::string_view(name).starts_with(typed)) return name;
    for (const char* name : names)
        if (std::string_view(name).find(later) != std::string_view::npos) return name;
    return std::nullopt;
}

std::optional<std::string> value_of(const Field& field, Words words) {
    const std::string_view type = type_name(field);
    if (type == "vec3" || type == "vec4") return as_numbers(words, type == "vec3" ? 3 : 4);
    if (type == "enum") {
        Params any;
        return as_name(words, std::get<EnumRef>(field.in(any)).names);
    }
    if (words.size() != 1) return std::nullopt;
    if (type == "bool") return as_switch(words.front());
    if (type == "color") return words.front().starts_with('#') ? std::optional(words.front()) : std::nullopt;
    return as_number(words.front());
}

/// Returns a field's entry, with the value given by the last words; nullopt if they give no value. After "beside", the
/// value is for the second picture.
std::optional<std::pair<SearchEntry, int>> with_value(const SearchEntry& entry, Words words) {
    const auto* const choice = std::get_if<FieldChoice>(&entry.choice);
    const bool is_beside = !words.empty() && (words.front() == "beside" || words.front() == "비교");
    if (is_beside) words = words.subspan(1);
    if (is_beside && choice && !may_differ_beside(choice->path)) return std::nullopt;
    for (std::size_t named = words.size(); choice && named > 1;) {
        const Misfit misfit = misfit_of(entry, words.first(--named));
        if (misfit.lacks > 0) continue;
        const std::optional<std::string> value = value_of(field(choice->path), words.subspan(named));
        if (!value) continue;
        SearchEntry set = entry;
        set.choice = FieldChoice{choice->path, std::string(choice->path) + "=" + *value, is_beside};
        set.note = entry.note + (is_beside ? " | " : " → ") + *value;
        return std::pair{std::move(set), misfit.cost};
    }
    return std::nullopt;
}

}  // namespace

bool contains_words(std::string_view text, std::string_view query) {
    const std::vector<std::string> words = words_of(query);
    return std::all_of(words.begin(), words.end(),
                       [&](const std::string& word) { return text.find(word) != std::string_view::npos; });
}

namespace {

std::vector<SearchEntry> on_slide(std::span<const SearchEntry> entries, int slide, std::size_t most) {
    std::vector<SearchEntry> there;
    for (const SearchEntry& entry : entries)
        if (std::find(entry.slides.begin(), entry.slides.end(), slide) != entry.slides.end()) there.push_back(entry);
    // Troubles show what the slide warns about. Put them after the entries that show the slide's own content.
    std::stable_partition(there.begin(), there.end(),
                          [](const SearchEntry& entry) { return entry.kind != EntryKind::trouble; });
    if (there.size() > most) there.resize(most);
    return there;
}

}  // namespace

std::vector<SearchEntry> found(std::span<const SearchEntry> entries, std::string_view query, std::size_t most) {
    if (const std::optional<int> slide = searched_slide(query)) return on_slide(entries, *slide, most);
    struct Hit {
        SearchEntry entry;
        int lacks, cost;
    };
    const std::vector<std::string> words = words_of(query);
    std::vector<Hit> hits;
    for (const SearchEntry& entry : entries) {
        if (std::optional<std::pair<SearchEntry, int>> set = with_value(entry, words)) {
            hits.push_back({std::move(set->first), 0, set->second});
            continue;
        }
        const Misfit misfit = misfit_of(entry, words);
        hits.push_back({entry, misfit.lacks, is_name(entry, words) ? -1 : misfit.cost});
    }
    const auto meant = static_cast<int>(
        std::count_if(words.begin(), words.end(), [](const std::string& word) { return !has_little_meaning(word); }));
    int least = meant;
    for (const Hit& hit : hits) least = std::min(least, hit.lacks);
    // Return nothing if even the best entries lack more than half of the words.
    if (least > 0 && 2 * least > meant) return {};
    std::erase_if(hits, [&](const Hit& hit) { return hit.lacks > least; });
    if (!words.empty())
        std::stable_sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) {
            const auto order = [](const Hit& hit) {
                return std::tuple(hit.cost, character_count(hit.entry.title), hit.entry.kind);
            };
            return order(a) < order(b);
        });
    std::vector<SearchEntry> best;
    for (Hit& hit : hits) {
        if (best.size() == most) break;
        best.push_back(std::move(hit.entry));
    }
    return best;
}

}  // namespace viewing
