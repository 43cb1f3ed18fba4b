#include "lesson/formulas/names.h"

#include <algorithm>

#include "lesson/formulas/mathematics.h"
#include "state/fields.h"
#include "text/words.h"

namespace viewing {
namespace {

/// Returns the first part of each path in the state, in the order of the state file.
std::vector<ExpressionName> names_of_state() {
    std::vector<ExpressionName> names;
    for (const Field& field : fields()) {
        const std::string name(field.path.substr(0, field.path.find('.')));
        if (!names.empty() && names.back().name == name) continue;
        const bool is_group = field.path.size() > name.size();
        names.push_back({name, NameKind::value, is_group ? name + ".…" : name,
                         is_group ? "with the fields that `viewing-sandbox params` lists" : std::string(field.help)});
    }
    return names;
}

std::vector<ExpressionName> all_names() {
    std::vector<ExpressionName> names = names_of_state();
    const ExpressionName others[] = {
        {"start", NameKind::value, "start.…", "the same fields at the beginning of the step"},
        {"V", NameKind::value, "V", "view_from_world, rows of numbers: V[2][3] is row 3, column 4"},
        {"C", NameKind::value, "C", "world_from_view"},
        {"P", NameKind::value, "P", "clip_from_view, as uploaded"},
        {"PV", NameKind::value, "PV", "clip_from_world"},
        {"S", NameKind::value, "S", "shadow_from_world of the first plane and light"},
        {"R", NameKind::value, "R", "mirror_from_world of the first plane"},
        {"shadow_sign", NameKind::value, "shadow_sign", "1 or −1: the uploaded matrix is shadow_sign · S"},
        {"facts", NameKind::value, "facts.…", "as `viewing-sandbox matrices` prints them"},
        {"followed", NameKind::value, "followed.…", "the followed point, as `viewing-sandbox matrices` prints it"},
        {"problems", NameKind::value, "problems", "the sentences about problems"},
        {"answer", NameKind::value, "answer", "the entered answer: a number or a list of numbers"},
        {"depth_step", NameKind::measured, "depth_step(z)", "width of one stored code at eye distance z"},
        {"fighting", NameKind::measured, "fighting()", "as `measure --what fighting` prints it, at 1280x720"},
        {"visibility_counts", NameKind::measured, "visibility_counts()",
         "as `measure --what visibility --no-times` prints it, at 640x360"},
        {"mirror_ways", NameKind::measured, "mirror_ways()", "as `measure --what mirror` prints it, at 1280x720"},
        {"order", NameKind::measured, "order()", "as `measure --what order` prints it, at 1280x720"},
        {"bsp_order", NameKind::measured, "bsp_order()",
         "count: the number of BSP nodes; order: their numbers from 1, in the camera's drawing order, farthest first"},
        {"newell_step", NameKind::measured, "newell_step()",
         "one step of Newell's ladder, at visibility.step: test, action, and a and b with left, right, bottom, top, "
         "nearest, farthest"},
        {"pixel", NameKind::measured, "pixel(x, y)", "as `inspect` prints it, at 1280x720; (0, 0) is at the top left"},
        {"why", NameKind::measured, "why(x, y)", "as `inspect --why` prints it, at 1280x720"},
    };
    names.insert(names.end(), std::begin(others), std::end(others));
    for (const MathematicsName& name : mathematics_names())
        names.push_back(
            {std::string(name.name), NameKind::mathematics, std::string(name.form), std::string(name.help)});
    return names;
}

}  // namespace

const std::vector<ExpressionName>& expression_names() {
    static const std::vector<ExpressionName> names = all_names();
    return names;
}

std::string expression_names_as_text() {
    std::size_t widest = 0;
    for (const ExpressionName& name : expression_names()) widest = std::max(widest, character_count(name.form));
    std::string text;
    for (const ExpressionName& name : expression_names())
        text += name.form + std::string(widest + 2 - character_count(name.form), ' ') + name.help + "\n";
    return text;
}

}  // namespace viewing
