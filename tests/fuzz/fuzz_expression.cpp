// libFuzzer: evaluates arbitrary text as an expression in a lesson from an untrusted author. Evaluation must finish
// quickly, with a value that can be written or with a one-sentence error.
#include "fuzz.h"
#include "lesson/formulas/expression.h"

using namespace viewing;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(fuzz::as_text(data, size));
    const Surroundings surroundings{[](const std::string&, std::span<const double> arguments) -> Result<Json> {
                                        return Json(static_cast<double>(arguments.size()));
                                    },
                                    Json{1, 2, 3}, Json{{"P", {0, 1, 0, 0}}, {"k", 2}}};
    const std::string names[] = {"P", "k"};
    const Status can_be = check_expression(text, names);
    if (!can_be) fuzz::check_message(can_be.error());
    ExpressionLimits limits{.instructions = 20'000, .memory_bytes = 1U << 20U, .measured_call = 1000};
    for (const bool closed_list : {true, false}) {
        limits.closed_list = closed_list;
        const Result<Json> value = evaluate(text, surroundings, limits);
        if (value)
            fuzz::check(!value->dump().empty());
        else
            fuzz::check_message(value.error());
        if (closed_list && value) fuzz::check(static_cast<bool>(can_be));
    }
    return 0;
}
