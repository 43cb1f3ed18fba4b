// Reads exercise files and makes variants from the values listed for each constant.
#include <algorithm>
#include <set>

#include "lesson/exercise.h"
#include "lesson/step_reader.h"
#include "lesson/variants.h"
#include "platform/file.h"
#include "state/scene.h"
#include "text/words.h"

namespace viewing {

void require_constant_name(const std::string& name, const Where& where) {
    if (!is_constant_name(name))
        where.refuse("\"" + excerpt(name) +
                     "\" is not a valid name: use letters, digits and _, and no word that already has a meaning");
}

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_combinations = 20'000;
constexpr std::size_t most_required = 40'000;                 // evaluations of "require" over all combinations
constexpr std::size_t instructions_of_require = 100'000'000;  // for all evaluations together: a few seconds
constexpr std::size_t longest_variant = 8192;                 // bytes of a combination as JSON

/// Reads the lists that constants are picked from.
const Json& read_picks(const Json& document, const Where& where) {
    const Where inside = where.key("pick");
    if (!has(document, "pick")) inside.refuse("is missing: an object of names and lists of values");
    require_object(document["pick"], inside, "an object of names and lists of values");
    if (document["pick"].empty()) inside.refuse("must have at least one name");
    for (const auto& [name, values] : document["pick"].items()) {
        require_constant_name(name, inside);
        require_array(values, inside.key(name), most_entries, "a list of values");
        if (values.empty()) inside.key(name).refuse("must have at least one value");
    }
    return document["pick"];
}

/// Returns the combination with that index; the last list varies fastest.
Json combination(const Json& picks, std::size_t place) {
    std::vector<std::pair<std::string, std::size_t>> digits;
    for (const auto& [name, values] : picks.items()) digits.emplace_back(name, values.size());
    for (auto digit = digits.rbegin(); digit != digits.rend(); ++digit) {
        const std::size_t size = digit->second;
        digit->second = place % size;
        place /= size;
    }
    Json constants = Json::object();
    for (const auto& [name, at] : digits) constants[name] = picks[name][at];
    return constants;
}

Surroundings constants_alone(Json constants) {
    return {[](const std::string& name, std::span<const double>) -> Result<Json> {
                return Error{name + " is not known here: only the picked values are"};
            },
            nullptr, std::move(constants)};
}

std::vector<std::string> read_combinations(const Json& document, const std::string& id, const Where& where) {
    const Json& picks = read_picks(document, where);
    const std::vector<std::string> require = expressions_at(document, "require", where, keys_of(picks));
    std::size_t count = 1;
    for (const auto& [name, values] : picks.items()) {
        count *= values.size();
        if (count > most_combinations)
            where.key("pick").refuse("has more than " + std::to_string(most_combinations) + " combinations");
    }
    if (count * require.size() > most_required)
        where.key("require").refuse("has " + std::to_string(require.size()) + " expressions for " +
                                    std::to_string(count) + " combinations: at most " + std::to_string(most_required) +
                                    " values are computed");
    ExpressionLimits limits;
    const std::size_t share = instructions_of_require / std::max<std::size_t>(1, count * require.size());
    limits.instructions = std::min(limits.instructions, static_cast<int>(share));
    std::vector<std::string> kept;
    std::set<std::string> seen;
    for (std::size_t place = 0; place < count; ++place) {
        const Json constants = combination(picks, place);
        std::string text = constants.dump();
        if (text.size() > longest_variant)
            where.key("pick").refuse("has a combination longer than " + std::to_string(longest_variant) + " bytes");
        const Surroundings surroundings = constants_alone(constants);
        bool passes = true;
        for (std::size_t i = 0; passes && i < require.size(); ++i) {
            const Result<bool> fine = holds(require[i], surroundings, limits);
            if (!fine) where.key("require").at(i).refuse(fine.error());
            passes = *fine;
        }
        if (passes && seen.insert(text).second) kept.push_back(std::move(text));
    }
    if (kept.empty()) where.key("require").refuse("rejects every combination");
    std::vector<std::string> in_order;
    for (const std::size_t at : shuffled(kept.size(), fnv1a(id))) in_order.push_back(kept[at]);
    return in_order;
}

/// Reads the stored variants, each with a value for every constant.
std::vector<std::string> read_deployed(const Json& document, const Where& where) {
    const std::vector<std::string> names = keys_of(read_picks(document, where));
    expressions_at(document, "require", where, names);
    const Where inside = where.key("deployed");
    require_array(document["deployed"], inside, most_entries, "a list of variants");
    std::vector<std::string> variants;
    for (std::size_t i = 0; i < document["deployed"].size(); ++i) {
        const Json& constants = document["deployed"][i];
        require_keys(constants, inside.at(i), names);
        for (const std::string& name : names)
            if (!constants.contains(name)) inside.at(i).key(name).refuse("is missing: a value");
        variants.push_back(constants.dump());
    }
    if (variants.empty()) inside.refuse("must have at least one variant");
    return variants;
}

Exercise read_exercise(const Json& document, const std::string& source, const Where& where) {
    require_keys(document, where,
                 {"exercise", "id", "title", "sets", "slides", "points", "visible", "tags", "pick", "require", "step",
                  "deployed"});
    if (!has(document, "exercise") || document["exercise"] != 1)
        where.key("exercise").refuse("must be 1, the version of the format that this program reads");
    Exercise exercise;
    exercise.source = source;
    exercise.id = name_at(document, "id", where);
    if (exercise.id.find_first_of("|,/") != std::string::npos) where.key("id").refuse("must not contain | , or /");
    exercise.title = text_at(document, "title", where, true);
    exercise.sets = names_at(document, "sets", where);
    exercise.slides = read_slides(document, where);
    exercise.tags = read_tags(document, where);
    if (has(document, "points")) exercise.points = read_whole(document["points"], where.key("points"), 1, 100);
    if (has(document, "visible"))
        exercise.visible_px = read_whole(document["visible"], where.key("visible"), 1, 640 * 360);
    if (!has(document, "step")) where.key("step").refuse("is missing: a lesson step");
    require_object(document["step"], where.key("step"), "a lesson step");
    exercise.pattern = document["step"].dump();
    if (has(document, "deployed")) {
        exercise.variants = read_deployed(document, where);
    } else {
        exercise.variants = read_combinations(document, exercise.id, where);
        exercise.variants.resize(std::min(exercise.variants.size(), most_deployed));
    }
    return exercise;
}

Result<Exercise> load_exercise(const fs::path& file) {
    const Result<std::string> text = read_text_file(file);
    if (!text) return Error{text.error()};
    Result<Exercise> exercise = parse_exercise(*text, file.filename().string(), file.parent_path());
    if (exercise) exercise->file = file;
    return exercise;
}

}  // namespace

