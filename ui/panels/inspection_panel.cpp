#include "ui/panels/inspection_panel.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QInputDialog>
#include <QScrollArea>
#include <algorithm>
#include <cmath>

#include "ui/core_sentences.h"
#include "ui/number_text.h"
#include "ui/tab_chain.h"
#include "ui/widgets/row_table.h"

namespace lacuna::ui {

InspectionPanel::InspectionPanel(QWidget* parent)
    : QWidget(parent),
      form_(new CriteriaForm(this)),
      model_(new DefectModel(this)),
      filtered_(new DefectFilter(this)),
      inspect_(new QPushButton(tr("Inspect"), this)),
      load_(new QPushButton(tr("Load criteria…"), this)),
      save_(new QPushButton(tr("Save criteria…"), this)),
      report_(new QPushButton(tr("Report…"), this)),
      accept_(new QPushButton(tr("Accept…"), this)),
      reject_(new QPushButton(tr("Reject…"), this)),
      undecide_(new QPushButton(tr("Undecide"), this)),
      verdict_(new QLabel(this)),
      facts_(new QLabel(this)),
      filter_(new QLineEdit(this)),
      coloring_(new QComboBox(this)),
      view_(new QTableView(this)),
      judge_job_(this) {
    build();
    connect(inspect_, &QPushButton::clicked, this, [this] { Q_EMIT inspectRequested(form_->criteria().detection); });
    connect(load_, &QPushButton::clicked, this, &InspectionPanel::loadCriteriaRequested);
    connect(save_, &QPushButton::clicked, this, &InspectionPanel::saveCriteriaRequested);
    connect(report_, &QPushButton::clicked, this, &InspectionPanel::reportRequested);
    connect(accept_, &QPushButton::clicked, this, [this] { askReason(true); });
    connect(reject_, &QPushButton::clicked, this, [this] { askReason(false); });
    connect(undecide_, &QPushButton::clicked, this, [this] { decide(chosen(), true, {}); });
    connect(form_, &CriteriaForm::limitsEdited, this, &InspectionPanel::judgeAgain);
    connect(form_, &CriteriaForm::detectionEdited, this, [this] {
        stale_ = analysis_ != nullptr;
        showVerdict();
    });
    connect(filter_, &QLineEdit::textChanged, filtered_, &DefectFilter::setText);
    connect(coloring_, &QComboBox::currentIndexChanged, this, [this](int index) {
        model_->setColoring(DefectColoring(index));
        Q_EMIT colorsChanged();
    });
    connect(view_->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] {
        const std::uint32_t id = chosen();
        for (QPushButton* button : {accept_, reject_, undecide_}) button->setEnabled(id != 0);
        Q_EMIT defectChosen(id);
    });
    setAnalysis(nullptr);
    inspect_->setEnabled(false);
}

void InspectionPanel::build() {
    inspect_->setAccessibleName(tr("Inspect the part"));
    load_->setAccessibleName(tr("Load criteria from a file"));
    save_->setAccessibleName(tr("Save the criteria as a file"));
    report_->setAccessibleName(tr("Write the report folder"));
    accept_->setAccessibleName(tr("Accept the chosen defect by hand"));
    reject_->setAccessibleName(tr("Reject the part for the chosen defect"));
    undecide_->setAccessibleName(tr("Take the decision by hand back"));
    verdict_->setAccessibleName(tr("Verdict"));
    verdict_->setWordWrap(true);
    facts_->setWordWrap(true);
    facts_->setEnabled(false);
    filter_->setPlaceholderText(tr("Filter: fail, void, diameter > 0.5"));
    filter_->setAccessibleName(tr("Filter of the defect table"));
    filter_->setClearButtonEnabled(true);
    coloring_->addItems({tr("Colour by verdict"), tr("Colour by size"), tr("Colour by depth")});
    coloring_->setAccessibleName(tr("What the defects' colours tell"));
    buildTable();
    auto* over = new QHBoxLayout;
    over->addWidget(filter_, 1);
    over->addWidget(coloring_);
    auto* right = new QVBoxLayout;
    right->addLayout(over);
    right->addWidget(view_, 1);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(6, 6, 6, 6);
    row->addLayout(criteriaColumn(), 2);
    row->addLayout(verdictColumn(), 2);
    row->addLayout(right, 5);
    chain_tabs({form_, load_, save_, inspect_, accept_, reject_, undecide_, report_, filter_, coloring_, view_});
}

