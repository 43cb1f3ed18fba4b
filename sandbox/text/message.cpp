#include "text/message.h"

#include <fmt/args.h>

namespace viewing {

Message::Message(std::string_view english, std::vector<Value> values) : english_(english), values_(std::move(values)) {}

bool Message::operator==(const Message& other) const {
    return english_ == other.english_ && values_ == other.values_;
}

std::vector<std::pair<std::string, std::string>> Message::said_values() const {
    std::vector<std::pair<std::string, std::string>> all;
    for (const Value& value : values_) {
        std::string& said = all.emplace_back(value.name, value.is_object ? object_text(value.text) : value.text).second;
        for (const Message& part : value.list) said += (said.empty() ? "" : ", ") + say(part);
    }
    return all;
}

std::string say(const Message& message) {
    if (message.values_.empty()) return std::string(tr_part(message.english_));
    fmt::dynamic_format_arg_store<fmt::format_context> values;
    for (const auto& [name, said] : message.said_values()) values.push_back(fmt::arg(name.c_str(), said));
    return say_with({message.english_.data(), message.english_.size()}, values);
}

Message object_message(std::string_view name) {
    return {"{object}", {{"object", std::string(name), {}, true}}};
}

Message listed(const std::vector<Message>& messages) {
    return messages.empty() ? Message() : Message("{all}", {{"all", "", messages}});
}

}  // namespace viewing
