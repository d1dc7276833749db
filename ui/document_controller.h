#pragma once

#include <QObject>
#include <QString>
#include <optional>

#include "core/session/document.h"
#include "core/session/edit_history.h"
#include "ui/gesture_end.h"

namespace lacuna::ui {

/// Owns the open document and its undo history; the one place that changes them. Everyone else gets values.
class DocumentController final : public QObject {
    Q_OBJECT
public:
    explicit DocumentController(QObject* parent = nullptr);

    bool hasDocument() const { return document_.has_value(); }
    /// @pre hasDocument()
    const Document& document() const { return *document_; }
    const EditHistory& history() const { return history_; }

public Q_SLOTS:
    void open(const lacuna::Document& document);
    /// Goes on with what another controller had: the document with its results, and its undo history.
    void adopt(const lacuna::Document& document, const lacuna::EditHistory& history);
    /// Replaces the settings as a step of undo; edits of one name in quick succession are one step.
    void edit(const QString& name, const lacuna::ViewSettings& next);
    /// What is edited next is a step of its own, whatever its name.
    void endGesture() { history_.seal(); }
    void undo();
    void redo();
    /// Shows the document as a session left it. No step of undo: there is nothing before it.
    void restore(const lacuna::ViewSettings& settings, const lacuna::Camera& camera, const glm::dvec3& cursor_mm);
    void setCamera(const lacuna::Camera& camera);
    void setCursor(const glm::dvec3& mm);
    /// The planner's answer to the budget; no step of undo. Null: none.
    void setPlanned(std::shared_ptr<const lacuna::ModePlan> planned);
    void setRegions(std::shared_ptr<const lacuna::RegionTable> regions);
    /// Forgets the defects shown until their voxels are gathered.
    void setInspection(std::shared_ptr<const lacuna::PartAnalysis> analysis);
    void showDefects(std::shared_ptr<const std::vector<lacuna::Highlight>> defects);
    void selectDefect(std::uint32_t id);
    /// @param highlight  the region's voxels; null while they are being gathered, or for none
    void selectRegion(std::uint32_t id, std::shared_ptr<const lacuna::Highlight> highlight);

Q_SIGNALS:
    void opened();
    void settingsChanged();
    void cameraChanged();
    void plannedChanged();
    void cursorChanged();
    void regionsChanged();
    void inspectionChanged();
    void selectionChanged();
    void historyChanged();

private:
    void replaceSettings(const ViewSettings& settings);

    std::optional<Document> document_;
    EditHistory history_{500};
    GestureEnd gesture_end_;
};

}  // namespace lacuna::ui
