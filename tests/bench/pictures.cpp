// The counterpart of floor.cpp: draws many pictures in one process, with the sandbox's code for windows and snapshots.
//
// bench-pictures STATE N WxH read|png      N camera pictures, before each of which camera and light move a bit, read
//                                          back (png: also encoded); prints pictures per second and CPU milliseconds
//                                          per picture
// bench-pictures STATE N WxH window        N whole windows with every view redrawn, read back; prints the same numbers
// bench-pictures STATE N WxH flight        the same while the forward key is held; as in the window, large meshes are
//                                          then drawn coarsely
// bench-pictures STATE N WxH frame         prints medians of our thread's CPU milliseconds per window frame: for derive
//                                          and plan; for the user interface; for the whole frame with
//                                          GL_RASTERIZER_DISCARD, which draws nothing, and without draw calls; for the
//                                          same with draw calls (a software renderer then transforms the vertices on
//                                          our thread); and for the whole frame (the renderer then also sorts triangles
//                                          into tiles).
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <string>
#include <string_view>

#include "app/studio.h"
#include "gl/debug.h"
#include "gl/egl_context.h"
#include "gl/gl.h"
#include "image/png.h"
#include "platform/heap.h"
#include "ui_frame.h"

namespace {

using namespace viewing;
using bench::value_of;

double cpu_ms(clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Calls `picture` with 0, 1, 2 …; the first call is not timed.
void print_rate(int count, const std::function<void(int)>& picture) {
    picture(0);
    const auto begin = std::chrono::steady_clock::now();
    const double begin_cpu_ms = cpu_ms(CLOCK_PROCESS_CPUTIME_ID);
    for (int i = 1; i <= count; ++i) picture(i);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    std::printf("%.2f %.3f\n", count / seconds.count(), (cpu_ms(CLOCK_PROCESS_CPUTIME_ID) - begin_cpu_ms) / count);
}

double median_thread_ms(int count, const std::function<void(int)>& work) {
    for (int i = 0; i < 10; ++i) work(i);
    std::vector<double> spent;
    for (int i = 0; i < count; ++i) {
        const double begin = cpu_ms(CLOCK_THREAD_CPUTIME_ID);
        work(i);
        spent.push_back(cpu_ms(CLOCK_THREAD_CPUTIME_ID) - begin);
    }
    return median(std::move(spent));
}

void camera_pictures(Renderer& renderer, const LoadedState& state, int count, glm::ivec2 size_px, bool with_png) {
    const Scene scene = value_of(load_scene(state.params.scene, state.base, state.params.coplanar));
    const Viewport viewport{size_px, renderer.capabilities().clip_control};
    Params params = state.params;
    params.view.samples = 0;
    View view;
    std::size_t bytes = 0;
    print_rate(count, [&](int i) {
        bench::edit(params, i);
        value_of(renderer.draw(plan(params, derive(params, scene, viewport)), scene, size_px, view));
        const Image image = renderer.read(view);
        bytes += with_png ? encode_png(image).size() : image.rgba.size();
    });
    if (bytes == 0) throw std::runtime_error("empty pictures");
}

void windows(Renderer& renderer, const LoadedState& state, int count, glm::ivec2 size_px) {
    const Studio::Surroundings surroundings{.size_px = size_px, .input = {}};
    Studio studio(renderer, value_of(Session::make(state)));
    for (int i = 0; i < 10; ++i) studio.frame(surroundings);  // settles the window
    print_rate(count, [&](int i) {
        bench::edit(studio.session.params, i);
        studio.frame(surroundings);
        if (studio.read().rgba.empty()) throw std::runtime_error("empty pictures");
    });
}

/// Times a flight, except for its first four seconds, in which the window notices slow frames and makes a coarser mesh.
void flight(Renderer& renderer, const LoadedState& state, int count, glm::ivec2 size_px) {
    Studio::Surroundings surroundings{.size_px = size_px, .shows_time = true, .input = {}};
    surroundings.input.down[static_cast<std::size_t>(Key::w)] = true;
    Studio studio(renderer, value_of(Session::make(state)));
    const auto picture = [&](int i) {
        // Rotate back and forth, so that the picture keeps its content.
        surroundings.input.dt_s = 1.0 / 60.0;
        studio.session.params.camera.yaw += i % 2 == 0 ? 0.5 : -0.5;
        studio.frame(surroundings);
        if (studio.session.params.camera.position.z < 3.0)
            studio.session.params.camera.position = state.params.camera.position;
        if (studio.read().rgba.empty()) throw std::runtime_error("empty pictures");
    };
    const auto begin = std::chrono::steady_clock::now();
    for (int i = 0; std::chrono::steady_clock::now() - begin < std::chrono::seconds(4); ++i) picture(i);
    print_rate(count, picture);
}

double whole_frame_ms(
    Renderer& renderer, const LoadedState& state, int count, glm::ivec2 size_px,
    const std::function<void()>& before_painting = [] {}) {
    const Studio::Surroundings surroundings{.size_px = size_px, .input = {}};
    Studio studio(renderer, value_of(Session::make(state)));
    return median_thread_ms(count, [&](int i) {
        bench::edit(studio.session.params, i);
        studio.frame(surroundings);
        before_painting();
        studio.paint();
    });
}

void draw_nothing(GLenum, GLsizei, GLenum, const void*) {}

/// Makes Dear ImGui draw no triangles: it has its own loader of GL functions, so its draw calls cannot be replaced.
void empty_interface() {
    const ImDrawData& data = *ImGui::GetDrawData();
    for (int list = 0; list < data.CmdListsCount; ++list)
        for (ImDrawCmd& command : data.CmdLists[list]->CmdBuffer) command.ElemCount = 0;
}

void frame_parts(Renderer& renderer, const LoadedState& state, int count, glm::ivec2 size_px) {
    glEnable(GL_RASTERIZER_DISCARD);
    const auto draw = epoxy_glDrawElements;
    epoxy_glDrawElements = draw_nothing;
    const double calls_ms = whole_frame_ms(renderer, state, count, size_px, empty_interface);
    epoxy_glDrawElements = draw;
    const double submit_ms = whole_frame_ms(renderer, state, count, size_px);
    glDisable(GL_RASTERIZER_DISCARD);
    const double whole_ms = whole_frame_ms(renderer, state, count, size_px);
    bench::UiFrame ui(state, size_px);
    const auto numbers = [&](int i) {
        bench::edit(ui.session().params, i);
        ui.derive_and_plan();
    };
    const double numbers_ms = median_thread_ms(count, numbers);
    const double both_ms = median_thread_ms(count, [&](int i) {
        numbers(i);
        ui.draw();
    });
    std::printf("%.4f %.4f %.4f %.4f %.4f\n", numbers_ms, both_ms - numbers_ms, calls_ms, submit_ms, whole_ms);
}

void run(const std::string& state_name, int count, glm::ivec2 size_px, std::string_view mode) {
    const gl::EglContext context = value_of(gl::EglContext::make());
    gl::DebugLog log;
    Renderer renderer = value_of(Renderer::make());
    const LoadedState state = value_of(load_state(state_name));
    if (mode == "window") {
        windows(renderer, state, count, size_px);
    } else if (mode == "flight") {
        flight(renderer, state, count, size_px);
    } else if (mode == "frame") {
        frame_parts(renderer, state, count, size_px);
    } else {
        camera_pictures(renderer, state, count, size_px, mode == "png");
    }
    for (const std::string& error : log.errors()) throw std::runtime_error("GL: " + error);
}

}  // namespace

int main(int argc, char** argv) try {
    viewing::reserve_heap();  // as the program does
    glm::ivec2 size_px{0};
    const std::string_view mode = argc == 5 ? argv[4] : "";
    if ((mode != "read" && mode != "png" && mode != "window" && mode != "flight" && mode != "frame") ||
        std::atoi(argv[2]) < 1 || std::sscanf(argv[3], "%dx%d", &size_px.x, &size_px.y) != 2) {
        std::fputs("usage: bench-pictures STATE N WxH read|png|window|flight|frame\n", stderr);
        return 2;
    }
    run(argv[1], std::atoi(argv[2]), size_px, mode);
} catch (const std::exception& error) {
    std::fprintf(stderr, "bench-pictures: %s\n", error.what());
    return 1;
}
