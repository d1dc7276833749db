#include "ui/dialogs/about_dialog.h"

#include <QClipboard>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QGuiApplication>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "core/io/library_versions.h"

namespace lacuna::ui {

QList<QPair<QString, QString>> version_rows(const QString& device, const QString& driver) {
    QList<QPair<QString, QString>> rows{{QStringLiteral("Lacuna"), QStringLiteral(LACUNA_VERSION)},
                                        {QStringLiteral("Qt"), QString::fromLatin1(qVersion())},
                                        {AboutDialog::tr("OpenCL device"), device}};
    if (!driver.isEmpty()) rows.push_back({AboutDialog::tr("OpenCL driver"), driver});
    for (const LibraryVersion& library : io_library_versions())
        rows.push_back({QString::fromStdString(library.name), QString::fromStdString(library.version)});
    return rows;
}

AboutDialog::AboutDialog(const QList<QPair<QString, QString>>& versions, QWidget* parent)
    : QDialog(parent), versions_(versions) {
    setWindowTitle(tr("About Lacuna"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(24, 20, 24, 16);
    column->setSpacing(12);
    auto* title = new QLabel(QStringLiteral("Lacuna"), this);
    QFont large = font();
    large.setPointSizeF(font().pointSizeF() * 2);
    title->setFont(large);
    auto* what =
        new QLabel(tr("A workstation for computed tomography: pictures whose error is known, and the measures of "
                      "what is found in them."),
                   this);
    auto* notice = new QLabel(tr("Not a medical device; not for diagnosis."), this);
    QFont bold = font();
    bold.setBold(true);
    notice->setFont(bold);
    auto* license = new QLabel(tr("Free software under the GNU General Public License, version 3 or later."), this);
    for (QLabel* label : {what, license}) label->setWordWrap(true);
    for (QLabel* label : {title, what, notice}) column->addWidget(label);
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(18);
    for (const auto& [name, version] : versions_) {
        auto* value = new QLabel(version, this);
        value->setTextFormat(Qt::PlainText);
        value->setTextInteractionFlags(Qt::TextSelectableByMouse);
        value->setAccessibleName(name);
        form->addRow(name, value);
    }
    column->addLayout(form);
    column->addWidget(license);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    QPushButton* copy = buttons->addButton(tr("&Copy the versions"), QDialogButtonBox::ActionRole);
    copy->setAccessibleName(tr("Copy the versions"));
    buttons->button(QDialogButtonBox::Close)->setAccessibleName(tr("Close"));
    column->addWidget(buttons);
    connect(copy, &QPushButton::clicked, this, [this] { QGuiApplication::clipboard()->setText(text()); });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    setMinimumSize(460, column->totalHeightForWidth(460));  // wrapped words are taller than they ask for
}

QString AboutDialog::text() const {
    QString text;
    for (const auto& [name, version] : versions_) text += name + QStringLiteral(": ") + version + QLatin1Char('\n');
    return text;
}

}  // namespace lacuna::ui
