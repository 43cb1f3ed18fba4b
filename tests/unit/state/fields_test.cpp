// Checks the list of fields against the golden list, tests/fields.txt.
#include "state/fields.h"

#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <sstream>

#include "listed_fields.h"
#include "random_params.h"
#include "state/file/state_json.h"

namespace viewing {
namespace {

/// Returns the lines of `params --format text` that describe the fields, without the help and formula below each.
std::vector<std::string> descriptions() {
    std::istringstream text(params_as_text());
    std::vector<std::string> lines;
    for (std::string line; std::getline(text, line);)
        if (!line.starts_with(' ')) lines.push_back(std::regex_replace(line, std::regex(" +"), " "));
    return lines;
}

TEST(Fields, MatchTheGoldenListInOrder) {
    const std::vector<std::string> lines = descriptions();
    const std::vector<testing::ListedField> listed = testing::listed_fields();
    EXPECT_EQ(lines.size(), fields().size());
    for (std::size_t i = 0; i < std::max(lines.size(), listed.size()); ++i) {
        const std::string line = i < lines.size() ? lines[i] : "",
                          golden = i < listed.size() ? listed[i].description : "";
        ASSERT_EQ(line, golden) << "if the change is intended, change tests/fields.txt";
    }
}

TEST(Fields, NamesMatchTheirEnumerators) {
    EXPECT_EQ(name_of(CompareFunc::always), "always");
    EXPECT_EQ(name_of(DepthFormat::d32f), "d32f");
    EXPECT_EQ(name_of(CullFace::front_and_back), "front_and_back");
    EXPECT_EQ(name_of(VisibilityMethod::ray_cast), "ray_cast");
    EXPECT_EQ(name_of(BspSplitter::balanced), "balanced");
    EXPECT_EQ(name_of(DepthMapping::logarithmic), "logarithmic");
    EXPECT_EQ(name_of(Shows::overdraw), "overdraw");
    EXPECT_EQ(name_of(ShapeKind::mesh), "mesh");
    EXPECT_EQ(name_of(ShapeKind::torus), "torus");
}

TEST(Fields, EachPathReachesItsOwnMember) {
    Params params;
    std::set<const void*> addresses;
    for (const Field& field : fields()) {
        const FieldRef ref = field.in(params);
        const void* address = std::visit(
            [](auto value) -> const void* {
                if constexpr (std::is_same_v<decltype(value), EnumRef>) {
                    return value.value;
                } else if constexpr (requires { value.all; }) {
                    return value.all;
                } else {
                    return value;
                }
            },
            ref);
        const bool stands_in_a_list = field.path.starts_with("light.") || field.path.starts_with("plane.");
        const bool is_new = addresses.insert(address).second;
        EXPECT_TRUE(is_new || field.path == "overrides.further")
            << field.path << " reaches the same member as another field";
        if (stands_in_a_list) {
            continue;
        }
        EXPECT_GE(static_cast<const char*>(address), reinterpret_cast<const char*>(&params)) << field.path;
        EXPECT_LT(static_cast<const char*>(address), reinterpret_cast<const char*>(&params + 1)) << field.path;
    }
}

// Copies every field of a random state one by one. A member that the list cannot reach would keep its default value.
TEST(Fields, CoverAllOfParams) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Params random = testing::RandomParams(seed).make();
        Params copy;
        copy.lights.resize(random.lights.size());
        copy.planes.resize(random.planes.size());
        const auto copy_field = [&](const Field& field, std::size_t element) {
            const FieldRef to = field.in(copy, element);
            const FieldRef from = field.in(random, element);
            ASSERT_EQ(to.index(), from.index());
            std::visit(
                [&](auto target) {
                    const auto source = std::get<decltype(target)>(from);
                    if constexpr (std::is_same_v<decltype(target), EnumRef>) {
                        target.set(source.index());
                    } else if constexpr (std::is_same_v<decltype(target), FurtherOverrides>) {
                        *target.all = *source.all;
                    } else if constexpr (requires { *target; }) {
                        *target = *source;
                    }
                },
                to);
        };
        for (const Field& field : fields()) {
            for (std::size_t element = 0; element < element_count(field, random); ++element) {
                copy_field(field, element);
            }
        }
        EXPECT_EQ(copy, random);
    }
}

