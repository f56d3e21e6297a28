#include <sys/mman.h>
#include <unistd.h>

#include <IGESControl_Reader.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESModel.hxx>
#include <TCollection_HAsciiString.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include "base/error.hpp"
#include "occ/occ_model.hpp"

namespace quadrille::occ {
namespace {

// The reader requires a path: an anonymous file in memory provides it.
class MemoryFile {
 public:
  explicit MemoryFile(const std::string& bytes) : fd_(memfd_create("cad", 0)) {
    if (fd_ < 0) throw Defect("cannot make a file in memory");
    for (size_t done = 0; done < bytes.size();) {
      const ssize_t n = write(fd_, bytes.data() + done, bytes.size() - done);
      if (n <= 0) throw Defect("cannot write a file in memory");
      done += static_cast<size_t>(n);
    }
  }
  ~MemoryFile() { close(fd_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  std::string path() const { return "/proc/self/fd/" + std::to_string(fd_); }

 private:
  int fd_;
};

// Names of the unit flags of the global section (IGES 5.3, table 2.2.4.3.14).
std::string unit_name(int flag) {
  switch (flag) {
    case 1:
      return "inch";
    case 2:
      return "millimetre";
    case 4:
      return "foot";
    case 5:
      return "mile";
    case 6:
      return "metre";
    case 7:
      return "kilometre";
    case 8:
      return "mil";
    case 9:
      return "micrometre";
    case 10:
      return "centimetre";
    case 11:
      return "microinch";
    default:
      return "unknown";
  }
}

}  // namespace

OccModel occ_load_iges(const std::string& bytes, const std::string& name) {
  switch_healing_off();
  IGESControl_Reader reader;
  const MemoryFile file(bytes);
  if (reader.ReadFile(file.path().c_str()) != IFSelect_RetDone)
    throw FormatError(name + ": the IGES file cannot be parsed");
  const Handle(IGESData_IGESModel) iges = reader.IGESModel();
  IGESData_GlobalSection global = iges->GlobalSection();
  OccModel model;
  model.length_unit = unit_name(global.UnitFlag());
  if (model.length_unit != "unknown") {
    global.SetCascadeUnit(1.0);
    const double millimetres = global.UnitValue();
    model.metres_per_unit = millimetres / 1000;
    // The reader multiplies coordinates by the millimetres per unit and divides them by this value: the factor is
    // exactly 1.
    global.SetCascadeUnit(millimetres);
    iges->SetGlobalSection(global);
  }
  if (global.Resolution() > 0) model.tolerance = global.Resolution();
  reader.SetReadVisible(false);
  reader.TransferRoots();
  model.shape = reader.OneShape();
  add_iges_labels(*iges, reader.WS()->TransferReader()->TransientProcess(), model);
  return model;
}

const KernelFormat& iges_format() {
  static const KernelFormat format{cad::CadFormat::iges, occ_load_iges, nullptr};
  return format;
}

}  // namespace quadrille::occ
