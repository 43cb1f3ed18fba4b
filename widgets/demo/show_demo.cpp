// Every widget once, each in as few lines as it needs. Read this as the library's manual while the demo runs. Its
// columns are: numbers and switches; planes, lights, lamps, and labels in a view; matrices; the diagrams of
// show_diagrams_demo.cpp and show_depth_demo.cpp.
#include "widgets/demo/show_demo.h"

#include <array>
#include <cmath>
#include <string>

namespace widgets {

namespace {

// One bit for each parameter that matrix entries depend on.
constexpr Links light_link(int component) {
    return Links{1} << component;
}
constexpr Links plane_link(int component) {
    return Links{1} << (4 + component);
}

constexpr std::array<Links, 4> light_links{light_link(0), light_link(1), light_link(2), light_link(3)};
constexpr std::array<Links, 4> plane_links{plane_link(0), plane_link(1), plane_link(2), plane_link(3)};

/// The values that the widgets edit.
struct DemoValues {
    glm::dvec3 position{3.9, 3.0, 6.6};
    double yaw_deg = 30.6, fovy_deg = 40.0, near = 0.5, far = 40.0, opacity = 0.5;
    double bounces = 1.0;
    bool depth_test = true, cull_face = false, unavailable = true;
    int depth_func = 1, navigation = 0;
    const char* scene = "Boxes";
    glm::u8vec3 color{0x5A, 0x9E, 0xF0};
    glm::dvec4 plane{0.0, 1.0, 0.0, 0.0}, light{2.6, 5.2, 2.2, 1.0};
    glm::dvec4 light_before{2.6, 5.2, 2.2, 1.0};
    glm::dmat4 shadow_before{1.0};
    glm::dmat4 override_matrix{1.0};
    float split = 120.0F;
};

constexpr const char* depth_funcs[] = {"GL_NEVER",   "GL_LESS",     "GL_EQUAL",  "GL_LEQUAL",
                                       "GL_GREATER", "GL_NOTEQUAL", "GL_GEQUAL", "GL_ALWAYS"};
constexpr const char* navigations[] = {"Fly (6 DOF)", "Walk (2 DOF)", "Orbit"};
constexpr const char* navigation_tips[] = {"Six degrees of freedom.", "Two: turn and go forward.", "About a target."};

void ShowNumbers(DemoValues& v) {
    if (!Section("Numbers", true, "drag · type · reset")) return;
    const Group group("numbers");
    Vec3("position", v.position, {.step = 0.02, .decimals = 2, .role = Role::camera}, {3.9, 3.0, 6.6});
    Tooltip("Camera position", "The eye in world space. Drag to move, double-click to type, right-click to reset.",
            "V = C^{-1}", "glUniformMatrix4fv(view_from_world, …)");
    Number("yaw", v.yaw_deg, {.min = -360, .max = 360, .step = 0.2, .decimals = 1, .unit = "°", .default_value = 30.6});
    Slider("fovy", v.fovy_deg, {.min = 1, .max = 170, .step = 0.2, .decimals = 1, .unit = "°", .default_value = 40});
    Slider("z-near", v.near,
           {.min = 1e-4, .max = v.far * 0.999, .decimals = 3, .logarithmic = true, .default_value = 0.5});
    Tooltip("Near plane", "Half of all depth codes lie between n and 2nf/(f + n): moving n out gains the most.",
            "Δz ≈ z^2 (f - n) / (f n (2^b - 1))", "glm::perspective(fovy, aspect, near, far)");
    Slider("z-far", v.far,
           {.min = v.near * 1.001, .max = 1e6, .decimals = 1, .logarithmic = true, .default_value = 40});
    Slider("opacity", v.opacity, {.min = 0, .max = 1, .decimals = 2, .default_value = 0.5, .role = Role::light});
    Number("bounces", v.bounces, {.min = 0, .max = 8, .step = 0.05, .integer = true, .default_value = 1});
    Note("24-bit depth: Δz at 8.2 m = 8.0 μm");
}

void ShowSwitches(DemoValues& v, DemoLook& look) {
    if (!Section("Switches")) return;
    const Group group("switches");
    Toggle("Depth test", v.depth_test, true);
    Tooltip("Depth test", "When off, nothing is compared or written: not the same as GL_ALWAYS.", "",
            "glEnable(GL_DEPTH_TEST)");
    ImGui::SameLine(150.0F * CurrentContext().scale * CurrentContext().palette.type_scale);
    Choice("##depth func", v.depth_func, depth_funcs, 1);
    Toggle("Cull face", v.cull_face, false);
    ImGui::SameLine(150.0F * CurrentContext().scale * CurrentContext().palette.type_scale);
    ImGui::BeginDisabled(true);
    Toggle("Stencil", v.unavailable, true);
    ImGui::EndDisabled();
    Tooltip("Stencil", "This depth format has no stencil bits.");
    Segments("##navigation", v.navigation, navigations, 0, navigation_tips);
    if (BeginChoice("##scene", v.scene, 150.0F * CurrentContext().scale)) {
        for (const char* name : {"Boxes", "Torus and boxes"}) {
            if (ImGui::Selectable(name)) v.scene = name;
        }
        EndChoice();
    }
    ColorField("colour", v.color, {0x5A, 0x9E, 0xF0});
    Button("Snapshot");
    ImGui::SameLine();
    Button("Undo", false, "There is nothing to undo");
    SmallButton("Copy");
    ImGui::SameLine();
    SmallButton("Edit");

    static constexpr const char* themes[] = {"Dark", "Light", "Projector"};
    int theme = static_cast<int>(look.theme);
    if (Segments("theme", theme, themes, 0)) look.theme = static_cast<ThemeKind>(theme);
    double scale = look.scale;
    if (Number("scale", scale, {.min = 0.75, .max = 3, .step = 0.01, .default_value = 1}, 60.0F * look.scale)) {
        look.scale = static_cast<float>(scale);
    }
}

void ShowTheLecturesThings(DemoValues& v) {
    if (Section("Light")) {
        const Group group("light");
        Light("position", v.light, {2.6, 5.2, 2.2, 1.0}, light_links);
    }
    if (Section("Plane  n·p + d = 0")) {
        const Group group("plane");
        PlaneEquation("equation", v.plane, {0.0, 1.0, 0.0, 0.0}, plane_links);
    }
    if (glm::dot(v.plane, v.light) == 0.0) {
        Trouble("The light lies in the plane: S sends every point to the light.");
    } else {
        Trouble("This is how a problem reads: one sentence next to its cause.");
    }
    if (Section("Lamps")) {
        const bool fly = v.navigation == 0, walk = v.navigation == 1;
        const Lamp lamps[] = {{"yaw", true, true},     {"pitch", fly, false},  {"roll", fly, false},
                              {"forward", true, walk}, {"strafe", fly, false}, {"up", fly, false}};
        Lamps("degrees of freedom", lamps, Role::camera);
    }
}

void ShowView(DemoValues& v) {
    const Context& context = CurrentContext();
    if (!Section("Labels in a view", true, "the bar below moves")) return;
    const ImVec2 min = ImGui::GetCursorScreenPos();
    const ImVec2 size(ImGui::GetContentRegionAvail().x, v.split * context.scale);
    const ImVec2 max(min.x + size.x, min.y + size.y);
    ImDrawList* draw = ImGui::GetWindowDrawList();
    draw->PushClipRect(min, max, true);
    draw->AddRectFilled(min, max, context.palette.view_ground, 4.0F * context.scale);
    const LetterRole roles[] = {{'l', Role::light}, {'n', Role::plane}, {'p', Role::point}};
    struct Point {
        float x, y;
        const char* text;
        Role role;
    };
    constexpr Point points[] = {{0.62F, 0.22F, "l", Role::light},      {0.50F, 0.50F, "p", Role::point},
                                {0.42F, 0.72F, "s = S p", Role::none}, {0.45F, 0.74F, "s_w = n·l - n·p", Role::none},
                                {0.20F, 0.66F, "n", Role::plane},      {0.22F, 0.70F, "R p", Role::mirror}};
    LabelPlacer placer(draw, min, max);
    const auto at = [&](const Point& point) { return ImVec2(min.x + point.x * size.x, min.y + point.y * size.y); };
    draw->AddLine(at(points[0]), at(points[2]), context.palette.light, 1.5F * context.scale * context.palette.stroke);
    for (const Point& point : points) {
        const ImVec2 center = at(point);
        const float radius = 3.5F * context.scale;
        draw->AddCircleFilled(center, radius, context.palette.of(point.role));
        placer.Avoid(ImVec2(center.x - radius, center.y - radius), ImVec2(center.x + radius, center.y + radius));
    }
    for (const Point& point : points) placer.Place(at(point), point.text, context.palette.of(point.role), roles);
    draw->PopClipRect();
    ImGui::Dummy(size);
    Splitter("height of the view", false, v.split, 60.0F, 240.0F, size.x);
    ValueText("p  = ( 1.700, 1.300, −0.050, 1 )", Role::point);
    ValueText("Sp = ( 5.460, 0.000, −3.120, 3.900 )");
}

glm::dmat4 ShadowOf(const glm::dvec4& plane, const glm::dvec4& light) {
    return glm::dmat4(glm::dot(plane, light)) - glm::outerProduct(light, plane);
}

void ShowShadowMatrix(const char* label, DemoValues& v, float width = 0.0F) {
    static constexpr const char* symbols[16] = {
        "n·l - l_x n_x", "-l_x n_y", "-l_x n_z",      "-l_x d", "-l_y n_x", "n·l - l_y n_y", "-l_y n_z", "-l_y d",
        "-l_z n_x",      "-l_z n_y", "n·l - l_z n_z", "-l_z d", "-l_w n_x", "-l_w n_y",      "-l_w n_z", "n·l - l_w d"};
    constexpr Links all_light = 0x0F, all_plane = 0xF0;
    const glm::dmat4 shadow = ShadowOf(v.plane, v.light);
    if (v.light != v.light_before) {
        v.shadow_before = ShadowOf(v.plane, v.light_before);
        v.light_before = v.light;
    }
    std::array<MatrixCell, 16> cells;
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
            MatrixCell& cell = cells[4 * row + column];
            cell.symbol = symbols[4 * row + column];
            cell.links = light_link(row) | plane_link(column);
            if (row == column) cell.links |= all_light | all_plane;
            cell.changed = v.shadow_before != glm::dmat4(1.0) && shadow[column][row] != v.shadow_before[column][row];
        }
    }
    static constexpr LetterRole roles[] = {{'l', Role::light}, {'n', Role::plane}, {'d', Role::plane}};
    Matrix(label, shadow, {.cells = cells, .roles = roles}, width);
}

