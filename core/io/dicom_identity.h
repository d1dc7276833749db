#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/volume/voi_window.h"

namespace lacuna {

/// What identifies a patient and their study, UTF-8, as one slice says it. PERSONAL DATA: shown in a view's corner
/// while the person at the screen wants it there, and nowhere else. It must not reach a log, a message, a report, an
/// exported file or a saved session; so it is no part of DicomFacts or Volume, and nothing but a view may read it.
struct PatientIdentity {
    std::string name;  ///< as a person reads it: "Doe, Dr. Jane"
    std::string id;
    std::string birth_date, sex, age;      ///< dates as YYYY-MM-DD where they are dates
    std::string study_date, study, place;  ///< the study's date and description, the institution
    bool empty() const {
        return name.empty() && id.empty() && birth_date.empty() && sex.empty() && age.empty() && study_date.empty() &&
               study.empty() && place.empty();
    }
};

/// What a view wants to know of a slice beyond its values.
struct DicomScreenFacts {
    std::shared_ptr<const PatientIdentity> patient;           ///< null: it names nobody
    std::optional<VoiFunction> voi_function;                  ///< VOILUTFunction (0028,1056); none: it says nothing
    std::vector<std::shared_ptr<const VoiTable>> voi_tables;  ///< of its VOI LUT Sequence
};

/// Reads them from one file, its texts in UTF-8 whatever character set they are in, control characters left out.
/// @param frame  from 1, of a file with several; 0: the file has one. Cost: one header.
/// Does not throw for what the file holds or lacks: what cannot be read is left out.
DicomScreenFacts read_screen_facts(const std::filesystem::path& file, int frame = 0);

}  // namespace lacuna
