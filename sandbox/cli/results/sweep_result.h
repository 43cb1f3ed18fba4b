// What a sweep makes of its pictures: a film, a folder of pictures, or a sheet. Each takes the pictures one by one.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/picture.h"
#include "cli/output.h"

namespace viewing {

class SweepResult {
public:
    virtual ~SweepResult() = default;
    /// Takes the next picture, of these parameters; `settings` are those of the sweep: "light.position[0]=-2.9".
    virtual void add(const Image& image, const Params& params, const std::vector<std::string>& settings) = 0;
    /// Adds the finished file or folder to the command's outputs. Call it once, after the last picture.
    virtual void finish(Outputs& outputs) = 0;
};

/// `ending`: see Film::begin().
std::unique_ptr<SweepResult> begin_film(const std::string& file, const std::string& ending, glm::ivec2 size_px,
                                        double frames_per_second);
/// `count`: the number of pictures.
std::unique_ptr<SweepResult> begin_folder(const std::string& folder, const PictureRequest& picture, std::size_t count);
/// A sheet with each picture's values below it.
std::unique_ptr<SweepResult> begin_sheet(const std::string& file, int columns);

/// Whether a file is a picture from an earlier sweep: its name is a number, and it contains the state that it shows.
bool is_sweep_picture(const std::filesystem::path& file);

}  // namespace viewing
