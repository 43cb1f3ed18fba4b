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

using form::Object;
using Names = std::vector<std::string>;

/// The lists from which constants take their values. Expressions in the file may use the constants' names.
form::Form<Json> picks_form(LessonReading& reading) {
    const char* const what = "an object of names and lists of values";
    const auto values = form::list(form::value("a value", [](Json&) { return Json(true); }), "a list of values",
                                   {most_entries, 1, "must have at least one value"});
    const auto read = [&reading, values, what](const Json& value, const Where& where) {
        require_object(value, where, what);
        if (value.empty()) where.refuse("must have at least one name");
        for (const auto& [name, list] : value.items()) {
            require_constant_name(name, where);
            values.read(list, where.key(name));
        }
        reading.constants = keys_of(value);
        return value;
    };
    return {
        what, {}, read, [values](Json& definitions) {
            return Json{{"type", "object"}, {"minProperties", 1}, {"additionalProperties", values.schema(definitions)}};
        }};
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

/// What an exercise file says about its variants.
struct VariantsRead {
    Exercise exercise;
    Json picks;
    Names require;
};

/// Returns the combinations of values that pass all requirements, in shuffled order.
Names combinations_of(const Json& picks, const Names& require, const std::string& id, const Where& where) {
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

/// The stored variants, each with a value for every constant.
form::Form<Names> deployed_form(const LessonReading& reading) {
    const auto read = [&](const Json& constants, const Where& where) {
        require_keys(constants, where, *reading.constants);
        for (const std::string& name : *reading.constants)
            if (!constants.contains(name)) where.key(name).refuse("is missing: a value");
        return constants.dump();
    };
    const form::Form<std::string> variant{"an object", {}, read, [](Json&) { return Json{{"type", "object"}}; }};
    return form::list(variant, "a list of variants", {most_entries, 1, "must have at least one variant"});
}

/// The members of an exercise file on which the combinations of values depend.
Object<VariantsRead> combined_form(LessonReading& reading) {
    const auto is_valid_id = [](const std::string& id, const Where& where) {
        if (id.find_first_of("|,/") != std::string::npos) where.refuse("must not contain | , or /");
    };
    return Object<VariantsRead>()
        .required(
            "id", form::name().then(is_valid_id, {{"pattern", "^[^|,/]*$"}}),
            [](VariantsRead & read) -> auto& { return read.exercise.id; })
        .required("pick", picks_form(reading), &VariantsRead::picks)
        .optional("require", expressions_form(reading), &VariantsRead::require);
}

Object<VariantsRead> exercise_form(LessonReading& reading) {
    const Json any_step{{"$comment", "A step of a lesson, in which a value may be an expression: \"=x\"."},
                        {"type", "object"}};
    const auto pattern = [](Exercise& exercise, const Json* step, const Where& where) {
        require_object(*step, where, "a lesson step");
        exercise.pattern = step->dump();
    };
    return Object<VariantsRead>()
        .version("exercise")
        .with(combined_form(reading), std::identity())
        .with(Object<Exercise>()
                  .required("title", text_form(true), &Exercise::title)
                  .optional("sets", names_form(), &Exercise::sets)
                  .optional("slides", form::slides(), &Exercise::slides)
                  .optional("tags", tags_form(), &Exercise::tags)
                  .optional("points", form::whole(1, 100), &Exercise::points)
                  .optional("visible", form::whole(1, 640 * 360), &Exercise::visible_px)
                  .required("step", form::value("a lesson step", [any_step](Json&) { return any_step; }), pattern)
                  .optional("deployed", deployed_form(reading), &Exercise::variants),
              &VariantsRead::exercise);
}

Exercise read_exercise(const Json& document, const std::string& source, const Where& where) {
    LessonReading reading;
    VariantsRead read = exercise_form(reading).read(document, where);
    Exercise& exercise = read.exercise;
    exercise.source = source;
    if (!has(document, "deployed")) {
        exercise.variants = combinations_of(read.picks, read.require, exercise.id, where);
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

std::string exercise_schema() {
    LessonReading none;
    return form::document("An exercise of the Viewing Sandbox", exercise_form(none));
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
        LessonReading reading;
        VariantsRead read;
        combined_form(reading).read_members(read, parse_document(json, root.prefix), root);
        return combinations_of(read.picks, read.require, read.exercise.id, root);
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
        return text_form(false).read(parse_document(*text, "")["title"], Where{"", ""});
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
    std::vector<std::string> sets;
    for (const Exercise& exercise : exercises)
        for (const std::string& name : exercise.sets)
            if (std::find(sets.begin(), sets.end(), name) == sets.end()) sets.push_back(name);
    std::vector<Exercise> kept;
    const auto keep = [&kept](const Exercise& exercise) {
        const auto is_it = [&](const Exercise& one) { return one.id == exercise.id; };
        if (std::none_of(kept.begin(), kept.end(), is_it)) kept.push_back(exercise);
    };
    for (std::size_t begin = 0, end = 0; begin <= set.size(); begin = end + 1) {
        end = std::min(set.find(',', begin), set.size());
        const std::string name = set.substr(begin, end - begin);
        if (std::find(sets.begin(), sets.end(), name) != sets.end()) {
            for (const Exercise& exercise : exercises)
                if (exercise.is_in(name)) keep(exercise);
            continue;
        }
        const Result<std::size_t> at = find_exercise(exercises, name);
        if (!at) {
            std::vector<std::string> names = sets;
            for (const Exercise& exercise : exercises) names.push_back(exercise.id);
            return Error{"\"" + excerpt(name) + "\" is neither a set (" + joined(sets) + ") nor an exercise" +
                         suggestion(name, names)};
        }
        keep(exercises[*at]);
    }
    return kept;
}

}  // namespace viewing
