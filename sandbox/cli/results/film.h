// Encodes pictures as a film with ffmpeg, if it is installed.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <utility>
#include <vector>

#include "image/image.h"
#include "platform/child_process.h"

namespace viewing {

class Film {
public:
    /// Starts ffmpeg. `ending` is ".mp4" (H.264; width and height must be even), ".gif" (with a palette made for these
    /// pictures) or ".webp" (lossless). Fails if ffmpeg is not installed.
    static Result<Film> begin(const std::string& ending, glm::ivec2 size_px, double frames_per_second);
    Film(Film&& other) noexcept : process_(std::move(other.process_)), file_(std::exchange(other.file_, -1)) {}
    Film& operator=(Film&&) = delete;
    ~Film();

    Status add(const Image& picture);
    /// Returns the content of the finished file.
    Result<std::string> finish();

private:
    Film(ChildProcess process, int file) : process_(std::move(process)), file_(file) {}
    Error failure();

    ChildProcess process_;
    int file_ = -1;  ///< the file that ffmpeg writes; it has no name, so that nothing is left behind
};

}  // namespace viewing
