// Tests the command line itself: help, version, and misspelled and missing arguments.
#include <gtest/gtest.h>

#include <cstdio>
#include <sstream>

#include "cli/program.h"

namespace cli_tests {
namespace {

class Usage : public Program {};

const std::vector<std::string> command_names{"open",  "snapshot", "compare", "matrices", "inspect", "measure",
                                             "state", "params",   "presets", "doctor",   "lesson",  "lecture"};

TEST_F(Usage, HelpNamesEveryCommandAndEveryExitStatus) {
    for (const char* asked : {"--help", "-h", "help"}) {
        const std::string help = expect(0, {asked}).out;
        for (const std::string& name : command_names) EXPECT_TRUE(has(help, "\n  " + name + " ")) << name;
        for (int status = 0; status <= 9; ++status)
            EXPECT_TRUE(has(help, "\n  " + std::to_string(status) + "  ")) << status;
        EXPECT_TRUE(has(help, "Examples:"));
    }
}

TEST_F(Usage, EveryCommandHasHelpWithUsageExamplesAndExitStatus) {
    for (const std::string& name : command_names) {
        const std::string help = expect(0, {name, "--help"}).out;
        for (const std::string& part : {"Usage: viewing-sandbox " + name, std::string("Examples:"),
                                        std::string("Exit status:"), std::string("  2  bad usage")})
            EXPECT_TRUE(has(help, part)) << name << ": " << part << "\n" << help;
        EXPECT_TRUE(expect(0, {"help", name}).out.ends_with(help)) << name;  // below the topic of the same name
    }
}

TEST_F(Usage, HelpTakesPrecedenceOverErrors) {
    expect(0, {"snapshot", "--nonsense", "--help"});
    expect(0, {"inspect", "-h"});
}

TEST_F(Usage, HelpFitsATerminal) {
    for (const std::string& name : command_names) {
        std::istringstream lines(expect(0, {name, "--help"}).out);
        for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 130U) << name << ": " << line;
    }
}

TEST_F(Usage, VersionIsThreeNumbers) {
    const std::string version = expect(0, {"--version"}).out;
    int major = -1, minor = -1, patch = -1;
    EXPECT_EQ(std::sscanf(version.c_str(), "viewing-sandbox %d.%d.%d\n", &major, &minor, &patch), 3) << version;
}

TEST_F(Usage, AMisspelledCommandSuggestsTheNearest) {
    refused({"snapshto", "-o", "x.png"}, {"snapshto", "did you mean the command snapshot?"});
    refused({"matrix"}, {"matrix"});
    refused({"doctr"}, {"did you mean the command doctor?"});
}

TEST_F(Usage, AMisspelledOptionSuggestsTheNearest) {
    refused({"snapshot", "--siez", "10x10", "-o", "x.png"}, {"--siez", "no such option", "--size"});
    refused({"matrices", "--fromat=json"}, {"--fromat", "--format"});
    refused({"open", "--nonsense"}, {"--nonsense", "no such option", "open --help"});
    refused({"--sett", "projection.near=1"}, {"--sett", "--set"});
}

TEST_F(Usage, AMissingOrRepeatedValueIsNamed) {
    refused({"snapshot", "-o"}, {"--output", "needs a value"});
    refused({"matrices", "--set"}, {"--set", "needs a value"});
    refused({"snapshot", "-o", "a.png", "-o", "b.png"}, {"--output", "more than once"});
    refused({"matrices", "a", "b"}, {"\"b\"", "unexpected argument"});
}

TEST_F(Usage, RequiredOptionsAreNamed) {
    refused({"snapshot"}, {"-o OUT.png or --compare REF.png is required"});
    refused({"inspect"}, {"--pixel is missing"});
    refused({"measure"}, {"--what is missing"});
    refused({"compare", "a.png"}, {"two pictures"});
}

TEST_F(Usage, ValuesOutsideTheirRangeAreRefused) {
    for (const char* size : {"0x10", "10", "axb", "-5x10", "16385x1", "1x16385", "16384x16384", "10x10x10", "1e3x10",
                             "99999999999x1", "", "10 x10"})
        refused({"snapshot", "--view", "camera", "-o", "x.png", "--size", size}, {"--size", "must be"});
    refused({"snapshot", "-o", "x.png", "--size", "319x240"}, {"--size", "320x240"});
    refused({"measure", "--what", "visibility", "--size", "2049x2048"}, {"--size", "at most 4 million pixels"});
    refused({"snapshot", "-o", "x.png", "--samples", "2"}, {"--samples", "0 or 4"});
    refused({"snapshot", "-o", "x.png", "--repeat", "0"}, {"--repeat", "from 1"});
    refused({"snapshot", "-o", "x.png", "--timeout", "0"}, {"--timeout"});
    refused({"snapshot", "-o", "x.png", "--timeout", "nan"}, {"--timeout"});
    refused({"snapshot", "-o", "x.png", "--view", "camra"}, {"--view", "did you mean camera?"});
    refused({"snapshot", "-o", "x.png", "--device", "first"}, {"--device"});
    refused({"snapshot", "-o", "x.png", "--worst", "3"}, {"--compare"});
    refused({"snapshot", "-o", "-", "--json", "-"}, {"standard output"});
    refused({"matrices", "--format", "jsn"}, {"--format", "did you mean json?"});
    refused({"params", "--format", "xml"}, {"--format", "json, text, schema"});
    refused({"inspect", "--pixel", "1280,0"}, {"--pixel", "0 to 1279"});
    refused({"inspect", "--pixel", "-1,0"}, {"--pixel"});
    refused({"inspect", "--pixel", "12"}, {"--pixel"});
    refused({"compare", "a.png", "b.png", "--worst", "256"}, {"--worst", "0 to 255"});
    refused({"compare", "a.png", "b.png", "--share", "1.5"}, {"--share", "0 to 1"});
}

/// Results name their inputs and are UTF-8, so they could not contain a name that is not UTF-8.
TEST_F(Usage, InvalidUtf8IsRefusedWithItsPosition) {
    write("caf\xe9.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    refused({"state", "caf\xe9.obj"}, {"argument 2: caf\\xe9.obj: not UTF-8"});
    refused({"exercises", "--student", "32\xff", "--format", "json"}, {"argument 3: 32\\xff: not UTF-8"});
    refused({"snapshot", "-o", "\xff.png"}, {"argument 3: \\xff.png: not UTF-8"});
    write("caf\xc3\xa9.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_TRUE(has(expect(0, {"state", "caf\xc3\xa9.obj"}).out, "caf\xc3\xa9.obj"));
}

TEST_F(Usage, AVeryLongNameLeavesRoomForTheReason) {
    const Ended ended = expect(2, {"state", std::string(50'000, '[') + "/x.json"});
    EXPECT_LT(ended.err.size(), 2'100U);
    EXPECT_TRUE(has(ended.err, "[[[ … [[[")) << ended.told();
    EXPECT_TRUE(has(ended.err, "x.json: ")) << ended.told();
}

TEST_F(Usage, MeasureListsItsOptions) {
    refused({"measure"}, {"--what is missing", "visibility, growth, fighting"});
    refused({"measure", "--what", "fighting", "--max", "10"}, {"--max needs --what growth"});
    refused({"measure", "--what", "fighting", "--size", "0x9"}, {"--size"});
    refused({"measure", "--what", "fighting", "--device", "no"}, {"--device"});
    refused({"measure", "--what", "luck"}, {"visibility, growth, fighting"});
    refused({"measure", "--what", "visibilty"}, {"did you mean visibility?"});
    refused({"measure", "--what", "visibility", "--format", "csv"}, {"--format needs --what growth"});
    refused({"measure", "--what", "visibility", "--max", "10"}, {"--max needs --what growth"});
    refused({"measure", "--what", "visibility", "--polygons", "large"}, {"--polygons needs --what growth"});
    refused({"measure", "--what", "visibility", "--size", "0x9"}, {"--size"});
    refused({"measure", "--what", "visibility", "--timeout", "-1"}, {"--timeout"});
    refused({"measure", "--what", "growth", "--device", "auto"}, {"--device needs --what visibility"});
    refused({"measure", "--what", "growth", "--max", "0"}, {"--max", "1"});
    refused({"measure", "--what", "growth", "--max", "1000001"}, {"--max", "1000000"});
    refused({"measure", "--what", "growth", "--polygons", "huge"}, {"--polygons", "small, large, scene"});
    refused({"measure", "--what", "growth", "--format", "xml"}, {"--format", "json or csv"});
}

}  // namespace
}  // namespace cli_tests
