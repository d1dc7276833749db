#include "core/io/dicom_anonymise.h"

#include <dcmtk/config/osconfig.h>
// DCMTK's configuration comes first
#include <dcmtk/dcmdata/dctk.h>
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/base/atomic_folder.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/io/dicom_data_set_anonymiser.h"
#include "core/io/dicom_header.h"
#include "core/io/dicom_tags.h"

namespace lacuna {

namespace fs = std::filesystem;
using dicom::Pseudonyms;
using dicom::text_of;

namespace {

/// One file to export and where it goes.
struct Plan {
    fs::path file;
    std::string series;
    int instance = 0;
    fs::path target;  ///< below the export's folder
};

/// Kinds of images whose devices often draw names into the picture.
bool often_has_text(DcmDataset& set) {
    static const std::set<std::string> k_kinds = {"US", "OT", "XC", "ES", "GM", "RF",
                                                  "XA", "CR", "DX", "MG", "SC", "IO"};
    return k_kinds.contains(text_of(set, DCM_Modality)) || set.tagExists(DCM_ConversionType);
}

/// What one file adds to the report.
struct Counted {
    enum class What { exported, unreadable, burned_in } what = What::exported;
    bool burned_in = false, burned_in_unsaid = false, face = false;
    std::string study, patient;
};

/// The library does not report a disk that ran full when it closes a file: the length tells, of a deflated file that of
/// what comes out of it.
bool is_whole(const fs::path& written, DcmDataset& set, E_TransferSyntax syntax) {
    const std::uint32_t expected = set.calcElementLength(syntax, EET_ExplicitLength);
    std::error_code ec;
    const std::uintmax_t bytes = fs::file_size(written, ec);
    if (ec || bytes == 0) return false;
    if (syntax != EXS_DeflatedLittleEndianExplicit) return bytes >= expected;
    DcmFileFormat back;
    return back.loadFile(written.c_str()).good() &&
           back.getDataset()->calcElementLength(syntax, EET_ExplicitLength) >= expected;
}

Counted export_file(const Plan& plan, const fs::path& folder, const Pseudonyms& names,
                    const AnonymiseOptions& options) {
    Counted counted;
    DcmFileFormat source;
    // All of it: what cannot be read must not come up while writing, where it would look like a full disk.
    if (source.loadFile(plan.file.c_str()).bad() || source.loadAllDataIntoMemory().bad()) {
        counted.what = Counted::What::unreadable;
        return counted;
    }
    DcmDataset& set = *source.getDataset();
    const std::string stated = text_of(set, DCM_BurnedInAnnotation);
    counted.burned_in = stated == "YES";
    counted.burned_in_unsaid = stated.empty() && often_has_text(set);
    counted.face = text_of(set, DCM_RecognizableVisualFeatures) == "YES";
    if (counted.burned_in && !options.keep_burned_in) {
        counted.what = Counted::What::burned_in;
        return counted;
    }
    const std::string patient = names.patient(text_of(set, DCM_PatientID) + "\n" + text_of(set, DCM_PatientName));
    dicom::anonymise(set, names, patient, options.software);
    counted.patient = patient;
    counted.study = text_of(set, DCM_StudyInstanceUID);

    const fs::path target = folder / plan.target;
    const E_TransferSyntax syntax = set.getOriginalXfer();
    // Of a new file: preamble and meta group hold nothing of the old one's.
    DcmFileFormat made(&set, OFFalse);
    const OFCondition saved =
        made.saveFile(target.c_str(), syntax, EET_ExplicitLength, EGL_withoutGL, EPD_withoutPadding);
    (void)made.getAndRemoveDataset();
    if (saved.good() && is_whole(target, set, syntax)) return counted;
    if (saved.good() || saved == EC_InvalidStream || saved == EC_StreamNotifyClient)
        throw Error(Errc::io, "Cannot write the anonymised images to " + folder.parent_path().string() +
                                  ": the disk is full or the file size is limited; nothing was written.");
    std::error_code ec;
    fs::remove(target, ec);
    counted.what = Counted::What::unreadable;
    return counted;
}

/// What there is to export, by series and instance number; counts the rest.
std::vector<Plan> plan_export(const std::vector<fs::path>& files, AnonymiseReport& report, const JobContext& job) {
    std::vector<dicom::HeaderResult> headers(files.size());
    parallel_for(
        0, std::int64_t(files.size()),
        [&](std::int64_t i) {
            try {
                headers[std::size_t(i)] = dicom::read_header(files[std::size_t(i)]);
            } catch (const Error& error) {
                if (error.code() != Errc::io) throw;
                headers[std::size_t(i)].what = dicom::FileClass::locked;
            }
            headers[std::size_t(i)].file.lut = nullptr;
        },
        job);
    std::vector<Plan> plans;
    for (std::size_t i = 0; i < files.size(); ++i) {
        const dicom::HeaderResult& header = headers[i];
        switch (header.what) {
            case dicom::FileClass::image:
                plans.push_back({files[i],
                                 header.file.series_uid,
                                 header.file.frames.empty() ? 0 : header.file.frames.front().instance.value_or(0),
                                 {}});
                break;
            case dicom::FileClass::no_image:
                ++report.not_images;
                break;
            case dicom::FileClass::unreadable:
            case dicom::FileClass::locked:
                ++report.unreadable;
                break;
            case dicom::FileClass::not_dicom:
                break;
        }
    }
    std::stable_sort(plans.begin(), plans.end(), [](const Plan& a, const Plan& b) {
        return std::tie(a.series, a.instance) < std::tie(b.series, b.instance);
    });
    int series = 0, image = 0;
    for (std::size_t i = 0; i < plans.size(); ++i) {
        if (i == 0 || plans[i].series != plans[i - 1].series) ++series, image = 0;
        plans[i].target = fs::path(fmt::format("SE{:03d}", series)) / fmt::format("IM{:05d}.dcm", ++image);
    }
    return plans;
}

std::string counted_text(int count, const char* one, const char* many) {
    return count == 1 ? std::string("1 ") + one : fmt::format("{} {}", count, many);
}

}  // namespace

std::vector<std::string> AnonymiseReport::notes() const {
    std::vector<std::string> said;
    if (not_images > 0)
        said.push_back(
            counted_text(not_images, "DICOM file without an image was", "DICOM files without an image were") +
            " left out.");
    if (unreadable > 0)
        said.push_back(
            counted_text(unreadable, "DICOM file that cannot be read was", "DICOM files that cannot be read were") +
            " left out.");
    if (burned_in > 0)
        said.push_back(counted_text(burned_in, "image says", "images say") +
                       " that patient data are drawn into the pixels (0028,0301); the pixels are not cleaned.");
    if (burned_in_unsaid > 0)
        said.push_back(
            counted_text(burned_in_unsaid, "image does", "images do") +
            " not say whether text is drawn into the pixels (0028,0301); look at them before passing them on.");
    if (faces > 0)
        said.push_back(counted_text(faces, "image says", "images say") + " that a face can be recognised (0028,0302).");
    return said;
}

AnonymiseReport anonymise_dicom(const std::vector<fs::path>& files, const fs::path& folder,
                                const AnonymiseOptions& options, const JobContext& job) {
    dicom::prepare_dcmtk();
    AnonymiseReport report;
    const fs::path target = folder.has_filename() ? folder : folder.parent_path();
    AtomicFolder output(target);
    const std::vector<Plan> plans = plan_export(files, report, job.part(0, 0.2));
    if (plans.empty())
        throw Error(Errc::bad_input, "There is no DICOM image to anonymise; name a DICOM folder or file.");
    for (const Plan& plan : plans) fs::create_directory(output.path() / plan.target.parent_path());
    const Pseudonyms names(options.key);
    std::vector<Counted> counted(plans.size());
    parallel_for(
        0, std::int64_t(plans.size()),
        [&](std::int64_t i) {
            counted[std::size_t(i)] = export_file(plans[std::size_t(i)], output.path(), names, options);
        },
        job.part(0.2, 1));
    std::set<std::string> series, studies, patients;
    for (std::size_t i = 0; i < plans.size(); ++i) {
        const Counted& c = counted[i];
        report.burned_in += c.burned_in;
        report.unreadable += c.what == Counted::What::unreadable;
        if (c.what != Counted::What::exported) continue;
        ++report.images;
        report.burned_in_unsaid += c.burned_in_unsaid;
        report.faces += c.face;
        series.insert(plans[i].series);
        studies.insert(c.study);
        patients.insert(c.patient);
    }
    if (report.images == 0)
        throw Error(Errc::bad_input,
                    "None of the DICOM images can be exported: they cannot be read, or say that patient data are drawn "
                    "into their pixels.");
    report.series = int(series.size());
    report.studies = int(studies.size());
    report.patients = int(patients.size());
    std::error_code ec;
    for (const auto& entry : fs::directory_iterator(output.path(), ec))
        fs::remove(entry.path(), ec);  // empty ones only
    output.commit();
    return report;
}

}  // namespace lacuna
