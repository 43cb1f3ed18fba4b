// Compares the sandbox with the floor, the minimal program of floor.cpp. Starts the two alternately, so that a warm or
// busy machine affects both equally. Reports medians. Times are compared as wall time and as CPU time (user and system,
// all threads), since wall time is noisy on a busy machine. The exit status is 0 unless a program cannot be run.
//
// bench-ratios FOLDER SANDBOX ONE_MESH DENSE [ROUNDS]
//     FOLDER contains bench-floor, bench-pictures and bench-mesh; SANDBOX is the program; ONE_MESH and DENSE are states
//     that match the floor's pictures: its torus, and a mesh of about 80,000 triangles
//
// If VIEWING_BENCH_ROWS names a file, the rows are also appended to it, with tabs between columns, for
// tests/bench/table. floor.cpp, pictures.cpp and mesh.cpp describe the timed work.
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "idle.h"
#include "program.h"

namespace {

using namespace viewing::bench;
namespace fs = std::filesystem;

struct Programs {
    std::string floor, pictures, mesh, sandbox, one_mesh, dense;
};

/// Collects one value per round; the median of the values is the result.
class Samples {
public:
    void add(double value) { values_.push_back(value); }
    double median() const {
        std::vector<double> sorted = values_;
        std::sort(sorted.begin(), sorted.end());
        return sorted[sorted.size() / 2];
    }

private:
    std::vector<double> values_;
};

enum class Wanted { at_most, at_least };

struct Bound {
    Wanted wanted;
    double ratio;
};

struct Row {
    std::string what;
    std::optional<double> floor;
    double sandbox;
    const char* unit;
    std::optional<double> cpu_ratio;
    std::optional<Bound> bound;  ///< for the ratio, or for the value if there is no floor

