// The floor: the least work with which a program can draw one lit mesh. It uses a bare EGL context on a software
// device, a torus, its own framebuffer, a readback and libpng. It deliberately shares no code with the sandbox, so any
// cost beyond this floor is the sandbox's own.
//
// bench-floor OUT.png [MESH.obj]
//     draws one 1280 × 720 picture, like those of `viewing-sandbox snapshot`. It shows MESH.obj if given, read by
//     tinyobjloader; each corner there must use the same index for position and normal
// bench-floor --count N WxH read|png [shaded|dense]
//     draws N pictures in one process, each rotated a bit more, and reads them back (png: also encodes them); prints
//     pictures per second and CPU milliseconds per picture. shaded: uses the sandbox's shading (two-sided, sky light,
//     highlight, sRGB) instead of one Lambert term. dense: uses a torus of 79,524 triangles
#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <png.h>
#include <tiny_obj_loader.h>

#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string_view>
#include <vector>

namespace {

int width = 1280;
int height = 720;
constexpr double pi = 3.14159265358979323846;

void require(bool fine, const char* what) {
    if (fine) return;
    std::fprintf(stderr, "bench-floor: %s failed\n", what);
    std::exit(3);
}

/// Returns the display of the EGL device that reports software rendering, or else a surfaceless one with software
/// rendering forced.
EGLDisplay software_display() {
    std::array<EGLDeviceEXT, 16> devices{};
    EGLint count = 0;
    if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_device") &&
        eglQueryDevicesEXT(static_cast<EGLint>(devices.size()), devices.data(), &count) != EGL_FALSE) {
        for (EGLint i = 0; i < count; ++i) {
            const char* extensions = eglQueryDeviceStringEXT(devices[static_cast<std::size_t>(i)], EGL_EXTENSIONS);
            if (extensions != nullptr &&
                std::string_view(extensions).find("EGL_MESA_device_software") != std::string_view::npos)
                return eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[static_cast<std::size_t>(i)], nullptr);
        }
    }
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    return eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
}

void make_context_current() {
    const EGLDisplay display = software_display();
    require(eglInitialize(display, nullptr, nullptr) != EGL_FALSE, "eglInitialize");
    require(eglBindAPI(EGL_OPENGL_API) != EGL_FALSE, "eglBindAPI");
    constexpr std::array<EGLint, 7> attributes{
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes.data());
    require(context != EGL_NO_CONTEXT, "eglCreateContext");
    require(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) != EGL_FALSE, "eglMakeCurrent");
}

GLuint compiled(GLenum stage, const char* source) {
    const GLuint shader = glCreateShader(stage);
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    GLint fine = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &fine);
    require(fine != 0, "glCompileShader");
    return shader;
}

constexpr const char* lambert_source = R"(#version 330 core
in vec3 position_view;
in vec3 normal_view;
out vec4 color;
void main() {
    float lambert = max(dot(normalize(normal_view), normalize(vec3(0.4, 0.8, 0.5))), 0.0);
    color = vec4(vec3(0.35, 0.62, 0.94) * (0.2 + 0.8 * lambert), 1);
})";

/// The sandbox's shading does not count as overhead, so this shader computes the same terms in their simplest form.
constexpr const char* shaded_source = R"(#version 330 core
in vec3 position_view;
in vec3 normal_view;
out vec4 color;
void main() {
    vec3 eye = normalize(-position_view), light = normalize(vec3(0.4, 0.8, 0.5)), normal = normalize(normal_view);
    vec3 facet = cross(dFdx(position_view), dFdy(position_view));
    if (dot(facet, eye) * dot(facet, normal) < 0.0) normal = -normal;
    vec3 albedo = vec3(0.10, 0.34, 0.87);
    float lambert = max(dot(normal, light), 0.0);
    vec3 sum = albedo * (0.23 + 0.07 * normal.y + 0.78 * lambert);
    if (lambert > 0.0) sum += 0.16 * pow(max(dot(normal, normalize(light + eye)), 0.0), 48.0);
    vec3 curve = 1.055 * pow(sum, vec3(1.0 / 2.4)) - 0.055;
    color = vec4(mix(12.92 * sum, curve, greaterThan(sum, vec3(0.0031308))), 1);
})";

