// Benchmarks of parts of our own code in one process. ratios.cpp compares the whole program with a minimal one.
#include <benchmark/benchmark.h>

#include <cmath>
#include <random>

#include "image/compare.h"
#include "image/png.h"
#include "state/file/state_json.h"
#include "ui_frame.h"

namespace viewing {
namespace {

constexpr int width = 1280;
constexpr int height = 720;

/// Makes an image like a rendered scene: a plain background, a shaded ball, a checkered floor.
Image picture() {
    Image image{width, height, {}};
    image.rgba.resize(image.row_bytes() * height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const double radius = std::hypot(x - 640, y - 300);
            const bool light_tile = (x / 40 + y / 20) % 2 == 0;
            const int level = radius < 250 ? static_cast<int>(250 - 0.8 * radius)
                              : y < 400    ? 24
                              : light_tile ? 120
                                           : 90;
            std::uint8_t* pixel = image.pixel(x, y);
            pixel[0] = static_cast<std::uint8_t>(level);
            pixel[1] = static_cast<std::uint8_t>(level * 3 / 4);
            pixel[2] = static_cast<std::uint8_t>(level / 2);
            pixel[3] = 255;
        }
    }
    return image;
}

/// Makes an image of random bytes: no row equals picture()'s, and nearly every pixel differs beyond the threshold.
Image noise() {
    std::mt19937 random(1);
    Image image = picture();
    for (auto& byte : image.rgba) byte = static_cast<std::uint8_t>(random());
    return image;
}

/// Makes an image with a dot every 18 pixels, for which the comparison finds the maximum number of boxes.
Image dotted() {
    Image image = picture();
    for (int y = 0; y < height; y += 18)
        for (int x = 0; x < width; x += 18) image.pixel(x, y)[0] ^= 0x80;
    return image;
}

void compare_with(benchmark::State& state, const Image& other) {
    const Image image = picture();
    for (auto _ : state) benchmark::DoNotOptimize(compare_images(image, other));
}
BENCHMARK_CAPTURE(compare_with, equal, picture())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(compare_with, noise, noise())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(compare_with, dots, dotted())->Unit(benchmark::kMillisecond);

void diff(benchmark::State& state) {
    const Image image = picture();
    const Image other = noise();
    for (auto _ : state) benchmark::DoNotOptimize(diff_picture(image, other));
}
BENCHMARK(diff)->Unit(benchmark::kMillisecond);

void png(benchmark::State& state) {
    const Image image = picture();
    for (auto _ : state) benchmark::DoNotOptimize(encode_png(image));
    state.counters["bytes"] = static_cast<double>(encode_png(image).size());
}
BENCHMARK(png)->Unit(benchmark::kMillisecond);

LoadedState opening() {
    return bench::value_of(load_state("opening"));
}

void derive_numbers(benchmark::State& state) {
    const LoadedState loaded = opening();
    const Scene scene = bench::value_of(load_scene(loaded.params.scene, loaded.base, loaded.params.coplanar));
    for (auto _ : state) benchmark::DoNotOptimize(derive(loaded.params, scene, Viewport{{width, height}, true}));
}
BENCHMARK(derive_numbers)->Unit(benchmark::kMicrosecond);

void plan_passes(benchmark::State& state) {
    const LoadedState loaded = opening();
    const Scene scene = bench::value_of(load_scene(loaded.params.scene, loaded.base, loaded.params.coplanar));
    const Derived derived = derive(loaded.params, scene, Viewport{{width, height}, true});
    for (auto _ : state) benchmark::DoNotOptimize(plan(loaded.params, derived));
}
BENCHMARK(plan_passes)->Unit(benchmark::kMicrosecond);

void parse(benchmark::State& state) {
    const std::string text = write_state(Params{});
    for (auto _ : state) benchmark::DoNotOptimize(parse_state(text, "state.json"));
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(text.size()));
}
BENCHMARK(parse)->Unit(benchmark::kMicrosecond);

void write(benchmark::State& state) {
    const Params params;
    for (auto _ : state) benchmark::DoNotOptimize(write_state(params));
}
BENCHMARK(write)->Unit(benchmark::kMicrosecond);

/// Runs derive, plan and the whole user interface after an edit of camera and light.
void ui_frame(benchmark::State& state) {
    bench::UiFrame frame(opening(), {static_cast<int>(state.range(0)), static_cast<int>(state.range(1))});
    int step = 0;
    for (auto _ : state) {
        bench::edit(frame.session().params, step++);
        frame.derive_and_plan();
        frame.draw();
    }
}
BENCHMARK(ui_frame)->Args({1280, 720})->Args({1600, 900})->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace viewing
