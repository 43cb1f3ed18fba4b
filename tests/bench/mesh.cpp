// Reads a million-triangle Wavefront file with our reader or with tinyobjloader, the fastest reader in Debian.
//
// bench-mesh write FILE                    writes a torus of 1,000 × 500 quads with normals
// bench-mesh load FILE sandbox|tinyobj     reads FILE; prints milliseconds, CPU milliseconds, the megabytes of the
//                                          resulting arrays, and the megabytes by which the process grew at its peak
#include <sys/resource.h>
#include <tiny_obj_loader.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>
#include <string_view>

#include "geometry/shapes.h"
#include "state/scene.h"

namespace {

using namespace viewing;

bool write(const char* path) {
    const Mesh mesh = torus_mesh(1000, 500);
    std::FILE* file = std::fopen(path, "w");
    if (file == nullptr) return false;
    for (const glm::vec3& p : mesh.positions) std::fprintf(file, "v %.6f %.6f %.6f\n", p.x, p.y, p.z);
    for (const glm::vec3& n : mesh.normals) std::fprintf(file, "vn %.6f %.6f %.6f\n", n.x, n.y, n.z);
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        std::fputs("f", file);
        for (std::size_t k = i; k < i + 3; ++k) std::fprintf(file, " %u//%u", mesh.indices[k] + 1, mesh.indices[k] + 1);
        std::fputs("\n", file);
    }
    return std::fclose(file) == 0;
}

double peak_mb() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

template <typename T>
double megabytes(const std::vector<T>& values) {
    return static_cast<double>(values.size() * sizeof(T)) / (1024.0 * 1024.0);
}

/// Returns the size of the arrays that were read, in MB; 0 if the file cannot be read.
double load(const std::string& path, bool ours) {
    if (ours) {
        const Result<ObjMesh> read = load_obj(path);
        if (!read) return 0.0;
        return megabytes(read->mesh.positions) + megabytes(read->mesh.normals) + megabytes(read->mesh.indices);
    }
    tinyobj::ObjReader reader;
    if (!reader.ParseFromFile(path)) return 0.0;
    double sum = megabytes(reader.GetAttrib().vertices) + megabytes(reader.GetAttrib().normals);
    for (const tinyobj::shape_t& shape : reader.GetShapes()) sum += megabytes(shape.mesh.indices);
    return sum;
}

}  // namespace

int main(int argc, char** argv) {
    const std::string_view what = argc > 1 ? argv[1] : "";
    if (what == "write" && argc == 3) return write(argv[2]) ? 0 : 1;
    if (what != "load" || argc != 4) {
        std::fputs("usage: bench-mesh write FILE | bench-mesh load FILE sandbox|tinyobj\n", stderr);
        return 2;
    }
    const double before_mb = peak_mb();
    const auto begin = std::chrono::steady_clock::now();
    const std::clock_t begin_cpu = std::clock();
    const double arrays_mb = load(argv[2], std::string_view(argv[3]) == "sandbox");
    const double cpu_ms = 1e3 * static_cast<double>(std::clock() - begin_cpu) / CLOCKS_PER_SEC;
    const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - begin;
    std::printf("%.1f %.1f %.1f %.1f\n", spent.count(), cpu_ms, arrays_mb, peak_mb() - before_mb);
    return arrays_mb > 0.0 ? 0 : 1;
}
