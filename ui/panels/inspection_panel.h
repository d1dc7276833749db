#pragma once

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableView>
#include <QWidget>

#include "ui/latest_job.h"
#include "ui/models/defect_model.h"
#include "ui/panels/criteria_form.h"

namespace lacuna::ui {

/// An inspector's place: criteria with the verdict they give at once, the defect table, and decisions by hand.
class InspectionPanel final : public QWidget {
    Q_OBJECT
public:
    explicit InspectionPanel(QWidget* parent = nullptr);
    void setVolume(const lacuna::Volume& volume, const lacuna::VolumeStatistics& statistics);
    /// The criteria of a file: the table is judged by them at once, what was found stays until measured anew.
    void setCriteria(const lacuna::Criteria& criteria);
    /// A new analysis; null: none. Decisions by hand are forgotten.
    void setAnalysis(std::shared_ptr<const lacuna::PartAnalysis> analysis);
    /// @param current  whether what was found was found by these criteria
    void adoptCriteria(const lacuna::Criteria& criteria, bool current);
    bool isCurrent() const { return !stale_; }
    void setRunning(bool running);

    CriteriaForm* form() const { return form_; }
    DefectModel* model() const { return model_; }
    QTableView* table() const { return view_; }
    QPushButton* inspectButton() const { return inspect_; }
    QLineEdit* filterEdit() const { return filter_; }
    const Judgement& judgement() const { return judgement_; }
    QString verdictText() const { return verdict_->text(); }
    /// Takes a defect out of the verdict (accepted) or lets the part fail by it; an empty reason takes the word back.
    void decide(std::uint32_t defect, bool accepted, const QString& reason);

Q_SIGNALS:
    void inspectRequested(const lacuna::DetectionOptions& options);
    void defectChosen(std::uint32_t id);  ///< 0: none
    void colorsChanged();                 ///< of the model's rows
    void loadCriteriaRequested();
    void saveCriteriaRequested();
    void reportRequested();
    void judged();   ///< judgement() is that of the criteria and decisions as they are
    void decided();  ///< a decision by hand was made or taken back
    void failed(const QString& sentence);

private:
    void build();
    void buildTable();
    QLayout* criteriaColumn();
    QLayout* verdictColumn();
    void judgeAgain();
    void accept(Outcome<Judgement> judgement);
    void showVerdict();
    void askReason(bool accepted);
    std::uint32_t chosen() const;

    std::shared_ptr<const PartAnalysis> analysis_;
    std::vector<HandDecision> by_hand_;
    Judgement judgement_;
    bool stale_ = false;  ///< criteria of detection were edited since the analysis
    GridGeometry geometry_;
    CriteriaForm* form_;
    DefectModel* model_;
    DefectFilter* filtered_;
    QPushButton *inspect_, *load_, *save_, *report_, *accept_, *reject_, *undecide_;
    QLabel *verdict_, *facts_;
    QLineEdit* filter_;
    QComboBox* coloring_;
    QTableView* view_;
    LatestJob<Judgement> judge_job_;
};

}  // namespace lacuna::ui
