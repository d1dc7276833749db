#include "core/io/library_versions.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcuid.h>
#include <gdcmVersion.h>
#include <itkVersion.h>

namespace lacuna {

std::vector<LibraryVersion> io_library_versions() {
    return {{"DCMTK", OFFIS_DCMTK_VERSION_STRING},
            {"GDCM", gdcm::Version::GetVersion()},
            {"ITK", itk::Version::GetITKVersion()}};
}

}  // namespace lacuna
