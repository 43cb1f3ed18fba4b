// C++ and GLSL agree: the tables of uniforms match the programs as the driver sees them, constants are defined on one
// side only, and all programs also compile as GLSL ES 3.00 for WebGL 2 and draw the same.
#include <dlfcn.h>
#include <epoxy/egl.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <regex>
#include <sstream>

#include "gl_test.h"
#include "render/programs.h"
#include "render/shader_constants.h"
#include "state/presets.h"

namespace viewing {
namespace {

using testing::params_with;
using testing::scene_named;

constexpr Shading all_shadings[] = {Shading::lit,  Shading::unlit,    Shading::flat,     Shading::facing,
                                    Shading::heat, Shading::caster_w, Shading::identity, Shading::polygon_identity};

/// Returns programs of every kind: plain ones, and ones with all the features that can be combined.
std::vector<SurfaceKind> surface_kinds() {
    using Source = SurfaceKind::Source;
    std::vector<SurfaceKind> kinds;
    for (const Source source : {Source::object, Source::vertices, Source::picture}) {
        for (const Shading shading : all_shadings) {
            if (shading == Shading::polygon_identity && source != Source::vertices) continue;
            SurfaceKind kind{.shading = shading, .source = source, .lights = shading == Shading::lit ? 1U : 0U};
            kind.write_depth = source == Source::picture;  // the picture's depths can only come from the shader
            kinds.push_back(kind);
            kind.clips = kind.mask_test = kind.mask_write = true;
            kind.write_depth = true;
            kind.logarithm_per_vertex = kind.forces_sign = source != Source::picture;
            kinds.push_back(kind);
        }
    }
    kinds.push_back({.shading = Shading::flat, .clips = true, .write_depth = true, .depth_of_plane = true});
    kinds.push_back({.shading = Shading::unlit, .is_patch = true});
    for (std::size_t lights = 1; lights <= most_lights; ++lights)
        for (const bool has_gloss : {false, true})
            kinds.push_back({.is_patch = true, .lights = lights, .has_gloss = has_gloss});
    return kinds;
}

/// The active uniforms found in a program, by name, with their sizes.
using Found = std::map<std::string, GLint>;

/// Compares a linked program, or one of its separate stages, with the program's table of uniforms.
void expect_agreement(const ShaderProgram& program, GLuint part, Found& found) {
    const GLuint stage = program.programs().size() > 1 ? part : 0;
    GLint active = 0;
    glGetProgramiv(part, GL_ACTIVE_UNIFORMS, &active);
    for (GLint index = 0; index < active; ++index) {
        char text[80] = {};
        GLint size = 0;
        GLenum type = 0;
        glGetActiveUniform(part, static_cast<GLuint>(index), sizeof text, nullptr, &size, &type, text);
        const std::string name(text, std::string_view(text).substr(0, std::string_view(text).find('[')).size());
        const auto entry = std::find_if(program.uniforms().begin(), program.uniforms().end(),
                                        [&](const UniformEntry& each) { return each.name == name; });
        ASSERT_NE(entry, program.uniforms().end()) << name << " is missing from the table";
        EXPECT_EQ(entry->type, type) << name;
        EXPECT_LE(size, entry->count) << name;
        EXPECT_EQ(entry->place->location, glGetUniformLocation(part, text)) << name;
        EXPECT_EQ(entry->place->stage, stage) << name << " is in both stages, or listed for the wrong one";
        found[name] = std::max(found[name], size);
    }
}

void expect_agreement(const ShaderProgram& program, Found& found) {
    for (const GLuint part : program.programs()) expect_agreement(program, part, found);
}

void expect_all_found(const ShaderProgram& program, const Found& found) {
    for (const UniformEntry& entry : program.uniforms()) {
        ASSERT_TRUE(found.count(entry.name)) << entry.name << " is active in no program";
        EXPECT_EQ(found.at(entry.name), entry.count) << entry.name;
    }
}

template <typename Program>
void expect_table(const Result<const Program*>& program) {
    ASSERT_TRUE(program) << program.error();
    Found found;
    expect_agreement(**program, found);
    expect_all_found(**program, found);
}

void expect_all_tables(Programs& programs) {
    Found found;
    const ShaderProgram* last = nullptr;
    for (const SurfaceKind& kind : surface_kinds()) {
        SCOPED_TRACE("shading " + std::to_string(static_cast<int>(kind.shading)) + ", source " +
                     std::to_string(static_cast<int>(kind.source)));
        const Result<const SurfaceProgram*> program = programs.surface(kind);
        ASSERT_TRUE(program) << program.error();
        expect_agreement(**program, found);
        last = *program;
    }
    expect_all_found(*last, found);
    expect_table(programs.show_depth());
    expect_table(programs.show_stencil());
    expect_table(programs.show_overdraw());
    expect_table(programs.show_picture());
    expect_table(programs.read_depth());
    expect_table(programs.constant());
    expect_table(programs.fill());
}

class ProgramTables : public testing::GlTest {};

TEST_F(ProgramTables, MatchTheDriver) {
    const gl::Capabilities all = renderer().capabilities();
    for (const bool clip_distance : {true, false}) {
        for (const bool shared_stages : {true, false}) {
            gl::Capabilities capabilities = all;
            capabilities.clip_distance = clip_distance;
            capabilities.shared_stages = shared_stages && all.shared_stages;
            Programs programs(capabilities);
            expect_all_tables(programs);
        }
    }
}

/// Returns the source of each shader, without its comments.
std::map<std::string, std::string> shader_texts() {
    std::map<std::string, std::string> texts;
    const std::filesystem::path folder = std::filesystem::path(std::getenv("TEST_SOURCE_DIR")) / "../shaders";
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        std::ostringstream text;
        text << std::ifstream(entry.path()).rdbuf();
        texts[entry.path().filename().string()] = std::regex_replace(text.str(), std::regex("//[^\n]*"), "");
    }
    return texts;
}

TEST(ShaderConstants, AppearInNoShaderAndAllAreUsed) {
    std::set<std::string> known, families, used;
    for (const ShaderConstant& each : shader_constants()) {
        EXPECT_TRUE(known.insert(each.name).second) << each.name;
        const std::string name(each.name);
        if (name.find('_') != std::string::npos) families.insert(name.substr(0, name.find('_') + 1));
    }
    for (const auto& [file, text] : shader_texts()) {
        EXPECT_FALSE(std::regex_search(text, std::regex("#define +[A-Z_]+ +[0-9]"))) << file;
        EXPECT_EQ(text.find("#version"), std::string::npos) << file;
        EXPECT_FALSE(std::regex_search(text, std::regex("\\bprecision\\b"))) << file;
        const std::regex words("\\b[A-Z]+(_[A-Z]+)*\\b");
        for (std::sregex_iterator word(text.begin(), text.end(), words), end; word != end; ++word) {
            const std::string name = word->str();
            if (known.count(name)) used.insert(name);
            const bool is_of_family = families.count(name.substr(0, name.find('_') + 1)) != 0;
            const bool is_flag = name == "CLIP_DISTANCE" || name == "CLIP_BY_DISCARD";
            EXPECT_TRUE(known.count(name) || !is_of_family || is_flag) << file << ": " << name;
        }
    }
    EXPECT_EQ(used, known);
}

/// An OpenGL ES 3.0 context without a surface, current during its lifetime. If it is unavailable, trouble() says why.
class EsContext {
public:
    EsContext() {
        // The GL loader terminates the program if it finds no entry points of GL ES.
        if (!library_) return;
        display_ = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
        if (display_ == EGL_NO_DISPLAY || !eglInitialize(display_, nullptr, nullptr)) return;
        eglBindAPI(EGL_OPENGL_ES_API);
        const EGLint wish[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 0, EGL_NONE};
        context_ = eglCreateContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wish);
        if (context_ != EGL_NO_CONTEXT) eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_);
    }
    EsContext(const EsContext&) = delete;
    EsContext& operator=(const EsContext&) = delete;
    ~EsContext() {
        if (context_ == EGL_NO_CONTEXT) return;
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display_, context_);
        eglBindAPI(EGL_OPENGL_API);
    }
    /// Returns why there is no context; "" if there is one.
    const char* trouble() const {
        if (!library_) return "no libGLESv2.so.2 (Debian's package libgles2)";
        return context_ == EGL_NO_CONTEXT ? "no OpenGL ES 3.0 context from EGL" : "";
    }

