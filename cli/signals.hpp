#pragma once

namespace delone::cli {

/// From now on SIGINT, SIGTERM, SIGHUP and SIGPIPE remove the temporary files of running
/// writers before the process dies of the signal as it would have anyway: an interrupted
/// run leaves no partial file, and a reader that goes away (`delone hull points.csv |
/// head`) ends the program silently. A signal that the parent had ignored (nohup) stays
/// ignored.
void install_signal_handlers();

}  // namespace delone::cli
