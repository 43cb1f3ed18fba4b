// Random states within the ranges of the list of fields, for round-trip tests.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>

#include "state/fields.h"

namespace viewing::testing {

class RandomParams {
public:
    explicit RandomParams(unsigned seed) : random_(seed) {}

    Params make() {
        Params params;
        params.lights.resize(static_cast<std::size_t>(whole(1, most_lights)));
        params.planes.resize(static_cast<std::size_t>(whole(1, most_planes)));
        for (const Field& field : fields()) {
            for (std::size_t element = 0; element < element_count(field, params); ++element) {
                fill(field, params, element);
            }
        }
        params.view.plane = whole(1, static_cast<int>(params.planes.size()));
        params.view.light = whole(1, static_cast<int>(params.lights.size()));
        if (params.projection.near >= params.projection.far || params.projection.near < least_near(params)) {
            params.projection.near = std::min(params.projection.far / 3.0, 1e6);
        }
        ProjectionParams& projection = params.projection;
        if (may_have_infinite_far(params) && coin()) projection.far = std::numeric_limits<double>::infinity();
        for (auto [low, high] : {std::pair(&projection.left, &projection.right), {&projection.bottom, &projection.top}})
            if (*low > *high) std::swap(*low, *high);
        if (projection.left == projection.right || projection.bottom == projection.top) projection.set_window({});
        return params;
    }

private:
    double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
    int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
    bool coin() { return whole(0, 1) == 1; }

    double number(const Field& field, int component) {
        const Range range = component_range(field, component);
        const double value = field.logarithmic && range.min > 0.0
                                 ? std::exp(uniform(std::log(range.min), std::log(range.max)))
                                 : uniform(range.min, range.max);
        // Include round numbers and the ends of the range.
        const int kind = whole(0, 9);
        return std::clamp(kind == 0   ? range.min
                          : kind == 1 ? range.max
                          : kind < 5  ? std::round(value) + 0.0  // a link writes −0 as 0
                                      : value,
                          range.min, range.max);
    }

    template <typename Vector>
    Vector vector(const Field& field) {
        Vector result;
        for (int i = 0; i < Vector::length(); ++i) {
            result[i] = number(field, i);
        }
        return result;
    }

    ObjectDescription object(int index) {
        ObjectDescription made;
        made.name = "object \"" + std::to_string(index) + "\" äß – 그림자";
        made.shape = static_cast<ShapeKind>(whole(0, static_cast<int>(names_of<ShapeKind>().size()) - 1));
        made.position = {uniform(-10, 10), uniform(-1e6, 1e6), 0.1};
        made.rotation = {uniform(-3600, 3600), uniform(-90, 90), 0.0};
        made.scale = {uniform(0.1, 2), -uniform(0.1, 2), 1e-6};
        made.color = {static_cast<std::uint8_t>(whole(0, 255)), static_cast<std::uint8_t>(whole(0, 255)), 7};
        made.decal = coin();
        if (made.shape == ShapeKind::triangle) {
            made.vertices = {glm::dvec3(0, uniform(0, 1), 0), glm::dvec3(uniform(2, 3), 0, 0), glm::dvec3(0, 0, 4)};
        } else if (made.shape == ShapeKind::mesh) {
            made.file = "folder/bunny \\ 2.obj";
            made.reading = {uniform(0, 180), coin()};
        } else if (made.shape == ShapeKind::teapot) {
            made.resolution = whole(1, 64);
        }
        return made;
    }

