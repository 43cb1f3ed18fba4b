// The form of a JSON value, declared once: it reads the value, with a message for each mistake, and makes the value's
// JSON Schema (draft 2020-12). A file's form is an Object, whose members have forms. form.cpp has the forms of plain
// values.
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "state/file/reader.h"
#include "text/words.h"

namespace viewing::form {

/// Puts a schema into `definitions` under `name`, and returns a schema that refers to it.
Json defined(Json& definitions, const char* name, Json schema);

/// Calls `change` with a value and, if `change` takes two arguments, with the value's place.
template <typename Change, typename V>
auto called(const Change& change, V value, const Where& where) {
    if constexpr (std::is_invocable_v<const Change&, V, const Where&>)
        return change(std::move(value), where);
    else
        return change(std::move(value));
}

template <typename V>
struct Form {
    std::string what;  ///< completes "is missing:" and "must be", or says itself what the value must be
    std::function<bool(const Json& value)> takes;                  ///< whether the value has the right JSON type
    std::function<V(const Json& value, const Where& where)> read;  ///< throws a Refusal
    std::function<Json(Json& definitions)> schema;                 ///< puts schemas that it needs into `definitions`

    /// Returns the form whose value is change(value) or change(value, where). The change may refuse the value; if
    /// the change returns nothing, the value stays. `also` is added to the schema.
    template <typename Change>
    auto then(Change change, const Json& also = Json::object()) const {
        using Changed = decltype(called(change, std::declval<V>(), std::declval<const Where&>()));
        using Next = std::conditional_t<std::is_void_v<Changed>, V, Changed>;
        const auto read_next = [read = read, change](const Json& value, const Where& where) -> Next {
            V found = where.whole([&] { return read(value, where); });
            if constexpr (std::is_void_v<Changed>) {
                called(change, found, where);
                return found;
            } else {
                return called(change, std::move(found), where);
            }
        };
        return Form<Next>{what, takes, read_next, [schema = schema, also](Json& definitions) {
                              Json all = schema(definitions);
                              all.update(also);
                              return all;
                          }};
    }
    /// Returns a form that reads alike but stops at the first mistake, because later mistakes may follow from it.
    Form strict() const {
        const auto read_strictly = [read = read](const Json& value, const Where& where) {
            return read(value, {where.prefix, where.path});
        };
        return {what, takes, read_strictly, schema};
    }
    /// Returns a form that reads alike; schemas define it once, under `name`, and refer to that definition.
    Form named(const char* name) const {
        return {what, takes, read, [schema = schema, name](Json& definitions) {
                    Json own = schema(definitions);
                    return defined(definitions, name, std::move(own));
                }};
    }
};

// ---- parts of schemas ----------------------------------------------------------------------------------------------

Json number_in(const Range& range);
Json whole_in(double min, double max);
Json one_of(std::span<const char* const> names);
Json name_schema();
Json object_of(Json properties);
/// Returns the schema of a list. `items` is one schema for all items, or an array of schemas for the first items; the
/// items after them are like the last one.
Json list_of(Json items, std::size_t most, std::size_t least = 0);
/// Returns the text of a file's schema. `content` returns the schema itself, and may add definitions.
std::string document(const char* title, const std::function<Json(Json& definitions)>& content);

// ---- plain values --------------------------------------------------------------------------------------------------

Form<std::string> name(const std::string& what = "a name");
/// Any text of at most `most_bytes` bytes.
Form<std::string> text(const std::string& what = "a string", std::size_t most_bytes = max_document_bytes);
Form<bool> boolean();
Form<double> number(const Range& range);
Form<int> whole(int min, int max);
Form<Color> color();
/// Three numbers [x, y, z].
Form<glm::dvec3> vec3(const Range& range, const std::string& what);
/// The number 1: the version of a file's format.
Form<int> version();
/// {PATH: VALUE, …}, read as a list of PATH=VALUE.
Form<std::vector<std::string>> settings();
Form<std::vector<int>> slides();
/// A value that is left unread: the form returns its address.
Form<const Json*> value(const std::string& what, const std::function<Json(Json& definitions)>& schema);

/// One of these names, read as an enumerator or an index.
template <typename Enum = int>
Form<Enum> choice(std::span<const char* const> names) {
    return {
        "one of " + joined(names), &Json::is_string,
        [names](const Json& value, const Where& where) { return static_cast<Enum>(read_choice(value, where, names)); },
        [names](Json&) { return one_of(names); }};
}

// ---- lists, and values of several kinds ----------------------------------------------------------------------------

/// How many items a list may have, and the message if it has fewer.
struct Count {
    std::size_t most, least = 0;
    const char* too_few = "must not be empty";  ///< nullptr: the message for too many
};

/// A list whose first items have forms of their own; those after them are like the last one.
template <typename V>
Form<std::vector<V>> list(const std::vector<Form<V>>& forms, const std::string& what, const Count& count) {
    const auto items = std::make_shared<const std::vector<Form<V>>>(forms);  // closures are copied often
    const auto read = [=](const Json& value, const Where& where) {
        require_array(value, where, count.most, what);
        if (value.size() < count.least && count.too_few) where.refuse(count.too_few);
        if (value.size() < count.least) refuse_value(value, where, what);
        std::vector<V> values;
        for (std::size_t i = 0; i < value.size(); ++i)
            where.part([&] { values.push_back((*items)[std::min(i, items->size() - 1)].read(value[i], where.at(i))); });
        return values;
    };
    const auto schema = [=](Json& definitions) {
        Json schemas = Json::array();
        for (const Form<V>& item : *items) schemas.push_back(item.schema(definitions));
        return list_of(std::move(schemas), count.most, count.least);
    };
    return {what, &Json::is_array, read, schema};
}

template <typename V>
Form<std::vector<V>> list(const Form<V>& item, const std::string& what, const Count& count) {
    return list(std::vector{item}, what, count);
}

/// A value that one of the forms takes: forms of different JSON types, or objects with different keys.
template <typename V>
Form<V> either(const std::string& what, const std::vector<Form<V>>& forms) {
    const auto all = std::make_shared<const std::vector<Form<V>>>(forms);
    const auto taker = [all](const Json& value) {
        return std::find_if(all->begin(), all->end(), [&](const Form<V>& one) { return one.takes(value); });
    };
    const auto read = [=](const Json& value, const Where& where) {
        const auto form = taker(value);
        if (form == all->end()) refuse_value(value, where, what);
        return form->read(value, where);
    };
    return {what, [=](const Json& value) { return taker(value) != all->end(); }, read,
            [=](Json& definitions) {
                Json schemas = Json::array();
                for (const Form<V>& form : *all) schemas.push_back(form.schema(definitions));
                return Json{{"anyOf", std::move(schemas)}};
            }};
}

// ---- objects -------------------------------------------------------------------------------------------------------

/// The keys of an object, and the rules about them.
class Keys {
public:
    explicit Keys(std::string what) : kind(std::move(what)) {}
    /// Returns the schema.
    Json operator()(Json& definitions) const;

