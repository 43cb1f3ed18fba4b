// The kinds of choices: yes or no, one name of a list, or several.
#pragma once

#include <algorithm>

#include "state/kinds/kind.h"
#include "text/words.h"

namespace viewing::kinds {

template <>
struct Kind<bool*> : AnyKind {
    static constexpr std::string_view type = "bool";
    static Form<bool> form(const Field&) { return form::boolean(); }
    static Json write(const bool* value) { return *value; }
};

template <>
struct Kind<EnumRef> : AnyKind {
    static constexpr std::string_view type = "enum";
    static Form<int> form(const Field& field) { return form::choice(std::get<EnumRef>(default_ref(field)).names); }
    static std::vector<std::string> names(const Field& field) {
        const auto all = std::get<EnumRef>(default_ref(field)).names;
        return {all.begin(), all.end()};
    }
    static void assign(const EnumRef& to, int index) { to.set(index); }
    static Json write(const EnumRef& value) { return value.names[value.index()]; }
};

template <>
struct Kind<std::vector<std::string>*> : AnyKind {
    static constexpr std::string_view type = "names";
    static std::vector<std::string> names(const Field& field) {
        return field.names.empty() ? known_paths() : std::vector<std::string>(field.names.begin(), field.names.end());
    }
    static Form<std::vector<std::string>> form(const Field& field) {
        const std::string each = field.names.empty() ? "the path of a field or group" : "one of " + joined(field.names);
        const std::string what = "an array of different names, each " + each;
        const std::vector<std::string> allowed = names(field);
        const auto read = [=](const Json& value, const Where& where) {
            require_array(value, where, allowed.size(), what);
            std::vector<std::string> names;
            for (std::size_t i = 0; i < value.size(); ++i) {
                const std::string name = read_name(value[i], where.at(i));
                if (std::find(allowed.begin(), allowed.end(), name) == allowed.end())
                    where.at(i).refuse("must be " + each + ", got " + describe(value[i]) + suggestion(name, allowed));
                if (std::find(names.begin(), names.end(), name) != names.end())
                    where.at(i).refuse(describe(value[i]) + " appears twice in the list");
                names.push_back(name);
            }
            return names;
        };
        const auto schema = [allowed](Json&) {
            Json list = form::list_of({{"enum", allowed}}, allowed.size());
            list["uniqueItems"] = true;
            return list;
        };
        return {what, {}, read, schema};
    }
    static Json write(const std::vector<std::string>* value) { return *value; }
};

}  // namespace viewing::kinds
