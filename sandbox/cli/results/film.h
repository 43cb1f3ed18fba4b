// Pictures one after the other as a film, through ffmpeg where that is installed.
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "image/image.h"
#include "platform/child_process.h"

namespace viewing {

class Film {
public:
    /// `ending`: ".mp4" (H.264, sides even), ".gif" (a palette made for these pictures) or ".webp" (lossless). The
    /// error: ffmpeg is not installed.
    static Result<Film> begin(const std::string& ending, glm::ivec2 size_px, double frames_per_second);
    Film(Film&&) noexcept = default;
    Film& operator=(Film&&) noexcept = default;
    ~Film();

    Status add(const Image& picture);
    /// The whole file.
    Result<std::string> finish();

private:
    Film(ChildProcess process, std::filesystem::path folder, std::filesystem::path file)
        : process_(std::move(process)), folder_(std::move(folder)), file_(std::move(file)) {}
    Error failure();

    ChildProcess process_;
    std::filesystem::path folder_, file_;  ///< where it grows; gone in the end
};

}  // namespace viewing
