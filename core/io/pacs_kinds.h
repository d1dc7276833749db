#pragma once

#include <dcmtk/config/osconfig.h>
// DCMTK's configuration comes first
#include <dcmtk/dcmdata/dcuid.h>

// The kinds of objects that are retrieved, and how images may be coded.
namespace lacuna::dicom {

inline constexpr const char* k_images[] = {UID_CTImageStorage,
                                           UID_EnhancedCTImageStorage,
                                           UID_LegacyConvertedEnhancedCTImageStorage,
                                           UID_MRImageStorage,
                                           UID_EnhancedMRImageStorage,
                                           UID_PositronEmissionTomographyImageStorage,
                                           UID_ComputedRadiographyImageStorage,
                                           UID_DigitalXRayImageStorageForPresentation,
                                           UID_XRay3DAngiographicImageStorage,
                                           UID_NuclearMedicineImageStorage,
                                           UID_SecondaryCaptureImageStorage,
                                           UID_MultiframeGrayscaleWordSecondaryCaptureImageStorage};
inline constexpr const char* k_others[] = {UID_SegmentationStorage,    UID_EnhancedSRStorage,
                                           UID_ComprehensiveSRStorage, UID_Comprehensive3DSRStorage,
                                           UID_BasicTextSRStorage,     UID_RTDoseStorage,
                                           UID_RTStructureSetStorage,  UID_GrayscaleSoftcopyPresentationStateStorage};
inline constexpr const char* k_packed[] = {UID_JPEGProcess14SV1TransferSyntax,     UID_JPEGLSLosslessTransferSyntax,
                                           UID_JPEG2000LosslessOnlyTransferSyntax, UID_RLELosslessTransferSyntax,
                                           UID_JPEGProcess2_4TransferSyntax,       UID_JPEG2000TransferSyntax};

}  // namespace lacuna::dicom