    double judged() const { return floor ? sandbox / *floor : sandbox; }
    std::string wanted() const {
        if (!bound) return "";
        char text[32];
        std::snprintf(text, sizeof(text), "%s %g", bound->wanted == Wanted::at_most ? "≤" : "≥", bound->ratio);
        return text;
    }
    bool is_met() const {
        return !bound || (bound->wanted == Wanted::at_most ? judged() <= bound->ratio : judged() >= bound->ratio);
    }
};

void print_head() {
    std::printf("%-46s %9s %9s %-5s %6s %6s  %s\n", "", "floor", "sandbox", "", "ratio", "CPU", "target");
}

void keep(const Row& row) {
    const char* path = std::getenv("VIEWING_BENCH_ROWS");
    std::FILE* file = path == nullptr ? nullptr : std::fopen(path, "a");
    if (file == nullptr) return;
    std::fprintf(file, "%s\t", row.what.c_str());
    if (row.floor) std::fprintf(file, "%g", *row.floor);
    std::fprintf(file, "\t%g\t%s\t", row.sandbox, row.unit);
    if (row.cpu_ratio) std::fprintf(file, "%g", *row.cpu_ratio);
    std::fprintf(file, "\t%s\t%s\n", row.wanted().c_str(), row.is_met() ? "" : "missed");
    std::fclose(file);
}

void print(const Row& row) {
    // printf counts bytes, and a character such as × has two.
    const auto continued =
        std::count_if(row.what.begin(), row.what.end(), [](char byte) { return (byte & 0xC0) == 0x80; });
    std::printf("%-*s ", static_cast<int>(46 + continued), row.what.c_str());
    const auto number = [](const char* format, const std::optional<double>& value, int width) {
        value ? std::printf(format, *value) : std::printf("%*s ", width - 1, "");
    };
    number("%9.1f ", row.floor, 10);
    std::printf(row.floor ? "%9.1f %-5s " : "%9.3f %-5s ", row.sandbox, row.unit);
    number("%6.2f ", row.floor ? std::optional(row.judged()) : std::nullopt, 7);
    number("%6.2f ", row.cpu_ratio, 7);
    if (row.bound) std::printf(" %-6s %s", row.wanted().c_str(), row.is_met() ? "met" : "MISSED");
    std::printf("\n");
    std::fflush(stdout);
    keep(row);
}

void print_value(const std::string& what, double value, const char* unit, const std::optional<Bound>& bound) {
    print({what, std::nullopt, value, unit, std::nullopt, bound});
}

// ---- process start to PNG ----------------------------------------------------------------------------

struct Start {
    Samples wall_ms, cpu_ms, peak_mb;
};

/// Starts the command once with this folder as its shader cache; a cold start empties the folder first.
void start_once(const Command& command, const fs::path& cache, bool cold, Start& start) {
    if (cold) fs::remove_all(cache);
    fs::create_directories(cache);
    setenv("MESA_SHADER_CACHE_DIR", cache.c_str(), 1);
    const Measured measured = run(command);
    start.wall_ms.add(measured.wall_ms);
    start.cpu_ms.add(measured.cpu_ms);
    start.peak_mb.add(measured.peak_mb);
}

void compare_starts(const Programs& programs, const fs::path& scratch, int rounds) {
    const std::string out = scratch / "out.png";
    struct Kind {
        const char* name;
        Command command;
        bool bound;
        Start warm, cold;
    };
    const auto snapshot = [&](const std::string& state) -> Command {
        return {programs.sandbox, "snapshot", state, "--view", "camera", "--samples", "0", "-o", out};
    };
    Kind kinds[] = {{"floor", {programs.floor, out}, false, {}, {}},
                    {"one mesh", snapshot(programs.one_mesh), true, {}, {}},
                    {"opening state", snapshot("opening"), false, {}, {}}};
    Start unused;
    for (Kind& kind : kinds) start_once(kind.command, scratch / kind.name, true, unused);
    for (int round = 0; round < rounds; ++round) {
        for (Kind& kind : kinds) start_once(kind.command, scratch / kind.name, false, kind.warm);
        for (Kind& kind : kinds) start_once(kind.command, scratch / "cold", true, kind.cold);
    }
    const Kind& floor = kinds[0];
    for (const Kind& kind : {kinds[1], kinds[2]}) {
        for (const auto& [heat, start] : {std::pair("warm", &Kind::warm), std::pair("cold", &Kind::cold)}) {
            const Start &ours = kind.*start, &least = floor.*start;
            // The opening state has five passes, so only its cold time is judged; its warm time is just reported.
            const bool is_cold = start == &Kind::cold;
            const double most = kind.bound ? 1.3 : 1.5;
            print({std::string("start to PNG, ") + kind.name + ", " + heat + " shader cache", least.wall_ms.median(),
                   ours.wall_ms.median(), "ms", ours.cpu_ms.median() / least.cpu_ms.median(),
                   kind.bound || is_cold ? std::optional(Bound{Wanted::at_most, most}) : std::nullopt});
        }
        const auto peak = [](const Kind& of) { return std::max(of.warm.peak_mb.median(), of.cold.peak_mb.median()); };
        print({std::string("peak memory, ") + kind.name, peak(floor), peak(kind), "MB", std::nullopt,
               Bound{Wanted::at_most, 1.2}});
    }
}

// ---- pictures per second in one process --------------------------------------------------------------

struct Rate {
    Samples per_second, cpu_ms;
};

void rate_once(const Command& command, Rate& rate) {
    double per_second = 0.0, cpu_ms = 0.0;
    if (std::sscanf(run(command).output.c_str(), "%lf %lf", &per_second, &cpu_ms) != 2) std::exit(2);
    rate.per_second.add(per_second);
    rate.cpu_ms.add(cpu_ms);
}

void print_rate(const std::string& what, const Rate& floor, const Rate& ours, const std::optional<Bound>& bound) {
    print({what, floor.per_second.median(), ours.per_second.median(), "/s",
           floor.cpu_ms.median() / ours.cpu_ms.median(), bound});
}

void compare_rates(const Programs& programs, int rounds) {
    const std::string count = "40", size = "1280x720";
    for (const std::string mode : {"read", "png"}) {
        Rate lambert, shaded, dense_floor, one_mesh, dense, opening;
        for (int round = 0; round < rounds; ++round) {
            rate_once({programs.floor, "--count", count, size, mode}, lambert);
            rate_once({programs.pictures, programs.one_mesh, count, size, mode}, one_mesh);
            rate_once({programs.floor, "--count", count, size, mode, "shaded"}, shaded);
            rate_once({programs.pictures, "opening", count, size, mode}, opening);
            rate_once({programs.floor, "--count", count, size, mode, "dense"}, dense_floor);
            rate_once({programs.pictures, programs.dense, count, size, mode}, dense);
        }
        const std::string what = mode == "png" ? "pictures with PNG, " : "pictures read back, ";
        const Bound bound{Wanted::at_least, mode == "png" ? 0.8 : 0.9};
        print_rate(what + "one mesh", lambert, one_mesh, bound);
        print_rate(what + "floor shaded alike", shaded, one_mesh, bound);
        print_rate(what + "80 000 triangles", dense_floor, dense, bound);
        print_rate(what + "opening state", lambert, opening, std::nullopt);
    }
}

// ---- the window --------------------------------------------------------------------------------------

void compare_windows(const Programs& programs, int rounds) {
    for (const std::string size : {"1280x720", "1600x900"}) {
        Rate floor, window;
        for (int round = 0; round < rounds; ++round) {
            rate_once({programs.floor, "--count", "40", size, "png", "dense"}, floor);
            rate_once({programs.pictures, "opening", "20", size, "window"}, window);
        }
        print_rate("whole window, floor of 80 000 triangles, " + size, floor, window, Bound{Wanted::at_least, 0.5});
        print_value("whole window, pictures per second", window.per_second.median(), "/s",
                    Bound{Wanted::at_least, 15.0});
    }
}

/// Compares windows in which each edit redraws the color and depth pictures, the histogram and the precision chart.
void compare_depth_views(const Programs& programs, int rounds) {
    const std::string depth = fs::path(programs.dense).replace_filename("depth.json");
    Rate floor, window;
    for (int round = 0; round < rounds; ++round) {
        rate_once({programs.floor, "--count", "40", "1280x720", "png", "dense"}, floor);
        rate_once({programs.pictures, depth, "20", "1280x720", "window"}, window);
    }
    print_rate("depth views, same floor", floor, window, Bound{Wanted::at_least, 0.5});
    print_value("depth views, windows per second", window.per_second.median(), "/s", Bound{Wanted::at_least, 30.0});
}

// ---- a mesh of a million triangles -------------------------------------------------------------------

/// The numbers that bench-mesh prints.
struct Reading {
    Samples wall_ms, cpu_ms, arrays_mb, grown_mb;