void ShowMatrices(DemoValues& v) {
    const Context& context = CurrentContext();
    const auto heading = [&context](const char* text, const char* note) {
        ImGui::PushFont(context.fonts.heading);
        ImGui::TextUnformatted(text);
        ImGui::PopFont();
        ImGui::SameLine();
        Note(note);
    };
    heading("Shadow  S", "hover an entry, or a number of light and plane");
    ShowShadowMatrix("S", v);

    const float narrow = 250.0F * context.scale * context.palette.type_scale;
    heading("Narrow", "fewer decimals, then 1.2e5, smaller symbols");
    const glm::dmat4 large(12.3456789, -1e-17, 0.5, 0, 0, -123456.789, 0, 0, 0, 0, 1.0, -1, 2, 0, 3e7, 0);
    ShowShadowMatrix("narrow S", v, narrow);
    Matrix("large", large, {}, narrow);

    heading("Edited by hand", "each entry is a Number");
    Matrix("override", v.override_matrix, {.editable = true});
}

}  // namespace

void ShowWidgetsDemo(DemoLook& look) {
    static DemoValues values;
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(0, 0));
    ImGui::SetNextWindowSize(display);
    ImGui::Begin("widgets-demo", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
    const float column = std::floor((ImGui::GetContentRegionAvail().x - 3.0F * ImGui::GetStyle().ItemSpacing.x) / 4.4F);
    const auto begin_column = [column](const char* name, float width = 1.0F) {
        ImGui::BeginChild(name, ImVec2(std::floor(column * width), 0.0F));
        ImGui::PushItemWidth(column * 0.6F);
    };
    const auto end_column = [] {
        ImGui::PopItemWidth();
        ImGui::EndChild();
    };
    begin_column("controls");
    ShowNumbers(values);
    ShowSwitches(values, look);
    end_column();
    ImGui::SameLine();
    begin_column("lecture");
    ShowTheLecturesThings(values);
    ShowView(values);
    end_column();
    ImGui::SameLine();
    begin_column("matrices");
    ShowMatrices(values);
    end_column();
    ImGui::SameLine();
    begin_column("diagrams", 1.4F);
    ShowDiagramsDemo();
    ShowDepthDemo();
    end_column();
    ImGui::End();
}

}  // namespace widgets
