// Every control of the panel changes its own field and nothing else, and reaches only values in range.
#include <set>

#include "desk.h"
#include "listed_fields.h"

namespace viewing::test {
namespace {

struct Control {
    std::string label, field;
    Navigation mode = Navigation::fly;  ///< the mode in which the control is available
};

/// All controls of the panel that hold a value, with every section expanded in the opening state.
std::vector<Control> listed_controls() {
    std::vector<Control> controls;
    for (const testing::ListedField& field : testing::listed_fields())
        for (const std::string& control : field.controls) {
            if (control == "elsewhere" || control == "none") continue;
            const std::size_t end = std::min(control.find(" ["), control.size());
            const std::string_view mode = std::string_view(control).substr(end);
            controls.push_back({control.substr(0, end), field.path(),
                                mode == " [walk]"    ? Navigation::walk
                                : mode == " [orbit]" ? Navigation::orbit
                                                     : Navigation::fly});
        }
    return controls;
}

bool is_switch(const RecordedItem& item) {
    return item.text == "on" || item.text == "off";
}
bool is_number(const RecordedItem& item) {
    return widgets::ParseNumber(item.text, "°").has_value();
}
bool holds_value(const RecordedItem& item) {
    const std::set<std::string> other = {"", "open", "folded", "available"};
    const bool is_text = item.label.ends_with("/note") || item.label.ends_with("/trouble");
    return item.window == "panel" && !other.contains(item.text) && !is_text &&
           item.label.find("degrees of freedom") == std::string::npos;
}

/// Operates a control as a user would, so that its value changes; returns false for a choice that is already selected.
bool use(Desk& desk, const RecordedItem& item) {
    if (is_switch(item)) {
        desk.click(item.label);
        return !(item.text == "on" && std::count(item.label.begin(), item.label.end(), '/') == 2);
    }
    if (is_number(item)) {
        desk.drag(item.label, -12.0F);
        return true;
    }
    desk.click(item.label);
    desk.ui.frames(2);
    if (item.text.starts_with('#')) {
        const std::string group = item.label.substr(0, item.label.find('/'));
        desk.ui.click(group + "/picker");
    } else {
        for (const RecordedItem& offered : desk.recorded())
            if (offered.label.starts_with(item.label + "/") && !offered.label.ends_with("/" + item.text)) {
                desk.ui.click(std::string(offered.label));
                break;
            }
    }
    desk.click_at({1.0F, desk.layout().status_bar.min.y + 5.0F});  // closes an open list
    desk.ui.frames(2);
    return true;
}

TEST(Panel, EveryControlChangesItsOwnFieldInOneUndoStep) {
    Desk desk;
    desk.params().cull.enabled = desk.params().animation.light_orbit = true;  // make the dependent controls effective
    desk.fold_out_all();
    for (const Control& control : listed_controls()) {
        SCOPED_TRACE(control.label);
        if (control.mode != Navigation::fly) {
            EXPECT_FALSE(desk.ui.find(control.label).enabled);  // not available in fly mode
        }
        desk.session.params.camera.navigation = control.mode;
        desk.ui.frames(2);
        const Params before = desk.params();
        const RecordedItem item = desk.ui.find(control.label);
        EXPECT_TRUE(item.enabled);
        const bool changes = use(desk, item);
        const Paths changed = differing_fields(before, desk.params());
        EXPECT_EQ(changed, changes ? Paths{control.field} : Paths{});
        if (!changes) continue;
        desk.undo();
        EXPECT_EQ(desk.params(), before);
        desk.session.params.camera.navigation = Navigation::fly;
        desk.ui.frames(2);
    }
}

TEST(Panel, NoControlIsMissingFromTheTable) {
    Desk desk;
    desk.fold_out_all();
    std::set<std::string> known;
    for (const Control& control : listed_controls()) known.insert(control.label);
    known.insert("camera/speed");                                               // part of the session, not of the state
    known.insert({"projection/explicit window", "projection/infinite z-far"});  // projection_test.cpp
    known.insert({"camera/pose/Angles", "camera/pose/Look at"});                // show the same fields in another way
    for (const RecordedItem& item : desk.recorded()) {
        if (holds_value(item) && item.enabled) {
            EXPECT_TRUE(known.contains(item.label)) << item.label << " shows " << item.text;
        }
    }
}

TEST(Panel, EveryFieldHasAControlOrIsListedWithoutOne) {
    for (const testing::ListedField& field : testing::listed_fields())
        EXPECT_FALSE(field.controls.empty())
            << field.path() << " has no control: draw one, and name its label in tests/fields.txt";
}

class PanelTest : public UiTest {};

TEST_F(PanelTest, FieldsHiddenInTheOpeningStateHaveControls) {
    params.camera.navigation = Navigation::orbit;
    params.projection.type = ProjectionType::orthographic;
    params.shadow.offset = ShadowOffset::lift;
    desk.fold_out_all();
    desk.settle();
    for (const auto& [label, field] :
         std::vector<std::pair<std::string, std::string>>{{"camera/target/x", "camera.target"},
                                                          {"projection/height", "projection.height"},
                                                          {"shadow/lift", "shadow.lift"}}) {
        const Params before = params;
        desk.drag(label, 25.0F);
        EXPECT_EQ(differing_fields(before, params), Paths{field});
    }
}

// Both switches are enabled only if the plane is one that they affect.
TEST_F(PanelTest, TheMistakesOfRHaveSwitchesIfTheyAffectThePlane) {
    desk.fold_out_all();
    EXPECT_FALSE(ui.find("reflection/+2ab in R").enabled);
    EXPECT_FALSE(ui.find("reflection/n not unit").enabled);
    params.planes.front().equation = {0.3, 1.0, 0.15, 0.5};
    desk.settle();
    for (const auto& [label, field] : std::vector<std::pair<std::string, std::string>>{
             {"reflection/+2ab in R", "slips.plus_2ab"}, {"reflection/n not unit", "slips.normal_not_unit"}}) {
        const Params before = params;
        desk.click(label);
        EXPECT_EQ(differing_fields(before, params), Paths{field});
        desk.undo();
    }
}

TEST_F(PanelTest, TheObliquePlaneCanStayInWorldSpace) {
    desk.fold_out_all();
    EXPECT_FALSE(ui.find("reflection/Oblique in world").enabled);
    params.reflection.clip = MirrorClip::oblique;
    desk.settle();
    const Params before = params;
    desk.click("reflection/Oblique in world");
    EXPECT_EQ(differing_fields(before, params), Paths{"slips.oblique_in_world"});
}

TEST_F(PanelTest, DecalsHaveTheirOwnOffset) {
    for (const NamedFile& scene : scenes()) {
        params.scene = scene.name;
        desk.settle();
        bool has_decals = false;
        for (const SceneObject& object : desk.session.scene().objects) has_decals |= object.description.decal;
        desk.fold_out_all();
        EXPECT_EQ(ui.find("buffer/decal factor").enabled, has_decals) << scene.name;
        EXPECT_EQ(ui.find("buffer/decal units").enabled, has_decals) << scene.name;
    }
    SceneDescription description;
    ObjectDescription& decal = description.objects.emplace_back();
    decal.name = "decal";
    decal.shape = ShapeKind::quad;
    decal.decal = true;
    params.scene = description;
    desk.settle();
    desk.enter("buffer/decal factor", "-2");
    desk.enter("buffer/decal units", "-3");
    EXPECT_EQ(params.depth.offset, (DepthOffset{-2.0, -3.0}));
}

TEST_F(PanelTest, NearCannotPassFarAndFarCannotPassNear) {
    desk.drag("projection/z-near", 900.0F, 0.0F, 30);
    EXPECT_GT(params.projection.near, 39.0);
    EXPECT_LT(params.projection.near, params.projection.far);
    EXPECT_EQ(params.projection.far, 40.0);
    desk.drag("projection/z-far", -900.0F, 0.0F, 30);
    EXPECT_GT(params.projection.far, params.projection.near);
    EXPECT_GT(params.projection.near, 39.0);
    desk.enter("projection/z-near", "1000");
    EXPECT_LT(params.projection.near, params.projection.far);
    desk.enter("projection/z-far", "0.001");
    EXPECT_LT(params.projection.near, params.projection.far);
}

TEST_F(PanelTest, TypedValuesAreClamped) {
    struct Typed {
        const char *label, *text;
        const double& value;
        double expected;
    };
    const Typed typed[] = {{"projection/fovy", "500", params.projection.fovy, 179.0},
                           {"projection/fovy", "-3", params.projection.fovy, 1.0},
                           {"projection/fovy", "55", params.projection.fovy, 55.0},
                           {"projection/z-near", "-1", params.projection.near, 1e-6},
                           {"projection/z-far", "1e9", params.projection.far, 1e9},
                           {"projection/z-far", "40", params.projection.far, 40.0},
                           {"shadow/opacity", "7", params.shadow.opacity, 1.0},
                           {"light/position/w", "2", params.lights.front().position.w, 1.0},
                           {"camera/position/x", "1e300", params.camera.position.x, 1e6},
                           {"camera/position/x", "−2,5", params.camera.position.x, -2.5}};
    for (const Typed& one : typed) {
        desk.enter(one.label, one.text);
        EXPECT_EQ(one.value, one.expected) << one.label << " " << one.text;
    }
    const Params before = params;
    for (const char* junk : {"nan", "inf", "abc", "1e999", ""}) desk.enter("projection/fovy", junk);
    EXPECT_EQ(params, before);
}

TEST_F(PanelTest, RightClickResets) {
    params.projection.near = 2.0;
    params.camera.position = {1.0, 2.0, 3.0};
    params.camera.yaw = 5.0;
    params.depth.func = CompareFunc::always;
    params.shadow.clip_casters = false;
    params.projection.type = ProjectionType::orthographic;
    ui.frames(3);
    for (const char* label : {"camera/position/x", "camera/position/y", "camera/position/z", "camera/yaw pitch roll/x",
                              "projection/z-near", "projection/type/Perspective", "depth/func", "shadow/Clip casters"})
        desk.right_click(label);
    EXPECT_EQ(differing_fields(params, Params{}), Paths{});
}

TEST_F(PanelTest, CombosChooseByName) {
    params.cull.enabled = true;  // otherwise the choice of faces has no effect
    desk.fold_out_all();
    desk.choose("depth/func", "depth/func/GL_GEQUAL");
    EXPECT_EQ(params.depth.func, CompareFunc::gequal);
    desk.choose("depth/face", "depth/face/GL_FRONT_AND_BACK");
    EXPECT_EQ(params.cull.face, CullFace::front_and_back);
    desk.choose("depth/front_face", "depth/front_face/GL_CW");
    EXPECT_EQ(params.cull.front_face, FrontFace::cw);
    desk.choose("buffer/depth format", "buffer/depth format/16 bit");
    EXPECT_EQ(params.depth.format, DepthFormat::d16);
    desk.choose("buffer/depth mapping", "buffer/depth mapping/reversed");
    EXPECT_EQ(params.depth.mapping, DepthMapping::reversed);
    desk.choose("shadow/offset", "shadow/offset/lift");
    EXPECT_EQ(params.shadow.offset, ShadowOffset::lift);
    desk.choose("reflection/clip at the plane", "reflection/clip at the plane/oblique near plane");
    EXPECT_EQ(params.reflection.clip, MirrorClip::oblique);
}

TEST_F(PanelTest, PlaneButtonsAndNormalize) {
    desk.enter("plane/equation/d", "2");
    const Bounds& bounds = desk.session.scene().bounds_world;
    for (const auto& [button, axis] : {std::pair{"yz", 0}, std::pair{"xy", 2}}) {
        glm::dvec4 coordinate_plane(0.0);
        coordinate_plane[axis] = 1.0;
        desk.click(std::string("plane/equation/") + button);
        const glm::dvec4 clear = params.planes.front().equation;
        EXPECT_EQ(glm::dvec3(clear), glm::dvec3(coordinate_plane));
        EXPECT_GT(bounds.min[axis] + clear.w, 0.0) << "all objects are in front of the plane";
        EXPECT_GT(params.camera.position[axis] + clear.w, 0.0) << "and so is the eye";
        desk.click(std::string("plane/equation/") + button);
        EXPECT_EQ(params.planes.front().equation, coordinate_plane) << "the second press: through the origin";
    }
    desk.click("plane/equation/xz");
    EXPECT_EQ(params.planes.front().equation, glm::dvec4(0, 1, 0, 0));
    EXPECT_FALSE(ui.find("plane/equation/Normalize").enabled);

    desk.enter("plane/equation/a", "3");
    desk.enter("plane/equation/b", "4");
    desk.enter("plane/equation/d", "10");
    desk.click("plane/equation/Normalize");
    EXPECT_NEAR(params.planes.front().equation.x, 0.6, 1e-15);
    EXPECT_NEAR(params.planes.front().equation.y, 0.8, 1e-15);
    EXPECT_NEAR(params.planes.front().equation.w, 2.0, 1e-15);
}

TEST_F(PanelTest, ANormalNeverBecomesZeroAndALightNeverVanishes) {
    desk.enter("plane/equation/b", "0");
    EXPECT_EQ(params.planes.front().equation, glm::dvec4(0, 1, 0, 0));
    for (const char* component : {"light/position/x", "light/position/y", "light/position/z", "light/position/w"})
        desk.enter(component, "0");
    EXPECT_GT(glm::length(params.lights.front().position), 0.0);
}

TEST_F(PanelTest, LightIsPointOrParallel) {
    desk.click("light/position/parallel");
    EXPECT_EQ(params.lights.front().position, glm::dvec4(2.6, 5.2, 2.2, 0.0));
    EXPECT_EQ(ui.text_of("light/position/parallel"), "on");
    desk.click("light/position/point");
    EXPECT_EQ(params.lights.front().position, glm::dvec4(2.6, 5.2, 2.2, 1.0));
}

TEST_F(PanelTest, LightsCanBeAddedChangedAndRemoved) {
    for (std::size_t count = 1; count <= 3; ++count) {
        desk.click("light/Add a light");
        ASSERT_EQ(params.lights.size(), count + 1);
    }
    const std::vector<LightParams> four = params.lights;
    EXPECT_EQ(four[1].position, glm::dvec4(-2.6, 5.2, 2.2, 1.0));
    EXPECT_NE(four[1], four[2]);
    EXPECT_NE(four[2], four[3]);
    EXPECT_FALSE(ui.find("light/Add a light").enabled);
    desk.enter("light/light 3/y", "4");
    EXPECT_EQ(params.lights[2].position.y, 4.0);
    desk.click("light/light 4/parallel");
    EXPECT_EQ(params.lights[3].position.w, 0.0);
    desk.click("light/remove light 2");
    ASSERT_EQ(params.lights.size(), 3U);
    EXPECT_EQ(params.lights[1].position.y, 4.0);
    EXPECT_TRUE(ui.find("light/Add a light").enabled);
    desk.undo();
    EXPECT_EQ(params.lights.size(), 4U);
}

TEST_F(PanelTest, PlanesCanBeAddedChangedAndRemoved) {
    for (std::size_t count = 1; count <= 7; ++count) {
        desk.click("plane/Add a plane");
        ASSERT_EQ(params.planes.size(), count + 1);
    }
    EXPECT_EQ(params.planes[1].equation, glm::dvec4(0, 0, 1, 3));
    EXPECT_EQ(params.planes[2].equation, glm::dvec4(1, 0, 0, 3));
    for (std::size_t one = 0; one < 8; ++one)
        for (std::size_t other = 0; other < one; ++other) EXPECT_NE(params.planes[one], params.planes[other]);
    EXPECT_FALSE(ui.find("plane/Add a plane").enabled);
    desk.click("plane/Plane 3");
    desk.enter("plane/plane 3/equation/d", "4");
    EXPECT_EQ(params.planes[2].equation, glm::dvec4(1, 0, 0, 4));
    desk.enter("plane/plane 3/extent", "7");
    EXPECT_EQ(params.planes[2].extent, 7.0);
    for (const char* flag : {"plane/plane 3/Receiver", "plane/plane 3/Mirrors", "plane/plane 3/Gloss"})
        desk.click(flag);
    EXPECT_FALSE(params.planes[2].receives_shadow || params.planes[2].mirrors);
    EXPECT_TRUE(params.planes[2].gloss);
    EXPECT_EQ(params.planes.front(), PlaneParams{});
    desk.click("plane/plane 3/remove plane 3");
    ASSERT_EQ(params.planes.size(), 7U);
    EXPECT_EQ(params.planes[2].equation, glm::dvec4(-1, 0, 0, 3));
}

TEST_F(PanelTest, TheMirroredCamerasProjectionIsOfferedWhenUsed) {
    desk.fold_out_all();
    EXPECT_FALSE(ui.find("reflection/Same projection").enabled);
    desk.click("reflection/mirrored/the camera");
    desk.click("reflection/Same projection");
    EXPECT_FALSE(params.reflection.same_projection);
}

TEST_F(PanelTest, AMirrorsOwnFovyIsReportedAndFixed) {
    desk.fold_out_all();
    desk.enter("reflection/mirror fovy", "20");
    EXPECT_EQ(params.reflection.fovy, 20.0);
    EXPECT_TRUE(ui.has("Shadow and reflection/trouble"));
    desk.right_click("reflection/mirror fovy");
    EXPECT_EQ(params.reflection.fovy, 0.0);
    params.projection.type = ProjectionType::orthographic;
    desk.settle();
    EXPECT_FALSE(ui.find("reflection/mirror fovy").enabled);
}

TEST_F(PanelTest, ABrokenSwitchIsReportedBesideIt) {
    ASSERT_FALSE(ui.has("Shadow and reflection/trouble"));
    desk.click("shadow/Stencil once");
    EXPECT_TRUE(ui.has("Shadow and reflection/trouble"));
    desk.click("reflection/Mirror light");
    const std::string both = ui.text_of("Shadow and reflection/trouble");
    EXPECT_NE(both.find('\n'), std::string::npos) << both;
}

TEST_F(PanelTest, ALightInThePlaneIsReportedBesideItsCause) {
    ASSERT_FALSE(ui.has("Light  l/trouble"));
    desk.enter("light/position/y", "0");
    ASSERT_FALSE(desk.problems.empty());
    EXPECT_TRUE(ui.has("Light  l/trouble"));
}

TEST_F(PanelTest, TypingAPositionMovesTheCamera) {
    desk.enter("camera/position/x", "1.25");
    desk.enter("camera/yaw pitch roll/x", "-75.5");
    EXPECT_EQ(params.camera.position.x, 1.25);
    EXPECT_EQ(params.camera.yaw, -75.5);
    EXPECT_EQ(desk.derived.eye_world.x, 1.25);
    EXPECT_EQ(ui.text_of("matrices/V/r3c3"), "1.000");
}

TEST_F(PanelTest, HoveringHighlightsParametersAndMatrixEntriesBothWays) {
    const auto vertices_in = [](const RecordedItem& item) {
        int count = 0;
        const ImDrawData& data = *ImGui::GetDrawData();
        for (int list = 0; list < data.CmdListsCount; ++list) {
            if (std::string(data.CmdLists[list]->_OwnerName) != item.window) continue;
            for (const ImDrawVert& vertex : data.CmdLists[list]->VtxBuffer)
                count += vertex.pos.x >= item.min.x && vertex.pos.x < item.max.x && vertex.pos.y >= item.min.y &&
                         vertex.pos.y < item.max.y;
        }
        return count;
    };
    ui.move_to({-1, -1});
    ui.frames(3);
    const int dark = vertices_in(ui.find("matrices/S/r1c0"));
    const int other = vertices_in(ui.find("matrices/S/r3c0"));
    const int field = vertices_in(ui.find("light/position/y"));
    ui.hover("light/position/y");
    ui.frames(2);
    EXPECT_NE(desk.workbench.widgets.hovered, 0U);
    EXPECT_GT(vertices_in(ui.find("matrices/S/r1c0")), dark);   // −l_y n_x
    EXPECT_EQ(vertices_in(ui.find("matrices/S/r3c0")), other);  // −l_w n_x
    ui.hover("matrices/S/r1c0");
    ui.frames(2);
    EXPECT_GT(vertices_in(ui.find("light/position/y")), field);
}

}  // namespace
/// The position of S's button among those of V, P, S and R.
constexpr std::size_t shadow_place = 2;

TEST(Matrices, VAndPEnteredByHandOverrideUntilReleased) {
    Desk desk;
    const Params before = desk.params();
    const glm::dmat4 v = desk.derived.view_from_world, p = desk.derived.clip_from_view;
    desk.click_one_of("matrices/Edit", 0);
    desk.ui.frames(3);
    EXPECT_EQ(*desk.params().camera_overrides.view_from_world, v);
    desk.drag("matrices/V/r0c3", 20.0F);
    EXPECT_NE(desk.derived.view_from_world[3][0], v[3][0]);
    desk.params().camera.position.x += 1.0;
    desk.ui.frames(3);
    EXPECT_EQ(desk.derived.view_from_world, *desk.params().camera_overrides.view_from_world)
        << "the camera no longer changes V";
    desk.click_one_of("matrices/Edit", 0);  // the first Edit button is now P's
    desk.ui.frames(3);
    EXPECT_EQ(*desk.params().camera_overrides.clip_from_view, p);
    desk.drag("matrices/P/r1c1", 20.0F);
    EXPECT_NE(desk.derived.clip_from_view[1][1], p[1][1]);
    EXPECT_FALSE(desk.ui.find("projection/z-near").enabled) << "near would have no effect";
    desk.click("matrices/Release");
    desk.ui.frames(3);
    desk.click("matrices/Release");
    desk.ui.frames(3);
    desk.params().camera = before.camera;
    desk.ui.frames(3);
    EXPECT_EQ(desk.params(), before);
}

/// No view breaks while V or P is entered by hand, even with arbitrary entries.
TEST(Matrices, EveryViewBearsAnyVAndP) {
    const glm::dmat4 none(0.0), huge(1e12);
    glm::dmat4 behind(1.0), swapped(0.0);
    behind[2][2] = -1.0;
    for (int i = 0; i < 4; ++i) swapped[i][3 - i] = 1.0;
    for (const CameraOverrides& overrides :
         {CameraOverrides{none, {}}, {huge, {}}, {swapped, {}}, {{}, none}, {{}, huge}, {{}, behind}, {{}, swapped}}) {
        Desk desk;
        for (std::size_t topic = 1; topic < names_of<Topic>().size(); ++topic) {
            SCOPED_TRACE(names_of<Topic>()[topic]);
            desk.params().camera_overrides = overrides;
            desk.params().follow = Follow{"box", 3};
            desk.params().scene = std::string(topic % 2 == 0 ? "coplanar" : "torus-and-boxes");
            desk.params().view.lower_right = static_cast<Topic>(topic);
            desk.settle();
            const ImDrawData& drawn = *ImGui::GetDrawData();
            for (int list = 0; list < drawn.CmdListsCount; ++list)
                for (const ImDrawVert& vertex : drawn.CmdLists[list]->VtxBuffer)
                    ASSERT_TRUE(std::isfinite(vertex.pos.x) && std::isfinite(vertex.pos.y));
        }
    }
}

TEST(Matrices, AMatrixEnteredByHandOverridesUntilReleased) {
    Desk desk;
    const glm::dmat4 derived = desk.derived.planes[0].shadows[0].shadowed_world_from_world;
    desk.click_one_of("matrices/Edit", shadow_place);
    desk.ui.frames(3);
    ASSERT_TRUE(desk.params().overrides[0].shadowed_world_from_world[0]);
    EXPECT_EQ(*desk.params().overrides[0].shadowed_world_from_world[0], derived);
    desk.drag("matrices/S/r0c1", 20.0F);
    EXPECT_NE(desk.derived.planes[0].shadows[0].shadowed_world_from_world[1][0], derived[1][0]);
    EXPECT_EQ(desk.derived.planes[0].shadows[0].shadowed_world_from_world[0][1], derived[0][1]);
    desk.ui.click("matrices/Release");
    desk.ui.frames(3);
    EXPECT_FALSE(desk.params().overrides[0].shadowed_world_from_world[0]);
    EXPECT_EQ(desk.derived.planes[0].shadows[0].shadowed_world_from_world, derived);
}

TEST(Matrices, EachPlaneAndLightHasItsOwnMatrices) {
    Desk desk({1600, 1500}, "opening");
    EXPECT_FALSE(desk.ui.has("matrices/plane"));
    desk.click("plane/Add a plane");
    desk.click("light/Add a light");
    desk.ui.frames(3);
    EXPECT_EQ(desk.ui.text_of("matrices/R/r2c2"), "1.000");
    desk.choose("matrices/plane", "matrices/plane/plane 2");
    EXPECT_EQ(desk.ui.text_of("matrices/R/r2c2"), "−1.000");  // the wall z = −3
    EXPECT_EQ(desk.ui.text_of("matrices/R/r2c3"), "−6.000");
    EXPECT_EQ(desk.ui.text_of("matrices/S/r0c2"), "−2.600");  // −l_x n_z
    EXPECT_EQ(desk.params().view.plane, 2);
    desk.choose("matrices/light", "matrices/light/light 2");
    EXPECT_EQ(desk.ui.text_of("matrices/S/r0c2"), "2.600");
    desk.click_one_of("matrices/Edit", shadow_place);
    desk.ui.frames(3);
    PlaneOverrides wall;
    wall.shadowed_world_from_world[1] = desk.derived.planes[1].shadows[1].shadowed_world_from_world;
    EXPECT_EQ(desk.params().overrides[1], wall);
    EXPECT_EQ(desk.params().overrides[0], PlaneOverrides{});
    desk.click("plane/Plane 2");
    desk.click("plane/plane 2/remove plane 2");
    desk.ui.frames(3);
    EXPECT_FALSE(desk.ui.has("matrices/plane"));
}

}  // namespace viewing::test
