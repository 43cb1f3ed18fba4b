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

const form::Object<Titles>& titles_form() {
    static const form::Object<Titles> titles = form::Object<Titles>()
                                                   .optional("$schema", form::text(), &Titles::schema)
                                                   .optional("title", form::text(), &Titles::title)
                                                   .optional("about", form::text(), &Titles::about)
                                                   .optional("group", form::text(), &Titles::group)
                                                   .optional("mended_by", form::text(), &Titles::fixed_by)
                                                   .optional("slides", form::slides(), &Titles::slides);
    return titles;
}

Titles take_titles(Json& document, const Where& where) {
    Titles titles;
    if (document.is_object()) titles_form().take_members(titles, document, where);
    return titles;
}

}  // namespace viewing
