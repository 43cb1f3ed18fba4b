// Checks values of a state that depend on each other. Read reader.cpp first.
#include <cmath>

#include "state/file/reader.h"
#include "text/numbers.h"

namespace viewing {

namespace {

void check_light(const glm::dvec4& position, const Where& where) {
    if (glm::length(position) < min_length) {
        where.refuse("must not be zero: a point light has w = 1, a parallel light a direction");
    }
}

/// Returns where an element of a list is in the file: "light" for the first one, then "lights[0]".
Where element(const Where& root, const std::string& group, std::size_t index) {
    return index == 0 ? root.key(group) : root.key(group + "s").at(index - 1);
}

void check_chosen(int number, std::size_t count, const Where& where) {
    if (number > static_cast<int>(count)) {
        const std::string allowed =
            (count == 1 ? "1" : "from 1 to " + std::to_string(count)) + ": the state has only " + std::to_string(count);
        where.refuse("must be " + allowed + ", got " + std::to_string(number));
    }
}

/// Refuses matrices for planes and lights that do not exist.
void check_overrides(const Params& params, const Where& where) {
    for (std::size_t plane = 0; plane < most_planes; ++plane) {
        const PlaneOverrides& overrides = params.overrides[plane];
        bool is_used = overrides.mirrored_world_from_world.has_value();
        for (std::size_t light = 0; light < most_lights; ++light) {
            const bool has_shadow = overrides.shadowed_world_from_world[light].has_value();
            if (has_shadow && light >= params.lights.size()) {
                where.refuse("there is no light " + std::to_string(light + 1));
            }
            is_used = is_used || has_shadow;
        }
        if (is_used && plane >= params.planes.size()) {
            where.refuse("there is no plane " + std::to_string(plane + 1));
        }
    }
}

/// Refuses a window without width or height, or one whose edges are swapped.
void check_edges(const Params& params, const char* low_path, double low, const char* high_path, double high,
                 const Where& root) {
    if (!params.projection.has_window() || high - low >= least_window(low, high)) return;
    root.key(low_path).refuse("must be less than " + std::string(high_path) + " (" + format_number(high) + "), got " +
                              format_number(low));
}

void check_plane(const glm::dvec4& equation, const Where& where) {
    if (glm::length(glm::dvec3(equation)) < min_length) {
        where.refuse("the normal (a, b, c) must not be zero");
    }
}

}  // namespace

void check_together(const Params& params, const std::string& prefix) {
    const Where root{prefix, ""};
    const auto [near, far] = std::pair(params.projection.near, params.projection.far);
    if (near < least_near(params)) {
        root.key("projection.near")
            .refuse("must be a number " + range_text({least_near(params), field("projection.near").max}) +
                    ", got the number " + format_number(near) +
                    "; it may be 0 or negative only in an orthographic projection without logarithmic depth");
    }
    if (std::isinf(far) && !may_have_infinite_far(params))
        root.key("projection.far")
            .refuse("must be a number " + range_text({field("projection.far").min, field("projection.far").max}) +
                    "; it may be infinite only in a perspective or a frustum without logarithmic depth");
    if (near >= far) {
        root.key("projection.near")
            .refuse("must be less than projection.far (" + format_number(far) + "), got " + format_number(near));
    }
    const Edges window = params.projection.window();
    check_edges(params, "projection.left", window.left, "projection.right", window.right, root);
    check_edges(params, "projection.bottom", window.bottom, "projection.top", window.top, root);
    for (std::size_t i = 0; i < params.lights.size(); ++i) {
        check_light(params.lights[i].position, element(root, "light", i).key("position"));
    }
    for (std::size_t i = 0; i < params.planes.size(); ++i) {
        check_plane(params.planes[i].equation, element(root, "plane", i).key("equation"));
    }
    check_chosen(params.view.plane, params.planes.size(), root.key("view.plane"));
    check_chosen(params.view.light, params.lights.size(), root.key("view.light"));
    check_overrides(params, root.key("overrides.further"));
}

}  // namespace viewing
