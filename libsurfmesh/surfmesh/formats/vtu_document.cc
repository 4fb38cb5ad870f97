// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/vtu_document.hh"

#include <expat.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <exception>
#include <limits>
#include <map>
#include <memory>
#include <new>
#include <utility>

#include "surfmesh/core/error.hh"
#include "surfmesh/io/text_scanner.hh"

namespace surfmesh::vtu {
namespace {

/// Bytes that the parser is given at once: its sizes are int.
constexpr std::size_t kChunk = std::size_t{1} << 24;

constexpr std::string_view kAppendedTag = "<AppendedData";

using Attributes = std::map<std::string, std::string, std::less<>>;

/// What of a file is XML, and the appended data, which need not be.
struct Parts {
  std::string_view xml;       ///< with the tag of the appended data
  std::string_view appended;  ///< after the _
};

Parts parts_of(std::string_view bytes, const std::string& name) {
  const std::size_t tag = bytes.find(kAppendedTag);
  if (tag == std::string_view::npos) return {bytes, {}};
  const std::size_t end = bytes.find('>', tag);
  const std::size_t start = end == std::string_view::npos ? end : bytes.find('_', end);
  if (start == std::string_view::npos) {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("{}: byte {}: the appended data do not begin, the file is cut short",
                            name, tag));
  }
  return {bytes.substr(0, end + 1), bytes.substr(start + 1)};
}

class DocumentReader {
 public:
  DocumentReader(std::string_view bytes, const std::string& name)
      : parts_(parts_of(bytes, name)), parser_(XML_ParserCreate(nullptr), XML_ParserFree) {
    if (!parser_) throw std::bad_alloc();
    document_.form.name = name;
    document_.form.appended = parts_.appended;
    document_.form.appended_start = bytes.size() - parts_.appended.size();
    XML_SetUserData(parser_.get(), this);
    XML_SetElementHandler(
        parser_.get(),
        [](void* self, const XML_Char* tag, const XML_Char** attributes) {
          static_cast<DocumentReader*>(self)->guard(
              [&](DocumentReader& reader) { reader.begin(tag, attributes); });
        },
        [](void* self, const XML_Char* tag) { static_cast<DocumentReader*>(self)->end(tag); });
    XML_SetCharacterDataHandler(parser_.get(), [](void* self, const XML_Char* text, int size) {
      static_cast<DocumentReader*>(self)->add_text({text, static_cast<std::size_t>(size)});
    });
    // Entities, which a file of numbers does not need, could stand for any amount of text.
    XML_SetStartDoctypeDeclHandler(
        parser_.get(), [](void* self, const XML_Char*, const XML_Char*, const XML_Char*, int) {
          static_cast<DocumentReader*>(self)->guard(
              [](DocumentReader& reader) { reader.fail("a document type is not read"); });
        });
  }

  Document run() {
    const bool is_whole = parts_.appended.data() == nullptr;
    for (std::string_view rest = parts_.xml; !rest.empty() || is_whole;) {
      const std::string_view chunk = rest.substr(0, kChunk);
      rest.remove_prefix(chunk.size());
      const bool is_last = rest.empty() && is_whole;
      const auto status = XML_Parse(parser_.get(), chunk.data(), static_cast<int>(chunk.size()),
                                    is_last ? XML_TRUE : XML_FALSE);
      if (error_) std::rethrow_exception(error_);
      if (status != XML_STATUS_OK) fail_to_parse(XML_GetErrorCode(parser_.get()));
      if (rest.empty()) break;
    }
    if (!is_grid_) fail("the file has no UnstructuredGrid");
    set_ends();
    return std::move(document_);
  }

 private:
  [[noreturn]] void fail(std::string_view reason) const {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("{}:{}: {}", document_.form.name,
                            XML_GetCurrentLineNumber(parser_.get()), reason));
  }

  [[noreturn]] void fail_to_parse(XML_Error error) const {
    if (error == XML_ERROR_NO_MEMORY) throw std::bad_alloc();
    fail(fmt::format("the XML is broken: {}", XML_ErrorString(error)));
  }

  /// Keep an error until the parser, which is C, has returned.
  template <class Body>
  void guard(Body body) {
    try {
      if (!error_) body(*this);
    } catch (...) {
      error_ = std::current_exception();
      XML_StopParser(parser_.get(), XML_FALSE);
    }
  }

  static std::string text_at(const Attributes& attributes, std::string_view key) {
    const auto found = attributes.find(key);
    return found == attributes.end() ? std::string() : found->second;
  }

