#include "cli/option_values.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <vector>

#include "image/image_size.h"
#include "image/png.h"
#include "state/file/link.h"
#include "text/catalogue.h"
#include "text/numbers.h"
#include "text/words.h"

namespace viewing {
namespace {

std::optional<int> parse_int(std::string_view text) {
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return number;
}

/// Parses two whole numbers separated by `between`.
std::optional<glm::ivec2> parse_pair(const std::string& text, char between) {
    const std::size_t at = text.find(between);
    if (at == std::string::npos) return std::nullopt;
    const std::optional<int> x = parse_int(std::string_view(text).substr(0, at));
    const std::optional<int> y = parse_int(std::string_view(text).substr(at + 1));
    if (!x || !y) return std::nullopt;
    return glm::ivec2(*x, *y);
}

std::string got(const std::string& text) {
    return ", got \"" + one_line(text) + "\"";
}

}  // namespace

glm::ivec2 size_option(const Options& options, const std::optional<std::string>& text, int most_pixels) {
    if (!text) return default_size_px;
    const std::optional<glm::ivec2> size = parse_pair(*text, 'x');
    if (!size) options.refuse("--size: must be WIDTHxHEIGHT in pixels, such as 1280x720" + got(*text));
    if (!is_image_size(size->x, size->y, most_pixels))
        options.refuse("--size: " + image_size_rule(most_pixels) + got(*text));
    return *size;
}

glm::ivec2 pixel_option(const Options& options, const std::optional<std::string>& text, glm::ivec2 size_px,
                        const std::string& place) {
    const std::string range = "X from 0 to " + std::to_string(size_px.x - 1) + " and Y from 0 to " +
                              std::to_string(size_px.y - 1) + ", counted from the top left";
    if (!text) options.refuse("--pixel is missing: X,Y with " + range);
    const std::optional<glm::ivec2> pixel = parse_pair(*text, ',');
    if (!pixel || pixel->x < 0 || pixel->y < 0 || pixel->x >= size_px.x || pixel->y >= size_px.y)
        options.refuse(place + ": must be X,Y with " + range + got(*text));
    return *pixel;
}

int whole_option(const Options& options, const char* name, const std::string& text, int min, int max) {
    const std::optional<int> value = parse_int(text);
    if (!value || *value < min || *value > max)
        options.refuse(std::string(name) + ": must be a whole number from " + std::to_string(min) + " to " +
                       std::to_string(max) + got(text));
    return *value;
}

double number_option(const Options& options, const char* name, const std::string& text, double min, double max) {
    const std::optional<double> value = parse_double(text);
    if (!value || !(*value >= min && *value <= max))
        options.refuse(std::string(name) + ": must be a number from " + format_number(min) + " to " +
                       format_number(max) + got(text));
    return *value;
}

std::size_t choice_option(const Options& options, const char* name, const std::string& text,
                          std::span<const char* const> names) {
    for (std::size_t i = 0; i < names.size(); ++i)
        if (text == names[i]) return i;
    const std::vector<std::string> known(names.begin(), names.end());
    const std::string allowed = names.size() == 2 ? known[0] + " or " + known[1] : "one of " + joined(names);
    options.refuse(std::string(name) + ": must be " + allowed + got(text) + suggestion(text, known));
}

bool is_png_name(const std::string& name) {
    return in_lower_case(std::filesystem::path(name).extension().string()) == ".png";
}

namespace {

/// Refuses the name of a file, but not "-" and no device or pipe, because it has none of the `endings`.
void refuse_file_name(const Options& options, const char* name, const std::string& target, const char* endings) {
    namespace fs = std::filesystem;
    std::error_code error;
    const fs::file_status there = fs::status(target, error);
    const bool is_named = !fs::exists(there) || fs::is_regular_file(there);
    if (target != "-" && !target.empty() && is_named)
        options.refuse(std::string(name) + ": must end in " + endings + ", or be - for standard output" + got(target));
}

}  // namespace

void check_picture_name(const Options& options, const char* name, const std::string& target, const char* endings) {
    if (!is_png_name(target)) refuse_file_name(options, name, target, endings);
}

void check_handout(const Options& options, const std::optional<std::string>& handout, bool has_answers,
                   bool opens_window) {
    if (has_answers && !handout) options.refuse("--answers needs --handout");
    if (!handout) return;
    if (opens_window) options.refuse("--handout contains all steps: --present, --step and --notes need the window");
}

void check_page_name(const Options& options, const char* name, const std::string& target) {
    const std::string ending = in_lower_case(std::filesystem::path(target).extension().string());
    if (ending != ".html" && ending != ".htm") refuse_file_name(options, name, target, ".html");
}

std::optional<int> samples_option(const Options& options, const std::optional<std::string>& text) {
    if (!text) return std::nullopt;
    constexpr std::array choices{"0", "4"};
    return choice_option(options, "--samples", *text, choices) == 0 ? 0 : 4;
}

std::string points_text(int points) {
    return say_count(points, "1 point", "{count} points");
}

std::optional<Language> language_option(const Options& options, const std::optional<std::string>& text) {
    if (!text) return std::nullopt;
    return static_cast<Language>(choice_option(options, "--language", *text, names_of<Language>()));
}

std::string address_option(const Options& options, const char* name, const std::optional<std::string>& text) {
    if (text && text->find_first_of("# \t\r\n") != std::string::npos)
        options.refuse(std::string(name) + ": must be an address without # or spaces");
    return text.value_or(link_base());
}

void speak_option(const Options& options, const std::optional<std::string>& text) {
    if (const std::optional<Language> language = language_option(options, text)) value_or_end(speak(*language));
}

}  // namespace viewing
