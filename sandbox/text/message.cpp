#include "text/message.h"

#include <fmt/args.h>

namespace viewing {

Message::Message(std::string_view english, std::vector<Value> values) : english_(english), values_(std::move(values)) {}

bool Message::operator==(const Message& other) const {
    return english_ == other.english_ && values_ == other.values_;
}

std::string say(const Message& message) {
    if (message.values_.empty()) return std::string(tr_part(message.english_));
    fmt::dynamic_format_arg_store<fmt::format_context> values;
    for (const auto& [name, said, inner] : message.values_)
        values.push_back(fmt::arg(name.c_str(), inner.empty() ? said : say(inner)));
    return say_with({message.english_.data(), message.english_.size()}, values);
}

}  // namespace viewing
