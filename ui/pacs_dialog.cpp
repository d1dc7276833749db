#include "ui/pacs_dialog.h"

#include <QDate>
#include <QDateTime>
#include <QDialogButtonBox>
#include <QDir>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "core/io/dicom_catalogue.h"
#include "ui/core_sentences.h"
#include "ui/file_choice.h"
#include "ui/pacs_server_dialog.h"
#include "ui/preferences.h"

namespace lacuna::ui {

namespace {

enum Role { k_study = Qt::UserRole + 1, k_series, k_asked };

QString text(const std::string& words) { return QString::fromStdString(words); }

/// With all four digits of the year, and sorted by time where sorted by letters.
QString date_text(const std::string& stored) {
    const QDate date = QDate::fromString(text(stored), QStringLiteral("yyyyMMdd"));
    return date.isValid() ? date.toString(Qt::ISODate) : text(stored);
}

QString count_text(int count) { return count > 0 ? QString::number(count) : QString(); }

/// A name with a star behind it, as people mean it who type its start.
std::string started(const QString& words) {
    const QString name = words.trimmed();
    if (name.isEmpty() || name.contains(QLatin1Char('*')) || name.contains(QLatin1Char('?'))) return name.toStdString();
    return name.toStdString() + "*";
}

}  // namespace

PacsDialog::PacsDialog(TaskList* tasks, QWidget* parent)
    : QDialog(parent),
      tasks_(tasks),
      server_(new QComboBox(this)),
      name_(new QLineEdit(this)),
      id_(new QLineEdit(this)),
      accession_(new QLineEdit(this)),
      since_(new QComboBox(this)),
      modality_(new QComboBox(this)),
      results_(new QTreeWidget(this)),
      status_(new QLabel(this)),
      echo_(this, tasks, AtStake::nothing),
      find_(this, tasks, AtStake::nothing),
      series_(this, tasks, AtStake::nothing),
      get_(this, tasks),
      store_(this, tasks) {
    setWindowTitle(tr("DICOM servers (PACS)"));
    resize(900, 620);
    auto* column = new QVBoxLayout(this);
    column->addWidget(makeServerRow());
    column->addWidget(makeQuery());
    results_->setHeaderLabels({tr("Patient / series"), tr("Date"), tr("Kind"), tr("Description"), tr("Images")});
    results_->setAccessibleName(tr("Studies found"));
    results_->setAlternatingRowColors(true);
    for (const int section : {0, 1, 2, 4})
        results_->header()->setSectionResizeMode(section, QHeaderView::ResizeToContents);
    results_->header()->setStretchLastSection(false);
    results_->header()->setSectionResizeMode(3, QHeaderView::Stretch);
    results_->headerItem()->setTextAlignment(4, Qt::AlignRight);
    column->addWidget(results_, 1);
    status_->setWordWrap(true);
    status_->setAccessibleName(tr("What happened last"));
    column->addWidget(status_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    retrieve_ = buttons->addButton(tr("&Retrieve and open…"), QDialogButtonBox::ActionRole);
    retrieve_->setToolTip(
        tr("Copies the chosen series, or the whole study, into a folder and opens it (C-GET, or C-MOVE where the "
           "server is set to)"));
    send_ = buttons->addButton(tr("Send &files…"), QDialogButtonBox::ActionRole);
    send_->setToolTip(tr("Sends DICOM files, such as segmentations, reports and captures, to the server (C-STORE)"));
    for (QPushButton* button : {retrieve_, send_}) button->setAutoDefault(false);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    connect(retrieve_, &QPushButton::clicked, this, &PacsDialog::chooseAndRetrieve);
    connect(send_, &QPushButton::clicked, this, &PacsDialog::chooseAndSend);
    connect(results_, &QTreeWidget::itemExpanded, this, &PacsDialog::loadSeries);
    connect(results_, &QTreeWidget::currentItemChanged, this, &PacsDialog::showEnabled);
    setServers(kept_pacs_servers());
}

PacsDialog::~PacsDialog() = default;

QWidget* PacsDialog::makeServerRow() {
    auto* box = new QWidget(this);
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    auto* label = new QLabel(tr("Ser&ver"), box);
    label->setBuddy(server_);
    server_->setAccessibleName(tr("Server"));
    row->addWidget(label);
    row->addWidget(server_, 1);
    auto* add = new QPushButton(tr("&Add…"), box);
    edit_ = new QPushButton(tr("&Edit…"), box);
    remove_ = new QPushButton(tr("Re&move"), box);
    test_ = new QPushButton(tr("&Test"), box);
    test_->setToolTip(tr("Asks the server whether it is there (C-ECHO)"));
    for (QPushButton* button : {add, edit_, remove_, test_}) {
        button->setAutoDefault(false);
        row->addWidget(button);
    }
    connect(add, &QPushButton::clicked, this, [this] { editServer(true); });
    connect(edit_, &QPushButton::clicked, this, [this] { editServer(false); });
    connect(remove_, &QPushButton::clicked, this, &PacsDialog::removeServer);
    connect(test_, &QPushButton::clicked, this, &PacsDialog::test);
    connect(server_, &QComboBox::currentIndexChanged, this, &PacsDialog::forgetResults);
    return box;
}

QWidget* PacsDialog::makeQuery() {
    auto* box = new QWidget(this);
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    auto* left = new QFormLayout;
    auto* right = new QFormLayout;
    left->addRow(tr("Patient's &name"), name_);
    left->addRow(tr("Patient's &ID"), id_);
    left->addRow(tr("A&ccession number"), accession_);
    name_->setPlaceholderText(tr("Family name; * and ? stand for any letters"));
    const std::pair<QString, int> spans[] = {{tr("Any date"), -1},
                                             {tr("Today"), 0},
                                             {tr("Last 7 days"), 7},
                                             {tr("Last 30 days"), 30},
                                             {tr("Last 12 months"), 365}};
    for (const auto& [words, days] : spans) since_->addItem(words, days);
    modality_->addItem(tr("Any kind"), QString());
    for (const char* kind : {"CT", "MR", "PT", "XA", "CR", "DX", "NM", "SEG", "SR"})
        modality_->addItem(QLatin1String(kind), QLatin1String(kind));
    right->addRow(tr("&Date"), since_);
    right->addRow(tr("&Kind"), modality_);
    search_ = new QPushButton(tr("&Search"), box);
    search_->setDefault(true);
    right->addRow(search_);
    row->addLayout(left, 1);
    row->addLayout(right, 1);
    connect(search_, &QPushButton::clicked, this, &PacsDialog::search);
    return box;
}

void PacsDialog::setServers(const std::vector<PacsServer>& servers) {
    servers_ = servers;
    showServers(0);
}

/// What one server answered, or is still to answer, is not what another has.
void PacsDialog::forgetResults() {
    asked_.clear();  // first: a cancelled question goes on to the next
    find_.cancel();
    series_.cancel();
    results_->clear();
    showEnabled();
}

void PacsDialog::showServers(int row) {
    {
        const QSignalBlocker blocker(server_);
        server_->clear();
        for (const PacsServer& server : servers_)
            server_->addItem(QStringLiteral("%1  —  %2 @ %3:%4")
                                 .arg(text(server.name), text(server.called_aet), text(server.host))
                                 .arg(server.port));
        server_->setCurrentIndex(std::min(row, int(servers_.size()) - 1));
    }
    forgetResults();
    status_->setText(servers_.empty() ? tr("Add a server first.") : QString());
}

const PacsServer* PacsDialog::current() const {
    const int row = server_->currentIndex();
    return row >= 0 && row < int(servers_.size()) ? &servers_[std::size_t(row)] : nullptr;
}

void PacsDialog::editServer(bool fresh) {
    PacsServerDialog dialog(fresh || !current() ? PacsServer{} : *current(), this);
    if (dialog.exec() != QDialog::Accepted) return;
    int row = server_->currentIndex();
    if (fresh || !current()) {
        servers_.push_back(dialog.server());
        row = int(servers_.size()) - 1;
    } else {
        servers_[std::size_t(row)] = dialog.server();
    }
    keep_pacs_servers(servers_);
    showServers(row);
}

void PacsDialog::removeServer() {
    if (!current()) return;
    servers_.erase(servers_.begin() + server_->currentIndex());
    keep_pacs_servers(servers_);
    showServers(0);
}

void PacsDialog::showEnabled() {
    const bool server = current() != nullptr;
    for (QPushButton* button : {edit_, remove_, test_, search_})
        if (button) button->setEnabled(server);
    // A second one would take the place of the first, which would end without a word.
    if (send_) send_->setEnabled(server && !store_.running());
    if (retrieve_) retrieve_->setEnabled(server && results_->currentItem() && !get_.running());
}

template <class T>
bool PacsDialog::failed(const Outcome<T>& outcome) {
    const Error* error = std::get_if<Error>(&outcome);
    if (!error) return false;
    status_->setText(error->code() == Errc::cancelled ? PacsDialog::tr("Cancelled.") : core_sentence(error->what()));
    return true;
}

void PacsDialog::test() {
    if (!current()) return;
    status_->setText(tr("Asking…"));
    echo_.start(
        tr("Testing a DICOM server"),
        [server = *current()](const JobContext& job) {
            pacs_echo(server, job);
            return 0;
        },
        [this](Outcome<int> outcome) {
            if (!failed(outcome)) status_->setText(tr("The server is there and accepts this program."));
            Q_EMIT finished();
        });
}

void PacsDialog::search() {
    if (!current()) return;
    PacsQuery query;
    query.patient_name = started(name_->text());
    query.patient_id = id_->text().trimmed().toStdString();
    query.accession = accession_->text().trimmed().toStdString();
    query.modality = modality_->currentData().toString().toStdString();
    if (const int days = since_->currentData().toInt(); days >= 0)
        query.date_from = QDate::currentDate().addDays(-days).toString(QStringLiteral("yyyyMMdd")).toStdString();
    forgetResults();
    status_->setText(tr("Searching…"));
    find_.start(
        tr("Searching a DICOM server"),
        [server = *current(), query](const JobContext& job) { return find_pacs_studies(server, query, job); },
        [this](Outcome<PacsAnswer<PacsStudy>> outcome) {
            if (!failed(outcome)) showStudies(std::get<0>(outcome));
            Q_EMIT finished();
        });
}

void PacsDialog::showStudies(const PacsAnswer<PacsStudy>& answer) {
    results_->clear();
    std::vector<PacsStudy> newest_first = answer.rows;
    std::stable_sort(newest_first.begin(), newest_first.end(),
                     [](const PacsStudy& a, const PacsStudy& b) { return a.date > b.date; });
    for (const PacsStudy& study : newest_first) {
        const bool hidden = preferences::hide_patient();
        QString who =
            hidden ? tr("Patient %1").arg(results_->topLevelItemCount() + 1) : text(person_name(study.patient_name));
        if (!hidden && !study.patient_id.empty()) who += QStringLiteral("  ·  ") + text(study.patient_id);
        auto* item = new QTreeWidgetItem(results_, {who, date_text(study.date), text(study.modalities),
                                                    text(study.description), count_text(study.images)});
        item->setTextAlignment(4, Qt::AlignRight);
        item->setData(0, k_study, text(study.uid));
        item->setChildIndicatorPolicy(QTreeWidgetItem::ShowIndicator);
    }
    QString words = tr("%n studies found.", nullptr, int(answer.rows.size()));
    if (answer.more) words += tr(" There are more; narrow the search.");
    status_->setText(words);
    if (results_->topLevelItemCount() > 0) results_->setCurrentItem(results_->topLevelItem(0));
}

void PacsDialog::loadSeries(QTreeWidgetItem* study) {
    if (study->parent() || study->data(0, k_asked).toBool()) return;
    study->setData(0, k_asked, true);
    asked_ << study->data(0, k_study).toString();
    askForSeries();
}

/// One study after the other: a start in between would end the one that runs.
void PacsDialog::askForSeries() {
    if (!current() || asked_.isEmpty() || series_.running()) return;
    const QString uid = asked_.takeFirst();
    series_.start(
        tr("Asking for the series of a study"),
        [server = *current(), study_uid = uid.toStdString()](const JobContext& job) {
            return find_pacs_series(server, study_uid, job);
        },
        [this, uid](Outcome<PacsAnswer<PacsSeries>> outcome) {
            QTreeWidgetItem* parent = nullptr;
            for (int i = 0; i < results_->topLevelItemCount(); ++i)
                if (results_->topLevelItem(i)->data(0, k_study).toString() == uid) parent = results_->topLevelItem(i);
            if (failed(outcome)) {
                if (parent) parent->setData(0, k_asked, false);
            } else if (parent) {
                for (const PacsSeries& series : std::get<0>(outcome).rows) {
                    auto* item = new QTreeWidgetItem(
                        parent, {tr("Series %1").arg(series.number), QString(), text(series.modality),
                                 text(series.description), count_text(series.images)});
                    item->setTextAlignment(4, Qt::AlignRight);
                    item->setData(0, k_study, uid);
                    item->setData(0, k_series, text(series.uid));
                }
            }
            Q_EMIT finished();
            askForSeries();
        });
}

void PacsDialog::chooseAndRetrieve() {
    if (!results_->currentItem()) return;
    const QString parent = file_choice::open_folder(this, tr("Folder to retrieve into"), FileKind::retrieved, true);
    if (parent.isEmpty()) return;
    // Named by time, not by the patient.
    const QString stamp = QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss"));
    retrieve(QDir(parent).filePath(QStringLiteral("dicom-") + stamp));
}

void PacsDialog::retrieve(const QString& folder) {
    QTreeWidgetItem* item = results_->currentItem();
    if (!current() || !item || get_.running()) return;
    status_->setText(tr("Retrieving…"));
    get_.start(
        tr("Retrieving from a DICOM server"),
        [server = *current(), study = item->data(0, k_study).toString().toStdString(),
         series = item->data(0, k_series).toString().toStdString(), target = folder.toStdString()](
            const JobContext& job) { return retrieve_from_pacs(server, study, series, target, job); },
        [this, folder](Outcome<PacsTransfer> outcome) {
            showEnabled();
            if (!failed(outcome)) {
                const PacsTransfer& transfer = std::get<0>(outcome);
                QString words = tr("%n files retrieved.", nullptr, transfer.done);
                if (transfer.failed > 0) words += tr(" The server could not send %n.", nullptr, transfer.failed);
                if (!transfer.fault.empty()) words += tr(" It is not all: %1").arg(core_sentence(transfer.fault));
                if (transfer.failed > 0 || !transfer.fault.empty()) Q_EMIT tasks_->failed();
                status_->setText(words);
                Q_EMIT retrieved(folder);
            }
            Q_EMIT finished();
        });
    showEnabled();
}

void PacsDialog::chooseAndSend() {
    const QStringList files = file_choice::open_files(this, tr("DICOM files to send"), FileKind::dicom,
                                                      tr("DICOM files (*.dcm);;All files (*)"));
    if (!files.isEmpty()) send(files);
}

void PacsDialog::send(const QStringList& files) {
    if (!current() || store_.running()) return;
    std::vector<std::filesystem::path> paths;
    for (const QString& file : files) paths.emplace_back(file.toStdString());
    status_->setText(tr("Sending…"));
    store_.start(
        tr("Sending to a DICOM server"),
        [server = *current(), paths](const JobContext& job) { return send_to_pacs(server, paths, job); },
        [this](Outcome<PacsTransfer> outcome) {
            showEnabled();
            if (!failed(outcome)) {
                const PacsTransfer& transfer = std::get<0>(outcome);
                QString words = tr("%n files sent.", nullptr, transfer.done);
                if (transfer.failed > 0) {
                    words += tr(" The server did not take %n.", nullptr, transfer.failed);
                    Q_EMIT tasks_->failed();
                }
                status_->setText(words);
            }
            Q_EMIT finished();
        });
    showEnabled();
}

}  // namespace lacuna::ui
