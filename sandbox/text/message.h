// A text that does not depend on the language: an English template and its values. Code that computes, compares or
// keeps texts uses messages; say() translates a message where it is shown.
//
//     pass.name = message("Shadow of light {light}", "light"_a = light + 1);
//     message("{pass} in mirror {mirrors}", "pass"_a = pass.name, "mirrors"_a = "2, 3")
//                                a value may itself be a message; say() translates both
#pragma once

#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "text/catalogue.h"

namespace viewing {

class Message {
public:
    struct Value;

    Message() = default;
    /// A literal without placeholders. Call message() instead if tests/catalogue should find the literal.
    template <std::size_t N>
    Message(const char (&english)[N]) : english_(english) {}  // NOLINT(google-explicit-constructor)
    /// `english` must live as long as the program, as literals do.
    Message(fmt::string_view english, std::vector<Value> values);

    bool empty() const { return english_.empty(); }
    /// Returns the placeholders' names and what replaces them in the current language.
    std::vector<std::pair<std::string, std::string>> said_values() const;
    bool operator==(const Message& other) const;

private:
    friend std::string say(const Message& message);

    std::string_view english_;
    std::vector<Value> values_;
};

/// A placeholder's name, and what replaces it: a text, the name of an object, or a list of messages.
struct Message::Value {
    enum class Form { as_it_is, object, begun, ended };

    std::string name, text;
    std::vector<Message> list{};  ///< if not empty, used instead of `text`
    std::string_view between = ", ";
    Form form = Form::as_it_is;
    bool operator==(const Value&) const = default;
};

/// Returns the message in the current language.
std::string say(const Message& message);

template <typename T>
Message::Value message_value(const char* name, const T& said) {
    if constexpr (std::is_same_v<T, Message>)
        return {name, "", {said}};
    else
        return {name, fmt::to_string(said)};
}

/// The compiler checks that each placeholder has a value, as in say().
template <typename... Values>
Message message(fmt::format_string<Values...> english, Values&&... values) {
    return {english, {message_value(values.name, values.value)...}};
}

/// The message of say_count().
template <typename... Values>
Message message_count(std::int64_t count, fmt::format_string<CountValue, Values...> one,
                      fmt::format_string<CountValue, Values...> many, Values&&... values) {
    return {count == 1 ? one : many,
            {message_value("count", grouped_number(count)), message_value(values.name, values.value)...}};
}

/// Returns a message that say() turns into object_text(name).
Message object_message(std::string_view name);

/// Returns a message that is the same in every language.
Message verbatim(std::string text);

/// Returns the message "a, b"; an empty one if there are none. `between` must live as long as the program.
Message listed(const std::vector<Message>& messages, std::string_view between = ", ");

/// Returns the message "a, b, and c", for names within a sentence; an empty one if there are none.
Message enumerated(const std::vector<Message>& messages);

/// Returns the message with a capital first letter; "n·ℓ" at its start stays as it is.
Message begun(const Message& message);

/// Returns the message with a period at its end.
Message ended(const Message& message);

}  // namespace viewing

/// A message may be a value of say().
template <>
struct fmt::formatter<viewing::Message> : fmt::formatter<std::string_view> {
    template <typename Context>
    auto format(const viewing::Message& message, Context& context) const {
        return fmt::formatter<std::string_view>::format(viewing::say(message), context);
    }
};