private:
    struct CloseLibrary {
        void operator()(void* library) const { dlclose(library); }
    };
    std::unique_ptr<void, CloseLibrary> library_{dlopen("libGLESv2.so.2", RTLD_LAZY)};
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
};

/// Returns the number of programs in this context.
int program_count() {
    constexpr GLuint beyond_all_names = 5000;
    int count = 0;
    for (GLuint name = 1; name < beyond_all_names; ++name) count += glIsProgram(name) == GL_TRUE;
    return count;
}

/// Returns the number of programs that a new renderer makes to draw one picture.
int programs_for(const Params& params, const Scene& scene, const gl::Capabilities& capabilities) {
    const int before = program_count();
    Result<Renderer> made = Renderer::make(capabilities);
    EXPECT_TRUE(made) << made.error();
    Renderer renderer = *std::move(made);
    View view;
    constexpr glm::ivec2 size_px(64, 36);
    EXPECT_TRUE(renderer.draw(plan(params, derive(params, scene, {size_px, false})), scene, size_px, view));
    return program_count() - before;
}

class ProgramCount : public testing::GlTest {};

/// Five passes share three programs: masks and shadows, the patch, and lit surfaces, which the mirror reuses. A plane
/// that clips its image and its shadow adds two. With shared stages, each of these is a fragment stage; one vertex
/// stage serves all programs without clipping, and another serves all programs with clipping.
TEST_F(ProgramCount, MatchesThePicture) {
    gl::Capabilities capabilities = renderer().capabilities();
    const Scene whole = scene_named("torus-and-boxes");
    Scene cut = whole;
    cut.objects.back().world_from_model[3].y -= 0.1;
    if (capabilities.shared_stages) {
        EXPECT_EQ(programs_for(Params{}, whole, capabilities), 3 + 1);
        EXPECT_EQ(programs_for(Params{}, cut, capabilities), 5 + 2);
    }
    capabilities.shared_stages = false;
    EXPECT_EQ(programs_for(Params{}, whole, capabilities), 3);
    EXPECT_EQ(programs_for(Params{}, cut, capabilities), 5);
}

