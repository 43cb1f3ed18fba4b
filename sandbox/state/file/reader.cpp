// Reads groups and whole states from a JSON tree, as defined by the list of fields. kinds.cpp reads a field's value;
// writer.cpp does the reverse.
#include "state/file/reader.h"

#include <algorithm>

#include "state/file/form.h"
#include "text/words.h"

namespace viewing {

namespace {

std::string_view last_of(std::string_view path) {
    return path.substr(path.rfind('.') + 1);
}

}  // namespace

bool is_group(std::string_view path) {
    return std::any_of(fields().begin(), fields().end(), [path](const Field& field) {
        return field.path.size() > path.size() && is_in(field.path, path);
    });
}

void read_group(Params& params, const Json& object, const Where& where) {
    require_object(object, where, "an object");
    if (where.path == "camera") require_one_camera(object, where);
    for (const auto& [key, value] : object.items()) {
        const Where inside = where.key(key);
        if (key.empty() || key.find('.') != std::string::npos) {
            inside.refuse("no such field: a key is a single name, and a group is a nested object");
        }
        if (const Field* known = find_field(inside.path)) {
            read_field(*known, params, value, inside);
        } else if (inside.path == look_at_path) {
            params.camera.look(read_look_at(value, inside));
        } else if (is_group(inside.path)) {
            read_group(params, value, inside);
        } else {
            refuse_unknown(inside);
        }
    }
}

void refuse_unknown(const Where& where) {
    std::vector<std::string> known = known_paths();
    for (const char* part : {"", ".eye", ".center", ".up"}) known.push_back(std::string(look_at_path) + part);
    const std::string_view word = last_of(where.path);
    // Handles both a typo anywhere in the path and a correct name in the wrong group.
    const auto distance = [&](const std::string& path) {
        return std::min(edit_distance(where.path, path), edit_distance(word, last_of(path)) + 1);
    };
    const auto nearest = std::min_element(known.begin(), known.end(), [&](const std::string& a, const std::string& b) {
        return distance(a) < distance(b);
    });
    if (is_near(distance(*nearest), word.size())) {
        where.refuse("no such field; did you mean " + *nearest + "?");
    }
    const std::string_view group = is_group(group_of(where.path)) ? group_of(where.path) : "";
    std::string all;
    for (const std::string& path : known) {
        if (group_of(path) == group) {
            all += (all.empty() ? "" : ", ") + std::string(last_of(path));
        }
    }
    where.refuse("no such field; " + (group.empty() ? "the fields are " : std::string(group) + " has ") + all);
}

std::vector<int> read_slides(const Json& object, const Where& where) {
    return object.contains("slides") ? form::slides().read(object["slides"], where.key("slides")) : std::vector<int>();
}

Titles take_titles(Json& document, const Where& where) {
    Titles titles;
    if (!document.is_object()) {
        return titles;
    }
    const auto take = [&](const char* key, std::string& text) {
        if (!document.contains(key)) {
            return;
        }
        if (!document[key].is_string()) {
            refuse_value(document[key], where.key(key), "a string");
        }
        text = document[key].get<std::string>();
        document.erase(key);
    };
    take("$schema", titles.schema);
    take("title", titles.title);
    take("about", titles.about);
    take("group", titles.group);
    take("mended_by", titles.fixed_by);
    titles.slides = read_slides(document, where);
    document.erase("slides");
    return titles;
}

}  // namespace viewing
