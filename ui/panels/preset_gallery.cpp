#include "ui/panels/preset_gallery.h"

#include <QGridLayout>
#include <QKeyEvent>
#include <QPainter>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/core_sentences.h"
#include "ui/preset_thumbnails.h"
#include "ui/preset_title.h"
#include "ui/theme.h"

namespace lacuna::ui {

namespace {

/// The picture on the views' ground; an empty frame while there is none, a sign where there can be none.
QIcon icon_of(const QImage& picture, bool broken) {
    QPixmap ground(PresetThumbnails::k_size);
    ground.fill(theme::k_base);
    QPainter painter(&ground);
    if (!picture.isNull()) painter.drawImage(0, 0, picture);
    if (broken) {
        painter.setPen(theme::k_warning);
        QFont large = painter.font();
        large.setPointSizeF(26);
        painter.setFont(large);
        painter.drawText(ground.rect(), Qt::AlignCenter, QStringLiteral("!"));
    }
    return QIcon(ground);
}

}  // namespace

PresetGallery::PresetGallery(QWidget* parent)
    : QWidget(parent),
      list_(new QListWidget(this)),
      technique_(new QCheckBox(tr("With mode, shading and step"), this)),
      apply_(new QPushButton(tr("Show"), this)),
      save_(new QPushButton(tr("Save as…"), this)),
      rename_(new QPushButton(tr("Rename…"), this)),
      remove_(new QPushButton(tr("Delete"), this)),
      import_(new QPushButton(tr("Import…"), this)),
      export_(new QPushButton(tr("Export…"), this)) {
    build();
    const auto with_chosen = [this](auto signal) {
        return [this, signal] {
            if (const PresetEntry* entry = chosen()) Q_EMIT(this->*signal)(*entry);
        };
    };
    connect(list_, &QListWidget::currentRowChanged, this, &PresetGallery::showChosen);
    connect(list_, &QListWidget::itemDoubleClicked, this, with_chosen(&PresetGallery::applyRequested));
    connect(list_->verticalScrollBar(), &QScrollBar::valueChanged, this, &PresetGallery::shown);
    connect(apply_, &QPushButton::clicked, this, with_chosen(&PresetGallery::applyRequested));
    connect(save_, &QPushButton::clicked, this, &PresetGallery::saveRequested);
    connect(rename_, &QPushButton::clicked, this, with_chosen(&PresetGallery::renameRequested));
    connect(remove_, &QPushButton::clicked, this, with_chosen(&PresetGallery::removeRequested));
    connect(import_, &QPushButton::clicked, this, &PresetGallery::importRequested);
    connect(export_, &QPushButton::clicked, this, with_chosen(&PresetGallery::exportRequested));
    showChosen();
}

void PresetGallery::build() {
    list_->setViewMode(QListView::IconMode);
    list_->setIconSize(PresetThumbnails::k_size);
    list_->setGridSize(PresetThumbnails::k_size + QSize(12, 28));
    list_->setResizeMode(QListView::Adjust);
    list_->setMovement(QListView::Static);
    list_->setUniformItemSizes(true);
    list_->setWordWrap(false);
    list_->setTextElideMode(Qt::ElideRight);
    list_->setAccessibleName(tr("Presets"));
    list_->installEventFilter(this);
    technique_->setChecked(true);
    technique_->setToolTip(tr("Also takes the view mode, the shading and the step the preset was made for"));
    apply_->setAccessibleName(tr("Show the chosen preset"));
    save_->setAccessibleName(tr("Save what is shown as a preset"));
    save_->setToolTip(tr("Saves the colours with the view mode, shading and step in use"));
    rename_->setAccessibleName(tr("Rename the chosen preset"));
    remove_->setAccessibleName(tr("Delete the chosen preset"));
    import_->setAccessibleName(tr("Import a preset file"));
    export_->setAccessibleName(tr("Export the chosen preset to a file"));
    auto* column = new QVBoxLayout(this);
    column->addWidget(list_, 1);
    column->addWidget(technique_);
    auto* buttons = new QGridLayout;
    int at = 0;
    QWidget* before = technique_;
    for (QPushButton* button : {apply_, save_, rename_, remove_, import_, export_}) {
        buttons->addWidget(button, at / 3, at % 3);
        setTabOrder(before, button);
        before = button;
        ++at;
    }
    column->addLayout(buttons);
}

QString PresetGallery::keyOf(const PresetEntry& entry) {
    return QString::fromStdString(entry.built_in() ? "preset:" + entry.name : entry.file.string());
}

void PresetGallery::setEntries(const std::vector<PresetEntry>& entries) {
    const QString before = chosen() ? keyOf(*chosen()) : QString();
    {
        const QSignalBlocker quiet(list_);
        entries_ = entries;
        list_->clear();
        for (const PresetEntry& entry : entries_) {
            auto* item = new QListWidgetItem(icon_of({}, !entry.fault.empty()), preset_title(entry));
            item->setToolTip(entry.fault.empty() ? preset_title(entry) : core_sentence(entry.fault));
            list_->addItem(item);
            if (keyOf(entry) == before) list_->setCurrentItem(item);
        }
    }
    showChosen();
    Q_EMIT shown();
}

void PresetGallery::setPicture(const QString& key, const QImage& picture) {
    for (std::size_t i = 0; i < entries_.size(); ++i)
        if (keyOf(entries_[i]) == key) list_->item(int(i))->setIcon(icon_of(picture, !entries_[i].fault.empty()));
}

std::vector<PresetEntry> PresetGallery::visibleEntries() const {
    std::vector<PresetEntry> visible;
    if (!isVisible()) return visible;
    const QRect sight = list_->viewport()->rect().adjusted(0, 0, 0, list_->gridSize().height());
    for (std::size_t i = 0; i < entries_.size(); ++i)
        if (list_->visualItemRect(list_->item(int(i))).intersects(sight)) visible.push_back(entries_[i]);
    return visible;
}

const PresetEntry* PresetGallery::chosen() const {
    const int row = list_->currentRow();
    return row >= 0 && row < int(entries_.size()) ? &entries_[std::size_t(row)] : nullptr;
}

void PresetGallery::choose(const QString& name) {
    for (std::size_t i = 0; i < entries_.size(); ++i)
        if (QString::fromStdString(entries_[i].name) == name) list_->setCurrentRow(int(i));
}

bool PresetGallery::holds(const PresetEntry& entry) const {
    return std::find(entries_.begin(), entries_.end(), entry) != entries_.end();
}

void PresetGallery::showChosen() {
    const PresetEntry* entry = chosen();
    apply_->setEnabled(entry && entry->fault.empty());
    export_->setEnabled(entry && entry->fault.empty());
    rename_->setEnabled(entry && !entry->built_in() && entry->fault.empty());
    remove_->setEnabled(entry && !entry->built_in());
}

void PresetGallery::showEvent(QShowEvent*) { Q_EMIT shown(); }
void PresetGallery::resizeEvent(QResizeEvent*) { Q_EMIT shown(); }

bool PresetGallery::eventFilter(QObject* watched, QEvent* event) {
    if (watched == list_ && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        const PresetEntry* entry = chosen();
        if (entry && (key == Qt::Key_Return || key == Qt::Key_Enter)) {
            Q_EMIT applyRequested(*entry);
            return true;
        }
        if (entry && key == Qt::Key_Delete && !entry->built_in()) {
            Q_EMIT removeRequested(*entry);
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

}  // namespace lacuna::ui
