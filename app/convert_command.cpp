// lacuna convert: an input in another format.

#include <fmt/format.h>

#include <algorithm>

#include "app/command.h"
#include "app/input_options.h"
#include "core/base/atomic_folder.h"
#include "core/io/dicom_anonymise.h"
#include "core/io/folder_listing.h"
#include "core/io/volume_writer.h"

namespace lacuna::cli {

namespace {

/// Bytes up to which a volume is converted in one piece: what goes into a file as it is need not be gathered first.
std::uint64_t most_at_once(const InputOptions& input, const std::string& target) {
    constexpr std::uint64_t k_worth_parts = std::uint64_t(256) << 20;
    const bool plain = target.ends_with(".raw") || target.ends_with(".mhd");
    return plain ? std::min(k_worth_parts, input.memory_limit_bytes()) : input.memory_limit_bytes();
}

struct AnonymiseWords {
    bool wanted = false, keep_burned_in = false;
};

/// The files an anonymised export takes: all under the input, or those of the series named.
std::vector<std::filesystem::path> files_to_anonymise(const InputOptions& input, const Console& console) {
    if (input.open.series.empty()) return files_under(input.input, console.job("Looking")).files;
    for (const SeriesEntry& entry : list_series(input.input, console.job("Looking")))
        if (std::to_string(entry.number) == input.open.series || entry.uid == input.open.series) return entry.files;
    throw Error(Errc::bad_usage, "There is no series '" + input.open.series + "' in " + input.input + "; lacuna info " +
                                     input.input + " lists what it holds.");
}

int anonymise(const InputOptions& input, const std::string& target, const AnonymiseWords& words, Console& console) {
    if (!input.open.raw.empty() || !input.spacing_text.empty() || !input.smooth_text.empty())
        throw Error(Errc::bad_usage,
                    "--anonymise copies DICOM images as they are; leave out --raw, --spacing and --smooth.");
    if (input.input.starts_with("sample:"))
        throw Error(Errc::bad_usage, "--anonymise needs DICOM images; " + input.input + " is a built-in sample.");
    AtomicFolder::check(target);
    AnonymiseOptions options;
    options.keep_burned_in = words.keep_burned_in;
    options.software = std::string("Lacuna ") + LACUNA_VERSION;
    const AnonymiseReport report =
        anonymise_dicom(files_to_anonymise(input, console), target, options, console.job("Anonymising"));
    const auto count = [](int n, const char* one, const char* many) {
        return fmt::format("{} {}", n, n == 1 ? one : many);
    };
    console.note(count(report.images, "image", "images") + " of " + count(report.series, "series", "series") + ", " +
                 count(report.studies, "study", "studies") + " and " + count(report.patients, "patient", "patients") +
                 " written.");
    for (const std::string& note : report.notes()) console.note_at_end("note: " + note);
    return 0;
}

}  // namespace

void add_convert_command(CLI::App& app, Action& chosen) {
    CLI::App* command = app.add_subcommand("convert", "write an input in another format");
    command->footer(
        "Example: lacuna convert scans/head head.nrrd\n"
        "OUT ends in .nrrd, .mhd, .nii, .nii.gz or .raw (with a .dat beside it); a folder name takes a DICOM\n"
        "series. A large raw volume, a large sample or anything not packed goes into .raw and .mhd in parts:\n"
        "lacuna convert sample:casting@2048x2048x1024 large.mhd\n"
        "Without patients' data: lacuna convert scans/head shared/head --anonymise");
    auto input = std::make_shared<InputOptions>();
    auto target = std::make_shared<std::string>();
    input->add_to(*command);
    input->add_smooth(*command);
    command->add_option("OUT", *target, "file or folder to write")->required();
    auto words = std::make_shared<AnonymiseWords>();
    command->add_flag("--anonymise", words->wanted,
                      "write the DICOM images of INPUT (of --series, else all) into a new folder OUT without the "
                      "patients' data: basic profile of PS3.15 Annex E, new UIDs");
    command
        ->add_flag("--keep-burned-in", words->keep_burned_in,
                   "with --anonymise: also images that say patient data are drawn into their pixels")
        ->needs("--anonymise");
    command->callback([&chosen, input, target, words] {
        chosen = [input, target, words](Console& console) {
            input->check();
            if (words->wanted) return anonymise(*input, *target, *words, console);
            const Volume volume = input->load_or_leave(most_at_once(*input, *target), console);
            write_volume(volume, *target, console.job("Writing"));
            return 0;
        };
    });
}

}  // namespace lacuna::cli
