#include "ui/dialogs/settings_dialog.h"

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QTabWidget>
#include <QVBoxLayout>

#include "core/compute/device_list.h"
#include "ui/core_sentences.h"
#include "ui/number_text.h"
#include "ui/preferences.h"
#include "ui/theme_control.h"
#include "ui/widgets/row_table.h"

namespace lacuna::ui {

namespace {
constexpr int k_memory_step_mib = 512, k_memory_most_mib = 1 << 20;
}

SettingsDialog::SettingsDialog(QWidget* parent)
    : QDialog(parent),
      language_(new QComboBox(this)),
      theme_(new QComboBox(this)),
      device_(new QComboBox(this)),
      memory_(new QSpinBox(this)),
      autosave_(new QSpinBox(this)),
      hide_patient_(new QCheckBox(tr("&Hide names, identifiers and dates of patients"), this)),
      open_folder_(new QLineEdit(this)),
      save_folder_(new QLineEdit(this)),
      devices_(new QTableWidget(0, 4, this)),
      why_(new QLabel(this)),
      measure_(new QPushButton(tr("&Measure again"), this)),
      list_job_(this) {
    setWindowTitle(tr("Settings"));
    resize(620, 460);
    auto* pages = new QTabWidget(this);
    pages->setAccessibleName(tr("Pages of settings"));
    pages->addTab(generalPage(), tr("&General"));
    pages->addTab(computePage(), tr("&Computing"));
    pages->addTab(folderPage(), tr("&Folders and privacy"));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    buttons->button(QDialogButtonBox::Ok)->setAccessibleName(tr("Keep the settings"));
    buttons->button(QDialogButtonBox::Cancel)->setAccessibleName(tr("Leave the settings as they were"));
    connect(buttons, &QDialogButtonBox::accepted, this, &SettingsDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* column = new QVBoxLayout(this);
    column->addWidget(pages, 1);
    column->addWidget(buttons);
    listDevices(false);
}

QWidget* SettingsDialog::generalPage() {
    auto* page = new QWidget(this);
    auto* form = new QFormLayout(page);
    language_->setAccessibleName(tr("Language"));
    language_->addItem(tr("As the system"), QString());
    language_->addItem(QStringLiteral("English"), QStringLiteral("en"));
    language_->addItem(QStringLiteral("Deutsch"), QStringLiteral("de"));
    language_->setCurrentIndex(std::max(0, language_->findData(preferences::language())));
    theme_->setAccessibleName(tr("Theme"));
    theme_->addItem(tr("As the system"), int(ThemeChoice::system));
    theme_->addItem(tr("Dark"), int(ThemeChoice::dark));
    theme_->addItem(tr("Light"), int(ThemeChoice::light));
    theme_->setCurrentIndex(theme_->findData(int(ThemeControl::instance()->choice())));
    autosave_->setAccessibleName(tr("Minutes between automatic saves"));
    autosave_->setRange(0, 60);
    autosave_->setSuffix(tr(" min"));
    autosave_->setSpecialValueText(tr("never"));
    autosave_->setToolTip(tr("The session is kept beside its file, so that it comes back after a crash"));
    autosave_->setValue(preferences::autosave_minutes());
    form->addRow(tr("&Language"), language_);
    form->addRow(tr("&Theme"), theme_);
    form->addRow(tr("&Save the session every"), autosave_);
    return page;
}

QWidget* SettingsDialog::computePage() {
    auto* page = new QWidget(this);
    auto* column = new QVBoxLayout(page);
    auto* form = new QFormLayout;
    device_->setAccessibleName(tr("Device"));
    device_->addItem(tr("The fastest one"), QString());
    device_->addItem(tr("None (the slower built-in renderer)"), QStringLiteral("none"));
    memory_->setAccessibleName(tr("Memory limit"));
    memory_->setRange(0, k_memory_most_mib);
    memory_->setSingleStep(k_memory_step_mib);
    memory_->setSuffix(tr(" MiB"));
    memory_->setSpecialValueText(tr("75 % of the machine's"));
    memory_->setToolTip(tr("Host and device memory together; larger volumes are not opened in the window"));
    memory_->setValue(preferences::memory_limit_mib());
    form->addRow(tr("&Device"), device_);
    form->addRow(tr("M&emory limit"), memory_);
    column->addLayout(form);
    devices_->setAccessibleName(tr("Devices found, with their times"));
    devices_->setHorizontalHeaderLabels({tr("Device"), tr("Kind"), tr("Memory"), tr("Time")});
    devices_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    devices_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    choose_rows_of(devices_);
    column->addWidget(devices_, 1);
    why_->setWordWrap(true);
    why_->setAccessibleName(tr("Why the fastest one is it"));
    auto* foot = new QHBoxLayout;
    foot->addWidget(why_, 1);
    measure_->setAccessibleName(tr("Measure the devices again"));
    measure_->setToolTip(tr("Tests every device and times it with a short rendering"));
    foot->addWidget(measure_);
    column->addLayout(foot);
    connect(measure_, &QPushButton::clicked, this, &SettingsDialog::measure);
    return page;
}

QWidget* SettingsDialog::folderPage() {
    auto* page = new QWidget(this);
    auto* form = new QFormLayout(page);
    open_folder_->setText(preferences::open_folder());
    save_folder_->setText(preferences::save_folder());
    hide_patient_->setAccessibleName(tr("Hide names, identifiers and dates of patients"));
    hide_patient_->setChecked(preferences::hide_patient());
    const auto add = [&](const QString& label, QLineEdit* edit, const QString& title) {
        QWidget* row = folderRow(edit, title);
        form->addRow(label, row);
        static_cast<QLabel*>(form->labelForField(row))->setBuddy(edit);
        return row->findChild<QPushButton*>();
    };
    add(tr("&Open from"), open_folder_, tr("Folder to open from"));
    QPushButton* last = add(tr("&Write to"), save_folder_, tr("Folder to write to"));
    form->addRow(hide_patient_);
    setTabOrder(last, hide_patient_);
    return page;
}

QWidget* SettingsDialog::folderRow(QLineEdit* edit, const QString& title) {
    auto* row = new QWidget(this);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    edit->setAccessibleName(title);
    edit->setPlaceholderText(tr("the last one used"));
    edit->setClearButtonEnabled(true);
    auto* choose = new QPushButton(tr("Choose…"), row);
    choose->setAccessibleName(tr("Choose: %1").arg(title));
    connect(choose, &QPushButton::clicked, this, [this, edit, title] {
        const QString folder = QFileDialog::getExistingDirectory(this, title, edit->text());
        if (!folder.isEmpty()) edit->setText(folder);
    });
    layout->addWidget(edit, 1);
    layout->addWidget(choose);
    setTabOrder(edit, choose);
    return row;
}

void SettingsDialog::measure() { listDevices(true); }

void SettingsDialog::listDevices(bool again) {
    measure_->setEnabled(false);
    why_->setText(tr("Measuring…"));
    list_job_.start(
        [again](const JobContext& job) {
            if (again) forget_measurements();
            return list_devices(true, job);
        },
        [this](Outcome<std::vector<DeviceInfo>> outcome) {
            measure_->setEnabled(true);
            if (const Error* error = std::get_if<Error>(&outcome))
                why_->setText(core_sentence(error->what()));
            else
                showDevices(std::get<0>(outcome));
            Q_EMIT measured();
        });
}

void SettingsDialog::showDevices(const std::vector<DeviceInfo>& devices) {
    const int fastest = fastest_index(devices);
    const QString kept = device_->count() > 2 ? device_->currentData().toString() : preferences::device();
    while (device_->count() > 2) device_->removeItem(2);
    devices_->setRowCount(int(devices.size()));
    for (int row = 0; row < int(devices.size()); ++row) {
        const DeviceInfo& info = devices[std::size_t(row)];
        const QString name = QString::fromStdString(info.name);
        device_->addItem(name, name);
        const QString time = !info.usable ? tr("cannot be used") : tr("%1 ms").arg(number_text(info.rank_ms, 'f', 2));
        const QString cells[] = {name,
                                 info.is_gpu   ? tr("graphics card")
                                 : info.is_cpu ? tr("processor")
                                               : tr("other"),
                                 tr("%1 GiB").arg(number_text(double(info.memory_bytes) / double(1 << 30), 'f', 1)),
                                 time};
        for (int column = 0; column < 4; ++column) {
            auto* cell = new QTableWidgetItem(cells[column]);
            cell->setToolTip(info.usable ? name : core_sentence(info.fault));
            if (info.index == fastest) {
                QFont bold = devices_->font();
                bold.setBold(true);
                cell->setFont(bold);
            }
            devices_->setItem(row, column, cell);
        }
    }
    why_->setText(devices.empty() ? tr("No OpenCL device was found.")
                  : fastest < 0   ? tr("No device can be used.")
                                  : tr("The fastest one is in bold."));
    const int at = device_->findData(kept);
    if (at < 0) device_->addItem(tr("%1 (not found now)").arg(kept), kept);
    device_->setCurrentIndex(device_->findData(kept));
}

void SettingsDialog::accept() {
    // Until the devices were listed the box does not hold the kept one yet.
    const bool listed = device_->count() > 2 || device_->currentIndex() > 0;
    const QString device = listed ? device_->currentData().toString() : preferences::device();
    const bool engine = device != preferences::device() || memory_->value() != preferences::memory_limit_mib();
    preferences::set_device(device);
    preferences::set_memory_limit_mib(memory_->value());
    preferences::set_autosave_minutes(autosave_->value());
    preferences::set_hide_patient(hide_patient_->isChecked());
    preferences::set_open_folder(open_folder_->text().trimmed());
    preferences::set_save_folder(save_folder_->text().trimmed());
    ThemeControl::instance()->choose(ThemeChoice(theme_->currentData().toInt()));
    const QString language = language_->currentData().toString();
    QDialog::accept();
    if (engine) Q_EMIT engineChosen();
    Q_EMIT preferencesChanged();
    if (language != preferences::language()) {
        preferences::set_language(language);
        Q_EMIT languageChosen();
    }
}

}  // namespace lacuna::ui
