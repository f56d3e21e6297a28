#pragma once
// What Abaqus .inp of quadrilaterals and of hexahedra have in common. Private to abaqus*.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "export/groups.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {

/// CalculiX' greatest length of the name of a set; upper and lower case are the same.
inline const WordRules abaqus_set_names{{"NALL", "EALL"}, 80, true};

class AbaqusText : protected TextWriter {
 protected:
  void print_node(int number, const std::array<double, 3>& x) {
    print("{}, {}, {}, {}\n", number, short_number(x[0]), short_number(x[1]), short_number(x[2]));
  }

  /// `regions`: sets of elements that were written.
  void print_all_elements(const NameList& regions) {
    print("*ELSET, ELSET=EALL\n");
    for (const std::string& region : regions) print("{}\n", region);
  }

  /// Sorted, each once.
  void print_node_set(const std::string& name, std::vector<int> numbers) {
    constexpr int numbers_a_line = 16;
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    print("*NSET, NSET={}\n", name);
    for (std::size_t k = 0; k < numbers.size(); ++k)
      print("{}{}", numbers[k], (k + 1) % numbers_a_line == 0 || k + 1 == numbers.size() ? "\n" : ", ");
  }

 private:
  /// The shortest digits that read back to the same bits or, if those are more than CalculiX reads, as many as fit.
  static std::string short_number(double x) {
    constexpr std::size_t longest = 20;
    std::string text = fmt::format("{}", x);
    for (int digits = 17; text.size() > longest; --digits) text = fmt::format("{:.{}g}", x, digits);
    return text;
  }
};

}  // namespace quadrille::exports
