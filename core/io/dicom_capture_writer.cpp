#include "core/io/dicom_capture_writer.h"

#include <dcmtk/config/osconfig.h>
// DCMTK's configuration comes first
#include <dcmtk/dcmdata/dctk.h>

#include <vector>

#include "core/base/error.h"

namespace lacuna {

void write_dicom_capture(glm::ivec2 size, std::span<const std::uint8_t> rgb, const DicomSource& source,
                         const DicomProvenance& made, const std::filesystem::path& target) {
    if (size.x < 1 || size.y < 1 || size.x > 65535 || size.y > 65535 ||
        rgb.size() != std::size_t(size.x) * std::size_t(size.y) * 3)
        throw Error(Errc::bad_input, "The bytes are no RGB picture of the size given.");
    DcmDataset set, context;
    dicom::copy_context(source, made, context);
    for (DcmObject* at = context.nextInContainer(nullptr); at; at = context.nextInContainer(at))
        if (at->getTag() != DCM_FrameOfReferenceUID && at->getTag() != DCM_PositionReferenceIndicator)
            context.findAndInsertCopyOfElement(at->getTag(), &set, OFTrue);
    const auto put = [&set](const DcmTagKey& tag, const std::string& text) {
        set.putAndInsertString(tag, text.c_str());
    };
    put(DCM_SOPClassUID, UID_SecondaryCaptureImageStorage);
    put(DCM_Modality, "OT");
    put(DCM_ConversionType, "WSD");
    put(DCM_ImageType, "DERIVED\\SECONDARY");
    put(DCM_SeriesNumber, "903");
    put(DCM_InstanceNumber, "1");
    put(DCM_PatientOrientation, "");
    put(DCM_Laterality, "");
    put(DCM_Manufacturer, made.software);
    put(DCM_ManufacturerModelName, made.software);
    put(DCM_SoftwareVersions, made.version);
    put(DCM_BurnedInAnnotation, "NO");
    put(DCM_PhotometricInterpretation, "RGB");
    set.putAndInsertUint16(DCM_SamplesPerPixel, 3);
    set.putAndInsertUint16(DCM_PlanarConfiguration, 0);
    set.putAndInsertUint16(DCM_Rows, Uint16(size.y));
    set.putAndInsertUint16(DCM_Columns, Uint16(size.x));
    set.putAndInsertUint16(DCM_BitsAllocated, 8);
    set.putAndInsertUint16(DCM_BitsStored, 8);
    set.putAndInsertUint16(DCM_HighBit, 7);
    set.putAndInsertUint16(DCM_PixelRepresentation, 0);
    std::vector<std::uint8_t> bytes(rgb.begin(), rgb.end());
    if (bytes.size() % 2) bytes.push_back(0);
    set.putAndInsertUint8Array(DCM_PixelData, bytes.data(), static_cast<unsigned long>(bytes.size()));
    dicom::fix_identity(made, "key", context, set);
    dicom::save_dataset(set, target);
}

}  // namespace lacuna