/// Uses a program with one directional light; its vertex shader rotates the torus by `turn`, moves it back and projects
/// it with a fovy of 40°.
void use_program(const char* fragment_source) {
    const GLuint program = glCreateProgram();
    glAttachShader(program, compiled(GL_VERTEX_SHADER, R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform float turn;
uniform float aspect;
out vec3 position_view;
out vec3 normal_view;
void main() {
    mat3 tilt = mat3(1, 0, 0, 0, cos(turn), sin(turn), 0, -sin(turn), cos(turn));
    vec3 p = tilt * position + vec3(0, 0, -4);
    position_view = p;
    normal_view = tilt * normal;
    float f = 2.747, near = 0.5, far = 40.0;
    gl_Position = vec4(f / aspect * p.x, f * p.y, (far + near) / (near - far) * p.z + 2.0 * far * near / (near - far), -p.z);
})"));
    glAttachShader(program, compiled(GL_FRAGMENT_SHADER, fragment_source));
    glLinkProgram(program);
    GLint fine = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &fine);
    require(fine != 0, "glLinkProgram");
    glUseProgram(program);
}

/// Uploads interleaved positions and normals with their indices; returns the number of indices.
GLsizei upload(const std::vector<float>& vertices, const std::vector<std::uint32_t>& indices) {
    GLuint array = 0;
    std::array<GLuint, 2> buffers{};
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    glGenBuffers(2, buffers.data());
    glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(float)), vertices.data(),
                 GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint32_t)),
                 indices.data(), GL_STATIC_DRAW);
    for (GLuint attribute = 0; attribute < 2; ++attribute) {
        glEnableVertexAttribArray(attribute);
        glVertexAttribPointer(attribute, 3, GL_FLOAT, GL_FALSE, 6 * sizeof(float),
                              reinterpret_cast<const void*>(attribute * 3 * sizeof(float)));
    }
    return static_cast<GLsizei>(indices.size());
}

GLsizei upload_file(const char* path) {
    tinyobj::ObjReader reader;
    require(reader.ParseFromFile(path), "reading the mesh");
    const tinyobj::attrib_t& read = reader.GetAttrib();
    require(read.normals.size() == read.vertices.size(), "a normal for each position");
    std::vector<float> vertices;
    for (std::size_t i = 0; i < read.vertices.size(); i += 3) {
        vertices.insert(vertices.end(), &read.vertices[i], &read.vertices[i] + 3);
        vertices.insert(vertices.end(), &read.normals[i], &read.normals[i] + 3);
    }
    std::vector<std::uint32_t> indices;
    for (const tinyobj::shape_t& shape : reader.GetShapes())
        for (const tinyobj::index_t& corner : shape.mesh.indices)
            indices.push_back(static_cast<std::uint32_t>(corner.vertex_index));
    return upload(vertices, indices);
}

/// Uploads a torus (radii 0.9 and 0.34) of around × across quads; returns the number of indices.
GLsizei upload_torus(std::uint32_t around, std::uint32_t across) {
    std::vector<float> vertices;
    std::vector<std::uint32_t> indices;
    for (std::uint32_t i = 0; i <= around; ++i) {
        for (std::uint32_t j = 0; j <= across; ++j) {
            const double u = 2 * pi * i / around;
            const double v = 2 * pi * j / across;
            const double ring = 0.9 + 0.34 * std::cos(v);
            for (const double value : {ring * std::cos(u), 0.34 * std::sin(v), -ring * std::sin(u),
                                       std::cos(v) * std::cos(u), std::sin(v), -std::cos(v) * std::sin(u)})
                vertices.push_back(static_cast<float>(value));
        }
    }
    for (std::uint32_t i = 0; i < around; ++i) {
        for (std::uint32_t j = 0; j < across; ++j) {
            const std::uint32_t first = i * (across + 1) + j;
            const std::uint32_t next = first + across + 1;
            for (const std::uint32_t index : {first, next, next + 1, first, next + 1, first + 1})
                indices.push_back(index);
        }
    }
    return upload(vertices, indices);
}

