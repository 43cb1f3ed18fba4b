// Parses the values of options. Every error message names the option and the allowed values.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>

#include "cli/options.h"
#include "image/image_size.h"
#include "state/person/language.h"

namespace viewing {

/// The default of --size.
inline constexpr glm::ivec2 default_size_px{1280, 720};

/// Parses "1280x720": sides from 1 to 16384, at most `most_pixels`. Returns the default if the option was left out.
glm::ivec2 size_option(const Options& options, const std::optional<std::string>& text,
                       int most_pixels = most_drawn_pixels);

/// Parses "X,Y", which must be inside a picture of size `size_px`. `place` names the source in messages.
glm::ivec2 pixel_option(const Options& options, const std::optional<std::string>& text, glm::ivec2 size_px,
                        const std::string& place = "--pixel");

/// Parse a whole number, or any finite number, from `min` to `max` inclusive.
int whole_option(const Options& options, const char* name, const std::string& text, int min, int max);
double number_option(const Options& options, const char* name, const std::string& text, double min, double max);

/// Returns the index of a name; the error message for a misspelled name suggests the nearest one.
std::size_t choice_option(const Options& options, const char* name, const std::string& text,
                          std::span<const char* const> names);

/// Whether a name ends in .png, in upper or lower case.
bool is_png_name(const std::string& name);

/// Refuses the name of an output picture unless it ends in .png, is "-", or names a device or a pipe. `endings`: all
/// that the option takes.
void check_picture_name(const Options& options, const char* name, const std::string& target,
                        const char* endings = ".png");

/// Refuses options that do not go with --handout or without it. `opens_window`: --present, --step or --notes is given.
void check_handout(const Options& options, const std::optional<std::string>& handout, bool has_answers,
                   bool opens_window);
/// Refuses the name of a page unless it ends in .html, is "-", or names a device or a pipe.
void check_page_name(const Options& options, const char* name, const std::string& target);

/// Returns the value of --samples, 0 or 4; nothing if the option was left out.
std::optional<int> samples_option(const Options& options, const std::optional<std::string>& text);

/// Returns, for example, "3 points", in the current language.
std::string points_text(int points);

/// Returns the value of --language; nothing if the option was left out.
std::optional<Language> language_option(const Options& options, const std::optional<std::string>& text);

/// Makes the language of --language the current one; without the option, changes nothing.
void speak_option(const Options& options, const std::optional<std::string>& text);

/// Returns the address before a link's #, as typed; the default if the option was left out.
std::string address_option(const Options& options, const char* name, const std::optional<std::string>& text);
/// The help text of --base.
inline constexpr const char* base_help =
    "Address before the # of a link; default $VIEWING_SANDBOX_LINK_BASE, else viewing-sandbox.html";

/// The help texts of --samples and --size.
inline constexpr const char* samples_help = "Multisampling; default: view.samples of the state";
inline constexpr const char* size_help =
    "Width and height of the picture in pixels, 1x1 to 16384x16384 and at most 16 million pixels; default 1280x720";

}  // namespace viewing
