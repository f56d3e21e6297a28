#include "chain/run_chain.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "base/cleanup.hpp"
#include "base/parallel.hpp"
#include "chain/chain_inputs.hpp"
#include "chain/early_checks.hpp"
#include "chain/end_of_run.hpp"
#include "chain/make_quads.hpp"
#include "chain/watched_child.hpp"
#include "cli/messages.hpp"
#include "cli/outcome.hpp"
#include "cli/process_setup.hpp"
#include "io/whole_file.hpp"

namespace quadrille::chain {

namespace {

namespace fs = std::filesystem;

/// Waits; false where there are no locks.
bool lock_file(int fd) {
  while (flock(fd, LOCK_EX) != 0)
    if (errno != EINTR) return false;
  return true;
}

/// Whether the path still names the file: the run before removes it.
bool is_named(int fd, const std::string& path) {
  struct stat open_file {
  }, named{};
  return fstat(fd, &open_file) == 0 && stat(path.c_str(), &named) == 0 && open_file.st_ino == named.st_ino;
}

/// One run at a time on the stage files of a shape in a folder.
///
/// Holds the files STEM.* of a folder as long as it exists. A second run waits, in other processes and on other
/// machines too where the file system has locks; where it has none, nobody waits.
class FolderLock {
 public:
  /// `stem`: path without the endings. The file FOLDER/.NAME.lock exists while a run holds it.
  explicit FolderLock(const std::string& stem, bool is_quiet);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  std::string path_;
  int fd_ = -1, slot_ = -1;
};

FolderLock::FolderLock(const std::string& stem, bool is_quiet) {
  const std::size_t name = stem.rfind('/') + 1;  // npos + 1 is 0
  path_ = stem.substr(0, name) + '.' + stem.substr(name) + ".lock";
  bool is_told = is_quiet;
  for (;;) {
    fd_ = open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (fd_ < 0) return;
    if (flock(fd_, LOCK_EX | LOCK_NB) != 0) {
      if (errno == EWOULDBLOCK && !is_told)
        cli::print_message(fmt::format("quadmesh: waits for another run that works on {}.*\n", stem));
      is_told = true;
      if (!lock_file(fd_)) break;
    }
    if (is_named(fd_, path_)) break;
    close(fd_);
  }
  slot_ = register_temporary(path_);
}

FolderLock::~FolderLock() {
  if (fd_ < 0) return;
  unlink(path_.c_str());
  release_temporary(slot_);
  close(fd_);
}

std::string make_scratch() {
  const char* const folder = std::getenv("TMPDIR");
  std::string path = std::string(folder != nullptr && *folder != '\0' ? folder : "/tmp") + "/quadmesh.XXXXXX";
  if (mkdtemp(path.data()) == nullptr)
    throw OutputError(fmt::format("the temporary folder in {}: cannot be written: {}", path.substr(0, path.rfind('/')),
                                  std::strerror(errno)));
  return path;
}

void make_folder(const ChainOptions& options) {
  std::error_code error;
  if (options.workdir.empty() || fs::is_directory(options.workdir, error)) return;
  if (options.is_dry_run) {
    cli::print_to_stdout(shell_command({"mkdir", "-p", options.workdir}) + '\n');
    return;
  }
  fs::create_directories(options.workdir, error);
  if (error) throw OutputError(fmt::format("{}: cannot be written: {}", options.workdir, error.message()));
}

void sweep_quads(ChainState& chain) {
  if (!chain.options.is_swept) return;
  StageFile<QuadMesh>& quads = chain.files.of_nodes.quads;
  const auto hexes = [&](Run& run) {
    const stage::HexsweepOptions& options = chain.values.hexsweep;
    const auto curve = space_points(chain, options.curve_file), terrain = space_points(chain, options.terrain_file);
    return stage::hexsweep({quads.input(), curve.input(), terrain.input()}, options, run);
  };
  make_file(chain, {ChainStage::hexsweep}, chain.files.hexes, hexes, quads);
}

void export_mesh(ChainState& chain) {
  ChainFiles& files = chain.files;
  const std::string ending = exported_ending(chain.options, chain.values);
  const bool is_step = ending == "blocks.h5", is_swept = ending == "hex.h5";
  StageTask task;
  task.stage = ChainStage::quadexport;
  task.output = output_of(chain.options);
  task.words = {files.stem + '.' + ending};
  task.compute = [&, is_step, is_swept](Run& run) {
    const std::string output = output_of(chain.options);
    std::vector<stage::OutputFile> written;
    if (is_step) {
      const std::string bytes = io::stage_bytes(files.of_nodes.blocks.model());
      written = {stage::quadexport_step({bytes, io::identity_of(files.of_nodes.blocks.path(), bytes)}, output,
                                        chain.values.quadexport, run)};
    } else if (is_swept) {
      written = stage::quadexport(files.hexes.release(), files.hexes.path(), output, chain.values.quadexport, run);
    } else {
      written = stage::quadexport(files.of_nodes.quads.release(), files.of_nodes.quads.path(), output,
                                  chain.values.quadexport, run);
    }
    for (const stage::OutputFile& file : written) io::write_output(file.path, file.bytes, file.is_binary);
  };
  task.write_inputs = [&, is_step, is_swept] {
    if (is_step)
      files.of_nodes.blocks.write();
    else
      is_swept ? files.hexes.write() : files.of_nodes.quads.write();
  };
  run_stage(chain, task);
}

/// The file of the last stage, where that is the output.
void write_stage_file(ChainState& chain) {
  ChainFiles& files = chain.files;
  const auto write = [&](auto& file) {
    io::write_stage_bytes(output_of(chain.options), io::stage_bytes(file.release()));
  };
  switch (chain.options.last) {
    case ChainStage::cad2tri:
      return write(files.triangles);
    case ChainStage::fieldsolve:
      return write(files.solve);
    case ChainStage::padapt:
      return write(files.field);
    case ChainStage::critpoints:
      return write(files.of_nodes.nodes);
    case ChainStage::separatrix:
      return write(files.of_nodes.graph);
    case ChainStage::blocksplit:
      return write(files.of_nodes.blocks);
    case ChainStage::quadrefine:
      return write(files.of_nodes.quads);
    case ChainStage::hexsweep:
      return write(files.hexes);
    case ChainStage::quadexport:
      return;
  }
}

/// Layers with blocks of their own need curves that cad2tri makes, others room below the irregular nodes; for formats
/// with straight sides, elements along them are short.
void add_options_of_walls(ChainState& chain) {
  const std::string output = mesh_name_of(chain.options);
  if (bool& is_straight = chain.values.quadrefine.has_straight_sides;
      !is_straight && !chain.values.quadrefine.walls.empty() &&
      stage::has_straight_sides(stage::format_of(output, chain.values.quadexport))) {
    chain.added["quadrefine"].emplace_back("--straight-sides");
    is_straight = true;
  }
  for (const std::string& offset : stage::offsets_of(chain.values.quadrefine)) {
    chain.added["cad2tri"].insert(chain.added["cad2tri"].end(), {"--offset", offset});
    chain.values.cad2tri.offsets.push_back(offset);
  }
}

void add_clearances(ChainState& chain) {
  if (!chain.is_due(ChainStage::critpoints) || !chain.options.nodes_file.empty() ||
      chain.values.separatrix.layout == layout::LayoutChoice::midpoint)
    return;
  std::vector<std::string>& given = chain.values.critpoints.clearances;
  const std::vector<std::string> of_user = given;
  for (const std::string& clearance : stage::clearances_of(chain.values.quadrefine)) {
    const std::string name = clearance.substr(0, clearance.rfind('=') + 1);
    if (std::any_of(of_user.begin(), of_user.end(), [&](const std::string& one) { return one.starts_with(name); }))
      continue;
    chain.added["critpoints"].insert(chain.added["critpoints"].end(), {"--clearance", clearance});
    given.push_back(clearance);
  }
}

void run_stages(ChainState& chain) {
  check_files(chain);
  make_folder(chain.options);
  std::optional<FolderLock> lock;
  if (!chain.options.workdir.empty() && !chain.options.is_dry_run)
    lock.emplace(chain.files.stem, chain.options.is_quiet);
  triangulate_shape(chain);
  check_face(chain);
  add_clearances(chain);
  make_quads(chain);
  sweep_quads(chain);
  export_mesh(chain);
  if (chain.options.is_dry_run) return;
  if (chain.options.writes_stage_file()) write_stage_file(chain);
  end_run(chain);
}

/// An exception that no stage has caught is one of quadmesh.
int run_to_the_end(ChainState& chain) {
  ChainFailure failure;
  const cli::Outcome outcome = cli::outcome_of([&] {
    try {
      run_stages(chain);
    } catch (const ChainFailure& thrown) {
      failure = thrown;
    }
  });
  if (!outcome.is_success()) {
    cli::print_failure("quadmesh", outcome);
    if (outcome.code == ExitCode::usage) return static_cast<int>(outcome.code);
    failure = {outcome.code, "quadmesh", outcome.message};
  } else if (!failure.is_printed) {
    cli::print_message(fmt::format("quadmesh: {}\n", failure.message));
  }
  if (failure.code != ExitCode::done) end_failed_run(chain, failure);
  return static_cast<int>(failure.code);
}

/// What standard input holds, if it is the shape or the nodes: read once, before a process is copied.
std::optional<std::string> standard_input(const ChainOptions& options) {
  if (options.is_dry_run || (options.shape != "-" && options.nodes_file != "-")) return std::nullopt;
  if (options.shape == "-" && options.first != ChainStage::cad2tri) return std::nullopt;
  std::string bytes;
  std::array<char, 65536> buffer{};
  for (ssize_t count = 0; (count = read(STDIN_FILENO, buffer.data(), buffer.size())) > 0;)
    bytes.append(buffer.data(), static_cast<std::size_t>(count));
  return bytes;
}

/// Everything after the command line was read.
int run(ChainOptions options) {
  const Budget budget(options.limits);
  StageOptions values;
  std::string scratch;
  std::optional<std::string> input;
  const cli::Outcome checked = cli::outcome_of([&] {
    values = stage_options(options);
    check_command_line(options, values);
    options.shape = shape_of(options, values);
    input = standard_input(options);
  });
  if (!checked.is_success()) return cli::print_failure("quadmesh", checked);
  const auto work = [&](bool is_second_try) {
    cli::install_signal_handlers();
    if (options.num_threads == 0) start_threads_after();
    StageRunner runner(options, budget, is_second_try || budget.is_limited(), scratch);
    const std::string folder = !options.workdir.empty() ? options.workdir : options.is_dry_run ? "." : scratch;
    ChainState chain(options, values, runner, folder + '/' + stem_of(options.shape));
    chain.standard_input = input;
    chain.keeps_files = !options.workdir.empty() || options.writes_stage_file() || !options.html.empty() ||
                        !options.nodes_file.empty() || !options.programs.empty() || is_second_try ||
                        budget.is_limited();
    chain.values.fieldsolve.estimates_errors = chain.keeps_files;  // padapt makes its own
    const cli::Outcome added = cli::outcome_of([&] { add_options_of_walls(chain); });
    return added.is_success() ? run_to_the_end(chain) : cli::print_failure("quadmesh", added);
  };
  if (options.is_dry_run) return work(false);
  int code = 0;
  const cli::Outcome outcome =
      cli::outcome_of([&] { code = supervise(work, [&] { return scratch = make_scratch(); }); });
  return outcome.is_success() ? code : cli::print_failure("quadmesh", outcome);
}

}  // namespace

int run_chain(const std::vector<std::string>& arguments) {
  ChainOptions options;
  const cli::Request request = cli::request_of(arguments);
  const cli::Outcome outcome = cli::outcome_of([&] {
    const bool is_for_all = std::ranges::count(arguments, "--help-all") > 0;
    cli::answer(request, "quadmesh", is_for_all ? full_help_text : help_text, option_list);
    if (request == cli::Request::run) read_command_line(arguments, options);
  });
  return outcome.is_success() && request == cli::Request::run ? run(std::move(options))
                                                              : cli::print_failure("quadmesh", outcome);
}

}  // namespace quadrille::chain
