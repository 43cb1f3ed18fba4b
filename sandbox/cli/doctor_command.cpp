// doctor: what GL and EGL there is, step by step. Works where there is nothing, and says what to install.
#include <array>
#include <cstdlib>
#include <optional>
#include <vector>

#include "cli/commands.h"
#include "cli/headless.h"
#include "cli/options.h"
#include "cli/output.h"
#include "embedded/fonts.h"
#include "gl/debug.h"
#include "gl/egl_context.h"
#include "gl/facts.h"
#include "render/renderer.h"
#include "report/as_json.h"
#include "state/presets.h"
#include "state/scene.h"

namespace viewing {
namespace {

enum class Health { fine, remark, missing };

struct Step {
    const char* name;
    Health health = Health::fine;
    std::string found;
    std::string advice;  ///< what to do about it; empty when it is fine
};

struct Examination {
    std::vector<Step> steps;
    ExitStatus status = ExitStatus::done;
};

constexpr const char* install_drivers = "install Debian's packages libegl1, libegl-mesa0 and libgl1-mesa-dri";

void examine_egl(Examination& examination) {
    const gl::EglFacts egl = gl::egl_facts();
    if (!egl.has_library) {
        examination.steps.push_back(
            {"EGL library", Health::missing, "libEGL.so.1 cannot be loaded", "install Debian's package libegl1"});
        return;
    }
    examination.steps.push_back({"EGL library", Health::fine, "libEGL.so.1, EGL " + egl.version, ""});

    std::string names;
    for (const std::string& extension : egl.client_extensions) names += (names.empty() ? "" : ", ") + extension;
    if (names.empty())
        examination.steps.push_back({"client extensions", Health::missing, "none: EGL has no driver", install_drivers});
    else
        examination.steps.push_back({"client extensions", Health::fine, names, ""});

    std::string devices;
    for (const gl::DeviceInfo& device : gl::egl_devices())
        devices += (devices.empty() ? "" : "; ") + std::to_string(device.index) + ": " +
                   (device.name.empty() ? "unnamed" : device.name);
    if (devices.empty())
        examination.steps.push_back(
            {"devices", Health::remark, "EGL lists none; surfaceless is tried", install_drivers});
    else
        examination.steps.push_back({"devices", Health::fine, devices, ""});
}

void examine_capabilities(Examination& examination) {
    const gl::ContextFacts facts = gl::context_facts();
    examination.steps.push_back(
        {"OpenGL", Health::fine,
         facts.version + ", GLSL " + facts.shading_language + "; " + facts.renderer + "; " + facts.vendor, ""});
    const gl::Capabilities capabilities = gl::Capabilities::of_current_context();
    const auto add = [&](const char* name, bool there, const char* otherwise) {
        examination.steps.push_back(
            {name, there ? Health::fine : Health::remark, there ? "yes" : "no", there ? "" : otherwise});
    };
    add("glClipControl", capabilities.clip_control, "reversed depth keeps the clip range −1 … 1 and gains nothing");
    add("clip distances", capabilities.clip_distance, "casters and mirror images are cut per pixel");
    add("debug output", facts.debug_output, "errors are asked for with glGetError after each picture");
}

void examine_context(Examination& examination) {
    require_threads();
    const Result<gl::EglContext> context = gl::EglContext::make();
    if (!context) {
        examination.steps.push_back({"context", Health::missing, context.error(), install_drivers});
        examination.status = ExitStatus::no_context;
        return;
    }
    examination.steps.push_back({"context", Health::fine, "OpenGL 3.3 core on " + context->description(), ""});
    examine_capabilities(examination);

    gl::DebugLog log;
    const Result<Renderer> renderer = Renderer::make();
    if (renderer && log.errors().empty()) {
        examination.steps.push_back({"shaders", Health::fine, "compiled and linked", ""});
        return;
    }
    examination.steps.push_back({"shaders", Health::missing, renderer ? log.errors().front() : renderer.error(),
                                 "the driver refuses the program's shaders: a newer libgl1-mesa-dri may help"});
    examination.status = ExitStatus::gl_error;
}

void examine_surroundings(Examination& examination) {
    std::size_t font_bytes = 0;
    for (const char* font : {"Inter-Regular.otf", "Inter-SemiBold.otf", "JetBrainsMono-Regular.ttf", "DejaVuSans.ttf"})
        font_bytes += embedded_font(font).size();
    examination.steps.push_back(
        {"fonts", Health::fine, std::to_string(font_bytes / 1024) + " KiB, part of the program", ""});

    if (const auto assets = assets_directory(); assets.empty())
        examination.steps.push_back({"assets", Health::missing, "no directory beside the program",
                                     "VIEWING_SANDBOX_ASSETS can name it; presets and named scenes need it"});
    else
        examination.steps.push_back({"assets", Health::fine,
                                     assets.string() + ": " + std::to_string(presets().size()) + " presets, " +
                                         std::to_string(scenes().size()) + " scenes",
                                     ""});

    std::string displays;
    for (const char* variable : {"WAYLAND_DISPLAY", "DISPLAY"})
        if (const char* value = std::getenv(variable); value != nullptr && *value != '\0')
            displays += (displays.empty() ? "" : ", ") + std::string(variable) + "=" + value;
    if (displays.empty())
        examination.steps.push_back({"display", Health::remark, "neither DISPLAY nor WAYLAND_DISPLAY is set",
                                     "the window needs one (or Debian's package xvfb); every other command does not"});
    else
        examination.steps.push_back({"display", Health::fine, displays, ""});
}

const char* word(Health health) {
    switch (health) {
        case Health::fine:
            return "ok";
        case Health::remark:
            return "note";
        case Health::missing:
            return "missing";
    }
    return "";
}

std::string as_text(const Examination& examination) {
    constexpr std::size_t found_column = 28;
    std::string text;
    for (const Step& step : examination.steps) {
        std::string head = step.name;
        head.resize(found_column - 9, ' ');
        head += word(step.health);
        head.resize(found_column, ' ');
        text += head + wrapped(step.found, found_column).substr(found_column);
        if (!step.advice.empty()) text += wrapped(step.advice, found_column);
    }
    return text + (examination.status == ExitStatus::done
                       ? "Everything needed to draw is there.\n"
                       : "Pictures cannot be drawn here: see what is missing above.\n");
}

Json as_json(const Examination& examination) {
    Json steps = Json::array();
    for (const Step& step : examination.steps)
        steps.push_back({{"step", step.name},
                         {"health", word(step.health)},
                         {"found", step.found},
                         {"advice", step.advice.empty() ? Json() : Json(step.advice)}});
    Json devices = Json::array();
    for (const gl::DeviceInfo& device : gl::egl_devices())
        devices.push_back({{"index", device.index}, {"software", device.software}, {"name", device.name}});
    return {{"fine", examination.status == ExitStatus::done}, {"steps", steps}, {"devices", devices}};
}

ExitStatus run(const Command& self, const Arguments& arguments) {
    Options options(self);
    bool json = false;
    options.flag("--json", json, "The same as JSON");
    if (!options.parse(arguments)) return ExitStatus::done;

    Examination examination;
    examine_egl(examination);
    if (examination.steps.front().health != Health::missing)
        examine_context(examination);
    else
        examination.status = ExitStatus::no_context;
    examine_surroundings(examination);
    print(json ? print_document(as_json(examination)) + "\n" : as_text(examination));
    return examination.status;
}

}  // namespace

constinit const Command doctor_command{
    "doctor",
    "[--json]",
    "what GL and EGL there is, step by step, and what to install if something is missing",
    "Looks for everything that the program needs to draw without a display, in the order in which it needs it, and "
    "names the Debian package that helps where something is missing.",
    "doctor\n"
    "doctor --json",
    "023489",
    run};

}  // namespace viewing