    void fill(const Field& field, Params& params, std::size_t element) {
        const FieldRef ref = field.in(params, element);
        if (const auto* value = std::get_if<bool*>(&ref)) {
            **value = coin();
        } else if (const auto* value_int = std::get_if<int*>(&ref)) {
            **value_int = field.path == "view.samples"
                              ? 4 * whole(0, 1)
                              : whole(static_cast<int>(field.min), static_cast<int>(field.max));
        } else if (const auto* value_double = std::get_if<double*>(&ref)) {
            **value_double = number(field, 0);
            if (**value_double < field.least_above_zero) **value_double = 0.0;
        } else if (const auto* vec3 = std::get_if<glm::dvec3*>(&ref)) {
            **vec3 = vector<glm::dvec3>(field);
        } else if (const auto* vec4 = std::get_if<glm::dvec4*>(&ref)) {
            **vec4 = vector<glm::dvec4>(field);
        } else if (const auto* color = std::get_if<Color*>(&ref)) {
            **color = {static_cast<std::uint8_t>(whole(0, 255)), static_cast<std::uint8_t>(whole(0, 255)),
                       static_cast<std::uint8_t>(whole(0, 255))};
        } else if (const auto* choice = std::get_if<EnumRef>(&ref)) {
            choice->set(whole(0, static_cast<int>(choice->names.size()) - 1));
        } else if (const auto* scene = std::get_if<SceneSource*>(&ref)) {
            fill_scene(**scene);
        } else if (const auto* matrix = std::get_if<std::optional<glm::dmat4>*>(&ref)) {
            fill_matrix(**matrix);
        } else if (std::holds_alternative<FurtherOverrides>(ref)) {
            for (std::size_t plane = 0; plane < params.planes.size(); ++plane) {
                if (plane > 0) {
                    fill_matrix(params.overrides[plane].mirrored_world_from_world);
                }
                for (std::size_t light = plane > 0 ? 0 : 1; light < params.lights.size(); ++light) {
                    fill_matrix(params.overrides[plane].shadowed_world_from_world[light]);
                }
            }
        } else if (const auto* follow = std::get_if<std::optional<Follow>*>(&ref)) {
            (*follow)->reset();
            if (coin()) {
                **follow = Follow{"box", whole(0, 1'000'000)};
                if (coin()) **follow = Follow{.object = "", .point = vector<glm::dvec3>(field)};
            }
        } else if (const auto* span = std::get_if<std::optional<glm::dvec2>*>(&ref)) {
            (*span)->reset();
            if (coin()) {
                const double nearest = uniform(0.01, 1.0);
                **span = glm::dvec2(nearest, nearest + uniform(0.01, 1e6));
            }
        } else if (const auto* pixel = std::get_if<std::optional<glm::ivec2>*>(&ref)) {
            (*pixel)->reset();
            if (coin()) {
                const int least = static_cast<int>(field.min), most = static_cast<int>(field.max);
                **pixel = glm::ivec2(whole(least, most), whole(least, most));
            }
        } else if (const auto* pin = std::get_if<std::optional<Pin>*>(&ref)) {
            (*pin)->reset();
            const glm::dvec2 at(uniform(0.0, 1.0), uniform(0.0, 1.0));
            const Pin kinds[] = {{"box \"1\"", {}}, {"box", at}, {"", at}};
            if (coin()) **pin = kinds[whole(0, 2)];
        } else if (const auto* names = std::get_if<std::vector<std::string>*>(&ref)) {
            **names = allowed_names(field);
            std::shuffle((*names)->begin(), (*names)->end(), random_);
            (*names)->resize(static_cast<std::size_t>(whole(0, static_cast<int>((*names)->size()))));
        } else if (const auto* settings = std::get_if<Settings*>(&ref)) {
            (*settings)->all = {"projection.near=" + std::to_string(whole(1, 9)), "depth.func=\"always\"",
                                "camera.look_at={\"eye\":[1,2,3],\"center\":[0,0,0]}"};
            (*settings)->all.resize(static_cast<std::size_t>(whole(0, 3)));
        }
    }

    void fill_matrix(std::optional<glm::dmat4>& matrix) {
        matrix.reset();
        if (coin()) {
            const Field& entries = viewing::field("overrides.shadow_from_world");
            matrix = glm::dmat4(vector<glm::dvec4>(entries), vector<glm::dvec4>(entries), vector<glm::dvec4>(entries),
                                vector<glm::dvec4>(entries));
        }
    }

    void fill_scene(SceneSource& scene) {
        if (coin()) {
            scene = std::string("a scene/with \"quotes\".json");
            return;
        }
        SceneDescription made;
        for (int i = whole(0, 4); i > 0; --i) {
            made.objects.push_back(object(i));
        }
        scene = made;
    }

    std::mt19937 random_;
};

}  // namespace viewing::testing
