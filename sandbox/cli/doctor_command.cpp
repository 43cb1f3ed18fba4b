// doctor: checks GL and EGL step by step. Works even if they are missing, and says what to install.
#include <imgui.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "cli/commands.h"
#include "cli/headless.h"
#include "cli/options.h"
#include "cli/output.h"
#include "embedded/fonts.h"
#include "gl/debug.h"
#include "gl/egl_context.h"
#include "gl/facts.h"
#include "platform/file.h"
#include "render/renderer.h"
#include "render/stored_depth.h"
#include "report/as_json.h"
#include "state/presets.h"
#include "state/scene.h"
#include "text/numbers.h"
#include "text/words.h"

namespace viewing {
namespace {

enum class Health { fine, remark, missing };

struct Step {
    const char* name;
    Health health = Health::fine;
    std::string found;
    std::string advice;  ///< how to fix the problem; empty if there is none
};

struct Examination {
    std::vector<Step> steps;
    ExitStatus status = ExitStatus::done;
    Json depth;  ///< by format; null without a context
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
        examination.steps.push_back({"devices", Health::remark, "EGL lists none; trying surfaceless", install_drivers});
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
    add("clip distances", capabilities.clip_distance, "casters and mirror images are clipped per pixel");
    add("multisampling", capabilities.multisampling, "pictures have one sample per pixel, whatever view.samples says");
    add("debug output", facts.debug_output, "errors are queried with glGetError after each picture");
}

std::string stored_as_text(const DepthPrecision& precision) {
    return precision.is_float ? "a 32-bit float" : std::to_string(precision.bits) + "-bit integers";
}

/// Reports how the driver stores a depth format, and whether that matches the format's name.
void add_depth(Examination& examination, const char* name, DepthFormat format, const StoredDepth& stored) {
    const DepthPrecision wanted = precision_of(format);
    const bool is_as_named = stored.precision == wanted;
    const std::string unit = shortest_number(*stored.unit_codes);
    const std::string codes = stored.precision.is_float ? " steps of the float" : " codes";
    examination.steps.push_back(
        {name, is_as_named ? Health::fine : Health::remark,
         "stored as " + stored_as_text(stored.precision) + "; a unit of glPolygonOffset is " +
             (stored.unit_codes == 1.0 ? (stored.precision.is_float ? "one step of the float" : "one code")
                                       : unit + codes),
         is_as_named ? "" : "predictions use the stored format; lists of codes use " + stored_as_text(wanted)});
}

Json depth_as_json(const StoredDepth& stored) {
    return {{"bits", stored.precision.bits},
            {"float", stored.precision.is_float},
            {"offset_unit_codes", *stored.unit_codes}};
}

void examine_depth(Examination& examination, const gl::Capabilities& capabilities) {
    struct Asked {
        const char *name, *key;
        DepthFormat format;
        gl::DepthKind kind;
    };
    for (const auto& [name, key, format, kind] :
         {Asked{"16-bit depth", "d16", DepthFormat::d16, gl::DepthKind::d16},
          Asked{"24-bit depth", "d24", DepthFormat::d24, gl::DepthKind::d24_s8},
          Asked{"float depth", "d32f", DepthFormat::d32f, gl::DepthKind::d32f_s8}}) {
        const StoredDepth stored = value_or_end(measure_stored_depth(capabilities, kind), ExitStatus::gl_error);
        add_depth(examination, name, format, stored);
        examination.depth[key] = depth_as_json(stored);
    }
}

/// Returns the names of environment variables that are set and affect a driver or its loader.
std::string variables_of_drivers() {
    constexpr std::array<std::string_view, 6> beginnings{"MESA_", "LIBGL_", "GALLIUM_", "__EGL_", "EGL_", "LP_"};
    std::vector<std::string> names;
    for (char** entry = environ; *entry != nullptr; ++entry) {
        const std::string_view text = *entry;
        const auto begins = [text](std::string_view beginning) { return text.starts_with(beginning); };
        if (std::any_of(beginnings.begin(), beginnings.end(), begins))
            names.emplace_back(text.substr(0, text.find('=')));
    }
    std::sort(names.begin(), names.end());
    return joined(names);
}

/// Returns advice for a machine that has a driver but gets no context.
std::string advice_for_refusal(const std::string& variables) {
    const std::string half =
        "there is a driver, but it is too old or only partly installed: see Debian's libgl1-mesa-dri";
    return variables.empty()
               ? half
               : "try without the variables that configure the driver (" + variables + "); otherwise " + half;
}

void examine_context(Examination& examination) {
    const bool has_driver = !gl::egl_devices().empty();
    const std::string variables = variables_of_drivers();
    const Result<gl::EglContext> context = context_for_pictures("");
    if (!context) {
        examination.steps.push_back({"context", Health::missing, context.error(),
                                     has_driver ? advice_for_refusal(variables) : std::string(install_drivers)});
        examination.status = ExitStatus::no_context;
        return;
    }
    examination.steps.push_back({"context", Health::fine, "OpenGL 3.3 core on " + context->description(), ""});
    examine_capabilities(examination);

    gl::DebugLog log;
    const Result<Renderer> renderer = Renderer::make();
    if (renderer && log.errors().empty()) {
        examination.steps.push_back({"shaders", Health::fine, "compiled and linked", ""});
        examine_depth(examination, renderer->capabilities());
        return;
    }
    examination.steps.push_back({"shaders", Health::missing, renderer ? log.errors().front() : renderer.error(),
                                 "the driver rejects the program's shaders: a newer libgl1-mesa-dri may help"});
    examination.status = ExitStatus::gl_error;
}

void examine_surroundings(Examination& examination) {
    std::size_t font_bytes = 0;
    for (const char* font : {"Inter-Regular.otf", "Inter-SemiBold.otf", "JetBrainsMono-Regular.ttf", "DejaVuSans.ttf"})
        font_bytes += embedded_font(font).size();
    examination.steps.push_back(
        {"fonts", Health::fine,
         std::to_string(font_bytes / 1024) + " KiB, built into the program; drawn by Dear ImGui " + ImGui::GetVersion(),
         ""});

    if (const std::string problem = assets_problem(); !problem.empty()) {
        examination.steps.push_back({"assets", Health::missing, problem,
                                     "install the complete program; leave VIEWING_SANDBOX_ASSETS unset unless the "
                                     "program and its assets are in separate places"});
        if (examination.status == ExitStatus::done) examination.status = ExitStatus::bad_input;
    } else {
        examination.steps.push_back({"assets", Health::fine,
                                     assets_directory().string() + ": " + std::to_string(presets().size()) +
                                         " presets, " + std::to_string(scenes().size()) + " scenes",
                                     ""});
    }

    std::string displays;
    for (const char* variable : {"WAYLAND_DISPLAY", "DISPLAY"})
        if (const char* value = std::getenv(variable); value != nullptr && *value != '\0')
            displays += (displays.empty() ? "" : ", ") + std::string(variable) + "=" + value;
    if (displays.empty())
        examination.steps.push_back({"display", Health::remark, "neither DISPLAY nor WAYLAND_DISPLAY is set",
                                     "only the window needs one (or Debian's package xvfb)"});
    else
        examination.steps.push_back({"display", Health::fine, displays, ""});
}

/// Reports files that an interrupted write left here.
void examine_leftovers(Examination& examination) {
    std::string names;
    for (const std::filesystem::path& file : unfinished_files_in("."))
        names += (names.empty() ? "" : ", ") + one_line(file.filename().string());
    if (!names.empty())
        examination.steps.push_back(
            {"left behind", Health::remark, names, "unfinished files of an interrupted program: remove them"});
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
    switch (examination.status) {
        case ExitStatus::done:
            return text + "Everything needed to draw is available.\n";
        case ExitStatus::bad_input:
            return text + "Pictures can be drawn, but presets and scenes are missing: see above.\n";
        default:
            return text + "Pictures cannot be drawn here: see what is missing above.\n";
    }
}

Json examination_as_json(const Examination& examination) {
    Json steps = Json::array();
    for (const Step& step : examination.steps)
        steps.push_back({{"step", step.name},
                         {"health", word(step.health)},
                         {"found", step.found},
                         {"advice", step.advice.empty() ? Json() : Json(step.advice)}});
    Json devices = Json::array();
    for (const gl::DeviceInfo& device : gl::egl_devices())
        devices.push_back({{"index", device.index}, {"software", device.software}, {"name", device.name}});
    Json json{{"fine", examination.status == ExitStatus::done}, {"steps", steps}, {"devices", devices}};
    if (!examination.depth.is_null()) json["depth"] = examination.depth;
    return json;
}

ExitStatus run_doctor(const Command& self, const Arguments& arguments) {
    Options options(self);
    bool json = false;
    options.flag("--json", json, "Prints JSON instead");
    if (!options.parse(arguments)) return ExitStatus::done;

    Examination examination;
    examine_egl(examination);
    if (examination.steps.front().health != Health::missing)
        examine_context(examination);
    else
        examination.status = ExitStatus::no_context;
    examine_surroundings(examination);
    examine_leftovers(examination);
    print(json ? print_document(examination_as_json(examination)) + "\n" : as_text(examination));
    return examination.status;
}

}  // namespace

constinit const Command doctor_command{
    "doctor",
    "[--json]",
    "checks GL and EGL step by step, and says what to install if something is missing",
    "Checks, one after the other, the things that the program needs to draw without a display, and names the Debian "
    "package to install if one is missing. The context is the one that pictures are drawn in. Presets, scenes, lessons "
    "and exercises come from the folder assets beside the program, else from ../share/viewing-sandbox; the environment "
    "variable VIEWING_SANDBOX_ASSETS names another. Without them the exit status is 2. Finally it lists the unfinished "
    "files that an interrupted program left in this folder.",
    "doctor\n"
    "doctor --json",
    "023489",
    run_doctor};

}  // namespace viewing