  std::size_t number_at(const Attributes& attributes, std::string_view key) const {
    const std::string text = text_at(attributes, key);
    std::size_t value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || stop != end) {
      fail(fmt::format("{} is {}, which is no number from 0", key, surfmesh::quoted(text)));
    }
    return value;
  }

  void begin(const XML_Char* tag, const XML_Char** given) {
    Attributes attributes;
    for (const XML_Char** at = given; *at != nullptr; at += 2) attributes[at[0]] = at[1];
    const std::string_view name = tag;
    path_.emplace_back(name);
    if (name == "VTKFile") {
      begin_file(attributes);
    } else if (name == "UnstructuredGrid") {
      is_grid_ = true;
    } else if (name == "Piece") {
      Piece& piece = document_.pieces.emplace_back();
      piece.points = number_at(attributes, "NumberOfPoints");
      piece.cells = number_at(attributes, "NumberOfCells");
      piece.line = XML_GetCurrentLineNumber(parser_.get());
    } else if (name == "DataArray") {
      begin_array(attributes);
    } else if (name == "AppendedData") {
      const std::string encoding = text_at(attributes, "encoding");
      if (encoding != "raw" && encoding != "base64") {
        fail(fmt::format("appended data in {} are not read", surfmesh::quoted(encoding)));
      }
      document_.form.is_base64 = encoding == "base64";
    }
  }

  void begin_file(const Attributes& attributes) {
    ArrayForm& form = document_.form;
    if (const std::string type = text_at(attributes, "type"); type != "UnstructuredGrid") {
      fail(fmt::format("a file of the type {} is no UnstructuredGrid", surfmesh::quoted(type)));
    }
    if (text_at(attributes, "byte_order") == "BigEndian") form.order = std::endian::big;
    form.header_size = text_at(attributes, "header_type") == "UInt64" ? 8 : 4;
    const std::string compressor = text_at(attributes, "compressor");
    form.is_compressed = !compressor.empty();
    if (form.is_compressed && compressor != "vtkZLibDataCompressor") {
      fail(fmt::format("{} is not read, only vtkZLibDataCompressor or none",
                       surfmesh::quoted(compressor)));
    }
  }

  /// The arrays of a piece, or of the grid, that the element around belongs to; null for those that
  /// are not read.
  std::vector<DataArray>* arrays_here() {
    if (path_.size() < 3) return nullptr;
    const std::string& around = path_[path_.size() - 2];
    const std::string& whole = path_[path_.size() - 3];
    if (whole == "UnstructuredGrid" && around == "FieldData") return &document_.whole;
    if (whole != "Piece" || document_.pieces.empty()) return nullptr;
    Piece& piece = document_.pieces.back();
    if (around == "Points") return &piece.coordinates;
    if (around == "Cells") return &piece.topology;
    if (around == "PointData") return &piece.at_points;
    return around == "CellData" ? &piece.at_cells : nullptr;
  }

  void begin_array(const Attributes& attributes) {
    constexpr std::array<std::string_view, 10> types = {"Int8",    "UInt8",  "Int16", "UInt16",
                                                        "Int32",   "UInt32", "Int64", "UInt64",
                                                        "Float32", "Float64"};
    std::vector<DataArray>* const arrays = arrays_here();
    if (arrays == nullptr) return;
    const std::string word = text_at(attributes, "type");
    const auto type = std::find(types.begin(), types.end(), word);
    // Text, for one: it is of no use here, but where numbers have to be they are then missing.
    if (type == types.end()) return;
    DataArray array;
    array.name = text_at(attributes, "Name");
    array.type = static_cast<Type>(type - types.begin());
    array.line = XML_GetCurrentLineNumber(parser_.get());
    if (attributes.contains("NumberOfComponents")) {
      const std::size_t components = number_at(attributes, "NumberOfComponents");
      constexpr auto most = static_cast<std::size_t>(std::numeric_limits<int>::max());
      if (components < 1 || components > most) fail("an array has no components");
      array.components = static_cast<int>(components);
    }
    const std::string format = text_at(attributes, "format");
    if (format == "appended") {
      array.encoding = Encoding::Appended;
      array.offset = number_at(attributes, "offset");
    } else {
      array.encoding = format == "binary" ? Encoding::Inline : Encoding::Text;
    }
    arrays->push_back(std::move(array));
    open_ = &arrays->back();
  }

  void end(std::string_view tag) {
    if (tag == "DataArray") open_ = nullptr;
    if (!path_.empty()) path_.pop_back();
  }

  void add_text(std::string_view text) {
    if (open_ == nullptr || open_->encoding == Encoding::Appended) return;
    if (path_.back() != "DataArray") return;  // but one of what is in it
    if (open_->content.empty()) open_->line = XML_GetCurrentLineNumber(parser_.get());
    guard([&](DocumentReader&) { open_->content.append(text); });
  }

  template <class Visitor>
  void for_each_array(Visitor visit) {
    for (DataArray& array : document_.whole) visit(array);
    for (Piece& piece : document_.pieces) {
      for (auto* arrays :
           {&piece.coordinates, &piece.topology, &piece.at_points, &piece.at_cells}) {
        for (DataArray& array : *arrays) visit(array);
      }
    }
  }

  void set_ends() {
    std::vector<std::size_t> offsets = {document_.form.appended.size()};
    const auto is_appended = [](const DataArray& a) { return a.encoding == Encoding::Appended; };
    for_each_array([&](DataArray& array) {
      if (is_appended(array)) offsets.push_back(array.offset);
    });
    std::sort(offsets.begin(), offsets.end());
    for_each_array([&](DataArray& array) {
      const auto next = std::upper_bound(offsets.begin(), offsets.end(), array.offset);
      array.end = next == offsets.end() ? array.offset : *next;
    });
  }

  Parts parts_;
  std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser_;
  Document document_;
  std::vector<std::string> path_;  ///< of open elements
  DataArray* open_ = nullptr;      ///< the array whose content comes
  bool is_grid_ = false;
  std::exception_ptr error_;
};

}  // namespace

Document read_document(std::string_view bytes, const std::string& name) {
  return DocumentReader(bytes, name).run();
}

}  // namespace surfmesh::vtu
