#include "app/pictures_to_files.h"

#include <ctime>
#include <string>
#include <utility>

#include "app/picture.h"
#include "image/note_parts.h"
#include "image/png.h"
#include "platform/file.h"
#include "platform/person_files.h"
#include "text/catalogue.h"

namespace viewing {
namespace {

std::string snapshot_name() {
    const std::time_t now = std::time(nullptr);
    char name[64];
    std::strftime(name, sizeof name, "viewing-%Y-%m-%d-%H%M%S.png", std::localtime(&now));
    return name;
}

}  // namespace

void write_snapshot(const Renderer& renderer, Studio& studio, const std::filesystem::path& folder) {
    std::error_code ignored;
    const std::filesystem::path file = std::filesystem::absolute(folder / snapshot_name(), ignored);
    const std::string state = studio.shown_state();
    const std::string place = place_for_person(file);
    std::string told = can_carry(state)
                           ? say("snapshot of the camera view written to {file}", "file"_a = place)
                           : say("snapshot of the camera view written to {file} without its state, which is too long",
                                 "file"_a = place);
    studio.session.write([file, image = renderer.read(studio.camera_view()),
                          state] { return write_file(file, encode_png(image, state)); },
                         std::move(told));
}

void write_view_picture(Renderer& renderer, Studio& studio, const std::filesystem::path& file) {
    const Result<Image> chart = draw_growth_chart(renderer, studio.session, studio.workbench.views.hidden.growth);
    if (!chart) return studio.session.report(Error{chart.error()});
    studio.session.write([file, image = *chart] { return write_png(file, image); },
                         say("picture written to {file}", "file"_a = place_for_person(file)));
}

}  // namespace viewing
