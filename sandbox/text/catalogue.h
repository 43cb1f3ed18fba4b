// Every text of the window, in the user's language. A text's English version is its id, and is shown if there is no
// translation. Command lines, state files, ImGui ids, recorded items and tests stay English.
//
//     say("{count} of {all} pixels differ", "count"_a = grouped_number(count), "all"_a = grouped_number(all))
//                                whole templates with named placeholders, never a sentence joined from halves;
//                                text/numbers.h formats the numbers. The compiler checks that each placeholder has a
//                                value.
//     say_count(n, "one node is built", "{count} nodes are built")
//                                two whole templates, never an appended "s"
//     tr("Scene")                a text without placeholders that goes straight to ImGui
//     marked("Scene")            a text in a table, which tr() or a widget looks up later. A widget looks up every
//                                label, name, tip, title and sentence that it draws, so literals given to a widget
//                                need no marking.
//
// state/person/language.h chooses the language.
//
// Templates and marked texts are literals, so that tests/catalogue finds them. tests/texts lists the texts in the
// program's own tables (fields, presets). Object names, GL names and code are not texts. assets/text/*.po has the
// translations.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "text/numbers.h"
#include "text/po.h"

namespace viewing {

// NOLINTNEXTLINE(google-global-names-in-headers): the only literal operator that fills templates
using fmt::literals::operator""_a;

// ---- the language ------------------------------------------------------------------------------------------------

void speak_english();
/// Sets the translations; fuzzy and empty ones stay English. Safe while other threads look up texts.
void speak(std::span<const PoEntry> entries);
/// For tests: translates each entry to its English text in brackets, 40 % longer and with every letter replaced;
/// placeholders stay. Text that still appears in English never went through the catalog.
void speak_pseudo(std::span<const PoEntry> entries);

/// Returns all translations of the current language in one string, so that fonts can be loaded with all characters that
/// occur; "" for English.
std::string spoken_texts();

/// Returns "[Êçéñé å]" for "Scene".
std::string pseudo_text(std::string_view english);

// ---- texts -------------------------------------------------------------------------------------------------------

/// Returns the text in the current language, null-terminated and never freed; `english` itself for English, or if there
/// is no translation.
const char* tr(const char* english);
/// Translates a part of a text, such as the visible part of a label.
std::string_view tr_part(std::string_view english);

/// Returns the translated name of an object in the program's own scenes; a number at its end stays: "post 3".
std::string object_text(std::string_view name);

/// Marks a literal that is looked up where it is shown.
constexpr const char* marked(const char* english) {
    return english;
}

/// Fills the template in the current language. A translation whose placeholders do not match the values counts as
/// missing.
std::string say_with(fmt::string_view english, fmt::format_args values);

template <typename... Values>
std::string say(fmt::format_string<Values...> english, Values&&... values) {
    return say_with(english, fmt::make_format_args(values...));
}

/// The value that say_count inserts for {count}.
using CountValue = decltype("count"_a = std::declval<const std::string&>());

/// Uses `one` for 1, otherwise `many`; {count} is the count with its digits in groups. `one` may spell the number out.
template <typename... Values>
std::string say_count(std::int64_t count, fmt::format_string<CountValue, Values...> one,
                      fmt::format_string<CountValue, Values...> many, Values&&... values) {
    const std::string number = grouped_number(count);
    const CountValue place = "count"_a = number;
    return say_with(count == 1 ? one : many, fmt::make_format_args(place, values...));
}

}  // namespace viewing
