// Every text that a person sees in the window, in the person's language. English is the id of a text: where there is no
// translation it is shown itself. Command lines, state files, ImGui ids, recorded items and tests stay English.
//
//     say("{count} of {all} pixels differ", "count"_a = grouped(count), "all"_a = grouped(all))   whole templates with
//                                named places, never a sentence glued from halves; numbers come as text/numbers.h
//                                writes them. The compiler checks that each place has its value.
//     say_count(n, "one node is built", "{count} nodes are built")   two whole templates, never an "s" glued on
//     tr("Scene")                a text without places that goes straight to ImGui
//     marked("Scene")            the same text in a table: shown later by tr(), or by a widget, which looks up every
//     label,
//                                name, tip, title and sentence that it draws. Literals given to a widget need nothing.
//
// Who chooses among languages is state/person/language.h.
//
// Templates and marked texts are literals, so that tests/catalogue finds them; what the program itself lists (fields,
// presets) it finds through tests/texts. Object names, GL names and code are not texts. assets/text/*.po has the rest.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "text/numbers.h"
#include "text/po.h"

namespace viewing {

// NOLINTNEXTLINE(google-global-names-in-headers): the one literal that templates are filled with
using fmt::literals::operator""_a;

// ---- the language ------------------------------------------------------------------------------------------------

void speak_english();
/// What the entries translate; fuzzy and empty ones stay English. May be called while other threads look texts up.
void speak(std::span<const PoEntry> entries);
/// For tests: each text of the entries in brackets, stretched by 40 %, without one letter of the English alphabet, with
/// its places kept. What is still English then never went through the catalogue.
void speak_pseudo(std::span<const PoEntry> entries);

/// All translations of the language spoken now, one after the other: what its fonts must have. "" in English.
std::string spoken_texts();

/// "[Þçéñé ååå]" for "Scene".
std::string pseudo_text(std::string_view english);

// ---- texts -------------------------------------------------------------------------------------------------------

/// The text in the language spoken now, ended by 0 and there for good; `english` itself where there is none, also in
/// English.
const char* tr(const char* english);
/// The same for a part of a text, such as what a label shows.
std::string_view tr_part(std::string_view english);

/// Marks a literal that is looked up where it is shown.
constexpr const char* marked(const char* english) {
    return english;
}

/// The template in the language spoken now, filled. A translation that does not fit its values counts as missing.
std::string say_with(fmt::string_view english, fmt::format_args values);

template <typename... Values>
std::string say(fmt::format_string<Values...> english, Values&&... values) {
    return say_with(english, fmt::make_format_args(values...));
}

/// What say_count fills {count} with.
using CountValue = decltype("count"_a = std::declval<const std::string&>());

/// `one` for 1, else `many`; {count} is the count, its digits in groups. `one` may say the number in a word.
template <typename... Values>
std::string say_count(std::int64_t count, fmt::format_string<CountValue, Values...> one,
                      fmt::format_string<CountValue, Values...> many, Values&&... values) {
    const std::string number = grouped_number(count);
    const CountValue place = "count"_a = number;
    return say_with(count == 1 ? one : many, fmt::make_format_args(place, values...));
}

}  // namespace viewing
