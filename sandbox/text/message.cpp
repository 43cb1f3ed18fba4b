#include "text/message.h"

#include <fmt/args.h>

namespace viewing {

Message::Message(fmt::string_view english, std::vector<Value> values)
    : english_(english.data(), english.size()), values_(std::move(values)) {}

bool Message::operator==(const Message& other) const {
    return english_ == other.english_ && values_ == other.values_;
}

namespace {

std::string text_of(const Message::Value& value) {
    using Form = Message::Value::Form;
    const auto is_small = [](char letter) { return letter >= 'a' && letter <= 'z'; };
    std::string said = value.form == Form::object ? object_text(value.text) : value.text;
    for (const Message& part : value.list) {
        if (&part != &value.list.front()) said += value.between;
        said += say(part);
    }
    if (value.form == Form::begun && said.size() > 1 && is_small(said[0]) && is_small(said[1]))
        said[0] = static_cast<char>(said[0] - 'a' + 'A');
    return value.form == Form::ended && !said.ends_with('.') ? said + "." : said;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> Message::said_values() const {
    std::vector<std::pair<std::string, std::string>> all;
    for (const Value& value : values_) all.emplace_back(value.name, text_of(value));
    return all;
}

std::string say(const Message& message) {
    if (message.values_.empty()) return std::string(tr_part(message.english_));
    fmt::dynamic_format_arg_store<fmt::format_context> values;
    for (const auto& [name, said] : message.said_values()) values.push_back(fmt::arg(name.c_str(), said));
    return say_with({message.english_.data(), message.english_.size()}, values);
}

Message object_message(std::string_view name) {
    return {"{all}", {{"all", std::string(name), {}, "", Message::Value::Form::object}}};
}

Message verbatim(std::string text) {
    return {"{all}", {{"all", std::move(text)}}};
}

Message listed(const std::vector<Message>& messages, std::string_view between) {
    return messages.empty() ? Message() : Message("{all}", {{"all", "", messages, between}});
}

Message enumerated(const std::vector<Message>& messages) {
    if (messages.size() <= 1) return listed(messages);
    const Message before = listed({messages.begin(), messages.end() - 1});
    const Message& last = messages.back();
    return messages.size() == 2 ? message("{names} and {last_name}", "names"_a = before, "last_name"_a = last)
                                : message("{names}, and {last_name}", "names"_a = before, "last_name"_a = last);
}

Message begun(const Message& message) {
    return {"{all}", {{"all", "", {message}, "", Message::Value::Form::begun}}};
}

Message ended(const Message& message) {
    return {"{all}", {{"all", "", {message}, "", Message::Value::Form::ended}}};
}

}  // namespace viewing
