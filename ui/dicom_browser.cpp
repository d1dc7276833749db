#include "ui/dicom_browser.h"

#include <QDate>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QImage>
#include <QPainter>
#include <QPixmap>
#include <QVBoxLayout>
#include <functional>

#include "ui/core_sentences.h"
#include "ui/file_choice.h"
#include "ui/preferences.h"
#include "ui/tab_chain.h"
#include "ui/widgets/short_words.h"

namespace lacuna::ui {

namespace {

constexpr int k_picture_edge = 64, k_columns = 5;
enum Role { k_folder = Qt::UserRole + 1, k_uid };

/// A stored date, YYYYMMDD, with all four digits of the year; what is none as it is.
QString date_text(const std::string& stored) {
    const QString text = QString::fromStdString(stored);
    const QDate date = QDate::fromString(text, QStringLiteral("yyyyMMdd"));
    return date.isValid() ? date.toString(Qt::ISODate) : text;
}

QList<QStandardItem*> row_of(const QStringList& texts) {
    QList<QStandardItem*> row;
    for (int i = 0; i < k_columns; ++i) {
        row << new QStandardItem(texts.value(i));
        row.back()->setEditable(false);
    }
    return row;
}

QList<QStandardItem*> patient_row(const CataloguePatient& patient, int number) {
    if (preferences::hide_patient()) return row_of({DicomBrowser::tr("Patient %1").arg(number)});
    QString name = QString::fromStdString(person_name(patient.name));
    if (name.isEmpty()) name = DicomBrowser::tr("(no name)");
    if (!patient.id.empty()) name += QStringLiteral("  ·  ") + QString::fromStdString(patient.id);
    return row_of({name, date_text(patient.birth_date)});
}

QList<QStandardItem*> study_row(const CatalogueStudy& study) {
    QString words = QString::fromStdString(study.description);
    if (words.isEmpty()) words = DicomBrowser::tr("(study without a description)");
    QStringList kinds;
    int images = 0;
    for (const CatalogueSeries& series : study.series) {
        images += series.images;
        const QString kind = QString::fromStdString(series.modality);
        if (!kind.isEmpty() && !kinds.contains(kind)) kinds << kind;
    }
    return row_of({words, date_text(study.date), kinds.join(QStringLiteral(", ")), QString::number(images)});
}

/// @param blank  rows do not jump when the picture comes
QList<QStandardItem*> series_row(const CatalogueSeries& series, const QIcon& blank) {
    QString words = QString::fromStdString(series.description);
    if (words.isEmpty()) words = DicomBrowser::tr("(no description)");
    if (series.number > 0) words = QStringLiteral("%1  ").arg(series.number) + words;
    const QString size =
        series.columns > 0 ? QStringLiteral("%1 × %2").arg(series.columns).arg(series.rows) : QString();
    QList<QStandardItem*> row =
        row_of({words, {}, QString::fromStdString(series.modality), QString::number(series.images), size});
    row[0]->setData(QString::fromStdString(folder_of(series).string()), k_folder);
    row[0]->setData(QString::fromStdString(series.uid), k_uid);
    row[0]->setIcon(blank);
    return row;
}

QPixmap picture_of(const CatalogueThumbnail& thumbnail) {
    QImage image(thumbnail.width, thumbnail.height, QImage::Format_Grayscale8);
    for (int y = 0; y < thumbnail.height; ++y)
        std::copy_n(thumbnail.grey.data() + std::size_t(y) * std::size_t(thumbnail.width), thumbnail.width,
                    image.scanLine(y));
    // As large as the others, whatever its shape: the words beside them stand below each other.
    QPixmap picture(k_picture_edge, k_picture_edge);
    picture.fill(Qt::transparent);
    QPainter(&picture).drawImage((k_picture_edge - image.width()) / 2, (k_picture_edge - image.height()) / 2, image);
    return picture;
}

/// Every series with its place in the list.
void each_series(const Catalogue& catalogue, const std::function<void(const CatalogueSeries&, int)>& visit) {
    int index = 0;
    for (const CataloguePatient& patient : catalogue.patients)
        for (const CatalogueStudy& study : patient.studies)
            for (const CatalogueSeries& series : study.series) visit(series, index++);
}

}  // namespace

DicomBrowser::DicomBrowser(TaskList* tasks, QWidget* parent)
    : QDialog(parent),
      path_(new QLineEdit(this)),
      search_(new QLineEdit(this)),
      tree_(new QTreeView(this)),
      status_(new QLabel(this)),
      open_(nullptr),
      model_(new QStandardItemModel(this)),
      filter_(new QSortFilterProxyModel(this)),
      scan_(this, tasks, AtStake::nothing),
      pictures_(this) {
    setWindowTitle(tr("DICOM browser"));
    resize(860, 620);
    auto* column = new QVBoxLayout(this);
    auto* where = new QHBoxLayout;
    path_->setAccessibleName(tr("Folder or DICOMDIR"));
    path_->setPlaceholderText(tr("Choose a folder or a DICOMDIR"));
    auto* folder = new QPushButton(tr("&Folder…"), this);
    auto* directory = new QPushButton(tr("DICOM&DIR…"), this);
    directory->setToolTip(tr("Reads the directory of a disc or stick instead of every file on it"));
    where->addWidget(path_, 1);
    where->addWidget(folder);
    where->addWidget(directory);
    column->addLayout(where);
    search_->setPlaceholderText(tr("Search patients, studies and series"));
    search_->setAccessibleName(tr("Search"));
    search_->setClearButtonEnabled(true);
    column->addWidget(search_);
    filter_->setSourceModel(model_);
    filter_->setRecursiveFilteringEnabled(true);
    filter_->setAutoAcceptChildRows(true);
    filter_->setFilterCaseSensitivity(Qt::CaseInsensitive);
    filter_->setFilterKeyColumn(-1);
    tree_->setModel(filter_);
    tree_->setAccessibleName(tr("Patients, studies and series"));
    tree_->setIconSize({k_picture_edge, k_picture_edge});
    tree_->setAlternatingRowColors(true);
    tree_->setExpandsOnDoubleClick(false);
    column->addWidget(tree_, 1);
    status_->setWordWrap(true);
    column->addWidget(status_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Close, this);
    open_ = buttons->button(QDialogButtonBox::Open);
    open_->setEnabled(false);
    column->addWidget(buttons);
    // Return in the fields is theirs: no button takes it.
    for (QPushButton* button : {folder, directory, open_, buttons->button(QDialogButtonBox::Close)}) {
        button->setAutoDefault(false);
        button->setDefault(false);
    }
    connect(path_, &QLineEdit::returnPressed, this, [this] {
        if (!path_->text().isEmpty()) look(path_->text());
    });
    connect(folder, &QPushButton::clicked, this, &DicomBrowser::chooseFolder);
    connect(directory, &QPushButton::clicked, this, &DicomBrowser::chooseDicomdir);
    connect(search_, &QLineEdit::textChanged, this, [this](const QString& words) {
        filter_->setFilterFixedString(words.trimmed());
        tree_->expandAll();
    });
    connect(tree_, &QTreeView::activated, this, &DicomBrowser::activate);
    connect(tree_->selectionModel(), &QItemSelectionModel::currentChanged, this,
            [this](const QModelIndex& index) { open_->setEnabled(index.siblingAtColumn(0).data(k_uid).isValid()); });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    connect(open_, &QPushButton::clicked, this, &DicomBrowser::openCurrent);
    chain_tabs({folder, directory, search_, tree_, open_});
    showCatalogue(catalogue_);
    status_->clear();
}

DicomBrowser::~DicomBrowser() = default;

void DicomBrowser::chooseFolder() {
    const QString folder = file_choice::open_folder(this, tr("Look for DICOM in a folder"), FileKind::dicom);
    if (!folder.isEmpty()) look(folder);
}

void DicomBrowser::chooseDicomdir() {
    const QString file = file_choice::open_file(this, tr("Read a DICOMDIR"), FileKind::dicom,
                                                tr("DICOMDIR (DICOMDIR dicomdir);;All files (*)"));
    if (!file.isEmpty()) look(file);
}

void DicomBrowser::look(const QString& input) {
    path_->setText(input);
    pictures_.cancel();
    showCatalogue({});
    status_->setText(tr("Looking…"));
    scan_.start(
        tr("Looking for DICOM"),
        [this, folder = input.toStdString()](const JobContext& job) {
            return scan_catalogue(folder, job, [this, job](const Catalogue& so_far) {
                QMetaObject::invokeMethod(
                    this,
                    [this, so_far, stop = job.stop] {
                        if (!stop.stop_requested() && scan_.running()) showCatalogue(so_far);
                    },
                    Qt::QueuedConnection);
            });
        },
        [this](Outcome<Catalogue> outcome) {
            if (const Error* error = std::get_if<Error>(&outcome)) {
                status_->setText(error->code() == Errc::cancelled ? tr("Stopped; this is what was found until then.")
                                                                  : with_short_words(core_sentence(error->what())));
            } else {
                showCatalogue(std::get<0>(outcome));
                say(catalogue_, true);
                addPictures();
            }
            Q_EMIT looked();
        });
}

void DicomBrowser::showCatalogue(const Catalogue& catalogue) {
    catalogue_ = catalogue;
    series_items_.clear();
    model_->clear();
    model_->setHorizontalHeaderLabels({tr("Name"), tr("Date"), tr("Kind"), tr("Images"), tr("Size")});
    QPixmap transparent(k_picture_edge, k_picture_edge);
    transparent.fill(Qt::transparent);
    const QIcon blank(transparent);
    for (const CataloguePatient& patient : catalogue_.patients) {
        const auto of_patient = patient_row(patient, model_->rowCount() + 1);
        for (const CatalogueStudy& study : patient.studies) {
            const auto of_study = study_row(study);
            for (const CatalogueSeries& series : study.series) {
                const auto of_series = series_row(series, blank);
                series_items_.push_back(of_series[0]);
                of_study[0]->appendRow(of_series);
            }
            of_patient[0]->appendRow(of_study);
        }
        model_->appendRow(of_patient);
    }
    tree_->expandAll();
    tree_->header()->setStretchLastSection(false);
    tree_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    say(catalogue_, false);
}

void DicomBrowser::say(const Catalogue& catalogue, bool done) {
    QString words = tr("%n series", nullptr, catalogue.series_count()) + tr(" in %n files", nullptr, catalogue.files);
    if (catalogue.unreadable > 0) words += tr("; %n cannot be read", nullptr, catalogue.unreadable);
    if (catalogue.missing > 0) words += tr("; %n named in the directory are missing", nullptr, catalogue.missing);
    status_->setText(done ? words : words + tr(" so far…"));
}

void DicomBrowser::addPictures() {
    pictures_.start(
        [this, catalogue = catalogue_](const JobContext& job) {
            each_series(catalogue, [&](const CatalogueSeries& series, int index) {
                job.check();
                const CatalogueThumbnail thumbnail = catalogue_thumbnail(series, k_picture_edge, job);
                if (thumbnail.width == 0) return;
                QMetaObject::invokeMethod(
                    this,
                    [this, thumbnail, index, stop = job.stop] {
                        if (!stop.stop_requested() && std::size_t(index) < series_items_.size())
                            series_items_[std::size_t(index)]->setIcon(picture_of(thumbnail));
                    },
                    Qt::QueuedConnection);
            });
            return 0;
        },
        [this](Outcome<int>) { Q_EMIT pictured(); });
}

void DicomBrowser::activate(const QModelIndex& index) {
    const QModelIndex first = index.siblingAtColumn(0);
    if (!first.data(k_uid).isValid()) {
        tree_->setExpanded(first, !tree_->isExpanded(first));
        return;
    }
    Q_EMIT openRequested(first.data(k_folder).toString(), first.data(k_uid).toString());
}

void DicomBrowser::openCurrent() { activate(tree_->currentIndex()); }

int DicomBrowser::seriesShown() const {
    int count = 0;
    for (int p = 0; p < filter_->rowCount(); ++p) {
        const QModelIndex patient = filter_->index(p, 0);
        for (int s = 0; s < filter_->rowCount(patient); ++s) count += filter_->rowCount(filter_->index(s, 0, patient));
    }
    return count;
}

}  // namespace lacuna::ui