class SharedStages : public testing::GlTest {};

std::size_t differing_pixels(const Image& a, const Image& b) {
    EXPECT_EQ(a.rgba.size(), b.rgba.size());
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.rgba.size(); i += 4)
        count += !std::equal(&a.rgba[i], &a.rgba[i] + 4, &b.rgba[i]) ? 1U : 0U;
    return count;
}

/// Allows a few different pixels: since version 23, Mesa optimizes whole programs more aggressively when
/// it links them, which changes the rounding at edges and in depth fighting.
TEST_F(SharedStages, EqualWholeProgramsInEveryPreset) {
    if (!renderer().capabilities().shared_stages) GTEST_SKIP() << "only whole programs are available here";
    gl::Capabilities capabilities = renderer().capabilities();
    capabilities.shared_stages = false;
    Result<Renderer> whole = Renderer::make(capabilities);
    ASSERT_TRUE(whole) << whole.error();
    constexpr glm::ivec2 size_px(128, 72);
    for (const NamedFile& preset : presets()) {
        auto [params, scene] = testing::preset_named(preset.name);
        params.view.samples = 0;
        const FramePlan frame = plan(params, derive_for(params, scene, size_px));
        View of_stages, of_whole;
        const std::string_view version = reinterpret_cast<const char*>(glGetString(GL_VERSION));
        const std::size_t most = version.find("Mesa 22") != std::string_view::npos ? 0 : 45;
        const Image one = draw(frame, scene, size_px, renderer(), of_stages);
        EXPECT_LE(differing_pixels(one, draw(frame, scene, size_px, *whole, of_whole)), most) << preset.name;
    }
}

TEST(ProgramsInEs, CompileWithTheSameTables) {
    const EsContext context;
    if (*context.trouble()) GTEST_SKIP() << "skipped: " << context.trouble();
    ASSERT_FALSE(epoxy_is_desktop_gl());
    Programs programs(gl::Capabilities::of_current_context());
    expect_all_tables(programs);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

/// Returns pictures of the opening scene, drawn in the current context with only the features that GL and GL ES share.
std::vector<Image> pictures_in_common() {
    Result<Renderer> renderer = Renderer::make(gl::Capabilities{});
    EXPECT_TRUE(renderer) << renderer.error();
    const Scene scene = scene_named("torus-and-boxes");
    constexpr glm::ivec2 size_px(96, 54);
    std::vector<Image> pictures;
    for (const std::vector<std::string>& settings : {std::vector<std::string>{},
                                                     {"depth.format=d16", "shadow.style=missing_light"},
                                                     {"depth.format=d8", "depth.mapping=reversed"},
                                                     {"view.shows=depth"},
                                                     {"view.shows=stencil"}}) {
        const Params params = params_with(settings);
        View view;
        const Status drawn =
            renderer->draw(plan(params, derive(params, scene, {size_px, false})), scene, size_px, view);
        EXPECT_TRUE(drawn) << drawn.error();
        pictures.push_back(renderer->read(view));
    }
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    return pictures;
}

TEST(ProgramsInEs, DrawTheSamePicturesAsGl) {
    std::vector<Image> in_es;
    {
        const EsContext context;
        if (*context.trouble()) GTEST_SKIP() << "skipped: " << context.trouble();
        in_es = pictures_in_common();
    }
    const Result<gl::EglContext> context = gl::EglContext::make();
    ASSERT_TRUE(context) << context.error();
    const std::vector<Image> in_gl = pictures_in_common();
    ASSERT_EQ(in_es.size(), in_gl.size());
    for (std::size_t index = 0; index < in_gl.size(); ++index)
        EXPECT_EQ(testing::pixels_beyond(in_es[index], in_gl[index], 1), 0) << index;
}

}  // namespace
}  // namespace viewing