    using Keyed = std::vector<const char*>;
    struct Rule {
        std::function<void(const Json& object, const Where& where)> check;
        Json schema;
    };

protected:
    bool knows(const std::string& key) const;
    struct Key {
        std::string name, what;
        bool is_needed;
        std::function<Json(Json& definitions)> schema;
    };
    void check(const Json& object, const Where& where) const;
    /// Returns the member's value, or nullptr if it is missing. Refuses an object without a key that it needs.
    static const Json* found(const Json& object, const Key& key, const Where& where);
    static Rule one_of_keys(const Keyed& keys, bool is_needed);
    static Rule needed_by(const char* key, const char* needed);

    std::string kind;  ///< completes "must be"
    std::vector<Key> members;
    std::vector<Rule> all_rules;
};

/// An object that is read into a T, member by member in the order in which they are added. `into` is a pointer to a
/// member of T, a function that returns a reference to where the value goes, or a function that takes the value and
/// perhaps its place.
template <typename T>
class Object : public Keys {
public:
    explicit Object(const std::string& what = "an object") : Keys(what) {}
    template <typename V, typename Into>
    Object& add(const char* key, const Form<V>& form, Into into, bool is_needed) {
        members.push_back({key, form.what, is_needed, form.schema});
        readers_.push_back([read = form.read, into](const Json& value, const Where& where, T& object) {
            if constexpr (std::is_invocable_v<Into, T&, V, const Where&>)
                into(object, read(value, where), where);
            else if constexpr (std::is_invocable_v<Into, T&, V>)
                into(object, read(value, where));
            else
                std::invoke(into, object) = read(value, where);
        });
        return *this;
    }
    template <typename V, typename Into>
    Object& required(const char* key, const Form<V>& form, Into into) {
        return add(key, form, into, true);
    }
    template <typename V, typename Into>
    Object& optional(const char* key, const Form<V>& form, Into into) {
        return add(key, form, into, false);
    }
    /// A member that is only checked.
    template <typename V>
    Object& checked(const char* key, const Form<V>& form, bool is_needed = false) {
        return add(
            key, form, [](T&, const V&) {}, is_needed);
    }
    /// An object whose members are read into the same T.
    Object& nested(const char* key, const Object& part, bool is_needed) {
        const auto read = [shared = part.shared()](T& object, const Json* value, const Where& where) {
            shared->read_into(object, *value, where);
        };
        return add(key, part.unread(), read, is_needed);
    }
    /// A list of objects that are read into the same T, one after another; next(T&) is called before each.
    template <typename Next>
    Object& each(const char* key, const Object& item, const std::string& what, const Count& count, Next next) {
        const auto read = [next, shared = item.shared()](T& object, const std::vector<const Json*>& values,
                                                         const Where& where) {
            for (std::size_t i = 0; i < values.size(); ++i)
                where.part([&] {
                    next(object);
                    shared->read_into(object, *values[i], {where.at(i).prefix, where.at(i).path});
                });
        };
        return optional(key, list(item.unread(), what, count), read);
    }
    /// The version of the file's format. `key` also identifies the format; the file may contain "$schema" too.
    Object& version(const char* key) { return ignored({"$schema"}).checked(key, form::version(), true); }
    /// Members that only another kind of this object uses: they are allowed here, but not read.
    Object& ignored(const Keyed& keys) {
        for (const char* const key : keys)
            if (!knows(key)) checked(key, value("", [](Json&) { return Json(true); }));
        return *this;
    }
    Object& refused(const char* key, const char* why) {
        const auto read = [why](const Json&, const Where& where) -> bool { where.refuse(why); };
        return knows(key) ? *this : checked(key, Form<bool>{"", {}, read, [](Json&) { return Json(false); }});
    }
    /// All members of another object. They are read into a part of T: into(T&) returns a reference to that part.
    template <typename U, typename Into>
    Object& with(const Object<U>& part, Into into) {
        members.insert(members.end(), part.members.begin(), part.members.end());
        all_rules.insert(all_rules.end(), part.all_rules.begin(), part.all_rules.end());
        for (const auto& reader : part.readers_)
            readers_.push_back([reader, into](const Json& value, const Where& where, T& object) {
                reader(value, where, std::invoke(into, object));
            });
        return *this;
    }
    Object& at_most_one(const Keyed& keys) { return rule(one_of_keys(keys, false)); }
    Object& exactly_one(const Keyed& keys) { return rule(one_of_keys(keys, true)); }
    Object& rule(Rule rule) {
        all_rules.push_back(std::move(rule));
        return *this;
    }
    /// The keys are allowed only together with `needed`.
    Object& need(const Keyed& keys, const char* needed) {
        for (const char* const key : keys) all_rules.push_back(needed_by(key, needed));
        return *this;
    }

