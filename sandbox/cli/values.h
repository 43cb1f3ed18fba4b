// Values of options, from the text a person typed. Every refusal names the option and what is allowed.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>

#include "cli/options.h"
#include "image/image_size.h"
#include "state/person/language.h"

namespace viewing {

/// The size of a picture when --size is left out.
inline constexpr glm::ivec2 default_size_px{1280, 720};

/// "1280x720": sides 1 … 16384, at most `most_pixels`. Left out: the default.
glm::ivec2 size_option(const Options& options, const std::optional<std::string>& text,
                       int most_pixels = most_drawn_pixels);

/// "X,Y" inside a picture of that size.
glm::ivec2 pixel_option(const Options& options, const std::optional<std::string>& text, glm::ivec2 size_px);

/// A whole number, or any finite number, between two limits, both allowed.
int whole_option(const Options& options, const char* name, const std::string& text, int min, int max);
double number_option(const Options& options, const char* name, const std::string& text, double min, double max);

/// The index of a name; a misspelt one gets the nearest.
std::size_t choice_option(const Options& options, const char* name, const std::string& text,
                          std::span<const char* const> names);

/// Whether a name ends in .png, in capitals or not.
bool is_png_name(const std::string& name);

/// The name of a picture that is written: it ends in .png, or is "-", or that of a device or a pipe.
void check_picture_name(const Options& options, const char* name, const std::string& target);

/// The value of --samples, 0 or 4; none where it was left out.
std::optional<int> samples_option(const Options& options, const std::optional<std::string>& text);

/// The value of --language; none where it was left out.
std::optional<Language> language_option(const Options& options, const std::optional<std::string>& text);

/// What --help says about --samples and --size.
inline constexpr const char* samples_help = "Multisampling; default: view.samples of the state";
inline constexpr const char* size_help =
    "Width and height of the picture in pixels, 1x1 to 16384x16384 and at most 16 million pixels; default 1280x720";

}  // namespace viewing
