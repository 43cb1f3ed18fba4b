// widgets-demo [dark|light|projector] [SCALE]: a window with every widget. show_demo.cpp fills it.
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <GLFW/glfw3.h>

#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "widgets/demo/show_demo.h"
#include "widgets/widgets.h"

namespace {

constexpr const char* text_file = "/usr/share/fonts/opentype/inter/Inter-Regular.otf";
constexpr const char* heading_file = "/usr/share/fonts/opentype/inter/Inter-SemiBold.otf";
constexpr const char* number_file = "/usr/share/fonts/truetype/jetbrains-mono/JetBrainsMono-Regular.ttf";
constexpr const char* signs_file = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";

/// Loads a font at a size in pixels and adds the math signs that it lacks. Returns ImGui's own font if the file is
/// missing.
ImFont* LoadFont(const char* file, float size_px) {
    static constexpr ImWchar latin[] = {0x20, 0xFF, 0x2013, 0x2026, 0x2212, 0x2212, 0};
    static constexpr ImWchar signs[] = {0x370,  0x3FF,  0x1D40, 0x1D40, 0x2070, 0x209C,
                                        0x2190, 0x21FF, 0x2200, 0x22FF, 0};
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    std::FILE* readable = std::fopen(file, "rb");
    if (!readable) return atlas.AddFontDefault();
    std::fclose(readable);
    ImFont* font = atlas.AddFontFromFileTTF(file, size_px, nullptr, latin);
    if (std::FILE* also_readable = std::fopen(signs_file, "rb")) {
        std::fclose(also_readable);
        ImFontConfig merged;
        merged.MergeMode = true;
        atlas.AddFontFromFileTTF(signs_file, size_px * 0.9F, &merged, signs);
    }
    return font;
}

void ApplyLook(const widgets::DemoLook& look, widgets::Context& context) {
    context.palette = widgets::palette_of(look.theme);
    context.scale = look.scale;
    const float type = look.scale * context.palette.type_scale;
    ImGui::GetIO().Fonts->Clear();
    context.fonts.text = LoadFont(text_file, 16.0F * type);
    context.fonts.heading = LoadFont(heading_file, 16.0F * type);
    context.fonts.note = LoadFont(text_file, 13.0F * type);
    context.fonts.number = LoadFont(number_file, 16.0F * type);
    context.fonts.small_number = LoadFont(number_file, 13.0F * type);
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
    widgets::ApplyStyle(context);
}

widgets::DemoLook LookFromArguments(int count, char** arguments) {
    widgets::DemoLook look;
    for (int i = 1; i < count; ++i) {
        const std::string_view argument = arguments[i];
        if (argument == "light")
            look.theme = widgets::ThemeKind::light;
        else if (argument == "projector")
            look.theme = widgets::ThemeKind::projector;
        else if (const double scale = std::atof(arguments[i]); scale > 0.0)
            look.scale = static_cast<float>(scale);
    }
    return look;
}

GLFWwindow* OpenWindow(float scale) {
    if (!glfwInit()) return nullptr;
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    const int width = static_cast<int>(1600 * scale), height = static_cast<int>(840 * scale);
    GLFWwindow* window = glfwCreateWindow(width, height, "Widgets", nullptr, nullptr);
    if (window) glfwMakeContextCurrent(window);
    return window;
}

}  // namespace

int main(int argument_count, char** arguments) {
    widgets::DemoLook look = LookFromArguments(argument_count, arguments);
    GLFWwindow* window = OpenWindow(look.scale);
    if (!window) {
        std::fputs("widgets-demo: no window could be opened; it needs a display and OpenGL 3.3\n", stderr);
        return EXIT_FAILURE;
    }
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    ImGui_ImplGlfw_InitForOpenGL(window, true);
    ImGui_ImplOpenGL3_Init("#version 330");
    ImGui_ImplOpenGL3_NewFrame();

    widgets::Context context;
    ApplyLook(look, context);
    constexpr int frames_to_settle = 3;  // ImGui draws each frame with the layout of the previous one
    int frames_left = frames_to_settle;
    while (!glfwWindowShouldClose(window)) {
        const float wait_s = frames_left > 0 ? 0.0F : widgets::RedrawIn(context);
        if (wait_s < 0.0F)
            glfwWaitEvents();
        else if (wait_s > 0.0F)
            glfwWaitEventsTimeout(wait_s);
        else
            glfwPollEvents();
        frames_left = frames_left > 0 ? frames_left - 1 : wait_s != 0.0F ? frames_to_settle : 0;

        ImGui_ImplOpenGL3_NewFrame();
        ImGui_ImplGlfw_NewFrame();
        ImGui::NewFrame();
        widgets::NewFrame(context);
        const widgets::DemoLook before = look;
        widgets::ShowWidgetsDemo(look);
        ImGui::Render();
        ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
        glfwSwapBuffers(window);
        if (look.theme != before.theme || look.scale != before.scale) {
            ApplyLook(look, context);
            glfwPostEmptyEvent();
        }
    }
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
    glfwDestroyWindow(window);
    glfwTerminate();
}
