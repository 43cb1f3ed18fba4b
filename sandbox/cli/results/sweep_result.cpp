#include "cli/results/sweep_result.h"

#include <algorithm>
#include <set>

#include "cli/exit_status.h"
#include "cli/results/contact_sheet.h"
#include "cli/results/film.h"
#include "cli/results/picture_file.h"
#include "image/png.h"
#include "platform/file.h"
#include "platform/whole_folder.h"
#include "text/numbers.h"
#include "text/words.h"

namespace viewing {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t fewest_digits = 4;  // of a picture's number in its file name

std::string file_of_picture(std::size_t index, std::size_t count) {
    const std::string number = std::to_string(index + 1);
    const std::size_t digits = std::max(fewest_digits, std::to_string(count).size());
    return std::string(digits - number.size(), '0') + number + ".png";
}

/// Returns the value with four digits for each of its numbers.
std::string shortened(const std::string& value) {
    if (const std::optional<double> number = parse_double(value)) return figures(*number, 4);
    if (!value.starts_with('[') || !value.ends_with(']')) return value;
    std::string text;
    for (const std::string& part : split_outside_brackets(value.substr(1, value.size() - 2), ','))
        text += (text.empty() ? "" : ", ") + shortened(part);
    return "[" + text + "]";
}

/// Returns three captions from long to short, such as "light.position[0] = −2.9", "position[0] = −2.9" and "−2.9". The
/// second one keeps the whole paths if it could not tell two fields apart without them.
std::vector<std::string> captions_of(const std::vector<std::string>& settings) {
    const auto path_of = [](const std::string& setting) { return setting.substr(0, setting.find('=')); };
    const auto name_of = [](const std::string& path) { return path.substr(path.rfind('.') + 1); };
    std::set<std::string> names;
    for (const std::string& setting : settings) names.insert(name_of(path_of(setting)));
    std::vector<std::string> captions(3);
    for (const std::string& setting : settings) {
        const std::string path = path_of(setting), value = shortened(setting.substr(path.size() + 1));
        const std::string name = names.size() < settings.size() ? path : name_of(path);
        const std::string words[] = {path + " = " + value, name + " = " + value, value};
        for (std::size_t i = 0; i < captions.size(); ++i) captions[i] += (captions[i].empty() ? "" : "  ") + words[i];
    }
    return captions;
}

class FilmResult : public SweepResult {
public:
    FilmResult(std::string file, Film film) : file_(std::move(file)), film_(std::move(film)) {}
    void add(const Image& image, const Params&, const std::vector<std::string>&) override {
        value_or_end(film_.add(image));
    }
    void finish(Outputs& outputs) override { outputs.add(file_, value_or_end(film_.finish())); }

private:
    std::string file_;
    Film film_;
};

class FolderResult : public SweepResult {
public:
    FolderResult(WholeFolder folder, const PictureRequest& picture, std::size_t count)
        : folder_(std::move(folder)), picture_(picture), count_(count) {}
    void add(const Image& image, const Params& params, const std::vector<std::string>&) override {
        value_or_end(write_file(folder_.beside() / file_of_picture(added_++, count_),
                                encode_png(image, carried_state(drawn_params(params, picture_)))));
    }
    void finish(Outputs& outputs) override { outputs.add(std::move(folder_)); }

private:
    WholeFolder folder_;
    PictureRequest picture_;
    std::size_t count_, added_ = 0;
};

class SheetResult : public SweepResult {
public:
    SheetResult(std::string file, int columns) : file_(std::move(file)), columns_(columns) {}
    void add(const Image& image, const Params&, const std::vector<std::string>& settings) override {
        pictures_.push_back({image, captions_of(settings)});
    }
    void finish(Outputs& outputs) override { outputs.add(file_, encode_png(contact_sheet(pictures_, columns_))); }

private:
    std::string file_;
    int columns_;
    std::vector<SheetPicture> pictures_;
};

}  // namespace

std::unique_ptr<SweepResult> begin_film(const std::string& file, const std::string& ending, glm::ivec2 size_px,
                                        double frames_per_second) {
    return std::make_unique<FilmResult>(file, value_or_end(Film::begin(ending, size_px, frames_per_second)));
}

std::unique_ptr<SweepResult> begin_folder(const std::string& folder, const PictureRequest& picture, std::size_t count) {
    return std::make_unique<FolderResult>(value_or_end(WholeFolder::begin(folder, is_sweep_picture)), picture, count);
}

std::unique_ptr<SweepResult> begin_sheet(const std::string& file, int columns) {
    return std::make_unique<SheetResult>(file, columns);
}

bool is_sweep_picture(const fs::path& file) {
    const std::string stem = file.stem().string();
    const bool is_number = stem.size() >= fewest_digits && stem.find_first_not_of("0123456789") == std::string::npos;
    if (!is_number || file.extension() != ".png") return false;
    const Result<std::string> note = read_png_note(file);
    return note && !note->empty();
}

}  // namespace viewing
