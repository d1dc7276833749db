#include "ui/pacs_server_dialog.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QSettings>
#include <QStyle>

#include "ui/file_choice.h"

namespace lacuna::ui {

namespace {

QString text(const std::string& words) { return QString::fromStdString(words); }

}  // namespace

std::vector<PacsServer> kept_pacs_servers() {
    QSettings settings;
    std::vector<PacsServer> servers;
    const int count = settings.beginReadArray(QStringLiteral("pacs/servers"));
    const auto word = [&](const char* key) { return settings.value(QLatin1String(key)).toString().toStdString(); };
    for (int i = 0; i < count; ++i) {
        settings.setArrayIndex(i);
        PacsServer server;
        server.name = word("name");
        server.host = word("host");
        server.port = settings.value(QStringLiteral("port"), 104).toInt();
        server.called_aet = word("called");
        server.calling_aet = word("calling");
        server.timeout_s = settings.value(QStringLiteral("timeout_s"), 30).toInt();
        server.tls.on = settings.value(QStringLiteral("tls"), false).toBool();
        server.tls.trusted = word("trusted");
        server.tls.certificate = word("certificate");
        server.tls.key = word("key");
        server.receiver.on = settings.value(QStringLiteral("move"), false).toBool();
        server.receiver.address =
            settings.value(QStringLiteral("move_address"), text(PacsReceiver{}.address)).toString().toStdString();
        server.receiver.port = settings.value(QStringLiteral("move_port"), PacsReceiver{}.port).toInt();
        servers.push_back(std::move(server));
    }
    settings.endArray();
    return servers;
}

void keep_pacs_servers(const std::vector<PacsServer>& servers) {
    QSettings settings;
    settings.remove(QStringLiteral("pacs/servers"));
    settings.beginWriteArray(QStringLiteral("pacs/servers"), int(servers.size()));
    for (int i = 0; i < int(servers.size()); ++i) {
        const PacsServer& server = servers[std::size_t(i)];
        settings.setArrayIndex(i);
        const auto put = [&](const char* key, const std::string& words) {
            settings.setValue(QLatin1String(key), text(words));
        };
        put("name", server.name);
        put("host", server.host);
        settings.setValue(QStringLiteral("port"), server.port);
        put("called", server.called_aet);
        put("calling", server.calling_aet);
        settings.setValue(QStringLiteral("timeout_s"), server.timeout_s);
        settings.setValue(QStringLiteral("tls"), server.tls.on);
        put("trusted", server.tls.trusted.string());
        put("certificate", server.tls.certificate.string());
        put("key", server.tls.key.string());
        settings.setValue(QStringLiteral("move"), server.receiver.on);
        put("move_address", server.receiver.address);
        settings.setValue(QStringLiteral("move_port"), server.receiver.port);
    }
    settings.endArray();
}

PacsServerDialog::PacsServerDialog(const PacsServer& server, QWidget* parent)
    : QDialog(parent),
      name_(new QLineEdit(text(server.name), this)),
      host_(new QLineEdit(text(server.host), this)),
      port_(new QSpinBox(this)),
      called_(new QLineEdit(text(server.called_aet), this)),
      calling_(new QLineEdit(text(server.calling_aet), this)),
      timeout_(new QSpinBox(this)),
      tls_(new QCheckBox(tr("&Secure connection (TLS)"), this)),
      trusted_(file(server.tls.trusted, tr("Trusted certificates"))),
      certificate_(file(server.tls.certificate, tr("Own certificate"))),
      key_(file(server.tls.key, tr("Own private key"))),
      move_(new QCheckBox(tr("&Retrieve by C-MOVE"), this)),
      move_address_(new QLineEdit(text(server.receiver.address), this)),
      move_port_(new QSpinBox(this)) {
    setWindowTitle(tr("DICOM server"));
    resize(460, 0);
    auto* form = new QFormLayout(this);
    port_->setRange(1, 65535);
    port_->setValue(server.port);
    timeout_->setRange(1, 600);
    timeout_->setValue(server.timeout_s);
    timeout_->setSuffix(tr(" s"));
    for (QLineEdit* title : {called_, calling_}) title->setMaxLength(16);
    tls_->setChecked(server.tls.on);
    tls_->setToolTip(tr("TLS 1.2 or newer with the ciphers of BCP 195"));
    form->addRow(tr("&Name"), name_);
    form->addRow(tr("&Host"), host_);
    form->addRow(tr("&Port"), port_);
    form->addRow(tr("Its &AE title"), called_);
    form->addRow(tr("&Our AE title"), calling_);
    form->addRow(tr("&Wait at most"), timeout_);
    form->addRow(tls_);
    form->addRow(tr("&Trusted certificates"), trusted_);
    form->addRow(tr("Own &certificate"), certificate_);
    form->addRow(tr("Own private &key"), key_);
    const auto allow = [this](bool on) {
        for (QLineEdit* edit : {trusted_, certificate_, key_}) edit->setEnabled(on);
    };
    connect(tls_, &QCheckBox::toggled, this, allow);
    allow(server.tls.on);
    addReceiver(form, server.receiver);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    form->addRow(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void PacsServerDialog::addReceiver(QFormLayout* form, const PacsReceiver& receiver) {
    move_->setChecked(receiver.on);
    move_->setToolTip(tr(
        "For servers that know no C-GET: during a retrieval a port of this computer is open, which takes images from "
        "this server's AE title alone. The server has to know our AE title, the address and the port."));
    move_address_->setAccessibleName(tr("Address to receive at"));
    move_address_->setToolTip(
        tr("One of this computer's addresses; 127.0.0.1 takes only what comes from this computer itself"));
    move_port_->setAccessibleName(tr("Port to receive at"));
    move_port_->setRange(1, 65535);
    move_port_->setValue(receiver.port);
    form->addRow(move_);
    form->addRow(tr("Receive at a&ddress"), move_address_);
    form->addRow(tr("Recei&ve at port"), move_port_);
    const auto allow = [this](bool on) {
        move_address_->setEnabled(on);
        move_port_->setEnabled(on);
    };
    connect(move_, &QCheckBox::toggled, this, allow);
    allow(receiver.on);
}

QLineEdit* PacsServerDialog::file(const std::filesystem::path& now, const QString& name) {
    auto* edit = new QLineEdit(text(now.string()), this);
    edit->setAccessibleName(name);
    edit->setPlaceholderText(tr("PEM file"));
    QAction* choose = edit->addAction(style()->standardIcon(QStyle::SP_DialogOpenButton), QLineEdit::TrailingPosition);
    choose->setToolTip(tr("Choose a file"));
    connect(choose, &QAction::triggered, this, [this, edit, name] {
        const QString chosen = file_choice::open_file(this, name, FileKind::certificate,
                                                      tr("PEM files (*.pem *.crt *.key);;All files (*)"));
        if (!chosen.isEmpty()) edit->setText(chosen);
    });
    return edit;
}

PacsServer PacsServerDialog::server() const {
    PacsServer server;
    server.name = name_->text().trimmed().toStdString();
    server.host = host_->text().trimmed().toStdString();
    if (server.name.empty()) server.name = server.host;
    server.port = port_->value();
    server.called_aet = called_->text().trimmed().toStdString();
    server.calling_aet = calling_->text().trimmed().toStdString();
    server.timeout_s = timeout_->value();
    server.tls.on = tls_->isChecked();
    server.tls.trusted = trusted_->text().trimmed().toStdString();
    server.tls.certificate = certificate_->text().trimmed().toStdString();
    server.tls.key = key_->text().trimmed().toStdString();
    server.receiver.on = move_->isChecked();
    server.receiver.address = move_address_->text().trimmed().toStdString();
    server.receiver.port = move_port_->value();
    return server;
}

}  // namespace lacuna::ui