bool Exercise::is_in(const std::string& set) const {
    return std::find(sets.begin(), sets.end(), set) != sets.end();
}

Result<Exercise> parse_exercise(std::string_view json, const std::string& source, const fs::path& folder) {
    return guarded([&] {
        const Where root{source + ": ", ""};
        Exercise exercise = read_exercise(parse_document(json, root.prefix), source, root);
        exercise.file = folder / source;
        return exercise;
    });
}

Result<std::vector<std::string>> combinations(std::string_view json, const std::string& source) {
    return guarded([&] {
        const Where root{source + ": ", ""};
        const Json document = parse_document(json, root.prefix);
        return read_combinations(document, name_at(document, "id", root), root);
    });
}

std::vector<Result<Exercise>> exercises() {
    std::vector<Result<Exercise>> found;
    const fs::path assets = assets_directory();
    if (assets.empty()) return found;
    for (const fs::path& file : files_in(assets / "exercises", ".json")) found.push_back(load_exercise(file));
    return found;
}

Result<std::vector<Exercise>> load_exercises(const std::vector<std::string>& files) {
    std::vector<Result<Exercise>> read;
    if (files.empty()) read = exercises();
    for (const std::string& file : files) {
        std::error_code error;
        if (!fs::is_directory(file, error)) {
            read.push_back(load_exercise(file));
            continue;
        }
        const std::vector<fs::path> inside = files_in(file, ".json");
        if (inside.empty()) return Error{one_line(file) + ": the folder contains no .json file"};
        for (const fs::path& path : inside) read.push_back(load_exercise(path));
    }
    if (read.empty()) return Error{"there are no exercises: the folder assets/exercises was not found"};
    std::vector<Exercise> all;
    for (Result<Exercise>& one : read) {
        if (!one) return Error{one.error()};
        for (const Exercise& other : all)
            if (other.id == one->id)
                return Error{one->source + ": " + other.source + " also has the id \"" + excerpt(one->id) + "\""};
        all.push_back(*std::move(one));
    }
    return all;
}

LessonText exercise_title(const std::string& id) {
    const Result<std::string> text = read_text_file(assets_directory() / "exercises" / (id + ".json"));
    if (!text) return {};
    const Result<LessonText> title = guarded([&] {
        return text_at(parse_document(*text, ""), "title", Where{"", ""}, false);
    });
    return title ? *title : LessonText{};
}

Result<std::size_t> find_exercise(const std::vector<Exercise>& exercises, const std::string& name) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < exercises.size(); ++i) {
        if (exercises[i].id == name || exercises[i].short_id() == name) return i;
        names.push_back(exercises[i].id);
    }
    return Error{"no exercise is called \"" + excerpt(name) + "\"" + suggestion(name, names)};
}

Result<std::vector<Exercise>> of_set(std::vector<Exercise> exercises, const std::string& set) {
    if (set.empty()) return exercises;
    std::vector<Exercise> kept;
    std::vector<std::string> sets;
    for (const Exercise& exercise : exercises) {
        if (exercise.is_in(set)) kept.push_back(exercise);
        for (const std::string& name : exercise.sets)
            if (std::find(sets.begin(), sets.end(), name) == sets.end()) sets.push_back(name);
    }
    if (!kept.empty()) return kept;
    for (std::size_t begin = 0, end = 0; begin <= set.size(); begin = end + 1) {
        end = std::min(set.find(',', begin), set.size());
        const std::string name = set.substr(begin, end - begin);
        const Result<std::size_t> at = find_exercise(exercises, name);
        if (!at) {
            std::vector<std::string> names = sets;
            for (const Exercise& exercise : exercises) names.push_back(exercise.id);
            return Error{"\"" + excerpt(name) + "\" is neither a set (" + joined(sets) + ") nor an exercise" +
                         suggestion(name, names)};
        }
        const auto is_there = [&](const Exercise& one) { return one.id == exercises[*at].id; };
        if (std::none_of(kept.begin(), kept.end(), is_there)) kept.push_back(exercises[*at]);
    }
    return kept;
}

}  // namespace viewing
