// Tables of points as --points takes them. The input's first byte says how many columns there are and how
// many rows are read at a time.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "host/base/parameter_check.h"
#include "host/io/number_table.h"
#include "tests/fuzz/expect.h"
#include "tests/fuzz/input_file.h"

namespace {

/// All rows; checks what a table promises.
std::vector<double> all_of(offing::NumberTable& table, std::size_t columns, std::size_t most) {
  using offing::fuzz::expect;
  std::vector<double> numbers;
  for (std::vector<double> rows = table.next(most); !rows.empty(); rows = table.next(most)) {
    expect(rows.size() % columns == 0 && rows.size() <= most * columns);
    expect(table.place_of(rows.size() / columns - 1).find(':') != std::string::npos);
    for (const double number : rows) expect(std::abs(number) <= offing::farthest_point_m);
    numbers.insert(numbers.end(), rows.begin(), rows.end());
  }
  return numbers;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return -1;  // do not keep it
  static const offing::fuzz::InputFile file("points.csv");
  file.hold({data + 1, size - 1});
  const std::vector<std::string> names{"x_m", "z_m", "height_m", "to_x_m", "to_z_m", "to_height_m"};
  const std::size_t columns = 1 + data[0] % names.size();
  const std::size_t most = 1 + data[0] / names.size();
  return offing::fuzz::check_reading([&] {
    offing::NumberTable table(file.path(),
                              {.names = {names.begin(), names.begin() + static_cast<std::ptrdiff_t>(columns)},
                               .meaning = "for each point, where it is in m",
                               .example = "1,2"});
    offing::fuzz::expect(table.can_rewind());
    const std::vector<double> once = all_of(table, columns, most);
    table.rewind();
    offing::fuzz::expect(all_of(table, columns, most) == once);
  });
}
