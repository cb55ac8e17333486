#include "app/mpi/mailbox.h"

namespace pupflow::mpi {

Mailbox::Mailbox() {
  int size = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  outgoing_.resize(static_cast<std::size_t>(size));
  // The default handler would end this rank when a message to a lost rank fails.
  MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN);
}

void Mailbox::send(int destination, Tag tag, std::string bytes) {
  std::list<Outgoing>& messages = outgoing_[static_cast<std::size_t>(destination)];
  Outgoing& message = messages.emplace_back(Outgoing{std::move(bytes), MPI_REQUEST_NULL});
  const int status =
      MPI_Isend(message.bytes.data(), static_cast<int>(message.bytes.size()), MPI_BYTE, destination,
                static_cast<int>(tag), MPI_COMM_WORLD, &message.request);
  if (status != MPI_SUCCESS) messages.pop_back();
}

bool Mailbox::all_sent(int destination) {
  std::list<Outgoing>& messages = outgoing_[static_cast<std::size_t>(destination)];
  messages.remove_if([](Outgoing& message) {
    int done = 0;
    return MPI_Test(&message.request, &done, MPI_STATUS_IGNORE) != MPI_SUCCESS || done != 0;
  });
  return messages.empty();
}

std::optional<Message> Mailbox::receive() {
  int arrived = 0;
  MPI_Status status;
  if (MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &arrived, &status) != MPI_SUCCESS ||
      arrived == 0) {
    return std::nullopt;
  }
  int size = 0;
  MPI_Get_count(&status, MPI_BYTE, &size);
  Message message{status.MPI_SOURCE, static_cast<Tag>(status.MPI_TAG),
                  std::string(static_cast<std::size_t>(size), '\0')};
  if (MPI_Recv(message.bytes.data(), size, MPI_BYTE, message.source, status.MPI_TAG, MPI_COMM_WORLD,
               MPI_STATUS_IGNORE) != MPI_SUCCESS) {
    return std::nullopt;
  }
  return message;
}

}  // namespace pupflow::mpi
