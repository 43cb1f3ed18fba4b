// Does with a field what its kind says. The folder kinds declares each kind once: its name; its form, which reads a
// value, says what is allowed, and makes the schema; how a value is written; and how a value is clamped and blended.
// Code that needs a window or a random generator is elsewhere, with an overload for each type:
// ui/parts/field_controls.cpp draws the controls, and the tests' random_params.h makes random values.
#include "state/kinds/choice_kinds.h"
#include "state/kinds/matrix_kinds.h"
#include "state/kinds/object_kinds.h"

namespace viewing {
namespace {

/// Calls use(kind, ref) with the kind of a field and the reference to its value.
template <typename Use>
auto of_kind(const FieldRef& field, const Use& use) {
    return std::visit([&](const auto& ref) { return use(kinds::Kind<std::decay_t<decltype(ref)>>(), ref); }, field);
}

}  // namespace

std::string_view type_name(const Field& field) {
    return of_kind(kinds::default_ref(field), [](auto kind, const auto&) { return kind.type; });
}

bool has_range(const Field& field) {
    return of_kind(kinds::default_ref(field), [](auto kind, const auto&) { return kind.has_range; });
}

std::vector<std::string> allowed_names(const Field& field) {
    return of_kind(kinds::default_ref(field), [&](auto kind, const auto&) { return kind.names(field); });
}

std::string allowed_text(const Field& field) {
    return of_kind(kinds::default_ref(field), [&](auto kind, const auto&) { return kind.form(field).what; });
}

Json value_schema(const Field& field) {
    Json none;
    return of_kind(kinds::default_ref(field), [&](auto kind, const auto&) { return kind.form(field).schema(none); });
}

void read_field(const Field& field, Params& params, const Json& value, const Where& where, std::size_t element) {
    of_kind(field.in(params, element),
            [&](auto kind, const auto& to) { kind.assign(to, kind.form(field).read(value, where)); });
}

Json field_as_json(const Field& field, Params& params, std::size_t element) {
    return of_kind(field.in(params, element), [](auto kind, const auto& value) { return kind.write(value); });
}

void clamp_field(const Field& field, Params& params, std::size_t element) {
    const FieldRef fallback = kinds::default_ref(field);
    of_kind(field.in(params, element),
            [&]<typename Ref>(auto kind, const Ref& value) { kind.clamp(value, std::get<Ref>(fallback), field); });
}

void blend_field(const Field& field, Params& from, Params& to, double share, std::size_t element) {
    const FieldRef source = field.in(from, element);
    of_kind(field.in(to, element),
            [&]<typename Ref>(auto kind, const Ref& value) { kind.blend(std::get<Ref>(source), value, share, field); });
}

}  // namespace viewing