    /// Checks the keys and reads the members. Members of `object` whose keys are missing keep their values.
    void read_into(T& object, const Json& value, const Where& where) const {
        check(value, where);
        read_members(object, value, where);
    }
    /// Reads the members, but checks neither the rules nor whether there are unknown keys.
    void read_members(T& object, const Json& value, const Where& where) const {
        for (std::size_t i = 0; i < members.size(); ++i)
            where.part([&] {
                const Json* const member = found(value, members[i], where);
                if (member) readers_[i](*member, where.key(members[i].name), object);
            });
    }
    /// Reads the members, and removes them from the value.
    void take_members(T& object, Json& value, const Where& where) const {
        read_members(object, value, where);
        for (const Key& key : members) value.erase(key.name);
    }
    T read(const Json& value, const Where& where, T object = {}) const {
        read_into(object, value, where);
        return object;
    }

    /// Returns the form of the object. Reading begins with start(), or with T{} if there is no `start`. Unless `key` is
    /// empty, the form takes only objects that contain it.
    Form<T> form(const std::function<T()>& start = {}, const std::string& key = "") const {
        const auto read = [start, self = shared()](const Json& value, const Where& where) {
            return self->read(value, where, start ? start() : T{});
        };
        return {kind, [=](const Json& value) { return value.is_object() && (key.empty() || value.contains(key)); },
                read, unread().schema};
    }

private:
    template <typename>
    friend class Object;
    using Reader = std::function<void(const Json& value, const Where& where, T& object)>;

    std::shared_ptr<const Object> shared() const { return std::make_shared<const Object>(*this); }
    Form<const Json*> unread() const {
        return value(kind, [self = shared()](Json& definitions) { return (*self)(definitions); });
    }

    std::vector<Reader> readers_;
};

}  // namespace viewing::form

namespace viewing {

form::Object<SceneDescription> scene_form();
const form::Object<Titles>& titles_form();

}  // namespace viewing
