#pragma once

#include <OpenEXR/Iex.h>
#include <OpenEXR/ImfIO.h>

#include "zonal/io/byte_reader.h"
#include "zonal/io/file.h"

namespace zonal {

/// Lets OpenEXR read through a ByteReader.
class ExrInput : public Imf::IStream {
 public:
  explicit ExrInput(const ByteReader& file) : Imf::IStream(file.name().c_str()), reader_(file.another()) {}

  bool read(char into[], int count) override {
    const auto bytes = std::as_writable_bytes(std::span(into, static_cast<std::size_t>(count)));
    if (reader_.read_some(bytes) != bytes.size()) throw Iex::InputExc("the file ends early");
    return reader_.remaining() > 0;
  }
  std::uint64_t tellg() override { return reader_.position(); }
  void seekg(std::uint64_t position) override { reader_.seek(position); }

 private:
  ByteReader reader_;
};

/// Lets OpenEXR write through an OutputFile. A failure that OpenEXR swallows (in a destructor) is remembered by the
/// OutputFile.
class ExrOutput : public Imf::OStream {
 public:
  explicit ExrOutput(OutputFile& file) : Imf::OStream(file.path().c_str()), file_(file) {}

  void write(const char from[], int count) override {
    file_.write(std::as_bytes(std::span(from, static_cast<std::size_t>(count))));
  }
  std::uint64_t tellp() override { return file_.position(); }
  void seekp(std::uint64_t position) override { file_.seek(position); }

 private:
  OutputFile& file_;
};

}  // namespace zonal
