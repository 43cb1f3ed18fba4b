// The kinds of matrices that a person enters by hand: those of the first plane and light, and the others.
#pragma once

#include "state/kinds/vector_kinds.h"

namespace viewing::kinds {

inline Form<std::optional<glm::dmat4>> matrix(const Field& field) {
    const Range range = component_range(field, 0);
    const Json row = form::list_of(form::number_in(range), 4, 4);
    return or_null<glm::dmat4>(
        {"null or 4 rows of 4 numbers, " + each_in_range(field),
         {},
         [range](const Json& value, const Where& where) { return read_matrix(value, where, range); },
         [row](Json&) { return form::list_of(row, 4, 4); }});
}

inline void fix_matrix(std::optional<glm::dmat4>& matrix, const Field& field) {
    for (int column = 0; matrix && column < 4; ++column) fix_vector((*matrix)[column], glm::dvec4(0.0), field);
}

template <>
struct Kind<std::optional<glm::dmat4>*> : NumericKind {
    static constexpr std::string_view type = "matrix";
    static Form<std::optional<glm::dmat4>> form(const Field& field) { return matrix(field); }
    static Json write(const std::optional<glm::dmat4>* value) { return written(*value, matrix_as_json); }
    static void clamp(std::optional<glm::dmat4>* value, const std::optional<glm::dmat4>*, const Field& field) {
        fix_matrix(*value, field);
    }
};

template <>
struct Kind<FurtherOverrides> : AnyKind {
    using All = std::array<PlaneOverrides, most_planes>;
    static constexpr std::string_view type = "matrices";
    static Form<All> form(const Field& field) {
        const std::string what =
            "an array of {\"plane\", \"light\": whole numbers from 1, \"shadow_from_world\", \"mirror_from_world\": "
            "null or 4 rows of 4 numbers}";
        constexpr std::size_t most = most_planes * most_lights;
        const auto read = [=](const Json& value, const Where& where) {
            require_array(value, where, most, what);
            All all;
            for (std::size_t i = 0; i < value.size(); ++i) read_one(all, value[i], field, what, where.at(i));
            return all;
        };
        const Form<std::optional<glm::dmat4>> entry = matrix(field);
        const auto schema = [entry](Json& definitions) {
            return form::list_of(form::object_of({{"plane", form::whole_in(1, most_planes)},
                                                  {"light", form::whole_in(1, most_lights)},
                                                  {"shadow_from_world", entry.schema(definitions)},
                                                  {"mirror_from_world", entry.schema(definitions)}}),
                                 most);
        };
        return {what, {}, read, schema};
    }
    /// Leaves the first R and S unchanged, since they have their own fields.
    static void assign(const FurtherOverrides& to, All all) {
        all[0].mirrored_world_from_world = (*to.all)[0].mirrored_world_from_world;
        all[0].shadowed_world_from_world[0] = (*to.all)[0].shadowed_world_from_world[0];
        *to.all = all;
    }
    static Json write(const FurtherOverrides& overrides) {
        Json array = Json::array();
        for (std::size_t plane = 0; plane < most_planes; ++plane) {
            PlaneOverrides& of_plane = (*overrides.all)[plane];
            for (std::size_t light = 0; light < most_lights; ++light) {
                std::optional<glm::dmat4> shadow, mirror;
                if (plane > 0 || light > 0) shadow = of_plane.shadowed_world_from_world[light];
                if (plane > 0 && light == 0) mirror = of_plane.mirrored_world_from_world;
                if (shadow || mirror)
                    array.push_back({{"plane", plane + 1},
                                     {"light", light + 1},
                                     {"shadow_from_world", written(shadow, matrix_as_json)},
                                     {"mirror_from_world", written(mirror, matrix_as_json)}});
            }
        }
        return array;
    }
    static void clamp(const FurtherOverrides& value, const FurtherOverrides&, const Field& field) {
        for (PlaneOverrides& of_plane : *value.all) {
            fix_matrix(of_plane.mirrored_world_from_world, field);
            for (std::optional<glm::dmat4>& shadow : of_plane.shadowed_world_from_world) fix_matrix(shadow, field);
        }
    }

private:
    static void read_one(All& all, const Json& object, const Field& field, const std::string& must_be,
                         const Where& where) {
        static const std::vector<std::string> keys = {"plane", "light", "shadow_from_world", "mirror_from_world"};
        require_object(object, where, must_be);
        for (const auto& [key, value] : object.items()) require_known_key(key, where, keys);
        const auto index_of = [&](const char* key, std::size_t most) {
            const int number =
                object.contains(key) ? read_whole(object[key], where.key(key), 1, static_cast<int>(most)) : 1;
            return static_cast<std::size_t>(number - 1);
        };
        const std::size_t plane = index_of("plane", most_planes), light = index_of("light", most_lights);
        const auto read = [&](const char* key, std::optional<glm::dmat4>& to, bool has_own_field) {
            if (!object.contains(key) || object[key].is_null()) return;
            const Where inside = where.key(key);
            if (has_own_field) inside.refuse("for the first one, use overrides." + std::string(key));
            if (to) inside.refuse("is given twice for that plane and light");
            to = matrix(field).read(object[key], inside);
        };
        read("shadow_from_world", all[plane].shadowed_world_from_world[light], plane == 0 && light == 0);
        read("mirror_from_world", all[plane].mirrored_world_from_world, plane == 0);
    }
};

}  // namespace viewing::kinds
