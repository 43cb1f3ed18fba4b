// compare: two PNG files.
#include "cli/commands.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/thresholds.h"
#include "cli/values.h"
#include "image/compare.h"
#include "image/png.h"
#include "state/document.h"

namespace viewing {
namespace {

ExitStatus run(const Command& self, const Arguments& arguments) {
    Options options(self);
    std::string a_file, b_file;
    options.group("Pictures");
    options.positional("A.png", a_file, "The picture that is looked at");
    options.positional("B.png", b_file, "What it is compared with");
    ThresholdOptions thresholds(options);
    std::optional<std::string> output, json;
    options.group("Output");
    options.text("-o,--output", "DIFF.png", output,
                 "Writes a picture of the differences: A in faint grey, small differences blue, those beyond the "
                 "threshold orange-red, what only one picture has violet");
    options.text("--json", "FILE|-", json, "Writes the whole report as JSON; - for standard output");
    if (!options.parse(arguments)) return ExitStatus::done;

    if (a_file.empty() || b_file.empty()) options.refuse("two pictures are needed: " + std::string(self.synopsis));
    const CompareOptions limits = thresholds.values();
    if (output) check_picture_name(options, "-o", *output);
    std::vector<FileArgument> written;
    if (output) written.push_back({"-o", *output});
    if (json) written.push_back({"--json", *json});
    check_outputs(options, written, std::vector<FileArgument>{{"A.png", a_file}, {"B.png", b_file}});
    const Image a = value_or_end(read_png(a_file));
    const Image b = value_or_end(read_png(b_file));

    const CompareReport report = compare_images(a, b, limits);
    Outputs outputs;
    if (output) outputs.add(*output, encode_png(diff_picture(a, b, limits)));
    if (json) outputs.add(*json, print_document(Json::parse(as_json(report))) + "\n");
    outputs.write();
    const bool stdout_is_taken = output == "-" || json == "-";
    if (!stdout_is_taken) print(sentence(report) + "\n");
    return report.equal ? ExitStatus::done : ExitStatus::different;
}

}  // namespace

constinit const Command compare_command{
    "compare",
    "A.png B.png [--worst N] [--share F] [-o DIFF.png] [--json FILE|-]",
    "how much two PNG files differ, by how much at worst, and where",
    "Says in one line whether two pictures are equal within thresholds. A pixel counts as different when a channel "
    "differs by more than --worst levels; the pictures are equal when at most the share --share of the pixels does. "
    "Different sizes are a difference. A picture has at most 16384 pixels a side and 64 million in all.",
    "compare mine.png reference.png\n"
    "compare mine.png reference.png --worst 3 --share 0.001 -o difference.png",
    "01289",
    run};

}  // namespace viewing
