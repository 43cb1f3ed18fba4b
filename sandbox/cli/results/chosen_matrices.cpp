#include "cli/results/chosen_matrices.h"

#include <array>
#include <charconv>
#include <string_view>

#include "text/words.h"

namespace viewing {
namespace {

constexpr std::array letters{"C", "V", "P", "PV", "S", "R"};
constexpr std::array names{"world_from_view", "view_from_world",   "clip_from_view",
                           "clip_from_world", "shadow_from_world", "mirror_from_world"};
constexpr const char* allowed = "C, V, P, PV, S, S[plane,light], R or R[plane]";

/// One word of the list: "S[2,1]" is the letter S with the indices 2 and 1.
struct Word {
    std::string text;
    std::size_t letter = 0;
    std::vector<std::size_t> indices = {};
};

/// Parses a word; returns nothing if it has another form.
std::optional<Word> parse(const std::string& text) {
    Word word{text};
    const std::size_t bracket = text.find('[');
    const std::string letter = text.substr(0, bracket);
    while (word.letter < letters.size() && letter != letters[word.letter]) ++word.letter;
    if (word.letter == letters.size()) return std::nullopt;
    if (bracket == std::string::npos) return word;
    if (text.back() != ']') return std::nullopt;
    std::string_view rest(text);
    rest = rest.substr(bracket + 1, text.size() - bracket - 2);
    for (const std::string& number : split_outside_brackets(rest, ',')) {
        std::size_t index = 0;
        const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), index);
        if (error != std::errc{} || end != number.data() + number.size()) return std::nullopt;
        word.indices.push_back(index);
    }
    const std::size_t most = letter == "S" ? 2 : letter == "R" ? 1 : 0;
    return word.indices.size() == most ? std::optional(word) : std::nullopt;
}

/// Returns the indices of a word, counted from 0. Ends the command if there is no such plane or light.
Choice pair_of(const Options& options, const Word& word, const Derived& derived) {
    const auto index = [&](std::size_t place, std::size_t count, const char* what) {
        if (place >= word.indices.size()) return std::size_t{0};
        const std::size_t number = word.indices[place];
        if (number < 1 || number > count)
            options.refuse("--only: " + word.text + ": there is no " + what + " " + std::to_string(number) +
                           ", only 1" + (count > 1 ? " to " + std::to_string(count) : ""));
        return number - 1;
    };
    return {index(0, derived.planes.size(), "plane"), index(1, derived.lights_world.size(), "light")};
}

ChosenMatrix matrix_of(const Word& word, const Choice& pair, const Params& params, const Derived& derived) {
    const DerivedPlane& plane = derived.planes[pair.plane];
    const CastShadow& cast = plane.shadows[pair.light];
    const SlipParams& slips = params.slips;
    const std::string key = names[word.letter];
    switch (word.letter) {
        case 0:
            return {key, key, derived.world_from_view, camera_symbols(slips.swapped_order)};
        case 1:
            return {key, key, derived.view_from_world,
                    slips.camera_as_view ? camera_symbols(slips.swapped_order) : view_symbols(slips.swapped_order)};
        case 2:
            return {key, key, derived.clip_from_view, projection_symbols(params, derived.clip_zero_to_one)};
        case 3:
            return {key, key, derived.clip_from_world};
        case 4:
            return {key,
                    key,
                    cast.shadowed_world_from_world,
                    cast.by_hand ? std::nullopt : std::optional(shadow_symbols(slips.shadow_by_rows)),
                    cast.sign,
                    "shadow_sign",
                    "shadow_sign"};
        default:
            return {key, key, plane.mirrored_world_from_world,
                    plane.mirror_by_hand
                        ? std::nullopt
                        : std::optional(mirror_symbols(params.reflection.printed_by_rows, slips.plus_2ab))};
    }
}

}  // namespace

std::vector<ChosenMatrix> chosen_matrices(const Options& options, const std::optional<std::string>& only,
                                          const Params& params, const Derived& derived) {
    std::vector<ChosenMatrix> chosen;
    for (std::size_t letter = 0; !only && letter < letters.size(); ++letter)
        chosen.push_back(matrix_of({letters[letter], letter}, {}, params, derived));
    if (!only) return chosen;
    for (const std::string& text : split_outside_brackets(*only, ',')) {
        const std::optional<Word> word = parse(text);
        if (!word)
            options.refuse("--only: must be a list of " + std::string(allowed) + ", got \"" + one_line(text) + "\"");
        chosen.push_back(matrix_of(*word, pair_of(options, *word, derived), params, derived));
        const std::size_t bracket = text.find('[');
        const std::string indices = bracket == std::string::npos ? "" : text.substr(bracket);
        chosen.back().name = text;
        chosen.back().key += indices;
        chosen.back().sign_name += indices;
        chosen.back().sign_key += indices;
    }
    return chosen;
}

}  // namespace viewing
