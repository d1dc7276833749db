#pragma once

#include <QCheckBox>
#include <QDialog>
#include <QFormLayout>
#include <QLineEdit>
#include <QSpinBox>
#include <vector>

#include "core/io/pacs.h"

namespace lacuna::ui {

/// The servers a person has configured, kept in QSettings. Of a private key only its file's name is kept.
std::vector<PacsServer> kept_pacs_servers();
void keep_pacs_servers(const std::vector<PacsServer>& servers);

/// Edits one server.
class PacsServerDialog final : public QDialog {
    Q_OBJECT
public:
    explicit PacsServerDialog(const PacsServer& server, QWidget* parent = nullptr);
    PacsServer server() const;

private:
    void addReceiver(QFormLayout* form, const PacsReceiver& receiver);
    QLineEdit* file(const std::filesystem::path& now, const QString& name);

    QLineEdit* name_;
    QLineEdit* host_;
    QSpinBox* port_;
    QLineEdit* called_;
    QLineEdit* calling_;
    QSpinBox* timeout_;
    QCheckBox* tls_;
    QLineEdit* trusted_;
    QLineEdit* certificate_;
    QLineEdit* key_;
    QCheckBox* move_;
    QLineEdit* move_address_;
    QSpinBox* move_port_;
};

}  // namespace lacuna::ui
