#include "ui/features/limits_feature.h"

#include <QCoreApplication>
#include <QScrollBar>
#include <algorithm>

#include "ui/core_sentences.h"

namespace lacuna::ui {

namespace {

/// A text of the catalogue in the window's language; `words` between accents become typed ones.
QString in_words(std::string_view text) {
    const QStringList parts =
        QCoreApplication::translate("Limits", std::string(text).c_str()).toHtmlEscaped().split(QLatin1Char('`'));
    QString html;
    for (qsizetype i = 0; i < parts.size(); ++i)
        html += i % 2 ? QStringLiteral("<code>%1</code>").arg(parts[i]) : parts[i];
    return html;
}

/// The first letter large: in the document some of the texts follow a word and a colon.
QString sentence(std::string_view text) {
    QString words = in_words(text);
    if (!words.isEmpty()) words[0] = words[0].toUpper();
    return words;
}

QString word_of(Guard guard) {
    switch (guard) {
        case Guard::refused:
            return LimitsFeature::tr("Refused");
        case Guard::detected:
            return LimitsFeature::tr("Detected");
        case Guard::corrected:
            return LimitsFeature::tr("Corrected");
        case Guard::bounded:
            return LimitsFeature::tr("Bounded");
    }
    return {};
}

QString entry(const Limit& limit, const MetLimit* met) {
    QString html = QStringLiteral("<p style='margin:6px 0 2px 0'><b>%1</b> &nbsp;<i>%2</i></p>")
                       .arg((met ? QStringLiteral("\u26a0 ") : QString()) + in_words(limit.name), word_of(limit.guard));
    if (met)
        html += QStringLiteral("<p style='margin:0 0 2px 14px'>%1</p>").arg(core_sentence(met->how).toHtmlEscaped());
    html += QStringLiteral("<p style='margin:0 0 2px 14px'>%1</p>").arg(sentence(limit.fails));
    html += QStringLiteral("<p style='margin:0 0 2px 14px'>%1 %2</p>")
                .arg(LimitsFeature::tr("What is done:"), sentence(limit.guarded));
    return html + QStringLiteral("<p style='margin:0 0 6px 14px'>%1 %2</p>")
                      .arg(LimitsFeature::tr("How far off:"), sentence(limit.bound));
}

/// Whether facts measured on one scene hold for another: they do not depend on the view.
bool same_facts(const Scene& a, const Scene& b) {
    return a.volume.identity() == b.volume.identity() && a.mode == b.mode && a.iso == b.iso && a.window == b.window &&
           a.classification == b.classification;
}

}  // namespace

LimitsFeature::LimitsFeature(Workbench& bench)
    : QObject(&bench),
      bench_(bench),
      text_(new QTextBrowser(bench.window())),
      dock_(bench.addDock(QStringLiteral("limits"), tr("Where this method fails"), text_, Qt::BottomDockWidgetArea)),
      job_(this) {
    text_->setAccessibleName(tr("Where this method fails"));
    text_->setFrameShape(QFrame::NoFrame);
    text_->setTabChangesFocus(true);
    text_->document()->setDocumentMargin(10);
    bench.needDocument(text_);
    dock_->hide();
    bench.add(bench.menu(Workbench::Menu::help), tr("Where this &method fails"),
              QKeySequence(QStringLiteral("Ctrl+F1")), this, &LimitsFeature::show);
    connect(dock_, &QDockWidget::visibilityChanged, this, &LimitsFeature::refresh);
    connect(bench.scheduler(), &FrameScheduler::frameReady, this, [this](const QImage&, const FrameFacts& facts) {
        if (facts.coarse) return;
        shown_ = facts;
        shown_.frame.reset();  // the picture itself is not needed
        refresh();
    });
    connect(bench.documents(), &DocumentController::opened, this, [this] {
        job_.cancel();
        shown_ = {};
        measured_.reset();
        facts_.reset();
        met_.clear();
        text_->clear();
    });
}

void LimitsFeature::show() {
    dock_->show();
    dock_->raise();
    text_->setFocus(Qt::TabFocusReason);
}

void LimitsFeature::refresh() {
    if (!shown_.scene || !dock_->isVisible()) return;
    if (measured_ && same_facts(*measured_, *shown_.scene)) {
        if (facts_) fill(&*facts_);
        return;  // else they are on their way
    }
    facts_.reset();
    measured_ = shown_.scene;
    fill(nullptr);
    job_.start([scene = shown_.scene](const JobContext& job) { return measure_facts(*scene, job); },
               [this](Outcome<SceneFacts> outcome) {
                   if (auto* error = std::get_if<Error>(&outcome)) {
                       measured_.reset();
                       return bench_.report(*error);
                   }
                   facts_ = std::get<SceneFacts>(outcome);
                   fill(&*facts_);
               });
}

void LimitsFeature::fill(const SceneFacts* facts) {
    const std::vector<const Limit*> all = limits_of(*shown_.scene, shown_.drawn);
    met_ = facts ? limits_met(*facts, *shown_.scene, shown_.drawn) : std::vector<MetLimit>();
    listed_ = int(all.size());
    QString html = QStringLiteral("<p><b>%1</b></p>").arg(shown_.plan.toHtmlEscaped());
    if (!facts)
        html += QStringLiteral("<p>%1</p>").arg(tr("Looking at what of this the volume holds\u2026"));
    else if (met_.empty())
        html += QStringLiteral("<p>%1</p>")
                    .arg(tr("The scene on screen meets none of these failures, as far as facts "
                            "about its voxels tell."));
    else
        html += QStringLiteral("<p>%1</p>")
                    .arg(tr("The scene on screen meets %n of these failures:", nullptr, int(met_.size())));
    for (const MetLimit& met : met_) html += entry(*met.limit, &met);
    if (facts && !met_.empty() && met_.size() < all.size())
        html += QStringLiteral("<hr><p>%1</p>").arg(tr("Known of this way of drawing, and not met here:"));
    for (const Limit* limit : all)
        if (std::none_of(met_.begin(), met_.end(), [&](const MetLimit& met) { return met.limit == limit; }))
            html += entry(*limit, nullptr);
    const int at = text_->verticalScrollBar()->value();
    text_->setHtml(html);
    text_->verticalScrollBar()->setValue(at);
    if (facts) Q_EMIT updated();
}

}  // namespace lacuna::ui
