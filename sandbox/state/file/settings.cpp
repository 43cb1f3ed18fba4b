// `--set PATH=VALUE`: a path names a field, a group of fields, or a part of a field's value.
#include <charconv>
#include <optional>

#include "state/file/reader.h"
#include "state/file/state_json.h"

namespace viewing {

namespace {

/// Parses VALUE as JSON; treats it as a string if it is not JSON.
Json value_of(const std::string& text, const Where& where) {
    try {
        return parse_document(text, where.prefix + where.path + ": ");
    } catch (const SyntaxRefusal&) {
        return text;
    }
}

/// Returns the field that the path names, or that contains the named part; stores the rest of the path in `rest`.
const Field* field_at(std::string_view path, std::string_view& rest) {
    for (const Field& field : fields()) {
        if (path.starts_with(field.path)) {
            rest = path.substr(field.path.size());
            if (rest.empty() || rest.front() == '.' || rest.front() == '[') {
                return &field;
            }
        }
    }
    return nullptr;
}

/// Removes an index such as `[2]` from the front of `rest` and returns that element of the value. An index just past
/// the end adds an element, so that arrays can grow.
Json& element(Json& value, std::string_view& rest, Where& where) {
    const std::size_t close = rest.find(']');
    std::size_t index = 0;
    const char* end = close == std::string_view::npos ? nullptr : rest.data() + close;
    if (end == nullptr || close < 2 || close > 6 || std::from_chars(rest.data() + 1, end, index).ptr != end) {
        where.refuse("\"" + std::string(rest) + "\" is not an index such as [0]");
    }
    rest.remove_prefix(close + 1);
    if (!value.is_array()) {
        where.refuse("has no elements: it is " + describe(value));
    }
    if (index > value.size()) {
        where.at(index).refuse("no such element: the length of the array is " + std::to_string(value.size()));
    }
    where = where.at(index);
    if (index == value.size()) {
        value.push_back(nullptr);
    }
    return value[index];
}

/// Removes a name such as `.name` from the front of `rest` and returns that member of the value; null becomes an
/// object.
Json& member(Json& value, std::string_view& rest, Where& where) {
    const std::string_view name = rest.substr(1, rest.find_first_of(".[", 1) - 1);
    rest.remove_prefix(1 + name.size());
    if (!value.is_object() && !value.is_null()) {
        where.refuse("has no fields: it is " + describe(value));
    }
    where = where.key(name);
    return value[std::string(name)];
}

/// Replaces the part of `whole` that `rest` names, such as ".name" or "[2]"; `path` names the whole.
void set_part(Json& whole, std::string_view path, std::string_view rest, const Json& value, const std::string& prefix) {
    Json* part = &whole;
    Where where{prefix, std::string(path)};
    while (!rest.empty()) {
        if (rest.front() != '.' && rest.front() != '[') {
            where.refuse("must not be followed by \"" + std::string(rest) + "\"");
        }
        part = rest.front() == '[' ? &element(*part, rest, where) : &member(*part, rest, where);
    }
    *part = value;
}

/// Applies settings one by one. Parts of camera.look_at are collected and applied at the end, since a camera with only
/// some of them may be degenerate.
class Applier {
public:
    Applier(Params params, const std::string& prefix) : params_(std::move(params)), prefix_(prefix) {}

    void apply(const std::string& setting) {
        const std::size_t equals = setting.find('=');
        if (equals == std::string::npos || equals == 0) {
            throw Refusal(prefix_ + setting + ": must be PATH=VALUE, such as projection.near=0.01");
        }
        const Where where{prefix_, setting.substr(0, equals)};
        const Json value = value_of(setting.substr(equals + 1), where);

        std::string_view rest;
        if (const Field* field = field_at(where.path, rest)) {
            note_camera(field->path);
            // Reads the whole field again, so that the rules for a state file apply.
            Json whole = field_as_json(*field, params_);
            set_part(whole, field->path, rest, value, prefix_);
            read_field(*field, params_, whole, {prefix_, std::string(field->path)});
        } else if (is_in(where.path, look_at_path)) {
            set_look_at(std::string_view(where.path).substr(look_at_path.size()), value);
        } else if (is_group(where.path)) {
            read_group(params_, value, where);
        } else {
            refuse_unknown(where);
        }
    }

    Params result() {
        if (!look_at_.is_null()) params_.camera.look(read_look_at(look_at_, {prefix_, std::string(look_at_path)}));
        return params_;
    }

private:
    void set_look_at(std::string_view rest, const Json& value) {
        if (look_at_.is_null()) look_at_ = look_at_as_json(params_.camera.look_at());
        set_part(look_at_, look_at_path, rest, value, prefix_);
        if (!look_at_.is_object()) read_look_at(look_at_, {prefix_, std::string(look_at_path)});  // refuses it
        note_camera(look_at_path);
    }

    /// Refuses settings of both look_at and a field that it replaces.
    void note_camera(std::string_view path) {
        if (path != "camera.navigation" && path != "camera.target" && is_in(path, "camera"))
            camera_[std::string(path.substr(path.find('.') + 1))] = true;
        require_one_camera(camera_, {prefix_, "camera"});
    }

    Params params_;
    const std::string& prefix_;
    Json look_at_, camera_ = Json::object();
};

}  // namespace

std::vector<std::string> read_settings(const Json& object, const Where& where) {
    require_object(object, where, "an object of paths and values");
    std::vector<std::string> settings;
    for (const auto& [path, value] : object.items()) {
        if (path.find('=') != std::string::npos) where.key(path).refuse("no such field");
        settings.push_back(path + "=" + value.dump());
    }
    return settings;
}

Json settings_as_json(const std::vector<std::string>& settings) {
    Json object = Json::object();
    for (const std::string& setting : settings) {
        const std::size_t sign = setting.find('=');
        object[setting.substr(0, sign)] = Json::parse(setting.substr(sign + 1), nullptr, false);
    }
    return object;
}

std::vector<std::string> settings_to(Params before, Params after) {
    std::vector<std::string> settings;
    for (const Field& field : fields()) {
        const Json value = field_as_json(field, after);
        if (value != field_as_json(field, before))
            settings.push_back(std::string(field.path) + "=" +
                               value.dump(-1, ' ', false, Json::error_handler_t::replace));  // names may hold any bytes
    }
    return settings;
}

std::string setting_of(std::string_view path, const Params& params) {
    Params copy = params;
    const Json value = field_as_json(field(path), copy);
    return std::string(path) + "=" + (value.is_string() ? value.get<std::string>() : value.dump());
}

std::string default_setting(std::string_view path) {
    return setting_of(path, {});
}

Params applied(Params params, std::span<const std::string> settings, const std::string& source) {
    Applier applier(std::move(params), source);
    for (const std::string& setting : settings) {
        applier.apply(setting);
    }
    return applier.result();
}

Result<Params> apply_settings(Params params, std::span<const std::string> settings, const std::string& source) {
    return guarded([&] {
        params = applied(std::move(params), settings, source);
        if (!settings.empty()) {
            check_together(params, source);
        }
        return params;
    });
}

}  // namespace viewing
