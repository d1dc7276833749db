#pragma once

#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>

#include "core/io/pacs.h"
#include "ui/task.h"

namespace lacuna::ui {

/// Studies on DICOM servers: looked for, retrieved into a folder and opened; files sent. All of it runs in the
/// background and stands in the task list.
class PacsDialog final : public QDialog {
    Q_OBJECT
public:
    explicit PacsDialog(TaskList* tasks, QWidget* parent = nullptr);
    ~PacsDialog() override;

    void setServers(const std::vector<PacsServer>& servers);
    const std::vector<PacsServer>& servers() const { return servers_; }
    void test();
    void search();
    void retrieve(const QString& folder);
    void send(const QStringList& files);
    QTreeWidget* results() const { return results_; }
    QLabel* statusText() const { return status_; }

Q_SIGNALS:
    void finished();                        ///< a test, search, retrieval or sending has ended
    void retrieved(const QString& folder);  ///< to be opened

private:
    QWidget* makeServerRow();
    QWidget* makeQuery();
    const PacsServer* current() const;
    void editServer(bool fresh);
    void removeServer();
    void showServers(int row);
    void showStudies(const PacsAnswer<PacsStudy>& answer);
    void loadSeries(QTreeWidgetItem* study);
    void askForSeries();
    void forgetResults();
    void chooseAndRetrieve();
    void chooseAndSend();
    void showEnabled();
    /// Says an error; true if there was one.
    template <class T>
    bool failed(const Outcome<T>& outcome);

    TaskList* tasks_;
    std::vector<PacsServer> servers_;
    QComboBox* server_;
    QLineEdit* name_;
    QLineEdit* id_;
    QLineEdit* accession_;
    QComboBox* since_;
    QComboBox* modality_;
    QTreeWidget* results_;
    QLabel* status_;
    QPushButton* edit_ = nullptr;
    QPushButton* remove_ = nullptr;
    QPushButton* test_ = nullptr;
    QPushButton* search_ = nullptr;
    QPushButton* retrieve_ = nullptr;
    QPushButton* send_ = nullptr;
    QStringList asked_;  ///< studies whose series are still to be asked for
    Task<int> echo_;
    Task<PacsAnswer<PacsStudy>> find_;
    Task<PacsAnswer<PacsSeries>> series_;
    Task<PacsTransfer> get_;
    Task<PacsTransfer> store_;
};

}  // namespace lacuna::ui
