#pragma once

#include <string>

class DcmDataset;

namespace lacuna::dicom {

/// New names for old ones, the same for the same within an export.
class Pseudonyms {
public:
    /// @param key  makes them the same in several exports; a random one where it is empty
    explicit Pseudonyms(std::string key);
    /// The standard's own (classes, syntaxes, atlases) stay.
    std::string uid(const std::string& old) const;
    /// Twelve digits that follow from a patient's id and name.
    std::string patient(const std::string& id_and_name) const;

private:
    std::string key_;
};

/// Works through one data set by the profile (anonymise_dicom()), and states in it what was done.
/// @param patient  the pseudonym for name and id
/// @param software  stated as the method
void anonymise(DcmDataset& set, const Pseudonyms& names, const std::string& patient, const std::string& software);

}  // namespace lacuna::dicom
