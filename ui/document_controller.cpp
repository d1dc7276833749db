#include "ui/document_controller.h"

namespace lacuna::ui {

DocumentController::DocumentController(QObject* parent)
    : QObject(parent), gesture_end_([this] { history_.seal(); }, this) {}

void DocumentController::open(const Document& document) {
    document_ = document;
    history_.reset();
    Q_EMIT opened();
    Q_EMIT historyChanged();
}

void DocumentController::adopt(const Document& document, const EditHistory& history) {
    document_ = document;
    history_ = history;
    Q_EMIT opened();
    // What opened() made others forget is still there.
    document_ = document;
    Q_EMIT settingsChanged();
    Q_EMIT cameraChanged();
    Q_EMIT cursorChanged();
    Q_EMIT regionsChanged();
    Q_EMIT inspectionChanged();
    document_ = document;  // tables that fill clear the selection
    Q_EMIT selectionChanged();
    Q_EMIT historyChanged();
}

void DocumentController::edit(const QString& name, const ViewSettings& next) {
    if (!document_ || !history_.note(name.toStdString(), document_->settings, next)) return;
    gesture_end_.start();
    replaceSettings(next);
}

void DocumentController::undo() {
    if (document_ && history_.can_undo()) replaceSettings(history_.undo());
}

void DocumentController::redo() {
    if (document_ && history_.can_redo()) replaceSettings(history_.redo());
}

void DocumentController::restore(const ViewSettings& settings, const Camera& camera, const glm::dvec3& cursor_mm) {
    if (!document_) return;
    history_.reset();
    replaceSettings(settings);
    setCamera(camera);
    setCursor(cursor_mm);
}

void DocumentController::replaceSettings(const ViewSettings& settings) {
    const Quality &before = document_->settings.quality, &after = settings.quality;
    if (before.error_budget != after.error_budget || before.time_budget_ms != after.time_budget_ms)
        document_->planned.reset();  // it answered another question
    document_->settings = ViewSettings(settings);
    Q_EMIT settingsChanged();
    Q_EMIT historyChanged();
}

void DocumentController::setCamera(const Camera& camera) {
    if (!document_ || document_->camera == camera) return;
    document_->camera = camera;
    Q_EMIT cameraChanged();
}

void DocumentController::setCursor(const glm::dvec3& mm) {
    if (!document_ || document_->cursor_mm == mm) return;
    document_->cursor_mm = mm;
    Q_EMIT cursorChanged();
}

void DocumentController::setPlanned(std::shared_ptr<const ModePlan> planned) {
    if (!document_ || document_->planned == planned) return;
    document_->planned = std::move(planned);
    Q_EMIT plannedChanged();
}

void DocumentController::setRegions(std::shared_ptr<const RegionTable> regions) {
    if (!document_) return;
    document_->regions = std::move(regions);
    document_->selected_region = 0;
    document_->highlight.reset();
    Q_EMIT regionsChanged();
    Q_EMIT selectionChanged();
}

void DocumentController::setInspection(std::shared_ptr<const PartAnalysis> analysis) {
    if (!document_) return;
    document_->inspection = std::move(analysis);
    document_->selected_defect = 0;
    document_->defects.reset();
    Q_EMIT inspectionChanged();
    Q_EMIT selectionChanged();
}

void DocumentController::showDefects(std::shared_ptr<const std::vector<Highlight>> defects) {
    if (!document_) return;
    document_->defects = std::move(defects);
    Q_EMIT selectionChanged();
}

void DocumentController::selectDefect(std::uint32_t id) {
    if (!document_ || document_->selected_defect == id) return;
    document_->selected_defect = id;
    Q_EMIT selectionChanged();
}

void DocumentController::selectRegion(std::uint32_t id, std::shared_ptr<const Highlight> highlight) {
    if (!document_) return;
    document_->selected_region = id;
    document_->highlight = std::move(highlight);
    Q_EMIT selectionChanged();
}

}  // namespace lacuna::ui
