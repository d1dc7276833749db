#include "ui/dialogs/log_window.h"

#include <QClipboard>
#include <QDialogButtonBox>
#include <QFontDatabase>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/tab_chain.h"

namespace lacuna::ui {

LogWindow::LogWindow(QWidget* parent) : QDialog(parent), level_(new QComboBox(this)), lines_(new QPlainTextEdit(this)) {
    setWindowTitle(tr("Log"));
    resize(760, 420);
    for (const LogLevel level : {LogLevel::debug, LogLevel::info, LogLevel::warning, LogLevel::error})
        level_->addItem(level_name(level), int(level));
    level_->setCurrentIndex(1);
    level_->setAccessibleName(tr("Least level shown"));
    lines_->setReadOnly(true);
    lines_->setTabChangesFocus(true);
    lines_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    lines_->setAccessibleName(tr("Log"));
    lines_->setMaximumBlockCount(int(LogStore::k_lines_kept));
    lines_->setPlaceholderText(tr("Nothing was logged yet."));
    auto* label = new QLabel(tr("&From level"), this);
    label->setBuddy(level_);
    auto* top = new QHBoxLayout;
    top->addWidget(label);
    top->addWidget(level_);
    top->addStretch(1);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    QPushButton* copy = buttons->addButton(tr("&Copy"), QDialogButtonBox::ActionRole);
    copy->setAccessibleName(tr("Copy the log"));
    QPushButton* clear = buttons->addButton(tr("C&lear"), QDialogButtonBox::ActionRole);
    clear->setAccessibleName(tr("Clear the log"));
    buttons->button(QDialogButtonBox::Close)->setAccessibleName(tr("Close the log"));
    auto* column = new QVBoxLayout(this);
    column->addLayout(top);
    column->addWidget(lines_, 1);
    column->addWidget(buttons);
    chain_tabs({level_, lines_, copy, clear, buttons->button(QDialogButtonBox::Close)});
    connect(level_, &QComboBox::currentIndexChanged, this, &LogWindow::fill);
    connect(copy, &QPushButton::clicked, this, &LogWindow::copy);
    connect(clear, &QPushButton::clicked, this, [this] {
        LogStore::instance()->clear();
        fill();
    });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(LogStore::instance(), &LogStore::added, this, &LogWindow::append);
    fill();
}

LogLevel LogWindow::least() const { return LogLevel(level_->currentData().toInt()); }

void LogWindow::fill() {
    lines_->clear();
    for (const LogLine& line : LogStore::instance()->lines()) append(line);
}

void LogWindow::append(const LogLine& line) {
    if (line.level >= least()) lines_->appendPlainText(to_text(line));
}

void LogWindow::copy() const { QGuiApplication::clipboard()->setText(text()); }

}  // namespace lacuna::ui
