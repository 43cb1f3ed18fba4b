// Checks the list of fields against the contract, which is written out here by hand.
#include "state/fields.h"

#include <gtest/gtest.h>

#include <set>

#include "random_params.h"

namespace viewing {
namespace {

constexpr std::string_view contract_paths[] = {
    "version",
    "scene",
    "camera.position",
    "camera.yaw",
    "camera.pitch",
    "camera.roll",
    "camera.target",
    "camera.navigation",
    "projection.type",
    "projection.fovy",
    "projection.height",
    "projection.near",
    "projection.far",
    "projection.aspect",
    "projection.left",
    "projection.right",
    "projection.bottom",
    "projection.top",
    "depth.buffer",
    "depth.test",
    "depth.func",
    "depth.write",
    "depth.clear",
    "depth.format",
    "depth.mapping",
    "depth.offset.factor",
    "depth.offset.units",
    "depth.decals",
    "depth.clear_value",
    "depth.write_while_clearing",
    "depth.reversed_zero_to_one",
    "depth.reversed_clear",
    "depth.reversed_offset",
    "depth.logarithm_per_vertex",
    "coplanar.gap",
    "coplanar.tilt",
    "coplanar.distance",
    "cull.enabled",
    "cull.face",
    "cull.front_face",
    "light.position",
    "lights",
    "plane.equation",
    "plane.extent",
    "plane.receives_shadow",
    "plane.mirrors",
    "plane.gloss",
    "planes",
    "shadow.enabled",
    "shadow.color",
    "shadow.opacity",
    "shadow.stencil_once",
    "shadow.clip_to_receiver",
    "shadow.clip_casters",
    "shadow.offset",
    "shadow.offset_factor",
    "shadow.offset_units",
    "shadow.lift",
    "shadow.style",
    "shadow.clip_at_light",
    "shadow.sign",
    "shadow.write_depth",
    "shadow.own_stencil",
    "reflection.enabled",
    "reflection.reflectance",
    "reflection.stencil",
    "reflection.clip",
    "reflection.flip_winding",
    "reflection.reflect_light",
    "reflection.bounces",
    "reflection.mirrored",
    "reflection.same_projection",
    "reflection.fovy",
    "reflection.printed_by_rows",
    "reflection.mask_writes_depth",
    "reflection.after_objects",
    "reflection.side_of_eye",
    "reflection.shadows",
    "overrides.view_from_world",
    "overrides.clip_from_view",
    "overrides.shadow_from_world",
    "overrides.mirror_from_world",
    "overrides.further",
    "follow",
    "visibility.method",
    "visibility.step",
    "visibility.sort_key",
    "visibility.splitter",
    "visibility.walk",
    "visibility.epsilon",
    "visibility.exact_curves",
    "visibility.compare_with",
    "visibility.numbers",
    "visibility.raster",
    "visibility.pixel",
    "view.shows",
    "view.depth_scale",
    "view.depth_colors",
    "view.depth_range",
    "view.samples",
    "view.plane",
    "view.light",
    "view.beside.shows",
    "view.beside.layout",
    "view.beside.share",
    "view.beside.format",
    "view.beside.mapping",
    "view.beside.set",
    "view.pixel",
    "view.pin",
    "view.cells",
    "view.call",
    "view.triangle",
    "view.pass",
    "view.derivation_step",
    "view.division",
    "view.way",
    "view.lower_left",
    "view.lower_right",
    "view.layout.big",
    "view.layout.matrices",
    "view.layout.controls",
    "view.layout.folded",
    "observer.target",
    "observer.yaw",
    "observer.pitch",
    "observer.distance",
    "observer.light_rays",
    "observer.mirrored_eye",
    "observer.image_space",
    "slips.walk_slows",
    "slips.creeping_roll",
    "slips.pole_flip",
    "slips.swapped_order",
    "slips.camera_as_view",
    "slips.degrees_as_radians",
    "slips.plus_2ab",
    "slips.normal_not_unit",
    "slips.shadow_by_rows",
    "slips.oblique_in_world",
    "animation.jiggle",
    "animation.light_orbit",
    "animation.light_speed",
    "ui.theme",
    "ui.scale",
    "ui.language",
};

std::vector<std::string> names(std::string_view path) {
    Params params;
    const auto choice = std::get<EnumRef>(field(path).in(params));
    return {choice.names.begin(), choice.names.end()};
}

using Names = std::vector<std::string>;

TEST(Fields, MatchTheContractInOrder) {
    ASSERT_EQ(fields().size(), std::size(contract_paths));
    for (std::size_t i = 0; i < fields().size(); ++i) {
        EXPECT_EQ(fields()[i].path, contract_paths[i]);
    }
}

TEST(Fields, EnumsHaveTheNamesOfTheContract) {
    EXPECT_EQ(names("camera.navigation"), (Names{"fly", "walk", "orbit"}));
    EXPECT_EQ(names("projection.type"), (Names{"perspective", "orthographic", "frustum", "orthographic_window"}));
    EXPECT_EQ(names("depth.func"),
              (Names{"never", "less", "equal", "lequal", "greater", "notequal", "gequal", "always"}));
    EXPECT_EQ(names("depth.format"),
              (Names{"d4", "d5", "d6", "d7", "d8", "d9", "d10", "d11", "d12", "d16", "d24", "d32f"}));
    EXPECT_EQ(names("depth.mapping"), (Names{"standard", "reversed", "logarithmic"}));
    EXPECT_EQ(names("cull.face"), (Names{"front", "back", "front_and_back"}));
    EXPECT_EQ(names("cull.front_face"), (Names{"ccw", "cw"}));
    EXPECT_EQ(names("shadow.offset"), (Names{"none", "polygon_offset", "lift", "no_depth_test"}));
    EXPECT_EQ(names("shadow.style"), (Names{"blend", "missing_light"}));
    EXPECT_EQ(names("shadow.sign"), (Names{"plane_dot_light", "none", "forced"}));
    EXPECT_EQ(names("reflection.mirrored"), (Names{"scene", "camera"}));
    EXPECT_EQ(names("reflection.clip"), (Names{"none", "clip_distance", "oblique"}));
    EXPECT_EQ(names("visibility.method"),
              (Names{"depth_buffer", "none", "painter", "newell", "bsp", "software_depth_buffer", "ray_cast"}));
    EXPECT_EQ(names("visibility.sort_key"), (Names{"nearest", "farthest", "centroid"}));
    EXPECT_EQ(names("visibility.splitter"), (Names{"first", "random", "fewest_splits", "balanced"}));
    EXPECT_EQ(names("visibility.walk"), (Names{"back_to_front", "front_to_back"}));
    EXPECT_EQ(names("visibility.compare_with"), names("visibility.method"));
    EXPECT_EQ(names("view.shows"),
              (Names{"color", "depth", "stencil", "facing", "overdraw", "difference", "fighting", "shadow_w"}));
    EXPECT_EQ(names("view.depth_scale"), (Names{"window", "linear"}));
    EXPECT_EQ(names("view.depth_colors"), (Names{"grey", "bands"}));
    EXPECT_EQ(names("view.beside.shows"), (Names{"nothing", "depth", "other_depth", "settings"}));
    EXPECT_EQ(names("view.beside.layout"), (Names{"halves", "divider"}));
    EXPECT_EQ(names("view.beside.format"), names("depth.format"));
    EXPECT_EQ(names("depth.decals"), (Names{"offset", "equal", "stencil"}));
    EXPECT_EQ(names("view.layout.big"), (Names{"none", "camera", "lower_left", "lower_right", "matrices"}));
    EXPECT_EQ(names("ui.theme"), (Names{"dark", "light", "projector"}));
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
        if (field.logarithmic && field.path != "projection.near") {  // negative only in orthographic projections
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
