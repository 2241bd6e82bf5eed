#include "host/io/spectra/netcdf_output.h"

#include <fmt/format.h>
#include <netcdf.h>

#include "host/base/error.h"
#include "host/io/spectra/text_cursor.h"

namespace offing::spectra {
namespace {

int type_of(NetcdfLayout::Type type) {
  switch (type) {
    case NetcdfLayout::Type::int32:
      return NC_INT;
    case NetcdfLayout::Type::float32:
      return NC_FLOAT;
    case NetcdfLayout::Type::float64:
      return NC_DOUBLE;
  }
  return NC_DOUBLE;
}

class ClassicOutput : public NetcdfOutput {
 public:
  ClassicOutput(const std::filesystem::path& path, const NetcdfLayout& layout, std::string target)
      : target_(std::move(target)) {
    check(nc_create(path.c_str(), NC_CLOBBER | NC_64BIT_OFFSET, &id_));
    is_open_ = true;
    try {
      define(layout);
    } catch (...) {
      nc_abort(id_);
      throw;
    }
  }
  ClassicOutput(const ClassicOutput&) = delete;
  ClassicOutput& operator=(const ClassicOutput&) = delete;
  ~ClassicOutput() override {
    if (is_open_) nc_close(id_);
  }

  void put(std::size_t variable, std::span<const std::size_t> start, std::span<const std::size_t> count,
           std::span<const double> values) override {
    check(nc_put_vara_double(id_, variables_[variable], start.data(), count.data(), values.data()));
  }

  void close() override {
    is_open_ = false;
    check(nc_close(id_));
  }

 private:
  void define(const NetcdfLayout& layout) {
    int unused = 0;
    check(nc_set_fill(id_, NC_NOFILL, &unused));
    put_texts(NC_GLOBAL, layout.attributes);
    std::vector<int> dimensions;
    for (const NetcdfLayout::Dimension& dimension : layout.dimensions) {
      const std::size_t length = dimension.length == 0 ? NC_UNLIMITED : dimension.length;
      check(nc_def_dim(id_, dimension.name.c_str(), length, &dimensions.emplace_back()));
    }
    for (const NetcdfLayout::Variable& variable : layout.variables) {
      std::vector<int> ids;
      for (const std::size_t index : variable.dimensions) ids.push_back(dimensions[index]);
      check(nc_def_var(id_, variable.name.c_str(), type_of(variable.type), static_cast<int>(ids.size()),
                       ids.data(), &variables_.emplace_back()));
      put_texts(variables_.back(), variable.attributes);
    }
    check(nc_enddef(id_));
  }

  void put_texts(int variable, const std::vector<NetcdfLayout::Text>& texts) {
    for (const auto& [name, value] : texts) {
      check(nc_put_att_text(id_, variable, name.c_str(), value.size(), value.data()));
    }
  }

  void check(int status) const {
    if (status == NC_NOERR) return;
    throw Error(ErrorKind::file,
                fmt::format("{}: cannot write NetCDF: {}", printable_name(target_), nc_strerror(status)),
                "check the folder and the room on the disk; many points or modes need several files");
  }

  std::string target_;
  int id_ = -1;
  bool is_open_ = false;
  std::vector<int> variables_;
};

}  // namespace

std::unique_ptr<NetcdfOutput> create_netcdf(const std::filesystem::path& path, const NetcdfLayout& layout,
                                            const std::string& target) {
  return std::make_unique<ClassicOutput>(path, layout, target);
}

}  // namespace offing::spectra
