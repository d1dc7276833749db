#pragma once

#include <QStringList>

namespace lacuna::ui {

/// What a person means who drops files on the window.
struct Dropped {
    QString input;              ///< the one thing to open: a path
    int left_out = 0;           ///< so many others are not part of it
    bool whole_folder = false;  ///< files of one folder: it is opened with all that is in it
};

/// Of several: the session; a header, whose voxels' files belong to it; slices of one folder (DICOM, TIFF): that
/// folder; else the first. Looks at no more than the first bytes of a few. @pre `files` is not empty
Dropped dropped_input(const QStringList& files);

}  // namespace lacuna::ui
