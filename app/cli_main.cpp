// lacuna: everything the workstation can compute, without a display.

#include <fmt/format.h>

#include <cstdio>
#include <new>
#include <set>

#include "app/command.h"

namespace lacuna::cli {

namespace {

/// "--name" of every flag that takes no value, of all subcommands.
void collect_switches(const CLI::App& app, std::set<std::string>& switches) {
    for (const CLI::Option* option : app.get_options())
        if (option->get_expected_max() == 0)
            for (const std::string& name : option->get_lnames()) switches.insert("--" + name);
    for (const CLI::App* command : app.get_subcommands({})) collect_switches(*command, switches);
}

/// Joins "--flag -5" to "--flag=-5", so that a negative value is never taken for a flag. A switch has no value.
std::vector<std::string> join_negative_values(int argc, char** argv, const std::set<std::string>& switches) {
    std::vector<std::string> words;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        const bool negative = word.size() > 1 && word[0] == '-' && (std::isdigit(word[1]) || word[1] == '.');
        const bool after_flag = !words.empty() && words.back().starts_with("--") && words.back().size() > 2 &&
                                words.back().find('=') == std::string::npos && !switches.count(words.back());
        if (negative && after_flag)
            words.back() += "=" + word;
        else
            words.push_back(word);
    }
    return words;
}

/// File names may hold anything; a terminal must not be steered by them.
std::string printable(std::string text) {
    for (char& c : text)
        if ((static_cast<unsigned char>(c) < 0x20 && c != '\n') || c == 0x7f) c = '?';
    return text;
}

int complain(const std::string& sentence, int status) {
    std::fprintf(stderr, "lacuna: %s\n", printable(sentence).c_str());
    return status;
}

int status_of(Errc code) {
    if (code == Errc::bad_usage) return 2;
    return code == Errc::cancelled ? 130 : 1;
}

/// What went wrong in one line, with the file or device concerned when the sentence does not name it.
std::string line_of(const Error& error) {
    std::string line = error.what();
    const std::string& about = error.about();
    if (!about.empty() && about.find('\n') == std::string::npos && line.find(about) == std::string::npos)
        line += " (" + about + ")";
    return line;
}

/// CLI11's complaint in this program's words, one line.
std::string line_of(const CLI::ParseError& error, const CLI::App& app) {
    std::string command = "lacuna";
    for (const CLI::App* chosen : app.get_subcommands()) command += " " + chosen->get_name();
    std::string what = error.what();
    if (const auto* extras = dynamic_cast<const CLI::ExtrasError*>(&error)) {
        std::vector<std::string> unknown = app.remaining(true);
        what = extras->what();
        if (!unknown.empty())
            what = (unknown.front().starts_with("-") ? "unknown flag "
                    : app.get_subcommands().empty()  ? "unknown command "
                                                     : "unexpected word ") +
                   unknown.front();
    }
    for (char& c : what)
        if (c == '\n') c = ' ';
    while (!what.empty() && (what.back() == ' ' || what.back() == '.')) what.pop_back();
    return fmt::format("{}; see {} --help.", what, command);
}

int run(int argc, char** argv) {
    Console console(Console::watch_signals());
    CLI::App app{
        "Lacuna shows and measures computed-tomography volumes.\n"
        "Not a medical device: not for diagnosis or treatment."};
    app.name("lacuna");
    app.set_version_flag("--version", std::string("lacuna ") + LACUNA_VERSION);
    app.set_help_flag("-h,--help", "show this and leave");
    app.footer(
        "Example: lacuna render sample:casting@192 --mode iso -o casting.png\n"
        "INPUT is a DICOM folder or file, .mhd .mha .nrrd .nhdr .nii .nii.gz .hdr, a TIFF stack, a raw file, or\n"
        "sample:NAME[@SIZE] with NAME one of casting, head, vessels, spheres, marschner-lobb.\n"
        "Exit status: 0 done, 1 could not be done, 2 wrong words in the call, 3 a part did not pass,\n"
        "130 interrupted.");
    app.require_subcommand(0, 1);
    app.fallthrough(false);
    app.get_formatter()->column_width(34);
    app.get_formatter()->label("TEXT", "VALUE");

    Action chosen;
    add_info_command(app, chosen);
    add_render_command(app, chosen);
    add_bench_command(app, chosen);
    add_regions_command(app, chosen);
    add_inspect_command(app, chosen);
    add_batch_command(app, chosen);
    add_convert_command(app, chosen);
    add_devices_command(app, chosen);
    add_tf_command(app, chosen);
    for (CLI::App* command : app.get_subcommands({}))
        command->add_flag("-q,--quiet", console.quiet,
                          "no progress, no notes; what could not be kept is said all the same");

    std::set<std::string> switches;
    collect_switches(app, switches);
    std::vector<std::string> words = join_negative_values(argc, argv, switches);
    std::reverse(words.begin(), words.end());  // what CLI11 asks for
    try {
        app.parse(std::move(words));
    } catch (const CLI::Success& done) {
        return app.exit(done);  // --help and --version
    } catch (const CLI::ParseError& error) {
        return complain(line_of(error, app), 2);
    }
    if (!chosen) return complain("no command given; see lacuna --help.", 2);

    try {
        const int status = chosen(console);
        console.say_at_end();
        console.clear_progress();
        return status;
    } catch (const Error& error) {
        console.clear_progress();
        return complain(error.code() == Errc::cancelled ? "interrupted." : line_of(error), status_of(error.code()));
    } catch (const std::bad_alloc&) {
        console.clear_progress();
        return complain("there is not enough memory; close other programs or use a smaller volume.", 1);
    } catch (const std::exception& error) {
        console.clear_progress();
        return complain(error.what(), 1);
    }
}

}  // namespace

}  // namespace lacuna::cli

int main(int argc, char** argv) { return lacuna::cli::run(argc, argv); }
