#include "ui/welcome_page.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace lacuna::ui {

WelcomePage::WelcomePage(QWidget* parent) : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    column->addStretch(2);
    auto* title = new QLabel(QStringLiteral("Lacuna"), this);
    QFont large = font();
    large.setPointSizeF(font().pointSizeF() * 3);
    large.setWeight(QFont::Light);
    title->setFont(large);
    title->setAlignment(Qt::AlignCenter);
    auto* words = new QLabel(tr("Drop a DICOM folder or a volume file here, or open one."), this);
    words->setAlignment(Qt::AlignCenter);
    column->addWidget(title);
    column->addWidget(words);
    column->addSpacing(14);
    const auto add_row = [&](std::initializer_list<QPushButton*> buttons) {
        auto* row = new QHBoxLayout;
        row->addStretch(1);
        for (QPushButton* button : buttons) {
            button->setMinimumSize(150, 34);
            button->setAccessibleName(button->text());
            row->addWidget(button);
        }
        row->addStretch(1);
        column->addLayout(row);
    };
    auto* folder = new QPushButton(tr("Open folder…"), this);
    auto* file = new QPushButton(tr("Open file…"), this);
    auto* casting = new QPushButton(tr("Sample: casting"), this);
    auto* head = new QPushButton(tr("Sample: head"), this);
    add_row({folder, file});
    add_row({casting, head});
    column->addStretch(3);
    auto* notice = new QLabel(tr("Not a medical device. Not for diagnosis."), this);
    notice->setAlignment(Qt::AlignCenter);
    notice->setEnabled(false);
    column->addWidget(notice);
    connect(folder, &QPushButton::clicked, this, &WelcomePage::openFolderRequested);
    connect(file, &QPushButton::clicked, this, &WelcomePage::openFileRequested);
    connect(casting, &QPushButton::clicked, this, [this] { Q_EMIT sampleRequested(QStringLiteral("sample:casting")); });
    connect(head, &QPushButton::clicked, this, [this] { Q_EMIT sampleRequested(QStringLiteral("sample:head")); });
}

}  // namespace lacuna::ui