TEST(Fields, DefaultsAreWithinTheRanges) {
    Params params;
    Params clamped = params;
    clamp_to_ranges(clamped);
    EXPECT_EQ(clamped, params);
}

TEST(Fields, AreDescribed) {
    for (const Field& field : fields()) {
        EXPECT_FALSE(field.label.empty()) << field.path;
        EXPECT_GT(field.help.size(), 20U) << field.path;
        EXPECT_TRUE(field.help.ends_with(".")) << field.path;
        EXPECT_LE(field.min, field.max) << field.path;
        EXPECT_GT(field.step, 0.0) << field.path;
        EXPECT_GE(field.min, -1e12) << field.path;
        EXPECT_LE(field.max, 1e12) << field.path;
        EXPECT_FALSE(allowed_text(field).empty()) << field.path;
        if (field.logarithmic && field.path != "projection.near") {  // may be negative in orthographic projections
            EXPECT_GT(field.min, 0.0) << field.path;
        }
    }
    EXPECT_EQ(field("projection.near").label, "z-near");
    EXPECT_EQ(field("projection.far").label, "z-far");
    EXPECT_EQ(field("depth.test").gl_call, "glEnable(GL_DEPTH_TEST)");
    EXPECT_EQ(field("cull.enabled").gl_call, "glEnable(GL_CULL_FACE)");
    EXPECT_EQ(field("depth.func").gl_call, "glDepthFunc");
    EXPECT_EQ(find_field("projection.naer"), nullptr);
}

TEST(Fields, RangesIncludeTheValuesOfTheLecture) {
    EXPECT_LE(field("projection.near").min, 0.001);
    EXPECT_GE(field("projection.far").max, 1e9);
    EXPECT_EQ(field("projection.fovy").min, 1.0);
    EXPECT_EQ(field("projection.fovy").max, 179.0);
    EXPECT_EQ(component_range(field("light.position"), 3).min, 0.0);
    EXPECT_EQ(component_range(field("light.position"), 3).max, 1.0);
    EXPECT_EQ(component_range(field("light.position"), 0).max, 1e6);
    EXPECT_EQ(component_range(field("plane.equation"), 3).max, 1e6);
}

TEST(Clamp, ReturnsNumbersToTheirRanges) {
    Params params;
    params.projection.fovy = 400.0;
    params.projection.near = -3.0;
    params.shadow.opacity = 1.5;
    params.reflection.bounces = 99;
    params.view.samples = 3;
    params.visibility.step = -7;
    params.lights.front().position = {1e9, 2.0, 3.0, 4.0};
    params.observer.pitch = -120.0;
    params.camera.position.x = std::nan("");
    params.projection.height = INFINITY;
    clamp_to_ranges(params);
    EXPECT_EQ(params.projection.fovy, 179.0);
    EXPECT_EQ(params.projection.near, 1e-6);
    EXPECT_EQ(params.shadow.opacity, 1.0);
    EXPECT_EQ(params.reflection.bounces, 16);
    EXPECT_EQ(params.view.samples, 4);
    EXPECT_EQ(params.visibility.step, -1);
    EXPECT_EQ(params.lights.front().position, glm::dvec4(1e6, 2.0, 3.0, 1.0));
    EXPECT_EQ(params.observer.pitch, -90.0);
    EXPECT_EQ(params.camera.position.x, 3.9);
    EXPECT_EQ(params.projection.height, 1e4);
}

// Nothing between 0 and the smallest aspect is valid, so a drag jumps over the gap.
TEST(Clamp, JumpsOverAspectsThatAreTooNarrow) {
    for (const auto& [dragged, fixed] : {std::pair(-1.0, 0.0), {0.04, 0.0}, {0.06, 0.1}, {0.1, 0.1}, {99.0, 10.0}}) {
        Params params;
        params.projection.aspect = dragged;
        clamp_to_ranges(params);
        EXPECT_EQ(params.projection.aspect, fixed) << dragged;
    }
}

TEST(Clamp, WrapsAnglesByWholeTurns) {
    Params params;
    params.camera.yaw = 3600.0 * 3.0 + 10.0;
    params.camera.roll = -3605.0;
    params.camera.pitch = 190.0;
    params.observer.yaw = 725.0;  // within ten turns: unchanged
    clamp_to_ranges(params);
    EXPECT_EQ(params.camera.yaw, 10.0);
    EXPECT_EQ(params.camera.roll, -5.0);
    EXPECT_EQ(params.camera.pitch, -170.0);
    EXPECT_EQ(params.observer.yaw, 725.0);
}

