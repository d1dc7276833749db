#include "core/io/dicom_catalogue.h"

#include <dcmtk/config/osconfig.h>
// DCMTK's configuration comes first
#include <dcmtk/dcmdata/dcdicdir.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <map>
#include <mutex>
#include <optional>
#include <tuple>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/io/dicom_header.h"
#include "core/io/dicom_tags.h"
#include "core/io/folder_listing.h"
#include "core/io/random_access_file.h"
#include "core/io/text_fields.h"
#include "core/io/volume_reader.h"

namespace lacuna {

namespace fs = std::filesystem;
using dicom::text_of;

namespace {

constexpr auto k_between_reports = std::chrono::milliseconds(200);

/// One image file with all that says where it belongs.
struct Item {
    CataloguePatient patient;
    CatalogueStudy study;
    CatalogueSeries series;
    int instance = 0;
};

int whole_number(DcmItem& item, const DcmTagKey& tag) {
    try {
        return dicom::integer_of(item, tag).value_or(0);
    } catch (const std::exception&) {
        return 0;  // only shown and sorted by
    }
}

void fill_patient(DcmItem& item, CataloguePatient& patient) {
    patient.id = text_of(item, DCM_PatientID);
    patient.name = text_of(item, DCM_PatientName);
    patient.birth_date = text_of(item, DCM_PatientBirthDate);
    patient.sex = text_of(item, DCM_PatientSex);
}

void fill_study(DcmItem& item, CatalogueStudy& study) {
    study.uid = text_of(item, DCM_StudyInstanceUID);
    study.date = text_of(item, DCM_StudyDate);
    study.description = text_of(item, DCM_StudyDescription);
    study.accession = text_of(item, DCM_AccessionNumber);
}

void fill_series(DcmItem& item, CatalogueSeries& series) {
    series.uid = text_of(item, DCM_SeriesInstanceUID);
    series.modality = text_of(item, DCM_Modality);
    series.description = text_of(item, DCM_SeriesDescription);
    series.number = whole_number(item, DCM_SeriesNumber);
}

enum class Looked { image, other, unreadable };

/// The header of one file; everything before its pixels.
Looked look_at(const fs::path& file, Item& item) {
    try {
        const RandomAccessFile bytes(file);
        std::array<std::byte, 256> start{};
        const std::size_t got = bytes.read(0, start);
        if (!dicom::starts_like_dicom({reinterpret_cast<const char*>(start.data()), got})) return Looked::other;
    } catch (const Error&) {
        return Looked::unreadable;
    }
    DcmFileFormat format;
    const bool read = format
                          .loadFileUntilTag(file.c_str(), EXS_Unknown, EGL_noChange, DCM_MaxReadLength, ERM_autoDetect,
                                            DcmTagKey(0x7FE0, 0))
                          .good();
    DcmDataset& set = *format.getDataset();
    const bool image = set.tagExists(DCM_Rows) && set.tagExists(DCM_Columns);
    if (!read || !image) return read || !image ? Looked::other : Looked::unreadable;
    (void)set.convertToUTF8();
    fill_patient(set, item.patient);
    fill_study(set, item.study);
    fill_series(set, item.series);
    item.series.columns = whole_number(set, DCM_Columns);
    item.series.rows = whole_number(set, DCM_Rows);
    item.series.images = std::max(1, whole_number(set, DCM_NumberOfFrames));
    item.series.files = {file};
    item.instance = whole_number(set, DCM_InstanceNumber);
    return Looked::image;
}

/// Images put together into patients, studies and series.
Catalogue gathered(const std::vector<const Item*>& items) {
    struct OpenSeries {
        CatalogueSeries series;
        std::vector<std::pair<int, fs::path>> files;
    };
    struct OpenStudy {
        CatalogueStudy study;
        std::map<std::tuple<int, std::string>, OpenSeries> series;
    };
    struct OpenPatient {
        CataloguePatient patient;
        std::map<std::string, OpenStudy> studies;
    };
    std::map<std::tuple<std::string, std::string>, OpenPatient> patients;
    for (const Item* item : items) {
        OpenPatient& patient = patients[{lower_case(item->patient.name), item->patient.id}];
        if (patient.studies.empty()) patient.patient = item->patient;
        OpenStudy& study = patient.studies[item->study.uid];
        if (study.series.empty()) study.study = item->study;
        OpenSeries& series = study.series[{item->series.number, item->series.uid}];
        const int images = series.series.images;
        if (series.files.empty()) series.series = item->series;
        series.series.images = images + item->series.images;
        for (const fs::path& file : item->series.files) series.files.push_back({item->instance, file});
    }
    Catalogue catalogue;
    for (auto& [patient_key, patient] : patients) {
        for (auto& [study_uid, study] : patient.studies) {
            for (auto& [series_key, series] : study.series) {
                std::sort(series.files.begin(), series.files.end());
                series.series.files.clear();
                for (const auto& [instance, file] : series.files) series.series.files.push_back(file);
                study.study.series.push_back(std::move(series.series));
            }
            patient.patient.studies.push_back(std::move(study.study));
        }
        std::stable_sort(patient.patient.studies.begin(), patient.patient.studies.end(),
                         [](const CatalogueStudy& a, const CatalogueStudy& b) { return a.date > b.date; });
        catalogue.patients.push_back(std::move(patient.patient));
    }
    return catalogue;
}

Catalogue scan_folder(const fs::path& folder, const JobContext& job,
                      const std::function<void(const Catalogue&)>& found) {
    const FolderListing listing = files_under(folder, job);
    const std::vector<fs::path>& files = listing.files;
    std::vector<Item> items(files.size());
    std::vector<Looked> looked(files.size(), Looked::other);
    std::vector<const Item*> images;
    std::mutex mutex;
    int unreadable = 0, seen = 0;
    auto told = std::chrono::steady_clock::now();
    parallel_for(
        0, std::int64_t(files.size()),
        [&](std::int64_t i) {
            const Looked what = look_at(files[std::size_t(i)], items[std::size_t(i)]);
            std::optional<Catalogue> so_far;
            {
                const std::lock_guard lock(mutex);
                looked[std::size_t(i)] = what;
                ++seen;
                unreadable += what == Looked::unreadable;
                if (what == Looked::image) images.push_back(&items[std::size_t(i)]);
                const auto now = std::chrono::steady_clock::now();
                // Gathering grows with what is there: told ever more rarely, it stays a small share of the work.
                const auto pause = k_between_reports + std::chrono::microseconds(20 * images.size());
                if (found && now - told > pause) {
                    told = now;
                    so_far = gathered(images);
                    so_far->files = seen;
                    so_far->unreadable = unreadable;
                }
            }
            if (so_far) found(*so_far);
        },
        job);
    images.clear();  // in the order of the files: the same result for any number of threads
    for (std::size_t i = 0; i < files.size(); ++i)
        if (looked[i] == Looked::image) images.push_back(&items[i]);
    Catalogue catalogue = gathered(images);
    catalogue.files = int(files.size()) + listing.empty;
    catalogue.unreadable = unreadable;
    return catalogue;
}

/// The file a directory record names, below the DICOMDIR's folder; nothing for a path that leads elsewhere.
std::optional<fs::path> referenced_file(DcmItem& record, const fs::path& root) {
    fs::path relative;
    for (unsigned long i = 0; i < 8; ++i) {
        const std::string part = text_of(record, DCM_ReferencedFileID, i);
        if (part.empty()) break;
        if (part == "." || part == ".." || part.find('/') != std::string::npos) return std::nullopt;
        relative /= part;
    }
    if (relative.empty()) return std::nullopt;
    return root / relative;
}

/// A path as it is spelled on the disk: media are often copied in lower case.
std::optional<fs::path> on_disk(const fs::path& wanted, const fs::path& root) {
    std::error_code ec;
    if (fs::is_regular_file(wanted, ec)) return wanted;
    const fs::path lower = root / lower_case(fs::relative(wanted, root, ec).string());
    if (!ec && fs::is_regular_file(lower, ec)) return lower;
    return std::nullopt;
}

/// DCMTK takes any file for a directory, an empty one if need be.
bool is_dicomdir(const fs::path& file) {
    DcmFileFormat format;
    return format.loadFile(file.c_str()).good() && format.getDataset()->tagExists(DCM_DirectoryRecordSequence);
}

Catalogue read_dicomdir(const fs::path& file, const JobContext& job) {
    if (!is_dicomdir(file))
        throw Error(Errc::bad_input,
                    "Cannot read " + file.string() + ": it is no DICOMDIR, or a damaged one; open its folder.");
    DcmDicomDir directory(file.c_str());
    std::vector<Item> items;
    Catalogue counts;
    const fs::path root = file.parent_path();
    DcmDirectoryRecord& top = directory.getRootRecord();
    const auto each = [](DcmDirectoryRecord& parent, E_DirRecType type, auto&& visit) {
        for (unsigned long i = 0; i < parent.cardSub(); ++i)
            if (DcmDirectoryRecord* record = parent.getSub(i); record && record->getRecordType() == type) {
                (void)record->convertToUTF8();
                visit(*record);
            }
    };
    const auto count = std::max(1ul, top.cardSub());
    unsigned long done = 0;
    each(top, ERT_Patient, [&](DcmDirectoryRecord& patient) {
        Item item;
        fill_patient(patient, item.patient);
        each(patient, ERT_Study, [&](DcmDirectoryRecord& study) {
            fill_study(study, item.study);
            each(study, ERT_Series, [&](DcmDirectoryRecord& series) {
                item.series = {};
                fill_series(series, item.series);
                each(series, ERT_Image, [&](DcmDirectoryRecord& image) {
                    ++counts.files;
                    const auto named = referenced_file(image, root);
                    const auto there = named ? on_disk(*named, root) : std::nullopt;
                    if (!there) {
                        ++counts.missing;
                        return;
                    }
                    item.series.files = {*there};
                    item.series.images = std::max(1, whole_number(image, DCM_NumberOfFrames));
                    item.series.columns = whole_number(image, DCM_Columns);
                    item.series.rows = whole_number(image, DCM_Rows);
                    item.instance = whole_number(image, DCM_InstanceNumber);
                    items.push_back(item);
                });
                job.check();
            });
        });
        job.checkpoint(++done, count);
    });
    std::vector<const Item*> all;
    for (const Item& item : items) all.push_back(&item);
    Catalogue catalogue = gathered(all);
    catalogue.files = counts.files;
    catalogue.missing = counts.missing;
    return catalogue;
}

/// The window of a picture's values: percentiles 1 and 99.
std::pair<double, double> window_of(std::vector<double> values) {
    std::erase_if(values, [](double v) { return !std::isfinite(v); });
    if (values.empty()) return {0, 1};
    std::sort(values.begin(), values.end());
    return {values[values.size() / 100], values[values.size() - 1 - values.size() / 100]};
}

}  // namespace

int Catalogue::series_count() const {
    int count = 0;
    for (const CataloguePatient& patient : patients)
        for (const CatalogueStudy& study : patient.studies) count += int(study.series.size());
    return count;
}

Catalogue scan_catalogue(const fs::path& input, const JobContext& job,
                         const std::function<void(const Catalogue&)>& found) {
    dicom::prepare_dcmtk();
    std::error_code ec;
    if (fs::is_directory(input, ec)) return scan_folder(input, job, found);
    if (!fs::is_regular_file(input, ec))
        throw Error(Errc::io, "Cannot open " + input.string() + ": there is no such file or folder.");
    return read_dicomdir(input, job);
}

std::string person_name(const std::string& stored) {
    const std::string group = stored.substr(0, stored.find('='));
    const auto parts = split(group, "^");
    std::string name;
    for (std::size_t i = 0; i < std::min<std::size_t>(3, parts.size()); ++i) {
        const std::string part(trimmed(parts[i]));
        if (part.empty()) continue;
        name += (name.empty() ? "" : i == 1 ? ", " : " ") + part;
    }
    return name;
}

fs::path folder_of(const CatalogueSeries& series) {
    if (series.files.empty()) return {};
    fs::path folder = series.files.front().parent_path();
    for (const fs::path& file : series.files) {
        const auto below = [&] {
            const auto at = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
            return at.first == folder.end();
        };
        while (!below()) folder = folder.parent_path();
    }
    return folder;
}

CatalogueThumbnail catalogue_thumbnail(const CatalogueSeries& series, int edge, const JobContext& job) {
    if (series.files.empty()) return {};
    Volume volume;
    try {
        volume = open_volume(series.files[series.files.size() / 2].string(), {}, {job.stop, nullptr});
    } catch (const Error& error) {
        if (error.code() == Errc::cancelled) throw;
        return {};
    }
    const glm::ivec3 size = volume.geometry().size;
    const double scale = std::min(1.0, double(edge) / std::max(size.x, size.y));
    CatalogueThumbnail picture;
    picture.width = std::max(1, int(size.x * scale));
    picture.height = std::max(1, int(size.y * scale));
    std::vector<double> values;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            values.push_back(volume.value(std::min(size.x - 1, int((x + 0.5) * size.x / picture.width)),
                                          std::min(size.y - 1, int((y + 0.5) * size.y / picture.height)), size.z / 2));
    const auto [lo, hi] = window_of(values);
    for (const double v : values)
        picture.grey.push_back(
            std::isfinite(v) && hi > lo ? std::uint8_t(std::clamp((v - lo) / (hi - lo), 0.0, 1.0) * 255) : 0);
    return picture;
}

}  // namespace lacuna
