#include "perinox/study/child_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <thread>

#include "perinox/core/clock.hpp"
#include "perinox/core/error.hpp"

extern char** environ;

namespace perinox::study {

namespace {
/// True for variables by which an MPI program knows that it was started by mpirun.
bool belongs_to_mpirun(const char* variable) {
  for (const char* prefix : {"OMPI_COMM_WORLD", "OMPI_UNIVERSE", "OMPI_APP_CTX", "OMPI_FIRST_RANKS", "OMPI_NUM_APP_CTX",
                             "OMPI_FILE_LOCATION", "OMPI_ARGV", "OMPI_COMMAND", "OMPI_MCA_orte_", "OMPI_MCA_ess",
                             "OMPI_MCA_pmix", "OMPI_MCA_initial_wdir", "PMIX_", "PMI_"})
    if (std::strncmp(variable, prefix, std::strlen(prefix)) == 0) return true;
  return false;
}

std::vector<std::string> environment() {
  std::vector<std::string> variables;
  for (char** variable = environ; *variable != nullptr; ++variable)
    if (!belongs_to_mpirun(*variable)) variables.emplace_back(*variable);
  const auto unless_set = [&](const char* name, const char* value) {
    if (std::getenv(name) == nullptr) variables.push_back(std::string(name) + "=" + value);
  };
  if (::geteuid() == 0)
    for (const char* name : {"OMPI_ALLOW_RUN_AS_ROOT", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM"}) unless_set(name, "1");
  unless_set("OMP_NUM_THREADS", "1");
  unless_set("OPENBLAS_NUM_THREADS", "1");
  return variables;
}

std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> list;
  for (std::string& word : words) list.push_back(word.data());
  list.push_back(nullptr);
  return list;
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}
}  // namespace

Outcome run_child(const std::vector<std::string>& command, const std::string& output_file,
                  const std::string& error_file) {
  std::vector<std::string> words = command, variables = environment();
  const std::vector<char*> arguments = pointers(words), setting = pointers(variables);
  const int nothing = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  const int out = ::open(output_file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  const int error = ::open(error_file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  const double begin = now();
  const pid_t parent = ::getpid();
  const pid_t child = out < 0 || error < 0 || nothing < 0 ? -1 : ::fork();
  if (child == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (::getppid() != parent) ::_exit(127);  // the study died before the line above
    ::dup2(nothing, STDIN_FILENO);
    ::dup2(out, STDOUT_FILENO);
    ::dup2(error, STDERR_FILENO);
    ::execvpe(arguments[0], arguments.data(), setting.data());
    ::_exit(127);
  }
  const int reason = errno;
  for (const int file : {nothing, out, error})
    if (file >= 0) ::close(file);
  if (child < 0) throw RunError(fmt::format("{} cannot be started: {}", command[0], std::strerror(reason)));
  int status = 0;
  rusage usage{};
  while (::wait4(child, &status, 0, &usage) < 0 && errno == EINTR) {
  }
  Outcome outcome;
  outcome.wall_seconds = now() - begin;
  outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  outcome.cpu_seconds = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  outcome.peak_megabytes = static_cast<double>(usage.ru_maxrss) / 1024;
  if (outcome.status == 127) throw RunError(fmt::format("{} cannot be started: is it installed?", command[0]));
  return outcome;
}

std::vector<std::string> on_ranks(int ranks, const std::vector<std::string>& command) {
  if (ranks == 1) return command;
  std::vector<std::string> all{"mpirun", "-np", std::to_string(ranks)};
  if (ranks > static_cast<int>(std::thread::hardware_concurrency())) all.emplace_back("--oversubscribe");
  all.insert(all.end(), command.begin(), command.end());
  return all;
}

int ranks_around() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"})
    if (const char* text = std::getenv(name); text != nullptr && std::atoi(text) > 1) return std::atoi(text);
  return 1;
}

bool first_rank_around() {
  for (const char* name : {"OMPI_COMM_WORLD_RANK", "PMI_RANK"})
    if (const char* text = std::getenv(name); text != nullptr) return std::atoi(text) == 0;
  return true;
}

std::string own_path() { return std::filesystem::read_symlink("/proc/self/exe").string(); }

}  // namespace perinox::study