TEST(Clamp, RepairsRelationsBetweenFields) {
    Params params;
    params.projection.near = 50.0;
    params.planes.front().equation = {0.0, 0.0, 0.0, 3.0};
    params.lights.front().position = glm::dvec4(0.0);
    params.lights.resize(9, LightParams{glm::dvec4(0.0)});
    params.planes.resize(9, PlaneParams{glm::dvec4(0.0), -1.0, true, true, false});
    params.overrides[0].shadowed_world_from_world[0] = glm::dmat4(std::nan(""));
    params.follow = Follow{"box", -3};
    params.view.plane = 100;
    params.view.light = -3;
    clamp_to_ranges(params);
    EXPECT_LT(params.projection.near, params.projection.far);
    EXPECT_EQ(params.projection.near, 50.0);
    EXPECT_EQ(params.planes.front().equation, glm::dvec4(0.0, 1.0, 0.0, 3.0));
    EXPECT_EQ(params.lights.front().position, glm::dvec4(0.0, 1.0, 0.0, 0.0));
    EXPECT_EQ(params.lights.size(), 4U);
    EXPECT_EQ(params.planes.size(), 8U);
    EXPECT_EQ(params.planes[7].extent, 1e-3);
    EXPECT_EQ(params.view.plane, 8);
    EXPECT_EQ(params.view.light, 1);
    EXPECT_EQ((*params.overrides[0].shadowed_world_from_world[0])[0][0], 0.0);
    EXPECT_EQ(params.follow->vertex, 0);
    params.follow = Follow{.object = "", .point = glm::dvec3(0.0, std::nan(""), 1e30)};
    params.reflection.fovy = 0.7;
    clamp_to_ranges(params);
    EXPECT_EQ(*params.follow->point, glm::dvec3(0.0, 0.0, field("follow").max));
    EXPECT_EQ(params.reflection.fovy, 1.0);
}

TEST(Clamp, KeepsANegativeNearOnlyWhereItIsLegal) {
    for (const bool orthographic : {false, true}) {
        for (const DepthMapping mapping : {DepthMapping::standard, DepthMapping::reversed, DepthMapping::logarithmic}) {
            Params params;
            if (orthographic) params.projection.type = ProjectionType::orthographic;
            params.depth.mapping = mapping;
            params.projection.near = -5.0;
            clamp_to_ranges(params);
            const bool is_legal = orthographic && mapping != DepthMapping::logarithmic;
            EXPECT_EQ(params.projection.near, is_legal ? -5.0 : 1e-6);
        }
    }
}

TEST(Clamp, KeepsAnInfiniteFarOnlyWhereItIsLegal) {
    for (int type = 0; type < 4; ++type) {
        for (const DepthMapping mapping : {DepthMapping::standard, DepthMapping::reversed, DepthMapping::logarithmic}) {
            Params params;
            params.projection.type = static_cast<ProjectionType>(type);
            params.depth.mapping = mapping;
            params.projection.far = INFINITY;
            params.projection.near = 100.0;
            clamp_to_ranges(params);
            const bool is_parallel = type % 2 == 1;
            EXPECT_EQ(std::isinf(params.projection.far), !is_parallel && mapping != DepthMapping::logarithmic);
            EXPECT_LT(params.projection.near, params.projection.far);
        }
    }
}

// Pushes near and far to their extremes. The repair must work at both ends of their ranges.
TEST(Clamp, KeepsNearBelowFarAtTheEnds) {
    for (const double near : {1e-9, 1e-6, 1e-5, 1.0, 1e6, 1e12}) {
        for (const double far : {0.0, 1e-6, 1e-5, 1e6, 1e9, 1e12}) {
            Params params;
            params.projection.near = near;
            params.projection.far = far;
            clamp_to_ranges(params);
            EXPECT_LT(params.projection.near, params.projection.far) << near << " " << far;
            EXPECT_LE(params.projection.far, 1e9);
            EXPECT_GE(params.projection.near, 1e-6);
        }
    }
}

}  // namespace
}  // namespace viewing
