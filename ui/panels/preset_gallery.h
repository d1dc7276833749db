#pragma once

#include <QCheckBox>
#include <QListWidget>
#include <QPushButton>
#include <QWidget>

#include "core/session/preset_library.h"

namespace lacuna::ui {

/// Presets with their pictures, built-in ones first, and buttons for one's own. Double click or Enter shows the chosen
/// one on the volume.
class PresetGallery final : public QWidget {
    Q_OBJECT
public:
    explicit PresetGallery(QWidget* parent = nullptr);
    /// Keeps the choice where the preset is still there.
    void setEntries(const std::vector<lacuna::PresetEntry>& entries);
    void setPicture(const QString& key, const QImage& picture);
    /// Names an entry among all: its file, or its name where it is built in.
    static QString keyOf(const lacuna::PresetEntry& entry);
    /// Entries that can be seen now, or a little further down.
    std::vector<lacuna::PresetEntry> visibleEntries() const;
    /// Null where none is chosen.
    const lacuna::PresetEntry* chosen() const;
    void choose(const QString& name);
    /// Whether this very entry is listed, with what its file held then.
    bool holds(const lacuna::PresetEntry& entry) const;
    bool withTechnique() const { return technique_->isChecked(); }
    QListWidget* list() const { return list_; }
    QCheckBox* techniqueBox() const { return technique_; }

Q_SIGNALS:
    void shown();  ///< other entries came into sight
    void applyRequested(const lacuna::PresetEntry& entry);
    void saveRequested();
    void renameRequested(const lacuna::PresetEntry& entry);
    void removeRequested(const lacuna::PresetEntry& entry);
    void importRequested();
    void exportRequested(const lacuna::PresetEntry& entry);

protected:
    void showEvent(QShowEvent*) override;
    void resizeEvent(QResizeEvent*) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void build();
    void showChosen();

    std::vector<PresetEntry> entries_;
    QListWidget* list_;
    QCheckBox* technique_;
    QPushButton *apply_, *save_, *rename_, *remove_, *import_, *export_;
};

}  // namespace lacuna::ui
