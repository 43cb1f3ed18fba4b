// The public interface of the readers and writers: state files, scene files and the `params` command. reader.cpp reads
// fields, scene_reader.cpp reads objects, document.cpp parses text, and settings.cpp handles `--set`.
#include "state/file/state_json.h"

#include <algorithm>

#include "state/file/flight.h"
#include "state/file/reader.h"
#include "text/words.h"

namespace viewing {

namespace {

/// Returns a field's default as text on one line.
std::string default_text(const Field& field) {
    Params defaults;
    return print_document(field_as_json(field, defaults));
}

Json field_description(const Field& field) {
    Params defaults;
    Json json = {{"path", field.path}, {"type", type_name(field)}, {"label", field.label}, {"unit", field.unit}};
    if (has_range(field)) {
        json["min"] = field.min;
        json["max"] = field.max;
        json["step"] = field.step;
        json["logarithmic"] = field.logarithmic && field.min > 0.0;
    }
    if (const std::vector<std::string> names = allowed_names(field); !names.empty()) json["values"] = names;
    json["allowed"] = allowed_text(field);
    json["default"] = field_as_json(field, defaults);
    json["help"] = field.help;
    json["formula"] = field.formula;
    json["gl_call"] = field.gl_call;
    return json;
}

}  // namespace

Result<StateDocument> parse_state_document(std::string_view json, std::string_view source) {
    return guarded([&] {
        const Where root{std::string(source) + ": ", ""};
        Json document = parse_document(json, root.prefix);
        StateDocument state;
        state.titles = take_titles(document, root);
        if (is_flight(document)) {
            state.flight = std::make_shared<const Flight>(read_flight(document, root));
            state.params = state.flight->start;
            return state;
        }
        if (document.is_object() && document.contains("objects")) {
            root.key("objects").refuse("no such field; this is a scene: use --set scene=" +
                                       one_line(source.ends_with(".json") ? source : "FILE.json"));
        }
        if (document.is_object() && document.contains("lesson") && document.contains("steps"))
            root.refuse("this is a lesson: open it with viewing-sandbox lesson " + one_line(source));
        read_group(state.params, document, root);
        check_together(state.params, root.prefix);
        return state;
    });
}

Result<Params> parse_state(std::string_view json, std::string_view source) {
    Result<StateDocument> state = parse_state_document(json, source);
    if (!state) return Error{state.error()};
    return std::move(state->params);
}

std::string write_state(const Params& params, const Titles& titles) {
    Json document = Json::object();
    const auto put = [&document](const char* key, const std::string& text) {
        if (!text.empty()) document[key] = text;
    };
    put("$schema", titles.schema);
    document["version"] = nullptr;  // reserves its position; the value follows
    put("title", titles.title);
    put("about", titles.about);
    put("group", titles.group);
    put("mended_by", titles.fixed_by);
    if (!titles.slides.empty()) document["slides"] = titles.slides;
    document.update(params_as_document(params));
    return print_document(document) + "\n";
}

Result<SceneDescription> parse_scene(std::string_view json, std::string_view source) {
    return guarded([&] {
        const Where root{std::string(source) + ": ", ""};
        Json document = parse_document(json, root.prefix);
        take_titles(document, root);
        return read_scene(document, root);
    });
}

std::string params_as_json() {
    Json array = Json::array();
    for (const Field& field : fields()) {
        array.push_back(field_description(field));
    }
    return print_document(array) + "\n";
}

std::string params_as_text() {
    std::size_t path_width = 0;
    for (const Field& field : fields()) {
        path_width = std::max(path_width, field.path.size());
    }
    std::string text;
    for (const Field& field : fields()) {
        std::string line(field.path);
        line.resize(path_width + 2, ' ');
        line += std::string(type_name(field));
        line.resize(path_width + 10, ' ');
        line += allowed_text(field) + "; default " + default_text(field);
        if (!field.unit.empty()) {
            line += "; in " + std::string(field.unit == "°" ? "degrees" : field.unit);
        }
        text += line + "\n" + std::string(path_width + 2, ' ') + std::string(field.help) + "\n";
        if (!field.formula.empty() || !field.gl_call.empty()) {
            const std::string between = field.formula.empty() || field.gl_call.empty() ? "" : "; ";
            text += std::string(path_width + 2, ' ') + std::string(field.formula) + between +
                    std::string(field.gl_call) + "\n";
        }
    }
    return text;
}

}  // namespace viewing
