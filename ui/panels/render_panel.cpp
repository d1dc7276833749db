#include "ui/panels/render_panel.h"

#include <QSignalBlocker>
#include <QStandardItemModel>
#include <algorithm>

#include "core/volume/border.h"
#include "core/volume/statistics.h"
#include "ui/core_sentences.h"
#include "ui/language.h"
#include "ui/plan_words.h"

namespace lacuna::ui {

namespace {

struct QualityChoice {
    const char* name;
    double step;
    Sampler sampler;
};
constexpr QualityChoice k_qualities[] = {
    {QT_TRANSLATE_NOOP("lacuna::ui::RenderPanel", "Draft (step 1, nearest)"), 1.0, Sampler::nearest},
    {QT_TRANSLATE_NOOP("lacuna::ui::RenderPanel", "Fast (step 1)"), 1.0, Sampler::linear},
    {QT_TRANSLATE_NOOP("lacuna::ui::RenderPanel", "Normal (step 0.5)"), 0.5, Sampler::linear},
    {QT_TRANSLATE_NOOP("lacuna::ui::RenderPanel", "High (step 0.25)"), 0.25, Sampler::linear},
    {QT_TRANSLATE_NOOP("lacuna::ui::RenderPanel", "Finest (step 0.1)"), 0.1, Sampler::linear}};

}  // namespace

const std::vector<ModeName>& mode_names() {
    static QString language;
    static std::vector<ModeName> names;
    if (language == Language::instance()->code()) return names;
    language = Language::instance()->code();
    names = {
        {ViewMode::iso, RenderPanel::tr("Isosurface"), RenderPanel::tr("The surface of one value, shaded")},
        {ViewMode::ea, RenderPanel::tr("Volume (emission–absorption)"),
         RenderPanel::tr("Colours and opacities of the transfer function, front to back")},
        {ViewMode::mip, RenderPanel::tr("Maximum projection (MIP)"), RenderPanel::tr("The largest value of each ray")},
        {ViewMode::lmip, RenderPanel::tr("Local maximum (LMIP)"),
         RenderPanel::tr("The first local maximum above a threshold")},
        {ViewMode::minip, RenderPanel::tr("Minimum projection (MinIP)"),
         RenderPanel::tr("The smallest value of each ray")},
        {ViewMode::mean, RenderPanel::tr("Mean (radiograph)"), RenderPanel::tr("The mean value of each ray")},
        {ViewMode::shear_warp, RenderPanel::tr("Shear-warp surface"),
         RenderPanel::tr("The surface's visible voxels by shear and warp")}};
    return names;
}

RenderPanel::RenderPanel(QWidget* parent)
    : QWidget(parent),
      form_(new QFormLayout(this)),
      mode_(new QComboBox(this)),
      note_(new QLabel(this)),
      iso_(new ValueSlider(tr("Isovalue"), this)),
      lmip_(new ValueSlider(tr("Local maximum threshold"), this)),
      by_tf_(new QCheckBox(tr("Colours of the transfer function"), this)),
      shading_(new QComboBox(this)),
      quality_(new QComboBox(this)),
      structure_(new QComboBox(this)) {
    buildRows();
    connectRows();
    showRelevantRows();
}

void RenderPanel::buildRows() {
    form_->setContentsMargins(10, 8, 10, 8);
    form_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    for (std::size_t i = 0; i < mode_names().size(); ++i) {
        mode_->addItem(QStringLiteral("%1  %2").arg(i + 1).arg(mode_names()[i].name));
        mode_->setItemData(int(i), mode_names()[i].hint, Qt::ToolTipRole);
    }
    mode_->setAccessibleName(tr("View mode"));
    mode_->setToolTip(tr("Keys 1 to 7"));
    iso_->keepTypedDigits();
    lmip_->keepTypedDigits();
    by_tf_->setAccessibleName(tr("Projection in the colours of the transfer function"));
    shading_->addItems({tr("None"), tr("Lambert"), tr("Phong")});
    shading_->setAccessibleName(tr("Shading"));
    for (const QualityChoice& choice : k_qualities) quality_->addItem(tr(choice.name));
    quality_->setAccessibleName(tr("Quality"));
    quality_->setToolTip(tr("Distance between samples, in voxels, of the still picture"));
    structure_->addItem(tr("Automatic"), -1);
    for (const auto& [structure, name] : structure_names())
        structure_->addItem(structure_title(structure), int(structure));
    structure_->setAccessibleName(tr("Acceleration structure"));
    structure_->setToolTip(tr("What lets rays jump over empty space; the picture is the same with each"));
    const auto row = [this](const QString& name, QWidget* field) {
        form_->addRow(name, field);
        if (QWidget* label = form_->labelForField(field)) label->setMinimumWidth(62);
    };
    note_->setWordWrap(true);
    note_->setTextFormat(Qt::PlainText);
    note_->setForegroundRole(QPalette::PlaceholderText);
    note_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    note_->setText(tr(
        "Almost every ray passes the air at the volume's border, which holds the least values: the picture shows "
        "that air, and is dark. What lies within the part is shown by a box inside it alone (Cuts), or by a range of "
        "the part's values (Ranges)."));
    note_->setAccessibleName(tr("About this mode"));
    row(tr("Mo&de"), mode_);
    form_->addRow(note_);
    form_->setRowVisible(note_, false);
    row(tr("&Isovalue"), iso_);
    row(tr("Threshold"), lmip_);
    row(QString(), by_tf_);
    row(tr("&Shading"), shading_);
    row(tr("&Quality"), quality_);
    row(tr("Str&ucture"), structure_);
    static_cast<QLabel*>(form_->labelForField(iso_))->setBuddy(iso_->slider());
}

template <class Change>
void RenderPanel::edit(const QString& name, Change&& change) {
    ViewSettings next = settings_;
    change(next);
    Q_EMIT edited(name, next);
}

void RenderPanel::connectRows() {
    connect(mode_, &QComboBox::currentIndexChanged, this, [this](int i) {
        edit(tr("View mode"), [i](ViewSettings& s) { switch_mode(s, mode_names()[std::size_t(i)].mode); });
    });
    connect(iso_, &ValueSlider::valueEdited, this,
            [this](double value) { edit(tr("Isovalue"), [value](ViewSettings& s) { s.iso = value; }); });
    connect(lmip_, &ValueSlider::valueEdited, this, [this](double value) {
        edit(tr("Local maximum threshold"), [value](ViewSettings& s) { s.lmip_threshold = value; });
    });
    connect(by_tf_, &QCheckBox::toggled, this,
            [this](bool on) { edit(tr("Projection colours"), [on](ViewSettings& s) { s.color_by_tf = on; }); });
    connect(shading_, &QComboBox::currentIndexChanged, this,
            [this](int i) { edit(tr("Shading"), [i](ViewSettings& s) { s.shading = Shading(i); }); });
    connect(quality_, &QComboBox::activated, this, [this](int i) {
        edit(tr("Quality"), [i](ViewSettings& s) {
            s.quality.step = k_qualities[i].step;
            s.quality.sampler = k_qualities[i].sampler;
            s.quality.plan.clear();
        });
    });
    connect(structure_, &QComboBox::activated, this, [this](int i) {
        const int chosen = structure_->itemData(i).toInt();
        edit(tr("Structure"), [chosen](ViewSettings& s) {
            s.quality.structure = chosen < 0 ? std::nullopt : std::optional(Structure(chosen));
            s.quality.plan.clear();
        });
    });
}

void RenderPanel::setVolumeFacts(const VolumeStatistics& statistics, const QString& unit) {
    const ValueRange values = statistics.range;
    air_below_ = otsu_threshold(statistics);
    for (ValueSlider* slider : {iso_, lmip_}) {
        slider->setLimits(values);
        slider->setSuffix(unit.isEmpty() ? QString() : QStringLiteral(" ") + unit);
    }
}

void RenderPanel::setSettings(const ViewSettings& settings) {
    settings_ = settings;
    const QSignalBlocker blockers[] = {QSignalBlocker(mode_), QSignalBlocker(by_tf_), QSignalBlocker(shading_),
                                       QSignalBlocker(quality_), QSignalBlocker(structure_)};
    for (std::size_t i = 0; i < mode_names().size(); ++i)
        if (mode_names()[i].mode == settings.mode) mode_->setCurrentIndex(int(i));
    iso_->setValue(settings.iso);
    lmip_->setValue(settings.lmip_threshold);
    by_tf_->setChecked(settings.color_by_tf);
    shading_->setCurrentIndex(int(settings.shading));
    int chosen = -1;
    for (int i = 0; i < int(std::size(k_qualities)); ++i)
        if (k_qualities[i].step == settings.quality.step && k_qualities[i].sampler == settings.quality.sampler)
            chosen = i;
    quality_->setCurrentIndex(chosen);
    structure_->setCurrentIndex(
        structure_->findData(settings.quality.structure ? int(*settings.quality.structure) : -1));
    showRelevantRows();
}

/// Nearly all of what rays meet first is the dark class of the values, and no range leaves it out.
bool RenderPanel::airAround(const Volume& volume) const {
    constexpr double k_nearly_all = 0.75;
    const glm::dvec3 cells(volume.geometry().size);
    VoxelBox box{{0, 0, 0}, volume.geometry().size};
    if (settings_.roi.enabled) {
        box.first = glm::clamp(glm::ivec3(glm::round(settings_.roi.lo * cells)), glm::ivec3(0), box.size - 1);
        const glm::ivec3 end(glm::round(settings_.roi.hi * cells));
        box.size = glm::clamp(end - box.first, glm::ivec3(1), box.size - box.first);
    }
    const auto& ranges = settings_.ranges;
    const bool all_shown = std::none_of(ranges.begin(), ranges.end(), [](const RangeSetting& r) { return r.enabled; });
    const auto is_air = [&](double value) {
        return value < air_below_ &&
               (all_shown || std::any_of(ranges.begin(), ranges.end(), [&](const RangeSetting& r) {
                    return r.enabled && r.range.range.contains(value);
                }));
    };
    return border_share(volume, box, is_air) >= k_nearly_all;
}

void RenderPanel::setScene(const Scene& scene) {
    form_->setRowVisible(note_, scene.mode == ViewMode::minip && airAround(scene.volume));
    auto* items = qobject_cast<QStandardItemModel*>(structure_->model());
    Plan own = default_plan(scene);
    structure_->setItemText(0, tr("Automatic (%1)").arg(structure_word(own.structure)));
    for (int i = 1; i < structure_->count(); ++i) {
        const auto structure = Structure(structure_->itemData(i).toInt());
        const QString refusal = core_sentence(structure_refusal(structure, scene));
        own.structure = structure;
        const QString words = refusal.isEmpty() ? core_sentence(gain_note(own, scene)) : refusal;
        items->item(i)->setEnabled(refusal.isEmpty());
        structure_->setItemData(i, words, Qt::ToolTipRole);
    }
}

void RenderPanel::showRelevantRows() {
    const ViewMode mode = settings_.mode;
    const bool surface = mode == ViewMode::iso || mode == ViewMode::shear_warp;
    const bool projection =
        mode == ViewMode::mip || mode == ViewMode::lmip || mode == ViewMode::minip || mode == ViewMode::mean;
    form_->setRowVisible(iso_, surface);
    form_->setRowVisible(lmip_, mode == ViewMode::lmip);
    form_->setRowVisible(by_tf_, projection);
    form_->setRowVisible(shading_, !projection);
    form_->setRowVisible(structure_, mode != ViewMode::shear_warp);
}

}  // namespace lacuna::ui