void InspectionPanel::buildTable() {
    filtered_->setSourceModel(model_);
    filtered_->setSortRole(DefectModel::k_sort_role);
    view_->setModel(filtered_);
    view_->setAccessibleName(tr("Defects"));
    choose_rows_of(view_);
    sort_by_titles(view_);
    view_->horizontalHeader()->setStretchLastSection(true);
}

QLayout* InspectionPanel::criteriaColumn() {
    auto* scroll = new QScrollArea(this);
    scroll->setWidget(form_);
    scroll->setWidgetResizable(true);
    scroll->setAccessibleName(tr("Criteria"));
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setMinimumWidth(310);
    auto* left = new QGridLayout;
    left->addWidget(scroll, 0, 0, 1, 2);
    left->addWidget(load_, 1, 0);
    left->addWidget(save_, 1, 1);
    left->addWidget(inspect_, 2, 0, 1, 2);
    return left;
}

QLayout* InspectionPanel::verdictColumn() {
    auto* middle = new QGridLayout;
    auto* result = new QWidget;
    auto* sentences = new QVBoxLayout(result);
    sentences->setContentsMargins(0, 0, 0, 0);
    sentences->addWidget(verdict_);
    sentences->addWidget(facts_);
    sentences->addStretch(1);
    auto* sentences_view =
        new QScrollArea(this);  // long sentences are scrolled, and neither widen nor heighten the dock
    sentences_view->setWidget(result);
    sentences_view->setWidgetResizable(true);
    sentences_view->setFrameShape(QFrame::NoFrame);
    sentences_view->setFocusPolicy(Qt::NoFocus);
    sentences_view->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    sentences_view->setMinimumHeight(6 * fontMetrics().lineSpacing());
    middle->addWidget(sentences_view, 0, 0, 1, 2);
    middle->setRowStretch(0, 1);
    middle->addWidget(accept_, 1, 0);
    middle->addWidget(reject_, 1, 1);
    middle->addWidget(undecide_, 2, 0);
    middle->addWidget(report_, 2, 1);
    for (QLabel* label : {verdict_, facts_}) label->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    return middle;
}

void InspectionPanel::setVolume(const Volume& volume, const VolumeStatistics& statistics) {
    geometry_ = volume.geometry();
    form_->setVolume(volume, statistics);
    inspect_->setEnabled(true);
    setAnalysis(nullptr);
}

void InspectionPanel::setCriteria(const Criteria& criteria) { adoptCriteria(criteria, false); }

void InspectionPanel::adoptCriteria(const Criteria& criteria, bool current) {
    form_->setCriteria(criteria);
    stale_ = analysis_ != nullptr && !current;
    judgeAgain();
}

void InspectionPanel::setAnalysis(std::shared_ptr<const PartAnalysis> analysis) {
    analysis_ = std::move(analysis);
    by_hand_.clear();
    stale_ = false;
    view_->clearSelection();
    judgement_ = {};
    model_->set(analysis_, judgement_);
    report_->setEnabled(analysis_ != nullptr);
    for (QPushButton* button : {accept_, reject_, undecide_}) button->setEnabled(false);
    judgeAgain();
}

void InspectionPanel::setRunning(bool running) {
    inspect_->setEnabled(!running);
    inspect_->setText(running ? tr("Inspecting…") : tr("Inspect"));
}

std::uint32_t InspectionPanel::chosen() const {
    const QModelIndexList rows = view_->selectionModel()->selectedRows();
    return rows.isEmpty() ? 0u : rows.front().data(DefectModel::k_id_role).toUInt();
}

void InspectionPanel::judgeAgain() {
    judge_job_.cancel();
    if (!analysis_) return showVerdict();
    const auto work = [analysis = analysis_, criteria = form_->criteria(), geometry = geometry_,
                       by_hand = by_hand_](const JobContext& job) {
        return judge(*analysis, criteria, lay_zones(criteria, geometry, job), by_hand, job);
    };
    judgement_.by_hand = by_hand_;  // kept, whatever the verdict is going to be
    // Zones may lie in files, and their voxels are counted; without any it is a matter of comparing numbers.
    constexpr std::size_t k_quick_defects = 5000;
    if (form_->criteria().zones.empty() && analysis_->defects.size() <= k_quick_defects)
        return accept(capture<Judgement>(work, {}));
    judge_job_.start(work, [this](Outcome<Judgement> outcome) { accept(std::move(outcome)); });
}

