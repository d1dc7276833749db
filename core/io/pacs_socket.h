#pragma once

#include <dcmtk/config/osconfig.h>
// DCMTK's configuration comes first
#include <dcmtk/dcmnet/dcmlayer.h>

#include <functional>
#include <memory>
#include <mutex>
#include <string>

#include "core/io/pacs.h"

// What lies below DICOM's messages: sockets that can be woken, in the clear or secured.
namespace lacuna::dicom {

/// A second handle on a connection's socket: shutting it down wakes whatever waits on the first one.
class SocketWatch {
public:
    ~SocketWatch();
    void watch(int socket);
    void shut_down();

private:
    std::mutex mutex_;
    int copy_ = -1;
    bool down_ = false;
};

/// The transport of a server's connections, watched. @param accepts  this end is called, else it calls
/// @param on_connection  told when a socket has become a connection. @throws Error(bad_usage) naming the PEM file that
/// cannot be used
std::unique_ptr<DcmTransportLayer> make_transport(const PacsTls& tls, bool accepts, std::shared_ptr<SocketWatch> watch,
                                                  std::function<void()> on_connection = {});

/// One line of a foreign text, without control characters.
std::string one_line(const char* text);

/// DCMTK's network calls switch off how it reads files for the whole process; this gives the setting back.
class ReadingAsBefore {
public:
    ReadingAsBefore();
    ~ReadingAsBefore();

private:
    bool corrects_;
};

}  // namespace lacuna::dicom
