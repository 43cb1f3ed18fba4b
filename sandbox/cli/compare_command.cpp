// compare: compares two PNG files.
#include <cstdio>

#include "cli/commands.h"
#include "cli/ending_report.h"
#include "cli/option_values.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/thresholds.h"
#include "image/compare.h"
#include "image/png.h"

namespace viewing {
namespace {

/// The options as typed.
struct TypedCompare {
    std::string a, b;
    std::optional<std::string> output, json;
};

void declare_pictures(Options& options, TypedCompare& typed) {
    options.group("Pictures");
    options.positional("A.png", typed.a, "The picture to check; - for standard input");
    options.positional("B.png", typed.b, "The picture to compare it with; - for standard input");
}

void declare_outputs(Options& options, TypedCompare& typed) {
    options.group("Output");
    options.text("-o,--output", "DIFF.png", typed.output,
                 "Writes a picture of the differences: A in faint gray, small differences in blue, edges sampled "
                 "differently in yellow, differences beyond the threshold in orange-red, and areas that are in only "
                 "one picture in violet");
    options.text("--json", "FILE|-", typed.json, ending_report_help);
}

std::vector<FileArgument> outputs_of(const TypedCompare& typed) {
    std::vector<FileArgument> outputs;
    if (typed.output) outputs.push_back({"-o", *typed.output});
    if (typed.json) outputs.push_back({"--json", *typed.json});
    return outputs;
}

std::vector<FileArgument> inputs_of(const TypedCompare& typed, const ThresholdOptions& thresholds) {
    std::vector<FileArgument> inputs = thresholds.files();
    inputs.push_back({"A.png", typed.a});
    inputs.push_back({"B.png", typed.b});
    return inputs;
}

Image picture(const std::string& name) {
    return value_or_end(name == "-" ? read_png(stdin, "standard input") : read_png(name));
}

ExitStatus compare(const Options& options, const TypedCompare& typed, const ThresholdOptions& thresholds,
                   EndingReport& report) {
    if (typed.a.empty() || typed.b.empty()) options.refuse("two pictures are needed: A.png B.png");
    if (typed.a == "-" && typed.b == "-") options.refuse("A.png and B.png cannot both be standard input");
    report.begin();
    const CompareOptions limits = thresholds.values();
    const MaskSource left_out = thresholds.mask();
    if (typed.output) check_picture_name(options, "-o", *typed.output);
    const Image a = picture(typed.a), b = picture(typed.b);
    const Mask mask = value_or_end(mask_of(left_out, a.width, a.height));

    const CompareReport found = compare_images(a, b, limits, mask);
    const Json facts = Json::parse(as_json(found));
    for (const auto& [name, value] : facts.items())
        if (name != "sentence") report.tell(name.c_str(), value);
    Outputs outputs;
    if (typed.output) outputs.add(*typed.output, encode_png(diff_picture(a, b, limits, mask)));
    const ExitStatus status = found.equal ? ExitStatus::done : ExitStatus::different;
    const bool is_deep = has_16_bits(typed.a) || has_16_bits(typed.b);
    const std::string said = sentence(found) + (is_deep ? "; of 16-bit channels, only the upper 8 bits count" : "");
    report.finish(outputs, status, said);
    const bool stdout_is_taken = typed.output == "-" || typed.json == "-";
    if (!stdout_is_taken) print(said + "\n");
    return status;
}

ExitStatus run_compare(const Command& self, const Arguments& arguments) {
    Options options(self);
    TypedCompare typed;
    declare_pictures(options, typed);
    const ThresholdOptions thresholds(options);
    declare_outputs(options, typed);
    EndingReport report(self, options, typed.json, [&] {
        return NamedFiles{outputs_of(typed), inputs_of(typed, thresholds)};
    });
    return report.guard([&] {
        if (!options.parse(arguments)) return ExitStatus::done;
        for (const auto& [name, file] : {std::pair("a", &typed.a), {"b", &typed.b}})
            report.tell(name, file->empty() ? Json() : name_as_json(*file));
        report.tell("masks", thresholds.masks_as_json());
        report.tell("output", name_as_json(typed.output));
        report.tell("equal", Json());
        return compare(options, typed, thresholds, report);
    });
}

}  // namespace

constinit const Command compare_command{
    "compare",
    "A.png B.png [--profile strict|portable] [--mask …] [-o DIFF.png] [--json FILE|-] [OPTIONS]",
    "compares two PNG files: how many pixels differ, by how much at most, and where",
    "Says in one line whether two pictures are equal within thresholds. A pixel counts as different if a channel "
    "differs by more than --worst levels; the pictures are equal if the fraction of such pixels is at most --share. "
    "The portable profile does not count edges that are sampled differently, and allows neither a block of five "
    "different pixels nor a shift of the mean by more than 0.6 levels in any 16 × 16 pixels. Pictures of different "
    "sizes are different. Channels of 16 bits are compared by their upper 8. A picture has at most 16384 pixels per "
    "side and 64 million in total.",
    "compare mine.png reference.png\n"
    "compare mine.png reference.png --worst 3 --share 0.001 -o difference.png\n"
    "compare mine.png reference.png --profile portable --mask 0,0,120,40 --json report.json\n"
    "snapshot --view camera -o - | viewing-sandbox compare - reference.png",
    "01289",
    run_compare};

}  // namespace viewing