void InspectionPanel::accept(Outcome<Judgement> judgement) {
    if (const Error* error = std::get_if<Error>(&judgement)) {
        Q_EMIT failed(QString::fromStdString(error->what()));
        return;
    }
    judgement_ = std::get<Judgement>(std::move(judgement));
    model_->setJudgement(judgement_);
    Q_EMIT colorsChanged();
    showVerdict();
    Q_EMIT judged();
}

void InspectionPanel::showVerdict() {
    if (!analysis_) {
        verdict_->setText(tr("Not inspected"));
        facts_->clear();
        verdict_->setStyleSheet({});
        return;
    }
    const Verdict verdict = judgement_.verdict;
    const QString word = verdict == Verdict::pass   ? tr("Pass")
                         : verdict == Verdict::fail ? tr("Fail")
                                                    : tr("Cannot tell");
    QStringList reasons;
    for (const std::string& reason : judgement_.reasons) reasons << core_sentence(reason);
    // The second says what was found where the first is that not all of the part was seen.
    const QString why =
        reasons.mid(0, 2).join(QLatin1Char('\n')).toHtmlEscaped().replace(QLatin1Char('\n'), QStringLiteral("<br>"));
    verdict_->setText(stale_ ? tr("%1 (of the settings before; inspect again)").arg(word)
                             : QStringLiteral("<b>%1</b><br>%2").arg(word, why));
    verdict_->setStyleSheet(
        stale_                     ? QStringLiteral("QLabel { padding: 6px; }")
        : verdict == Verdict::pass ? QStringLiteral("QLabel { background: #00664a; color: white; padding: 6px; }")
        : verdict == Verdict::fail ? QStringLiteral("QLabel { background: #a33c00; color: white; padding: 6px; }")
                                   : QStringLiteral("QLabel { background: #f0c828; color: black; padding: 6px; }"));
    const Measured& porosity = analysis_->part.porosity_percent;
    QStringList lines{tr("%n defect(s)", nullptr, int(analysis_->defects.size()))};
    if (std::isfinite(porosity.value))
        lines << tr("Porosity %1 % (%2 to %3)")
                     .arg(number_text(porosity.value, 'g', 3), number_text(porosity.lo, 'g', 3),
                          number_text(porosity.hi, 'g', 3));
    if (!by_hand_.empty()) lines << tr("%n decided by hand", nullptr, int(by_hand_.size()));
    for (const std::string& warning : analysis_->part.warnings) lines << core_sentence(warning);
    facts_->setText(lines.join(QLatin1Char('\n')));
    facts_->setToolTip(facts_->text());
    verdict_->setToolTip(reasons.join(QLatin1Char('\n')));
}

void InspectionPanel::askReason(bool accepted) {
    const std::uint32_t id = chosen();
    if (id == 0) return;
    const std::shared_ptr<const PartAnalysis> asked_about = analysis_;
    bool given = false;
    const QString reason =
        QInputDialog::getText(this, accepted ? tr("Accept defect %1").arg(id) : tr("Reject defect %1").arg(id),
                              tr("Reason (kept in the report):"), QLineEdit::Normal, {}, &given);
    if (!given || reason.trimmed().isEmpty()) return;
    if (analysis_ != asked_about) {
        Q_EMIT failed(tr("Meanwhile other defects were found, which have other numbers; choose the defect again."));
        return;
    }
    decide(id, accepted, reason.trimmed());
}

void InspectionPanel::decide(std::uint32_t defect, bool accepted, const QString& reason) {
    if (defect == 0) return;
    std::erase_if(by_hand_, [defect](const HandDecision& word) { return word.defect == defect; });
    if (!reason.isEmpty()) by_hand_.push_back({defect, accepted, reason.toStdString()});
    std::sort(by_hand_.begin(), by_hand_.end(), [](const auto& a, const auto& b) { return a.defect < b.defect; });
    judgeAgain();
    Q_EMIT decided();
}

}  // namespace lacuna::ui