    void add(const std::string& output) {
        double values[4] = {};
        if (std::sscanf(output.c_str(), "%lf %lf %lf %lf", &values[0], &values[1], &values[2], &values[3]) != 4)
            std::exit(2);
        wall_ms.add(values[0]);
        cpu_ms.add(values[1]);
        arrays_mb.add(values[2]);
        grown_mb.add(values[3]);
    }
};

void compare_large_mesh(const Programs& programs, const fs::path& scratch, int rounds) {
    const std::string mesh = scratch / "million.obj", state = scratch / "million.json", out = scratch / "out.png";
    run({programs.mesh, "write", mesh});
    std::ofstream(state)
        << R"({"scene": {"objects": [{"name": "mesh", "shape": "mesh", "file": "million.obj"}]}, "view": {"samples": 0}})";
    Reading tinyobj, ours;
    Start floor, sandbox;
    Rate flight;
    start_once({programs.floor, out, mesh}, scratch / "floor", false, floor);
    start_once({programs.sandbox, "snapshot", state, "--view", "camera", "-o", out}, scratch / "opening state", false,
               sandbox);
    for (int round = 0; round < rounds; ++round) {
        tinyobj.add(run({programs.mesh, "load", mesh, "tinyobj"}).output);
        ours.add(run({programs.mesh, "load", mesh, "sandbox"}).output);
        start_once({programs.floor, out, mesh}, scratch / "floor", false, floor);
        start_once({programs.sandbox, "snapshot", state, "--view", "camera", "-o", out}, scratch / "opening state",
                   false, sandbox);
    }
    for (int round = 0; round < std::min(rounds, 3); ++round)
        rate_once({programs.pictures, state, "30", "1600x900", "flight"}, flight);
    print({"a million triangles: reading, vs. tinyobjloader", tinyobj.wall_ms.median(), ours.wall_ms.median(), "ms",
           ours.cpu_ms.median() / tinyobj.cpu_ms.median(), Bound{Wanted::at_most, 1.2}});
    print({"… memory for reading, relative to the arrays", ours.arrays_mb.median(), ours.grown_mb.median(), "MB",
           std::nullopt, Bound{Wanted::at_most, 3.0}});
    print({"… start to PNG, warm shader cache", floor.wall_ms.median(), sandbox.wall_ms.median(), "ms",
           sandbox.cpu_ms.median() / floor.cpu_ms.median(), Bound{Wanted::at_most, 1.5}});
    print_value("… windows per second while flying at 1600×900", flight.per_second.median(), "/s",
                Bound{Wanted::at_least, 10.0});
}

/// The time that our thread spends on each frame, in milliseconds, as bench-pictures prints it.
struct FrameCost {
    Samples numbers, ui, calls, submitted, whole;
};

FrameCost frame_cost(const Programs& programs, const std::string& state, int rounds) {
    FrameCost cost;
    for (int round = 0; round < rounds; ++round) {
        double parts[5] = {};
        const std::string output = run({programs.pictures, state, "60", "1600x900", "frame"}).output;
        if (std::sscanf(output.c_str(), "%lf %lf %lf %lf %lf", &parts[0], &parts[1], &parts[2], &parts[3], &parts[4]) !=
            5)
            std::exit(2);
        cost.numbers.add(parts[0]);
        cost.ui.add(parts[1]);
        cost.calls.add(parts[2]);
        cost.submitted.add(parts[3]);
        cost.whole.add(parts[4]);
    }
    return cost;
}

void report_frame(const Programs& programs, int rounds) {
    const FrameCost opening = frame_cost(programs, "opening", rounds);
    print_value("CPU per frame at 1600×900: derive and plan", opening.numbers.median(), "ms", std::nullopt);
    print_value("… user interface", opening.ui.median(), "ms", std::nullopt);
    print_value("… these two and our GL calls", opening.calls.median(), "ms", Bound{Wanted::at_most, 1.0});
    print_value("… with the driver's vertex work, not rasterized", opening.submitted.median(), "ms",
                Bound{Wanted::at_most, 1.0});
    print_value("… our thread in total (with sorting into tiles)", opening.whole.median(), "ms", std::nullopt);
    for (const std::string full : {"room", "shadow-derivation", "passes"}) {
        const FrameCost cost = frame_cost(programs, full, std::min(rounds, 3));
        print_value("preset " + full + ": our code with its GL calls", cost.calls.median(), "ms",
                    Bound{Wanted::at_most, 3.0});
        print_value("… with the driver's vertex work", cost.submitted.median(), "ms", Bound{Wanted::at_most, 3.0});
    }
}

}  // namespace

