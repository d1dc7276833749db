#include "ui/dialogs/batch_dialog.h"

#include <QDesktopServices>
#include <QDir>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QToolButton>
#include <QUrl>
#include <QVBoxLayout>

#include "core/base/parallel.h"

#include "ui/core_sentences.h"
#include "ui/file_choice.h"
#include "ui/memory_limit.h"
#include "ui/widgets/short_words.h"

namespace lacuna::ui {

BatchDialog::BatchDialog(TaskList* tasks, DeviceSource device, QWidget* parent)
    : QDialog(parent),
      device_(std::move(device)),
      jobs_(new QSpinBox(this)),
      resume_(new QCheckBox(tr("&Go on with the series that stands in the report folder"), this)),
      start_(new QPushButton(tr("&Start"), this)),
      pause_(new QPushButton(tr("&Pause"), this)),
      cancel_(new QPushButton(tr("&Cancel the series"), this)),
      open_(new QPushButton(tr("&Open the summary"), this)),
      message_(new QLabel(this)),
      model_(new BatchModel(this)),
      table_(new QTableView(this)),
      gate_(std::make_shared<Gate>()),
      prepare_(this, tasks, AtStake::nothing),
      job_(this, tasks) {
    setWindowTitle(tr("Inspect a series of parts"));
    resize(820, 560);
    build();
    connectButtons();
    showRunning(false);
    open_->setEnabled(false);
}

BatchDialog::~BatchDialog() { setPaused(false); }

QLineEdit* BatchDialog::addPathRow(QFormLayout* form, const QString& label, const QString& tip,
                                   std::function<QString()> browse) {
    auto* row = new QHBoxLayout;
    auto* edit = new QLineEdit(this);
    auto* button = new QToolButton(this);
    QString name = label;
    name.remove(QLatin1Char('&'));
    edit->setAccessibleName(name);
    edit->setToolTip(tip);
    button->setText(QStringLiteral("…"));
    button->setAccessibleName(tr("Browse: %1").arg(name));
    browse_.push_back(button);
    connect(button, &QToolButton::clicked, this, [edit, browse = std::move(browse)] {
        if (const QString chosen = browse(); !chosen.isEmpty()) edit->setText(chosen);
    });
    row->addWidget(edit, 1);
    row->addWidget(button);
    auto* title = new QLabel(label, this);
    title->setBuddy(edit);
    form->addRow(title, row);
    return edit;
}

void BatchDialog::build() {
    auto* column = new QVBoxLayout(this);
    auto* form = new QFormLayout;
    column->addLayout(form);
    parts_ = addPathRow(form, tr("P&arts"), tr("A folder with one part a sub-folder or file, or a list file"),
                        [this] { return file_choice::open_folder(this, tr("Folder of the parts"), FileKind::parts); });
    criteria_ = addPathRow(form, tr("C&riteria"), tr("JSON file: material, defects, limits, zones"), [this] {
        return file_choice::open_file(this, tr("Criteria"), FileKind::criteria, tr("Criteria (*.json);;All files (*)"));
    });
    report_ = addPathRow(form, tr("R&eport folder"), tr("Gets the summary and one report folder a part"), [this] {
        return file_choice::open_folder(this, tr("Report folder"), FileKind::report, true);
    });
    reference_ = addPathRow(form, tr("Re&ference part"), tr("Deviations are told from it; may stay empty"),
                            [this] { return file_choice::open_folder(this, tr("Reference part"), FileKind::parts); });
    jobs_->setRange(1, std::max(1, thread_count()));
    jobs_->setAccessibleName(tr("Parts at once"));
    jobs_->setToolTip(tr("At most so many parts at once; fewer where the memory ends"));
    form->addRow(tr("Parts at o&nce"), jobs_);
    form->addRow(QString(), resume_);
    table_->setModel(model_);
    table_->setAccessibleName(tr("Parts of the series"));
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setTabKeyNavigation(false);
    table_->horizontalHeader()->setStretchLastSection(true);
    table_->setColumnWidth(BatchModel::k_name, 200);
    column->addWidget(table_, 1);
    message_->setWordWrap(true);
    message_->setTextFormat(Qt::PlainText);
    message_->setAccessibleName(tr("What became of the series"));
    column->addWidget(message_);
    auto* buttons = new QHBoxLayout;
    column->addLayout(buttons);
    buttons->addWidget(open_);
    buttons->addStretch(1);
    pause_->setCheckable(true);
    for (QPushButton* button : {cancel_, pause_, start_}) buttons->addWidget(button);
    start_->setDefault(true);
    parts_->setFocus();
}

void BatchDialog::connectButtons() {
    connect(start_, &QPushButton::clicked, this, &BatchDialog::prepare);
    connect(cancel_, &QPushButton::clicked, this, [this] {
        prepare_.cancel();
        job_.cancel();
    });
    connect(pause_, &QPushButton::toggled, this, &BatchDialog::setPaused);
    connect(open_, &QPushButton::clicked, this, [this] { QDesktopServices::openUrl(QUrl::fromLocalFile(summary_)); });
}

void BatchDialog::setPaused(bool paused) {
    {
        const std::lock_guard lock(gate_->mutex);
        gate_->paused = paused;
    }
    gate_->changed.notify_all();
    pause_->setText(paused ? tr("&Continue") : tr("&Pause"));
    job_.pause(paused ? [this] { pause_->setChecked(false); } : std::function<void()>());
    if (job_.running())
        message_->setText(paused ? tr("Paused: parts in work stop at their next step.") : tr("Inspecting…"));
}

void BatchDialog::showRunning(bool running) {
    for (QWidget* widget :
         {static_cast<QWidget*>(parts_), static_cast<QWidget*>(criteria_), static_cast<QWidget*>(report_),
          static_cast<QWidget*>(reference_), static_cast<QWidget*>(jobs_), static_cast<QWidget*>(resume_),
          static_cast<QWidget*>(start_)})
        widget->setEnabled(!running);
    for (QToolButton* button : browse_) button->setEnabled(!running);
    cancel_->setEnabled(running);
    pause_->setEnabled(running);
    if (!running) pause_->setChecked(false);
}

/// What is asked for is read and looked through off the window's thread: it may lie far away.
void BatchDialog::prepare() {
    Prepared asked;
    asked.options.folder = report_->text().trimmed().toStdString();
    asked.options.reference = reference_->text().trimmed().toStdString();
    asked.options.jobs = jobs_->value();
    asked.options.resume = resume_->isChecked();
    asked.options.memory_bytes = memory_limit_bytes();
    asked.options.software = "Lacuna " LACUNA_VERSION;
    const std::string parts = parts_->text().trimmed().toStdString();
    const std::string criteria = criteria_->text().trimmed().toStdString();
    const auto missing = [this](QLineEdit* field, const QString& words) {
        message_->setText(words);
        field->setFocus();
    };
    if (parts.empty()) return missing(parts_, tr("Name the folder of the parts, or a list of them."));
    if (criteria.empty())
        return missing(criteria_, tr("Name a file of criteria. The inspection panel writes one: Save criteria."));
    if (asked.options.folder.empty()) return missing(report_, tr("Name a report folder."));
    prepare_.start(
        tr("Looking for the parts"),
        [asked, parts, criteria](const JobContext&) mutable {
            asked.options.criteria = read_criteria(criteria);
            asked.parts = find_parts({parts}, asked.options.folder);
            return asked;
        },
        [this](Outcome<Prepared> outcome) {
            if (Prepared* prepared = std::get_if<Prepared>(&outcome)) return start(std::move(*prepared));
            showRunning(false);
            const Error& error = std::get<Error>(outcome);
            message_->setText(error.code() == Errc::cancelled ? tr("Cancelled.")
                                                              : with_short_words(core_sentence(error.what())));
            Q_EMIT finished();
        });
    showRunning(true);
    pause_->setEnabled(false);
    message_->setText(tr("Looking for the parts…"));
}

void BatchDialog::start(Prepared prepared) {
    auto& [options, parts] = prepared;
    model_->setParts(parts);
    open_->setEnabled(false);
    job_.start(
        tr("Inspecting a series"),
        [parts = std::move(parts), options = std::move(options), device = device_, gate = gate_,
         model = model_](const JobContext& job) mutable {
            options.on_part = [gate, model, stop = job.stop](std::size_t part, PartState state, double progress) {
                // The model outlives the work: the job ends before the dialog does.
                QMetaObject::invokeMethod(
                    model,
                    [model, part, state, progress, stop] {
                        if (!stop.stop_requested()) model->setState(part, state, progress);
                    },
                    Qt::QueuedConnection);
                std::unique_lock lock(gate->mutex);
                gate->changed.wait(lock, stop, [&] { return !gate->paused; });
            };
            options.device = device({job.stop, nullptr});
            return run_batch(parts, options, job);
        },
        [this](Outcome<BatchResult> outcome) { tell(outcome); });
    showRunning(true);
    message_->setText(tr("Inspecting…"));
}

void BatchDialog::tell(const Outcome<BatchResult>& outcome) {
    showRunning(false);
    if (const Error* error = std::get_if<Error>(&outcome)) {
        model_->stopRunning();
        resume_->setChecked(true);
        message_->setText(error->code() == Errc::cancelled ? tr("Cancelled after %n part(s); start again to go on.",
                                                                nullptr, model_->finishedParts())
                                                           : with_short_words(core_sentence(error->what())));
    } else {
        const BatchResult& result = std::get<0>(outcome);
        model_->setRows(result.rows);
        int passed = 0, failed = 0, open = 0, broken = 0;
        for (const BatchRow& row : result.rows)
            ++(!row.verdict                    ? broken
               : *row.verdict == Verdict::pass ? passed
               : *row.verdict == Verdict::fail ? failed
                                               : open);
        message_->setText(tr("%1 pass, %2 fail, %3 cannot tell, %4 broken. The summary stands in %5.")
                              .arg(passed)
                              .arg(failed)
                              .arg(open)
                              .arg(broken)
                              .arg(report_->text().trimmed()));
        summary_ = QDir(report_->text().trimmed()).absoluteFilePath(QStringLiteral("summary.html"));
        open_->setEnabled(result.whole);
    }
    Q_EMIT finished();
}

}  // namespace lacuna::ui