void bind_target() {
    std::array<GLuint, 2> buffers{};
    GLuint framebuffer = 0;
    glGenRenderbuffers(2, buffers.data());
    glBindRenderbuffer(GL_RENDERBUFFER, buffers[0]);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width, height);
    glBindRenderbuffer(GL_RENDERBUFFER, buffers[1]);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, width, height);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, buffers[0]);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, buffers[1]);
    require(glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE, "the framebuffer");
    glViewport(0, 0, width, height);
    glEnable(GL_DEPTH_TEST);
    glClearColor(0.11F, 0.13F, 0.16F, 1.0F);
}

void draw(GLint turn_location, GLsizei index_count, float turn, std::vector<std::uint8_t>& rgba) {
    glUniform1f(turn_location, turn);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glDrawElements(GL_TRIANGLES, index_count, GL_UNSIGNED_INT, nullptr);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
}

/// Writes RGB with libpng: level 1, only the SUB filter, rows from the bottom up as in GL.
void write_png(std::FILE* file, const std::vector<std::uint8_t>& rgba) {
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, file);
    png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), 8, PNG_COLOR_TYPE_RGB,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_compression_level(png, 1);
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
    png_write_info(png, info);
    png_set_filler(png, 0, PNG_FILLER_AFTER);
    const auto row_bytes = static_cast<std::size_t>(width) * 4;
    for (auto y = static_cast<std::size_t>(height); y-- > 0;) png_write_row(png, rgba.data() + y * row_bytes);
    png_write_end(png, nullptr);
    png_destroy_write_struct(&png, &info);
}

double cpu_ms() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

}  // namespace

int main(int argc, char** argv) {
    const bool shaded = argc == 6 && std::string_view(argv[5]) == "shaded";
    const bool dense = argc == 6 && std::string_view(argv[5]) == "dense";
    const bool many = (argc == 5 || shaded || dense) && std::string_view(argv[1]) == "--count" &&
                      std::sscanf(argv[3], "%dx%d", &width, &height) == 2;
    if (!many && argc != 2 && argc != 3) {
        std::fputs("usage: bench-floor OUT.png [MESH.obj] | bench-floor --count N WxH read|png [shaded|dense]\n",
                   stderr);
        return 2;
    }
    const int count = many ? std::atoi(argv[2]) : 1;
    const bool with_png = !many || std::string_view(argv[4]) == "png";

    make_context_current();
    use_program(shaded ? shaded_source : lambert_source);
    const GLsizei index_count = !many && argc == 3 ? upload_file(argv[2])
                                : dense            ? upload_torus(282, 141)  // 79,524 triangles
                                                   : upload_torus(64, 32);              // 4,096
    bind_target();
    GLint program = 0;
    glGetIntegerv(GL_CURRENT_PROGRAM, &program);
    const GLint turn_location = glGetUniformLocation(static_cast<GLuint>(program), "turn");
    glUniform1f(glGetUniformLocation(static_cast<GLuint>(program), "aspect"),
                static_cast<float>(width) / static_cast<float>(height));
    std::vector<std::uint8_t> rgba(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);

    std::FILE* file = std::fopen(many ? "/dev/null" : argv[1], "wb");
    require(file != nullptr, "opening the output");
    if (many) draw(turn_location, index_count, 0.5F, rgba);
    const auto begin = std::chrono::steady_clock::now();
    const double begin_cpu_ms = cpu_ms();
    for (int i = 0; i < count; ++i) {
        draw(turn_location, index_count, 0.5F + 0.01F * static_cast<float>(i), rgba);
        if (with_png) write_png(file, rgba);
    }
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    const double spent_cpu_ms = cpu_ms() - begin_cpu_ms;
    require(std::fclose(file) == 0, "writing the output");
    require(glGetError() == GL_NO_ERROR, "GL");
    if (many) std::printf("%.2f %.3f\n", count / seconds.count(), spent_cpu_ms / count);
}
