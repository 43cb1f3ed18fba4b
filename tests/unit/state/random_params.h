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
        params.lights.resize(lights_ = static_cast<std::size_t>(whole(1, most_lights)));
        params.planes.resize(planes_ = static_cast<std::size_t>(whole(1, most_planes)));
        for (const Field& field : fields()) {
            for (std::size_t element = 0; element < element_count(field, params); ++element) {
                std::visit([&](const auto& value) { fill(field, value); }, field.in(params, element));
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
                          : kind < 5  ? std::round(value) + 0.0  // turns −0 into 0, as a link does
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

    // One overload for each kind of field.
    void fill(const Field&, bool* value) { *value = coin(); }
    void fill(const Field& field, int* value) {
        *value = field.only.empty()
                     ? whole(static_cast<int>(field.min), static_cast<int>(field.max))
                     : field.only[static_cast<std::size_t>(whole(0, static_cast<int>(field.only.size()) - 1))];
    }
    void fill(const Field& field, double* value) {
        *value = number(field, 0);
        if (*value < field.least_above_zero) *value = 0.0;
    }
    void fill(const Field& field, glm::dvec3* value) { *value = vector<glm::dvec3>(field); }
    void fill(const Field& field, glm::dvec4* value) { *value = vector<glm::dvec4>(field); }
    void fill(const Field&, Color* value) {
        const auto part = [this] { return static_cast<std::uint8_t>(whole(0, 255)); };
        *value = {part(), part(), part()};
    }
    void fill(const Field&, const EnumRef& value) { value.set(whole(0, static_cast<int>(value.names.size()) - 1)); }
    void fill(const Field&, SceneSource* value) { fill_scene(*value); }
    template <typename Element>
    void fill(const Field&, const Further<Element>&) {}  // filled field by field
    void fill(const Field&, std::optional<glm::dmat4>* value) { fill_matrix(*value); }
    void fill(const Field&, const FurtherOverrides& value) {
        for (std::size_t plane = 0; plane < planes_; ++plane) {
            PlaneOverrides& overrides = (*value.all)[plane];
            if (plane > 0) fill_matrix(overrides.mirrored_world_from_world);
            for (std::size_t light = plane > 0 ? 0 : 1; light < lights_; ++light)
                fill_matrix(overrides.shadowed_world_from_world[light]);
        }
    }
    void fill(const Field& field, std::optional<Follow>* value) {
        value->reset();
        if (!coin()) return;
        *value = Follow{"box", whole(0, 1'000'000)};
        if (coin()) *value = Follow{.object = "", .point = vector<glm::dvec3>(field)};
    }
    void fill(const Field&, std::optional<glm::dvec2>* value) {
        value->reset();
        if (!coin()) return;
        const double nearest = uniform(0.01, 1.0);
        *value = glm::dvec2(nearest, nearest + uniform(0.01, 1e6));
    }
    void fill(const Field& field, std::optional<glm::ivec2>* value) {
        value->reset();
        const int least = static_cast<int>(field.min), most = static_cast<int>(field.max);
        if (coin()) *value = glm::ivec2(whole(least, most), whole(least, most));
    }
    void fill(const Field&, std::optional<Pin>* value) {
        value->reset();
        const glm::dvec2 at(uniform(0.0, 1.0), uniform(0.0, 1.0));
        const Pin kinds[] = {{"box \"1\"", {}}, {"box", at}, {"", at}};
        if (coin()) *value = kinds[whole(0, 2)];
    }
    void fill(const Field& field, std::vector<std::string>* value) {
        *value = allowed_names(field);
        std::shuffle(value->begin(), value->end(), random_);
        value->resize(static_cast<std::size_t>(whole(0, static_cast<int>(value->size()))));
    }
    void fill(const Field&, Settings* value) {
        value->all = {"projection.near=" + std::to_string(whole(1, 9)), "depth.func=\"always\"",
                      "camera.look_at={\"eye\":[1,2,3],\"center\":[0,0,0]}"};
        value->all.resize(static_cast<std::size_t>(whole(0, 3)));
    }

    void fill_matrix(std::optional<glm::dmat4>& matrix) {
        matrix.reset();
        if (coin()) {
            const Field entries;  // the widest range
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
    std::size_t lights_ = 1, planes_ = 1;  ///< the numbers of lights and planes of the state being made
};

}  // namespace viewing::testing