int main(int argc, char** argv) {
    const int rounds = argc > 5 ? std::atoi(argv[5]) : 9;
    if (argc < 5 || rounds < 1) {
        std::fputs("usage: bench-ratios FOLDER SANDBOX ONE_MESH DENSE [ROUNDS]\n", stderr);
        return 2;
    }
    const fs::path folder = argv[1];
    const Programs programs{
        folder / "bench-floor", folder / "bench-pictures", folder / "bench-mesh", argv[2], argv[3], argv[4]};
    const fs::path scratch = fs::temp_directory_path() / ("viewing-bench-" + std::to_string(getpid()));
    fs::create_directories(scratch);

    std::printf("1280×720 unless stated otherwise, medians of %d rounds, floor and sandbox in turn\n", rounds);
    print_head();
    compare_starts(programs, scratch, rounds);
    compare_rates(programs, rounds);
    compare_windows(programs, rounds);
    compare_depth_views(programs, rounds);
    compare_large_mesh(programs, scratch, rounds);
    report_frame(programs, rounds);
    if (const std::optional<double> idle = idle_percent(programs.sandbox))
        print_value("idle window, of one core", *idle, "%", Bound{Wanted::at_most, 0.5});
    else
        std::printf("idle window: not measured, there is no Xvfb or no window came up\n");
    fs::remove_all(scratch);
}
