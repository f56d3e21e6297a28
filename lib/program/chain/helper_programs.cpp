#include "chain/helper_programs.hpp"

#include <filesystem>

namespace quadrille::chain {

std::string command_path(const std::string& name) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
  for (const fs::path& path : {folder / name, folder / "../../pipelines" / name})
    if (fs::exists(path, error)) return path.string();
  return name;
}

}  // namespace quadrille::chain
