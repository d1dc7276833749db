#pragma once

#include <QtGlobal>

namespace lacuna::ui {

/// The core's sentences that are known in other languages, word by word as the core writes them. %1 .. %7 stand for
/// what it fills in, %8 and %9 for one of k_core_phrases. The first that fits counts.
inline constexpr const char* k_core_sentences[] = {
    // Opening.
    QT_TRANSLATE_NOOP("CoreSentence", "Cannot open '%1': there is no such file or folder."),
    QT_TRANSLATE_NOOP("CoreSentence", "Cannot open %1: there is no such file or folder."),
    QT_TRANSLATE_NOOP("CoreSentence", "Cannot read %1: it is empty (0 bytes); copy it again."),
    QT_TRANSLATE_NOOP("CoreSentence", "Cannot read %1: of packed files only .nii.gz is read; unpack it first."),
    QT_TRANSLATE_NOOP("CoreSentence", "Cannot read %1: the folder holds no DICOM images and no TIFF slices."),
    QT_TRANSLATE_NOOP("CoreSentence", "Cannot read %1: this DICOM file holds no image."),
    QT_TRANSLATE_NOOP("CoreSentence", "Cannot read %1: it is no DICOMDIR, or a damaged one; open its folder."),
    QT_TRANSLATE_NOOP(
        "CoreSentence",
        "Cannot read %1: it is neither DICOM nor named .mhd .mha .nrrd .nhdr .nii .nii.gz .hdr .tif .tiff .raw "
        ".img .vol .dat or .vgi; if it is a raw volume, import it as one (--raw)."),
    QT_TRANSLATE_NOOP(
        "CoreSentence",
        "Cannot read %1: the DICOM header of %2 is cut short or damaged; copy or export the files again."),
    QT_TRANSLATE_NOOP("CoreSentence", "The folder %1 is empty; name one that holds DICOM images."),
    QT_TRANSLATE_NOOP("CoreSentence", "The folder %1 holds no DICOM images; name one that does."),
    QT_TRANSLATE_NOOP("CoreSentence", "The folder %1 holds no DICOM images but %2; name the file."),
    QT_TRANSLATE_NOOP(
        "CoreSentence",
        "No DICOM image could be opened under %1: permission denied for %2; ask for the right to read it."),
    QT_TRANSLATE_NOOP("CoreSentence", "The volume takes %1 MB of memory, but only %2 MB may be used."),
    QT_TRANSLATE_NOOP("CoreSentence",
                      "Cannot allocate %1 bytes for the voxels; close other programs or use a smaller volume."),
    // Writing.
    QT_TRANSLATE_NOOP("CoreSentence", "Cannot write %1: the folder %2 does not exist; create it first."),
    QT_TRANSLATE_NOOP("CoreSentence", "Cannot write %1: it is no folder; name another one."),
    QT_TRANSLATE_NOOP("CoreSentence",
                      "Cannot write %1: the folder is not empty; name a new one, so that nothing is mixed."),
    QT_TRANSLATE_NOOP("CoreSentence", "There is no DICOM image to anonymise; name a DICOM folder or file."),
    // Sessions.
    QT_TRANSLATE_NOOP("CoreSentence", "%1 is no session of Lacuna."),
    // DICOM servers.
    QT_TRANSLATE_NOOP("CoreSentence",
                      "%1 refuses the connection; check that the server runs and that the port is right."),
    QT_TRANSLATE_NOOP("CoreSentence", "%1 does not answer; check address, port and firewall."),
    QT_TRANSLATE_NOOP("CoreSentence", "There is no host named %1; check the server's address."),
    QT_TRANSLATE_NOOP("CoreSentence",
                      "The server %1 refuses the association; check that its AE title is %2 and that it knows this "
                      "program as %3."),
    QT_TRANSLATE_NOOP("CoreSentence", "The server %1 fell silent for %2 s; try again, or allow it more time."),
    QT_TRANSLATE_NOOP(
        "CoreSentence",
        "The server %1 ended the connection; check that it is a DICOM server and takes connections of this "
        "program."),
    QT_TRANSLATE_NOOP("CoreSentence", "The server %1 does not offer %2."),
    QT_TRANSLATE_NOOP("CoreSentence", "What answers at %1 is no DICOM server, or does not speak as one (%2)."),
    QT_TRANSLATE_NOOP(
        "CoreSentence",
        "The secure connection to %1 failed (%2); check that it speaks TLS there and that its certificate "
        "is trusted."),
    QT_TRANSLATE_NOOP("CoreSentence", "A secure connection needs the certificates to trust; name their PEM file."),
    QT_TRANSLATE_NOOP("CoreSentence", "The AE title '%1' is none: 1 to 16 characters without spaces and backslashes."),
    QT_TRANSLATE_NOOP("CoreSentence", "The server has no address; enter its host name or IP address."),
    QT_TRANSLATE_NOOP("CoreSentence", "The server sent nothing for this; it may have been removed there."),
    // Opening.
    QT_TRANSLATE_NOOP("CoreSentence", "Cannot read %1: %9."),
    QT_TRANSLATE_NOOP("CoreSentence", "Cannot read %1: it has %2 bytes, more than the %3 expected at most."),
    QT_TRANSLATE_NOOP("CoreSentence", "Cannot read %1: it is damaged or cut short (%2)."),
    QT_TRANSLATE_NOOP("CoreSentence", "Cannot read %1: it is cut short; copy or export the file again."),
    QT_TRANSLATE_NOOP("CoreSentence", "Cannot read %1: its compressed voxels are damaged or cut short after %2 bytes."),
    QT_TRANSLATE_NOOP(
        "CoreSentence",
        "Cannot read %1: its voxels need %2 bytes, but unpack to %3; the file is cut or its sizes are wrong."),
    QT_TRANSLATE_NOOP("CoreSentence", "Cannot read %1: not enough memory."),
    QT_TRANSLATE_NOOP("CoreSentence",
                      "Cannot read %1: it holds %2 volumes (time points or channels); extract one first."),
    QT_TRANSLATE_NOOP(
        "CoreSentence",
        "Cannot read %1: it has %2 values a voxel (colours or vectors); only scalar volumes can be opened."),
    QT_TRANSLATE_NOOP("CoreSentence", "Cannot read %1: it has %2 values a voxel; only scalar volumes can be opened."),
    QT_TRANSLATE_NOOP("CoreSentence",
                      "Cannot read %1: it is NIfTI-2, which is not read; save it as NIfTI-1, .nrrd or .mhd."),
    QT_TRANSLATE_NOOP("CoreSentence",
                      "Cannot read %1: its axes are not at right angles or not of unit length (deviation %2); resample "
                      "it to a rectangular grid first."),
    QT_TRANSLATE_NOOP("CoreSentence",
                      "%1 has %2 bytes, but %3 voxels of %4 need %5 bytes; check the size, the type and the offset."),
    QT_TRANSLATE_NOOP("CoreSentence", "%1 names the data file %2, which is not there; put it beside the header."),
    QT_TRANSLATE_NOOP("CoreSentence",
                      "Cannot read the pixels of %1: JPEG-LS of %2 bits is not known; export it uncompressed."),
    QT_TRANSLATE_NOOP(
        "CoreSentence",
        "%1 is compressed in a way that cannot be read (transfer syntax %2, %3); export it uncompressed."),
    QT_TRANSLATE_NOOP("CoreSentence", "%1 is no DICOM file; name a DICOM image or a folder of them."),
    QT_TRANSLATE_NOOP("CoreSentence", "%1 is DICOM but holds no image; name one that does."),
    QT_TRANSLATE_NOOP("CoreSentence", "There is no file or folder %1; check the name."),
    QT_TRANSLATE_NOOP("CoreSentence", "Cannot list the folder %1: permission denied; ask for the right to read it."),
    QT_TRANSLATE_NOOP(
        "CoreSentence",
        "Some slices name no position (ImagePositionPatient), others do; remove %1 or the like from the folder."),
    QT_TRANSLATE_NOOP("CoreSentence",
                      "The slices name no position (ImagePositionPatient), so their order cannot be known; open one of "
                      "the files, or export the series with positions."),
    QT_TRANSLATE_NOOP(
        "CoreSentence",
        "The slices lie too far apart within their plane (%1) to belong to one volume; check ImagePositionPatient."),
    QT_TRANSLATE_NOOP("CoreSentence",
                      "The slices leave a gap of %1 between %2 and %3, where their usual step is %4; add the missing "
                      "slices or open the parts one by one."),
    QT_TRANSLATE_NOOP("CoreSentence", "The volume holds no voxels."),
    QT_TRANSLATE_NOOP("CoreSentence",
                      "None of the DICOM images can be exported: they cannot be read, or say that patient data are "
                      "drawn into their pixels."),
    // What reading had to repair or leave out.
    QT_TRANSLATE_NOOP("CoreSentence", "The voxel spacing is not stated; 1 x 1 x 1 mm is assumed."),
    QT_TRANSLATE_NOOP("CoreSentence", "%1 voxels are not a finite number (NaN or infinite)."),
    QT_TRANSLATE_NOOP("CoreSentence",
                      "The values, %1 to %2, are beyond what pictures can be calculated with; scale them before you "
                      "trust one."),
    QT_TRANSLATE_NOOP("CoreSentence",
                      "%1 images beside the series (localizers, other sizes or orientations) are set aside: %2."),
    QT_TRANSLATE_NOOP("CoreSentence", "%1 DICOM files with a damaged header are left out: %2."),
    QT_TRANSLATE_NOOP("CoreSentence",
                      "%1 files or folders may not be opened (permission denied) and are left out: %2."),
    QT_TRANSLATE_NOOP("CoreSentence", "%1 voxels are padding, not measured; they hold the smallest measured value %2."),
    QT_TRANSLATE_NOOP("CoreSentence", "The slices name no pixel spacing; 1 mm is assumed."),
    QT_TRANSLATE_NOOP("CoreSentence", "The slices name no orientation; axial is assumed."),
    QT_TRANSLATE_NOOP("CoreSentence", "Nothing names the distance between slices; 1 mm is assumed."),
    QT_TRANSLATE_NOOP("CoreSentence",
                      "The slices drift within their plane by less than a tenth of a pixel; that is ignored."),
    QT_TRANSLATE_NOOP(
        "CoreSentence",
        "The slices were taken with the gantry tilted by %1 degrees; they are resampled to an upright grid."),
    QT_TRANSLATE_NOOP("CoreSentence", "The slices are not quite evenly spaced (%1 to %2); an even step of %3 is used."),
    QT_TRANSLATE_NOOP("CoreSentence",
                      "The slices are unevenly spaced (%1 to %2); they are resampled to an even step of %3."),
    QT_TRANSLATE_NOOP("CoreSentence", "%1 of %2 slices missing, filled by interpolation: %3."),
    QT_TRANSLATE_NOOP("CoreSentence", "The image names no position; its corner is taken as the origin."),
    // Writing.
    QT_TRANSLATE_NOOP("CoreSentence", "Cannot write %1: %9; nothing was written; %8."),
    QT_TRANSLATE_NOOP("CoreSentence",
                      "Cannot write %1: it is being written already; wait for that, or name another folder."),
    QT_TRANSLATE_NOOP(
        "CoreSentence",
        "Cannot write %1: the folder is not empty and holds no %2; name a new one, so that nothing is mixed."),
    QT_TRANSLATE_NOOP("CoreSentence",
                      "Cannot write %1: the folder that stands there also holds %2, which would be lost; move that, or "
                      "name another folder."),
    QT_TRANSLATE_NOOP("CoreSentence",
                      "Cannot write %1: it needs %2 beside it, and there is such a file already; choose another name."),
    QT_TRANSLATE_NOOP("CoreSentence", "Cannot write %1: its ending names no format; known are %2."),
    QT_TRANSLATE_NOOP("CoreSentence",
                      "Cannot write %1: its ending names no mesh format; known are .stl, .ply, .obj and .vtp."),
    QT_TRANSLATE_NOOP("CoreSentence", "No voxel reaches the isovalue, so there is no surface; choose a lower one."),
    QT_TRANSLATE_NOOP(
        "CoreSentence",
        "Cannot write the anonymised images to %1: the disk is full or the file size is limited; nothing was written."),
    // Regions and inspection.
    QT_TRANSLATE_NOOP("CoreSentence",
                      "The volume falls into more than %1 regions of at least %2 voxels; ask for larger regions "
                      "(--min-voxels) or a wider range."),
    QT_TRANSLATE_NOOP("CoreSentence", "The volume falls into too many pieces to be counted; smooth or crop it first."),
    QT_TRANSLATE_NOOP("CoreSentence", "The threshold's lower value must not exceed its upper one."),
    QT_TRANSLATE_NOOP("CoreSentence",
                      "The part falls into more than 4194304 defects; raise min_voxels or smooth the volume."),
    QT_TRANSLATE_NOOP("CoreSentence", "There is no folder or list %1; check the name."),
    QT_TRANSLATE_NOOP("CoreSentence",
                      "The series has no part: name a folder of sub-folders or volume files, or a list of inputs."),
    QT_TRANSLATE_NOOP(
        "CoreSentence",
        "The folder %1 holds another series (other parts, criteria, options or version); name a new folder."),
    QT_TRANSLATE_NOOP("CoreSentence",
                      "The folder %1 holds this series already; go on with it (--resume), or name a new folder."),
    QT_TRANSLATE_NOOP("CoreSentence", "Cannot write %1: it is no empty folder; name a new one."),
    QT_TRANSLATE_NOOP("CoreSentence", "The reference component cannot be inspected: %1"),
    QT_TRANSLATE_NOOP("CoreSentence", "The volume holds no part: no material was found in it."),
    QT_TRANSLATE_NOOP("CoreSentence", "The part is cut by the volume's frame: what lies outside was not seen."),
    QT_TRANSLATE_NOOP(
        "CoreSentence",
        "The part reaches the volume's border: the border counts as its surface, and what it cuts is flagged."),
    QT_TRANSLATE_NOOP("CoreSentence", "What was seen breaks %1 of %2 limits."),
    QT_TRANSLATE_NOOP("CoreSentence", "All %1 limits are kept."),
    QT_TRANSLATE_NOOP("CoreSentence", "The criteria set no limit, so there is nothing to pass."),
    QT_TRANSLATE_NOOP("CoreSentence", "Defect %1 was rejected by hand: %2"),
    QT_TRANSLATE_NOOP("CoreSentence", "The material's range needs its low end below its high end."),
    QT_TRANSLATE_NOOP("CoreSentence", "The void threshold must lie below the inclusion threshold."),
    // Pictures.
    QT_TRANSLATE_NOOP(
        "CoreSentence",
        "Shear-warp is orthographic only; take the perspective away, or use mode iso, ea, mip, lmip, minip or mean."),
    QT_TRANSLATE_NOOP("CoreSentence", "The structure '%1' cannot serve the mode '%2'; 'visible' can."),
    QT_TRANSLATE_NOOP("CoreSentence",
                      "The structure '%1' cannot serve the mode '%2'; none, macrocells, octree, pyramid, pc, acd, eacd "
                      "and leap can."),
    QT_TRANSLATE_NOOP("CoreSentence",
                      "The structure 'leap' keeps 15 bits a voxel and cannot serve f32 values unless the range to "
                      "quantise is stated; none, macrocells, octree, pyramid, pc, acd and eacd can."),
    QT_TRANSLATE_NOOP(
        "CoreSentence",
        "Stored gradients need %1 MB, more than the %2 MB the device offers for them; take gradients on the fly."),
    QT_TRANSLATE_NOOP("CoreSentence",
                      "The structure '%1' needs %2 MB with an entry a voxel, more than the %3 MB the device offers for "
                      "it; take macro-cells of 4, 8 or 16 voxels."),
    QT_TRANSLATE_NOOP("CoreSentence", "An axis of %1 voxels is longer than the %2 that can be drawn; crop the volume."),
    QT_TRANSLATE_NOOP(
        "CoreSentence",
        "The device has not enough memory for %1 (%2); use a smaller volume or picture, or a lower --memory-limit."),
    QT_TRANSLATE_NOOP("CoreSentence", "The device failed while %1 (%2); try another one with --device."),
    QT_TRANSLATE_NOOP(
        "CoreSentence",
        "A buffer of %1 MB is more than %2 allocates at once (%3 MB); use a smaller volume or a lower --memory-limit."),
    QT_TRANSLATE_NOOP("CoreSentence", "OpenCL device %1 cannot be used: %2; choose another one."),
    QT_TRANSLATE_NOOP("CoreSentence", "No plan could be drawn on this device; choose another one."),
    QT_TRANSLATE_NOOP("CoreSentence", "Brute force could not be drawn on this device; choose another one."),
    // Sessions and presets.
    QT_TRANSLATE_NOOP("CoreSentence", "%1 is no JSON; it may have been cut short."),
    QT_TRANSLATE_NOOP("CoreSentence", "%1 has an unknown entry '%2'."),
    QT_TRANSLATE_NOOP("CoreSentence", "%1 was saved by a newer Lacuna (session version %2; this one reads up to %3)."),
    QT_TRANSLATE_NOOP(
        "CoreSentence",
        "The session was saved with a volume of %1 voxels, the data now has %2; it is shown as newly opened."),
    QT_TRANSLATE_NOOP("CoreSentence", "There is a preset named \"%1\" already; choose another name."),
    QT_TRANSLATE_NOOP("CoreSentence", "A preset needs a name."),
    QT_TRANSLATE_NOOP("CoreSentence", "The preset \"%1\" cannot be shown: %2"),
    QT_TRANSLATE_NOOP("CoreSentence",
                      "%1: this transfer function is of version %2 of the format, which is newer than this program; it "
                      "reads versions up to %3."),
    // More of DICOM servers.
    QT_TRANSLATE_NOOP("CoreSentence", "%1 cannot be reached: %9."),
    QT_TRANSLATE_NOOP("CoreSentence", "The server %1 offers none of the DICOM services asked for."),
    QT_TRANSLATE_NOOP("CoreSentence", "There is nothing to send."),
    QT_TRANSLATE_NOOP("CoreSentence", "Cannot send %1: it is no DICOM object."),
    QT_TRANSLATE_NOOP(
        "CoreSentence",
        "Cannot write what the server sends to %1: the disk is full or the file size is limited; nothing was kept."),
};

/// What the window itself says of a job of the core that failed in an unforeseen way.
inline constexpr const char* k_job_sentences[] = {
    QT_TRANSLATE_NOOP("CoreSentence", "There is not enough memory for this."),
    QT_TRANSLATE_NOOP("CoreSentence", "Something unexpected went wrong: %1"),
};

/// Parts of the core's sentences: advice of its own, and what the system says of a file or a connection.
inline constexpr const char* k_core_phrases[] = {
    QT_TRANSLATE_NOOP("CoreSentence", "free some space or write elsewhere"),
    QT_TRANSLATE_NOOP("CoreSentence",
                      "the file system or a limit (ulimit -f) allows no file so large; write elsewhere"),
    QT_TRANSLATE_NOOP("CoreSentence", "name a folder that takes new files"),
    QT_TRANSLATE_NOOP("CoreSentence", "choose a shorter name"),
    QT_TRANSLATE_NOOP("CoreSentence", "check the disk or write elsewhere"),
    QT_TRANSLATE_NOOP("CoreSentence", "Permission denied"),
    QT_TRANSLATE_NOOP("CoreSentence", "No such file or directory"),
    QT_TRANSLATE_NOOP("CoreSentence", "No space left on device"),
    QT_TRANSLATE_NOOP("CoreSentence", "Disk quota exceeded"),
    QT_TRANSLATE_NOOP("CoreSentence", "Read-only file system"),
    QT_TRANSLATE_NOOP("CoreSentence", "Operation not permitted"),
    QT_TRANSLATE_NOOP("CoreSentence", "Input/output error"),
    QT_TRANSLATE_NOOP("CoreSentence", "Is a directory"),
    QT_TRANSLATE_NOOP("CoreSentence", "Not a directory"),
    QT_TRANSLATE_NOOP("CoreSentence", "File name too long"),
    QT_TRANSLATE_NOOP("CoreSentence", "File too large"),
    QT_TRANSLATE_NOOP("CoreSentence", "Too many open files"),
    QT_TRANSLATE_NOOP("CoreSentence", "Stale file handle"),
    QT_TRANSLATE_NOOP("CoreSentence", "Network is unreachable"),
    QT_TRANSLATE_NOOP("CoreSentence", "No route to host"),
    QT_TRANSLATE_NOOP("CoreSentence", "Connection reset by peer"),
};

}  // namespace lacuna::ui
