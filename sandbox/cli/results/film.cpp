#include "cli/results/film.h"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "platform/file.h"
#include "platform/unfinished.h"
#include "text/numbers.h"
#include "text/words.h"

namespace viewing {
namespace {

namespace fs = std::filesystem;

/// Returns the path of a program found on PATH; empty if there is none.
std::string found_program(const std::string& name) {
    const char* const path = std::getenv("PATH");
    std::string folders = path ? path : "";
    while (!folders.empty()) {
        const std::size_t end = std::min(folders.find(':'), folders.size());
        const std::string file = folders.substr(0, end) + "/" + name;
        if (::access(file.c_str(), X_OK) == 0) return file;
        folders.erase(0, end + 1);
    }
    return "";
}

/// Opens a file without a name, which disappears once no process has it open, however the processes end. On failure,
/// returns −1 and sets errno. A child process inherits the file.
int nameless_file() {
    std::string name = (fs::temp_directory_path() / "viewing-sandbox-film-XXXXXX").string();
    const int file = ::mkstemp(name.data());
    if (file >= 0) ::unlink(name.c_str());
    return file;
}

/// Returns a path to an open file; the path is valid in this process and in ffmpeg.
std::string name_of(int file) {
    return "/proc/self/fd/" + std::to_string(file);
}

std::vector<std::string> encoding_of(const std::string& ending) {
    if (ending == ".gif")
        return {"-filter_complex",
                "split[a][b];[a]palettegen=stats_mode=full[p];[b][p]paletteuse=dither=sierra2_4a",
                "-loop",
                "0",
                "-f",
                "gif"};
    if (ending == ".webp") return {"-c:v", "libwebp_anim", "-lossless", "1", "-loop", "0", "-f", "webp"};
    return {"-c:v",     "libx264", "-preset",   "slow",       "-crf", "16",
            "-pix_fmt", "yuv420p", "-movflags", "+faststart", "-f",   "mp4"};
}

}  // namespace

Result<Film> Film::begin(const std::string& ending, glm::ivec2 size_px, double frames_per_second) {
    const std::string program = found_program("ffmpeg");
    if (program.empty())
        return Error{
            "a film needs ffmpeg, which is not installed (apt-get install ffmpeg); a folder of pictures or a .png "
            "sheet does not"};
    const int file = nameless_file();
    if (file < 0) return write_error(fs::temp_directory_path(), errno);
    std::vector<std::string> words{program,
                                   "-nostdin",
                                   "-loglevel",
                                   "error",
                                   "-f",
                                   "rawvideo",
                                   "-pixel_format",
                                   "rgba",
                                   "-video_size",
                                   std::to_string(size_px.x) + "x" + std::to_string(size_px.y),
                                   "-framerate",
                                   shortest_number(frames_per_second),
                                   "-i",
                                   "pipe:0",
                                   "-bitexact"};
    for (std::string& word : encoding_of(ending)) words.push_back(std::move(word));
    words.insert(words.end(), {"-y", name_of(file)});
    Result<ChildProcess> process = ChildProcess::start(words);
    if (!process) {
        ::close(file);
        return Error{process.error()};
    }
    return Film(*std::move(process), file);
}

Film::~Film() {
    if (file_ >= 0) ::close(file_);
}

Status Film::add(const Image& picture) {
    if (process_.give({reinterpret_cast<const char*>(picture.rgba.data()), picture.rgba.size()}))
        return std::monostate{};
    return failure();
}

Error Film::failure() {
    const std::string end = process_.wait();
    std::string complaint;
    std::istringstream lines(process_.take_complaints());
    for (std::string line; std::getline(lines, line);)
        if (!line.empty()) complaint += (complaint.empty() ? ": " : "; ") + one_line(line);
    return {"ffmpeg ended with " + end + complaint};
}

Result<std::string> Film::finish() {
    process_.finish_telling();
    process_.wait();
    if (process_.exit_status() != 0) return failure();
    std::string bytes = all_bytes(name_of(file_));
    if (bytes.empty()) return Error{"ffmpeg wrote nothing"};
    return bytes;
}

}  // namespace viewing
