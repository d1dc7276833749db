<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>AxisWords</name>
    <message>
        <source>From %1</source>
        <comment>a standard view; %1: the end of an axis, +X</comment>
        <translation>Von %1</translation>
    </message>
    <message>
        <source>Front (anterior)</source>
        <translation>Vorn (anterior)</translation>
    </message>
    <message>
        <source>Back (posterior)</source>
        <translation>Hinten (posterior)</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Kopf</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>Fuß</translation>
    </message>
</context>
<context>
    <name>ColourMap</name>
    <message>
        <source>grey</source>
        <translation>grau</translation>
    </message>
    <message>
        <source>heat</source>
        <translation>Glut</translation>
    </message>
    <message>
        <source>meadow</source>
        <translation>Wiese</translation>
    </message>
    <message>
        <source>dusk</source>
        <translation>Dämmerung</translation>
    </message>
    <message>
        <source>ocean</source>
        <translation>Meer</translation>
    </message>
    <message>
        <source>bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>blood</source>
        <translation>Blut</translation>
    </message>
    <message>
        <source>cubehelix</source>
        <translation>Cubehelix</translation>
    </message>
    <message>
        <source>cold-warm</source>
        <translation>kalt–warm</translation>
    </message>
</context>
<context>
    <name>CoreSentence</name>
    <message>
        <source>Cannot open &apos;%1&apos;: there is no such file or folder.</source>
        <translation>%1 kann nicht geöffnet werden: Es gibt keine solche Datei und keinen solchen Ordner.</translation>
    </message>
    <message>
        <source>Cannot open %1: there is no such file or folder.</source>
        <translation>%1 kann nicht geöffnet werden: Es gibt keine solche Datei und keinen solchen Ordner.</translation>
    </message>
    <message>
        <source>Cannot read %1: it is empty (0 bytes); copy it again.</source>
        <translation>%1 kann nicht gelesen werden: Die Datei ist leer (0 Bytes); bitte neu kopieren.</translation>
    </message>
    <message>
        <source>Cannot read %1: of packed files only .nii.gz is read; unpack it first.</source>
        <translation>%1 kann nicht gelesen werden: Von gepackten Dateien wird nur .nii.gz gelesen; bitte erst entpacken.</translation>
    </message>
    <message>
        <source>Cannot read %1: the folder holds no DICOM images and no TIFF slices.</source>
        <translation>%1 kann nicht gelesen werden: Der Ordner enthält weder DICOM-Bilder noch TIFF-Schichten.</translation>
    </message>
    <message>
        <source>Cannot read %1: this DICOM file holds no image.</source>
        <translation>%1 kann nicht gelesen werden: Diese DICOM-Datei enthält kein Bild.</translation>
    </message>
    <message>
        <source>Cannot read %1: it is no DICOMDIR, or a damaged one; open its folder.</source>
        <translation>%1 kann nicht gelesen werden: Es ist kein DICOMDIR oder ein beschädigter; bitte den Ordner öffnen.</translation>
    </message>
    <message>
        <source>Cannot read %1: it is neither DICOM nor named .mhd .mha .nrrd .nhdr .nii .nii.gz .hdr .tif .tiff .raw .img .vol .dat or .vgi; if it is a raw volume, import it as one (--raw).</source>
        <translation>%1 kann nicht gelesen werden: Es ist kein DICOM und heißt auch nicht .mhd .mha .nrrd .nhdr .nii .nii.gz .hdr .tif .tiff .raw .img .vol .dat oder .vgi; ein rohes Volumen lässt sich über das Menü Datei importieren.</translation>
    </message>
    <message>
        <source>Cannot read %1: the DICOM header of %2 is cut short or damaged; copy or export the files again.</source>
        <translation>%1 kann nicht gelesen werden: Der DICOM-Kopf von %2 ist abgeschnitten oder beschädigt; bitte die Dateien neu kopieren oder ausgeben.</translation>
    </message>
    <message>
        <source>The folder %1 is empty; name one that holds DICOM images.</source>
        <translation>Der Ordner %1 ist leer; bitte einen mit DICOM-Bildern nennen.</translation>
    </message>
    <message>
        <source>The folder %1 holds no DICOM images; name one that does.</source>
        <translation>Der Ordner %1 enthält keine DICOM-Bilder; bitte einen mit DICOM-Bildern nennen.</translation>
    </message>
    <message>
        <source>The folder %1 holds no DICOM images but %2; name the file.</source>
        <translation>Der Ordner %1 enthält keine DICOM-Bilder, sondern %2; bitte die Datei nennen.</translation>
    </message>
    <message>
        <source>No DICOM image could be opened under %1: permission denied for %2; ask for the right to read it.</source>
        <translation>Unter %1 konnte kein DICOM-Bild geöffnet werden: Der Zugriff auf %2 ist verweigert; bitte um das Leserecht bitten.</translation>
    </message>
    <message>
        <source>The volume takes %1 MB of memory, but only %2 MB may be used.</source>
        <translation>Das Volumen braucht %1 MB Speicher, aber nur %2 MB dürfen benutzt werden.</translation>
    </message>
    <message>
        <source>Cannot allocate %1 bytes for the voxels; close other programs or use a smaller volume.</source>
        <translation>Für die Voxel sind keine %1 Bytes Speicher frei; bitte andere Programme schließen oder ein kleineres Volumen nehmen.</translation>
    </message>
    <message>
        <source>Cannot write %1: the folder %2 does not exist; create it first.</source>
        <translation>%1 kann nicht geschrieben werden: Den Ordner %2 gibt es nicht; bitte erst anlegen.</translation>
    </message>
    <message>
        <source>Cannot write %1: it is no folder; name another one.</source>
        <translation>%1 kann nicht geschrieben werden: Das ist kein Ordner; bitte einen anderen nennen.</translation>
    </message>
    <message>
        <source>Cannot write %1: the folder is not empty; name a new one, so that nothing is mixed.</source>
        <translation>%1 kann nicht geschrieben werden: Der Ordner ist nicht leer; bitte einen neuen nennen, damit sich nichts vermischt.</translation>
    </message>
    <message>
        <source>There is no DICOM image to anonymise; name a DICOM folder or file.</source>
        <translation>Es gibt kein DICOM-Bild zu anonymisieren; bitte einen DICOM-Ordner oder eine Datei nennen.</translation>
    </message>
    <message>
        <source>%1 is no session of Lacuna.</source>
        <translation>%1 ist keine Sitzung von Lacuna.</translation>
    </message>
    <message>
        <source>%1 refuses the connection; check that the server runs and that the port is right.</source>
        <translation>%1 weist die Verbindung ab; bitte prüfen, ob der Server läuft und der Port stimmt.</translation>
    </message>
    <message>
        <source>%1 does not answer; check address, port and firewall.</source>
        <translation>%1 antwortet nicht; bitte Adresse, Port und Firewall prüfen.</translation>
    </message>
    <message>
        <source>There is no host named %1; check the server&apos;s address.</source>
        <translation>Es gibt keinen Rechner namens %1; bitte die Adresse des Servers prüfen.</translation>
    </message>
    <message>
        <source>The server %1 refuses the association; check that its AE title is %2 and that it knows this program as %3.</source>
        <translation>Der Server %1 weist die Assoziation ab; bitte prüfen, ob sein AE-Titel %2 ist und ob er dieses Programm als %3 kennt.</translation>
    </message>
    <message>
        <source>The server %1 fell silent for %2 s; try again, or allow it more time.</source>
        <translation>Der Server %1 schwieg %2 s lang; bitte noch einmal versuchen oder ihm mehr Zeit geben.</translation>
    </message>
    <message>
        <source>The server %1 ended the connection; check that it is a DICOM server and takes connections of this program.</source>
        <translation>Der Server %1 hat die Verbindung beendet; bitte prüfen, ob er ein DICOM-Server ist und Verbindungen dieses Programms annimmt.</translation>
    </message>
    <message>
        <source>The server %1 does not offer %2.</source>
        <translation>Der Server %1 bietet dies nicht an: %2.</translation>
    </message>
    <message>
        <source>What answers at %1 is no DICOM server, or does not speak as one (%2).</source>
        <translation>Was bei %1 antwortet, ist kein DICOM-Server oder spricht nicht wie einer (%2).</translation>
    </message>
    <message>
        <source>The secure connection to %1 failed (%2); check that it speaks TLS there and that its certificate is trusted.</source>
        <translation>Die sichere Verbindung zu %1 ist gescheitert (%2); bitte prüfen, ob dort TLS gesprochen wird und ob dem Zertifikat vertraut wird.</translation>
    </message>
    <message>
        <source>A secure connection needs the certificates to trust; name their PEM file.</source>
        <translation>Eine sichere Verbindung braucht die vertrauten Zertifikate; bitte ihre PEM-Datei nennen.</translation>
    </message>
    <message>
        <source>The AE title &apos;%1&apos; is none: 1 to 16 characters without spaces and backslashes.</source>
        <translation>Der AE-Titel &apos;%1&apos; ist keiner: 1 bis 16 Zeichen ohne Leerzeichen und Rückstriche.</translation>
    </message>
    <message>
        <source>The server has no address; enter its host name or IP address.</source>
        <translation>Der Server hat keine Adresse; bitte seinen Rechnernamen oder seine IP-Adresse eingeben.</translation>
    </message>
    <message>
        <source>The server sent nothing for this; it may have been removed there.</source>
        <translation>Der Server hat hierzu nichts geschickt; vielleicht wurde es dort entfernt.</translation>
    </message>
    <message>
        <source>Cannot read %1: %9.</source>
        <translation>%1 kann nicht gelesen werden: %9.</translation>
    </message>
    <message>
        <source>Cannot read %1: it has %2 bytes, more than the %3 expected at most.</source>
        <translation>%1 kann nicht gelesen werden: Die Datei hat %2 Byte, mehr als die erwarteten höchstens %3.</translation>
    </message>
    <message>
        <source>Cannot read %1: it is damaged or cut short (%2).</source>
        <translation>%1 kann nicht gelesen werden: Die Datei ist beschädigt oder abgeschnitten (%2).</translation>
    </message>
    <message>
        <source>Cannot read %1: it is cut short; copy or export the file again.</source>
        <translation>%1 kann nicht gelesen werden: Die Datei ist abgeschnitten; bitte neu kopieren oder exportieren.</translation>
    </message>
    <message>
        <source>Cannot read %1: its compressed voxels are damaged or cut short after %2 bytes.</source>
        <translation>%1 kann nicht gelesen werden: Die gepackten Voxel sind nach %2 Byte beschädigt oder abgeschnitten.</translation>
    </message>
    <message>
        <source>Cannot read %1: its voxels need %2 bytes, but unpack to %3; the file is cut or its sizes are wrong.</source>
        <translation>%1 kann nicht gelesen werden: Die Voxel brauchen %2 Byte, entpackt sind es %3; die Datei ist abgeschnitten oder ihre Maße sind falsch.</translation>
    </message>
    <message>
        <source>Cannot read %1: not enough memory.</source>
        <translation>%1 kann nicht gelesen werden: Der Speicher reicht nicht.</translation>
    </message>
    <message>
        <source>Cannot read %1: it holds %2 volumes (time points or channels); extract one first.</source>
        <translation>%1 kann nicht gelesen werden: Die Datei enthält %2 Volumen (Zeitpunkte oder Kanäle); bitte zuerst eines herauslösen.</translation>
    </message>
    <message>
        <source>Cannot read %1: it has %2 values a voxel (colours or vectors); only scalar volumes can be opened.</source>
        <translation>%1 kann nicht gelesen werden: Es gibt %2 Werte je Voxel (Farben oder Vektoren); nur skalare Volumen können geöffnet werden.</translation>
    </message>
    <message>
        <source>Cannot read %1: it has %2 values a voxel; only scalar volumes can be opened.</source>
        <translation>%1 kann nicht gelesen werden: Es gibt %2 Werte je Voxel; nur skalare Volumen können geöffnet werden.</translation>
    </message>
    <message>
        <source>Cannot read %1: it is NIfTI-2, which is not read; save it as NIfTI-1, .nrrd or .mhd.</source>
        <translation>%1 kann nicht gelesen werden: NIfTI-2 wird nicht gelesen; bitte als NIfTI-1, .nrrd oder .mhd sichern.</translation>
    </message>
    <message>
        <source>Cannot read %1: its axes are not at right angles or not of unit length (deviation %2); resample it to a rectangular grid first.</source>
        <translation>%1 kann nicht gelesen werden: Die Achsen stehen nicht rechtwinklig oder haben nicht die Länge eins (Abweichung %2); bitte zuerst auf ein rechtwinkliges Gitter umrechnen.</translation>
    </message>
    <message>
        <source>%1 has %2 bytes, but %3 voxels of %4 need %5 bytes; check the size, the type and the offset.</source>
        <translation>%1 hat %2 Byte, aber %3 Voxel von %4 brauchen %5 Byte; bitte Größe, Typ und Versatz prüfen.</translation>
    </message>
    <message>
        <source>%1 names the data file %2, which is not there; put it beside the header.</source>
        <translation>%1 nennt die Datendatei %2, die es nicht gibt; bitte neben den Kopf legen.</translation>
    </message>
    <message>
        <source>Cannot read the pixels of %1: JPEG-LS of %2 bits is not known; export it uncompressed.</source>
        <translation>Die Bildpunkte von %1 können nicht gelesen werden: JPEG-LS mit %2 Bit ist nicht bekannt; bitte ungepackt exportieren.</translation>
    </message>
    <message>
        <source>%1 is compressed in a way that cannot be read (transfer syntax %2, %3); export it uncompressed.</source>
        <translation>%1 ist auf eine Weise gepackt, die nicht gelesen werden kann (Transfersyntax %2, %3); bitte ungepackt exportieren.</translation>
    </message>
    <message>
        <source>%1 is no DICOM file; name a DICOM image or a folder of them.</source>
        <translation>%1 ist keine DICOM-Datei; bitte ein DICOM-Bild oder einen Ordner damit nennen.</translation>
    </message>
    <message>
        <source>%1 is DICOM but holds no image; name one that does.</source>
        <translation>%1 ist DICOM, enthält aber kein Bild; bitte eine Datei mit Bild nennen.</translation>
    </message>
    <message>
        <source>There is no file or folder %1; check the name.</source>
        <translation>Es gibt keine Datei und keinen Ordner %1; bitte den Namen prüfen.</translation>
    </message>
    <message>
        <source>Cannot list the folder %1: permission denied; ask for the right to read it.</source>
        <translation>Der Ordner %1 kann nicht durchgesehen werden: Der Zugriff ist verweigert; bitte das Leserecht erbitten.</translation>
    </message>
    <message>
        <source>Some slices name no position (ImagePositionPatient), others do; remove %1 or the like from the folder.</source>
        <translation>Einige Schichten nennen keine Lage (ImagePositionPatient), andere schon; bitte %1 oder Ähnliches aus dem Ordner nehmen.</translation>
    </message>
    <message>
        <source>The slices name no position (ImagePositionPatient), so their order cannot be known; open one of the files, or export the series with positions.</source>
        <translation>Die Schichten nennen keine Lage (ImagePositionPatient), ihre Reihenfolge ist daher nicht zu erkennen; bitte eine der Dateien öffnen oder die Serie mit Lagen exportieren.</translation>
    </message>
    <message>
        <source>The slices lie too far apart within their plane (%1) to belong to one volume; check ImagePositionPatient.</source>
        <translation>Die Schichten liegen in ihrer Ebene zu weit auseinander (%1), um zu einem Volumen zu gehören; bitte ImagePositionPatient prüfen.</translation>
    </message>
    <message>
        <source>The slices leave a gap of %1 between %2 and %3, where their usual step is %4; add the missing slices or open the parts one by one.</source>
        <translation>Die Schichten lassen zwischen %2 und %3 eine Lücke von %1, ihr üblicher Abstand ist %4; bitte die fehlenden Schichten ergänzen oder die Teile einzeln öffnen.</translation>
    </message>
    <message>
        <source>The volume holds no voxels.</source>
        <translation>Das Volumen enthält keine Voxel.</translation>
    </message>
    <message>
        <source>None of the DICOM images can be exported: they cannot be read, or say that patient data are drawn into their pixels.</source>
        <translation>Keines der DICOM-Bilder kann exportiert werden: Sie können nicht gelesen werden, oder in ihre Bildpunkte sind Patientendaten gezeichnet.</translation>
    </message>
    <message>
        <source>The voxel spacing is not stated; 1 x 1 x 1 mm is assumed.</source>
        <translation>Der Voxelabstand ist nicht angegeben; angenommen sind 1 x 1 x 1 mm.</translation>
    </message>
    <message>
        <source>%1 voxels are not a finite number (NaN or infinite).</source>
        <translation>%1 Voxel sind keine endliche Zahl (NaN oder unendlich).</translation>
    </message>
    <message>
        <source>The values, %1 to %2, are beyond what pictures can be calculated with; scale them before you trust one.</source>
        <translation>Mit den Werten, %1 bis %2, lassen sich keine Bilder berechnen; skalieren Sie sie, bevor Sie einem trauen.</translation>
    </message>
    <message>
        <source>%1 images beside the series (localizers, other sizes or orientations) are set aside: %2.</source>
        <translation>%1 Bilder neben der Serie (Übersichten, andere Größen oder Lagen) sind beiseitegelegt: %2.</translation>
    </message>
    <message>
        <source>%1 DICOM files with a damaged header are left out: %2.</source>
        <translation>%1 DICOM-Dateien mit beschädigtem Kopf sind ausgelassen: %2.</translation>
    </message>
    <message>
        <source>%1 files or folders may not be opened (permission denied) and are left out: %2.</source>
        <translation>%1 Dateien oder Ordner dürfen nicht geöffnet werden (Zugriff verweigert) und sind ausgelassen: %2.</translation>
    </message>
    <message>
        <source>%1 voxels are padding, not measured; they hold the smallest measured value %2.</source>
        <translation>%1 Voxel sind Füllung, nicht gemessen; sie tragen den kleinsten gemessenen Wert %2.</translation>
    </message>
    <message>
        <source>The slices name no pixel spacing; 1 mm is assumed.</source>
        <translation>Die Schichten nennen keinen Pixelabstand; angenommen ist 1 mm.</translation>
    </message>
    <message>
        <source>The slices name no orientation; axial is assumed.</source>
        <translation>Die Schichten nennen keine Ausrichtung; angenommen ist axial.</translation>
    </message>
    <message>
        <source>Nothing names the distance between slices; 1 mm is assumed.</source>
        <translation>Der Abstand der Schichten ist nirgends genannt; angenommen ist 1 mm.</translation>
    </message>
    <message>
        <source>The slices drift within their plane by less than a tenth of a pixel; that is ignored.</source>
        <translation>Die Schichten wandern in ihrer Ebene um weniger als ein Zehntel Pixel; das bleibt unbeachtet.</translation>
    </message>
    <message>
        <source>The slices were taken with the gantry tilted by %1 degrees; they are resampled to an upright grid.</source>
        <translation>Die Schichten wurden mit um %1 Grad gekippter Gantry aufgenommen; sie sind auf ein aufrechtes Gitter umgerechnet.</translation>
    </message>
    <message>
        <source>The slices are not quite evenly spaced (%1 to %2); an even step of %3 is used.</source>
        <translation>Die Schichten haben nicht ganz gleiche Abstände (%1 bis %2); gerechnet wird mit dem gleichmäßigen Abstand %3.</translation>
    </message>
    <message>
        <source>The slices are unevenly spaced (%1 to %2); they are resampled to an even step of %3.</source>
        <translation>Die Schichten haben ungleiche Abstände (%1 bis %2); sie sind auf den gleichmäßigen Abstand %3 umgerechnet.</translation>
    </message>
    <message>
        <source>%1 of %2 slices missing, filled by interpolation: %3.</source>
        <translation>%1 von %2 Schichten fehlen und sind durch Interpolation ergänzt: %3.</translation>
    </message>
    <message>
        <source>The image names no position; its corner is taken as the origin.</source>
        <translation>Das Bild nennt keine Lage; seine Ecke gilt als Ursprung.</translation>
    </message>
    <message>
        <source>Cannot write %1: %9; nothing was written; %8.</source>
        <translation>%1 kann nicht geschrieben werden: %9; es wurde nichts geschrieben; %8.</translation>
    </message>
    <message>
        <source>Cannot write %1: it is being written already; wait for that, or name another folder.</source>
        <translation>%1 kann nicht geschrieben werden: Der Ordner wird gerade schon geschrieben; bitte das abwarten oder einen anderen nennen.</translation>
    </message>
    <message>
        <source>Cannot write %1: the folder is not empty and holds no %2; name a new one, so that nothing is mixed.</source>
        <translation>%1 kann nicht geschrieben werden: Der Ordner ist nicht leer und enthält kein %2; bitte einen neuen nennen, damit sich nichts vermischt.</translation>
    </message>
    <message>
        <source>Cannot write %1: the folder that stands there also holds %2, which would be lost; move that, or name another folder.</source>
        <translation>%1 kann nicht geschrieben werden: Der Ordner, der dort steht, enthält auch %2, was verloren ginge; bitte das verschieben oder einen anderen Ordner nennen.</translation>
    </message>
    <message>
        <source>Cannot write %1: it needs %2 beside it, and there is such a file already; choose another name.</source>
        <translation>%1 kann nicht geschrieben werden: Daneben muss %2 stehen, und eine solche Datei gibt es schon; bitte einen anderen Namen wählen.</translation>
    </message>
    <message>
        <source>Cannot write %1: its ending names no format; known are %2.</source>
        <translation>%1 kann nicht geschrieben werden: Die Endung nennt kein Format; bekannt sind %2.</translation>
    </message>
    <message>
        <source>Cannot write %1: its ending names no mesh format; known are .stl, .ply, .obj and .vtp.</source>
        <translation>%1 kann nicht geschrieben werden: Die Endung nennt kein Netzformat; bekannt sind .stl, .ply, .obj und .vtp.</translation>
    </message>
    <message>
        <source>No voxel reaches the isovalue, so there is no surface; choose a lower one.</source>
        <translation>Kein Voxel erreicht den Isowert, also gibt es keine Fläche; bitte einen niedrigeren wählen.</translation>
    </message>
    <message>
        <source>Cannot write the anonymised images to %1: the disk is full or the file size is limited; nothing was written.</source>
        <translation>Die anonymisierten Bilder können nicht nach %1 geschrieben werden: Der Datenträger ist voll oder die Dateigröße begrenzt; es wurde nichts geschrieben.</translation>
    </message>
    <message>
        <source>The volume falls into more than %1 regions of at least %2 voxels; ask for larger regions (--min-voxels) or a wider range.</source>
        <translation>Das Volumen zerfällt in mehr als %1 Regionen von mindestens %2 Voxeln; bitte größere Regionen oder einen weiteren Bereich verlangen.</translation>
    </message>
    <message>
        <source>The volume falls into too many pieces to be counted; smooth or crop it first.</source>
        <translation>Das Volumen zerfällt in zu viele Stücke, um sie zu zählen; bitte zuerst glätten oder zuschneiden.</translation>
    </message>
    <message>
        <source>The threshold&apos;s lower value must not exceed its upper one.</source>
        <translation>Der untere Wert der Schwelle darf nicht über dem oberen liegen.</translation>
    </message>
    <message>
        <source>The part falls into more than 4194304 defects; raise min_voxels or smooth the volume.</source>
        <translation>Das Teil zerfällt in mehr als 4194304 Fehlstellen; bitte die kleinste Größe heraufsetzen oder das Volumen glätten.</translation>
    </message>
    <message>
        <source>There is no folder or list %1; check the name.</source>
        <translation>Es gibt keinen Ordner und keine Liste %1; bitte den Namen prüfen.</translation>
    </message>
    <message>
        <source>The series has no part: name a folder of sub-folders or volume files, or a list of inputs.</source>
        <translation>Die Serie hat kein Teil: bitte einen Ordner mit Unterordnern oder Volumendateien nennen, oder eine Liste von Eingaben.</translation>
    </message>
    <message>
        <source>The folder %1 holds another series (other parts, criteria, options or version); name a new folder.</source>
        <translation>Der Ordner %1 enthält eine andere Serie (andere Teile, Kriterien, Einstellungen oder Version); bitte einen neuen Ordner nennen.</translation>
    </message>
    <message>
        <source>The folder %1 holds this series already; go on with it (--resume), or name a new folder.</source>
        <translation>Der Ordner %1 enthält diese Serie schon; bitte mit ihr fortfahren lassen oder einen neuen Ordner nennen.</translation>
    </message>
    <message>
        <source>Cannot write %1: it is no empty folder; name a new one.</source>
        <translation>%1 kann nicht geschrieben werden: Es ist kein leerer Ordner; bitte einen neuen nennen.</translation>
    </message>
    <message>
        <source>The reference component cannot be inspected: %1</source>
        <translation>Das Referenzteil kann nicht geprüft werden: %1</translation>
    </message>
    <message>
        <source>Shear-warp is orthographic only; take the perspective away, or use mode iso, ea, mip, lmip, minip or mean.</source>
        <translation>Shear-Warp gibt es nur orthografisch; bitte die Perspektive abschalten oder einen anderen Modus nehmen.</translation>
    </message>
    <message>
        <source>The structure &apos;%1&apos; cannot serve the mode &apos;%2&apos;; &apos;visible&apos; can.</source>
        <translation>Die Struktur „%1“ passt nicht zum Modus „%2“; „visible“ passt.</translation>
    </message>
    <message>
        <source>The structure &apos;%1&apos; cannot serve the mode &apos;%2&apos;; none, macrocells, octree, pyramid, pc, acd, eacd and leap can.</source>
        <translation>Die Struktur „%1“ passt nicht zum Modus „%2“; none, macrocells, octree, pyramid, pc, acd, eacd und leap passen.</translation>
    </message>
    <message>
        <source>The structure &apos;leap&apos; keeps 15 bits a voxel and cannot serve f32 values unless the range to quantise is stated; none, macrocells, octree, pyramid, pc, acd and eacd can.</source>
        <translation>Die Struktur „leap“ hält 15 Bit je Voxel und passt nicht zu f32-Werten, solange der Bereich zum Quantisieren nicht genannt ist; none, macrocells, octree, pyramid, pc, acd und eacd passen.</translation>
    </message>
    <message>
        <source>Stored gradients need %1 MB, more than the %2 MB the device offers for them; take gradients on the fly.</source>
        <translation>Gespeicherte Gradienten brauchen %1 MB, mehr als die %2 MB, die das Gerät dafür bietet; bitte Gradienten im Lauf rechnen.</translation>
    </message>
    <message>
        <source>The structure &apos;%1&apos; needs %2 MB with an entry a voxel, more than the %3 MB the device offers for it; take macro-cells of 4, 8 or 16 voxels.</source>
        <translation>Die Struktur „%1“ braucht mit einem Eintrag je Voxel %2 MB, mehr als die %3 MB, die das Gerät dafür bietet; bitte Makrozellen von 4, 8 oder 16 Voxeln nehmen.</translation>
    </message>
    <message>
        <source>An axis of %1 voxels is longer than the %2 that can be drawn; crop the volume.</source>
        <translation>Eine Achse von %1 Voxeln ist länger als die %2, die gezeichnet werden können; bitte das Volumen zuschneiden.</translation>
    </message>
    <message>
        <source>The device has not enough memory for %1 (%2); use a smaller volume or picture, or a lower --memory-limit.</source>
        <translation>Der Speicher des Geräts reicht nicht (%1, %2); bitte ein kleineres Volumen oder Bild nehmen oder die Speichergrenze senken.</translation>
    </message>
    <message>
        <source>The device failed while %1 (%2); try another one with --device.</source>
        <translation>Das Gerät versagte (%1, %2); bitte ein anderes versuchen.</translation>
    </message>
    <message>
        <source>A buffer of %1 MB is more than %2 allocates at once (%3 MB); use a smaller volume or a lower --memory-limit.</source>
        <translation>Ein Puffer von %1 MB ist mehr, als %2 auf einmal bereitstellt (%3 MB); bitte ein kleineres Volumen nehmen oder die Speichergrenze senken.</translation>
    </message>
    <message>
        <source>OpenCL device %1 cannot be used: %2; choose another one.</source>
        <translation>Das OpenCL-Gerät %1 ist nicht brauchbar: %2; bitte ein anderes wählen.</translation>
    </message>
    <message>
        <source>No plan could be drawn on this device; choose another one.</source>
        <translation>Auf diesem Gerät ließ sich kein Plan zeichnen; bitte ein anderes wählen.</translation>
    </message>
    <message>
        <source>Brute force could not be drawn on this device; choose another one.</source>
        <translation>Auf diesem Gerät ließ sich Brute Force nicht zeichnen; bitte ein anderes wählen.</translation>
    </message>
    <message>
        <source>%1 is no JSON; it may have been cut short.</source>
        <translation>%1 ist kein JSON; vielleicht wurde es abgeschnitten.</translation>
    </message>
    <message>
        <source>%1 has an unknown entry &apos;%2&apos;.</source>
        <translation>%1 hat einen unbekannten Eintrag „%2“.</translation>
    </message>
    <message>
        <source>%1 was saved by a newer Lacuna (session version %2; this one reads up to %3).</source>
        <translation>%1 wurde von einem neueren Lacuna gesichert (Sitzungsversion %2; dieses liest bis %3).</translation>
    </message>
    <message>
        <source>The session was saved with a volume of %1 voxels, the data now has %2; it is shown as newly opened.</source>
        <translation>Die Sitzung wurde mit einem Volumen von %1 Voxeln gesichert, die Daten haben jetzt %2; sie werden wie neu geöffnet gezeigt.</translation>
    </message>
    <message>
        <source>There is a preset named &quot;%1&quot; already; choose another name.</source>
        <translation>Eine Vorgabe namens „%1“ gibt es schon; bitte einen anderen Namen wählen.</translation>
    </message>
    <message>
        <source>A preset needs a name.</source>
        <translation>Eine Vorgabe braucht einen Namen.</translation>
    </message>
    <message>
        <source>The preset &quot;%1&quot; cannot be shown: %2</source>
        <translation>Die Vorgabe „%1“ kann nicht gezeigt werden: %2</translation>
    </message>
    <message>
        <source>%1: this transfer function is of version %2 of the format, which is newer than this program; it reads versions up to %3.</source>
        <translation>%1: Diese Transferfunktion ist von Version %2 des Formats, neuer als dieses Programm; es liest bis Version %3.</translation>
    </message>
    <message>
        <source>%1 cannot be reached: %9.</source>
        <translation>%1 ist nicht erreichbar: %9.</translation>
    </message>
    <message>
        <source>The server %1 offers none of the DICOM services asked for.</source>
        <translation>Der Server %1 bietet keinen der verlangten DICOM-Dienste an.</translation>
    </message>
    <message>
        <source>There is nothing to send.</source>
        <translation>Es gibt nichts zu senden.</translation>
    </message>
    <message>
        <source>Cannot send %1: it is no DICOM object.</source>
        <translation>%1 kann nicht gesendet werden: Es ist kein DICOM-Objekt.</translation>
    </message>
    <message>
        <source>Cannot write what the server sends to %1: the disk is full or the file size is limited; nothing was kept.</source>
        <translation>Was der Server sendet, kann nicht nach %1 geschrieben werden: Der Datenträger ist voll oder die Dateigröße begrenzt; es wurde nichts behalten.</translation>
    </message>
    <message>
        <source>There is not enough memory for this.</source>
        <translation>Dafür reicht der Speicher nicht.</translation>
    </message>
    <message>
        <source>Something unexpected went wrong: %1</source>
        <translation>Etwas Unerwartetes ging schief: %1</translation>
    </message>
    <message>
        <source>free some space or write elsewhere</source>
        <translation>bitte Platz schaffen oder anderswohin schreiben</translation>
    </message>
    <message>
        <source>the file system or a limit (ulimit -f) allows no file so large; write elsewhere</source>
        <translation>das Dateisystem oder eine Grenze (ulimit -f) erlaubt keine so große Datei; bitte anderswohin schreiben</translation>
    </message>
    <message>
        <source>name a folder that takes new files</source>
        <translation>bitte einen Ordner nennen, der neue Dateien aufnimmt</translation>
    </message>
    <message>
        <source>choose a shorter name</source>
        <translation>bitte einen kürzeren Namen wählen</translation>
    </message>
    <message>
        <source>check the disk or write elsewhere</source>
        <translation>bitte den Datenträger prüfen oder anderswohin schreiben</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>Zugriff verweigert</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>Datei oder Ordner nicht gefunden</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>kein Platz auf dem Datenträger</translation>
    </message>
    <message>
        <source>Disk quota exceeded</source>
        <translation>Platzkontingent überschritten</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>Dateisystem nur lesbar</translation>
    </message>
    <message>
        <source>Operation not permitted</source>
        <translation>Vorgang nicht erlaubt</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>Ein-/Ausgabefehler</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>ist ein Ordner</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>ist kein Ordner</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>Dateiname zu lang</translation>
    </message>
    <message>
        <source>File too large</source>
        <translation>Datei zu groß</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>zu viele offene Dateien</translation>
    </message>
    <message>
        <source>Stale file handle</source>
        <translation>Netzlaufwerk nicht mehr verbunden</translation>
    </message>
    <message>
        <source>Network is unreachable</source>
        <translation>Netz nicht erreichbar</translation>
    </message>
    <message>
        <source>No route to host</source>
        <translation>kein Weg zum Rechner</translation>
    </message>
    <message>
        <source>Connection reset by peer</source>
        <translation>Verbindung von der Gegenseite beendet</translation>
    </message>
    <message>
        <source>The volume holds no part: no material was found in it.</source>
        <translation>Das Volumen enthält kein Teil: Es wurde kein Material darin gefunden.</translation>
    </message>
    <message>
        <source>The part is cut by the volume&apos;s frame: what lies outside was not seen.</source>
        <translation>Das Teil ist vom Rand des Volumens angeschnitten: Was außerhalb liegt, wurde nicht gesehen.</translation>
    </message>
    <message>
        <source>The part reaches the volume&apos;s border: the border counts as its surface, and what it cuts is flagged.</source>
        <translation>Das Teil reicht bis an den Rand des Volumens: Der Rand zählt als seine Oberfläche, und was er anschneidet, ist vermerkt.</translation>
    </message>
    <message>
        <source>What was seen breaks %1 of %2 limits.</source>
        <translation>Was gesehen wurde, verletzt %1 von %2 Grenzen.</translation>
    </message>
    <message>
        <source>All %1 limits are kept.</source>
        <translation>Alle %1 Grenzen sind eingehalten.</translation>
    </message>
    <message>
        <source>The criteria set no limit, so there is nothing to pass.</source>
        <translation>Die Kriterien setzen keine Grenze, also gibt es nichts zu bestehen.</translation>
    </message>
    <message>
        <source>Defect %1 was rejected by hand: %2</source>
        <translation>Fehlstelle %1 wurde von Hand abgelehnt: %2</translation>
    </message>
    <message>
        <source>The material&apos;s range needs its low end below its high end.</source>
        <translation>Der Bereich des Materials braucht sein unteres Ende unter dem oberen.</translation>
    </message>
    <message>
        <source>The void threshold must lie below the inclusion threshold.</source>
        <translation>Die Schwelle für Hohlräume muss unter der für Einschlüsse liegen.</translation>
    </message>
    <message>
        <source>Cannot list the folder %1: %9.</source>
        <translation>Der Ordner %1 kann nicht durchgesehen werden: %9.</translation>
    </message>
    <message>
        <source>Cannot read %1: %9 (%2).</source>
        <translation>%1 kann nicht gelesen werden: %9 (%2).</translation>
    </message>
    <message>
        <source>Cannot read %1 again, whose header the DICOM files written copy.</source>
        <translation>%1 kann nicht noch einmal gelesen werden; die geschriebenen DICOM-Dateien übernehmen den Kopf daraus.</translation>
    </message>
    <message>
        <source>Not enough memory to unpack.</source>
        <translation>Zum Entpacken reicht der Speicher nicht.</translation>
    </message>
    <message>
        <source>Not enough memory to compress.</source>
        <translation>Zum Packen reicht der Speicher nicht.</translation>
    </message>
    <message>
        <source>Compression failed.</source>
        <translation>Das Packen ist gescheitert.</translation>
    </message>
    <message>
        <source>The system&apos;s cryptography library does not offer SHA-256.</source>
        <translation>Die Kryptografie-Bibliothek des Systems bietet kein SHA-256.</translation>
    </message>
    <message>
        <source>There is no %1 &apos;%2&apos;; known are %3.</source>
        <translation>„%2“ (%1) gibt es nicht; bekannt sind %3.</translation>
    </message>
    <message>
        <source>The series names no files.</source>
        <translation>Die Serie nennt keine Dateien.</translation>
    </message>
    <message>
        <source>The series has gaps: %1; add the missing files, or open it without --keep-gaps to have them interpolated.</source>
        <translation>Die Serie hat Lücken: %1; bitte die fehlenden Dateien ergänzen oder die Lücken beim Öffnen interpolieren lassen.</translation>
    </message>
    <message>
        <source>%1 of %2 slices repeat the position of another and are left out: %3</source>
        <translation>%1 von %2 Schichten wiederholen die Lage einer anderen und sind ausgelassen: %3</translation>
    </message>
    <message>
        <source>%1 of %2 files hold more pixels than rows, columns and frames say; check that the picture is whole and not skewed.</source>
        <translation>%1 von %2 Dateien enthalten mehr Bildpunkte, als Zeilen, Spalten und Einzelbilder besagen; bitte prüfen, ob das Bild ganz und nicht verschoben ist.</translation>
    </message>
    <message>
        <source>Values up to %1 exceed what 32-bit floating point holds exactly and are rounded.</source>
        <translation>Werte bis %1 überschreiten, was Gleitkomma mit 32 Bit genau fasst, und sind gerundet.</translation>
    </message>
    <message>
        <source>The slices are shifted within their planes by up to %1, unevenly; they are resampled to an upright grid.</source>
        <translation>Die Schichten sind in ihren Ebenen ungleichmäßig um bis zu %1 verschoben; sie sind auf ein aufrechtes Gitter umgerechnet.</translation>
    </message>
    <message>
        <source>Cannot read the pixels of %1: %9; copy or export the file again.</source>
        <translation>Die Bildpunkte von %1 können nicht gelesen werden: %9; bitte die Datei neu kopieren oder exportieren.</translation>
    </message>
    <message>
        <source>The pixels of %1 are wider than its header says; export it uncompressed.</source>
        <translation>Die Bildpunkte von %1 sind breiter, als der Kopf besagt; bitte ungepackt exportieren.</translation>
    </message>
    <message>
        <source>Cannot write the DICOM series %1: CT images hold whole numbers, but the volume has fractions or NaN; write .nrrd or .nii.gz instead.</source>
        <translation>Die DICOM-Serie %1 kann nicht geschrieben werden: CT-Bilder fassen ganze Zahlen, das Volumen hat aber Brüche oder NaN; bitte stattdessen .nrrd oder .nii.gz schreiben.</translation>
    </message>
    <message>
        <source>Cannot write the DICOM series %1: its values %2 do not fit 16 bits; write .nrrd or .nii.gz instead.</source>
        <translation>Die DICOM-Serie %1 kann nicht geschrieben werden: Die Werte %2 passen nicht in 16 Bit; bitte stattdessen .nrrd oder .nii.gz schreiben.</translation>
    </message>
    <message>
        <source>Cannot write the DICOM series %1: a slice holds at most 65535 rows and columns.</source>
        <translation>Die DICOM-Serie %1 kann nicht geschrieben werden: Eine Schicht fasst höchstens 65535 Zeilen und Spalten.</translation>
    </message>
    <message>
        <source>Cannot write the DICOM series %1: a slice holds at most 4294967294 bytes; write .nrrd instead.</source>
        <translation>Die DICOM-Serie %1 kann nicht geschrieben werden: Eine Schicht fasst höchstens 4294967294 Bytes; bitte stattdessen .nrrd schreiben.</translation>
    </message>
    <message>
        <source>Cannot write the DICOM series %1: %9; nothing was written; check the space and the permissions there, or write elsewhere.</source>
        <translation>Die DICOM-Serie %1 kann nicht geschrieben werden: %9; es wurde nichts geschrieben; bitte dort Platz und Rechte prüfen oder anderswohin schreiben.</translation>
    </message>
    <message>
        <source>The DICOM source names no image.</source>
        <translation>Die DICOM-Quelle nennt kein Bild.</translation>
    </message>
    <message>
        <source>The DICOM segmentation cannot be made: %9 was refused (%1).</source>
        <translation>Die DICOM-Segmentierung lässt sich nicht erstellen: %9 wurde abgelehnt (%1).</translation>
    </message>
    <message>
        <source>The DICOM report cannot be made: %9 was refused (%1).</source>
        <translation>Der DICOM-Bericht lässt sich nicht erstellen: %9 wurde abgelehnt (%1).</translation>
    </message>
    <message>
        <source>A DICOM segmentation holds 1 to 65535 segments.</source>
        <translation>Eine DICOM-Segmentierung fasst 1 bis 65535 Segmente.</translation>
    </message>
    <message>
        <source>Cannot write %1: frames of %2 x %3 are larger than a DICOM segmentation&apos;s 65535 rows and columns; inspect a part of it.</source>
        <translation>%1 kann nicht geschrieben werden: Bilder von %2 x %3 sind größer als die 65535 Zeilen und Spalten einer DICOM-Segmentierung; bitte einen Teil davon prüfen.</translation>
    </message>
    <message>
        <source>Cannot write %1: its %2 segments take more than the 4 GiB of frames that a DICOM segmentation holds; inspect a part of the volume, or fewer defects.</source>
        <translation>%1 kann nicht geschrieben werden: Die %2 Segmente brauchen mehr als die 4 GiB an Bildern, die eine DICOM-Segmentierung fasst; bitte einen Teil des Volumens prüfen oder weniger Fehlstellen.</translation>
    </message>
    <message>
        <source>The bytes are no RGB picture of the size given.</source>
        <translation>Die Bytes sind kein RGB-Bild der angegebenen Größe.</translation>
    </message>
    <message>
        <source>1 DICOM file without an image was left out.</source>
        <translation>1 DICOM-Datei ohne Bild wurde ausgelassen.</translation>
    </message>
    <message>
        <source>%1 DICOM files without an image were left out.</source>
        <translation>%1 DICOM-Dateien ohne Bild wurden ausgelassen.</translation>
    </message>
    <message>
        <source>1 DICOM file that cannot be read was left out.</source>
        <translation>1 nicht lesbare DICOM-Datei wurde ausgelassen.</translation>
    </message>
    <message>
        <source>%1 DICOM files that cannot be read were left out.</source>
        <translation>%1 nicht lesbare DICOM-Dateien wurden ausgelassen.</translation>
    </message>
    <message>
        <source>1 image says that patient data are drawn into the pixels (0028,0301); the pixels are not cleaned.</source>
        <translation>1 Bild gibt an, dass Patientendaten in die Bildpunkte gezeichnet sind (0028,0301); die Bildpunkte sind nicht bereinigt.</translation>
    </message>
    <message>
        <source>%1 images say that patient data are drawn into the pixels (0028,0301); the pixels are not cleaned.</source>
        <translation>%1 Bilder geben an, dass Patientendaten in die Bildpunkte gezeichnet sind (0028,0301); die Bildpunkte sind nicht bereinigt.</translation>
    </message>
    <message>
        <source>1 image does not say whether text is drawn into the pixels (0028,0301); look at them before passing them on.</source>
        <translation>1 Bild gibt nicht an, ob Text in die Bildpunkte gezeichnet ist (0028,0301); bitte vor dem Weitergeben ansehen.</translation>
    </message>
    <message>
        <source>%1 images do not say whether text is drawn into the pixels (0028,0301); look at them before passing them on.</source>
        <translation>%1 Bilder geben nicht an, ob Text in die Bildpunkte gezeichnet ist (0028,0301); bitte vor dem Weitergeben ansehen.</translation>
    </message>
    <message>
        <source>1 image says that a face can be recognised (0028,0302).</source>
        <translation>1 Bild gibt an, dass ein Gesicht zu erkennen ist (0028,0302).</translation>
    </message>
    <message>
        <source>%1 images say that a face can be recognised (0028,0302).</source>
        <translation>%1 Bilder geben an, dass ein Gesicht zu erkennen ist (0028,0302).</translation>
    </message>
    <message>
        <source>The size in &apos;%1&apos; is not a number of voxels; write for example sample:casting@192 or sample:casting@256x256x128.</source>
        <translation>Die Größe in „%1“ ist keine Zahl von Voxeln; bitte zum Beispiel sample:casting@192 oder sample:casting@256x256x128 schreiben.</translation>
    </message>
    <message>
        <source>Cannot read %1: it is raw, and neither a sidecar (.dat, .vgi, .mhd, .hdr) nor its name says its size; give --raw WxHxD:TYPE[:SX,SY,SZ][:be][:+OFFSET].</source>
        <translation>%1 kann nicht gelesen werden: Das Volumen ist roh, und weder eine Begleitdatei (.dat, .vgi, .mhd, .hdr) noch der Name nennt die Größe; bitte über das Menü Datei importieren.</translation>
    </message>
    <message>
        <source>%1 holds %2 volumes; choose one with --series N or --series UID:
%3</source>
        <translation>%1 enthält %2 Volumen; bitte eines über seine Nummer oder UID wählen:
%3</translation>
    </message>
    <message>
        <source>Several volumes of %1 carry the UID %2; choose one by its number:
%3</source>
        <translation>Mehrere Volumen von %1 tragen die UID %2; bitte eines über seine Nummer wählen:
%3</translation>
    </message>
    <message>
        <source>There is no series &apos;%1&apos; in %2; it holds one volume.</source>
        <translation>In %2 gibt es keine Serie „%1“; es enthält ein Volumen.</translation>
    </message>
    <message>
        <source>There is no series &apos;%1&apos; in %2; it holds:
%3</source>
        <translation>In %2 gibt es keine Serie „%1“; es enthält:
%3</translation>
    </message>
    <message>
        <source>A built-in sample such as %1 is made with its own grid; leave out --raw, --spacing and --series.</source>
        <translation>Ein eingebautes Beispiel wie %1 hat sein eigenes Gitter; bitte Rohbeschreibung, Abstand und Serie weglassen.</translation>
    </message>
    <message>
        <source>The spacing was given by hand; the DICOM files name %1 mm.</source>
        <translation>Der Abstand ist von Hand angegeben; die DICOM-Dateien nennen %1 mm.</translation>
    </message>
    <message>
        <source>There is no built-in sample &quot;%1&quot;; the samples are %2.</source>
        <translation>Ein eingebautes Beispiel „%1“ gibt es nicht; es gibt %2.</translation>
    </message>
    <message>
        <source>The sample&apos;s size %1 is outside %2 voxels; choose one inside.</source>
        <translation>Die Größe %1 des Beispiels liegt außerhalb von %2 Voxeln; bitte eine innerhalb wählen.</translation>
    </message>
    <message>
        <source>The sample would have more than 2^36 voxels; choose a smaller size.</source>
        <translation>Das Beispiel hätte mehr als 2^36 Voxel; bitte eine kleinere Größe wählen.</translation>
    </message>
    <message>
        <source>The sample&apos;s noise and blur must be finite numbers.</source>
        <translation>Rauschen und Unschärfe des Beispiels müssen endliche Zahlen sein.</translation>
    </message>
    <message>
        <source>The smoothing must be above 0 mm and at most %1 voxels of the finest axis; give a smaller length in mm.</source>
        <translation>Die Glättung muss über 0 mm und darf höchstens %1 Voxel der feinsten Achse betragen; bitte eine kleinere Länge in mm angeben.</translation>
    </message>
    <message>
        <source>The volume&apos;s geometry is unsound: %9.</source>
        <translation>Die Geometrie des Volumens ist nicht brauchbar: %9.</translation>
    </message>
    <message>
        <source>The volume needs %1 bytes but has %2.</source>
        <translation>Das Volumen braucht %1 Byte, hat aber %2.</translation>
    </message>
    <message>
        <source>%1 claims an axis of %2 voxels; an axis needs 1 to 2147483647.</source>
        <translation>%1 nennt eine Achse von %2 Voxeln; eine Achse braucht 1 bis 2147483647.</translation>
    </message>
    <message>
        <source>%1 claims %2 voxels, more than any memory holds.</source>
        <translation>%1 nennt %2 Voxel, mehr als jeder Speicher fasst.</translation>
    </message>
    <message>
        <source>%1 cannot hold an offset of %2 bytes.</source>
        <translation>%1 kann keinen Versatz von %2 Byte enthalten.</translation>
    </message>
    <message>
        <source>%1 has %2 bytes, but %3 voxels of %4 behind the offset need %5 bytes; check the size, the type and the offset.</source>
        <translation>%1 hat %2 Byte, aber %3 Voxel von %4 hinter dem Versatz brauchen %5 Byte; bitte Größe, Typ und Versatz prüfen.</translation>
    </message>
    <message>
        <source>%1 does not describe a raw volume: %9.</source>
        <translation>%1 beschreibt kein rohes Volumen: %9.</translation>
    </message>
    <message>
        <source>%1 stores voxels as &apos;%2&apos; of &apos;%3&apos; bits; supported are 8 and 16 bit integers and 32 bit floats.</source>
        <translation>%1 speichert die Voxel als „%2“ mit „%3“ Bit; möglich sind ganze Zahlen von 8 und 16 Bit und Gleitkomma von 32 Bit.</translation>
    </message>
    <message>
        <source>%1 gives the resolution in &apos;%2&apos;; use mm.</source>
        <translation>%1 nennt die Auflösung in „%2“; bitte mm verwenden.</translation>
    </message>
    <message>
        <source>%1 joins %2 data files; export the volume as one raw file.</source>
        <translation>%1 verbindet %2 Datendateien; bitte das Volumen als eine rohe Datei exportieren.</translation>
    </message>
    <message>
        <source>%1 names a data file of format &apos;%2&apos;, not raw.</source>
        <translation>%1 nennt eine Datendatei im Format „%2“, nicht roh.</translation>
    </message>
    <message>
        <source>Slices are missing in the numbered stack: from %1.</source>
        <translation>Im nummerierten Stapel fehlen Schichten: von %1.</translation>
    </message>
    <message>
        <source>The pages are marked as stored mirrored or turned (TIFF&apos;s Orientation); rows and columns were kept as they are stored.</source>
        <translation>Die Seiten sind als gespiegelt oder gedreht gespeichert gekennzeichnet (Orientation in TIFF); Zeilen und Spalten bleiben, wie sie gespeichert sind.</translation>
    </message>
    <message>
        <source>The pages are marked white-is-zero; stored values were kept as they are.</source>
        <translation>Die Seiten sind mit „Weiß ist null“ gekennzeichnet; die gespeicherten Werte bleiben, wie sie sind.</translation>
    </message>
    <message>
        <source>The grid&apos;s axes are not exactly at right angles; they were made so.</source>
        <translation>Die Achsen des Gitters stehen nicht genau rechtwinklig; sie wurden gerichtet.</translation>
    </message>
    <message>
        <source>The header gives lengths in &apos;%1&apos;, which is no known unit; mm is assumed.</source>
        <translation>Der Kopf nennt Längen in „%1“, einer unbekannten Einheit; angenommen ist mm.</translation>
    </message>
    <message>
        <source>The header names a value scale (slope %1, offset %2), which readers of MetaImage leave out; the values are as stored.</source>
        <translation>Der Kopf nennt eine Skalierung der Werte (Steigung %1, Versatz %2), die beim Lesen von MetaImage entfällt; die Werte sind wie gespeichert.</translation>
    </message>
    <message>
        <source>The file states no orientation (neither qform nor sform): left and right cannot be known from it.</source>
        <translation>Die Datei nennt keine Ausrichtung (weder qform noch sform): Links und rechts sind daraus nicht zu erkennen.</translation>
    </message>
    <message>
        <source>Values beyond 16777216 were rounded to 24 significant bits.</source>
        <translation>Werte jenseits von 16777216 sind auf 24 signifikante Bit gerundet.</translation>
    </message>
    <message>
        <source>Values beyond the range of 32 bit floats became infinite.</source>
        <translation>Werte jenseits des Bereichs von Gleitkomma mit 32 Bit sind unendlich geworden.</translation>
    </message>
    <message>
        <source>Cannot write %1: there is no volume.</source>
        <translation>%1 kann nicht geschrieben werden: Es gibt kein Volumen.</translation>
    </message>
    <message>
        <source>Cannot write %1: this volume does not go into memory, and only .raw, .mhd and .nrrd are written in parts; choose one of them or raise --memory-limit.</source>
        <translation>%1 kann nicht geschrieben werden: Dieses Volumen passt nicht in den Speicher, und nur .raw, .mhd und .nrrd werden in Teilen geschrieben; bitte eines davon wählen oder die Speichergrenze heraufsetzen.</translation>
    </message>
    <message>
        <source>Cannot write the labels to %1: name a .nrrd file.</source>
        <translation>Die Markierungen können nicht nach %1 geschrieben werden: Bitte eine .nrrd-Datei nennen.</translation>
    </message>
    <message>
        <source>Cannot write %1: the labels do not fit their grid.</source>
        <translation>%1 kann nicht geschrieben werden: Die Markierungen passen nicht zu ihrem Gitter.</translation>
    </message>
    <message>
        <source>Cannot write %1: NIfTI holds at most 32767 voxels an axis; write .nrrd instead.</source>
        <translation>%1 kann nicht geschrieben werden: NIfTI fasst höchstens 32767 Voxel je Achse; bitte stattdessen .nrrd schreiben.</translation>
    </message>
    <message>
        <source>Cannot write %1: the mesh has over 2147483647 elements.</source>
        <translation>%1 kann nicht geschrieben werden: Das Netz hat über 2147483647 Elemente.</translation>
    </message>
    <message>
        <source>Cannot write %1: a triangle names a vertex that is not there.</source>
        <translation>%1 kann nicht geschrieben werden: Ein Dreieck nennt einen Eckpunkt, den es nicht gibt.</translation>
    </message>
    <message>
        <source>%1 bytes are no picture of %2 RGB pixels.</source>
        <translation>%1 Byte sind kein Bild von %2 RGB-Bildpunkten.</translation>
    </message>
    <message>
        <source>Cannot write %1: A picture could not be compressed: %2.</source>
        <translation>%1 kann nicht geschrieben werden: Das Bild ließ sich nicht packen: %2.</translation>
    </message>
    <message>
        <source>Cannot write %1: %2 bytes are no picture of %3 RGB pixels.</source>
        <translation>%1 kann nicht geschrieben werden: %2 Byte sind kein Bild von %3 RGB-Bildpunkten.</translation>
    </message>
    <message>
        <source>A picture could not be compressed: %1.</source>
        <translation>Ein Bild ließ sich nicht packen: %1.</translation>
    </message>
    <message>
        <source>The date &apos;%1&apos; is none; write YYYYMMDD.</source>
        <translation>Das Datum „%1“ ist keines; bitte JJJJMMTT schreiben.</translation>
    </message>
    <message>
        <source>The port %1 is none; ports are 1 to 65535, for DICOM often 104 or 11112.</source>
        <translation>Den Port %1 gibt es nicht; Ports sind 1 bis 65535, für DICOM oft 104 oder 11112.</translation>
    </message>
    <message>
        <source>The time to wait for the server must be a second at least.</source>
        <translation>Die Wartezeit auf den Server muss mindestens eine Sekunde betragen.</translation>
    </message>
    <message>
        <source>The receiver has no address of this computer; 127.0.0.1 is only it.</source>
        <translation>Der Empfänger hat keine Adresse dieses Rechners; 127.0.0.1 meint nur ihn selbst.</translation>
    </message>
    <message>
        <source>The receiver&apos;s port %1 is none; ports are 1 to 65535.</source>
        <translation>Den Empfangsport %1 gibt es nicht; Ports sind 1 bis 65535.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no unique identifier of a study or series.</source>
        <translation>„%1“ ist keine eindeutige Kennung einer Studie oder Serie.</translation>
    </message>
    <message>
        <source>No network connection can be made: %9.</source>
        <translation>Es lässt sich keine Netzverbindung aufbauen: %9.</translation>
    </message>
    <message>
        <source>The server %1 did not do the %9: %8 (status %2).</source>
        <translation>Der Server %1 hat dies nicht ausgeführt: %9; %8 (Status %2).</translation>
    </message>
    <message>
        <source>There is no address %1 to receive at; check the receiver&apos;s.</source>
        <translation>Unter der Adresse %1 kann nichts empfangen werden; bitte die Adresse des Empfängers prüfen.</translation>
    </message>
    <message>
        <source>Cannot receive at %1 port %2: %9; %8.</source>
        <translation>An %1, Port %2, kann nichts empfangen werden: %9; %8.</translation>
    </message>
    <message>
        <source>Images were sent by %1, and refused: from %2 to %3 is taken; correct the AE titles.</source>
        <translation>Bilder wurden von %1 gesendet und abgelehnt: Angenommen wird von %2 an %3; bitte die AE-Titel berichtigen.</translation>
    </message>
    <message>
        <source>%1 For C-MOVE the server has to know this program as %2.</source>
        <translation>%1 Für C-MOVE muss der Server dieses Programm kennen als %2.</translation>
    </message>
    <message>
        <source>The server says that it sent %1 files, but none came to %2; correct what it knows of it.</source>
        <translation>Der Server meldet %1 gesendete Dateien, aber bei %2 kam keine an; bitte berichtigen, was er darüber gespeichert hat.</translation>
    </message>
    <message>
        <source>Cannot read a private key from %1; it must be a PEM file without a password.</source>
        <translation>Aus %1 lässt sich kein privater Schlüssel lesen; es muss eine PEM-Datei ohne Kennwort sein.</translation>
    </message>
    <message>
        <source>Cannot read a certificate from %1; it must be a PEM file.</source>
        <translation>Aus %1 lässt sich kein Zertifikat lesen; es muss eine PEM-Datei sein.</translation>
    </message>
    <message>
        <source>The private key %1 does not belong to the certificate.</source>
        <translation>Der private Schlüssel %1 gehört nicht zum Zertifikat.</translation>
    </message>
    <message>
        <source>This system&apos;s TLS library does not offer the ciphers of BCP 195.</source>
        <translation>Die TLS-Bibliothek dieses Systems bietet die Verfahren von BCP 195 nicht an.</translation>
    </message>
    <message>
        <source>Cannot read trusted certificates from %1; it must be a PEM file.</source>
        <translation>Aus %1 lassen sich keine vertrauten Zertifikate lesen; es muss eine PEM-Datei sein.</translation>
    </message>
    <message>
        <source>Receiving over a secure connection needs a certificate of this program&apos;s own; name its PEM file, or retrieve by C-GET.</source>
        <translation>Der Empfang über eine sichere Verbindung braucht ein eigenes Zertifikat dieses Programms; bitte dessen PEM-Datei nennen oder mit C-GET holen.</translation>
    </message>
    <message>
        <source>they are cut short, damaged, or of a precision their decoder does not know</source>
        <translation>Sie sind abgeschnitten, beschädigt oder von einer Genauigkeit, die ihr Dekoder nicht kennt</translation>
    </message>
    <message>
        <source>they are cut short or damaged</source>
        <translation>Sie sind abgeschnitten oder beschädigt</translation>
    </message>
    <message>
        <source>they are cut short</source>
        <translation>Sie sind abgeschnitten</translation>
    </message>
    <message>
        <source>there are none</source>
        <translation>Es gibt keine</translation>
    </message>
    <message>
        <source>their size is unknown</source>
        <translation>Ihre Größe ist unbekannt</translation>
    </message>
    <message>
        <source>frame %1 is cut short or damaged</source>
        <translation>Einzelbild %1 ist abgeschnitten oder beschädigt</translation>
    </message>
    <message>
        <source>the file is cut short or damaged</source>
        <translation>Die Datei ist abgeschnitten oder beschädigt</translation>
    </message>
    <message>
        <source>the decoder failed</source>
        <translation>Der Dekoder versagte</translation>
    </message>
    <message>
        <source>they are of %1 x %2 pixels, but the header says %3 x %4</source>
        <translation>Sie haben %1 x %2 Bildpunkte, laut Kopf aber %3 x %4</translation>
    </message>
    <message>
        <source>they have no frame header</source>
        <translation>Ihnen fehlt der Kopf des Einzelbilds</translation>
    </message>
    <message>
        <source>they are no JPEG 2000 code stream</source>
        <translation>Sie sind kein Codestrom von JPEG 2000</translation>
    </message>
    <message>
        <source>they are of no size</source>
        <translation>Sie haben keine Größe</translation>
    </message>
    <message>
        <source>they have %1 samples a pixel, or coarser ones, but the header says %2</source>
        <translation>Sie haben %1 Werte je Bildpunkt oder gröbere, laut Kopf aber %2</translation>
    </message>
    <message>
        <source>they are signed numbers, but the header says unsigned</source>
        <translation>Sie haben Vorzeichen, laut Kopf aber keine</translation>
    </message>
    <message>
        <source>they are of %1 bits, but the header allots %2</source>
        <translation>Sie haben %1 Bit, der Kopf sieht aber %2 vor</translation>
    </message>
    <message>
        <source>they are in %1 RLE segments, but the header needs %2</source>
        <translation>Sie stehen in %1 RLE-Segmenten, der Kopf braucht aber %2</translation>
    </message>
    <message>
        <source>their RLE header is damaged</source>
        <translation>Ihr RLE-Kopf ist beschädigt</translation>
    </message>
    <message>
        <source>an RLE segment unpacks to %1 pixels, but the header says %2 x %3</source>
        <translation>Ein RLE-Segment ergibt entpackt %1 Bildpunkte, laut Kopf aber %2 x %3</translation>
    </message>
    <message>
        <source>it claims more pixels than any file could hold</source>
        <translation>Der Kopf nennt mehr Bildpunkte, als irgendeine Datei fassen könnte</translation>
    </message>
    <message>
        <source>it claims more frames than its bytes could hold</source>
        <translation>Der Kopf nennt mehr Einzelbilder, als die Datei fassen könnte</translation>
    </message>
    <message>
        <source>it is cut short: %1 of %2 bytes of pixels are there</source>
        <translation>Die Datei ist abgeschnitten: %1 von %2 Byte der Bildpunkte sind vorhanden</translation>
    </message>
    <message>
        <source>it is a colour image (%1); only grey values make a volume</source>
        <translation>Das Bild ist farbig (%1); nur Grauwerte ergeben ein Volumen</translation>
    </message>
    <message>
        <source>its header cannot be parsed; it may be cut short or damaged</source>
        <translation>Der Kopf ist nicht zu verstehen; er ist vielleicht abgeschnitten oder beschädigt</translation>
    </message>
    <message>
        <source>it has no pixels (7FE0,0010)</source>
        <translation>Das Bild hat keine Bildpunkte (7FE0,0010)</translation>
    </message>
    <message>
        <source>%1 has not three values</source>
        <translation>%1 hat nicht drei Werte</translation>
    </message>
    <message>
        <source>%1 has not six values</source>
        <translation>%1 hat nicht sechs Werte</translation>
    </message>
    <message>
        <source>%1 has not two values</source>
        <translation>%1 hat nicht zwei Werte</translation>
    </message>
    <message>
        <source>%1 holds no two perpendicular unit vectors</source>
        <translation>%1 enthält keine zwei senkrechten Einheitsvektoren</translation>
    </message>
    <message>
        <source>%1 is not positive</source>
        <translation>%1 ist nicht positiv</translation>
    </message>
    <message>
        <source>%1 is negative</source>
        <translation>%1 ist negativ</translation>
    </message>
    <message>
        <source>%1 is zero</source>
        <translation>%1 ist null</translation>
    </message>
    <message>
        <source>%1 is %2, which cannot be</source>
        <translation>%1 ist %2, was nicht sein kann</translation>
    </message>
    <message>
        <source>%1 is %2, but its pixels are floating-point numbers of %3</source>
        <translation>%1 ist %2, die Bildpunkte sind aber Gleitkommazahlen von %3</translation>
    </message>
    <message>
        <source>%1 is %2; 1, 8, 16 and 32 can be read</source>
        <translation>%1 ist %2; gelesen werden können 1, 8, 16 und 32</translation>
    </message>
    <message>
        <source>%1 does not fit %2</source>
        <translation>%1 passt nicht zu %2</translation>
    </message>
    <message>
        <source>%1 is not a number</source>
        <translation>%1 ist keine Zahl</translation>
    </message>
    <message>
        <source>%1 cannot be read</source>
        <translation>%1 ist nicht lesbar</translation>
    </message>
    <message>
        <source>%1 is not a whole number</source>
        <translation>%1 ist keine ganze Zahl</translation>
    </message>
    <message>
        <source>%1 is missing</source>
        <translation>%1 fehlt</translation>
    </message>
    <message>
        <source>the disk is full or the file size is limited</source>
        <translation>Der Datenträger ist voll oder die Dateigröße begrenzt</translation>
    </message>
    <message>
        <source>the whole</source>
        <translation>das Ganze</translation>
    </message>
    <message>
        <source>its frame size</source>
        <translation>die Bildgröße</translation>
    </message>
    <message>
        <source>the source&apos;s patient or study</source>
        <translation>Patient oder Studie der Quelle</translation>
    </message>
    <message>
        <source>the series number</source>
        <translation>die Nummer der Serie</translation>
    </message>
    <message>
        <source>the series UID</source>
        <translation>die UID der Serie</translation>
    </message>
    <message>
        <source>the spacing</source>
        <translation>der Abstand</translation>
    </message>
    <message>
        <source>the slice thickness</source>
        <translation>die Schichtdicke</translation>
    </message>
    <message>
        <source>the slice spacing</source>
        <translation>der Schichtabstand</translation>
    </message>
    <message>
        <source>the orientation</source>
        <translation>die Ausrichtung</translation>
    </message>
    <message>
        <source>a segment</source>
        <translation>ein Segment</translation>
    </message>
    <message>
        <source>a tracking id</source>
        <translation>eine Verfolgungskennung</translation>
    </message>
    <message>
        <source>a tracking UID</source>
        <translation>eine Verfolgungs-UID</translation>
    </message>
    <message>
        <source>a dimension index</source>
        <translation>ein Dimensionsindex</translation>
    </message>
    <message>
        <source>the source&apos;s class</source>
        <translation>die Klasse der Quelle</translation>
    </message>
    <message>
        <source>the source&apos;s UID</source>
        <translation>die UID der Quelle</translation>
    </message>
    <message>
        <source>the source&apos;s frame</source>
        <translation>das Einzelbild der Quelle</translation>
    </message>
    <message>
        <source>a measurement group</source>
        <translation>eine Messgruppe</translation>
    </message>
    <message>
        <source>the source series</source>
        <translation>die Quellserie</translation>
    </message>
    <message>
        <source>an evaluation</source>
        <translation>eine Bewertung</translation>
    </message>
    <message>
        <source>the language</source>
        <translation>die Sprache</translation>
    </message>
    <message>
        <source>the observer</source>
        <translation>der Beobachter</translation>
    </message>
    <message>
        <source>the procedure</source>
        <translation>das Verfahren</translation>
    </message>
    <message>
        <source>the character set</source>
        <translation>der Zeichensatz</translation>
    </message>
    <message>
        <source>the source&apos;s patient</source>
        <translation>der Patient der Quelle</translation>
    </message>
    <message>
        <source>the source&apos;s study</source>
        <translation>die Studie der Quelle</translation>
    </message>
    <message>
        <source>the content</source>
        <translation>der Inhalt</translation>
    </message>
    <message>
        <source>the type</source>
        <translation>der Typ</translation>
    </message>
    <message>
        <source>the manufacturer</source>
        <translation>der Hersteller</translation>
    </message>
    <message>
        <source>the model</source>
        <translation>das Modell</translation>
    </message>
    <message>
        <source>the version</source>
        <translation>die Version</translation>
    </message>
    <message>
        <source>the completion</source>
        <translation>der Abschluss</translation>
    </message>
    <message>
        <source>an axis has no voxels</source>
        <translation>Eine Achse hat keine Voxel</translation>
    </message>
    <message>
        <source>the voxel spacing is not a positive number</source>
        <translation>Der Voxelabstand ist keine positive Zahl</translation>
    </message>
    <message>
        <source>the origin is not a finite position</source>
        <translation>Der Ursprung ist keine endliche Lage</translation>
    </message>
    <message>
        <source>it has too many voxels</source>
        <translation>Es hat zu viele Voxel</translation>
    </message>
    <message>
        <source>the voxel spacing is too small or too large to calculate with</source>
        <translation>Der Voxelabstand ist zu klein oder zu groß, um damit zu rechnen</translation>
    </message>
    <message>
        <source>the grid axes are not orthonormal</source>
        <translation>Die Achsen des Gitters sind nicht orthonormal</translation>
    </message>
    <message>
        <source>its spacing along axis %1 is %2, but spacings must be positive numbers of mm</source>
        <translation>Der Abstand längs der Achse %1 ist %2; Abstände müssen positive Zahlen in mm sein</translation>
    </message>
    <message>
        <source>its origin is not a finite position</source>
        <translation>Der Ursprung ist keine endliche Lage</translation>
    </message>
    <message>
        <source>its data file %1 is not there; put it beside the header</source>
        <translation>Die Datendatei %1 gibt es nicht; bitte neben den Kopf legen</translation>
    </message>
    <message>
        <source>its data files &apos;%1&apos; are no pattern of names with one whole number (%d) in it</source>
        <translation>die Datendateien „%1“ sind kein Muster von Namen mit einer ganzen Zahl (%d) darin</translation>
    </message>
    <message>
        <source>its data files &apos;%1&apos; are not the %2 that its sizes ask for</source>
        <translation>die Datendateien „%1“ sind nicht die %2, die die Maße verlangen</translation>
    </message>
    <message>
        <source>it lists %1 data files, but its sizes ask for %2</source>
        <translation>die Liste nennt %1 Datendateien, aber die Maße verlangen %2</translation>
    </message>
    <message>
        <source>its voxels are stored as text in several files</source>
        <translation>die Voxel stehen als Text in mehreren Dateien</translation>
    </message>
    <message>
        <source>the orientation its %1 states holds what is no finite number</source>
        <translation>die Orientierung in %1 enthält, was keine endliche Zahl ist</translation>
    </message>
    <message>
        <source>it claims %1 bytes of voxels, more than its %2 compressed bytes can hold; the file is cut or its sizes are wrong</source>
        <translation>Der Kopf nennt %1 Byte Voxel, mehr als die %2 gepackten Byte fassen können; die Datei ist abgeschnitten oder ihre Maße sind falsch</translation>
    </message>
    <message>
        <source>its voxels need %1 bytes, but there are %2; the file is cut or its sizes are wrong</source>
        <translation>Die Voxel brauchen %1 Byte, vorhanden sind %2; die Datei ist abgeschnitten oder ihre Maße sind falsch</translation>
    </message>
    <message>
        <source>its spacing pixdim[%1] is %2, but spacings must be positive numbers of mm</source>
        <translation>Der Abstand pixdim[%1] ist %2; Abstände müssen positive Zahlen in mm sein</translation>
    </message>
    <message>
        <source>its %1 is &apos;%2&apos;, but spacings must be positive numbers of mm</source>
        <translation>%1 ist „%2“; Abstände müssen positive Zahlen in mm sein</translation>
    </message>
    <message>
        <source>it is no MetaImage header (no line ElementDataFile)</source>
        <translation>Die Datei ist kein Kopf von MetaImage (ohne Zeile ElementDataFile)</translation>
    </message>
    <message>
        <source>its ElementType &apos;%1&apos; is not a scalar type</source>
        <translation>Der ElementType „%1“ ist kein skalarer Typ</translation>
    </message>
    <message>
        <source>its %1 voxels are stored as text, but there are %2 numbers; the file is cut or its sizes are wrong</source>
        <translation>Die %1 Voxel sind als Text gespeichert, es gibt aber %2 Zahlen; die Datei ist abgeschnitten oder ihre Maße sind falsch</translation>
    </message>
    <message>
        <source>its %1 &apos;%2&apos; is not %3 numbers</source>
        <translation>%1 „%2“ besteht nicht aus %3 Zahlen</translation>
    </message>
    <message>
        <source>its BinaryDataByteOrderMSB and ElementByteOrderMSB contradict each other</source>
        <translation>BinaryDataByteOrderMSB und ElementByteOrderMSB widersprechen einander</translation>
    </message>
    <message>
        <source>its DimSize &apos;%1&apos; does not fit its NDims &apos;%2&apos;</source>
        <translation>DimSize „%1“ passt nicht zu NDims „%2“</translation>
    </message>
    <message>
        <source>its HeaderSize -1 does not go with compressed voxels</source>
        <translation>HeaderSize -1 verträgt sich nicht mit gepackten Voxeln</translation>
    </message>
    <message>
        <source>its HeaderSize %1 does not lie within the data</source>
        <translation>HeaderSize %1 liegt nicht innerhalb der Daten</translation>
    </message>
    <message>
        <source>it is no NRRD file (it does not start with NRRD)</source>
        <translation>Die Datei ist kein NRRD (sie beginnt nicht mit NRRD)</translation>
    </message>
    <message>
        <source>its voxels are opaque blocks</source>
        <translation>Die Voxel sind undurchsichtige Blöcke</translation>
    </message>
    <message>
        <source>its type &apos;%1&apos; is unknown</source>
        <translation>Der Typ „%1“ ist unbekannt</translation>
    </message>
    <message>
        <source>its data have fewer lines than it says to skip</source>
        <translation>Die Daten haben weniger Zeilen, als zu überspringen sind</translation>
    </message>
    <message>
        <source>its space units differ from axis to axis</source>
        <translation>Die Raumeinheiten unterscheiden sich von Achse zu Achse</translation>
    </message>
    <message>
        <source>its axis mins and axis maxs make no spacing, which must be a positive number of mm</source>
        <translation>axis mins und axis maxs ergeben keinen Abstand; er muss eine positive Zahl in mm sein</translation>
    </message>
    <message>
        <source>its sizes &apos;%1&apos; are no whole numbers</source>
        <translation>Die Größen „%1“ sind keine ganzen Zahlen</translation>
    </message>
    <message>
        <source>its byte skip of -1 does not go with compressed voxels</source>
        <translation>byte skip -1 verträgt sich nicht mit gepackten Voxeln</translation>
    </message>
    <message>
        <source>its byte skip is too large</source>
        <translation>byte skip ist zu groß</translation>
    </message>
    <message>
        <source>it is cut short, or no NIfTI file: its header needs 348 bytes</source>
        <translation>Die Datei ist abgeschnitten oder kein NIfTI: Der Kopf braucht 348 Byte</translation>
    </message>
    <message>
        <source>it has more axes than its space; write a line &quot;kinds: list domain domain domain&quot; that says which one is none of space</source>
        <translation>Es gibt mehr Achsen als der Raum hat; bitte eine Zeile „kinds: list domain domain domain“ schreiben, die sagt, welche keine des Raums ist</translation>
    </message>
    <message>
        <source>it is no NIfTI file (its magic word is missing)</source>
        <translation>Die Datei ist kein NIfTI (das Kennwort fehlt)</translation>
    </message>
    <message>
        <source>its number of dimensions is not within 1 to 7</source>
        <translation>Die Zahl der Dimensionen liegt nicht in 1 bis 7</translation>
    </message>
    <message>
        <source>its bitpix %1 does not fit its datatype %2</source>
        <translation>bitpix %1 passt nicht zu datatype %2</translation>
    </message>
    <message>
        <source>its voxels are of datatype %1 (colours, complex or single bits); only scalar volumes can be opened</source>
        <translation>Die Voxel haben den datatype %1 (Farben, komplex oder einzelne Bit); nur skalare Volumen können geöffnet werden</translation>
    </message>
    <message>
        <source>its vox_offset is %1, but must be %2 at least</source>
        <translation>vox_offset ist %1, muss aber mindestens %2 sein</translation>
    </message>
    <message>
        <source>its axes are not at right angles, or contradict its voxel spacing; resample it to a rectangular grid first</source>
        <translation>Die Achsen stehen nicht rechtwinklig oder widersprechen dem Voxelabstand; bitte zuerst auf ein rechtwinkliges Gitter umrechnen</translation>
    </message>
    <message>
        <source>its header says twice, and differently, how large it is</source>
        <translation>Der Kopf nennt die Größe zweimal, und verschieden</translation>
    </message>
    <message>
        <source>its voxel type %1 is not supported</source>
        <translation>Der Voxeltyp %1 wird nicht unterstützt</translation>
    </message>
    <message>
        <source>its voxels are cut short</source>
        <translation>Die Voxel sind abgeschnitten</translation>
    </message>
    <message>
        <source>it is no TIFF file or is damaged</source>
        <translation>Die Datei ist kein TIFF oder beschädigt</translation>
    </message>
    <message>
        <source>its palette is not of 8 bits; convert it to grey values</source>
        <translation>Die Palette hat nicht 8 Bit; bitte in Grauwerte umwandeln</translation>
    </message>
    <message>
        <source>it has a colour palette; convert it to grey values</source>
        <translation>Die Datei hat eine Farbpalette; bitte in Grauwerte umwandeln</translation>
    </message>
    <message>
        <source>it has several samples a pixel (colours); convert it to grey values</source>
        <translation>Die Datei hat mehrere Werte je Bildpunkt (Farben); bitte in Grauwerte umwandeln</translation>
    </message>
    <message>
        <source>it holds no grey values; convert it</source>
        <translation>Die Datei enthält keine Grauwerte; bitte umwandeln</translation>
    </message>
    <message>
        <source>its pixels of %1 bits are not supported; convert it to 8 or 16 bit integers or 32 bit floats</source>
        <translation>Bildpunkte von %1 Bit werden nicht unterstützt; bitte in ganze Zahlen von 8 oder 16 Bit oder Gleitkomma von 32 Bit umwandeln</translation>
    </message>
    <message>
        <source>it has no pixels</source>
        <translation>Die Datei hat keine Bildpunkte</translation>
    </message>
    <message>
        <source>its rows are not as long as its width says</source>
        <translation>Die Zeilen sind nicht so lang, wie die Breite besagt</translation>
    </message>
    <message>
        <source>its pixels are damaged or cut short</source>
        <translation>Die Bildpunkte sind beschädigt oder abgeschnitten</translation>
    </message>
    <message>
        <source>its tiles have an odd size</source>
        <translation>Die Kacheln haben eine seltsame Größe</translation>
    </message>
    <message>
        <source>page %1 has %2 pixels of %3 bits, or another palette or type, unlike the first page with %4 of %5</source>
        <translation>Seite %1 hat %2 Bildpunkte von %3 Bit oder eine andere Palette oder einen anderen Typ als die erste Seite mit %4 von %5</translation>
    </message>
    <message>
        <source>its list of pages is damaged or cut short after page %1</source>
        <translation>Die Liste der Seiten ist nach Seite %1 beschädigt oder abgeschnitten</translation>
    </message>
    <message>
        <source>ImageJ stored several channels or points of time in its pages; save one of them alone</source>
        <translation>ImageJ hat mehrere Kanäle oder Zeitpunkte in den Seiten gespeichert; bitte einen davon allein sichern</translation>
    </message>
    <message>
        <source>ImageJ stored its %1 slices behind one page; save it as raw or as an image sequence</source>
        <translation>ImageJ hat %1 Schichten hinter einer Seite gespeichert; bitte roh oder als Bildfolge sichern</translation>
    </message>
    <message>
        <source>a folder of TIFF files is a stack of slices, but this file has %1 pages; open one multi-page file by its name</source>
        <translation>Ein Ordner von TIFF-Dateien ist ein Stapel von Schichten, diese Datei hat aber %1 Seiten; bitte eine mehrseitige Datei bei ihrem Namen öffnen</translation>
    </message>
    <message>
        <source>page %1 cannot be read</source>
        <translation>Seite %1 ist nicht lesbar</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a size WxHxD</source>
        <translation>„%1“ ist keine Größe WxHxD</translation>
    </message>
    <message>
        <source>the size %1 is out of range</source>
        <translation>die Größe %1 liegt außerhalb des Möglichen</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is neither a spacing SX,SY,SZ nor be nor +OFFSET</source>
        <translation>„%1“ ist weder ein Abstand SX,SY,SZ noch be noch +OFFSET</translation>
    </message>
    <message>
        <source>the spacing &apos;%1&apos; must be positive numbers in mm</source>
        <translation>der Abstand „%1“ muss aus positiven Zahlen in mm bestehen</translation>
    </message>
    <message>
        <source>size or type is missing</source>
        <translation>Größe oder Typ fehlt</translation>
    </message>
    <message>
        <source>the type &apos;%1&apos; is none of u8 i8 u16 i16 f32</source>
        <translation>der Typ „%1“ ist keiner von u8 i8 u16 i16 f32</translation>
    </message>
    <message>
        <source>the offset &apos;%1&apos; is not +BYTES</source>
        <translation>der Versatz „%1“ ist nicht +BYTES</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be three whole numbers</source>
        <translation>„%1“ muss aus drei ganzen Zahlen bestehen</translation>
    </message>
    <message>
        <source>&apos;Origin&apos; must be three numbers</source>
        <translation>„Origin“ muss aus drei Zahlen bestehen</translation>
    </message>
    <message>
        <source>&apos;Direction&apos; must be nine numbers</source>
        <translation>„Direction“ muss aus neun Zahlen bestehen</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be three numbers</source>
        <translation>„%1“ muss aus drei Zahlen bestehen</translation>
    </message>
    <message>
        <source>the spacing &apos;%1&apos; is %2, but must be positive</source>
        <translation>der Abstand „%1“ ist %2, muss aber positiv sein</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is missing</source>
        <translation>„%1“ fehlt</translation>
    </message>
    <message>
        <source>the Format &apos;%1&apos; is none of UCHAR CHAR USHORT SHORT FLOAT</source>
        <translation>das Format „%1“ ist keines von UCHAR CHAR USHORT SHORT FLOAT</translation>
    </message>
    <message>
        <source>it has no [file1] section</source>
        <translation>der Abschnitt [file1] fehlt</translation>
    </message>
    <message>
        <source>&apos;SkipHeader&apos; is not a number of bytes</source>
        <translation>„SkipHeader“ ist keine Zahl von Byte</translation>
    </message>
    <message>
        <source>it failed there</source>
        <translation>dort ist es gescheitert</translation>
    </message>
    <message>
        <source>it is out of resources</source>
        <translation>ihm fehlen die Mittel</translation>
    </message>
    <message>
        <source>it does not know the destination</source>
        <translation>er kennt das Ziel nicht</translation>
    </message>
    <message>
        <source>it does not do this for such data</source>
        <translation>er tut dies nicht für solche Daten</translation>
    </message>
    <message>
        <source>this program is not allowed to</source>
        <translation>dieses Programm darf das nicht</translation>
    </message>
    <message>
        <source>it was cancelled there</source>
        <translation>dort wurde es abgebrochen</translation>
    </message>
    <message>
        <source>search (C-FIND)</source>
        <translation>Suche (C-FIND)</translation>
    </message>
    <message>
        <source>storing (C-STORE)</source>
        <translation>Speichern (C-STORE)</translation>
    </message>
    <message>
        <source>retrieval (C-GET)</source>
        <translation>Holen (C-GET)</translation>
    </message>
    <message>
        <source>retrieval (C-MOVE)</source>
        <translation>Holen (C-MOVE)</translation>
    </message>
    <message>
        <source>verification (C-ECHO)</source>
        <translation>Prüfung (C-ECHO)</translation>
    </message>
    <message>
        <source>choose another port</source>
        <translation>bitte einen anderen Port wählen</translation>
    </message>
    <message>
        <source>name one of this computer&apos;s addresses</source>
        <translation>bitte eine Adresse dieses Rechners nennen</translation>
    </message>
    <message>
        <source>choose a port from 1024 on</source>
        <translation>bitte einen Port ab 1024 wählen</translation>
    </message>
    <message>
        <source>check the receiver&apos;s address and port</source>
        <translation>bitte Adresse und Port des Empfängers prüfen</translation>
    </message>
    <message>
        <source>Address already in use</source>
        <translation>Adresse schon in Gebrauch</translation>
    </message>
    <message>
        <source>Cannot assign requested address</source>
        <translation>Adresse nicht verfügbar</translation>
    </message>
    <message>
        <source>a finding</source>
        <translation>ein Befund</translation>
    </message>
    <message>
        <source>a frame</source>
        <translation>ein Einzelbild</translation>
    </message>
    <message>
        <source>a measurement</source>
        <translation>eine Messung</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>ein Text</translation>
    </message>
    <message>
        <source>searching (C-FIND by the study root)</source>
        <translation>Suchen (C-FIND nach der Studienwurzel)</translation>
    </message>
    <message>
        <source>retrieving (C-GET by the study root)</source>
        <translation>Holen (C-GET nach der Studienwurzel)</translation>
    </message>
    <message>
        <source>retrieving (C-MOVE by the study root)</source>
        <translation>Holen (C-MOVE nach der Studienwurzel)</translation>
    </message>
    <message>
        <source>the file name states this size, and the length of the file fits it</source>
        <translation>der Dateiname nennt diese Größe, und die Länge der Datei passt dazu</translation>
    </message>
    <message>
        <source>the file name states this size</source>
        <translation>der Dateiname nennt diese Größe</translation>
    </message>
    <message>
        <source>the first bytes of the file state this size</source>
        <translation>die ersten Bytes der Datei nennen diese Größe</translation>
    </message>
    <message>
        <source>the length of the file fits to the byte</source>
        <translation>die Länge der Datei passt auf das Byte</translation>
    </message>
    <message>
        <source>%1 bytes are left over for a header</source>
        <translation>%1 Byte bleiben für einen Kopf übrig</translation>
    </message>
    <message>
        <source>the file name states this type</source>
        <translation>der Dateiname nennt diesen Typ</translation>
    </message>
    <message>
        <source>rows repeat after %1 voxels</source>
        <translation>Zeilen wiederholen sich nach %1 Voxeln</translation>
    </message>
    <message>
        <source>slices repeat after %1 rows</source>
        <translation>Schichten wiederholen sich nach %1 Zeilen</translation>
    </message>
    <message>
        <source>neighbours differ less in big endian</source>
        <translation>Nachbarn unterscheiden sich in Big-Endian weniger</translation>
    </message>
    <message>
        <source>neighbours differ less in little endian</source>
        <translation>Nachbarn unterscheiden sich in Little-Endian weniger</translation>
    </message>
    <message>
        <source>Only pictures of the same size can be compared.</source>
        <translation>Nur Bilder gleicher Größe lassen sich vergleichen.</translation>
    </message>
    <message>
        <source>FLIP needs more than 0 pixels a degree.</source>
        <translation>FLIP braucht mehr als 0 Bildpunkte je Grad.</translation>
    </message>
    <message>
        <source>A voxel&apos;s size must be above 0.</source>
        <translation>Die Größe eines Voxels muss über 0 liegen.</translation>
    </message>
    <message>
        <source>A sweep needs at least one view.</source>
        <translation>Eine Messreihe braucht mindestens eine Ansicht.</translation>
    </message>
    <message>
        <source>Planning needs an error or a time budget.</source>
        <translation>Das Planen braucht ein Fehler- oder ein Zeitbudget.</translation>
    </message>
    <message>
        <source>The error budget must be at least 0.</source>
        <translation>Das Fehlerbudget muss mindestens 0 sein.</translation>
    </message>
    <message>
        <source>The time budget must be above 0.</source>
        <translation>Das Zeitbudget muss über 0 liegen.</translation>
    </message>
    <message>
        <source>At least one frame must be expected.</source>
        <translation>Mindestens ein Bild muss zu erwarten sein.</translation>
    </message>
    <message>
        <source>Shear-warp has one plan; a budget goes with the modes that cast rays.</source>
        <translation>Shear-Warp hat einen einzigen Plan; ein Budget gehört zu den Modi, die Strahlen werfen.</translation>
    </message>
    <message>
        <source>Only a built-in sample has a closed form to compare with; take sample:NAME or the reference &apos;fine&apos;.</source>
        <translation>Nur ein eingebautes Beispiel hat eine geschlossene Form zum Vergleich; bitte sample:NAME oder die Referenz „fine“ nehmen.</translation>
    </message>
    <message>
        <source>There is no closed form to compare with for %9; compare with the references &apos;samples&apos; or &apos;fine&apos;.</source>
        <translation>Zum Vergleich gibt es keine geschlossene Form für %9; bitte mit den Referenzen „samples“ oder „fine“ vergleichen.</translation>
    </message>
    <message>
        <source>the device&apos;s costs have no good &quot;%1&quot;.</source>
        <translation>die Kosten des Geräts haben kein gültiges „%1“.</translation>
    </message>
    <message>
        <source>this is no JSON object of a device&apos;s costs.</source>
        <translation>dies ist kein JSON-Objekt der Kosten eines Geräts.</translation>
    </message>
    <message>
        <source>A device buffer of no bytes was asked for.</source>
        <translation>Ein Gerätepuffer von null Byte wurde verlangt.</translation>
    </message>
    <message>
        <source>There is no kernel source &quot;%1&quot; in this program.</source>
        <translation>Eine Kernelquelle „%1“ gibt es in diesem Programm nicht.</translation>
    </message>
    <message>
        <source>Kernel source %1, line %2, includes &quot;%3&quot;, which is not in this program.</source>
        <translation>Die Kernelquelle %1, Zeile %2, bindet „%3“ ein, das es in diesem Programm nicht gibt.</translation>
    </message>
    <message>
        <source>Kernel %1 does not compile on %2: %3</source>
        <translation>Der Kernel %1 lässt sich auf %2 nicht übersetzen: %3</translation>
    </message>
    <message>
        <source>Kernel source %1 has no kernel &quot;%2&quot;.</source>
        <translation>Die Kernelquelle %1 hat keinen Kernel „%2“.</translation>
    </message>
    <message>
        <source>Each part of the %1 colour must lie between 0 and 1.</source>
        <translation>Jeder Anteil der Farbe (%1) muss zwischen 0 und 1 liegen.</translation>
    </message>
    <message>
        <source>A scene takes at most %1 cutting planes, not %2.</source>
        <translation>Eine Szene fasst höchstens %1 Schnittebenen, nicht %2.</translation>
    </message>
    <message>
        <source>A cutting plane needs a normal a,b,c that is finite and not 0,0,0.</source>
        <translation>Eine Schnittebene braucht eine Normale a,b,c, die endlich und nicht 0,0,0 ist.</translation>
    </message>
    <message>
        <source>A cutting plane&apos;s offset must be a finite number.</source>
        <translation>Der Versatz einer Schnittebene muss eine endliche Zahl sein.</translation>
    </message>
    <message>
        <source>A scene takes at most %1 segmentation ranges and transfer functions of regions together.</source>
        <translation>Eine Szene fasst höchstens %1 Segmentierungsbereiche und Transferfunktionen von Regionen zusammen.</translation>
    </message>
    <message>
        <source>A scene takes at most %1 segmentation ranges, not %2.</source>
        <translation>Eine Szene fasst höchstens %1 Segmentierungsbereiche, nicht %2.</translation>
    </message>
    <message>
        <source>A segmentation range&apos;s lower end must not exceed its upper end.</source>
        <translation>Das untere Ende eines Segmentierungsbereichs darf nicht über dem oberen liegen.</translation>
    </message>
    <message>
        <source>Transfer functions of regions need the regions&apos; voxels.</source>
        <translation>Transferfunktionen von Regionen brauchen die Voxel der Regionen.</translation>
    </message>
    <message>
        <source>The region classes must hold one byte for each voxel of the volume.</source>
        <translation>Die Regionsklassen müssen ein Byte für jedes Voxel des Volumens enthalten.</translation>
    </message>
    <message>
        <source>Shear-warp paints surface voxels, whatever region they are in; use mode iso, ea, mip, lmip, minip or mean to show or hide regions.</source>
        <translation>Shear-Warp zeichnet die Voxel der Oberfläche, gleich in welcher Region; um Regionen zu zeigen oder auszublenden, bitte den Modus iso, ea, mip, lmip, minip oder mean nehmen.</translation>
    </message>
    <message>
        <source>Regions have transfer functions of their own in mode ea alone.</source>
        <translation>Eigene Transferfunktionen haben Regionen nur im Modus ea.</translation>
    </message>
    <message>
        <source>The camera&apos;s angles must be finite numbers.</source>
        <translation>Die Winkel der Kamera müssen endliche Zahlen sein.</translation>
    </message>
    <message>
        <source>The camera&apos;s centre must be finite.</source>
        <translation>Die Mitte der Kamera muss endlich sein.</translation>
    </message>
    <message>
        <source>A highlight must hold one byte for each voxel of its box.</source>
        <translation>Eine Hervorhebung muss ein Byte für jedes Voxel ihres Quaders enthalten.</translation>
    </message>
    <message>
        <source>A highlight&apos;s opacity must lie between 0 and 1.</source>
        <translation>Die Deckkraft einer Hervorhebung muss zwischen 0 und 1 liegen.</translation>
    </message>
    <message>
        <source>The scene holds no volume; open one first.</source>
        <translation>Die Szene enthält kein Volumen; bitte zuerst eines öffnen.</translation>
    </message>
    <message>
        <source>The isovalue must be a finite number.</source>
        <translation>Der Isowert muss eine endliche Zahl sein.</translation>
    </message>
    <message>
        <source>The LMIP threshold must be a finite number.</source>
        <translation>Die LMIP-Schwelle muss eine endliche Zahl sein.</translation>
    </message>
    <message>
        <source>The grey window&apos;s lower end must be below its upper end.</source>
        <translation>Das untere Ende des Graufensters muss unter dem oberen liegen.</translation>
    </message>
    <message>
        <source>The zoom must be a positive number.</source>
        <translation>Der Zoom muss eine positive Zahl sein.</translation>
    </message>
    <message>
        <source>The image size must be 1 to 16384 pixels on each side.</source>
        <translation>Das Bild muss 1 bis 16384 Bildpunkte je Seite haben.</translation>
    </message>
    <message>
        <source>There is no region %1; the volume has regions 1 to %2 (lacuna regions lists them).</source>
        <translation>Eine Region %1 gibt es nicht; das Volumen hat die Regionen 1 bis %2.</translation>
    </message>
    <message>
        <source>At most %1 regions can have transfer functions of their own.</source>
        <translation>Höchstens %1 Regionen können eigene Transferfunktionen haben.</translation>
    </message>
    <message>
        <source>There is no such effect.</source>
        <translation>Einen solchen Effekt gibt es nicht.</translation>
    </message>
    <message>
        <source>There is no effect &apos;%1&apos;; known are %2.</source>
        <translation>Einen Effekt „%1“ gibt es nicht; bekannt sind %2.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a number; effect %2 takes numbers separated by commas.</source>
        <translation>„%1“ ist keine Zahl; der Effekt %2 nimmt durch Kommas getrennte Zahlen.</translation>
    </message>
    <message>
        <source>Effect %1 takes at most %2 value (%3), not %4.</source>
        <translation>Der Effekt %1 nimmt höchstens %2 Wert (%3), nicht %4.</translation>
    </message>
    <message>
        <source>Effect %1 takes at most %2 values (%3), not %4.</source>
        <translation>Der Effekt %1 nimmt höchstens %2 Werte (%3), nicht %4.</translation>
    </message>
    <message>
        <source>Effect %1 needs a value: %2.</source>
        <translation>Der Effekt %1 braucht einen Wert: %2.</translation>
    </message>
    <message>
        <source>Effect %1: the %2 must be a whole number from %3 to %4, not %5.</source>
        <translation>Effekt %1: %2 muss eine ganze Zahl von %3 bis %4 sein, nicht %5.</translation>
    </message>
    <message>
        <source>Effect %1: the %2 must be a number from %3 to %4, not %5.</source>
        <translation>Effekt %1: %2 muss eine Zahl von %3 bis %4 sein, nicht %5.</translation>
    </message>
    <message>
        <source>The list of effects has an empty place; write name[=v[,v..]],name..</source>
        <translation>Die Liste der Effekte hat eine leere Stelle; bitte name[=w[,w..]],name.. schreiben.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; belongs to no effect; write name[=v[,v..]],name..</source>
        <translation>„%1“ gehört zu keinem Effekt; bitte name[=w[,w..]],name.. schreiben.</translation>
    </message>
    <message>
        <source>Effect ao needs a surface, which mode %1 does not show; modes iso, shear-warp and ea do.</source>
        <translation>Der Effekt ao braucht eine Oberfläche, die der Modus %1 nicht zeigt; die Modi iso, shear-warp und ea zeigen eine.</translation>
    </message>
    <message>
        <source>%9 needs the whole volume in memory, and this one is read in parts; raise --memory-limit or leave it out.</source>
        <translation>%9 braucht das ganze Volumen im Speicher, und dieses wird in Teilen gelesen; bitte die Speichergrenze heraufsetzen oder dies weglassen.</translation>
    </message>
    <message>
        <source>More than 2^32 voxels are visible; use mode iso, or an isovalue that gives a simpler surface.</source>
        <translation>Mehr als 2^32 Voxel sind sichtbar; bitte den Modus iso nehmen oder einen Isowert mit einfacherer Oberfläche.</translation>
    </message>
    <message>
        <source>Shear-warp takes at most 65534 voxels along an axis; use mode iso.</source>
        <translation>Shear-Warp nimmt höchstens 65534 Voxel je Achse; bitte den Modus iso nehmen.</translation>
    </message>
    <message>
        <source>The homogeneity of leaping is a share of the value range: give 0 to 1.</source>
        <translation>Die Homogenität beim Springen ist ein Anteil am Wertebereich: bitte 0 bis 1 angeben.</translation>
    </message>
    <message>
        <source>Leaping needs the sampling step it prepares for, in mm and above 0.</source>
        <translation>Das Springen braucht die Abtastweite, für die es vorbereitet, in mm und über 0.</translation>
    </message>
    <message>
        <source>The probability and relative radius of centre-voxel groups must lie in 0 to 1.</source>
        <translation>Wahrscheinlichkeit und relativer Radius der Mittelvoxel-Gruppen müssen in 0 bis 1 liegen.</translation>
    </message>
    <message>
        <source>Leaping keeps densities of 15 bits, and this volume has f32 values: state the range to quantise (--leap-quantise LO,HI), or use the structure macrocells, octree, pyramid, pc, acd or eacd.</source>
        <translation>Das Springen hält Dichten von 15 Bit, und dieses Volumen hat f32-Werte: bitte den Bereich zum Quantisieren nennen oder die Struktur macrocells, octree, pyramid, pc, acd oder eacd nehmen.</translation>
    </message>
    <message>
        <source>The lower end of the range to quantise must be below its upper end.</source>
        <translation>Das untere Ende des Bereichs zum Quantisieren muss unter dem oberen liegen.</translation>
    </message>
    <message>
        <source>The homogeneity of leap is a share of the value range: it must lie within 0 to 1.</source>
        <translation>Die Homogenität von leap ist ein Anteil am Wertebereich: Sie muss in 0 bis 1 liegen.</translation>
    </message>
    <message>
        <source>Centre-voxel groups take a probability and a relative radius within 0 to 1.</source>
        <translation>Mittelvoxel-Gruppen haben eine Wahrscheinlichkeit und einen relativen Radius in 0 bis 1.</translation>
    </message>
    <message>
        <source>The smallest region to leap through has 1 voxel or more.</source>
        <translation>Die kleinste zu überspringende Region hat mindestens 1 Voxel.</translation>
    </message>
    <message>
        <source>The range leap is to quantise must be finite, its lower end below its upper.</source>
        <translation>Der Bereich, den leap quantisieren soll, muss endlich sein, das untere Ende unter dem oberen.</translation>
    </message>
    <message>
        <source>The leaping kernel &apos;%1&apos; shows all regions alike; &apos;lossless&apos; hides some or draws them its own way.</source>
        <translation>Der Sprungkernel „%1“ zeigt alle Regionen gleich; „lossless“ blendet einzelne aus oder zeichnet sie eigens.</translation>
    </message>
    <message>
        <source>The structure &apos;leap&apos; answers with runs of equal samples, which pre-integrated segments do not take; none, macrocells, octree, pyramid, pc, acd and eacd can serve them.</source>
        <translation>Die Struktur „leap“ antwortet mit Folgen gleicher Proben, die vorintegrierte Segmente nicht nehmen; none, macrocells, octree, pyramid, pc, acd und eacd passen dazu.</translation>
    </message>
    <message>
        <source>The leaping kernel &apos;%1&apos; serves mode ea without shading and opacity by gradient, sampled linearly; &apos;lossless&apos; serves the rest.</source>
        <translation>Der Sprungkernel „%1“ dient dem Modus ea ohne Schattierung und Deckkraft nach Gradient, linear abgetastet; „lossless“ dient dem Rest.</translation>
    </message>
    <message>
        <source>There is no gradient &apos;%1&apos;; known are central or sobel, on-the-fly or stored, or one of each (sobel,stored).</source>
        <translation>Einen Gradienten „%1“ gibt es nicht; bekannt sind central oder sobel, on-the-fly oder stored, oder je einer davon (sobel,stored).</translation>
    </message>
    <message>
        <source>The sampler &apos;adaptive&apos; belongs to ray casting; shear-warp takes nearest or linear.</source>
        <translation>Der Abtaster „adaptive“ gehört zum Strahlenwerfen; Shear-Warp nimmt nearest oder linear.</translation>
    </message>
    <message>
        <source>The refinement &apos;cubic&apos; solves the trilinear signal: it goes with the sampler linear alone.</source>
        <translation>Die Verfeinerung „cubic“ löst das trilineare Signal: Sie gehört allein zum Abtaster linear.</translation>
    </message>
    <message>
        <source>Bricks go with the samplers nearest and linear, central gradients on the fly, the integration riemann, refinements other than cubic and plain sparse casting.</source>
        <translation>Zu Blöcken gehören die Abtaster nearest und linear, zentrale Gradienten im Lauf, die Integration riemann, andere Verfeinerungen als cubic und schlichtes dünnes Strahlenwerfen.</translation>
    </message>
    <message>
        <source>Pre-integrated segments serve the mode ea alone; take the integration riemann for the others.</source>
        <translation>Vorintegrierte Abschnitte dienen nur dem Modus ea; bitte für die anderen die Integration riemann nehmen.</translation>
    </message>
    <message>
        <source>Pre-integrated segments take values to change linearly: they go with the sampler linear alone.</source>
        <translation>Vorintegrierte Abschnitte setzen linear veränderliche Werte voraus: Sie gehören allein zum Abtaster linear.</translation>
    </message>
    <message>
        <source>Homogeneous runs do not go with pre-integrated segments; take the integration riemann.</source>
        <translation>Homogene Läufe vertragen sich nicht mit vorintegrierten Abschnitten; bitte die Integration riemann nehmen.</translation>
    </message>
    <message>
        <source>Opacity by gradient cannot be integrated over values alone; take the integration riemann.</source>
        <translation>Deckkraft nach Gradient lässt sich nicht über Werte allein integrieren; bitte die Integration riemann nehmen.</translation>
    </message>
    <message>
        <source>The step must lie between 0.01 and 100 voxel spacings.</source>
        <translation>Die Schrittweite muss zwischen 0,01 und 100 Voxelabständen liegen.</translation>
    </message>
    <message>
        <source>The number of refinement steps must lie between 0 and 64.</source>
        <translation>Die Zahl der Verfeinerungsschritte muss zwischen 0 und 64 liegen.</translation>
    </message>
    <message>
        <source>The early ray termination must be at least 0 and below 1.</source>
        <translation>Das frühe Strahlende muss mindestens 0 und unter 1 sein.</translation>
    </message>
    <message>
        <source>The homogeneity threshold must not be negative, its angle lie within 0 to 180 degrees.</source>
        <translation>Die Homogenitätsschwelle darf nicht negativ sein, ihr Winkel muss in 0 bis 180 Grad liegen.</translation>
    </message>
    <message>
        <source>The macro-cell edge must be 1, 4, 8 or 16 voxels.</source>
        <translation>Die Kante der Makrozellen muss 1, 4, 8 oder 16 Voxel sein.</translation>
    </message>
    <message>
        <source>The brick edge must lie between 8 and 1024 voxels; 0: no bricks.</source>
        <translation>Die Kante der Blöcke muss zwischen 8 und 1024 Voxeln liegen; 0: keine Blöcke.</translation>
    </message>
    <message>
        <source>Shear-warp does not work on bricks; use mode iso.</source>
        <translation>Shear-Warp arbeitet nicht auf Blöcken; bitte den Modus iso nehmen.</translation>
    </message>
    <message>
        <source>Regions are shown, hidden and coloured sample by sample, which cubic refinement, pre-integration and the adaptive sampler do not do; leave one of them out.</source>
        <translation>Regionen werden Abtastpunkt für Abtastpunkt gezeigt, ausgeblendet und gefärbt, was kubische Verfeinerung, Vorintegration und der adaptive Abtaster nicht tun; bitte eines davon weglassen.</translation>
    </message>
    <message>
        <source>Sparse casting takes every 2nd to 64th pixel.</source>
        <translation>Dünnes Strahlenwerfen nimmt jeden 2. bis 64. Bildpunkt.</translation>
    </message>
    <message>
        <source>The colour gradient of sparse casting must not be negative.</source>
        <translation>Der Farbgradient des dünnen Strahlenwerfens darf nicht negativ sein.</translation>
    </message>
    <message>
        <source>Sparse casting skips rays; shear-warp casts none. Leave one of them out.</source>
        <translation>Dünnes Strahlenwerfen lässt Strahlen aus; Shear-Warp wirft keine. Bitte eines davon weglassen.</translation>
    </message>
    <message>
        <source>Shear-warp divides the viewing directions into 6 or 24 regions.</source>
        <translation>Shear-Warp teilt die Blickrichtungen in 6 oder 24 Bereiche.</translation>
    </message>
    <message>
        <source>The structure &apos;%1&apos; knows no transfer functions of regions; none and leap do.</source>
        <translation>Die Struktur „%1“ kennt keine Transferfunktionen von Regionen; none und leap kennen sie.</translation>
    </message>
    <message>
        <source>The structure &apos;%1&apos; does not serve ray casting.</source>
        <translation>Die Struktur „%1“ dient dem Strahlenwerfen nicht.</translation>
    </message>
    <message>
        <source>Drawing this volume brick by brick takes at least %1 and the limit is %2; raise --memory-limit or make a smaller picture.</source>
        <translation>Dieses Volumen Block für Block zu zeichnen braucht mindestens %1, die Grenze ist %2; bitte die Speichergrenze heraufsetzen oder ein kleineres Bild nehmen.</translation>
    </message>
    <message>
        <source>The reference renderer casts rays; shear-warp has its own renderer. Use mode iso to compare.</source>
        <translation>Der Referenz-Renderer wirft Strahlen; Shear-Warp hat einen eigenen Renderer. Bitte zum Vergleich den Modus iso nehmen.</translation>
    </message>
    <message>
        <source>leap has no key &quot;%1&quot;.</source>
        <translation>leap hat keinen Schlüssel „%1“.</translation>
    </message>
    <message>
        <source>this is no JSON.</source>
        <translation>dies ist kein JSON.</translation>
    </message>
    <message>
        <source>a plan is a JSON object.</source>
        <translation>ein Plan ist ein JSON-Objekt.</translation>
    </message>
    <message>
        <source>a plan has no key &quot;%1&quot;.</source>
        <translation>ein Plan hat keinen Schlüssel „%1“.</translation>
    </message>
    <message>
        <source>the plan&apos;s &quot;%1&quot; is of the wrong kind.</source>
        <translation>„%1“ des Plans ist von falscher Art.</translation>
    </message>
    <message>
        <source>Bricks of %1 voxels, streamed from disk: the volume&apos;s %2 do not go into %3.</source>
        <translation>Blöcke von %1 Voxeln, vom Datenträger gelesen: Die %2 des Volumens passen nicht in %3.</translation>
    </message>
    <message>
        <source>Bricks of %1 voxels: the device takes at most %2 at once, the volume has %3.</source>
        <translation>Blöcke von %1 Voxeln: Das Gerät nimmt höchstens %2 auf einmal, das Volumen hat %3.</translation>
    </message>
    <message>
        <source>Bricks of %1 voxels: the volume&apos;s %2 exceed what the device may hold.</source>
        <translation>Blöcke von %1 Voxeln: Die %2 des Volumens sind mehr, als das Gerät halten darf.</translation>
    </message>
    <message>
        <source>Rays run to their end: nothing is hidden.</source>
        <translation>Strahlen laufen bis ans Ende: Nichts bleibt verborgen.</translation>
    </message>
    <message>
        <source>Rays end at opacity %1: what is left is below %2 of 255 grey levels.</source>
        <translation>Strahlen enden bei Deckkraft %1: Der Rest liegt unter %2 von 255 Graustufen.</translation>
    </message>
    <message>
        <source>Adaptive sampler: nearest in blocks whose every value is drawn alike, so the picture is linear&apos;s; most reads of eight voxels go, little of the time.</source>
        <translation>Adaptiver Abtaster: nearest in Blöcken, deren Werte alle gleich gezeichnet werden, also das Bild von linear; es entfallen die meisten Zugriffe auf acht Voxel, aber wenig Zeit.</translation>
    </message>
    <message>
        <source>Adaptive sampler: little to gain here, the structure already leaves out most blocks that are drawn alike.</source>
        <translation>Adaptiver Abtaster: hier wenig zu gewinnen, die Struktur lässt die meisten gleich gezeichneten Blöcke schon aus.</translation>
    </message>
    <message>
        <source>Cubic: every cell the ray crosses is solved, so no wall is missed, whatever the step.</source>
        <translation>Kubisch: Jede vom Strahl gekreuzte Zelle wird gelöst, also fehlt bei keiner Schrittweite eine Wand.</translation>
    </message>
    <message>
        <source>Plain regula falsi: stalls on convex stretches; regula-falsi does not.</source>
        <translation>Schlichte Regula falsi: stockt auf konvexen Strecken; regula-falsi nicht.</translation>
    </message>
    <message>
        <source>A peak of the transfer function is narrower than the threshold: homogeneous nodes may hide it; pc, acd and eacd compare opacities.</source>
        <translation>Eine Spitze der Transferfunktion ist schmaler als die Schwelle: Homogene Knoten können sie verdecken; pc, acd und eacd vergleichen Deckkräfte.</translation>
    </message>
    <message>
        <source>Pre-integrated segments: a transfer function&apos;s peaks between two samples are not missed.</source>
        <translation>Vorintegrierte Abschnitte: Spitzen der Transferfunktion zwischen zwei Abtastpunkten gehen nicht verloren.</translation>
    </message>
    <message>
        <source>Sparse casting asks min-max cells what its rays may have missed.</source>
        <translation>Dünnes Strahlenwerfen befragt Min-Max-Zellen, was den Strahlen entgangen sein kann.</translation>
    </message>
    <message>
        <source>Sparse casting loses what is thinner than its pixel distance and no cast ray meets.</source>
        <translation>Dünnes Strahlenwerfen verliert, was dünner als sein Bildpunktabstand ist und kein Strahl trifft.</translation>
    </message>
    <message>
        <source>Stored gradients: 4 bytes a voxel, directions within 0.2 degrees of those on the fly.</source>
        <translation>Gespeicherte Gradienten: 4 Byte je Voxel, Richtungen auf 0,2 Grad wie die im Lauf gerechneten.</translation>
    </message>
    <message>
        <source>Visible voxels: shear-warp paints the surface voxels that 1 of 24 regions of viewing directions can see; 2x2 predecessors list about half as many as the 3x3 of 6 regions.</source>
        <translation>Sichtbare Voxel: Shear-Warp zeichnet die Voxel der Oberfläche, die einer von 24 Bereichen der Blickrichtungen sehen kann; 2x2 Vorgänger ergeben etwa halb so viele wie die 3x3 bei 6 Bereichen.</translation>
    </message>
    <message>
        <source>Bilinear within the slices for a still picture; nearest is the faster one while the view moves.</source>
        <translation>Bilinear in den Schichten für ein stehendes Bild; nearest ist schneller, solange sich die Ansicht bewegt.</translation>
    </message>
    <message>
        <source>No distances: no ray is cast.</source>
        <translation>Keine Abstände: Es wird kein Strahl geworfen.</translation>
    </message>
    <message>
        <source>Distances over macro-cells, an octant of directions each: rays jump to the next cell whose values lie on both sides of the surface.</source>
        <translation>Abstände über Makrozellen, je Oktant der Richtungen: Strahlen springen zur nächsten Zelle, deren Werte zu beiden Seiten der Oberfläche liegen.</translation>
    </message>
    <message>
        <source>Regula falsi, 5 steps: the surface&apos;s depth is far more exact than the sample distance.</source>
        <translation>Regula falsi, 5 Schritte: Die Tiefe der Oberfläche ist weit genauer als die Abtastweite.</translation>
    </message>
    <message>
        <source>Distances over macro-cells, an octant of directions each: rays jump to the next cell with a visible value.</source>
        <translation>Abstände über Makrozellen, je Oktant der Richtungen: Strahlen springen zur nächsten Zelle mit einem sichtbaren Wert.</translation>
    </message>
    <message>
        <source>Macro-cells: cells that can hold no winner are jumped over.</source>
        <translation>Makrozellen: Zellen, die keinen Gewinner enthalten können, werden übersprungen.</translation>
    </message>
    <message>
        <source>Macro-cells: a stretch of samples whose cells hold no value better than the best so far is left out, after the most promising stretch was sampled first.</source>
        <translation>Makrozellen: Eine Strecke, deren Zellen keinen besseren Wert als den bisher besten enthalten, bleibt aus, nachdem die aussichtsreichste zuerst abgetastet wurde.</translation>
    </message>
    <message>
        <source>Distances over macro-cells: rays jump over what the segmentation ranges hide.</source>
        <translation>Abstände über Makrozellen: Strahlen überspringen, was die Segmentierungsbereiche ausblenden.</translation>
    </message>
    <message>
        <source>No structure: the mean counts every sample.</source>
        <translation>Keine Struktur: Im Mittel zählt jeder Abtastpunkt.</translation>
    </message>
    <message>
        <source>No structure: regions have transfer functions of their own; none and leap know them.</source>
        <translation>Keine Struktur: Regionen haben eigene Transferfunktionen; none und leap kennen sie.</translation>
    </message>
    <message>
        <source>Cells of 4^3 voxels: closer to what is visible than 8^3, an eighth of the voxels&apos; bytes.</source>
        <translation>Zellen von 4^3 Voxeln: näher am Sichtbaren als 8^3, ein Achtel der Bytes der Voxel.</translation>
    </message>
    <message>
        <source>Two samples a voxel, trilinear: below that, thin walls are missed.</source>
        <translation>Zwei Abtastpunkte je Voxel, trilinear: Bei weniger gehen dünne Wände verloren.</translation>
    </message>
    <message>
        <source>No stored gradients: they are taken where a sample shows.</source>
        <translation>Keine gespeicherten Gradienten: Sie werden gerechnet, wo ein Abtastpunkt sichtbar ist.</translation>
    </message>
    <message>
        <source>Every sample counts in the mean: a structure gains nothing here.</source>
        <translation>Im Mittel zählt jeder Abtastpunkt: Eine Struktur bringt hier nichts.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; knows what is visible, not how large it is: without segmentation ranges it gains nothing in this mode.</source>
        <translation>„%1“ weiß, was sichtbar ist, nicht wie groß es ist: Ohne Segmentierungsbereiche bringt es in diesem Modus nichts.</translation>
    </message>
    <message>
        <source>Brute force: what every other plan is measured against.</source>
        <translation>Brute Force: daran wird jeder andere Plan gemessen.</translation>
    </message>
    <message>
        <source>The structure &apos;%1&apos;, as asked.</source>
        <translation>Die Struktur „%1“, wie verlangt.</translation>
    </message>
    <message>
        <source>how far off it is only a drawn view tells, and %1 more are to come.</source>
        <translation>Die Abweichung zeigt nur eine gezeichnete Ansicht, und %1 weitere stehen aus.</translation>
    </message>
    <message>
        <source>%1/255 off on %2 rays of this view; the budget is %3/255.</source>
        <translation>weicht auf %2 Strahlen dieser Ansicht um %1/255 ab; das Budget ist %3/255.</translation>
    </message>
    <message>
        <source>about %1 ms a frame, no faster than without loss (%2 ms).</source>
        <translation>etwa %1 ms je Bild, nicht schneller als ohne Verlust (%2 ms).</translation>
    </message>
    <message>
        <source>what it interpolates is over %1/255 off for any gradient.</source>
        <translation>das Interpolierte weicht bei jedem Gradienten um mehr als %1/255 ab.</translation>
    </message>
    <message>
        <source>it would cast %1 % of the rays and take about %2 ms a frame, %3 ms without.</source>
        <translation>würde %1 % der Strahlen werfen und etwa %2 ms je Bild brauchen, ohne %3 ms.</translation>
    </message>
    <message>
        <source>%1/255 off in the whole view; the budget is %2/255.</source>
        <translation>weicht in der ganzen Ansicht um %1/255 ab; das Budget ist %2/255.</translation>
    </message>
    <message>
        <source>about %1 ms a frame expected; others that fit take %2 ms.</source>
        <translation>etwa %1 ms je Bild zu erwarten; andere passende brauchen %2 ms.</translation>
    </message>
    <message>
        <source>%1 faster ones did not keep the budget; not drawn.</source>
        <translation>%1 schnellere hielten das Budget nicht; nicht gezeichnet.</translation>
    </message>
    <message>
        <source>%1 ms a frame; the plan taken needs %2 ms, timed in turn.</source>
        <translation>%1 ms je Bild; der gewählte Plan braucht %2 ms, im Wechsel gemessen.</translation>
    </message>
    <message>
        <source>about %1/255 off expected; the plan taken is %2/255 off.</source>
        <translation>etwa %1/255 Abweichung zu erwarten; der gewählte Plan weicht um %2/255 ab.</translation>
    </message>
    <message>
        <source>about %1 ms a frame and %2 ms to build; %3 takes %4 ms and %5 ms over %6 frames.</source>
        <translation>etwa %1 ms je Bild und %2 ms zum Aufbau; %3 braucht %4 ms und %5 ms über %6 Bilder.</translation>
    </message>
    <message>
        <source>about %1 ms a frame; the budget is %2 ms.</source>
        <translation>etwa %1 ms je Bild; das Budget ist %2 ms.</translation>
    </message>
    <message>
        <source>%1 ms for the whole view; the budget is %2 ms.</source>
        <translation>%1 ms für die ganze Ansicht; das Budget ist %2 ms.</translation>
    </message>
    <message>
        <source>%1/255 off; the plan taken is %2/255 off.</source>
        <translation>weicht um %1/255 ab; der gewählte Plan um %2/255.</translation>
    </message>
    <message>
        <source>Measured in %1 of %2 views, the worst of them counts; the others may differ.</source>
        <translation>In %1 von %2 Ansichten gemessen, die schlechteste zählt; die anderen können abweichen.</translation>
    </message>
    <message>
        <source>Holds in all %1 views by rule (the same samples as brute force are taken in any), and was measured in %2 of them.</source>
        <translation>Gilt nach der Regel in allen %1 Ansichten (in jeder werden dieselben Abtastpunkte wie bei Brute Force genommen) und wurde in %2 davon gemessen.</translation>
    </message>
    <message>
        <source>Holds in all %1 views by rule (rays end where at most %2 of 255 levels are hidden, in any), and was measured in %3 of them.</source>
        <translation>Gilt nach der Regel in allen %1 Ansichten (Strahlen enden in jeder, wo höchstens %2 von 255 Stufen verborgen sind) und wurde in %3 davon gemessen.</translation>
    </message>
    <message>
        <source>%1: %2/255 from brute force over the whole view and %3 ms a frame, both measured (error budget %4).</source>
        <translation>%1: %2/255 Abweichung von Brute Force über die ganze Ansicht und %3 ms je Bild, beides gemessen (Fehlerbudget %4).</translation>
    </message>
    <message>
        <source>%1: %2/255 from brute force over the whole view and %3 ms a frame, both measured (time budget %4).</source>
        <translation>%1: %2/255 Abweichung von Brute Force über die ganze Ansicht und %3 ms je Bild, beides gemessen (Zeitbudget %4).</translation>
    </message>
    <message>
        <source>No plan tried fits the time budget; this is the fastest.</source>
        <translation>Kein versuchter Plan passt ins Zeitbudget; dies ist der schnellste.</translation>
    </message>
    <message>
        <source>In other views than this it fails on this scene (%1). %2</source>
        <translation>In anderen Ansichten versagt er an dieser Szene (%1). %2</translation>
    </message>
    <message>
        <source>it fails on this scene (%1). %2</source>
        <translation>versagt an dieser Szene (%1). %2</translation>
    </message>
    <message>
        <source>about %1 ms a frame by this device&apos;s costs, %2 about %3 ms; not measured.</source>
        <translation>etwa %1 ms je Bild nach den Kosten dieses Geräts, %2 etwa %3 ms; nicht gemessen.</translation>
    </message>
    <message>
        <source>step %1 with ert %2 is %3/255 off already; not measured.</source>
        <translation>Schrittweite %1 mit ert %2 weicht schon um %3/255 ab; nicht gemessen.</translation>
    </message>
    <message>
        <source>Not measured yet.</source>
        <translation>Noch nicht gemessen.</translation>
    </message>
    <message>
        <source>Not measured: the time set for this run was over.</source>
        <translation>Nicht gemessen: Die Zeit für diesen Lauf war um.</translation>
    </message>
    <message>
        <source>the mode &apos;%1&apos;</source>
        <translation>den Modus „%1“</translation>
    </message>
    <message>
        <source>a scene with cuts</source>
        <translation>eine Szene mit Schnitten</translation>
    </message>
    <message>
        <source>a scene with segmentation ranges</source>
        <translation>eine Szene mit Segmentierungsbereichen</translation>
    </message>
    <message>
        <source>a scene with effects</source>
        <translation>eine Szene mit Effekten</translation>
    </message>
    <message>
        <source>a scene by regions</source>
        <translation>eine Szene nach Regionen</translation>
    </message>
    <message>
        <source>shaded emission-absorption of solid parts (take --shading none)</source>
        <translation>schattierte Emission-Absorption fester Teile (bitte ohne Schattierung)</translation>
    </message>
    <message>
        <source>The reference renderer, used where no OpenCL device works,</source>
        <translation>Der Referenz-Renderer, der ohne brauchbares OpenCL-Gerät arbeitet,</translation>
    </message>
    <message>
        <source>The effect &apos;ao&apos;</source>
        <translation>Der Effekt „ao“</translation>
    </message>
    <message>
        <source>its driver says it is not available</source>
        <translation>laut Treiber nicht verfügbar</translation>
    </message>
    <message>
        <source>its driver has no compiler</source>
        <translation>der Treiber hat keinen Compiler</translation>
    </message>
    <message>
        <source>the compiler gave no reason</source>
        <translation>der Compiler nannte keinen Grund</translation>
    </message>
    <message>
        <source>sampling a ramp gave %1 in place of %2</source>
        <translation>das Abtasten einer Rampe ergab %1 statt %2</translation>
    </message>
    <message>
        <source>a sum gave %1 in place of %2</source>
        <translation>eine Summe ergab %1 statt %2</translation>
    </message>
    <message>
        <source>copying %1 bytes to the device</source>
        <translation>Kopieren von %1 Byte zum Gerät</translation>
    </message>
    <message>
        <source>allocating %1 bytes on the device</source>
        <translation>Belegen von %1 Byte auf dem Gerät</translation>
    </message>
    <message>
        <source>reading a result from the device</source>
        <translation>Lesen eines Ergebnisses vom Gerät</translation>
    </message>
    <message>
        <source>running its self-test</source>
        <translation>Selbsttest</translation>
    </message>
    <message>
        <source>timing the ranking kernel</source>
        <translation>Messen des Rangkernels</translation>
    </message>
    <message>
        <source>making kernel %1 of %2</source>
        <translation>Erzeugen des Kernels %1 von %2</translation>
    </message>
    <message>
        <source>radius in mm</source>
        <translation>Radius in mm</translation>
    </message>
    <message>
        <source>number of samples</source>
        <translation>Zahl der Abtastpunkte</translation>
    </message>
    <message>
        <source>distance in mm</source>
        <translation>Abstand in mm</translation>
    </message>
    <message>
        <source>rendering</source>
        <translation>Zeichnen</translation>
    </message>
    <message>
        <source>opening %1</source>
        <translation>Öffnen von %1</translation>
    </message>
    <message>
        <source>a word</source>
        <translation>ein Wort</translation>
    </message>
    <message>
        <source>There is no volume to inspect.</source>
        <translation>Es gibt kein Volumen zu prüfen.</translation>
    </message>
    <message>
        <source>min_voxels must be 1 or more.</source>
        <translation>Die kleinste Größe muss mindestens 1 Voxel sein.</translation>
    </message>
    <message>
        <source>The void threshold must be a finite number.</source>
        <translation>Die Schwelle für Hohlräume muss eine endliche Zahl sein.</translation>
    </message>
    <message>
        <source>The inclusion threshold must be a finite number.</source>
        <translation>Die Schwelle für Einschlüsse muss eine endliche Zahl sein.</translation>
    </message>
    <message>
        <source>A fixed threshold needs its value: give the material&apos;s range or the void threshold.</source>
        <translation>Eine feste Schwelle braucht ihren Wert: bitte den Bereich des Materials oder die Schwelle für Hohlräume angeben.</translation>
    </message>
    <message>
        <source>No value lies in the material&apos;s range. Nothing can be inspected.</source>
        <translation>Im Bereich des Materials liegt kein Wert. Es lässt sich nichts prüfen.</translation>
    </message>
    <message>
        <source>The values form one population: there is no material that stands out from air. Nothing can be inspected.</source>
        <translation>Die Werte bilden eine einzige Gruppe: Kein Material hebt sich von der Luft ab. Es lässt sich nichts prüfen.</translation>
    </message>
    <message>
        <source>The volume holds no finite value. Nothing can be inspected.</source>
        <translation>Das Volumen enthält keinen endlichen Wert. Es lässt sich nichts prüfen.</translation>
    </message>
    <message>
        <source>All values of the volume are the same. Nothing can be inspected.</source>
        <translation>Alle Werte des Volumens sind gleich. Es lässt sich nichts prüfen.</translation>
    </message>
    <message>
        <source>The number of voids or the porosity changes with every threshold: the curve has no plateau, and no threshold is better founded than its neighbours.</source>
        <translation>Die Zahl der Hohlräume oder die Porosität ändert sich mit jeder Schwelle: Die Kurve hat kein Plateau, und keine Schwelle ist besser begründet als ihre Nachbarn.</translation>
    </message>
    <message>
        <source>No clear edge was found to measure the blur by; 0.7 voxels are taken.</source>
        <translation>Zum Messen der Unschärfe fand sich keine klare Kante; angenommen sind 0,7 Voxel.</translation>
    </message>
    <message>
        <source>%1 voxels hold no finite value; they count as empty.</source>
        <translation>%1 Voxel enthalten keinen endlichen Wert; sie zählen als leer.</translation>
    </message>
    <message>
        <source>No material lies inside the outline of a part.</source>
        <translation>Innerhalb des Umrisses eines Teils liegt kein Material.</translation>
    </message>
    <message>
        <source>There is no defect of that number in this analysis of the volume.</source>
        <translation>Eine Fehlstelle dieser Nummer gibt es in dieser Auswertung des Volumens nicht.</translation>
    </message>
    <message>
        <source>There is no defect %1; the part has %2.</source>
        <translation>Eine Fehlstelle %1 gibt es nicht; das Teil hat %2.</translation>
    </message>
    <message>
        <source>The decision on defect %1 needs a reason.</source>
        <translation>Die Entscheidung über Fehlstelle %1 braucht eine Begründung.</translation>
    </message>
    <message>
        <source>Judging needs one mask a zone.</source>
        <translation>Zum Urteilen braucht jede Zone ihre Maske.</translation>
    </message>
    <message>
        <source>There is no defect.</source>
        <translation>Es gibt keine Fehlstelle.</translation>
    </message>
    <message>
        <source>The zone holds nothing of the part.</source>
        <translation>Die Zone enthält nichts vom Teil.</translation>
    </message>
    <message>
        <source>The zone reaches out of the volume; a piece of it was not seen.</source>
        <translation>Die Zone ragt aus dem Volumen; ein Stück davon wurde nicht gesehen.</translation>
    </message>
    <message>
        <source>within all limits</source>
        <translation>innerhalb aller Grenzen</translation>
    </message>
    <message>
        <source>accepted by hand: %1</source>
        <translation>von Hand angenommen: %1</translation>
    </message>
    <message>
        <source>rejected by hand: %1</source>
        <translation>von Hand abgelehnt: %1</translation>
    </message>
    <message>
        <source>defect %1: it cannot be measured.</source>
        <translation>Fehlstelle %1: Sie ist nicht messbar.</translation>
    </message>
    <message>
        <source>it cannot be measured.</source>
        <translation>Es ist nicht messbar.</translation>
    </message>
    <message>
        <source>defect %1: %2 keeps %3, the most allowed.</source>
        <translation>Fehlstelle %1: %2 hält die Grenze ein, höchstens %3.</translation>
    </message>
    <message>
        <source>defect %1: %2 keeps %3, the least allowed.</source>
        <translation>Fehlstelle %1: %2 hält die Grenze ein, mindestens %3.</translation>
    </message>
    <message>
        <source>defect %1: %2 breaks %3, the most allowed.</source>
        <translation>Fehlstelle %1: %2 verletzt die Grenze, höchstens %3.</translation>
    </message>
    <message>
        <source>defect %1: %2 breaks %3, the least allowed.</source>
        <translation>Fehlstelle %1: %2 verletzt die Grenze, mindestens %3.</translation>
    </message>
    <message>
        <source>defect %1: %2 lies on both sides of %3, the most allowed.</source>
        <translation>Fehlstelle %1: %2 liegt zu beiden Seiten der Grenze, höchstens %3.</translation>
    </message>
    <message>
        <source>defect %1: %2 lies on both sides of %3, the least allowed.</source>
        <translation>Fehlstelle %1: %2 liegt zu beiden Seiten der Grenze, mindestens %3.</translation>
    </message>
    <message>
        <source>%1 keeps %2, the most allowed.</source>
        <translation>%1 hält die Grenze ein, höchstens %2.</translation>
    </message>
    <message>
        <source>%1 keeps %2, the least allowed.</source>
        <translation>%1 hält die Grenze ein, mindestens %2.</translation>
    </message>
    <message>
        <source>%1 breaks %2, the most allowed.</source>
        <translation>%1 verletzt die Grenze, höchstens %2.</translation>
    </message>
    <message>
        <source>%1 breaks %2, the least allowed.</source>
        <translation>%1 verletzt die Grenze, mindestens %2.</translation>
    </message>
    <message>
        <source>%1 lies on both sides of %2, the most allowed.</source>
        <translation>%1 liegt zu beiden Seiten der Grenze, höchstens %2.</translation>
    </message>
    <message>
        <source>%1 lies on both sides of %2, the least allowed.</source>
        <translation>%1 liegt zu beiden Seiten der Grenze, mindestens %2.</translation>
    </message>
    <message>
        <source>Criteria %1: %2 %9.</source>
        <translation>Kriterien %1: %2 %9.</translation>
    </message>
    <message>
        <source>Zone %1 %9.</source>
        <translation>Zone %1 %9.</translation>
    </message>
    <message>
        <source>There was not enough memory.</source>
        <translation>Der Speicher reichte nicht.</translation>
    </message>
    <message>
        <source>Inspecting it takes %1 MB and the limit is %2 MB.</source>
        <translation>Die Prüfung braucht %1 MB, die Grenze ist %2 MB.</translation>
    </message>
    <message>
        <source>A series runs 1 to 1024 parts at once.</source>
        <translation>Eine Serie prüft 1 bis 1024 Teile zugleich.</translation>
    </message>
    <message>
        <source>A shard is I/N with 1 &lt;= I &lt;= N.</source>
        <translation>Ein Anteil ist I/N mit 1 &lt;= I &lt;= N.</translation>
    </message>
    <message>
        <source>The folder %1 is being filled by another run of this series; wait for it to end, or stop it.</source>
        <translation>Den Ordner %1 füllt gerade ein anderer Lauf dieser Serie; bitte sein Ende abwarten oder ihn anhalten.</translation>
    </message>
    <message>
        <source>%1 of %2 parts in %3 are not done (%4); run their shards again.</source>
        <translation>%1 von %2 Teilen in %3 sind nicht fertig (%4); bitte ihre Anteile noch einmal rechnen.</translation>
    </message>
    <message>
        <source>The folder %1 holds no series; name the --report folder of its shards.</source>
        <translation>Der Ordner %1 enthält keine Serie; bitte den Berichtsordner ihrer Anteile nennen.</translation>
    </message>
    <message>
        <source>The file %1 is damaged; start the series anew.</source>
        <translation>Die Datei %1 ist beschädigt; bitte die Serie neu beginnen.</translation>
    </message>
    <message>
        <source>The file %1 is no list of inputs, one a line; name the folder it lies in, or a list that names it.</source>
        <translation>Die Datei %1 ist keine Liste von Eingaben, eine je Zeile; bitte ihren Ordner nennen oder eine Liste, die sie nennt.</translation>
    </message>
    <message>
        <source>There is no volume to find regions in; load one first.</source>
        <translation>Es gibt kein Volumen, um Regionen zu finden; bitte zuerst eines laden.</translation>
    </message>
    <message>
        <source>Regions need either a range width or a threshold: give exactly one of them.</source>
        <translation>Regionen brauchen entweder eine Bereichsbreite oder eine Schwelle: bitte genau eines davon angeben.</translation>
    </message>
    <message>
        <source>The range width is a share of the volume&apos;s value range: give a number from 0 to 1.</source>
        <translation>Die Bereichsbreite ist ein Anteil am Wertebereich des Volumens: bitte eine Zahl von 0 bis 1 angeben.</translation>
    </message>
    <message>
        <source>The background&apos;s lower value must not exceed its upper one.</source>
        <translation>Der untere Wert des Hintergrunds darf nicht über dem oberen liegen.</translation>
    </message>
    <message>
        <source>The smallest region has 1 voxel: give at least 1.</source>
        <translation>Die kleinste Region hat 1 Voxel: bitte mindestens 1 angeben.</translation>
    </message>
    <message>
        <source>The gradient limit is a number from 0 up, in the volume&apos;s unit per mm.</source>
        <translation>Die Gradientengrenze ist eine Zahl ab 0, in der Einheit des Volumens je mm.</translation>
    </message>
    <message>
        <source>The connectivity is 6, 18 or 26.</source>
        <translation>Die Nachbarschaft ist 6, 18 oder 26.</translation>
    </message>
    <message>
        <source>Homogeneous regions need a range width, not a threshold.</source>
        <translation>Homogene Regionen brauchen eine Bereichsbreite, keine Schwelle.</translation>
    </message>
    <message>
        <source>The labels do not lie on the volume&apos;s grid; make them from this volume.</source>
        <translation>Die Markierungen liegen nicht auf dem Gitter des Volumens; bitte aus diesem Volumen erstellen.</translation>
    </message>
    <message>
        <source>The region&apos;s box lies outside the labels; measure these labels first.</source>
        <translation>Der Quader der Region liegt außerhalb der Markierungen; bitte diese zuerst vermessen.</translation>
    </message>
    <message>
        <source>Crofton&apos;s formula, 13 directions, weighted for the voxel spacing</source>
        <translation>Crofton-Formel, 13 Richtungen, gewichtet nach dem Voxelabstand</translation>
    </message>
    <message>
        <source>regions %1-connected, cavities %2-connected</source>
        <translation>Regionen mit %1er-Nachbarschaft, Höhlungen mit %2er-Nachbarschaft</translation>
    </message>
    <message>
        <source>There is no colour map &apos;%1&apos;; known are %2.</source>
        <translation>Eine Farbtafel „%1“ gibt es nicht; bekannt sind %2.</translation>
    </message>
    <message>
        <source>There is no transfer-function preset &quot;%1&quot;; the presets are %2.</source>
        <translation>Eine Vorgabe „%1“ für die Transferfunktion gibt es nicht; es gibt %2.</translation>
    </message>
    <message>
        <source>The transfer function &quot;%1&quot; is not usable: %9.</source>
        <translation>Die Transferfunktion „%1“ ist nicht brauchbar: %9.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; %9.</source>
        <translation>„%1“ %9.</translation>
    </message>
    <message>
        <source>the document %9.</source>
        <translation>das Dokument %9.</translation>
    </message>
    <message>
        <source>This volume does not lie in memory, where its values could be counted again; crop it, or raise the memory limit.</source>
        <translation>Dieses Volumen liegt nicht im Speicher, wo seine Werte neu gezählt werden könnten; bitte zuschneiden oder die Speichergrenze heraufsetzen.</translation>
    </message>
    <message>
        <source>The presets cannot be read from %1: %9.</source>
        <translation>Die Vorgaben können nicht aus %1 gelesen werden: %9.</translation>
    </message>
    <message>
        <source>The folder for presets cannot be made: %1: %9.</source>
        <translation>Der Ordner für Vorgaben kann nicht angelegt werden: %1: %9.</translation>
    </message>
    <message>
        <source>The preset cannot be removed: %1: %9.</source>
        <translation>Die Vorgabe kann nicht entfernt werden: %1: %9.</translation>
    </message>
    <message>
        <source>its step must lie between 0.01 and 100.</source>
        <translation>Ihre Schrittweite muss zwischen 0,01 und 100 liegen.</translation>
    </message>
    <message>
        <source>%1 has to be %9.</source>
        <translation>%1 muss %9 sein.</translation>
    </message>
    <message>
        <source>exactly one of range_width and threshold has to be given.</source>
        <translation>Genau eines von range_width und threshold muss angegeben sein.</translation>
    </message>
    <message>
        <source>range_width has to lie between 0 and 1.</source>
        <translation>range_width muss zwischen 0 und 1 liegen.</translation>
    </message>
    <message>
        <source>connectivity has to be 6, 18 or 26.</source>
        <translation>connectivity muss 6, 18 oder 26 sein.</translation>
    </message>
    <message>
        <source>min_voxels has to be 1 or more.</source>
        <translation>min_voxels muss mindestens 1 sein.</translation>
    </message>
    <message>
        <source>there are more than %1 ranges.</source>
        <translation>Es gibt mehr als %1 Bereiche.</translation>
    </message>
    <message>
        <source>there are more than %1 cutting planes.</source>
        <translation>Es gibt mehr als %1 Schnittebenen.</translation>
    </message>
    <message>
        <source>the ends of the box have to ascend within 0 to 1.</source>
        <translation>Die Enden des Quaders müssen innerhalb von 0 bis 1 aufsteigen.</translation>
    </message>
    <message>
        <source>quality.step has to lie between 0.01 and 100.</source>
        <translation>quality.step muss zwischen 0,01 und 100 liegen.</translation>
    </message>
    <message>
        <source>a grey level is no number.</source>
        <translation>Eine Graustufe ist keine Zahl.</translation>
    </message>
    <message>
        <source>a cutting plane has no direction.</source>
        <translation>Eine Schnittebene hat keine Richtung.</translation>
    </message>
    <message>
        <source>slices.tilt is no unit quaternion.</source>
        <translation>slices.tilt ist kein Einheitsquaternion.</translation>
    </message>
    <message>
        <source>slices.slab.thickness_mm has to be 0 or more.</source>
        <translation>slices.slab.thickness_mm muss mindestens 0 sein.</translation>
    </message>
    <message>
        <source>slices.table has to be 0 or more.</source>
        <translation>slices.table muss mindestens 0 sein.</translation>
    </message>
    <message>
        <source>slices.overlay_opacity has to be from 0 to 1.</source>
        <translation>slices.overlay_opacity muss von 0 bis 1 sein.</translation>
    </message>
    <message>
        <source>it has not as many points as its kind needs.</source>
        <translation>Sie hat nicht so viele Punkte, wie ihre Art braucht.</translation>
    </message>
    <message>
        <source>a point is no position.</source>
        <translation>Ein Punkt ist keine Lage.</translation>
    </message>
    <message>
        <source>its axes are no unit vectors at right angles.</source>
        <translation>Ihre Achsen sind keine senkrechten Einheitsvektoren.</translation>
    </message>
    <message>
        <source>The ends of a logarithmic axis must lie above 0.</source>
        <translation>Die Enden einer logarithmischen Achse müssen über 0 liegen.</translation>
    </message>
    <message>
        <source>The low end of an axis must lie below its high end.</source>
        <translation>Das untere Ende einer Achse muss unter dem oberen liegen.</translation>
    </message>
    <message>
        <source>The drawing failed: %1.</source>
        <translation>Die Zeichnung ist gescheitert: %1.</translation>
    </message>
    <message>
        <source>A drawing must be wider and higher than 0 and at most 16384 pixels a side.</source>
        <translation>Eine Zeichnung muss breiter und höher als 0 sein und darf höchstens 16384 Bildpunkte je Seite haben.</translation>
    </message>
    <message>
        <source>A picture needs more than 0 pixels a point.</source>
        <translation>Ein Bild braucht mehr als 0 Bildpunkte je Punkt.</translation>
    </message>
    <message>
        <source>Only a PDF has more than one page.</source>
        <translation>Nur ein PDF hat mehr als eine Seite.</translation>
    </message>
    <message>
        <source>The drawing was finished before.</source>
        <translation>Die Zeichnung war schon abgeschlossen.</translation>
    </message>
    <message>
        <source>Bars need one edge more than they have heights.</source>
        <translation>Balken brauchen eine Kante mehr, als sie Höhen haben.</translation>
    </message>
    <message>
        <source>The edges of bars must ascend.</source>
        <translation>Die Kanten von Balken müssen aufsteigen.</translation>
    </message>
    <message>
        <source>The chart&apos;s box is too small for its labels.</source>
        <translation>Das Feld des Diagramms ist zu klein für seine Beschriftung.</translation>
    </message>
    <message>
        <source>A sheet needs at least one chart and one column.</source>
        <translation>Ein Blatt braucht mindestens ein Diagramm und eine Spalte.</translation>
    </message>
    <message>
        <source>A chart is written as .svg, .png or .pdf, not as &apos;%1&apos;.</source>
        <translation>Ein Diagramm wird als .svg, .png oder .pdf geschrieben, nicht als „%1“.</translation>
    </message>
    <message>
        <source>is given twice; keep one</source>
        <translation>ist zweimal angegeben; bitte einmal streichen</translation>
    </message>
    <message>
        <source>is not a JSON object; see docs/schemas/criteria.schema.json</source>
        <translation>ist kein JSON-Objekt; siehe docs/schemas/criteria.schema.json</translation>
    </message>
    <message>
        <source>is a number too large to be one; limits are finite</source>
        <translation>ist eine zu große Zahl; Grenzen sind endlich</translation>
    </message>
    <message>
        <source>or what follows it is no JSON (line %1); numbers are finite, names quoted</source>
        <translation>oder was darauf folgt, ist kein JSON (Zeile %1); Zahlen sind endlich, Namen stehen in Anführungszeichen</translation>
    </message>
    <message>
        <source>must be an object { ... }</source>
        <translation>muss ein Objekt { ... } sein</translation>
    </message>
    <message>
        <source>lacks its unit: write %1</source>
        <translation>fehlt die Einheit: bitte %1 schreiben</translation>
    </message>
    <message>
        <source>is no known key; known here are %1</source>
        <translation>ist kein bekannter Schlüssel; bekannt sind hier %1</translation>
    </message>
    <message>
        <source>must be a number, without quotes; its unit is part of the key</source>
        <translation>muss eine Zahl ohne Anführungszeichen sein; die Einheit gehört zum Schlüssel</translation>
    </message>
    <message>
        <source>must be a finite number</source>
        <translation>muss eine endliche Zahl sein</translation>
    </message>
    <message>
        <source>must be a whole number from %1 to %2</source>
        <translation>muss eine ganze Zahl von %1 bis %2 sein</translation>
    </message>
    <message>
        <source>is a text that is not &quot;auto&quot;</source>
        <translation>ist ein anderer Text als &quot;auto&quot;</translation>
    </message>
    <message>
        <source>must be [lo, hi] or &quot;auto&quot;</source>
        <translation>muss [lo, hi] oder &quot;auto&quot; sein</translation>
    </message>
    <message>
        <source>has lo &gt;= hi; the smaller value comes first</source>
        <translation>hat lo &gt;= hi; der kleinere Wert kommt zuerst</translation>
    </message>
    <message>
        <source>must be {&quot;%1&quot;: value} or &quot;auto&quot;</source>
        <translation>muss {&quot;%1&quot;: Wert} oder &quot;auto&quot; sein</translation>
    </message>
    <message>
        <source>names no kind of defect; give void, inclusion or both</source>
        <translation>nennt keine Art von Fehlstelle; bitte void, inclusion oder beide angeben</translation>
    </message>
    <message>
        <source>must be &quot;local&quot;, &quot;otsu&quot; or &quot;fixed&quot;</source>
        <translation>muss &quot;local&quot;, &quot;otsu&quot; oder &quot;fixed&quot; sein</translation>
    </message>
    <message>
        <source>is &quot;fixed&quot;, but neither material nor defects.void.below gives a value</source>
        <translation>ist &quot;fixed&quot;, aber weder material noch defects.void.below nennt einen Wert</translation>
    </message>
    <message>
        <source>must be 6, 18 or 26</source>
        <translation>muss 6, 18 oder 26 sein</translation>
    </message>
    <message>
        <source>lies above the material&apos;s values: all of the part would be void</source>
        <translation>liegt über den Werten des Materials: Das ganze Teil wäre Hohlraum</translation>
    </message>
    <message>
        <source>lies below the material&apos;s values: all of the part would be inclusion</source>
        <translation>liegt unter den Werten des Materials: Das ganze Teil wäre Einschluss</translation>
    </message>
    <message>
        <source>is not below defects.inclusion.above (lo &gt; hi): a value would be both</source>
        <translation>liegt nicht unter defects.inclusion.above (lo &gt; hi): Ein Wert wäre beides</translation>
    </message>
    <message>
        <source>is negative; a limit is 0 or more</source>
        <translation>ist negativ; eine Grenze ist mindestens 0</translation>
    </message>
    <message>
        <source>is above 100 percent</source>
        <translation>liegt über 100 Prozent</translation>
    </message>
    <message>
        <source>must be a whole number</source>
        <translation>muss eine ganze Zahl sein</translation>
    </message>
    <message>
        <source>is more than can be counted</source>
        <translation>ist mehr, als gezählt werden kann</translation>
    </message>
    <message>
        <source>must be [[x, y, z], [x, y, z]]: the smallest corner, then the largest, in mm</source>
        <translation>muss [[x, y, z], [x, y, z]] sein: die kleinste Ecke, dann die größte, in mm</translation>
    </message>
    <message>
        <source>has lo &gt;= hi along %1; the smallest corner comes first</source>
        <translation>hat längs %1 lo &gt;= hi; die kleinste Ecke kommt zuerst</translation>
    </message>
    <message>
        <source>must be a list [ ... ]</source>
        <translation>muss eine Liste [ ... ] sein</translation>
    </message>
    <message>
        <source>is missing; a zone needs a name</source>
        <translation>fehlt; eine Zone braucht einen Namen</translation>
    </message>
    <message>
        <source>is used twice: %1</source>
        <translation>ist zweimal vergeben: %1</translation>
    </message>
    <message>
        <source>must have either box_mm or labels</source>
        <translation>muss entweder box_mm oder labels haben</translation>
    </message>
    <message>
        <source>must be the name of a label volume file</source>
        <translation>muss der Name einer Datei mit Markierungen sein</translation>
    </message>
    <message>
        <source>goes with labels, not with box_mm</source>
        <translation>gehört zu labels, nicht zu box_mm</translation>
    </message>
    <message>
        <source>is missing; a zone without limits says nothing</source>
        <translation>fehlt; eine Zone ohne Grenzen besagt nichts</translation>
    </message>
    <message>
        <source>lies outside the volume, or between its voxels; the volume reaches from %1 to %2 mm</source>
        <translation>liegt außerhalb des Volumens oder zwischen seinen Voxeln; das Volumen reicht von %1 bis %2 mm</translation>
    </message>
    <message>
        <source>has %1 voxels, the part %2; it must lie on the part&apos;s grid</source>
        <translation>hat %1 Voxel, das Teil %2; sie muss auf dem Gitter des Teils liegen</translation>
    </message>
    <message>
        <source>lies elsewhere than the part (origin, spacing or axes differ); it must lie on the part&apos;s grid</source>
        <translation>liegt anderswo als das Teil (Ursprung, Abstand oder Achsen weichen ab); sie muss auf dem Gitter des Teils liegen</translation>
    </message>
    <message>
        <source>holds no voxel of label %1</source>
        <translation>enthält kein Voxel der Markierung %1</translation>
    </message>
    <message>
        <source>holds no voxel above 0</source>
        <translation>enthält kein Voxel über 0</translation>
    </message>
    <message>
        <source>%1.magnitude must be two numbers of 0 or more, the first below the second</source>
        <translation>%1.magnitude muss aus zwei Zahlen ab 0 bestehen, die erste unter der zweiten</translation>
    </message>
    <message>
        <source>%1.values_at_lo must be two numbers, the first not above the second</source>
        <translation>%1.values_at_lo muss aus zwei Zahlen bestehen, die erste nicht über der zweiten</translation>
    </message>
    <message>
        <source>%1.values_at_hi must be two numbers, the first not above the second</source>
        <translation>%1.values_at_hi muss aus zwei Zahlen bestehen, die erste nicht über der zweiten</translation>
    </message>
    <message>
        <source>%1.opacity lies outside 0..1</source>
        <translation>%1.opacity liegt außerhalb von 0..1</translation>
    </message>
    <message>
        <source>%1.softness lies outside 0..1</source>
        <translation>%1.softness liegt außerhalb von 0..1</translation>
    </message>
    <message>
        <source>%1.color lies outside 0..1</source>
        <translation>%1.color liegt außerhalb von 0..1</translation>
    </message>
    <message>
        <source>unit_distance_mm must be a positive number</source>
        <translation>unit_distance_mm muss eine positive Zahl sein</translation>
    </message>
    <message>
        <source>points must hold at least one point</source>
        <translation>points muss mindestens einen Punkt enthalten</translation>
    </message>
    <message>
        <source>%1.value is not a finite number</source>
        <translation>%1.value ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>%1.value lies below the point before it</source>
        <translation>%1.value liegt unter dem Punkt davor</translation>
    </message>
    <message>
        <source>%1.value is the third at one value (two make a jump)</source>
        <translation>%1.value ist der dritte bei einem Wert (zwei ergeben einen Sprung)</translation>
    </message>
    <message>
        <source>%1.magnitude is not a number of 0 or more</source>
        <translation>%1.magnitude ist keine Zahl ab 0</translation>
    </message>
    <message>
        <source>%1.magnitude lies below the one before it</source>
        <translation>%1.magnitude liegt unter dem Wert davor</translation>
    </message>
    <message>
        <source>shapes holds more than %1</source>
        <translation>shapes enthält mehr als %1</translation>
    </message>
    <message>
        <source>must be a JSON object</source>
        <translation>muss ein JSON-Objekt sein</translation>
    </message>
    <message>
        <source>is an unknown key; known here: %1</source>
        <translation>ist ein unbekannter Schlüssel; bekannt sind hier %1</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>must be a number</source>
        <translation>muss eine Zahl sein</translation>
    </message>
    <message>
        <source>must be a list</source>
        <translation>muss eine Liste sein</translation>
    </message>
    <message>
        <source>must hold three numbers (red, green, blue)</source>
        <translation>muss drei Zahlen enthalten (rot, grün, blau)</translation>
    </message>
    <message>
        <source>must hold two numbers</source>
        <translation>muss zwei Zahlen enthalten</translation>
    </message>
    <message>
        <source>must be a text</source>
        <translation>muss ein Text sein</translation>
    </message>
    <message>
        <source>must be above 0</source>
        <translation>muss über 0 liegen</translation>
    </message>
    <message>
        <source>must be a whole number of 1 or more</source>
        <translation>muss eine ganze Zahl ab 1 sein</translation>
    </message>
    <message>
        <source>is not valid JSON (%1)</source>
        <translation>ist kein gültiges JSON (%1)</translation>
    </message>
    <message>
        <source>must be true or false</source>
        <translation>muss true oder false sein</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>eine ganze Zahl</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>ein Objekt</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>eine Liste</translation>
    </message>
    <message>
        <source>a list of %1 numbers</source>
        <translation>eine Liste von %1 Zahlen</translation>
    </message>
    <message>
        <source>a list of %1</source>
        <translation>eine Liste von %1</translation>
    </message>
    <message>
        <source>slices %1 to %2 (counted from 0) between %3 and %4</source>
        <translation>Schichten %1 bis %2 (ab 0 gezählt) zwischen %3 und %4</translation>
    </message>
    <message>
        <source>slice %1 (counted from 0) between %2 and %3</source>
        <translation>Schicht %1 (ab 0 gezählt) zwischen %2 und %3</translation>
    </message>
    <message>
        <source>There is no OpenCL device &quot;%1&quot;; %9.</source>
        <translation>Ein OpenCL-Gerät „%1“ gibt es nicht; %9.</translation>
    </message>
    <message>
        <source>known are %1</source>
        <translation>bekannt sind %1</translation>
    </message>
    <message>
        <source>there is none here</source>
        <translation>hier gibt es keines</translation>
    </message>
    <message>
        <source>reference renderer (no OpenCL device)</source>
        <translation>Referenz-Renderer (kein OpenCL-Gerät)</translation>
    </message>
    <message>
        <source>error measure</source>
        <translation>Fehlermaß</translation>
    </message>
    <message>
        <source>integration</source>
        <translation>Integration</translation>
    </message>
    <message>
        <source>leaping kernel</source>
        <translation>Sprungkernel</translation>
    </message>
    <message>
        <source>measurement</source>
        <translation>Messung</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>refinement</source>
        <translation>Verfeinerung</translation>
    </message>
    <message>
        <source>sampler</source>
        <translation>Abtaster</translation>
    </message>
    <message>
        <source>shading</source>
        <translation>Schattierung</translation>
    </message>
    <message>
        <source>slab mode</source>
        <translation>Schichtmodus</translation>
    </message>
    <message>
        <source>structure</source>
        <translation>Struktur</translation>
    </message>
    <message>
        <source>threshold method</source>
        <translation>Schwellenverfahren</translation>
    </message>
    <message>
        <source>view mode</source>
        <translation>Ansichtsmodus</translation>
    </message>
    <message>
        <source>view of regions</source>
        <translation>Ansicht der Regionen</translation>
    </message>
    <message>
        <source>voxel gradient</source>
        <translation>Voxelgradient</translation>
    </message>
    <message>
        <source>way of leap values</source>
        <translation>Sprungwertverfahren</translation>
    </message>
    <message>
        <source>window function</source>
        <translation>Fensterfunktion</translation>
    </message>
    <message>
        <source>The raw description &apos;%1&apos; is wrong: %9; write %2.</source>
        <translation>Die Rohbeschreibung „%1“ ist falsch: %9; bitte so schreiben: %2.</translation>
    </message>
    <message>
        <source>WxHxD:TYPE[:SX,SY,SZ][:be][:+OFFSET], for example %1</source>
        <translation>WxHxD:TYPE[:SX,SY,SZ][:be][:+OFFSET], zum Beispiel %1</translation>
    </message>
    <message>
        <source>The preset &quot;%1&quot; cannot be shown: its step must lie between 0.01 and 100.</source>
        <translation>Die Vorgabe „%1“ kann nicht gezeigt werden: Ihre Schrittweite muss zwischen 0,01 und 100 liegen.</translation>
    </message>
    <message>
        <source>The field of view must lie from 0.01 to below 180 degrees; parallel rays need none.</source>
        <translation>Das Sichtfeld muss von 0,01 bis unter 180 Grad reichen; parallele Strahlen brauchen keines.</translation>
    </message>
    <message>
        <source>Regions, leaping kernels and leap above homogeneity 0 need the whole volume at hand, not bricks of it; leave one out, or raise the memory limit.</source>
        <translation>Regionen, Sprungkernel und leap mit Homogenität über 0 brauchen das ganze Volumen, nicht Blöcke davon; bitte eines weglassen oder die Speichergrenze heraufsetzen.</translation>
    </message>
    <message>
        <source>The homogeneity of pc, acd and eacd is a difference of opacities: it must lie within 0 to 1.</source>
        <translation>Die Homogenität von pc, acd und eacd ist ein Unterschied von Deckkräften: Sie muss in 0 bis 1 liegen.</translation>
    </message>
    <message>
        <source>Regions are those of the whole volume, and this one has too many voxels to be drawn whole: take another structure, or leap with homogeneity 0, and show all regions.</source>
        <translation>Regionen gelten für das ganze Volumen, und dieses hat zu viele Voxel, um ganz gezeichnet zu werden: bitte eine andere Struktur nehmen oder leap mit Homogenität 0, und alle Regionen zeigen.</translation>
    </message>
    <message>
        <source>Regions are those of the whole volume, and this one does not fit whole: raise --memory-limit, or take another structure, or leap with homogeneity 0, and show all regions.</source>
        <translation>Regionen gelten für das ganze Volumen, und dieses passt nicht ganz hinein: bitte die Speichergrenze heraufsetzen, eine andere Struktur nehmen oder leap mit Homogenität 0, und alle Regionen zeigen.</translation>
    </message>
    <message>
        <source>Bricks of %1 voxels: the volume has more than %2 of them, which is the most that are drawn in one piece.</source>
        <translation>Blöcke von %1 Voxeln: Das Volumen hat mehr als %2 davon, das Meiste, was in einem Stück gezeichnet wird.</translation>
    </message>
    <message>
        <source>%1 of %2 voxels at the surface lie in walls that are thinner than the step of %3 voxels; %4 % would be missed square on.</source>
        <translation>%1 von %2 Voxeln an der Oberfläche liegen in Wänden, die dünner als die Schrittweite von %3 Voxeln sind; bei senkrechtem Blick gingen %4 % verloren.</translation>
    </message>
    <message>
        <source>%1 of %2 places where values pass a peak of the transfer function make shells that are thinner than the step of %3 voxels; %4 % would be missed square on.</source>
        <translation>%1 von %2 Stellen, an denen Werte eine Spitze der Transferfunktion durchlaufen, bilden Schalen, die dünner als die Schrittweite von %3 Voxeln sind; bei senkrechtem Blick gingen %4 % verloren.</translation>
    </message>
    <message>
        <source>%1 of %2 voxels at visible borders lie in layers that are thinner than the step of %3 voxels; %4 % would be missed square on.</source>
        <translation>%1 von %2 Voxeln an sichtbaren Grenzen liegen in Schichten, die dünner als die Schrittweite von %3 Voxeln sind; bei senkrechtem Blick gingen %4 % verloren.</translation>
    </message>
    <message>
        <source>The transfer function has a peak %1 wide; an entry of the table covers %2.</source>
        <translation>Die Transferfunktion hat eine Spitze von %1 Breite; ein Eintrag der Tabelle umfasst %2.</translation>
    </message>
    <message>
        <source>Up to %1 of 255 grey levels may be hidden.</source>
        <translation>Bis zu %1 von 255 Graustufen können verborgen sein.</translation>
    </message>
    <message>
        <source>%1 voxels stand out from all their neighbours, by up to %2; up to %3 of 255 grey levels of that are lost at this step.</source>
        <translation>%1 Voxel heben sich von allen Nachbarn ab, um bis zu %2; davon gehen bei dieser Schrittweite bis zu %3 von 255 Graustufen verloren.</translation>
    </message>
    <message>
        <source>This view lies within a third of a degree of where the principal axis switches.</source>
        <translation>Diese Ansicht liegt auf ein Drittel Grad an der Stelle, wo die Hauptachse wechselt.</translation>
    </message>
    <message>
        <source>This view is slanted by %1 degrees to the slices.</source>
        <translation>Diese Ansicht ist um %1 Grad gegen die Schichten geneigt.</translation>
    </message>
    <message>
        <source>The transfer function has a peak %1 wide, the threshold is %2: nodes as flat as that may hold the whole peak.</source>
        <translation>Die Transferfunktion hat eine Spitze von %1 Breite, die Schwelle ist %2: So flache Knoten können die ganze Spitze enthalten.</translation>
    </message>
    <message>
        <source>The threshold of %1 lets regions differ visibly from what they stand for.</source>
        <translation>Die Schwelle von %1 lässt Regionen sichtbar von dem abweichen, wofür sie stehen.</translation>
    </message>
    <message>
        <source>Most of %1 voxels along an axis is empty, and a box reaches %2.</source>
        <translation>Der größte Teil von %1 Voxeln längs einer Achse ist leer, und ein Quader reicht %2 weit.</translation>
    </message>
    <message>
        <source>%1 % of the voxels are visible: there is little to skip.</source>
        <translation>%1 % der Voxel sind sichtbar: Es gibt wenig zu überspringen.</translation>
    </message>
    <message>
        <source>%1 % of the voxels equal their neighbour, and not all of these lie in regions.</source>
        <translation>%1 % der Voxel gleichen ihrem Nachbarn, und nicht alle davon liegen in Regionen.</translation>
    </message>
    <message>
        <source>Regions span up to %1 % of the values and are drawn as their mean.</source>
        <translation>Regionen umfassen bis zu %1 % der Werte und werden als ihr Mittel gezeichnet.</translation>
    </message>
    <message>
        <source>Only %1 % of the voxels equal their neighbour: regions of one value are few.</source>
        <translation>Nur %1 % der Voxel gleichen ihrem Nachbarn: Regionen eines einzigen Werts sind selten.</translation>
    </message>
    <message>
        <source>%1 voxels stand alone across two axes or three; a voxel is %2 pixels wide, and every %3. pixel is cast.</source>
        <translation>%1 Voxel stehen längs zweier oder dreier Achsen allein; ein Voxel ist %2 Bildpunkte breit, und jeder %3. Bildpunkt wird gerechnet.</translation>
    </message>
    <message>
        <source>%1 voxels are no numbers.</source>
        <translation>%1 Voxel sind keine Zahlen.</translation>
    </message>
    <message>
        <source>The eye is %1 voxels away.</source>
        <translation>Das Auge ist %1 Voxel entfernt.</translation>
    </message>
    <message>
        <source>All voxels are equal.</source>
        <translation>Alle Voxel sind gleich.</translation>
    </message>
    <message>
        <source>The volume is one voxel thick.</source>
        <translation>Das Volumen ist ein Voxel dick.</translation>
    </message>
    <message>
        <source>%1: %2/255 from brute force over the whole view and %3 ms a frame, both measured (error budget %4, time budget %5).</source>
        <translation>%1: %2/255 Abweichung von Brute Force über die ganze Ansicht und %3 ms je Bild, beides gemessen (Fehlerbudget %4, Zeitbudget %5).</translation>
    </message>
    <message>
        <source>The centre looked at must be finite numbers.</source>
        <translation>Die Mitte, auf die geblickt wird, muss aus endlichen Zahlen bestehen.</translation>
    </message>
</context>
<context>
    <name>Gestures</name>
    <message>
        <source>3D view</source>
        <translation>3D-Ansicht</translation>
    </message>
    <message>
        <source>Left drag</source>
        <translation>Links ziehen</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>Middle or Shift+left drag</source>
        <translation>Mitte oder Umschalt+links ziehen</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Right drag, wheel</source>
        <translation>Rechts ziehen, Rad</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Vergrößern, verkleinern</translation>
    </message>
    <message>
        <source>Double click, Enter</source>
        <translation>Doppelklick, Eingabe</translation>
    </message>
    <message>
        <source>This view alone, or all again</source>
        <translation>Diese Ansicht allein oder wieder alle</translation>
    </message>
    <message>
        <source>Arrow keys</source>
        <translation>Pfeiltasten</translation>
    </message>
    <message>
        <source>Shift+arrow keys</source>
        <translation>Umschalt+Pfeiltasten</translation>
    </message>
    <message>
        <source>+ and −</source>
        <translation>+ und −</translation>
    </message>
    <message>
        <source>Comma, full stop</source>
        <translation>Komma, Punkt</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Schichten</translation>
    </message>
    <message>
        <source>Set the cross-hair</source>
        <translation>Fadenkreuz setzen</translation>
    </message>
    <message>
        <source>Wheel, Page Up and Page Down</source>
        <translation>Rad, Bild auf und Bild ab</translation>
    </message>
    <message>
        <source>Turn the pages</source>
        <translation>Blättern</translation>
    </message>
    <message>
        <source>Right drag, Shift+arrow keys</source>
        <translation>Rechts ziehen, Umschalt+Pfeiltasten</translation>
    </message>
    <message>
        <source>Window and level</source>
        <translation>Fensterung</translation>
    </message>
    <message>
        <source>Middle drag</source>
        <translation>Mitte ziehen</translation>
    </message>
    <message>
        <source>Move the picture</source>
        <translation>Bild verschieben</translation>
    </message>
    <message>
        <source>Ctrl+wheel, + and −</source>
        <translation>Strg+Rad, + und −</translation>
    </message>
    <message>
        <source>Move the cross-hair</source>
        <translation>Fadenkreuz bewegen</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Pos1</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Alles zeigen</translation>
    </message>
    <message>
        <source>Transfer function</source>
        <translation>Transferfunktion</translation>
    </message>
    <message>
        <source>Left drag of a point</source>
        <translation>Punkt links ziehen</translation>
    </message>
    <message>
        <source>Move it</source>
        <translation>Ihn bewegen</translation>
    </message>
    <message>
        <source>Double click, Insert</source>
        <translation>Doppelklick, Einfg</translation>
    </message>
    <message>
        <source>Add a point</source>
        <translation>Punkt hinzufügen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Entf</translation>
    </message>
    <message>
        <source>Remove the point</source>
        <translation>Punkt entfernen</translation>
    </message>
    <message>
        <source>Right click, Enter</source>
        <translation>Rechtsklick, Eingabe</translation>
    </message>
    <message>
        <source>Choose its colour</source>
        <translation>Seine Farbe wählen</translation>
    </message>
    <message>
        <source>Move the point</source>
        <translation>Punkt bewegen</translation>
    </message>
    <message>
        <source>Page Up and Page Down</source>
        <translation>Bild auf und Bild ab</translation>
    </message>
    <message>
        <source>Choose another point</source>
        <translation>Anderen Punkt wählen</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Rad</translation>
    </message>
    <message>
        <source>Widen or narrow the values shown</source>
        <translation>Gezeigten Wertebereich weiten oder verengen</translation>
    </message>
    <message>
        <source>Range sliders</source>
        <translation>Bereichsregler</translation>
    </message>
    <message>
        <source>Drag of an end</source>
        <translation>Ein Ende ziehen</translation>
    </message>
    <message>
        <source>Drag between the ends</source>
        <translation>Zwischen den Enden ziehen</translation>
    </message>
    <message>
        <source>Move both</source>
        <translation>Beide bewegen</translation>
    </message>
    <message>
        <source>Tab, arrow keys</source>
        <translation>Tab, Pfeiltasten</translation>
    </message>
    <message>
        <source>Go to the other end, move it</source>
        <translation>Zum anderen Ende gehen, es bewegen</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>Überall</translation>
    </message>
    <message>
        <source>Drop a file or folder</source>
        <translation>Datei oder Ordner ablegen</translation>
    </message>
    <message>
        <source>Open it</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Tab, Shift+Tab</source>
        <translation>Tab, Umschalt+Tab</translation>
    </message>
    <message>
        <source>Next or previous control</source>
        <translation>Nächstes oder voriges Bedienelement</translation>
    </message>
    <message>
        <source>Ctrl+full stop</source>
        <translation>Strg+Punkt</translation>
    </message>
    <message>
        <source>Cancel what is running</source>
        <translation>Laufendes abbrechen</translation>
    </message>
    <message>
        <source>Escape</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Dismiss the message</source>
        <translation>Meldung schließen</translation>
    </message>
    <message>
        <source>Drag of a cross-hair&apos;s handle, Shift+left drag, Ctrl+Left and Right</source>
        <translation>Griff des Fadenkreuzes ziehen, Umschalt+links ziehen, Strg+Links und Rechts</translation>
    </message>
    <message>
        <source>Tilt the two other planes</source>
        <translation>Die zwei anderen Ebenen kippen</translation>
    </message>
    <message>
        <source>Left drag or clicks while measuring, Space</source>
        <translation>Beim Messen links ziehen oder klicken, Leertaste</translation>
    </message>
    <message>
        <source>Set the points of a measurement</source>
        <translation>Punkte einer Messung setzen</translation>
    </message>
    <message>
        <source>Left drag of a measurement</source>
        <translation>Eine Messung links ziehen</translation>
    </message>
    <message>
        <source>Move it or one of its points</source>
        <translation>Sie oder einen ihrer Punkte bewegen</translation>
    </message>
    <message>
        <source>Remove the measurement</source>
        <translation>Messung entfernen</translation>
    </message>
    <message>
        <source>End measuring</source>
        <translation>Messen beenden</translation>
    </message>
    <message>
        <source>Right click</source>
        <translation>Rechtsklick</translation>
    </message>
    <message>
        <source>Ctrl+right drag</source>
        <translation>Strg+rechts ziehen</translation>
    </message>
    <message>
        <source>Drag of a box, Ctrl+A</source>
        <translation>Kasten ziehen, Strg+A</translation>
    </message>
    <message>
        <source>Choose several points</source>
        <translation>Mehrere Punkte wählen</translation>
    </message>
    <message>
        <source>Shift and widen the transfer function, the isovalue or the grey window</source>
        <translation>Transferfunktion, Isowert oder Graufenster verschieben und weiten</translation>
    </message>
    <message>
        <source>Click, Space</source>
        <translation>Klick, Leertaste</translation>
    </message>
    <message>
        <source>Read out and mark a point</source>
        <translation>Einen Punkt ablesen und markieren</translation>
    </message>
    <message>
        <source>Shift+click, Shift and moving, Shift+Space</source>
        <translation>Umschalt+Klick, Umschalt und Bewegen, Umschalt+Leertaste</translation>
    </message>
    <message>
        <source>Slices through a point</source>
        <translation>Schichten durch einen Punkt</translation>
    </message>
    <message>
        <source>What can be done at a point</source>
        <translation>Was an einem Punkt getan werden kann</translation>
    </message>
    <message>
        <source>Drag of a cut&apos;s arrow or outline</source>
        <translation>Pfeil oder Umriss eines Schnitts ziehen</translation>
    </message>
    <message>
        <source>Move the cut</source>
        <translation>Schnitt verschieben</translation>
    </message>
    <message>
        <source>Drag of a cut&apos;s round handle, with Ctrl to axes</source>
        <translation>Runden Griff eines Schnitts ziehen, mit Strg zu Achsen</translation>
    </message>
    <message>
        <source>Tilt the cut</source>
        <translation>Schnitt kippen</translation>
    </message>
    <message>
        <source>Drag of a box&apos;s square handle</source>
        <translation>Eckigen Griff eines Kastens ziehen</translation>
    </message>
    <message>
        <source>Move a side of the box, or all of it</source>
        <translation>Eine Seite des Kastens oder ihn ganz verschieben</translation>
    </message>
    <message>
        <source>All views</source>
        <translation>Alle Ansichten</translation>
    </message>
    <message>
        <source>Side buttons of the mouse</source>
        <translation>Seitentasten der Maus</translation>
    </message>
    <message>
        <source>Previous or next view</source>
        <translation>Vorige oder nächste Ansicht</translation>
    </message>
</context>
<context>
    <name>Limits</name>
    <message>
        <source>Walls between two samples</source>
        <translation>Wände zwischen zwei Abtastpunkten</translation>
    </message>
    <message>
        <source>A wall thinner than the step can lie between two samples that are both outside: the ray goes through it.</source>
        <translation>Eine Wand, dünner als die Schrittweite, kann zwischen zwei Abtastpunkten liegen, die beide außerhalb sind: Der Strahl geht hindurch.</translation>
    </message>
    <message>
        <source>the refinement `cubic` solves every cell the ray crosses; `--step` below the wall&apos;s thickness does as well.</source>
        <translation>die Verfeinerung `cubic` löst jede Zelle, die der Strahl durchquert; `--step` unter der Wanddicke hilft ebenso.</translation>
    </message>
    <message>
        <source>samples miss a wall of thickness w, crossed at an angle a to its normal, with probability 1 - w/(s cos a) at step s, for 0.1 to 1 voxel and up to 85 degrees; solved cells miss none, by any structure, and are off by under 0.002 voxels.</source>
        <translation>Abtastung verfehlt eine Wand der Dicke w, unter dem Winkel a zu ihrer Normalen durchquert, mit der Wahrscheinlichkeit 1 - w/(s cos a) bei Schrittweite s, für 0,1 bis 1 Voxel und bis 85 Grad; gelöste Zellen verfehlen keine, mit keiner Struktur, und liegen unter 0,002 Voxel daneben.</translation>
    </message>
    <message>
        <source>No structure or refinement adds to it</source>
        <translation>Keine Struktur oder Verfeinerung verschlimmert es</translation>
    </message>
    <message>
        <source>A skipped cell or a bad bracket could lose a wall that the samples do find.</source>
        <translation>Eine übersprungene Zelle oder eine schlechte Klammer könnte eine Wand verlieren, die die Abtastpunkte finden.</translation>
    </message>
    <message>
        <source>structures skip only cells whose smallest and largest values lie on one side; refinements keep their bracket.</source>
        <translation>Strukturen überspringen nur Zellen, deren kleinster und größter Wert auf einer Seite liegen; Verfeinerungen behalten ihre Klammer.</translation>
    </message>
    <message>
        <source>the same pixels are hit by every structure with every refinement; the depth is within a step unrefined, within step/2^(n+1) bisected.</source>
        <translation>mit jeder Struktur und jeder Verfeinerung werden dieselben Pixel getroffen; die Tiefe stimmt unverfeinert auf einen Schritt, halbiert auf Schritt/2^(n+1).</translation>
    </message>
    <message>
        <source>No refinement</source>
        <translation>Keine Verfeinerung</translation>
    </message>
    <message>
        <source>Without refinement the surface is drawn at the first sample behind it: it recedes, and shows rings.</source>
        <translation>Ohne Verfeinerung wird die Oberfläche am ersten Abtastpunkt dahinter gezeichnet: Sie weicht zurück und zeigt Ringe.</translation>
    </message>
    <message>
        <source>`--refine` other than `none`.</source>
        <translation>`--refine` anders als `none`.</translation>
    </message>
    <message>
        <source>off by up to a step, half a step on average: first order in the step.</source>
        <translation>bis zu einen Schritt daneben, im Mittel einen halben: erste Ordnung in der Schrittweite.</translation>
    </message>
    <message>
        <source>Regula falsi stalls</source>
        <translation>Regula falsi bleibt stehen</translation>
    </message>
    <message>
        <source>As published, one end of the bracket stays where the signal is convex along the ray, and more steps change nothing.</source>
        <translation>Wie veröffentlicht, bleibt ein Ende der Klammer stehen, wo das Signal entlang des Strahls konvex ist, und weitere Schritte ändern nichts.</translation>
    </message>
    <message>
        <source>`regula-falsi` halves the kept end&apos;s weight (Illinois); `regula-falsi-plain` is the method as published.</source>
        <translation>`regula-falsi` halbiert das Gewicht des behaltenen Endes (Illinois); `regula-falsi-plain` ist das Verfahren wie veröffentlicht.</translation>
    </message>
    <message>
        <source>plain: off by over a fifth of a millimetre at a step of 8 after 64 steps; guarded: within 0.001 mm after 16.</source>
        <translation>unverändert: nach 64 Schritten über ein Fünftel Millimeter daneben bei Schrittweite 8; mit Schutz: nach 16 auf 0,001 mm.</translation>
    </message>
    <message>
        <source>Newton at tangent rays</source>
        <translation>Newton an streifenden Strahlen</translation>
    </message>
    <message>
        <source>Where a ray all but touches the surface the slope along it all but vanishes, and textbook Newton runs off.</source>
        <translation>Wo ein Strahl die Oberfläche fast nur berührt, verschwindet die Steigung entlang des Strahls fast, und Newton nach Lehrbuch läuft davon.</translation>
    </message>
    <message>
        <source>the first estimate is the secant&apos;s, from which concave signals are met from the inside.</source>
        <translation>die erste Schätzung ist die der Sekante, von der aus konkave Signale von innen erreicht werden.</translation>
    </message>
    <message>
        <source>textbook Newton fails on most such rays; started at the secant none leaves its bracket, and depths are within 0.001 voxels.</source>
        <translation>Newton nach Lehrbuch versagt bei den meisten solcher Strahlen; von der Sekante aus verlässt keiner seine Klammer, und Tiefen stimmen auf 0,001 Voxel.</translation>
    </message>
    <message>
        <source>Newton beside flat signals</source>
        <translation>Newton neben flachen Signalen</translation>
    </message>
    <message>
        <source>Beside an edge narrower than a step the signal is flat: there is no slope to go by.</source>
        <translation>Neben einer Kante, schmaler als ein Schritt, ist das Signal flach: Es gibt keine Steigung, nach der man gehen könnte.</translation>
    </message>
    <message>
        <source>an estimate that leaves the bracket is replaced by its middle and counted.</source>
        <translation>eine Schätzung, die die Klammer verlässt, wird durch deren Mitte ersetzt und gezählt.</translation>
    </message>
    <message>
        <source>off by half a step at most.</source>
        <translation>höchstens einen halben Schritt daneben.</translation>
    </message>
    <message>
        <source>The grid&apos;s own error</source>
        <translation>Der Fehler des Gitters selbst</translation>
    </message>
    <message>
        <source>Between voxels the signal is trilinear, a curved surface is not.</source>
        <translation>Zwischen Voxeln ist das Signal trilinear, eine gekrümmte Oberfläche nicht.</translation>
    </message>
    <message>
        <source>finer voxels only.</source>
        <translation>nur feinere Voxel.</translation>
    </message>
    <message>
        <source>second order in the voxel size (slope within 0.15 of 2), on the device and in the reference.</source>
        <translation>zweite Ordnung in der Voxelgröße (Steigung auf 0,15 bei 2), auf dem Gerät und in der Referenz.</translation>
    </message>
    <message>
        <source>Peaks between two samples</source>
        <translation>Spitzen zwischen zwei Abtastpunkten</translation>
    </message>
    <message>
        <source>A peak of the transfer function narrower than the values&apos; change over a step falls between two samples: its shell has holes or vanishes.</source>
        <translation>Eine Spitze der Transferfunktion, schmaler als die Änderung der Werte über einen Schritt, fällt zwischen zwei Abtastpunkte: Ihre Schale hat Löcher oder verschwindet.</translation>
    </message>
    <message>
        <source>`--integration preintegrated` draws every value between two samples.</source>
        <translation>`--integration preintegrated` zeichnet jeden Wert zwischen zwei Abtastpunkten.</translation>
    </message>
    <message>
        <source>points are off by over 20 of 255 levels for a peak a tenth of a step wide, segments by less than 3.</source>
        <translation>Punkte liegen für eine Spitze von einem Zehntel Schritt über 20 von 255 Stufen daneben, Segmente unter 3.</translation>
    </message>
    <message>
        <source>Peaks narrower than a table&apos;s entry</source>
        <translation>Spitzen schmaler als ein Tabelleneintrag</translation>
    </message>
    <message>
        <source>The table of pre-integrated segments has 512 x 512 entries over the span between the function&apos;s outermost points: narrower peaks are smeared.</source>
        <translation>Die Tabelle der vorintegrierten Segmente hat 512 x 512 Einträge über die Spanne zwischen den äußersten Punkten der Funktion: Schmalere Spitzen werden verschmiert.</translation>
    </message>
    <message>
        <source>the extinction of every entry is integrated exactly, so that opacity survives the smear.</source>
        <translation>die Schwächung jedes Eintrags wird exakt integriert, sodass die Deckkraft das Verschmieren übersteht.</translation>
    </message>
    <message>
        <source>opacity within a fifth for a peak a twentieth of an entry wide.</source>
        <translation>Deckkraft auf ein Fünftel genau für eine Spitze von einem Zwanzigstel eines Eintrags.</translation>
    </message>
    <message>
        <source>Layers between two samples of like value</source>
        <translation>Schichten zwischen gleichen Abtastwerten</translation>
    </message>
    <message>
        <source>Both forms of integration know nothing of a layer of voxels between two samples: its values are neither of theirs.</source>
        <translation>Beide Arten der Integration wissen nichts von einer Voxelschicht zwischen zwei Abtastpunkten: Ihre Werte sind keiner der beiden.</translation>
    </message>
    <message>
        <source>a step below the layer&apos;s thickness meets it on every ray.</source>
        <translation>eine Schrittweite unter der Schichtdicke trifft sie auf jedem Strahl.</translation>
    </message>
    <message>
        <source>a layer one voxel thick is lost wholly on some rays at a step of two, on none at one half; a share of 1 - w/s as for walls.</source>
        <translation>eine Schicht von einem Voxel geht bei Schrittweite zwei auf manchen Strahlen ganz verloren, bei einem halben auf keinem; ein Anteil von 1 - w/s wie bei Wänden.</translation>
    </message>
    <message>
        <source>The step&apos;s own error</source>
        <translation>Der Fehler der Schrittweite selbst</translation>
    </message>
    <message>
        <source>A sum over samples is not the integral.</source>
        <translation>Eine Summe über Abtastpunkte ist nicht das Integral.</translation>
    </message>
    <message>
        <source>`--verify-against fine` measures it.</source>
        <translation>`--verify-against fine` misst ihn.</translation>
    </message>
    <message>
        <source>second order in the step (slope within 0.15 of 2).</source>
        <translation>zweite Ordnung in der Schrittweite (Steigung auf 0,15 bei 2).</translation>
    </message>
    <message>
        <source>Early termination before a bright core</source>
        <translation>Früher Abbruch vor einem hellen Kern</translation>
    </message>
    <message>
        <source>A ray ends when opacity exceeds 1 - E; a bright core behind a dense veil is lost.</source>
        <translation>Ein Strahl endet, wenn die Deckkraft 1 - E übersteigt; ein heller Kern hinter einem dichten Schleier geht verloren.</translation>
    </message>
    <message>
        <source>`--ert` states E; the plan&apos;s `why` the levels.</source>
        <translation>`--ert` nennt E; das `why` des Plans nennt die Stufen.</translation>
    </message>
    <message>
        <source>at most 255 E grey levels, 306 E under Phong shading: 0.6 at the default.</source>
        <translation>höchstens 255 E Graustufen, mit Phong-Schattierung 306 E: 0,6 bei der Voreinstellung.</translation>
    </message>
    <message>
        <source>Opacity of a step</source>
        <translation>Deckkraft eines Schritts</translation>
    </message>
    <message>
        <source>Opacity taken a sample instead of a length doubles when the step is halved.</source>
        <translation>Deckkraft je Abtastpunkt statt je Länge verdoppelt sich, wenn der Schritt halbiert wird.</translation>
    </message>
    <message>
        <source>a step of length d has 1-(1-a)^(d/unit), for voxels of any size.</source>
        <translation>ein Schritt der Länge d hat 1-(1-a)^(d/unit), für Voxel jeder Größe.</translation>
    </message>
    <message>
        <source>within 0.0005 of the closed form at steps of 1/8 to 1 voxel, and for voxels of 1e-6 and 1e6 mm.</source>
        <translation>auf 0,0005 an der geschlossenen Form bei Schritten von 1/8 bis 1 Voxel und für Voxel von 1e-6 und 1e6 mm.</translation>
    </message>
    <message>
        <source>Opacity at extreme scales</source>
        <translation>Deckkraft bei äußersten Maßstäben</translation>
    </message>
    <message>
        <source>With voxels a millionth or a million times the unit distance the powers over- or underflow.</source>
        <translation>Bei Voxeln vom Millionstel oder Millionenfachen der Bezugslänge laufen die Potenzen über oder unter.</translation>
    </message>
    <message>
        <source>lengths enter as ratios.</source>
        <translation>Längen gehen als Verhältnisse ein.</translation>
    </message>
    <message>
        <source>the same picture within half a level by every structure; a film or a wall where the unit stays, never NaN.</source>
        <translation>dasselbe Bild auf eine halbe Stufe mit jeder Struktur; Film oder Wand, wo die Bezugslänge bleibt, nie NaN.</translation>
    </message>
    <message>
        <source>One-voxel spots</source>
        <translation>Flecken von einem Voxel</translation>
    </message>
    <message>
        <source>The brightest (darkest) value of a spot lies between two samples, and less of it is shown.</source>
        <translation>Der hellste (dunkelste) Wert eines Flecks liegt zwischen zwei Abtastpunkten, und weniger von ihm wird gezeigt.</translation>
    </message>
    <message>
        <source>`--sampler nearest` shows every spot a ray goes through whole, at a step of up to one voxel.</source>
        <translation>`--sampler nearest` zeigt jeden Fleck, durch den ein Strahl geht, ganz, bei Schrittweiten bis zu einem Voxel.</translation>
    </message>
    <message>
        <source>a sample lies up to half a step off: 1 - prod(1 - s|d_i|/2) of the height along direction d; 25 % along an axis at half a voxel, 37 % along the diagonal. Measured 10 % and more at a quarter, 22 % at half, 35 % at one voxel, for spacing 1:1:1 and 1:1:5.</source>
        <translation>ein Abtastpunkt liegt bis zu einem halben Schritt daneben: 1 - prod(1 - s|d_i|/2) der Höhe entlang der Richtung d; 25 % entlang einer Achse bei einem halben Voxel, 37 % entlang der Diagonalen. Gemessen 10 % und mehr bei einem viertel, 22 % bei einem halben, 35 % bei einem Voxel, für Abstände 1:1:1 und 1:1:5.</translation>
    </message>
    <message>
        <source>No structure loses more of a spot</source>
        <translation>Keine Struktur verliert mehr von einem Fleck</translation>
    </message>
    <message>
        <source>A cell taken for one without a winner hides the winner.</source>
        <translation>Eine Zelle, die für eine ohne Sieger gehalten wird, verbirgt den Sieger.</translation>
    </message>
    <message>
        <source>cells carry the largest and smallest value of every voxel their samples can touch.</source>
        <translation>Zellen tragen den kleinsten und größten Wert jedes Voxels, den ihre Abtastpunkte berühren können.</translation>
    </message>
    <message>
        <source>the same picture within half a level by every structure.</source>
        <translation>dasselbe Bild auf eine halbe Stufe mit jeder Struktur.</translation>
    </message>
    <message>
        <source>Local maxima just above the threshold</source>
        <translation>Örtliche Maxima knapp über der Schwelle</translation>
    </message>
    <message>
        <source>LMIP passes over a local maximum that exceeds the threshold between two samples only.</source>
        <translation>LMIP übergeht ein örtliches Maximum, das die Schwelle nur zwischen zwei Abtastpunkten übersteigt.</translation>
    </message>
    <message>
        <source>`--sampler nearest`, or a threshold lower by the share that spots lose.</source>
        <translation>`--sampler nearest`, oder eine Schwelle, die um den Anteil niedriger ist, den Flecken verlieren.</translation>
    </message>
    <message>
        <source>a spot of 220 is passed over at threshold 200 and step one half; nearest samples stop at it.</source>
        <translation>ein Fleck von 220 wird bei Schwelle 200 und Schrittweite einhalb übergangen; nächste Voxel halten an ihm an.</translation>
    </message>
    <message>
        <source>Borders of the 24 regions</source>
        <translation>Grenzen der 24 Bereiche</translation>
    </message>
    <message>
        <source>A direction with a component of exactly zero, or two of equal size, lies in two regions of viewing directions; lists made for one may lack what the other sees.</source>
        <translation>Eine Richtung mit einer Komponente von genau null oder zwei gleich großen liegt in zwei Bereichen von Blickrichtungen; Listen für den einen können auslassen, was der andere sieht.</translation>
    </message>
    <message>
        <source>both regions&apos; lists hold all that their common border sees.</source>
        <translation>die Listen beider Bereiche enthalten alles, was ihre gemeinsame Grenze sieht.</translation>
    </message>
    <message>
        <source>all 26 axis and diagonal directions, and 1e-9 beside each: depth within 0.6 voxel diagonals (linear) of rays.</source>
        <translation>alle 26 Achsen- und Diagonalrichtungen und 1e-9 neben jeder: Tiefe auf 0,6 Voxeldiagonalen (linear) wie bei Strahlen.</translation>
    </message>
    <message>
        <source>Slanted views by nearest voxels</source>
        <translation>Schräge Ansichten mit nächsten Voxeln</translation>
    </message>
    <message>
        <source>One voxel paints one pixel of the sheared slice: at 45 degrees up to a third of the resolution is lost, and depth is a staircase.</source>
        <translation>Ein Voxel malt einen Pixel der gescherten Schicht: bei 45 Grad geht bis zu einem Drittel der Auflösung verloren, und die Tiefe ist eine Treppe.</translation>
    </message>
    <message>
        <source>`--sampler linear`, which the still picture takes.</source>
        <translation>`--sampler linear`, das das stehende Bild nimmt.</translation>
    </message>
    <message>
        <source>nearest: within 1.6 voxel diagonals, 0.2 mm and more on average at 45 degrees; linear: 0.1 mm.</source>
        <translation>nächste Voxel: auf 1,6 Voxeldiagonalen, bei 45 Grad im Mittel 0,2 mm und mehr; linear: 0,1 mm.</translation>
    </message>
    <message>
        <source>Popping</source>
        <translation>Springen</translation>
    </message>
    <message>
        <source>Where the principal axis switches, the slices do, and the picture jumps.</source>
        <translation>Wo die Hauptachse wechselt, wechseln die Schichten, und das Bild springt.</translation>
    </message>
    <message>
        <source>none: it is the method&apos;s nature; ray casting has no such view.</source>
        <translation>nichts: Es liegt im Verfahren; Strahlen kennen keine solche Ansicht.</translation>
    </message>
    <message>
        <source>a turn of 0.02 degrees over the switch changes the picture more than twice as much as one beside it, by under 6 levels on average.</source>
        <translation>eine Drehung um 0,02 Grad über den Wechsel ändert das Bild mehr als doppelt so sehr wie daneben, im Mittel um unter 6 Stufen.</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>Perspektive</translation>
    </message>
    <message>
        <source>One shear serves parallel rays only.</source>
        <translation>Eine Scherung dient nur parallelen Strahlen.</translation>
    </message>
    <message>
        <source>the camera&apos;s field of view is refused in one sentence.</source>
        <translation>das Sichtfeld der Kamera wird in einem Satz abgelehnt.</translation>
    </message>
    <message>
        <source>none is drawn.</source>
        <translation>keine wird gezeichnet.</translation>
    </message>
    <message>
        <source>A peak inside a homogeneous node</source>
        <translation>Eine Spitze in einem homogenen Knoten</translation>
    </message>
    <message>
        <source>The octree takes a node whose values differ by less than the threshold as its average; a narrow peak of the transfer function inside that range vanishes.</source>
        <translation>Der Octree nimmt einen Knoten, dessen Werte sich um weniger als die Schwelle unterscheiden, als ihren Mittelwert; eine schmale Spitze der Transferfunktion in diesem Bereich verschwindet.</translation>
    </message>
    <message>
        <source>threshold 0 is lossless; pc, acd and eacd compare opacities and colours instead; the plan&apos;s `why` says when a peak is narrower than the threshold, and the planner takes no thresholds.</source>
        <translation>Schwelle 0 ist verlustfrei; pc, acd und eacd vergleichen statt dessen Deckkraft und Farbe; das `why` des Plans sagt, wenn eine Spitze schmaler als die Schwelle ist, und der Planer nimmt keine Schwellen.</translation>
    </message>
    <message>
        <source>over 60 of 255 levels lost by values at a threshold of 15 voxels&apos; change; at most 6 by opacities at 0.02.</source>
        <translation>über 60 von 255 Stufen verloren nach Werten, bei einer Schwelle von der Änderung über 15 Voxel; höchstens 6 nach Deckkraft bei 0,02.</translation>
    </message>
    <message>
        <source>Thresholds too wide</source>
        <translation>Zu weite Schwellen</translation>
    </message>
    <message>
        <source>Regions whose opacities may differ by the threshold show as patches.</source>
        <translation>Bereiche, deren Deckkraft sich um die Schwelle unterscheiden darf, zeigen sich als Flecken.</translation>
    </message>
    <message>
        <source>0 is lossless.</source>
        <translation>0 ist verlustfrei.</translation>
    </message>
    <message>
        <source>255 T levels a unit distance; the error grows with the threshold.</source>
        <translation>255 T Stufen je Bezugslänge; der Fehler wächst mit der Schwelle.</translation>
    </message>
    <message>
        <source>Distances saturate at 31 voxels</source>
        <translation>Abstände enden bei 31 Voxeln</translation>
    </message>
    <message>
        <source>EACD has five bits an axis: large empty space is crossed in jumps of 31 voxels.</source>
        <translation>EACD hat fünf Bit je Achse: großer leerer Raum wird in Sprüngen von 31 Voxeln durchquert.</translation>
    </message>
    <message>
        <source>saturated, never wrapped; over macro-cells (the default) a jump is as many cells.</source>
        <translation>gesättigt, nie übergelaufen; über Makrozellen (Voreinstellung) reicht ein Sprung so viele Zellen.</translation>
    </message>
    <message>
        <source>at least one look-up in 31 voxels a ray, at most three times that; half as many over cells of 8^3. The picture is the same.</source>
        <translation>mindestens eine Abfrage je 31 Voxel und Strahl, höchstens das Dreifache; halb so viele über Zellen von 8^3. Das Bild ist dasselbe.</translation>
    </message>
    <message>
        <source>A field a voxel for large volumes</source>
        <translation>Ein Feld je Voxel bei großen Volumen</translation>
    </message>
    <message>
        <source>Eight distances a voxel need eight to sixteen bytes a voxel.</source>
        <translation>Acht Abstände je Voxel brauchen acht bis sechzehn Byte je Voxel.</translation>
    </message>
    <message>
        <source>before anything is allocated, naming the bytes and what fits.</source>
        <translation>bevor etwas belegt wird, mit den nötigen Byte und dem, was passt.</translation>
    </message>
    <message>
        <source>none is built.</source>
        <translation>keines wird gebaut.</translation>
    </message>
    <message>
        <source>Dense, faint data</source>
        <translation>Dichte, schwache Daten</translation>
    </message>
    <message>
        <source>Where most voxels are visible there is nothing to skip, and asking costs.</source>
        <translation>Wo die meisten Voxel sichtbar sind, gibt es nichts zu überspringen, und Fragen kostet.</translation>
    </message>
    <message>
        <source>a ray that can skip nothing asks once.</source>
        <translation>ein Strahl, der nichts überspringen kann, fragt einmal.</translation>
    </message>
    <message>
        <source>one look-up a ray where every cell is visible; leaping costs little more than nothing.</source>
        <translation>eine Abfrage je Strahl, wo jede Zelle sichtbar ist; Sprünge kosten wenig mehr als nichts.</translation>
    </message>
    <message>
        <source>Corners of cells</source>
        <translation>Ecken von Zellen</translation>
    </message>
    <message>
        <source>A ray through a corner or along a face of cells can loop, or jump a cell.</source>
        <translation>Ein Strahl durch eine Ecke oder entlang einer Fläche von Zellen kann im Kreis laufen oder eine Zelle überspringen.</translation>
    </message>
    <message>
        <source>jumps end a hair behind the cell&apos;s border and always advance a sample.</source>
        <translation>Sprünge enden ein Haar hinter dem Rand der Zelle und rücken immer einen Abtastpunkt vor.</translation>
    </message>
    <message>
        <source>diagonals through voxel corners: no pixel off by more than a level, by any structure.</source>
        <translation>Diagonalen durch Voxelecken: kein Pixel mehr als eine Stufe daneben, mit keiner Struktur.</translation>
    </message>
    <message>
        <source>Equal samples outside regions</source>
        <translation>Gleiche Abtastwerte außerhalb von Bereichen</translation>
    </message>
    <message>
        <source>The leaping kernel as published takes two equal samples for a region, wherever they lie, and then samples nearest: saturated, striped or padded data fools it.</source>
        <translation>Der Sprungkern wie veröffentlicht hält zwei gleiche Abtastwerte für einen Bereich, wo immer sie liegen, und tastet dann nächste Voxel ab: gesättigte, gestreifte oder aufgefüllte Daten täuschen ihn.</translation>
    </message>
    <message>
        <source>`--leaping confirmed` believes only the leap voxel&apos;s own bit; the planner never takes `published`.</source>
        <translation>`--leaping confirmed` glaubt nur dem Bit des Sprungvoxels selbst; der Planer nimmt `published` nie.</translation>
    </message>
    <message>
        <source>published: off by over 10 of 255 levels on balls without noise; confirmed: within 1.</source>
        <translation>wie veröffentlicht: über 10 von 255 Stufen daneben an Kugeln ohne Rauschen; bestätigt: auf 1.</translation>
    </message>
    <message>
        <source>Wide regions are drawn as their mean</source>
        <translation>Weite Bereiche werden als ihr Mittel gezeichnet</translation>
    </message>
    <message>
        <source>Above threshold 0 the picture is that of the volume in which each region has its average.</source>
        <translation>Über Schwelle 0 ist das Bild das des Volumens, in dem jeder Bereich seinen Mittelwert hat.</translation>
    </message>
    <message>
        <source>exactly the brute-force picture of the flattened volume; its error grows with the threshold.</source>
        <translation>genau das Bild der vollen Abtastung des geglätteten Volumens; sein Fehler wächst mit der Schwelle.</translation>
    </message>
    <message>
        <source>Leaps that go too far</source>
        <translation>Zu weite Sprünge</translation>
    </message>
    <message>
        <source>A leap longer than the way to the region&apos;s end skips a pore.</source>
        <translation>Ein Sprung, länger als der Weg bis zum Ende des Bereichs, überspringt eine Pore.</translation>
    </message>
    <message>
        <source>every leap value is at most the distance less one and a half voxel diagonals.</source>
        <translation>jeder Sprungwert ist höchstens der Abstand weniger anderthalb Voxeldiagonalen.</translation>
    </message>
    <message>
        <source>no voxel&apos;s value exceeds its true distance, in all three ways of making them.</source>
        <translation>kein Wert übersteigt den wahren Abstand, auf allen drei Wegen, sie zu bilden.</translation>
    </message>
    <message>
        <source>Floating-point voxels</source>
        <translation>Gleitkomma-Voxel</translation>
    </message>
    <message>
        <source>16 bits with a flag leave 15 for a density.</source>
        <translation>16 Bit mit einem Kennzeichen lassen 15 für eine Dichte.</translation>
    </message>
    <message>
        <source>`leap` on f32 unless the range to quantise is stated.</source>
        <translation>`leap` auf f32, außer der Bereich zum Quantisieren ist genannt.</translation>
    </message>
    <message>
        <source>Noise leaves nothing to leap through</source>
        <translation>Rauschen lässt nichts zum Springen</translation>
    </message>
    <message>
        <source>Noise makes tiny regions; with none large enough every sample is taken.</source>
        <translation>Rauschen macht winzige Bereiche; ist keiner groß genug, wird jeder Punkt abgetastet.</translation>
    </message>
    <message>
        <source>the share of equal neighbours is counted; `--smooth` first brings regions back.</source>
        <translation>der Anteil gleicher Nachbarn wird gezählt; `--smooth` zuvor bringt Bereiche zurück.</translation>
    </message>
    <message>
        <source>at noise of 10 % of the contrast over ten times as many regions, and over a tenth less of the voxels in large ones; smoothed by 1.5 voxels, at most three times as many.</source>
        <translation>bei Rauschen von 10 % des Kontrasts über zehnmal so viele Bereiche und über ein Zehntel weniger Voxel in großen; mit 1,5 Voxel geglättet höchstens dreimal so viele.</translation>
    </message>
    <message>
        <source>Wires between cast pixels</source>
        <translation>Drähte zwischen verfolgten Pixeln</translation>
    </message>
    <message>
        <source>What is thinner than K pixels and met by no cast ray is lost.</source>
        <translation>Was dünner als K Pixel ist und von keinem verfolgten Strahl getroffen wird, geht verloren.</translation>
    </message>
    <message>
        <source>`--sparse K,G,aware` asks min-max cells; nothing is promised for `lmip`, `mean`, and for what floats before or behind something visible.</source>
        <translation>`--sparse K,G,aware` fragt Min-Max-Zellen; nichts wird versprochen für `lmip`, `mean` und für das, was vor oder hinter Sichtbarem schwebt.</translation>
    </message>
    <message>
        <source>a wire of one voxel vanishes at K = 16 for some views; with `aware` no pixel is off by more than 6 levels.</source>
        <translation>ein Draht von einem Voxel verschwindet bei K = 16 in manchen Ansichten; mit `aware` liegt kein Pixel mehr als 6 Stufen daneben.</translation>
    </message>
    <message>
        <source>Soft differences between cast pixels</source>
        <translation>Sanfte Unterschiede zwischen verfolgten Pixeln</translation>
    </message>
    <message>
        <source>Differences below G between four cast pixels are interpolated away.</source>
        <translation>Unterschiede unter G zwischen vier verfolgten Pixeln werden weginterpoliert.</translation>
    </message>
    <message>
        <source>`--sparse K,0` interpolates between equal pixels only.</source>
        <translation>`--sparse K,0` interpoliert nur zwischen gleichen Pixeln.</translation>
    </message>
    <message>
        <source>the error grows with G, the number of rays falls.</source>
        <translation>der Fehler wächst mit G, die Zahl der Strahlen fällt.</translation>
    </message>
    <message>
        <source>Occlusion from the picture alone</source>
        <translation>Verdeckung aus dem Bild allein</translation>
    </message>
    <message>
        <source>SSAO sees only what the picture shows: what is hidden or outside it darkens nothing, and near things could darken far ones.</source>
        <translation>SSAO sieht nur, was das Bild zeigt: Verborgenes oder außerhalb Liegendes verdunkelt nichts, und Nahes könnte Fernes verdunkeln.</translation>
    </message>
    <message>
        <source>depths too far apart are left out (range check).</source>
        <translation>zu weit auseinander liegende Tiefen bleiben außen vor (Bereichsprüfung).</translation>
    </message>
    <message>
        <source>no halo on what lies far behind; a plane stays as it is.</source>
        <translation>kein Hof auf weit Entferntem; eine Ebene bleibt, wie sie ist.</translation>
    </message>
    <message>
        <source>Blur across outlines</source>
        <translation>Unschärfe über Umrisse</translation>
    </message>
    <message>
        <source>Depth of field blurs a picture: colours of what is sharp bleed into what is not.</source>
        <translation>Schärfentiefe verwischt ein Bild: Farben des Scharfen bluten ins Unscharfe.</translation>
    </message>
    <message>
        <source>pixels weigh by their own circle of confusion.</source>
        <translation>Pixel wiegen nach ihrem eigenen Unschärfekreis.</translation>
    </message>
    <message>
        <source>sharp colour stays out of the blur.</source>
        <translation>scharfe Farbe bleibt aus der Unschärfe heraus.</translation>
    </message>
    <message>
        <source>Voxels that are no numbers</source>
        <translation>Voxel, die keine Zahlen sind</translation>
    </message>
    <message>
        <source>A NaN or infinite voxel spoils every sample of its neighbourhood.</source>
        <translation>Ein NaN oder unendliches Voxel verdirbt jeden Abtastwert seiner Umgebung.</translation>
    </message>
    <message>
        <source>such samples contribute nothing and are counted nowhere; structures never call their cells empty or alike.</source>
        <translation>solche Abtastwerte tragen nichts bei und zählen nirgends; Strukturen nennen ihre Zellen nie leer oder gleich.</translation>
    </message>
    <message>
        <source>every mode by every structure, NaN and both infinities scattered: the reference&apos;s picture, but for 1 % of pixels.</source>
        <translation>jeder Modus mit jeder Struktur, NaN und beide Unendlich verstreut: das Bild der Referenz bis auf 1 % der Pixel.</translation>
    </message>
    <message>
        <source>One value, or one voxel across</source>
        <translation>Ein Wert oder ein Voxel quer</translation>
    </message>
    <message>
        <source>Ranges, gradients and cells of nothing: divisions by zero, empty trees.</source>
        <translation>Bereiche, Gradienten und Zellen aus nichts: Teilungen durch null, leere Bäume.</translation>
    </message>
    <message>
        <source>every build and fit takes them.</source>
        <translation>jeder Aufbau und jede Anpassung nimmt sie an.</translation>
    </message>
    <message>
        <source>constant volumes and 1xN, 1x1xN, 1x1x1 in every mode by every structure.</source>
        <translation>konstante Volumen und 1xN, 1x1xN, 1x1x1 in jedem Modus mit jeder Struktur.</translation>
    </message>
    <message>
        <source>Rays exactly along axes</source>
        <translation>Strahlen genau entlang der Achsen</translation>
    </message>
    <message>
        <source>A direction component of exactly zero divides by zero; rays within voxel faces belong to two voxels.</source>
        <translation>Eine Richtungskomponente von genau null teilt durch null; Strahlen in Voxelflächen gehören zwei Voxeln.</translation>
    </message>
    <message>
        <source>slabs the ray runs along are left out of its entry and exit.</source>
        <translation>Platten, an denen der Strahl entlangläuft, bleiben bei Ein- und Austritt außen vor.</translation>
    </message>
    <message>
        <source>six axes, on voxel centres and faces: the reference&apos;s picture but for rays within the box&apos;s own faces; structures change nothing.</source>
        <translation>sechs Achsen, auf Voxelmitten und -flächen: das Bild der Referenz außer bei Strahlen in den Flächen des Kastens selbst; Strukturen ändern nichts.</translation>
    </message>
    <message>
        <source>An eye inside the volume</source>
        <translation>Ein Auge im Volumen</translation>
    </message>
    <message>
        <source>There is no entry, and the first sample may lie inside a region or an object.</source>
        <translation>Es gibt keinen Eintritt, und der erste Abtastpunkt kann in einem Bereich oder Objekt liegen.</translation>
    </message>
    <message>
        <source>rays start at the eye; leaps look ahead for the region&apos;s value.</source>
        <translation>Strahlen beginnen am Auge; Sprünge sehen nach dem Wert des Bereichs voraus.</translation>
    </message>
    <message>
        <source>the reference&apos;s picture; structures change nothing.</source>
        <translation>das Bild der Referenz; Strukturen ändern nichts.</translation>
    </message>
    <message>
        <source>Single precision far away</source>
        <translation>Einfache Genauigkeit in der Ferne</translation>
    </message>
    <message>
        <source>At 10 000 voxels a float&apos;s last digit is a thousandth of a voxel.</source>
        <translation>Bei 10 000 Voxeln ist die letzte Stelle einer Gleitkommazahl ein tausendstel Voxel.</translation>
    </message>
    <message>
        <source>rays are re-based to the volume&apos;s box in double precision.</source>
        <translation>Strahlen werden in doppelter Genauigkeit auf den Kasten des Volumens bezogen.</translation>
    </message>
    <message>
        <source>depth within 0.01 voxels at 10 000 voxels and with origins up to 1e6 mm; 0.02 at the far end of a volume 10 000 voxels long.</source>
        <translation>Tiefe auf 0,01 Voxel bei 10 000 Voxeln und bei Ursprüngen bis 1e6 mm; 0,02 am fernen Ende eines Volumens von 10 000 Voxeln Länge.</translation>
    </message>
    <message>
        <source>The pixel&apos;s own error</source>
        <translation>Der Fehler des Pixels selbst</translation>
    </message>
    <message>
        <source>Between pixel centres nothing is cast.</source>
        <translation>Zwischen Pixelmitten wird nichts verfolgt.</translation>
    </message>
    <message>
        <source>larger pictures only.</source>
        <translation>nur größere Bilder.</translation>
    </message>
    <message>
        <source>second order in the pixel (slope within 0.15 of 2).</source>
        <translation>zweite Ordnung im Pixel (Steigung auf 0,15 bei 2).</translation>
    </message>
    <message>
        <source>Stored gradients</source>
        <translation>Gespeicherte Gradienten</translation>
    </message>
    <message>
        <source>Packed into four bytes, a normal&apos;s direction is rounded.</source>
        <translation>In vier Byte gepackt, wird die Richtung einer Normalen gerundet.</translation>
    </message>
    <message>
        <source>`--gradient on-the-fly`.</source>
        <translation>`--gradient on-the-fly`.</translation>
    </message>
    <message>
        <source>0.2 degrees.</source>
        <translation>0,2 Grad.</translation>
    </message>
    <message>
        <source>Nearest voxels</source>
        <translation>Nächste Voxel</translation>
    </message>
    <message>
        <source>One voxel&apos;s value for its whole cell: stairs.</source>
        <translation>Der Wert eines Voxels für seine ganze Zelle: Treppen.</translation>
    </message>
    <message>
        <source>`--sampler linear`; `adaptive` reads nearest only where nothing can tell.</source>
        <translation>`--sampler linear`; `adaptive` liest nächste Voxel nur, wo man es nicht merken kann.</translation>
    </message>
    <message>
        <source>a surface is off by up to half a voxel diagonal and the step.</source>
        <translation>eine Oberfläche liegt bis zu einer halben Voxeldiagonalen und einem Schritt daneben.</translation>
    </message>
    <message>
        <source>Growth shatters under noise</source>
        <translation>Wachstum zersplittert im Rauschen</translation>
    </message>
    <message>
        <source>A region&apos;s values span at most the width: noise wider than that leaves crumbs.</source>
        <translation>Die Werte eines Bereichs umspannen höchstens die Breite: weiteres Rauschen lässt Krümel.</translation>
    </message>
    <message>
        <source>`--min-voxels` drops them, `--smooth` avoids them.</source>
        <translation>`--min-voxels` lässt sie weg, `--smooth` vermeidet sie.</translation>
    </message>
    <message>
        <source>as for leaping: over ten times as many regions at noise of 10 % of the contrast.</source>
        <translation>wie beim Springen: über zehnmal so viele Bereiche bei Rauschen von 10 % des Kontrasts.</translation>
    </message>
    <message>
        <source>The order of growth</source>
        <translation>Die Reihenfolge des Wachstums</translation>
    </message>
    <message>
        <source>Which seed comes first decides which voxels a region may still take.</source>
        <translation>Welcher Keim zuerst kommt, entscheidet, welche Voxel ein Bereich noch nehmen darf.</translation>
    </message>
    <message>
        <source>seeds are tried in the voxels&apos; order, on any number of threads.</source>
        <translation>Keime werden in der Reihenfolge der Voxel versucht, auf jeder Zahl von Threads.</translation>
    </message>
    <message>
        <source>the same labels, bit for bit.</source>
        <translation>dieselben Marken, Bit für Bit.</translation>
    </message>
    <message>
        <source>Adjacency decides topology</source>
        <translation>Nachbarschaft entscheidet über Topologie</translation>
    </message>
    <message>
        <source>A shell with a diagonal gap is closed for one adjacency and open for the other.</source>
        <translation>Eine Schale mit einer diagonalen Lücke ist für die eine Nachbarschaft geschlossen und für die andere offen.</translation>
    </message>
    <message>
        <source>the adjacency used stands in the table; regions and cavities take opposite ones.</source>
        <translation>die benutzte Nachbarschaft steht in der Tabelle; Bereiche und Hohlräume nehmen entgegengesetzte.</translation>
    </message>
    <message>
        <source>both answers, each right for its adjacency.</source>
        <translation>beide Antworten, jede richtig für ihre Nachbarschaft.</translation>
    </message>
    <message>
        <source>Area from voxel faces</source>
        <translation>Fläche aus Voxelseiten</translation>
    </message>
    <message>
        <source>Counted faces overestimate by half and never converge; weights for cubes are wrong by tens of percent on flat voxels.</source>
        <translation>Gezählte Seiten überschätzen um die Hälfte und konvergieren nie; Gewichte für Würfel sind bei flachen Voxeln um zig Prozent falsch.</translation>
    </message>
    <message>
        <source>Crofton&apos;s formula with 13 directions, weighted for the spacing.</source>
        <translation>Croftons Formel mit 13 Richtungen, für den Voxelabstand gewichtet.</translation>
    </message>
    <message>
        <source>a flat tilted disc at 1:1:5 within the stated bound.</source>
        <translation>eine flache gekippte Scheibe bei 1:1:5 in der genannten Schranke.</translation>
    </message>
    <message>
        <source>Volume at one threshold</source>
        <translation>Volumen bei einer Schwelle</translation>
    </message>
    <message>
        <source>A blurred pore of two voxels&apos; radius reads 0.45 to 0.89 of its volume, as the threshold goes from 60 to 40 %.</source>
        <translation>Eine verwischte Pore von zwei Voxeln Radius liest 0,45 bis 0,89 ihres Volumens, wenn die Schwelle von 60 auf 40 % geht.</translation>
    </message>
    <message>
        <source>every volume carries an interval.</source>
        <translation>jedes Volumen trägt ein Intervall.</translation>
    </message>
    <message>
        <source>the true volume lies in the interval.</source>
        <translation>das wahre Volumen liegt im Intervall.</translation>
    </message>
    <message>
        <source>Porosity under noise</source>
        <translation>Porosität im Rauschen</translation>
    </message>
    <message>
        <source>Noise moves the threshold and adds false pores.</source>
        <translation>Rauschen verschiebt die Schwelle und fügt falsche Poren hinzu.</translation>
    </message>
    <message>
        <source>an interval; finds below the noise are dropped.</source>
        <translation>ein Intervall; Funde unter dem Rauschen fallen weg.</translation>
    </message>
    <message>
        <source>at noise of 0 to 10 % of the contrast the truth lies in the interval.</source>
        <translation>bei Rauschen von 0 bis 10 % des Kontrasts liegt die Wahrheit im Intervall.</translation>
    </message>
    <message>
        <source>Finds of a few voxels</source>
        <translation>Funde von wenigen Voxeln</translation>
    </message>
    <message>
        <source>Below eight voxels the uncertainty exceeds the object.</source>
        <translation>Unter acht Voxeln übersteigt die Unsicherheit das Objekt.</translation>
    </message>
    <message>
        <source>such finds are reported as detected, not measured.</source>
        <translation>solche Funde werden als gefunden, nicht als gemessen gemeldet.</translation>
    </message>
    <message>
        <source>no volume is printed for them.</source>
        <translation>kein Volumen wird für sie gedruckt.</translation>
    </message>
    <message>
        <source>Voxels that are no cubes</source>
        <translation>Voxel, die keine Würfel sind</translation>
    </message>
    <message>
        <source>A shear in voxels a slice puts surfaces elsewhere where voxels are flat or the grid is turned.</source>
        <translation>Eine Scherung in Voxeln je Schicht setzt Oberflächen an eine andere Stelle, wo Voxel flach sind oder das Gitter gedreht ist.</translation>
    </message>
    <message>
        <source>spacing and direction enter the shear and the warp.</source>
        <translation>Abstand und Richtung gehen in Scherung und Verzerrung ein.</translation>
    </message>
    <message>
        <source>spacings of 1:1:2, 0.8:1:1.5 and 1:1:5: depth within 1.6 voxel diagonals of rays (nearest), 0.6 (linear).</source>
        <translation>Abstände von 1:1:2, 0,8:1:1,5 und 1:1:5: die Tiefe liegt innerhalb von 1,6 Voxeldiagonalen bei der von Strahlen (nächster), 0,6 (linear).</translation>
    </message>
    <message>
        <source>A new isovalue or cut</source>
        <translation>Ein neuer Isowert oder Schnitt</translation>
    </message>
    <message>
        <source>A list of visible voxels holds for one isovalue and one set of cuts: every change is a new extraction.</source>
        <translation>Eine Liste sichtbarer Voxel gilt für einen Isowert und einen Satz Schnitte: jede Änderung ist eine neue Suche.</translation>
    </message>
    <message>
        <source>the one region of 24 that is looked from is extracted, others when the view turns there.</source>
        <translation>gesucht wird für den einen von 24 Bereichen, aus dem geblickt wird, für andere, wenn die Ansicht dorthin dreht.</translation>
    </message>
    <message>
        <source>a list is made once a region and sampling, and kept.</source>
        <translation>je Bereich und Abtastung wird eine Liste einmal gemacht und behalten.</translation>
    </message>
    <message>
        <source>Normals that turn within a region</source>
        <translation>Normalen, die sich in einem Bereich drehen</translation>
    </message>
    <message>
        <source>Gradients that differ by less than the angle count as equal: shading that turns within a run is drawn alike.</source>
        <translation>Gradienten, die sich um weniger als den Winkel unterscheiden, gelten als gleich: eine Schattierung, die sich in einem Lauf dreht, wird gleich gezeichnet.</translation>
    </message>
    <message>
        <source>an angle of 0 tells all directions apart.</source>
        <translation>ein Winkel von 0 unterscheidet alle Richtungen.</translation>
    </message>
    <message>
        <source>the error grows with the angle; on a shaded ball at threshold 0.02 under 4 of 255 levels on average, whatever the angle.</source>
        <translation>der Fehler wächst mit dem Winkel; auf einer schattierten Kugel bei Schwelle 0,02 im Mittel unter 4 von 255 Stufen, bei jedem Winkel.</translation>
    </message>
    <message>
        <source>Rays along a surface</source>
        <translation>Strahlen entlang einer Oberfläche</translation>
    </message>
    <message>
        <source>A ray that grazes a surface goes through cells on both its sides: a tree is walked to its leaves again and again, and nothing is skipped.</source>
        <translation>Ein Strahl, der eine Oberfläche streift, läuft durch Zellen auf ihren beiden Seiten: ein Baum wird immer wieder bis zu den Blättern durchlaufen, und nichts wird übersprungen.</translation>
    </message>
    <message>
        <source>16 rays ask once together, and a jump ends at the leaf&apos;s border.</source>
        <translation>16 Strahlen fragen gemeinsam einmal, und ein Sprung endet am Rand des Blatts.</translation>
    </message>
    <message>
        <source>two to three times the look-ups of a ray that meets the surface square on, at most one in four voxels; the picture is the same.</source>
        <translation>zwei- bis dreimal so viele Anfragen wie ein Strahl, der senkrecht auftrifft, höchstens eine je vier Voxel; das Bild ist dasselbe.</translation>
    </message>
</context>
<context>
    <name>PlanKey</name>
    <message>
        <source>mode %1</source>
        <translation>Modus %1</translation>
    </message>
    <message>
        <source>step %1</source>
        <translation>Schritt %1</translation>
    </message>
    <message>
        <source>sampler %1</source>
        <translation>Abtaster %1</translation>
    </message>
    <message>
        <source>gradient %1</source>
        <translation>Gradient %1</translation>
    </message>
    <message>
        <source>integration %1</source>
        <translation>Integration %1</translation>
    </message>
    <message>
        <source>refine %1</source>
        <translation>Verfeinerung %1</translation>
    </message>
    <message>
        <source>refine steps %1</source>
        <translation>Verfeinerungsschritte %1</translation>
    </message>
    <message>
        <source>ert %1</source>
        <translation>Strahlabbruch %1</translation>
    </message>
    <message>
        <source>sparse %1</source>
        <translation>jeder %1. Bildpunkt</translation>
    </message>
    <message>
        <source>sparse aware %1</source>
        <translation>Zellprüfung %1</translation>
    </message>
    <message>
        <source>cells %1</source>
        <translation>Zellen %1</translation>
    </message>
    <message>
        <source>directions %1</source>
        <translation>Richtungen %1</translation>
    </message>
    <message>
        <source>voxel gradient %1</source>
        <translation>Voxelgradient %1</translation>
    </message>
    <message>
        <source>homogeneity %1</source>
        <translation>Homogenität %1</translation>
    </message>
    <message>
        <source>homogeneity angle %1</source>
        <translation>Homogenitätswinkel %1</translation>
    </message>
    <message>
        <source>brick %1</source>
        <translation>Blöcke %1</translation>
    </message>
    <message>
        <source>kernel %1</source>
        <translation>Kern %1</translation>
    </message>
</context>
<context>
    <name>PlanStructure</name>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>macrocells</source>
        <translation>Makrozellen</translation>
    </message>
    <message>
        <source>octree</source>
        <translation>Octree</translation>
    </message>
    <message>
        <source>pyramid</source>
        <translation>Pyramide</translation>
    </message>
    <message>
        <source>pc</source>
        <translation>pc</translation>
    </message>
    <message>
        <source>acd</source>
        <translation>acd</translation>
    </message>
    <message>
        <source>eacd</source>
        <translation>eacd</translation>
    </message>
    <message>
        <source>leap</source>
        <translation>Sprünge</translation>
    </message>
    <message>
        <source>visible</source>
        <translation>sichtbare Voxel</translation>
    </message>
</context>
<context>
    <name>PlanValue</name>
    <message>
        <source>nearest</source>
        <translation>nächster</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>linear</translation>
    </message>
    <message>
        <source>adaptive</source>
        <translation>adaptiv</translation>
    </message>
    <message>
        <source>bisect</source>
        <translation>Bisektion</translation>
    </message>
    <message>
        <source>regula-falsi</source>
        <translation>Regula falsi</translation>
    </message>
    <message>
        <source>newton</source>
        <translation>Newton</translation>
    </message>
    <message>
        <source>regula-falsi-plain</source>
        <translation>schlichte Regula falsi</translation>
    </message>
    <message>
        <source>cubic</source>
        <translation>kubisch</translation>
    </message>
    <message>
        <source>central,on-the-fly</source>
        <translation>zentral im Lauf</translation>
    </message>
    <message>
        <source>central,stored</source>
        <translation>zentral gespeichert</translation>
    </message>
    <message>
        <source>sobel,on-the-fly</source>
        <translation>Sobel im Lauf</translation>
    </message>
    <message>
        <source>sobel,stored</source>
        <translation>Sobel gespeichert</translation>
    </message>
    <message>
        <source>central</source>
        <translation>zentral</translation>
    </message>
    <message>
        <source>sobel</source>
        <translation>Sobel</translation>
    </message>
    <message>
        <source>gaussian</source>
        <translation>Gauß</translation>
    </message>
    <message>
        <source>riemann</source>
        <translation>Riemann</translation>
    </message>
    <message>
        <source>preintegrated</source>
        <translation>vorintegriert</translation>
    </message>
    <message>
        <source>lossless</source>
        <translation>verlustfrei</translation>
    </message>
    <message>
        <source>confirmed</source>
        <translation>bestätigt</translation>
    </message>
    <message>
        <source>published</source>
        <translation>wie veröffentlicht</translation>
    </message>
    <message>
        <source>true</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>false</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>shear-warp</source>
        <translation>Shear-Warp</translation>
    </message>
    <message>
        <source>none</source>
        <comment>no refinement</comment>
        <translation>keine</translation>
    </message>
</context>
<context>
    <name>PresetName</name>
    <message>
        <source>bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>soft-tissue</source>
        <translation>Weichteile</translation>
    </message>
    <message>
        <source>skin</source>
        <translation>Haut</translation>
    </message>
    <message>
        <source>lung</source>
        <translation>Lunge</translation>
    </message>
    <message>
        <source>angio</source>
        <translation>Gefäße</translation>
    </message>
    <message>
        <source>metal</source>
        <translation>Metall</translation>
    </message>
    <message>
        <source>voids</source>
        <translation>Hohlräume</translation>
    </message>
    <message>
        <source>grey</source>
        <translation>Grau</translation>
    </message>
</context>
<context>
    <name>QToolBar</name>
    <message>
        <source>Tool bar</source>
        <translation>Werkzeugleiste</translation>
    </message>
</context>
<context>
    <name>SliceAnnotations</name>
    <message>
        <source>Axial</source>
        <translation>Axial</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Koronal</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittal</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>%1 cm</source>
        <translation>%1 cm</translation>
    </message>
    <message>
        <source>%1 µm</source>
        <translation>%1 µm</translation>
    </message>
</context>
<context>
    <name>Turntable</name>
    <message>
        <source>ffmpeg could not make the film: %1</source>
        <translation>ffmpeg konnte den Film nicht machen: %1</translation>
    </message>
    <message>
        <source>A film needs the program ffmpeg, which is not there; save pictures (.png).</source>
        <translation>Ein Film braucht das Programm ffmpeg, das nicht da ist; bitte Bilder sichern (.png).</translation>
    </message>
    <message>
        <source>There is no place for the film&apos;s pictures: %1.</source>
        <translation>Für die Bilder des Films ist kein Platz: %1.</translation>
    </message>
</context>
<context>
    <name>WindowPreset</name>
    <message>
        <source>Brain</source>
        <translation>Gehirn</translation>
    </message>
    <message>
        <source>Abdomen</source>
        <translation>Abdomen</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>Lung</source>
        <translation>Lunge</translation>
    </message>
    <message>
        <source>Mediastinum</source>
        <translation>Mediastinum</translation>
    </message>
    <message>
        <source>Angio</source>
        <translation>Angio</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::AboutDialog</name>
    <message>
        <source>OpenCL device</source>
        <translation>OpenCL-Gerät</translation>
    </message>
    <message>
        <source>OpenCL driver</source>
        <translation>OpenCL-Treiber</translation>
    </message>
    <message>
        <source>About Lacuna</source>
        <translation>Über Lacuna</translation>
    </message>
    <message>
        <source>A workstation for computed tomography: pictures whose error is known, and the measures of what is found in them.</source>
        <translation>Eine Workstation für die Computertomografie: Bilder, deren Fehler bekannt ist, und die Maße dessen, was in ihnen gefunden wird.</translation>
    </message>
    <message>
        <source>Not a medical device; not for diagnosis.</source>
        <translation>Kein Medizinprodukt; nicht für die Diagnose.</translation>
    </message>
    <message>
        <source>Free software under the GNU General Public License, version 3 or later.</source>
        <translation>Freie Software unter der GNU General Public License, Version 3 oder später.</translation>
    </message>
    <message>
        <source>&amp;Copy the versions</source>
        <translation>Versionen &amp;kopieren</translation>
    </message>
    <message>
        <source>Copy the versions</source>
        <translation>Versionen kopieren</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::AccuracyFeature</name>
    <message>
        <source>Speed and accuracy</source>
        <translation>Tempo und Genauigkeit</translation>
    </message>
    <message>
        <source>Open a volume to measure how fast and how exact each way of drawing it is.</source>
        <translation>Ein Volumen öffnen, um zu messen, wie schnell und wie genau jede Art ist, es zu zeichnen.</translation>
    </message>
    <message>
        <source>Sp&amp;eed and accuracy</source>
        <translation>T&amp;empo und Genauigkeit</translation>
    </message>
    <message>
        <source>Picture, &amp;brute force, difference</source>
        <translation>Bild, volle &amp;Rechnung, Unterschied</translation>
    </message>
    <message>
        <source>&amp;Error badge</source>
        <translation>&amp;Fehleranzeige</translation>
    </message>
    <message>
        <source>&amp;Faster: a larger budget</source>
        <translation>Sch&amp;neller: größerer Spielraum</translation>
    </message>
    <message>
        <source>&amp;More exact: a smaller budget</source>
        <translation>&amp;Genauer: kleinerer Spielraum</translation>
    </message>
    <message>
        <source>Most exact at &amp;30 frames a second</source>
        <translation>Am genauesten bei &amp;30 Bildern je Sekunde</translation>
    </message>
    <message>
        <source>Most exact at &amp;10 frames a second</source>
        <translation>Am genauesten bei &amp;10 Bildern je Sekunde</translation>
    </message>
    <message>
        <source>&amp;No budget</source>
        <translation>&amp;Kein Spielraum</translation>
    </message>
    <message>
        <source>Budget</source>
        <translation>Spielraum</translation>
    </message>
    <message>
        <source>&amp;Budget</source>
        <translation>S&amp;pielraum</translation>
    </message>
    <message>
        <source>Speed and accuracy &amp;chart</source>
        <translation>&amp;Diagramm von Tempo und Genauigkeit</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Shear-warp has no brute force to show</source>
        <translation>Shear-Warp hat keine volle Rechnung zu zeigen</translation>
    </message>
    <message>
        <source>Drawing brute force…</source>
        <translation>Volle Rechnung wird gezeichnet…</translation>
    </message>
    <message>
        <source>This is brute force; key B: the difference. The picture is</source>
        <translation>Dies ist die volle Rechnung; Taste B: der Unterschied. Das Bild ist</translation>
    </message>
    <message>
        <source>Difference ×%1, brightest %2/255; key B: the picture. The picture is</source>
        <translation>Unterschied ×%1, hellster %2/255; Taste B: das Bild. Das Bild ist</translation>
    </message>
    <message>
        <source>No difference in any pixel; key B: the picture. The picture is</source>
        <translation>Kein Unterschied in irgendeinem Pixel; Taste B: das Bild. Das Bild ist</translation>
    </message>
    <message>
        <source>Looking for the plan on this view…</source>
        <translation>Der Plan für diese Ansicht wird gesucht…</translation>
    </message>
    <message>
        <source>%1 · %2 ms a frame</source>
        <translation>%1 · %2 ms je Bild</translation>
    </message>
    <message>
        <source>No plan tried fits the budget; this is the fastest.</source>
        <translation>Kein versuchter Plan passt in den Spielraum; dies ist der schnellste.</translation>
    </message>
    <message>
        <source>… and %1 more</source>
        <translation>… und %1 weitere</translation>
    </message>
    <message>
        <source>Shear-warp has one way of drawing; choose another view mode.</source>
        <translation>Shear-Warp hat nur eine Art zu zeichnen; eine andere Darstellungsart wählen.</translation>
    </message>
    <message>
        <source>Measuring begins when the picture rests.</source>
        <translation>Gemessen wird, sobald das Bild ruht.</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::AccuracyMonitor</name>
    <message>
        <source>Choosing a plan</source>
        <translation>Plan wird gewählt</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::BatchDialog</name>
    <message>
        <source>&amp;Go on with the series that stands in the report folder</source>
        <translation>Mit der Serie &amp;weitermachen, die im Berichtsordner steht</translation>
    </message>
    <message>
        <source>&amp;Start</source>
        <translation>&amp;Starten</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pause</translation>
    </message>
    <message>
        <source>&amp;Cancel the series</source>
        <translation>Serie &amp;abbrechen</translation>
    </message>
    <message>
        <source>&amp;Open the summary</source>
        <translation>&amp;Übersicht öffnen</translation>
    </message>
    <message>
        <source>Inspect a series of parts</source>
        <translation>Serie von Teilen prüfen</translation>
    </message>
    <message>
        <source>Browse: %1</source>
        <translation>Wählen: %1</translation>
    </message>
    <message>
        <source>P&amp;arts</source>
        <translation>&amp;Teile</translation>
    </message>
    <message>
        <source>A folder with one part a sub-folder or file, or a list file</source>
        <translation>Ein Ordner mit einem Teil je Unterordner oder Datei oder eine Listendatei</translation>
    </message>
    <message>
        <source>Folder of the parts</source>
        <translation>Ordner der Teile</translation>
    </message>
    <message>
        <source>C&amp;riteria</source>
        <translation>&amp;Kriterien</translation>
    </message>
    <message>
        <source>JSON file: material, defects, limits, zones</source>
        <translation>JSON-Datei: Material, Fehlstellen, Grenzwerte, Zonen</translation>
    </message>
    <message>
        <source>Criteria</source>
        <translation>Kriterien</translation>
    </message>
    <message>
        <source>Criteria (*.json);;All files (*)</source>
        <translation>Kriterien (*.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>R&amp;eport folder</source>
        <translation>&amp;Berichtsordner</translation>
    </message>
    <message>
        <source>Gets the summary and one report folder a part</source>
        <translation>Bekommt die Übersicht und einen Berichtsordner je Teil</translation>
    </message>
    <message>
        <source>Report folder</source>
        <translation>Berichtsordner</translation>
    </message>
    <message>
        <source>Re&amp;ference part</source>
        <translation>&amp;Referenzteil</translation>
    </message>
    <message>
        <source>Deviations are told from it; may stay empty</source>
        <translation>Abweichungen werden von ihm aus angegeben; kann leer bleiben</translation>
    </message>
    <message>
        <source>Reference part</source>
        <translation>Referenzteil</translation>
    </message>
    <message>
        <source>Parts at once</source>
        <translation>Teile zugleich</translation>
    </message>
    <message>
        <source>At most so many parts at once; fewer where the memory ends</source>
        <translation>Höchstens so viele Teile zugleich; weniger, wo der Speicher endet</translation>
    </message>
    <message>
        <source>Parts at o&amp;nce</source>
        <translation>Teile &amp;zugleich</translation>
    </message>
    <message>
        <source>Parts of the series</source>
        <translation>Teile der Serie</translation>
    </message>
    <message>
        <source>What became of the series</source>
        <translation>Was aus der Serie wurde</translation>
    </message>
    <message>
        <source>&amp;Continue</source>
        <translation>&amp;Weiter</translation>
    </message>
    <message>
        <source>Paused: parts in work stop at their next step.</source>
        <translation>Angehalten: Teile in Arbeit halten bei ihrem nächsten Schritt.</translation>
    </message>
    <message>
        <source>Inspecting…</source>
        <translation>Prüfung läuft…</translation>
    </message>
    <message>
        <source>Name a report folder.</source>
        <translation>Einen Berichtsordner nennen.</translation>
    </message>
    <message>
        <source>Inspecting a series</source>
        <translation>Serie wird geprüft</translation>
    </message>
    <message numerus="yes">
        <source>Cancelled after %n part(s); start again to go on.</source>
        <translation>
            <numerusform>Nach %n Teil abgebrochen; zum Weitermachen erneut starten.</numerusform>
            <numerusform>Nach %n Teilen abgebrochen; zum Weitermachen erneut starten.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 pass, %2 fail, %3 cannot tell, %4 broken. The summary stands in %5.</source>
        <translation>%1 gut, %2 schlecht, %3 unentschieden, %4 defekt. Die Übersicht steht in %5.</translation>
    </message>
    <message>
        <source>Looking for the parts</source>
        <translation>Suche nach den Teilen</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Abgebrochen.</translation>
    </message>
    <message>
        <source>Looking for the parts…</source>
        <translation>Die Teile werden gesucht…</translation>
    </message>
    <message>
        <source>Name the folder of the parts, or a list of them.</source>
        <translation>Bitte den Ordner der Teile oder eine Liste von ihnen nennen.</translation>
    </message>
    <message>
        <source>Name a file of criteria. The inspection panel writes one: Save criteria.</source>
        <translation>Bitte eine Kriteriendatei nennen. Die Tafel Prüfung schreibt eine: Kriterien sichern.</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::BatchFeature</name>
    <message>
        <source>Inspect a &amp;series of parts…</source>
        <translation>&amp;Serie von Teilen prüfen…</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::BatchModel</name>
    <message>
        <source>waiting</source>
        <translation>wartet</translation>
    </message>
    <message>
        <source>running</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>broken</source>
        <translation>defekt</translation>
    </message>
    <message>
        <source>pass</source>
        <translation>gut</translation>
    </message>
    <message>
        <source>fail</source>
        <translation>schlecht</translation>
    </message>
    <message>
        <source>cannot tell</source>
        <translation>unentschieden</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Grund</translation>
    </message>
    <message numerus="yes">
        <source>%1 (and %n more)</source>
        <translation>
            <numerusform>%1 (und %n weiterer)</numerusform>
            <numerusform>%1 (und %n weitere)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>lacuna::ui::BoxPanel</name>
    <message>
        <source>Switch the box</source>
        <translation>Kasten schalten</translation>
    </message>
    <message>
        <source>Show a box of the volume alone</source>
        <translation>Nur einen Kasten des Volumens zeigen</translation>
    </message>
    <message>
        <source>Data values on the box&apos;s sides</source>
        <translation>Messwerte auf den Seiten des Kastens</translation>
    </message>
    <message>
        <source>Whole volume</source>
        <translation>Ganzes Volumen</translation>
    </message>
    <message>
        <source>Cuts away what lies outside the box; drag its sides in the 3D view</source>
        <translation>Schneidet weg, was außerhalb des Kastens liegt; seine Seiten in der 3D-Ansicht ziehen</translation>
    </message>
    <message>
        <source>Show data values on the box&apos;s sides</source>
        <translation>Messwerte auf den Seiten des Kastens zeigen</translation>
    </message>
    <message>
        <source>Off: the box is open and inner surfaces show</source>
        <translation>Aus: der Kasten ist offen und innere Flächen sind zu sehen</translation>
    </message>
    <message>
        <source>Make the box as large as the volume</source>
        <translation>Kasten so groß wie das Volumen machen</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Kasten</translation>
    </message>
    <message>
        <source>Sides of the box</source>
        <translation>Seiten des Kastens</translation>
    </message>
    <message>
        <source>Ends of the box from %1, in voxels</source>
        <translation>Enden des Kastens von %1, in Voxeln</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::BudgetPanel</name>
    <message>
        <source>Fastest: however far off</source>
        <translation>Am schnellsten: wie weit auch immer daneben</translation>
    </message>
    <message>
        <source>At most 32/255 off: the shape is right</source>
        <translation>Höchstens 32/255 daneben: die Form stimmt</translation>
    </message>
    <message>
        <source>At most 8/255 off: plain to see beside it</source>
        <translation>Höchstens 8/255 daneben: im Vergleich zu sehen</translation>
    </message>
    <message>
        <source>At most 2/255 off: hardly to be seen</source>
        <translation>Höchstens 2/255 daneben: kaum zu sehen</translation>
    </message>
    <message>
        <source>At most 0.5/255 off: the same on a screen</source>
        <translation>Höchstens 0,5/255 daneben: auf dem Schirm dasselbe</translation>
    </message>
    <message>
        <source>Exact: equal to brute force</source>
        <translation>Exakt: gleich der vollen Rechnung</translation>
    </message>
    <message>
        <source>&amp;Within a budget</source>
        <translation>In einem S&amp;pielraum</translation>
    </message>
    <message>
        <source>Budget from fastest to exact</source>
        <translation>Spielraum von am schnellsten bis exakt</translation>
    </message>
    <message>
        <source>The plan that draws the full picture is chosen by measuring this very view: the fastest one within the error.</source>
        <translation>Der Plan, der das volle Bild zeichnet, wird durch Messen eben dieser Ansicht gewählt: der schnellste innerhalb des Fehlers.</translation>
    </message>
    <message>
        <source>Draw within a budget</source>
        <translation>In einem Spielraum zeichnen</translation>
    </message>
    <message>
        <source>Off: the usual plan of the view mode, at the quality above</source>
        <translation>Aus: der übliche Plan der Darstellungsart, in der Güte darüber</translation>
    </message>
    <message>
        <source>fastest</source>
        <translation>am schnellsten</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>exakt</translation>
    </message>
    <message>
        <source>Plan in use</source>
        <translation>Benutzter Plan</translation>
    </message>
    <message>
        <source>Budget</source>
        <translation>Spielraum</translation>
    </message>
    <message>
        <source>A plan chosen by hand</source>
        <translation>Ein von Hand gewählter Plan</translation>
    </message>
    <message>
        <source>No budget: the usual plan</source>
        <translation>Kein Spielraum: der übliche Plan</translation>
    </message>
    <message>
        <source>At most %1/255 off</source>
        <translation>Höchstens %1/255 daneben</translation>
    </message>
    <message>
        <source>A frame in %1 ms</source>
        <translation>Ein Bild in %1 ms</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::CloseDialog</name>
    <message>
        <source>These jobs still run. What they have not finished is lost if they are stopped now.</source>
        <translation>Diese Aufgaben laufen noch. Was sie nicht beendet haben, geht verloren, wenn sie jetzt angehalten werden.</translation>
    </message>
    <message>
        <source>Close when they have &amp;ended</source>
        <translation>Schließen, wenn sie &amp;fertig sind</translation>
    </message>
    <message>
        <source>&amp;Stop them and close</source>
        <translation>&amp;Anhalten und schließen</translation>
    </message>
    <message>
        <source>&amp;Keep the window open</source>
        <translation>Fenster &amp;offen lassen</translation>
    </message>
    <message>
        <source>Close the window</source>
        <translation>Fenster schließen</translation>
    </message>
    <message>
        <source>Running jobs</source>
        <translation>Laufende Aufgaben</translation>
    </message>
    <message>
        <source>The window closes as soon as these jobs have ended:</source>
        <translation>Das Fenster schließt, sobald diese Aufgaben beendet sind:</translation>
    </message>
    <message>
        <source>%1 · %2 % done</source>
        <translation>%1 · %2 % erledigt</translation>
    </message>
    <message>
        <source>These jobs have not ended; paused ones go on if the window waits for them. What they have not finished is lost if they are stopped now.</source>
        <translation>Diese Aufgaben sind nicht beendet; angehaltene laufen weiter, wenn das Fenster auf sie wartet. Was sie nicht fertiggestellt haben, geht verloren, wenn sie jetzt abgebrochen werden.</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::ColoursFeature</name>
    <message>
        <source>&amp;Colours</source>
        <translation>&amp;Farben</translation>
    </message>
    <message>
        <source>&amp;Values</source>
        <translation>&amp;Werte</translation>
    </message>
    <message>
        <source>&amp;Gradient opacity</source>
        <translation>Deckkraft nach &amp;Gradient</translation>
    </message>
    <message>
        <source>Value and gradient (&amp;2D)</source>
        <translation>Wert und Gradient (&amp;2D)</translation>
    </message>
    <message>
        <source>&amp;Load a transfer function…</source>
        <translation>Transferfunktion &amp;laden…</translation>
    </message>
    <message>
        <source>&amp;Save the transfer function…</source>
        <translation>Transferfunktion &amp;sichern…</translation>
    </message>
    <message>
        <source>Colour &amp;map</source>
        <translation>Farb&amp;karte</translation>
    </message>
    <message>
        <source>Load a transfer function</source>
        <translation>Transferfunktion laden</translation>
    </message>
    <message>
        <source>Transfer functions (*.json);;All files (*)</source>
        <translation>Transferfunktionen (*.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Save the transfer function</source>
        <translation>Transferfunktion sichern</translation>
    </message>
    <message>
        <source>Transfer functions (*.json)</source>
        <translation>Transferfunktionen (*.json)</translation>
    </message>
    <message>
        <source>Saving the transfer function</source>
        <translation>Transferfunktion sichern</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::CommandPalette</name>
    <message>
        <source>Find a command</source>
        <translation>Befehl suchen</translation>
    </message>
    <message>
        <source>Type a few letters of a command</source>
        <translation>Ein paar Buchstaben eines Befehls eingeben</translation>
    </message>
    <message>
        <source>Command to look for</source>
        <translation>Gesuchter Befehl</translation>
    </message>
    <message>
        <source>Commands found</source>
        <translation>Gefundene Befehle</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::CriteriaForm</name>
    <message>
        <source>Porosity at most</source>
        <translation>Porosität höchstens</translation>
    </message>
    <message>
        <source>Volume at most</source>
        <translation>Volumen höchstens</translation>
    </message>
    <message>
        <source>Diameter at most</source>
        <translation>Durchmesser höchstens</translation>
    </message>
    <message>
        <source>Defects at most</source>
        <translation>Fehlstellen höchstens</translation>
    </message>
    <message>
        <source>Gap at least</source>
        <translation>Abstand mindestens</translation>
    </message>
    <message>
        <source>Depth at least</source>
        <translation>Tiefe mindestens</translation>
    </message>
    <message>
        <source>Material from</source>
        <translation>Material ab</translation>
    </message>
    <message>
        <source>Material from this value on</source>
        <translation>Material ab diesem Wert</translation>
    </message>
    <message>
        <source>below</source>
        <translation>unter</translation>
    </message>
    <message>
        <source>Voids below this value</source>
        <translation>Hohlräume unter diesem Wert</translation>
    </message>
    <message>
        <source>above</source>
        <translation>über</translation>
    </message>
    <message>
        <source>Inclusions above this value</source>
        <translation>Einschlüsse über diesem Wert</translation>
    </message>
    <message>
        <source>Voids</source>
        <translation>Hohlräume</translation>
    </message>
    <message>
        <source>Inclusions</source>
        <translation>Einschlüsse</translation>
    </message>
    <message>
        <source>Unchecked: found in the histogram, at the middle of the threshold&apos;s stable plateau</source>
        <translation>Aus: im Histogramm gesucht, in der Mitte des stabilen Bereichs der Schwelle</translation>
    </message>
    <message>
        <source>Unchecked: half-way between the two sides of each boundary</source>
        <translation>Aus: auf halbem Weg zwischen den beiden Seiten jeder Grenze</translation>
    </message>
    <message>
        <source>Look for voids</source>
        <translation>Hohlräume suchen</translation>
    </message>
    <message>
        <source>Look for inclusions</source>
        <translation>Einschlüsse suchen</translation>
    </message>
    <message>
        <source>at least </source>
        <translation>mindestens </translation>
    </message>
    <message>
        <source> voxels</source>
        <translation> Voxel</translation>
    </message>
    <message>
        <source>Smallest defect, voxels</source>
        <translation>Kleinste Fehlstelle, Voxel</translation>
    </message>
    <message>
        <source>No zones</source>
        <translation>Keine Zonen</translation>
    </message>
    <message>
        <source>Zones: %1</source>
        <translation>Zonen: %1</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::CutFeature</name>
    <message>
        <source>&amp;Cutting planes</source>
        <translation>&amp;Schnittebenen</translation>
    </message>
    <message>
        <source>&amp;Add a cutting plane</source>
        <translation>Schnittebene &amp;hinzufügen</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Cut here, &amp;facing the viewer</source>
        <translation>Hier schneiden, dem &amp;Betrachter zugewandt</translation>
    </message>
    <message>
        <source>Choose the &amp;next plane</source>
        <translation>&amp;Nächste Ebene wählen</translation>
    </message>
    <message>
        <source>F&amp;lip the plane</source>
        <translation>Seite der Ebene &amp;wechseln</translation>
    </message>
    <message>
        <source>Data values on the cut face (ca&amp;p)</source>
        <translation>&amp;Messwerte auf der Schnittfläche</translation>
    </message>
    <message>
        <source>&amp;Remove the plane</source>
        <translation>Ebene &amp;entfernen</translation>
    </message>
    <message>
        <source>&amp;Move and tilt the plane</source>
        <translation>Ebene &amp;verschieben und kippen</translation>
    </message>
    <message>
        <source>Cut away &amp;more</source>
        <translation>&amp;Mehr wegschneiden</translation>
    </message>
    <message>
        <source>Cut away &amp;less</source>
        <translation>&amp;Weniger wegschneiden</translation>
    </message>
    <message>
        <source>Cut away much more</source>
        <translation>Viel mehr wegschneiden</translation>
    </message>
    <message>
        <source>Cut away much less</source>
        <translation>Viel weniger wegschneiden</translation>
    </message>
    <message>
        <source>Tilt to the left</source>
        <translation>Nach links kippen</translation>
    </message>
    <message>
        <source>Tilt to the right</source>
        <translation>Nach rechts kippen</translation>
    </message>
    <message>
        <source>Tilt up</source>
        <translation>Nach oben kippen</translation>
    </message>
    <message>
        <source>Tilt down</source>
        <translation>Nach unten kippen</translation>
    </message>
    <message>
        <source>Show a &amp;box of the volume alone</source>
        <translation>Nur einen &amp;Kasten des Volumens zeigen</translation>
    </message>
    <message>
        <source>Show &amp;handles in the 3D view</source>
        <translation>&amp;Griffe in der 3D-Ansicht zeigen</translation>
    </message>
    <message>
        <source>Move a cut</source>
        <translation>Schnitt verschieben</translation>
    </message>
    <message>
        <source>Tilt a cut</source>
        <translation>Schnitt kippen</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::CutTool</name>
    <message>
        <source>Box</source>
        <translation>Kasten</translation>
    </message>
    <message>
        <source>Tilt a cut</source>
        <translation>Schnitt kippen</translation>
    </message>
    <message>
        <source>Move a cut</source>
        <translation>Schnitt verschieben</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::CutsPanel</name>
    <message>
        <source>Add a cut</source>
        <translation>Schnitt hinzufügen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Flip side</source>
        <translation>Seite wechseln</translation>
    </message>
    <message>
        <source>Azimuth of the cut&apos;s normal</source>
        <translation>Azimut der Schnittnormale</translation>
    </message>
    <message>
        <source>Elevation of the cut&apos;s normal</source>
        <translation>Elevation der Schnittnormale</translation>
    </message>
    <message>
        <source>Distance of the cut from the centre</source>
        <translation>Abstand des Schnitts von der Mitte</translation>
    </message>
    <message>
        <source>Show data values on the cut face</source>
        <translation>Messwerte auf der Schnittfläche zeigen</translation>
    </message>
    <message>
        <source>Remove a cut</source>
        <translation>Schnitt entfernen</translation>
    </message>
    <message>
        <source>Flip a cut</source>
        <translation>Schnittseite wechseln</translation>
    </message>
    <message>
        <source>Turn a cut</source>
        <translation>Schnitt drehen</translation>
    </message>
    <message>
        <source>Tilt a cut</source>
        <translation>Schnitt kippen</translation>
    </message>
    <message>
        <source>Move a cut</source>
        <translation>Schnitt verschieben</translation>
    </message>
    <message>
        <source>Cut face</source>
        <translation>Schnittfläche</translation>
    </message>
    <message>
        <source>Switch a cut</source>
        <translation>Schnitt schalten</translation>
    </message>
    <message>
        <source>Cutting planes</source>
        <translation>Schnittebenen</translation>
    </message>
    <message>
        <source>Add a cutting plane</source>
        <translation>Schnittebene hinzufügen</translation>
    </message>
    <message>
        <source>Remove the cutting plane</source>
        <translation>Schnittebene entfernen</translation>
    </message>
    <message>
        <source>Keep the other side of the cut</source>
        <translation>Andere Seite des Schnitts behalten</translation>
    </message>
    <message>
        <source>Cut sagittally</source>
        <translation>Sagittal schneiden</translation>
    </message>
    <message>
        <source>Cut coronally</source>
        <translation>Koronal schneiden</translation>
    </message>
    <message>
        <source>Cut axially</source>
        <translation>Axial schneiden</translation>
    </message>
    <message>
        <source>Off: the cut is open and inner surfaces show</source>
        <translation>Aus: der Schnitt ist offen und innere Flächen sind zu sehen</translation>
    </message>
    <message>
        <source>Azimuth</source>
        <translation>Azimut</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>Elevation</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>Cut %1</source>
        <translation>Schnitt %1</translation>
    </message>
    <message>
        <source>Cut along %1</source>
        <translation>Entlang %1 schneiden</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::DefectModel</name>
    <message>
        <source>Id</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Number of the defect, by descending volume</source>
        <translation>Nummer der Fehlstelle, nach fallendem Volumen</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Void or inclusion</source>
        <translation>Hohlraum oder Einschluss</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>Held against the limits, or decided by hand</source>
        <translation>An den Grenzwerten gemessen oder von Hand entschieden</translation>
    </message>
    <message>
        <source>Volume mm³</source>
        <translation>Volumen mm³</translation>
    </message>
    <message>
        <source>From grey values, below the size of a voxel</source>
        <translation>Aus Grauwerten, feiner als ein Voxel</translation>
    </message>
    <message>
        <source>Voxels</source>
        <translation>Voxel</translation>
    </message>
    <message>
        <source>Number of voxels</source>
        <translation>Zahl der Voxel</translation>
    </message>
    <message>
        <source>Diameter mm</source>
        <translation>Durchmesser mm</translation>
    </message>
    <message>
        <source>Of the circumscribed sphere</source>
        <translation>Der umschriebenen Kugel</translation>
    </message>
    <message>
        <source>Eq. diameter mm</source>
        <translation>Äq. Durchmesser mm</translation>
    </message>
    <message>
        <source>Of the ball of equal volume</source>
        <translation>Der Kugel gleichen Volumens</translation>
    </message>
    <message>
        <source>Depth mm</source>
        <translation>Tiefe mm</translation>
    </message>
    <message>
        <source>Distance to the part&apos;s surface</source>
        <translation>Abstand zur Oberfläche des Teils</translation>
    </message>
    <message>
        <source>Gap mm</source>
        <translation>Abstand mm</translation>
    </message>
    <message>
        <source>To the next defect</source>
        <translation>Zur nächsten Fehlstelle</translation>
    </message>
    <message>
        <source>Sphericity</source>
        <translation>Sphärizität</translation>
    </message>
    <message>
        <source>1 for a ball</source>
        <translation>1 für eine Kugel</translation>
    </message>
    <message>
        <source>Probability</source>
        <translation>Wahrscheinlichkeit</translation>
    </message>
    <message>
        <source>That it is a defect and no noise</source>
        <translation>Dass es eine Fehlstelle und kein Rauschen ist</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Mean value</source>
        <translation>Mittlerer Wert</translation>
    </message>
    <message>
        <source>Cavities</source>
        <translation>Höhlen</translation>
    </message>
    <message>
        <source>Closed cavities inside</source>
        <translation>Geschlossene Höhlen im Inneren</translation>
    </message>
    <message>
        <source>Tunnels</source>
        <translation>Tunnel</translation>
    </message>
    <message>
        <source>Handles through it</source>
        <translation>Durchgänge</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>Warum</translation>
    </message>
    <message>
        <source>What decided the verdict</source>
        <translation>Was das Urteil entschied</translation>
    </message>
    <message>
        <source>void</source>
        <translation>Hohlraum</translation>
    </message>
    <message>
        <source>inclusion</source>
        <translation>Einschluss</translation>
    </message>
    <message>
        <source>pass</source>
        <translation>gut</translation>
    </message>
    <message>
        <source>fail</source>
        <translation>schlecht</translation>
    </message>
    <message>
        <source>cannot tell</source>
        <translation>unentschieden</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>not measurable</source>
        <translation>nicht messbar</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::DicomBrowser</name>
    <message>
        <source>Patient %1</source>
        <translation>Patient %1</translation>
    </message>
    <message>
        <source>(no name)</source>
        <translation>(ohne Namen)</translation>
    </message>
    <message>
        <source>(study without a description)</source>
        <translation>(Studie ohne Beschreibung)</translation>
    </message>
    <message>
        <source>(no description)</source>
        <translation>(ohne Beschreibung)</translation>
    </message>
    <message>
        <source>DICOM browser</source>
        <translation>DICOM-Browser</translation>
    </message>
    <message>
        <source>Folder or DICOMDIR</source>
        <translation>Ordner oder DICOMDIR</translation>
    </message>
    <message>
        <source>Choose a folder or a DICOMDIR</source>
        <translation>Einen Ordner oder ein DICOMDIR wählen</translation>
    </message>
    <message>
        <source>&amp;Folder…</source>
        <translation>&amp;Ordner…</translation>
    </message>
    <message>
        <source>DICOM&amp;DIR…</source>
        <translation>DICOM&amp;DIR…</translation>
    </message>
    <message>
        <source>Reads the directory of a disc or stick instead of every file on it</source>
        <translation>Liest das Verzeichnis eines Datenträgers statt jeder Datei darauf</translation>
    </message>
    <message>
        <source>Search patients, studies and series</source>
        <translation>Patienten, Studien und Serien suchen</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suche</translation>
    </message>
    <message>
        <source>Patients, studies and series</source>
        <translation>Patienten, Studien und Serien</translation>
    </message>
    <message>
        <source>Look for DICOM in a folder</source>
        <translation>DICOM in einem Ordner suchen</translation>
    </message>
    <message>
        <source>Read a DICOMDIR</source>
        <translation>Ein DICOMDIR lesen</translation>
    </message>
    <message>
        <source>DICOMDIR (DICOMDIR dicomdir);;All files (*)</source>
        <translation>DICOMDIR (DICOMDIR dicomdir);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Looking…</source>
        <translation>Wird gesucht…</translation>
    </message>
    <message>
        <source>Looking for DICOM</source>
        <translation>DICOM wird gesucht</translation>
    </message>
    <message>
        <source>Stopped; this is what was found until then.</source>
        <translation>Angehalten; das wurde bis dahin gefunden.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message numerus="yes">
        <source>%n series</source>
        <translation>
            <numerusform>%n Serie</numerusform>
            <numerusform>%n Serien</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source> in %n files</source>
        <translation>
            <numerusform> in %n Datei</numerusform>
            <numerusform> in %n Dateien</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>; %n cannot be read</source>
        <translation>
            <numerusform>; %n ist nicht lesbar</numerusform>
            <numerusform>; %n sind nicht lesbar</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>; %n named in the directory are missing</source>
        <translation>
            <numerusform>; %n im Verzeichnis genannte fehlt</numerusform>
            <numerusform>; %n im Verzeichnis genannte fehlen</numerusform>
        </translation>
    </message>
    <message>
        <source> so far…</source>
        <translation> bisher…</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::EffectsPanel</name>
    <message>
        <source>Strength</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Strahlen</translation>
    </message>
    <message>
        <source>Focus</source>
        <translation>Schärfe</translation>
    </message>
    <message>
        <source>Dimming</source>
        <translation>Abdunkeln</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Weiß</translation>
    </message>
    <message>
        <source>Gamma</source>
        <translation>Gamma</translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation>Helligkeit</translation>
    </message>
    <message>
        <source>Contrast</source>
        <translation>Kontrast</translation>
    </message>
    <message>
        <source>Ambient occlusion, of the screen</source>
        <translation>Umgebungsverdeckung, vom Bild</translation>
    </message>
    <message>
        <source>Darkens creases seen in the depth image</source>
        <translation>Dunkelt Falten, die im Tiefenbild zu sehen sind</translation>
    </message>
    <message>
        <source>Ambient occlusion, of the volume</source>
        <translation>Umgebungsverdeckung, vom Volumen</translation>
    </message>
    <message>
        <source>Share of the hemisphere that is blocked, by rays through the volume; takes its time</source>
        <translation>Verdeckter Anteil der Halbkugel, durch Strahlen im Volumen; braucht seine Zeit</translation>
    </message>
    <message>
        <source>Depth of field</source>
        <translation>Tiefenschärfe</translation>
    </message>
    <message>
        <source>Blurs by distance from the focal plane</source>
        <translation>Verwischt nach dem Abstand von der Schärfeebene</translation>
    </message>
    <message>
        <source>Tone mapping</source>
        <translation>Tonwertabbildung</translation>
    </message>
    <message>
        <source>Compresses what is bright</source>
        <translation>Staucht das Helle</translation>
    </message>
    <message>
        <source>Colour to the power of one over gamma</source>
        <translation>Farbe hoch eins durch Gamma</translation>
    </message>
    <message>
        <source>Added to every colour</source>
        <translation>Zu jeder Farbe addiert</translation>
    </message>
    <message>
        <source>A factor about mid grey</source>
        <translation>Ein Faktor um mittleres Grau</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::ErrorBadge</name>
    <message>
        <source>early termination</source>
        <translation>früher Abbruch</translation>
    </message>
    <message>
        <source>another step</source>
        <translation>anderer Schritt</translation>
    </message>
    <message>
        <source>nearest voxels</source>
        <translation>nächste Voxel</translation>
    </message>
    <message>
        <source>sparse casting</source>
        <translation>dünne Abtastung</translation>
    </message>
    <message>
        <source>thresholds of homogeneity</source>
        <translation>Schwellen der Homogenität</translation>
    </message>
    <message>
        <source>quantised leaps</source>
        <translation>gerundete Sprünge</translation>
    </message>
    <message>
        <source>stored gradients</source>
        <translation>gespeicherte Gradienten</translation>
    </message>
    <message>
        <source>another gradient</source>
        <translation>anderer Gradient</translation>
    </message>
    <message>
        <source>another refinement</source>
        <translation>andere Verfeinerung</translation>
    </message>
    <message>
        <source>integrated segments</source>
        <translation>integrierte Abschnitte</translation>
    </message>
    <message>
        <source>shear-warp has no brute force</source>
        <translation>Shear-Warp hat keine volle Rechnung</translation>
    </message>
    <message>
        <source>not a number</source>
        <translation>keine Zahl</translation>
    </message>
    <message>
        <source>exact: same samples as brute force</source>
        <translation>exakt: dieselben Abtastpunkte wie die volle Rechnung</translation>
    </message>
    <message>
        <source>at most %1/255, by early termination&apos;s bound</source>
        <translation>höchstens %1/255, durch die Schranke des frühen Abbruchs</translation>
    </message>
    <message>
        <source>measured %1/255 on this view</source>
        <translation>gemessen %1/255 in dieser Ansicht</translation>
    </message>
    <message>
        <source>error unknown: %1</source>
        <translation>Fehler unbekannt: %1</translation>
    </message>
    <message>
        <source>Error of the 3D picture</source>
        <translation>Fehler des 3D-Bilds</translation>
    </message>
    <message>
        <source>coarse while moving</source>
        <translation>grob in Bewegung</translation>
    </message>
    <message>
        <source>measuring: %1</source>
        <translation>wird gemessen: %1</translation>
    </message>
    <message>
        <source>still the picture before; drawing…</source>
        <translation>noch das Bild davor; wird gezeichnet…</translation>
    </message>
    <message>
        <source>still the picture before; this one was not drawn</source>
        <translation>noch das Bild davor; dieses wurde nicht gezeichnet</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::ExportFeature</name>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Ausgeben</translation>
    </message>
    <message>
        <source>&amp;Picture of the view…</source>
        <translation>&amp;Bild der Ansicht…</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Picture &amp;without words and marks…</source>
        <translation>Bild &amp;ohne Texte und Zeichen…</translation>
    </message>
    <message>
        <source>&amp;Turntable…</source>
        <translation>&amp;Drehteller…</translation>
    </message>
    <message>
        <source>Save a turntable</source>
        <translation>Drehteller sichern</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Bilder (*.png)</translation>
    </message>
    <message>
        <source>Pictures (*.png);;Films (*.mp4 *.webm)</source>
        <translation>Bilder (*.png);;Filme (*.mp4 *.webm)</translation>
    </message>
    <message>
        <source>Turntable</source>
        <translation>Drehteller</translation>
    </message>
    <message>
        <source>Pictures a turn</source>
        <translation>Bilder je Umdrehung</translation>
    </message>
    <message>
        <source>&amp;Surface of the isovalue…</source>
        <translation>&amp;Fläche des Isowerts…</translation>
    </message>
    <message>
        <source>Save the surface</source>
        <translation>Fläche sichern</translation>
    </message>
    <message>
        <source>Meshes (*.stl *.ply *.obj *.vtp)</source>
        <translation>Netze (*.stl *.ply *.obj *.vtp)</translation>
    </message>
    <message>
        <source>&amp;Volume…</source>
        <translation>&amp;Volumen…</translation>
    </message>
    <message>
        <source>Save the volume</source>
        <translation>Volumen sichern</translation>
    </message>
    <message>
        <source>Volumes (*.nrrd *.mhd *.nii.gz *.nii *.raw)</source>
        <translation>Volumen (*.nrrd *.mhd *.nii.gz *.nii *.raw)</translation>
    </message>
    <message>
        <source>&amp;Copy the view</source>
        <translation>Ansicht &amp;kopieren</translation>
    </message>
    <message>
        <source>Pictures (*.png *.tif)</source>
        <translation>Bilder (*.png *.tif)</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Bild sichern</translation>
    </message>
    <message>
        <source>Saving the picture</source>
        <translation>Bild wird gesichert</translation>
    </message>
    <message>
        <source>Drawing a turntable</source>
        <translation>Drehteller wird gezeichnet</translation>
    </message>
    <message>
        <source>Saving the surface</source>
        <translation>Fläche wird gesichert</translation>
    </message>
    <message>
        <source>Saving the volume</source>
        <translation>Volumen wird gesichert</translation>
    </message>
    <message>
        <source>A picture&apos;s name ends in .png, .tif or .tiff.</source>
        <translation>Der Name eines Bildes endet auf .png, .tif oder .tiff.</translation>
    </message>
    <message>
        <source>The picture could not be packed: %1.</source>
        <translation>Das Bild konnte nicht gepackt werden: %1.</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::FileWrites</name>
    <message>
        <source>Written to %1.</source>
        <translation>Geschrieben nach %1.</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::FrameScheduler</name>
    <message>
        <source>%1 · %2 · step %3</source>
        <translation>%1 · %2 · Schritt %3</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::GradientPage</name>
    <message>
        <source>O&amp;pacity by gradient</source>
        <translation>Deckkraft nach Grad&amp;ient</translation>
    </message>
    <message>
        <source>Multiplies the opacity by a factor that depends on how fast the values change: surfaces stand out, even regions fade.</source>
        <translation>Multipliziert die Deckkraft mit einem Faktor, der davon abhängt, wie schnell sich die Werte ändern: Flächen treten hervor, gleichmäßige Bereiche verblassen.</translation>
    </message>
    <message>
        <source>Gradient opacity</source>
        <translation>Deckkraft nach Gradient</translation>
    </message>
    <message>
        <source>Factor on the opacity by gradient magnitude · drag points · double click adds one · Delete removes it · wheel zooms the axis</source>
        <translation>Faktor der Deckkraft nach Gradientenbetrag · Punkte ziehen · Doppelklick fügt einen hinzu · Entf entfernt ihn · Rad vergrößert die Achse</translation>
    </message>
    <message>
        <source>Opacity by gradient</source>
        <translation>Deckkraft nach Gradient</translation>
    </message>
    <message>
        <source>No opacity by gradient</source>
        <translation>Keine Deckkraft nach Gradient</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::HandFeature</name>
    <message>
        <source>Turn freel&amp;y (arcball)</source>
        <translation>&amp;Frei drehen (Arcball)</translation>
    </message>
    <message>
        <source>Le&amp;vels of the 3D view</source>
        <translation>&amp;Pegel der 3D-Ansicht</translation>
    </message>
    <message>
        <source>&amp;Lower: more is seen</source>
        <translation>&amp;Tiefer: mehr ist zu sehen</translation>
    </message>
    <message>
        <source>&amp;Higher: less is seen</source>
        <translation>&amp;Höher: weniger ist zu sehen</translation>
    </message>
    <message>
        <source>&amp;Wider</source>
        <translation>&amp;Weiter</translation>
    </message>
    <message>
        <source>&amp;Narrower</source>
        <translation>&amp;Enger</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>Pegel</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::HelpFeature</name>
    <message>
        <source>&amp;Find a command…</source>
        <translation>Befehl &amp;suchen…</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Befehle</translation>
    </message>
    <message>
        <source>&amp;Keys and mouse…</source>
        <translation>&amp;Tasten und Maus…</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>&amp;Log…</source>
        <translation>&amp;Protokoll…</translation>
    </message>
    <message>
        <source>&amp;About Lacuna…</source>
        <translation>Ü&amp;ber Lacuna…</translation>
    </message>
    <message>
        <source>being looked for</source>
        <translation>wird gesucht</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::ImportFeature</name>
    <message>
        <source>&amp;DICOM browser…</source>
        <translation>&amp;DICOM-Browser…</translation>
    </message>
    <message>
        <source>&amp;Import a raw volume…</source>
        <translation>&amp;Rohdaten einlesen…</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Ausgeben</translation>
    </message>
    <message>
        <source>&amp;Anonymised DICOM…</source>
        <translation>&amp;Anonymisiertes DICOM…</translation>
    </message>
    <message>
        <source>The images of the open series without the patient&apos;s data, as PS3.15 describes it</source>
        <translation>Die Bilder der offenen Serie ohne die Daten des Patienten, wie PS3.15 es beschreibt</translation>
    </message>
    <message>
        <source>Import a raw volume</source>
        <translation>Rohdaten einlesen</translation>
    </message>
    <message>
        <source>Raw volumes (*.raw *.img *.vol *.bin *.dat);;All files (*)</source>
        <translation>Rohdaten (*.raw *.img *.vol *.bin *.dat);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>New folder for the anonymised images</source>
        <translation>Neuer Ordner für die anonymisierten Bilder</translation>
    </message>
    <message>
        <source>Anonymising</source>
        <translation>Wird anonymisiert</translation>
    </message>
    <message numerus="yes">
        <source>%n anonymised images were written.</source>
        <translation>
            <numerusform>%n anonymisiertes Bild wurde geschrieben.</numerusform>
            <numerusform>%n anonymisierte Bilder wurden geschrieben.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>lacuna::ui::InspectionFeature</name>
    <message>
        <source>Inspection</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>&amp;Inspect the part</source>
        <translation>Teil &amp;prüfen</translation>
    </message>
    <message>
        <source>Inspect</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Ausgeben</translation>
    </message>
    <message>
        <source>&amp;Inspection report…</source>
        <translation>&amp;Prüfbericht…</translation>
    </message>
    <message>
        <source>Inspecting</source>
        <translation>Prüfung läuft</translation>
    </message>
    <message>
        <source>Load criteria</source>
        <translation>Kriterien laden</translation>
    </message>
    <message>
        <source>Criteria (*.json);;All files (*)</source>
        <translation>Kriterien (*.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Save the criteria</source>
        <translation>Kriterien sichern</translation>
    </message>
    <message>
        <source>Criteria (*.json)</source>
        <translation>Kriterien (*.json)</translation>
    </message>
    <message>
        <source>Write the report to a new folder</source>
        <translation>Bericht in einen neuen Ordner schreiben</translation>
    </message>
    <message>
        <source>Folders (*)</source>
        <translation>Ordner (*)</translation>
    </message>
    <message>
        <source>Writing the report</source>
        <translation>Bericht wird geschrieben</translation>
    </message>
    <message>
        <source>The report stands in %1.</source>
        <translation>Der Bericht steht in %1.</translation>
    </message>
    <message>
        <source>Saving the criteria</source>
        <translation>Kriterien sichern</translation>
    </message>
    <message>
        <source>Open the report</source>
        <translation>Bericht öffnen</translation>
    </message>
    <message>
        <source>The settings were changed since the part was inspected: inspect it again, then write the report.</source>
        <translation>Die Einstellungen wurden seit der Prüfung des Teils geändert: Bitte noch einmal prüfen und dann den Bericht schreiben.</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::InspectionPanel</name>
    <message>
        <source>Inspect</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Load criteria…</source>
        <translation>Kriterien laden…</translation>
    </message>
    <message>
        <source>Save criteria…</source>
        <translation>Kriterien sichern…</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Bericht…</translation>
    </message>
    <message>
        <source>Accept…</source>
        <translation>Annehmen…</translation>
    </message>
    <message>
        <source>Reject…</source>
        <translation>Ablehnen…</translation>
    </message>
    <message>
        <source>Undecide</source>
        <translation>Zurücknehmen</translation>
    </message>
    <message>
        <source>Inspect the part</source>
        <translation>Teil prüfen</translation>
    </message>
    <message>
        <source>Load criteria from a file</source>
        <translation>Kriterien aus einer Datei laden</translation>
    </message>
    <message>
        <source>Save the criteria as a file</source>
        <translation>Kriterien als Datei sichern</translation>
    </message>
    <message>
        <source>Write the report folder</source>
        <translation>Ordner mit dem Bericht schreiben</translation>
    </message>
    <message>
        <source>Accept the chosen defect by hand</source>
        <translation>Gewählte Fehlstelle von Hand annehmen</translation>
    </message>
    <message>
        <source>Reject the part for the chosen defect</source>
        <translation>Teil wegen der gewählten Fehlstelle ablehnen</translation>
    </message>
    <message>
        <source>Take the decision by hand back</source>
        <translation>Entscheidung von Hand zurücknehmen</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>Filter: fail, void, diameter &gt; 0.5</source>
        <translation>Filter: schlecht, Hohlraum, Durchmesser &gt; 0,5</translation>
    </message>
    <message>
        <source>Filter of the defect table</source>
        <translation>Filter der Fehlstellentabelle</translation>
    </message>
    <message>
        <source>Colour by verdict</source>
        <translation>Farbe nach Urteil</translation>
    </message>
    <message>
        <source>Colour by size</source>
        <translation>Farbe nach Größe</translation>
    </message>
    <message>
        <source>Colour by depth</source>
        <translation>Farbe nach Tiefe</translation>
    </message>
    <message>
        <source>What the defects&apos; colours tell</source>
        <translation>Was die Farben der Fehlstellen sagen</translation>
    </message>
    <message>
        <source>Defects</source>
        <translation>Fehlstellen</translation>
    </message>
    <message>
        <source>Criteria</source>
        <translation>Kriterien</translation>
    </message>
    <message>
        <source>Inspecting…</source>
        <translation>Prüfung läuft…</translation>
    </message>
    <message>
        <source>Not inspected</source>
        <translation>Nicht geprüft</translation>
    </message>
    <message>
        <source>Pass</source>
        <translation>Gut</translation>
    </message>
    <message>
        <source>Fail</source>
        <translation>Schlecht</translation>
    </message>
    <message>
        <source>Cannot tell</source>
        <translation>Unentschieden</translation>
    </message>
    <message>
        <source>%1 (of the settings before; inspect again)</source>
        <translation>%1 (mit den vorigen Einstellungen; erneut prüfen)</translation>
    </message>
    <message numerus="yes">
        <source>%n defect(s)</source>
        <translation>
            <numerusform>%n Fehlstelle</numerusform>
            <numerusform>%n Fehlstellen</numerusform>
        </translation>
    </message>
    <message>
        <source>Porosity %1 % (%2 to %3)</source>
        <translation>Porosität %1 % (%2 bis %3)</translation>
    </message>
    <message numerus="yes">
        <source>%n decided by hand</source>
        <translation>
            <numerusform>%n von Hand entschieden</numerusform>
            <numerusform>%n von Hand entschieden</numerusform>
        </translation>
    </message>
    <message>
        <source>Accept defect %1</source>
        <translation>Fehlstelle %1 annehmen</translation>
    </message>
    <message>
        <source>Reject defect %1</source>
        <translation>Fehlstelle %1 ablehnen</translation>
    </message>
    <message>
        <source>Reason (kept in the report):</source>
        <translation>Grund (steht im Bericht):</translation>
    </message>
    <message>
        <source>Meanwhile other defects were found, which have other numbers; choose the defect again.</source>
        <translation>Inzwischen wurden andere Fehlstellen gefunden, die andere Nummern haben; wählen Sie die Fehlstelle noch einmal.</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::LayoutFeature</name>
    <message>
        <source>&amp;Reset the layout</source>
        <translation>Anordnung &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>&amp;Arrangement</source>
        <translation>A&amp;nordnung</translation>
    </message>
    <message>
        <source>&amp;Four views</source>
        <translation>&amp;Vier Ansichten</translation>
    </message>
    <message>
        <source>Four</source>
        <translation>Vier</translation>
    </message>
    <message>
        <source>&amp;Large 3D view and three slices</source>
        <translation>&amp;Große 3D-Ansicht und drei Schichten</translation>
    </message>
    <message>
        <source>One and three</source>
        <translation>Eins und drei</translation>
    </message>
    <message>
        <source>&amp;One view</source>
        <translation>&amp;Eine Ansicht</translation>
    </message>
    <message>
        <source>One</source>
        <translation>Eine</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Farbschema</translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation>Wie das &amp;System</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Dunkel</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::LimitsFeature</name>
    <message>
        <source>Refused</source>
        <translation>Abgelehnt</translation>
    </message>
    <message>
        <source>Detected</source>
        <translation>Erkannt</translation>
    </message>
    <message>
        <source>Corrected</source>
        <translation>Berichtigt</translation>
    </message>
    <message>
        <source>Bounded</source>
        <translation>Begrenzt</translation>
    </message>
    <message>
        <source>What is done:</source>
        <translation>Was getan wird:</translation>
    </message>
    <message>
        <source>How far off:</source>
        <translation>Wie weit daneben:</translation>
    </message>
    <message>
        <source>Where this method fails</source>
        <translation>Wo dieses Verfahren versagt</translation>
    </message>
    <message>
        <source>Where this &amp;method fails</source>
        <translation>Wo dieses &amp;Verfahren versagt</translation>
    </message>
    <message>
        <source>Looking at what of this the volume holds…</source>
        <translation>Es wird nachgesehen, was davon das Volumen hat…</translation>
    </message>
    <message>
        <source>The scene on screen meets none of these failures, as far as facts about its voxels tell.</source>
        <translation>Die gezeigte Szene trifft keinen dieser Fälle, soweit Tatsachen über ihre Voxel es sagen.</translation>
    </message>
    <message>
        <source>Known of this way of drawing, and not met here:</source>
        <translation>Von dieser Art zu zeichnen bekannt und hier nicht getroffen:</translation>
    </message>
    <message numerus="yes">
        <source>The scene on screen meets %n of these failures:</source>
        <translation>
            <numerusform>Auf die gezeigte Szene trifft %n dieser Fälle zu:</numerusform>
            <numerusform>Auf die gezeigte Szene treffen %n dieser Fälle zu:</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>lacuna::ui::LoadController</name>
    <message>
        <source>lacuna render draws large volumes in .raw and .mhd from disk.</source>
        <translation>lacuna render zeichnet große Volumen in .raw und .mhd von der Platte.</translation>
    </message>
    <message>
        <source>This limit is that of the settings, page Computing.</source>
        <translation>Diese Grenze steht in den Einstellungen, Seite Rechnen.</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::LogStore</name>
    <message>
        <source>detail</source>
        <translation>Einzelheit</translation>
    </message>
    <message>
        <source>note</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>error</source>
        <translation>Fehler</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::LogWindow</name>
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Least level shown</source>
        <translation>Niedrigste gezeigte Stufe</translation>
    </message>
    <message>
        <source>Nothing was logged yet.</source>
        <translation>Noch wurde nichts protokolliert.</translation>
    </message>
    <message>
        <source>&amp;From level</source>
        <translation>&amp;Ab Stufe</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>Copy the log</source>
        <translation>Protokoll kopieren</translation>
    </message>
    <message>
        <source>C&amp;lear</source>
        <translation>&amp;Leeren</translation>
    </message>
    <message>
        <source>Clear the log</source>
        <translation>Protokoll leeren</translation>
    </message>
    <message>
        <source>Close the log</source>
        <translation>Protokoll schließen</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::MainWindow</name>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Open &amp;folder…</source>
        <translation>Or&amp;dner öffnen…</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>&amp;Open file…</source>
        <translation>Datei ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Open &amp;sample</source>
        <translation>&amp;Beispiel öffnen</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Rückgängig: %1</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Wiederholen: %1</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Vor</translation>
    </message>
    <message>
        <source>View &amp;mode</source>
        <translation>Darstellungs&amp;art</translation>
    </message>
    <message>
        <source>View mode</source>
        <translation>Darstellungsart</translation>
    </message>
    <message>
        <source>&amp;Look from</source>
        <translation>&amp;Blick von</translation>
    </message>
    <message>
        <source>&amp;Reset the 3D view</source>
        <translation>3D-Ansicht &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Reset the &amp;slices</source>
        <translation>Schi&amp;chten zurücksetzen</translation>
    </message>
    <message>
        <source>&amp;Perspective</source>
        <translation>&amp;Perspektive</translation>
    </message>
    <message>
        <source>Ma&amp;ximise the view, or show all</source>
        <translation>Ansicht ma&amp;ximieren oder alle zeigen</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>&amp;Vollbild</translation>
    </message>
    <message>
        <source>&amp;3D view</source>
        <translation>&amp;3D-Ansicht</translation>
    </message>
    <message>
        <source>&amp;Axial slice</source>
        <translation>&amp;Axiale Schicht</translation>
    </message>
    <message>
        <source>&amp;Coronal slice</source>
        <translation>&amp;Koronale Schicht</translation>
    </message>
    <message>
        <source>&amp;Sagittal slice</source>
        <translation>&amp;Sagittale Schicht</translation>
    </message>
    <message>
        <source>C&amp;olours</source>
        <translation>&amp;Farben</translation>
    </message>
    <message>
        <source>&amp;Ranges</source>
        <translation>&amp;Bereiche</translation>
    </message>
    <message>
        <source>C&amp;uts</source>
        <translation>S&amp;chnitte</translation>
    </message>
    <message>
        <source>&amp;Grey levels</source>
        <translation>&amp;Grauwerte</translation>
    </message>
    <message>
        <source>Region &amp;table</source>
        <translation>&amp;Regionentabelle</translation>
    </message>
    <message>
        <source>Add a segmentation &amp;range</source>
        <translation>Segmentierungs&amp;bereich hinzufügen</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>Open a folder of DICOM files or TIFF slices</source>
        <translation>Ordner mit DICOM-Dateien oder TIFF-Schichten öffnen</translation>
    </message>
    <message>
        <source>Open a volume</source>
        <translation>Volumen öffnen</translation>
    </message>
    <message>
        <source>Volumes and sessions (*.dcm *.mhd *.mha *.nrrd *.nhdr *.nii *.nii.gz *.hdr *.raw *.img *.vol *.dat *.vgi *.tif *.tiff *.lacuna);;All files (*)</source>
        <translation>Volumen und Sitzungen (*.dcm *.mhd *.mha *.nrrd *.nhdr *.nii *.nii.gz *.hdr *.raw *.img *.vol *.dat *.vgi *.tif *.tiff *.lacuna);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Scene settings</source>
        <translation>Einstellungen der Szene</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Ranges</source>
        <translation>Bereiche</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>Schnitte</translation>
    </message>
    <message>
        <source>Grey levels</source>
        <translation>Grauwerte</translation>
    </message>
    <message>
        <source>Effects</source>
        <translation>Effekte</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>Looking for a device…</source>
        <translation>Ein Gerät wird gesucht…</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>Wird geöffnet</translation>
    </message>
    <message>
        <source>Opening was cancelled.</source>
        <translation>Das Öffnen wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Window and level</source>
        <translation>Fensterung</translation>
    </message>
    <message>
        <source>Rendering</source>
        <translation>Bild wird berechnet</translation>
    </message>
    <message>
        <source> (and %1 more notes)</source>
        <translation> (und %1 weitere Hinweise)</translation>
    </message>
    <message>
        <source>%1 at %2  %3  %4 mm · voxel %5, %6, %7</source>
        <translation>%1 bei %2  %3  %4 mm · Voxel %5, %6, %7</translation>
    </message>
    <message>
        <source>no value</source>
        <translation>kein Wert</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Ausgeben</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>These are slices: their whole folder is opened.</source>
        <translation>Das sind Schichten: Ihr ganzer Ordner wird geöffnet.</translation>
    </message>
    <message numerus="yes">
        <source>One thing is open at a time: %n others are left out.</source>
        <translation>
            <numerusform>Offen ist nur eines: %n anderes bleibt weg.</numerusform>
            <numerusform>Offen ist nur eines: %n andere bleiben weg.</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;XY slice</source>
        <translation>&amp;XY-Schicht</translation>
    </message>
    <message>
        <source>X&amp;Z slice</source>
        <translation>X&amp;Z-Schicht</translation>
    </message>
    <message>
        <source>&amp;YZ slice</source>
        <translation>&amp;YZ-Schicht</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::MeasureFeature</name>
    <message>
        <source>Measurements</source>
        <translation>Messungen</translation>
    </message>
    <message>
        <source>&amp;Cross-hair</source>
        <translation>&amp;Fadenkreuz</translation>
    </message>
    <message>
        <source>&amp;Distance</source>
        <translation>&amp;Abstand</translation>
    </message>
    <message>
        <source>A&amp;ngle</source>
        <translation>&amp;Winkel</translation>
    </message>
    <message>
        <source>&amp;Rectangle</source>
        <translation>&amp;Rechteck</translation>
    </message>
    <message>
        <source>&amp;Ellipse</source>
        <translation>&amp;Ellipse</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Re&amp;move the measurement</source>
        <translation>&amp;Messung entfernen</translation>
    </message>
    <message>
        <source>Remove &amp;all measurements</source>
        <translation>A&amp;lle Messungen entfernen</translation>
    </message>
    <message>
        <source>Cop&amp;y the table</source>
        <translation>Tabelle &amp;kopieren</translation>
    </message>
    <message>
        <source>E&amp;xport the table…</source>
        <translation>Tabelle &amp;ausgeben…</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>tilted</source>
        <translation>gekippt</translation>
    </message>
    <message>
        <source>%1 mm²</source>
        <translation>%1 mm²</translation>
    </message>
    <message>
        <source>Remove all measurements</source>
        <translation>Alle Messungen entfernen</translation>
    </message>
    <message numerus="yes">
        <source>The table of %n measurement(s) is on the clipboard.</source>
        <translation>
            <numerusform>Die Tabelle von %n Messung ist in der Zwischenablage.</numerusform>
            <numerusform>Die Tabelle von %n Messungen ist in der Zwischenablage.</numerusform>
        </translation>
    </message>
    <message>
        <source>There is nothing measured yet; choose what to draw in this menu.</source>
        <translation>Noch ist nichts gemessen; in diesem Menü wählen, was gezeichnet wird.</translation>
    </message>
    <message>
        <source>Export the measurements</source>
        <translation>Messungen ausgeben</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>Writing the measurements</source>
        <translation>Schreiben der Messungen</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::MeasurePanel</name>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>K&amp;opieren</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>Au&amp;sgeben…</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Messungen</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Slice</source>
        <translation>Schicht</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Stddev</source>
        <translation>Std.-Abw.</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Minimum</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>Pixels</source>
        <translation>Pixel</translation>
    </message>
    <message>
        <source>Removes the chosen measurement</source>
        <translation>Entfernt die gewählte Messung</translation>
    </message>
    <message>
        <source>Copies the table to the clipboard, for a spreadsheet</source>
        <translation>Kopiert die Tabelle in die Zwischenablage, für eine Tabellenkalkulation</translation>
    </message>
    <message>
        <source>Writes the table as CSV</source>
        <translation>Schreibt die Tabelle als CSV</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::MessageBar</name>
    <message>
        <source>Message</source>
        <translation>Meldung</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Dismiss the message</source>
        <translation>Meldung schließen</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::OptionalValue</name>
    <message>
        <source>%1, value</source>
        <translation>%1, Wert</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::PacsDialog</name>
    <message>
        <source>DICOM servers (PACS)</source>
        <translation>DICOM-Server (PACS)</translation>
    </message>
    <message>
        <source>Patient / series</source>
        <translation>Patient / Serie</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Beschreibung</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Studies found</source>
        <translation>Gefundene Studien</translation>
    </message>
    <message>
        <source>What happened last</source>
        <translation>Was zuletzt geschah</translation>
    </message>
    <message>
        <source>&amp;Retrieve and open…</source>
        <translation>H&amp;olen und öffnen…</translation>
    </message>
    <message>
        <source>Send &amp;files…</source>
        <translation>Date&amp;ien senden…</translation>
    </message>
    <message>
        <source>Sends DICOM files, such as segmentations, reports and captures, to the server (C-STORE)</source>
        <translation>Sendet DICOM-Dateien wie Segmentierungen, Berichte und Aufnahmen an den Server (C-STORE)</translation>
    </message>
    <message>
        <source>Ser&amp;ver</source>
        <translation>Ser&amp;ver</translation>
    </message>
    <message>
        <source>Server</source>
        <translation>Server</translation>
    </message>
    <message>
        <source>&amp;Add…</source>
        <translation>&amp;Hinzufügen…</translation>
    </message>
    <message>
        <source>&amp;Edit…</source>
        <translation>&amp;Bearbeiten…</translation>
    </message>
    <message>
        <source>Re&amp;move</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>&amp;Test</source>
        <translation>&amp;Testen</translation>
    </message>
    <message>
        <source>Asks the server whether it is there (C-ECHO)</source>
        <translation>Fragt den Server, ob er da ist (C-ECHO)</translation>
    </message>
    <message>
        <source>Patient&apos;s &amp;name</source>
        <translation>&amp;Name des Patienten</translation>
    </message>
    <message>
        <source>Patient&apos;s &amp;ID</source>
        <translation>&amp;Kennung des Patienten</translation>
    </message>
    <message>
        <source>A&amp;ccession number</source>
        <translation>&amp;Auftragsnummer</translation>
    </message>
    <message>
        <source>Family name; * and ? stand for any letters</source>
        <translation>Familienname; * und ? als Platzhalter</translation>
    </message>
    <message>
        <source>Any date</source>
        <translation>Jedes Datum</translation>
    </message>
    <message>
        <source>Today</source>
        <translation>Heute</translation>
    </message>
    <message>
        <source>Last 7 days</source>
        <translation>Letzte 7 Tage</translation>
    </message>
    <message>
        <source>Last 30 days</source>
        <translation>Letzte 30 Tage</translation>
    </message>
    <message>
        <source>Last 12 months</source>
        <translation>Letzte 12 Monate</translation>
    </message>
    <message>
        <source>Any kind</source>
        <translation>Jede Art</translation>
    </message>
    <message>
        <source>&amp;Date</source>
        <translation>&amp;Datum</translation>
    </message>
    <message>
        <source>&amp;Kind</source>
        <translation>A&amp;rt</translation>
    </message>
    <message>
        <source>&amp;Search</source>
        <translation>&amp;Suchen</translation>
    </message>
    <message>
        <source>Add a server first.</source>
        <translation>Zuerst einen Server hinzufügen.</translation>
    </message>
    <message>
        <source>Asking…</source>
        <translation>Wird gefragt…</translation>
    </message>
    <message>
        <source>Testing a DICOM server</source>
        <translation>DICOM-Server wird getestet</translation>
    </message>
    <message>
        <source>The server is there and accepts this program.</source>
        <translation>Der Server ist da und nimmt dieses Programm an.</translation>
    </message>
    <message>
        <source>Searching…</source>
        <translation>Wird gesucht…</translation>
    </message>
    <message>
        <source>Searching a DICOM server</source>
        <translation>DICOM-Server wird durchsucht</translation>
    </message>
    <message>
        <source>Patient %1</source>
        <translation>Patient %1</translation>
    </message>
    <message numerus="yes">
        <source>%n studies found.</source>
        <translation>
            <numerusform>%n Studie gefunden.</numerusform>
            <numerusform>%n Studien gefunden.</numerusform>
        </translation>
    </message>
    <message>
        <source> There are more; narrow the search.</source>
        <translation> Es gibt mehr; die Suche enger fassen.</translation>
    </message>
    <message>
        <source>Asking for the series of a study</source>
        <translation>Serien einer Studie werden erfragt</translation>
    </message>
    <message>
        <source>Series %1</source>
        <translation>Serie %1</translation>
    </message>
    <message>
        <source>Folder to retrieve into</source>
        <translation>Ordner, in den geholt wird</translation>
    </message>
    <message>
        <source>Retrieving…</source>
        <translation>Wird geholt…</translation>
    </message>
    <message>
        <source>Retrieving from a DICOM server</source>
        <translation>Wird von einem DICOM-Server geholt</translation>
    </message>
    <message numerus="yes">
        <source>%n files retrieved.</source>
        <translation>
            <numerusform>%n Datei geholt.</numerusform>
            <numerusform>%n Dateien geholt.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source> The server could not send %n.</source>
        <translation>
            <numerusform> Der Server konnte %n nicht senden.</numerusform>
            <numerusform> Der Server konnte %n nicht senden.</numerusform>
        </translation>
    </message>
    <message>
        <source>DICOM files to send</source>
        <translation>Zu sendende DICOM-Dateien</translation>
    </message>
    <message>
        <source>DICOM files (*.dcm);;All files (*)</source>
        <translation>DICOM-Dateien (*.dcm);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Sending…</source>
        <translation>Wird gesendet…</translation>
    </message>
    <message>
        <source>Sending to a DICOM server</source>
        <translation>Wird an einen DICOM-Server gesendet</translation>
    </message>
    <message numerus="yes">
        <source>%n files sent.</source>
        <translation>
            <numerusform>%n Datei gesendet.</numerusform>
            <numerusform>%n Dateien gesendet.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source> The server did not take %n.</source>
        <translation>
            <numerusform> Der Server nahm %n nicht an.</numerusform>
            <numerusform> Der Server nahm %n nicht an.</numerusform>
        </translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Abgebrochen.</translation>
    </message>
    <message>
        <source>Copies the chosen series, or the whole study, into a folder and opens it (C-GET, or C-MOVE where the server is set to)</source>
        <translation>Kopiert die gewählte Serie oder die ganze Studie in einen Ordner und öffnet sie (C-GET oder, wo der Server so eingestellt ist, C-MOVE)</translation>
    </message>
    <message>
        <source> It is not all: %1</source>
        <translation> Es ist nicht alles: %1</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::PacsFeature</name>
    <message>
        <source>DICOM ser&amp;vers (PACS)…</source>
        <translation>DICOM-Ser&amp;ver (PACS)…</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::PacsServerDialog</name>
    <message>
        <source>&amp;Secure connection (TLS)</source>
        <translation>&amp;Sichere Verbindung (TLS)</translation>
    </message>
    <message>
        <source>Trusted certificates</source>
        <translation>Vertraute Zertifikate</translation>
    </message>
    <message>
        <source>Own certificate</source>
        <translation>Eigenes Zertifikat</translation>
    </message>
    <message>
        <source>Own private key</source>
        <translation>Eigener privater Schlüssel</translation>
    </message>
    <message>
        <source>DICOM server</source>
        <translation>DICOM-Server</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>TLS 1.2 or newer with the ciphers of BCP 195</source>
        <translation>TLS 1.2 oder neuer mit den Verfahren von BCP 195</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Name</translation>
    </message>
    <message>
        <source>&amp;Host</source>
        <translation>&amp;Rechner</translation>
    </message>
    <message>
        <source>&amp;Port</source>
        <translation>&amp;Port</translation>
    </message>
    <message>
        <source>Its &amp;AE title</source>
        <translation>Sein &amp;AE-Titel</translation>
    </message>
    <message>
        <source>&amp;Our AE title</source>
        <translation>&amp;Unser AE-Titel</translation>
    </message>
    <message>
        <source>&amp;Wait at most</source>
        <translation>&amp;Höchstens warten</translation>
    </message>
    <message>
        <source>&amp;Trusted certificates</source>
        <translation>&amp;Vertraute Zertifikate</translation>
    </message>
    <message>
        <source>Own &amp;certificate</source>
        <translation>Eigenes &amp;Zertifikat</translation>
    </message>
    <message>
        <source>Own private &amp;key</source>
        <translation>Eigener privater Schlüsse&amp;l</translation>
    </message>
    <message>
        <source>PEM file</source>
        <translation>PEM-Datei</translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation>Datei wählen</translation>
    </message>
    <message>
        <source>PEM files (*.pem *.crt *.key);;All files (*)</source>
        <translation>PEM-Dateien (*.pem *.crt *.key);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>&amp;Retrieve by C-MOVE</source>
        <translation>Mit C-&amp;MOVE abrufen</translation>
    </message>
    <message>
        <source>For servers that know no C-GET: during a retrieval a port of this computer is open, which takes images from this server&apos;s AE title alone. The server has to know our AE title, the address and the port.</source>
        <translation>Für Server, die kein C-GET kennen: Während eines Abrufs ist ein Port dieses Rechners offen, der nur Bilder vom AE-Titel dieses Servers annimmt. Der Server muss unseren AE-Titel, die Adresse und den Port kennen.</translation>
    </message>
    <message>
        <source>Address to receive at</source>
        <translation>Adresse, an der empfangen wird</translation>
    </message>
    <message>
        <source>One of this computer&apos;s addresses; 127.0.0.1 takes only what comes from this computer itself</source>
        <translation>Eine der Adressen dieses Rechners; 127.0.0.1 nimmt nur an, was von diesem Rechner selbst kommt</translation>
    </message>
    <message>
        <source>Port to receive at</source>
        <translation>Port, an dem empfangen wird</translation>
    </message>
    <message>
        <source>Receive at a&amp;ddress</source>
        <translation>Empfang an A&amp;dresse</translation>
    </message>
    <message>
        <source>Recei&amp;ve at port</source>
        <translation>Empfang am P&amp;ort</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::PatientFeature</name>
    <message>
        <source>Patient &amp;data</source>
        <translation>&amp;Patientendaten</translation>
    </message>
    <message>
        <source>Names, identifiers, dates and file names in the views and the window&apos;s title</source>
        <translation>Namen, Kennungen, Daten und Dateinamen in den Ansichten und im Titel des Fensters</translation>
    </message>
    <message>
        <source>[*]Lacuna</source>
        <translation>[*]Lacuna</translation>
    </message>
    <message>
        <source>%1[*] — Lacuna</source>
        <translation>%1[*] — Lacuna</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::PickFeature</name>
    <message>
        <source>&amp;Point in the 3D view</source>
        <translation>P&amp;unkt in der 3D-Ansicht</translation>
    </message>
    <message>
        <source>&amp;Read out the point in the middle</source>
        <translation>Punkt in der Mitte &amp;ablesen</translation>
    </message>
    <message>
        <source>&amp;Slices through the point in the middle</source>
        <translation>&amp;Schichten durch den Punkt in der Mitte</translation>
    </message>
    <message>
        <source>&amp;Focus on the point in the middle</source>
        <translation>Auf den Punkt in der Mitte scharf &amp;stellen</translation>
    </message>
    <message>
        <source>&amp;Turn about the point marked</source>
        <translation>Um den markierten Punkt &amp;drehen</translation>
    </message>
    <message>
        <source>&amp;Unmark the point</source>
        <translation>&amp;Markierung löschen</translation>
    </message>
    <message>
        <source>Focus</source>
        <translation>Schärfe</translation>
    </message>
    <message>
        <source>&amp;Slices through this point</source>
        <translation>&amp;Schichten durch diesen Punkt</translation>
    </message>
    <message>
        <source>&amp;Turn about this point</source>
        <translation>Um diesen Punkt &amp;drehen</translation>
    </message>
    <message>
        <source>&amp;Focus here</source>
        <translation>Hier scharf s&amp;tellen</translation>
    </message>
    <message>
        <source>&amp;Reset the view</source>
        <translation>Ansicht &amp;zurücksetzen</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::PicturePreview</name>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::PointFields</name>
    <message>
        <source>Colour…</source>
        <translation>Farbe…</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Value of the selected point</source>
        <translation>Wert des gewählten Punkts</translation>
    </message>
    <message>
        <source>Opacity of the selected point</source>
        <translation>Deckkraft des gewählten Punkts</translation>
    </message>
    <message>
        <source>Colour of the selected points</source>
        <translation>Farbe der gewählten Punkte</translation>
    </message>
    <message>
        <source>Add a point after the selected one</source>
        <translation>Punkt nach dem gewählten hinzufügen</translation>
    </message>
    <message>
        <source>Remove the selected points</source>
        <translation>Gewählte Punkte entfernen</translation>
    </message>
    <message>
        <source>V&amp;alue</source>
        <translation>Wer&amp;t</translation>
    </message>
    <message>
        <source>Gradie&amp;nt</source>
        <translation>Gradie&amp;nt</translation>
    </message>
    <message>
        <source>&amp;Opacity</source>
        <translation>Dec&amp;kkraft</translation>
    </message>
    <message>
        <source>Fa&amp;ctor</source>
        <translation>Fakt&amp;or</translation>
    </message>
    <message>
        <source>Transfer function</source>
        <translation>Transferfunktion</translation>
    </message>
    <message>
        <source>Colour of the point</source>
        <translation>Farbe des Punkts</translation>
    </message>
    <message>
        <source>Colour of a point</source>
        <translation>Farbe eines Punkts</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::PresetGallery</name>
    <message>
        <source>With mode, shading and step</source>
        <translation>Mit Art, Beleuchtung und Schritt</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Sichern als…</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Umbenennen…</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>Einlesen…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Ausgeben…</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Vorgaben</translation>
    </message>
    <message>
        <source>Also takes the view mode, the shading and the step the preset was made for</source>
        <translation>Übernimmt auch Darstellungsart, Beleuchtung und Schritt, für die die Vorgabe gemacht ist</translation>
    </message>
    <message>
        <source>Show the chosen preset</source>
        <translation>Gewählte Vorgabe zeigen</translation>
    </message>
    <message>
        <source>Save what is shown as a preset</source>
        <translation>Gezeigtes als Vorgabe sichern</translation>
    </message>
    <message>
        <source>Saves the colours with the view mode, shading and step in use</source>
        <translation>Sichert die Farben mit Darstellungsart, Beleuchtung und Schritt</translation>
    </message>
    <message>
        <source>Rename the chosen preset</source>
        <translation>Gewählte Vorgabe umbenennen</translation>
    </message>
    <message>
        <source>Delete the chosen preset</source>
        <translation>Gewählte Vorgabe löschen</translation>
    </message>
    <message>
        <source>Import a preset file</source>
        <translation>Vorgabe aus einer Datei einlesen</translation>
    </message>
    <message>
        <source>Export the chosen preset to a file</source>
        <translation>Gewählte Vorgabe in eine Datei ausgeben</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::PresetsFeature</name>
    <message>
        <source>Presets</source>
        <translation>Vorgaben</translation>
    </message>
    <message>
        <source>Save as a preset</source>
        <translation>Als Vorgabe sichern</translation>
    </message>
    <message>
        <source>Rename the preset</source>
        <translation>Vorgabe umbenennen</translation>
    </message>
    <message>
        <source>Delete the preset</source>
        <translation>Vorgabe löschen</translation>
    </message>
    <message>
        <source>Delete the preset “%1”? Its file is removed.</source>
        <translation>Vorgabe „%1“ löschen? Ihre Datei wird entfernt.</translation>
    </message>
    <message>
        <source>Import a preset</source>
        <translation>Vorgabe einlesen</translation>
    </message>
    <message>
        <source>Presets (*.json);;All files (*)</source>
        <translation>Vorgaben (*.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Export the preset</source>
        <translation>Vorgabe ausgeben</translation>
    </message>
    <message>
        <source>Presets (*.json)</source>
        <translation>Vorgaben (*.json)</translation>
    </message>
    <message>
        <source>&amp;Colours</source>
        <translation>&amp;Farben</translation>
    </message>
    <message>
        <source>&amp;Presets</source>
        <translation>&amp;Vorgaben</translation>
    </message>
    <message>
        <source>Sa&amp;ve as a preset…</source>
        <translation>Als Vorgabe &amp;sichern…</translation>
    </message>
    <message>
        <source>&amp;Import a preset…</source>
        <translation>Vorgabe &amp;einlesen…</translation>
    </message>
    <message>
        <source>Preset %1</source>
        <translation>Vorgabe %1</translation>
    </message>
    <message>
        <source>Name of the preset</source>
        <translation>Name der Vorgabe</translation>
    </message>
    <message>
        <source>There is a preset “%1” already. Replace it?</source>
        <translation>Es gibt schon eine Vorgabe „%1“. Ersetzen?</translation>
    </message>
    <message>
        <source>Importing a preset</source>
        <translation>Vorgabe importieren</translation>
    </message>
    <message>
        <source>Exporting the preset</source>
        <translation>Vorgabe exportieren</translation>
    </message>
    <message>
        <source>Saving the preset</source>
        <translation>Vorgabe sichern</translation>
    </message>
    <message>
        <source>Renaming the preset</source>
        <translation>Vorgabe umbenennen</translation>
    </message>
    <message>
        <source>Deleting the preset</source>
        <translation>Vorgabe löschen</translation>
    </message>
    <message>
        <source>The preset “%1” is saved.</source>
        <translation>Die Vorgabe „%1“ ist gesichert.</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::RangeRow</name>
    <message>
        <source>Range %1</source>
        <translation>Bereich %1</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>Range %1 in use</source>
        <translation>Bereich %1 an</translation>
    </message>
    <message>
        <source>Lower end of range %1</source>
        <translation>Unteres Ende von Bereich %1</translation>
    </message>
    <message>
        <source>Upper end of range %1</source>
        <translation>Oberes Ende von Bereich %1</translation>
    </message>
    <message>
        <source>Colours of range %1</source>
        <translation>Farben von Bereich %1</translation>
    </message>
    <message>
        <source>Remove range %1</source>
        <translation>Bereich %1 entfernen</translation>
    </message>
    <message>
        <source>Moves it one place up: where ranges overlap, the upper one counts</source>
        <translation>Rückt ihn einen Platz nach oben: wo Bereiche sich überlappen, gilt der obere</translation>
    </message>
    <message>
        <source>The range&apos;s colour</source>
        <translation>Farbe des Bereichs</translation>
    </message>
    <message>
        <source>Whether the range is in use</source>
        <translation>Ob der Bereich an ist</translation>
    </message>
    <message>
        <source>Scene&apos;s colours</source>
        <translation>Farben der Szene</translation>
    </message>
    <message>
        <source>Own colours…</source>
        <translation>Eigene Farben…</translation>
    </message>
    <message>
        <source>One colour</source>
        <translation>Eine Farbe</translation>
    </message>
    <message>
        <source>Name of range %1</source>
        <translation>Name von Bereich %1</translation>
    </message>
    <message>
        <source>Colour of range %1</source>
        <translation>Farbe von Bereich %1</translation>
    </message>
    <message>
        <source>Move range %1 up</source>
        <translation>Bereich %1 nach oben</translation>
    </message>
    <message>
        <source>What range %1 holds</source>
        <translation>Was Bereich %1 enthält</translation>
    </message>
    <message>
        <source>Use a range</source>
        <translation>Bereich anschalten</translation>
    </message>
    <message>
        <source>Leave out a range</source>
        <translation>Bereich ausschalten</translation>
    </message>
    <message>
        <source>Name of a range</source>
        <translation>Name eines Bereichs</translation>
    </message>
    <message>
        <source>Colours of a range</source>
        <translation>Farben eines Bereichs</translation>
    </message>
    <message>
        <source>%1 voxels · %2 mm³ · %3 %</source>
        <translation>%1 Voxel · %2 mm³ · %3 %</translation>
    </message>
    <message>
        <source> · mean %1</source>
        <translation> · Mittel %1</translation>
    </message>
    <message>
        <source>
%1 of them are in a range above, which draws them</source>
        <translation>
%1 davon liegen in einem Bereich darüber, der sie zeichnet</translation>
    </message>
    <message>
        <source>Ends of %1</source>
        <translation>Enden von %1</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::RangeSlider</name>
    <message>
        <source>Value range</source>
        <translation>Wertebereich</translation>
    </message>
    <message>
        <source>From %1 to %2; arrow keys move the %3 end</source>
        <translation>Von %1 bis %2; Pfeiltasten bewegen das %3 Ende</translation>
    </message>
    <message>
        <source>upper</source>
        <translation>obere</translation>
    </message>
    <message>
        <source>lower</source>
        <translation>untere</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::RangesPanel</name>
    <message>
        <source>Add a range</source>
        <translation>Bereich hinzufügen</translation>
    </message>
    <message>
        <source>Add a segmentation range</source>
        <translation>Segmentierungsbereich hinzufügen</translation>
    </message>
    <message>
        <source>Range %1</source>
        <translation>Bereich %1</translation>
    </message>
    <message>
        <source>Colours of range %1</source>
        <translation>Farben von Bereich %1</translation>
    </message>
    <message>
        <source>Remove range %1</source>
        <translation>Bereich %1 entfernen</translation>
    </message>
    <message>
        <source>No range: every value is kept. With ranges, only values inside them are seen; where they overlap, the upper one counts.</source>
        <translation>Kein Bereich: alle Werte bleiben. Mit Bereichen sind nur Werte darin zu sehen; wo sie sich überlappen, gilt der obere.</translation>
    </message>
    <message>
        <source>Order of the ranges</source>
        <translation>Reihenfolge der Bereiche</translation>
    </message>
    <message>
        <source>Colour of the range</source>
        <translation>Farbe des Bereichs</translation>
    </message>
    <message>
        <source>Colour of range %1</source>
        <translation>Farbe von Bereich %1</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::RawImportDialog</name>
    <message>
        <source>8 bit, unsigned</source>
        <translation>8 Bit, ohne Vorzeichen</translation>
    </message>
    <message>
        <source>8 bit, signed</source>
        <translation>8 Bit, mit Vorzeichen</translation>
    </message>
    <message>
        <source>16 bit, unsigned</source>
        <translation>16 Bit, ohne Vorzeichen</translation>
    </message>
    <message>
        <source>16 bit, signed</source>
        <translation>16 Bit, mit Vorzeichen</translation>
    </message>
    <message>
        <source>32 bit, floating point</source>
        <translation>32 Bit, Gleitkomma</translation>
    </message>
    <message>
        <source>%1 × %2 × %3, %4</source>
        <translation>%1 × %2 × %3, %4</translation>
    </message>
    <message>
        <source>, big endian</source>
        <translation>, Big Endian</translation>
    </message>
    <message>
        <source>, little endian</source>
        <translation>, Little Endian</translation>
    </message>
    <message numerus="yes">
        <source>, behind %n header bytes</source>
        <translation>
            <numerusform>, hinter %n Byte Kopf</numerusform>
            <numerusform>, hinter %n Bytes Kopf</numerusform>
        </translation>
    </message>
    <message>
        <source>under 1 % sure</source>
        <translation>unter 1 % sicher</translation>
    </message>
    <message>
        <source>%1 % sure</source>
        <translation>%1 % sicher</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>%1 einlesen</translation>
    </message>
    <message>
        <source>Proposals</source>
        <translation>Vorschläge</translation>
    </message>
    <message>
        <source>Looking at the file…</source>
        <translation>Die Datei wird angesehen…</translation>
    </message>
    <message>
        <source>&amp;Proposals, the likeliest first</source>
        <translation>&amp;Vorschläge, der wahrscheinlichste zuerst</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Breite</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>&amp;Höhe</translation>
    </message>
    <message>
        <source>&amp;Depth</source>
        <translation>&amp;Tiefe</translation>
    </message>
    <message>
        <source> voxels</source>
        <translation> Voxel</translation>
    </message>
    <message>
        <source> slices</source>
        <translation> Schichten</translation>
    </message>
    <message>
        <source>Voxel type</source>
        <translation>Voxeltyp</translation>
    </message>
    <message>
        <source>&amp;Type</source>
        <translation>T&amp;yp</translation>
    </message>
    <message>
        <source>Little endian</source>
        <translation>Little Endian</translation>
    </message>
    <message>
        <source>Big endian</source>
        <translation>Big Endian</translation>
    </message>
    <message>
        <source>Byte order</source>
        <translation>Byte-Reihenfolge</translation>
    </message>
    <message>
        <source>Which byte of a wider number comes first; PCs write little endian</source>
        <translation>Welches Byte einer breiteren Zahl zuerst kommt; PCs schreiben Little Endian</translation>
    </message>
    <message>
        <source>&amp;Byte order</source>
        <translation>Byte-&amp;Reihenfolge</translation>
    </message>
    <message>
        <source> bytes</source>
        <translation> Bytes</translation>
    </message>
    <message>
        <source>Header</source>
        <translation>Kopf</translation>
    </message>
    <message>
        <source>Bytes before the first voxel</source>
        <translation>Bytes vor dem ersten Voxel</translation>
    </message>
    <message>
        <source>H&amp;eader</source>
        <translation>&amp;Kopf</translation>
    </message>
    <message>
        <source>Spacing between columns</source>
        <translation>Abstand zwischen Spalten</translation>
    </message>
    <message>
        <source>Spacing between rows</source>
        <translation>Abstand zwischen Zeilen</translation>
    </message>
    <message>
        <source>Spacing between slices</source>
        <translation>Abstand zwischen Schichten</translation>
    </message>
    <message>
        <source>&amp;Spacing in mm</source>
        <translation>&amp;Abstand in mm</translation>
    </message>
    <message>
        <source>Size of the file</source>
        <translation>Größe der Datei</translation>
    </message>
    <message>
        <source>&amp;Fit the depth</source>
        <translation>Tiefe an&amp;passen</translation>
    </message>
    <message>
        <source>As many slices as the file holds</source>
        <translation>So viele Schichten, wie die Datei enthält</translation>
    </message>
    <message>
        <source>The &amp;rest is header</source>
        <translation>Der R&amp;est ist Kopf</translation>
    </message>
    <message>
        <source>Takes all bytes the voxels do not need for a header before them</source>
        <translation>Nimmt alle Bytes, die die Voxel nicht brauchen, für einen Kopf davor</translation>
    </message>
    <message>
        <source>Slice shown</source>
        <translation>Gezeigte Schicht</translation>
    </message>
    <message>
        <source>Nothing can be told from this file; enter what you know of it.</source>
        <translation>Aus dieser Datei lässt sich nichts erkennen; eingeben, was bekannt ist.</translation>
    </message>
    <message>
        <source>Voxels and header take %1 of the file&apos;s %2 bytes</source>
        <translation>Voxel und Kopf nehmen %1 von %2 Bytes der Datei</translation>
    </message>
    <message>
        <source>: %1 too many.</source>
        <translation>: %1 zu viel.</translation>
    </message>
    <message>
        <source>: %1 are left over.</source>
        <translation>: %1 bleiben übrig.</translation>
    </message>
    <message>
        <source>: it fits.</source>
        <translation>: es passt.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::RecentFeature</name>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Session of %1</source>
        <translation>Sitzung vom %1</translation>
    </message>
    <message>
        <source>Folder of %1</source>
        <translation>Ordner vom %1</translation>
    </message>
    <message>
        <source>File of %1</source>
        <translation>Datei vom %1</translation>
    </message>
    <message>
        <source>&amp;Forget these</source>
        <translation>Diese &amp;vergessen</translation>
    </message>
    <message>
        <source>There is no file %1.</source>
        <translation>Es gibt keine Datei %1.</translation>
    </message>
    <message>
        <source>It has left the list of what was open lately.</source>
        <translation>Sie steht nicht mehr in der Liste des zuletzt Geöffneten.</translation>
    </message>
    <message>
        <source>What was open then is no longer there.</source>
        <translation>Was damals geöffnet war, ist nicht mehr da.</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::RegionModel</name>
    <message>
        <source>Id</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Number of the region, by descending size</source>
        <translation>Nummer der Region, nach fallender Größe</translation>
    </message>
    <message>
        <source>Voxels</source>
        <translation>Voxel</translation>
    </message>
    <message>
        <source>Number of voxels</source>
        <translation>Zahl der Voxel</translation>
    </message>
    <message>
        <source>Volume mm³</source>
        <translation>Volumen mm³</translation>
    </message>
    <message>
        <source>Voxels times the volume of one</source>
        <translation>Voxel mal das Volumen von einem</translation>
    </message>
    <message>
        <source>Share %</source>
        <translation>Anteil %</translation>
    </message>
    <message>
        <source>Of the voxels of all regions</source>
        <translation>An den Voxeln aller Regionen</translation>
    </message>
    <message>
        <source>Surface mm²</source>
        <translation>Oberfläche mm²</translation>
    </message>
    <message>
        <source>Estimated surface area</source>
        <translation>Geschätzte Oberfläche</translation>
    </message>
    <message>
        <source>Sphericity</source>
        <translation>Sphärizität</translation>
    </message>
    <message>
        <source>1 for a ball</source>
        <translation>1 für eine Kugel</translation>
    </message>
    <message>
        <source>Shape factor</source>
        <translation>Formfaktor</translation>
    </message>
    <message>
        <source>Surface cubed over volume squared; 113.1 for a ball, more for anything less compact</source>
        <translation>Oberfläche hoch drei durch Volumen hoch zwei; 113,1 für eine Kugel, mehr für alles weniger Kompakte</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>Löcher</translation>
    </message>
    <message>
        <source>Closed cavities</source>
        <translation>Geschlossene Höhlen</translation>
    </message>
    <message>
        <source>Tunnels</source>
        <translation>Tunnel</translation>
    </message>
    <message>
        <source>Handles through the region</source>
        <translation>Durchgänge durch die Region</translation>
    </message>
    <message>
        <source>Diameter mm</source>
        <translation>Durchmesser mm</translation>
    </message>
    <message>
        <source>Of the ball of equal volume</source>
        <translation>Der Kugel gleichen Volumens</translation>
    </message>
    <message>
        <source>Length mm</source>
        <translation>Länge mm</translation>
    </message>
    <message>
        <source>Longest axis of the ellipsoid of equal moments</source>
        <translation>Längste Achse des Ellipsoids gleicher Momente</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Mean value</source>
        <translation>Mittlerer Wert</translation>
    </message>
    <message>
        <source>Min</source>
        <translation>Min</translation>
    </message>
    <message>
        <source>Smallest value</source>
        <translation>Kleinster Wert</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>Max</translation>
    </message>
    <message>
        <source>Largest value</source>
        <translation>Größter Wert</translation>
    </message>
    <message>
        <source>Std. dev.</source>
        <translation>Std.-Abw.</translation>
    </message>
    <message>
        <source>Standard deviation of the values</source>
        <translation>Standardabweichung der Werte</translation>
    </message>
    <message>
        <source>x mm</source>
        <translation>x mm</translation>
    </message>
    <message>
        <source>Centroid, to the patient&apos;s left</source>
        <translation>Schwerpunkt, zur linken Seite des Patienten</translation>
    </message>
    <message>
        <source>y mm</source>
        <translation>y mm</translation>
    </message>
    <message>
        <source>Centroid, to the back</source>
        <translation>Schwerpunkt, nach hinten</translation>
    </message>
    <message>
        <source>z mm</source>
        <translation>z mm</translation>
    </message>
    <message>
        <source>Centroid, to the head</source>
        <translation>Schwerpunkt, zum Kopf</translation>
    </message>
    <message>
        <source>Border</source>
        <translation>Rand</translation>
    </message>
    <message>
        <source>The region touches the volume&apos;s border</source>
        <translation>Die Region berührt den Rand des Volumens</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>Coordinate of the centroid</source>
        <translation>Koordinate des Schwerpunkts</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::RegionsFeature</name>
    <message>
        <source>Regions</source>
        <translation>Regionen</translation>
    </message>
    <message>
        <source>Compute re&amp;gions</source>
        <translation>Re&amp;gionen berechnen</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Ausgeben</translation>
    </message>
    <message>
        <source>&amp;Region table…</source>
        <translation>&amp;Regionentabelle…</translation>
    </message>
    <message>
        <source>Finding regions</source>
        <translation>Regionen werden gesucht</translation>
    </message>
    <message>
        <source>There is no region table yet; compute the regions first.</source>
        <translation>Es gibt noch keine Regionentabelle; zuerst die Regionen berechnen.</translation>
    </message>
    <message>
        <source>Export the region table</source>
        <translation>Regionentabelle ausgeben</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>Writing the region table</source>
        <translation>Schreiben der Regionentabelle</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::RegionsPanel</name>
    <message>
        <source>Current range</source>
        <translation>Jetziger Bereich</translation>
    </message>
    <message>
        <source>Compute regions</source>
        <translation>Regionen berechnen</translation>
    </message>
    <message>
        <source>Deselect</source>
        <translation>Abwählen</translation>
    </message>
    <message>
        <source>Export CSV…</source>
        <translation>CSV ausgeben…</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>Values from</source>
        <translation>Werte von</translation>
    </message>
    <message>
        <source>Homogeneous, width</source>
        <translation>Homogen, Breite</translation>
    </message>
    <message>
        <source>How regions are found</source>
        <translation>Wie Regionen gefunden werden</translation>
    </message>
    <message>
        <source>Connected voxels of a value range, or regions whose values span at most a share of the volume&apos;s value range</source>
        <translation>Zusammenhängende Voxel eines Wertebereichs oder Regionen, deren Werte höchstens einen Anteil des Wertebereichs des Volumens überspannen</translation>
    </message>
    <message>
        <source>6 neighbours</source>
        <translation>6 Nachbarn</translation>
    </message>
    <message>
        <source>18 neighbours</source>
        <translation>18 Nachbarn</translation>
    </message>
    <message>
        <source>26 neighbours</source>
        <translation>26 Nachbarn</translation>
    </message>
    <message>
        <source>Connectivity</source>
        <translation>Nachbarschaft</translation>
    </message>
    <message>
        <source>Lowest value of a region</source>
        <translation>Niedrigster Wert einer Region</translation>
    </message>
    <message>
        <source>Highest value of a region</source>
        <translation>Höchster Wert einer Region</translation>
    </message>
    <message>
        <source>Range width, percent of the volume&apos;s value range</source>
        <translation>Breite, Prozent des Wertebereichs des Volumens</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>at least </source>
        <translation>mindestens </translation>
    </message>
    <message>
        <source> voxels</source>
        <translation> Voxel</translation>
    </message>
    <message>
        <source>Smallest region, voxels</source>
        <translation>Kleinste Region, Voxel</translation>
    </message>
    <message>
        <source>Take the current segmentation range</source>
        <translation>Jetzigen Segmentierungsbereich übernehmen</translation>
    </message>
    <message>
        <source>The first segmentation range in use, or what lies above the isovalue</source>
        <translation>Der erste Segmentierungsbereich, der an ist, oder was über dem Isowert liegt</translation>
    </message>
    <message>
        <source>Compute the regions</source>
        <translation>Die Regionen berechnen</translation>
    </message>
    <message>
        <source>Select no region</source>
        <translation>Keine Region wählen</translation>
    </message>
    <message>
        <source>Export the region table</source>
        <translation>Regionentabelle ausgeben</translation>
    </message>
    <message>
        <source>Regions</source>
        <translation>Regionen</translation>
    </message>
    <message>
        <source>1 region</source>
        <translation>1 Region</translation>
    </message>
    <message>
        <source>%1 regions</source>
        <translation>%1 Regionen</translation>
    </message>
    <message>
        <source>Computing…</source>
        <translation>Wird berechnet…</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::RenderPanel</name>
    <message>
        <source>Draft (step 1, nearest)</source>
        <translation>Entwurf (Schritt 1, nächster)</translation>
    </message>
    <message>
        <source>Fast (step 1)</source>
        <translation>Schnell (Schritt 1)</translation>
    </message>
    <message>
        <source>Normal (step 0.5)</source>
        <translation>Normal (Schritt 0,5)</translation>
    </message>
    <message>
        <source>High (step 0.25)</source>
        <translation>Hoch (Schritt 0,25)</translation>
    </message>
    <message>
        <source>Finest (step 0.1)</source>
        <translation>Feinste (Schritt 0,1)</translation>
    </message>
    <message>
        <source>Isosurface</source>
        <translation>Isofläche</translation>
    </message>
    <message>
        <source>The surface of one value, shaded</source>
        <translation>Die Fläche eines Werts, beleuchtet</translation>
    </message>
    <message>
        <source>Volume (emission–absorption)</source>
        <translation>Volumen (Emission–Absorption)</translation>
    </message>
    <message>
        <source>Colours and opacities of the transfer function, front to back</source>
        <translation>Farben und Deckkraft der Transferfunktion, von vorn nach hinten</translation>
    </message>
    <message>
        <source>Maximum projection (MIP)</source>
        <translation>Maximumprojektion (MIP)</translation>
    </message>
    <message>
        <source>The largest value of each ray</source>
        <translation>Der größte Wert jedes Strahls</translation>
    </message>
    <message>
        <source>Local maximum (LMIP)</source>
        <translation>Lokales Maximum (LMIP)</translation>
    </message>
    <message>
        <source>The first local maximum above a threshold</source>
        <translation>Das erste lokale Maximum über einer Schwelle</translation>
    </message>
    <message>
        <source>Minimum projection (MinIP)</source>
        <translation>Minimumprojektion (MinIP)</translation>
    </message>
    <message>
        <source>The smallest value of each ray</source>
        <translation>Der kleinste Wert jedes Strahls</translation>
    </message>
    <message>
        <source>Mean (radiograph)</source>
        <translation>Mittel (Röntgenbild)</translation>
    </message>
    <message>
        <source>The mean value of each ray</source>
        <translation>Der mittlere Wert jedes Strahls</translation>
    </message>
    <message>
        <source>Shear-warp surface</source>
        <translation>Shear-Warp-Fläche</translation>
    </message>
    <message>
        <source>The surface&apos;s visible voxels by shear and warp</source>
        <translation>Die sichtbaren Voxel der Fläche durch Scheren und Verzerren</translation>
    </message>
    <message>
        <source>Isovalue</source>
        <translation>Isowert</translation>
    </message>
    <message>
        <source>Local maximum threshold</source>
        <translation>Schwelle des lokalen Maximums</translation>
    </message>
    <message>
        <source>Colours of the transfer function</source>
        <translation>Farben der Transferfunktion</translation>
    </message>
    <message>
        <source>View mode</source>
        <translation>Darstellungsart</translation>
    </message>
    <message>
        <source>Keys 1 to 7</source>
        <translation>Tasten 1 bis 7</translation>
    </message>
    <message>
        <source>Projection in the colours of the transfer function</source>
        <translation>Projektion in den Farben der Transferfunktion</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Lambert</source>
        <translation>Lambert</translation>
    </message>
    <message>
        <source>Phong</source>
        <translation>Phong</translation>
    </message>
    <message>
        <source>Shading</source>
        <translation>Beleuchtung</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Güte</translation>
    </message>
    <message>
        <source>Distance between samples, in voxels, of the still picture</source>
        <translation>Abstand der Abtastpunkte des stehenden Bilds, in Voxeln</translation>
    </message>
    <message>
        <source>Mo&amp;de</source>
        <translation>A&amp;rt</translation>
    </message>
    <message>
        <source>&amp;Isovalue</source>
        <translation>&amp;Isowert</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Schwelle</translation>
    </message>
    <message>
        <source>&amp;Shading</source>
        <translation>Beleu&amp;chtung</translation>
    </message>
    <message>
        <source>&amp;Quality</source>
        <translation>G&amp;üte</translation>
    </message>
    <message>
        <source>Projection colours</source>
        <translation>Projektionsfarben</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Selbsttätig</translation>
    </message>
    <message>
        <source>Acceleration structure</source>
        <translation>Beschleunigungsstruktur</translation>
    </message>
    <message>
        <source>What lets rays jump over empty space; the picture is the same with each</source>
        <translation>Was Strahlen leeren Raum überspringen lässt; das Bild ist mit jeder dasselbe</translation>
    </message>
    <message>
        <source>Str&amp;ucture</source>
        <translation>Str&amp;uktur</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>Struktur</translation>
    </message>
    <message>
        <source>Automatic (%1)</source>
        <translation>Selbsttätig (%1)</translation>
    </message>
    <message>
        <source>Almost every ray passes the air at the volume&apos;s border, which holds the least values: the picture shows that air, and is dark. What lies within the part is shown by a box inside it alone (Cuts), or by a range of the part&apos;s values (Ranges).</source>
        <translation>Fast jeder Strahl geht durch die Luft am Rand des Volumens, die die kleinsten Werte hat: Das Bild zeigt diese Luft und ist dunkel. Was im Teil liegt, zeigt ein Kasten in seinem Inneren (Schnitte) oder ein Bereich seiner Werte (Bereiche).</translation>
    </message>
    <message>
        <source>About this mode</source>
        <translation>Zu diesem Modus</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::SeriesDialog</name>
    <message>
        <source>Choose a series</source>
        <translation>Serie wählen</translation>
    </message>
    <message>
        <source>There are %1 volumes here. Which one should be opened?</source>
        <translation>Hier liegen %1 Volumen. Welches soll geöffnet werden?</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Modality</source>
        <translation>Modalität</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Beschreibung</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Schichten</translation>
    </message>
    <message>
        <source>Series found</source>
        <translation>Gefundene Serien</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::SessionFeature</name>
    <message>
        <source>Sessions (*.lacuna)</source>
        <translation>Sitzungen (*.lacuna)</translation>
    </message>
    <message>
        <source>Open a sess&amp;ion…</source>
        <translation>S&amp;itzung öffnen…</translation>
    </message>
    <message>
        <source>Open a session</source>
        <translation>Sitzung öffnen</translation>
    </message>
    <message>
        <source>Open the &amp;last session again</source>
        <translation>&amp;Letzte Sitzung wieder öffnen</translation>
    </message>
    <message>
        <source>Sa&amp;ve the session</source>
        <translation>Sitzung &amp;sichern</translation>
    </message>
    <message>
        <source>Session</source>
        <translation>Sitzung</translation>
    </message>
    <message>
        <source>Save the session &amp;as…</source>
        <translation>Sitzung sichern &amp;als…</translation>
    </message>
    <message>
        <source>Save the session</source>
        <translation>Sitzung sichern</translation>
    </message>
    <message>
        <source>Saving the session</source>
        <translation>Sitzung wird gesichert</translation>
    </message>
    <message>
        <source>The session is saved in %1.</source>
        <translation>Die Sitzung ist in %1 gesichert.</translation>
    </message>
    <message>
        <source>Where is the session&apos;s data?</source>
        <translation>Wo liegen die Daten der Sitzung?</translation>
    </message>
    <message>
        <source>The data of %1 is not where it was (%2). What is open stays open.</source>
        <translation>Die Daten von %1 liegen nicht mehr dort, wo sie waren (%2). Was offen ist, bleibt offen.</translation>
    </message>
    <message>
        <source>Locate the folder…</source>
        <translation>Ordner suchen…</translation>
    </message>
    <message>
        <source>Locate the file…</source>
        <translation>Datei suchen…</translation>
    </message>
    <message>
        <source>The data changed since this session was saved: its voxels are not the same. Measurements and decisions may not fit what is shown; save the session under another name to keep both.</source>
        <translation>Die Daten haben sich geändert, seit diese Sitzung gesichert wurde: ihre Voxel sind nicht dieselben. Messungen und Entscheidungen passen vielleicht nicht zu dem, was gezeigt wird; die Sitzung unter anderem Namen sichern, um beide zu behalten.</translation>
    </message>
    <message>
        <source>Lacuna did not end as it should. What was open was last kept at %1.</source>
        <translation>Lacuna wurde nicht ordentlich beendet. Was offen war, wurde zuletzt um %1 gesichert.</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>The session&apos;s data is not where it was. What is open stays open.</source>
        <translation>Die Daten der Sitzung liegen nicht mehr dort, wo sie waren. Was offen ist, bleibt offen.</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::SettingsDialog</name>
    <message>
        <source>&amp;Hide names, identifiers and dates of patients</source>
        <translation>&amp;Namen, Kennungen und Daten von Patienten verbergen</translation>
    </message>
    <message>
        <source>&amp;Measure again</source>
        <translation>Erneut &amp;messen</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Pages of settings</source>
        <translation>Seiten der Einstellungen</translation>
    </message>
    <message>
        <source>&amp;General</source>
        <translation>&amp;Allgemein</translation>
    </message>
    <message>
        <source>&amp;Computing</source>
        <translation>&amp;Rechnen</translation>
    </message>
    <message>
        <source>&amp;Folders and privacy</source>
        <translation>&amp;Ordner und Datenschutz</translation>
    </message>
    <message>
        <source>Keep the settings</source>
        <translation>Einstellungen übernehmen</translation>
    </message>
    <message>
        <source>Leave the settings as they were</source>
        <translation>Einstellungen lassen, wie sie waren</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Farbschema</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Minutes between automatic saves</source>
        <translation>Minuten zwischen selbsttätigen Sicherungen</translation>
    </message>
    <message>
        <source> min</source>
        <translation> min</translation>
    </message>
    <message>
        <source>never</source>
        <translation>nie</translation>
    </message>
    <message>
        <source>The session is kept beside its file, so that it comes back after a crash</source>
        <translation>Die Sitzung wird neben ihrer Datei gesichert, damit sie nach einem Absturz wiederkommt</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Farbschema</translation>
    </message>
    <message>
        <source>&amp;Save the session every</source>
        <translation>Sitzung si&amp;chern alle</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>The fastest one</source>
        <translation>Das schnellste</translation>
    </message>
    <message>
        <source>None (the slower built-in renderer)</source>
        <translation>Keines (der langsamere eingebaute Renderer)</translation>
    </message>
    <message>
        <source>Memory limit</source>
        <translation>Speichergrenze</translation>
    </message>
    <message>
        <source> MiB</source>
        <translation> MiB</translation>
    </message>
    <message>
        <source>75 % of the machine&apos;s</source>
        <translation>75 % des Rechners</translation>
    </message>
    <message>
        <source>&amp;Device</source>
        <translation>&amp;Gerät</translation>
    </message>
    <message>
        <source>M&amp;emory limit</source>
        <translation>Sp&amp;eichergrenze</translation>
    </message>
    <message>
        <source>Devices found, with their times</source>
        <translation>Gefundene Geräte mit ihren Zeiten</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>Speicher</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Why the fastest one is it</source>
        <translation>Warum das schnellste es ist</translation>
    </message>
    <message>
        <source>Measure the devices again</source>
        <translation>Geräte erneut messen</translation>
    </message>
    <message>
        <source>Tests every device and times it with a short rendering</source>
        <translation>Prüft jedes Gerät und stoppt die Zeit eines kurzen Renderns</translation>
    </message>
    <message>
        <source>Hide names, identifiers and dates of patients</source>
        <translation>Namen, Kennungen und Daten von Patienten verbergen</translation>
    </message>
    <message>
        <source>&amp;Open from</source>
        <translation>Öffnen a&amp;us</translation>
    </message>
    <message>
        <source>Folder to open from</source>
        <translation>Ordner, aus dem geöffnet wird</translation>
    </message>
    <message>
        <source>&amp;Write to</source>
        <translation>Schreiben &amp;in</translation>
    </message>
    <message>
        <source>Folder to write to</source>
        <translation>Ordner, in den geschrieben wird</translation>
    </message>
    <message>
        <source>the last one used</source>
        <translation>der zuletzt benutzte</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>Choose: %1</source>
        <translation>Wählen: %1</translation>
    </message>
    <message>
        <source>Measuring…</source>
        <translation>Wird gemessen…</translation>
    </message>
    <message>
        <source>cannot be used</source>
        <translation>nicht benutzbar</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>graphics card</source>
        <translation>Grafikkarte</translation>
    </message>
    <message>
        <source>processor</source>
        <translation>Prozessor</translation>
    </message>
    <message>
        <source>other</source>
        <translation>anderes</translation>
    </message>
    <message>
        <source>%1 GiB</source>
        <translation>%1 GiB</translation>
    </message>
    <message>
        <source>No OpenCL device was found.</source>
        <translation>Es wurde kein OpenCL-Gerät gefunden.</translation>
    </message>
    <message>
        <source>No device can be used.</source>
        <translation>Kein Gerät ist benutzbar.</translation>
    </message>
    <message>
        <source>The fastest one is in bold.</source>
        <translation>Das schnellste steht fett.</translation>
    </message>
    <message>
        <source>%1 (not found now)</source>
        <translation>%1 (gerade nicht gefunden)</translation>
    </message>
    <message>
        <source>Host and device memory together; larger volumes are not opened in the window</source>
        <translation>Speicher von Rechner und Gerät zusammen; größere Volumen werden im Fenster nicht geöffnet</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::SettingsFeature</name>
    <message>
        <source>&amp;Settings…</source>
        <translation>&amp;Einstellungen…</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::ShapePlot</name>
    <message>
        <source>Shapes of value and gradient</source>
        <translation>Formen aus Wert und Gradient</translation>
    </message>
    <message>
        <source>Arrow keys move the selected shape, with Shift its upper right corner, Page Up and Page Down select another, Insert adds one, Delete removes it, Enter chooses its colour.</source>
        <translation>Pfeiltasten bewegen die gewählte Form, mit Umschalt ihre rechte obere Ecke, Bild auf und Bild ab wählen eine andere, Einfg fügt eine hinzu, Entf entfernt sie, Eingabe wählt ihre Farbe.</translation>
    </message>
    <message>
        <source>Values to the right, gradient magnitudes up · drag on empty ground to draw a rectangle · drag a shape or its corners · Delete removes it · right click chooses its colour</source>
        <translation>Werte nach rechts, Gradientenbeträge nach oben · auf leerem Grund ziehen, um ein Rechteck zu zeichnen · eine Form oder ihre Ecken ziehen · Entf entfernt sie · Rechtsklick wählt ihre Farbe</translation>
    </message>
    <message>
        <source>value →  ↑ gradient to %1 per mm</source>
        <translation>Wert →  ↑ Gradient bis %1 je mm</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::ShapesPage</name>
    <message>
        <source>Draw &amp;by shapes of value and gradient</source>
        <translation>Mit Forme&amp;n aus Wert und Gradient zeichnen</translation>
    </message>
    <message>
        <source>Colour…</source>
        <translation>Farbe…</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Draw by shapes</source>
        <translation>Mit Formen zeichnen</translation>
    </message>
    <message>
        <source>Draw by values</source>
        <translation>Mit Werten zeichnen</translation>
    </message>
    <message>
        <source>Shapes of value and gradient</source>
        <translation>Formen aus Wert und Gradient</translation>
    </message>
    <message>
        <source>Kind of a shape</source>
        <translation>Art einer Form</translation>
    </message>
    <message>
        <source>Opacity of a shape</source>
        <translation>Deckkraft einer Form</translation>
    </message>
    <message>
        <source>Softness of a shape</source>
        <translation>Weichheit einer Form</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>Trapezoid</source>
        <translation>Trapez</translation>
    </message>
    <message>
        <source>Kind of the selected shape</source>
        <translation>Art der gewählten Form</translation>
    </message>
    <message>
        <source>Opacity of the selected shape</source>
        <translation>Deckkraft der gewählten Form</translation>
    </message>
    <message>
        <source>Softness of the selected shape</source>
        <translation>Weichheit der gewählten Form</translation>
    </message>
    <message>
        <source>Share of the half width over which opacity falls to nothing at either side</source>
        <translation>Anteil der halben Breite, über den die Deckkraft zu beiden Seiten auf nichts fällt</translation>
    </message>
    <message>
        <source>Colour of the selected shape</source>
        <translation>Farbe der gewählten Form</translation>
    </message>
    <message>
        <source>Add a shape</source>
        <translation>Form hinzufügen</translation>
    </message>
    <message>
        <source>Remove the selected shape</source>
        <translation>Gewählte Form entfernen</translation>
    </message>
    <message>
        <source>Opacity and colour come from the shapes below instead of the points and the gradient curve</source>
        <translation>Deckkraft und Farbe kommen von den Formen darunter statt von den Punkten und der Gradientenkurve</translation>
    </message>
    <message>
        <source>&amp;Opacity</source>
        <translation>Dec&amp;kkraft</translation>
    </message>
    <message>
        <source>Soft&amp;ness</source>
        <translation>W&amp;eichheit</translation>
    </message>
    <message>
        <source>Colour of the shape</source>
        <translation>Farbe der Form</translation>
    </message>
    <message>
        <source>Colour of a shape</source>
        <translation>Farbe einer Form</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::ShortcutSheet</name>
    <message>
        <source>Keys and mouse</source>
        <translation>Tasten und Maus</translation>
    </message>
    <message>
        <source>Search keys and commands</source>
        <translation>Tasten und Befehle suchen</translation>
    </message>
    <message>
        <source>Words to look for</source>
        <translation>Gesuchte Wörter</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Keys or mouse</source>
        <translation>Tasten oder Maus</translation>
    </message>
    <message>
        <source>Mouse: %1</source>
        <translation>Maus: %1</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>&amp;Drucken…</translation>
    </message>
    <message>
        <source>Print the sheet</source>
        <translation>Übersicht drucken</translation>
    </message>
    <message>
        <source>Close the sheet</source>
        <translation>Übersicht schließen</translation>
    </message>
    <message>
        <source>Lacuna: keys and mouse</source>
        <translation>Lacuna: Tasten und Maus</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::SliceMeasure</name>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Ellipse</translation>
    </message>
    <message>
        <source>Remove measurement %1</source>
        <translation>Messung %1 entfernen</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1 mm² · %2 px</source>
        <translation>%1 mm² · %2 px</translation>
    </message>
    <message>
        <source>Mean %1 ± %2%3</source>
        <translation>Mittel %1 ± %2%3</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>Measurement %1</source>
        <translation>Messung %1</translation>
    </message>
    <message>
        <source>Move measurement %1</source>
        <translation>Messung %1 bewegen</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::SliceView</name>
    <message>
        <source>%1 slice</source>
        <translation>Schicht: %1</translation>
    </message>
    <message>
        <source>Arrow keys move the cross-hair, Page Up and Page Down turn the pages, Shift and arrow keys change window and level.</source>
        <translation>Pfeiltasten bewegen das Fadenkreuz, Bild auf und Bild ab blättern, Umschalt und Pfeiltasten ändern die Fensterung.</translation>
    </message>
    <message>
        <source>%1 / %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>L %1  W %2</source>
        <translation>L %1  W %2</translation>
    </message>
    <message>
        <source>%1, tilted</source>
        <translation>%1, gekippt</translation>
    </message>
    <message>
        <source>MIP of %1 mm</source>
        <translation>MIP über %1 mm</translation>
    </message>
    <message>
        <source>MinIP of %1 mm</source>
        <translation>MinIP über %1 mm</translation>
    </message>
    <message>
        <source>Mean of %1 mm</source>
        <translation>Mittel über %1 mm</translation>
    </message>
    <message>
        <source>Zoom %1 %</source>
        <translation>Zoom %1 %</translation>
    </message>
    <message>
        <source>sigmoid</source>
        <translation>sigmoid</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::SlicesFeature</name>
    <message>
        <source>S&amp;lices</source>
        <translation>&amp;Schichten</translation>
    </message>
    <message>
        <source>Planes along the &amp;grid</source>
        <translation>Ebenen entlang des &amp;Gitters</translation>
    </message>
    <message>
        <source>Planes along the grid</source>
        <translation>Ebenen entlang des Gitters</translation>
    </message>
    <message>
        <source>&amp;Words, sides and scale</source>
        <translation>&amp;Texte, Seiten und Maßstab</translation>
    </message>
    <message>
        <source>Tilt the planes</source>
        <translation>Ebenen kippen</translation>
    </message>
    <message>
        <source>Window preset</source>
        <translation>Fenstervorgabe</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>&amp;Fenster</translation>
    </message>
    <message>
        <source>&amp;Full range</source>
        <translation>Ganzer &amp;Bereich</translation>
    </message>
    <message>
        <source>As &amp;opened</source>
        <translation>Wie ge&amp;öffnet</translation>
    </message>
    <message>
        <source>Slab: &amp;mean</source>
        <translation>Scheibe: &amp;Mittel</translation>
    </message>
    <message>
        <source>Slab: ma&amp;ximum (MIP)</source>
        <translation>Scheibe: Ma&amp;ximum (MIP)</translation>
    </message>
    <message>
        <source>Slab: m&amp;inimum (MinIP)</source>
        <translation>Scheibe: M&amp;inimum (MinIP)</translation>
    </message>
    <message>
        <source>Slab</source>
        <translation>Scheibe</translation>
    </message>
    <message>
        <source>Thicker slab</source>
        <translation>Dickere Scheibe</translation>
    </message>
    <message>
        <source>Thinner slab</source>
        <translation>Dünnere Scheibe</translation>
    </message>
    <message>
        <source>&amp;No slab</source>
        <translation>&amp;Keine Scheibe</translation>
    </message>
    <message>
        <source>Slab thickness</source>
        <translation>Dicke der Scheibe</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::SlicesPanel</name>
    <message>
        <source>Level</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>Window width</source>
        <translation>Fensterbreite</translation>
    </message>
    <message>
        <source>As the slices</source>
        <translation>Wie die Schichten</translation>
    </message>
    <message>
        <source>Window preset</source>
        <translation>Fenstervorgabe</translation>
    </message>
    <message>
        <source>Grey levels of the 3D view</source>
        <translation>Grauwerte der 3D-Ansicht</translation>
    </message>
    <message>
        <source>Grey levels of the 3D view as in the slices</source>
        <translation>Grauwerte der 3D-Ansicht wie in den Schichten</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>&amp;Fenster</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Grey levels of projections and cut faces in 3D</source>
        <translation>Grauwerte der Projektionen und Schnittflächen in 3D</translation>
    </message>
    <message>
        <source>As opened</source>
        <translation>Wie geöffnet</translation>
    </message>
    <message>
        <source>Full range</source>
        <translation>Ganzer Bereich</translation>
    </message>
    <message>
        <source>%1 (L %2, W %3)</source>
        <translation>%1 (L %2, W %3)</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Eigenes</translation>
    </message>
    <message>
        <source>Window and level</source>
        <translation>Fensterung</translation>
    </message>
    <message>
        <source>Slab thickness</source>
        <translation>Dicke der Scheibe</translation>
    </message>
    <message>
        <source>Opacity of regions and defects</source>
        <translation>Deckkraft von Regionen und Fehlstellen</translation>
    </message>
    <message>
        <source>Planes along the grid</source>
        <translation>Ebenen entlang des Gitters</translation>
    </message>
    <message>
        <source>Window function</source>
        <translation>Fensterfunktion</translation>
    </message>
    <message>
        <source>Slab</source>
        <translation>Scheibe</translation>
    </message>
    <message>
        <source>Opacity of the overlay</source>
        <translation>Deckkraft der Überlagerung</translation>
    </message>
    <message>
        <source>Linear (DICOM)</source>
        <translation>Linear (DICOM)</translation>
    </message>
    <message>
        <source>Linear, exact</source>
        <translation>Linear, exakt</translation>
    </message>
    <message>
        <source>Sigmoid</source>
        <translation>Sigmoid</translation>
    </message>
    <message>
        <source>What a slab shows</source>
        <translation>Was eine Scheibe zeigt</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Maximum (MIP)</source>
        <translation>Maximum (MIP)</translation>
    </message>
    <message>
        <source>Minimum (MinIP)</source>
        <translation>Minimum (MinIP)</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>How thick the slices are; 0: one voxel</source>
        <translation>Wie dick die Schichten sind; 0: ein Voxel</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Ends the tilt of the slices. They are tilted by dragging a handle near the end of a cross-hair&apos;s line, or with Shift and the left button.</source>
        <translation>Beendet die Neigung der Schichten. Gekippt werden sie durch Ziehen eines Griffs nahe dem Ende einer Linie des Fadenkreuzes oder mit Umschalt und der linken Taste.</translation>
    </message>
    <message>
        <source>Fun&amp;ction</source>
        <translation>Fun&amp;ktion</translation>
    </message>
    <message>
        <source>S&amp;lab</source>
        <translation>&amp;Scheibe</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation>Überlagerung</translation>
    </message>
    <message>
        <source>Table of the file</source>
        <translation>Tabelle der Datei</translation>
    </message>
    <message>
        <source>How a window makes grey of values: DICOM PS3.3 C.11.2. Linear (DICOM) leaves half a value at either end, as scanners do; exact runs from end to end; sigmoid fades out softly. A table is the file&apos;s own (VOI LUT), stretched over the window.</source>
        <translation>Wie ein Fenster aus Werten Grau macht: DICOM PS3.3 C.11.2. Linear (DICOM) lässt an beiden Enden einen halben Wert, wie Scanner es tun; genau läuft von Ende zu Ende; die Sigmoide läuft weich aus. Eine Tabelle bringt die Datei mit (VOI-LUT); sie wird über das Fenster gespannt.</translation>
    </message>
    <message>
        <source>Table %1 of the file</source>
        <translation>Tabelle %1 der Datei</translation>
    </message>
    <message>
        <source>%1 (table of the file)</source>
        <translation>%1 (Tabelle der Datei)</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::SpeedPanel</name>
    <message>
        <source>All pla&amp;ns</source>
        <translation>Alle Plä&amp;ne</translation>
    </message>
    <message>
        <source>Progress of measuring</source>
        <translation>Fortschritt des Messens</translation>
    </message>
    <message>
        <source>Every structure with every step, sampler, termination and sparse casting, instead of one example each; takes its time</source>
        <translation>Jede Struktur mit jedem Schritt, Abtaster, Abbruch und jeder dünnen Abtastung, statt je einem Beispiel; braucht seine Zeit</translation>
    </message>
    <message>
        <source>Time of a frame against its error</source>
        <translation>Zeit eines Bilds gegen seinen Fehler</translation>
    </message>
    <message>
        <source>The list beside it has the same plans.</source>
        <translation>Die Liste daneben hat dieselben Pläne.</translation>
    </message>
    <message>
        <source>Plans measured</source>
        <translation>Gemessene Pläne</translation>
    </message>
    <message>
        <source>Enter or a double click uses a plan</source>
        <translation>Eingabe oder ein Doppelklick benutzt einen Plan</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>Error /255</source>
        <translation>Fehler /255</translation>
    </message>
    <message>
        <source>Build ms</source>
        <translation>Aufbau ms</translation>
    </message>
    <message>
        <source>MiB</source>
        <translation>MiB</translation>
    </message>
    <message>
        <source>in use</source>
        <translation>in Gebrauch</translation>
    </message>
    <message>
        <source>Plans measured: %1 of %2; measuring goes on while nothing else runs</source>
        <translation>Gemessene Pläne: %1 von %2; gemessen wird, solange nichts anderes läuft</translation>
    </message>
    <message>
        <source>Plans measured: %1, in %2 of %3 rounds</source>
        <translation>Gemessene Pläne: %1, in %2 von %3 Durchgängen</translation>
    </message>
    <message>
        <source>%1 (in use)</source>
        <translation>%1 (in Gebrauch)</translation>
    </message>
    <message>
        <source>No other plan is both faster and more exact</source>
        <translation>Kein anderer Plan ist zugleich schneller und genauer</translation>
    </message>
    <message>
        <source>largest error</source>
        <translation>größter Fehler</translation>
    </message>
    <message>
        <source>time a frame</source>
        <translation>Zeit je Bild</translation>
    </message>
    <message>
        <source>1 grey level</source>
        <translation>1 Graustufe</translation>
    </message>
    <message>
        <source>the reference itself</source>
        <translation>die Referenz selbst</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::StatusLine</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Value under the cursor</source>
        <translation>Wert unter dem Zeiger</translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation>Letztes Bild</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Cancel the running job</source>
        <translation>Laufende Aufgabe abbrechen</translation>
    </message>
    <message>
        <source>Stops what is running (Ctrl+.)</source>
        <translation>Hält an, was läuft (Strg+.)</translation>
    </message>
    <message>
        <source>All running jobs: choose one to cancel it</source>
        <translation>Alle laufenden Aufgaben: eine wählen, um sie abzubrechen</translation>
    </message>
    <message>
        <source>All running jobs</source>
        <translation>Alle laufenden Aufgaben</translation>
    </message>
    <message>
        <source>%1 · %2 ms%3 · %4 MiB</source>
        <translation>%1 · %2 ms%3 · %4 MiB</translation>
    </message>
    <message>
        <source> (coarse)</source>
        <translation> (grob)</translation>
    </message>
    <message>
        <source>+%1</source>
        <translation>+%1</translation>
    </message>
    <message>
        <source>Cancel: %1</source>
        <translation>Abbrechen: %1</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::TaskList</name>
    <message>
        <source>a few seconds left</source>
        <translation>noch ein paar Sekunden</translation>
    </message>
    <message>
        <source>about %1 s left</source>
        <translation>noch etwa %1 s</translation>
    </message>
    <message numerus="yes">
        <source>about %n min left</source>
        <translation>
            <numerusform>noch etwa %n min</numerusform>
            <numerusform>noch etwa %n min</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 · paused</source>
        <translation>%1 · angehalten</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::TransferPanel</name>
    <message>
        <source>Load…</source>
        <translation>Laden…</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Sichern…</translation>
    </message>
    <message>
        <source>Transfer function</source>
        <translation>Transferfunktion</translation>
    </message>
    <message>
        <source>Load a transfer function file</source>
        <translation>Transferfunktion aus einer Datei laden</translation>
    </message>
    <message>
        <source>Save the transfer function to a file</source>
        <translation>Transferfunktion in eine Datei sichern</translation>
    </message>
    <message>
        <source>Load a transfer function</source>
        <translation>Transferfunktion laden</translation>
    </message>
    <message>
        <source>Shapes of value and gradient are in use: points give the colours of projections.</source>
        <translation>Formen aus Wert und Gradient sind an: Punkte geben die Farben der Projektionen.</translation>
    </message>
    <message>
        <source>&amp;Log</source>
        <translation>&amp;Log</translation>
    </message>
    <message>
        <source>Whose colours are edited</source>
        <translation>Wessen Farben bearbeitet werden</translation>
    </message>
    <message>
        <source>The scene&apos;s transfer function, or a segmentation range&apos;s own</source>
        <translation>Die Transferfunktion der Szene oder die eigene eines Segmentierungsbereichs</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Gradient</source>
        <translation>Gradient</translation>
    </message>
    <message>
        <source>Value × gradient</source>
        <translation>Wert × Gradient</translation>
    </message>
    <message>
        <source>What opacity depends on</source>
        <translation>Wovon die Deckkraft abhängt</translation>
    </message>
    <message>
        <source>Whole volume</source>
        <translation>Ganzes Volumen</translation>
    </message>
    <message>
        <source>Shown part</source>
        <translation>Gezeigter Teil</translation>
    </message>
    <message>
        <source>What the histogram counts</source>
        <translation>Was das Histogramm zählt</translation>
    </message>
    <message>
        <source>Counts all voxels, or those inside the cuts and ranges in use</source>
        <translation>Zählt alle Voxel oder die innerhalb der Schnitte und Bereiche, die an sind</translation>
    </message>
    <message>
        <source>Logarithmic histogram</source>
        <translation>Logarithmisches Histogramm</translation>
    </message>
    <message>
        <source>Colour ma&amp;p</source>
        <translation>&amp;Farbkarte</translation>
    </message>
    <message>
        <source>Give the points the colours of a map</source>
        <translation>Den Punkten die Farben einer Karte geben</translation>
    </message>
    <message>
        <source>Gives the points the colours of a map: all of them, or those selected where there are several</source>
        <translation>Gibt den Punkten die Farben einer Karte: allen oder den gewählten, wo es mehrere sind</translation>
    </message>
    <message>
        <source>Reverse the colours</source>
        <translation>Farben umkehren</translation>
    </message>
    <message>
        <source>Scene&apos;s colours</source>
        <translation>Farben der Szene</translation>
    </message>
    <message>
        <source>Colours of %1</source>
        <translation>Farben von %1</translation>
    </message>
    <message>
        <source>Own colours of %1</source>
        <translation>Eigene Farben von %1</translation>
    </message>
    <message>
        <source>Colour map %1</source>
        <translation>Farbkarte %1</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::TransferPlot</name>
    <message>
        <source>Transfer function</source>
        <translation>Transferfunktion</translation>
    </message>
    <message>
        <source>%1 → %2</source>
        <translation>%1 → %2</translation>
    </message>
    <message>
        <source>Arrow keys move the selected points, Page Up and Page Down select another, Control A all, Insert adds one, Delete removes them, Enter chooses the colour.</source>
        <translation>Pfeiltasten bewegen die gewählten Punkte, Bild auf und Bild ab wählen einen anderen, Strg A alle, Einfg fügt einen hinzu, Entf entfernt sie, Eingabe wählt die Farbe.</translation>
    </message>
    <message>
        <source>Drag points · drag a box to select several · double click adds one · Delete removes it · right click chooses its colour · wheel zooms the value axis · points snap to peaks and valleys, not with Alt</source>
        <translation>Punkte ziehen · einen Kasten ziehen, um mehrere zu wählen · Doppelklick fügt einen hinzu · Entf entfernt ihn · Rechtsklick wählt seine Farbe · Rad vergrößert die Wertachse · Punkte rasten an Spitzen und Tälern ein, mit Alt nicht</translation>
    </message>
    <message numerus="yes">
        <source>%n points selected</source>
        <translation>
            <numerusform>%n Punkt gewählt</numerusform>
            <numerusform>%n Punkte gewählt</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>lacuna::ui::ValueSlider</name>
    <message>
        <source>%1, number</source>
        <translation>%1, Zahl</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::ViewHistoryFeature</name>
    <message>
        <source>Prev&amp;ious view</source>
        <translation>V&amp;orige Ansicht</translation>
    </message>
    <message>
        <source>&amp;Next view</source>
        <translation>&amp;Nächste Ansicht</translation>
    </message>
    <message>
        <source>3D view</source>
        <translation>3D-Ansicht</translation>
    </message>
    <message>
        <source>cross-hair</source>
        <translation>Fadenkreuz</translation>
    </message>
    <message>
        <source>3D view and cross-hair</source>
        <translation>3D-Ansicht und Fadenkreuz</translation>
    </message>
    <message>
        <source>Prev&amp;ious view: %1</source>
        <translation>V&amp;orige Ansicht: %1</translation>
    </message>
    <message>
        <source>&amp;Next view: %1</source>
        <translation>&amp;Nächste Ansicht: %1</translation>
    </message>
    <message>
        <source>zoom of a slice</source>
        <translation>Zoom einer Schicht</translation>
    </message>
    <message>
        <source>several views</source>
        <translation>mehrere Ansichten</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::VolumeView</name>
    <message>
        <source>3D view</source>
        <translation>3D-Ansicht</translation>
    </message>
    <message>
        <source>Arrow keys turn the volume, Shift and arrow keys move it, plus and minus zoom, Home resets; A, P, L, R, H and F look from a side.</source>
        <translation>Pfeiltasten drehen das Volumen, Umschalt und Pfeiltasten verschieben es, Plus und Minus vergrößern und verkleinern, Pos1 setzt zurück; A, P, L, R, H und F blicken von einer Seite.</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::WelcomePage</name>
    <message>
        <source>Drop a DICOM folder or a volume file here, or open one.</source>
        <translation>Einen DICOM-Ordner oder eine Volumendatei hier ablegen oder öffnen.</translation>
    </message>
    <message>
        <source>Open folder…</source>
        <translation>Ordner öffnen…</translation>
    </message>
    <message>
        <source>Open file…</source>
        <translation>Datei öffnen…</translation>
    </message>
    <message>
        <source>Sample: casting</source>
        <translation>Beispiel: Gussteil</translation>
    </message>
    <message>
        <source>Sample: head</source>
        <translation>Beispiel: Kopf</translation>
    </message>
    <message>
        <source>Not a medical device. Not for diagnosis.</source>
        <translation>Kein Medizinprodukt. Nicht für die Diagnose.</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::Workbench</name>
    <message>
        <source>&amp;Panels</source>
        <translation>&amp;Tafeln</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Go</source>
        <translation>&amp;Gehe zu</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Messen</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>&amp;Werkzeuge</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
</context>
<context>
    <name>lacuna::ui::Workstation</name>
    <message>
        <source>The language changes as soon as the running jobs have ended.</source>
        <translation>Die Sprache wechselt, sobald die laufenden Aufgaben beendet sind.</translation>
    </message>
</context>
</TS>
